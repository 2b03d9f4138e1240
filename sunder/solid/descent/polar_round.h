// What the walk between two spaces does, round by round: for tests and pictures.
#pragma once

#include <sunder/predicate/point.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>

#include <cstdint>
#include <vector>

namespace sunder::solid {

struct PolarRound {
  // Where it took place: at the top of both hierarchies, at a vertex of P that came beyond the plane, or at a facet of
  // R that cut the point off.
  enum class Space : std::uint8_t { top, primal, polar };
  Space space = Space::top;
  bool is_apart = false;     // what held after it: a plane, or a point
  std::uint32_t vertex = 0;  // of P, the furthest along the plane's normal, as of the last plane
  std::uint32_t facet = 0;   // of R, the one that the point is nearest to be cut off by, as of the last point
  std::size_t level_p = 0, level_q = 0;  // how many levels below the tops
  // The plane's normal, towards R, or the point, in R's frame about o, its axes scaled (polar_hierarchy.h). Rounded.
  Point3 at{};
};
using PolarRounds = std::vector<PolarRound>;

// The rounds of polyhedron_polyhedron_by_polar in doubles, in order, and the levels of both hierarchies; of needles, as
// if it did not scale their axes (axis_scaled.h). Empty where it uses another method (both bodies are flat). R is the longer
// body, in the world, or where one is flat, the other; of equal lengths it is `b`.
struct PolarRun {
  PolarRounds rounds;
  std::size_t levels_p = 0, levels_q = 0;
};
PolarRun polyhedron_polyhedron_polar_run(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                         const ConvexPolyhedron& b, const Pose& pose_b);

}  // namespace sunder::solid
