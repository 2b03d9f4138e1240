// Are two polyhedra surely apart, or surely further apart than a distance, along a direction that parted them
// elsewhere? In doubles alone, and without evidence: for those who ask about the same two bodies again and again, and
// want to know of most of them only that they are apart. Where it is not sure, they ask polyhedron_polyhedron or its
// kin. Also called: caching of separating axes; temporal coherence.
#pragma once

#include <sunder/predicate/point.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/object/search_graph.h>

#include <cstdint>
#include <limits>
#include <span>

namespace sunder::solid {

// A body in its place. It refers to the body's vertices.
struct RigidlyPlaced {
  // At no place yet. The body must live as long.
  explicit RigidlyPlaced(const ConvexPolyhedron& body);

  void place(const Pose& pose);

  const SearchGraph* graph;
  Point3 middle, half;  // of the body's own box, which these hold
  Affine3 pose;
  // What rounding, and what its linear part departs from a rotation, may take from a gap, as a part of it for each of
  // the two bodies: derived in kept_partings.cpp. Infinite where the linear part is far from a rotation, or numbers are
  // so small or great that the derivation does not hold: then nothing is sure.
  double error = std::numeric_limits<double>::infinity();
};

// A direction that parted A from B. Its features are of A and B themselves: it serves wherever they are.
struct KeptParting {
  Point3 direction{};                                      // as the frame of A sees it, and turns with it; tame
  double reach = std::numeric_limits<double>::infinity();  // of A along it; infinite: there is no direction yet
  std::uint32_t near_b = 0;                                // a vertex of B that was extreme
};

// Does one of these part A from B, surely, by more than `least`? It becomes the first of them. False: not sure.
// Requires partings that were kept for these two bodies, or none, and least >= 0, which may be infinite (then it is not
// sure). Cost: for each two turned directions and a look at the box of B, or, where that does not tell, a walk on B.
bool part_again(const RigidlyPlaced& a, const RigidlyPlaced& b, std::span<KeptParting> kept, double least = 0);

// Keeps a direction of the frame of A as the first, and forgets the last. Requires it to be tame (predicate/point/along.h),
// and vertices of A and of B, of which the one of A is extreme along it as far as a search tells. False where that is
// not sure: then nothing is kept. Cost: a look at that vertex and at its neighbours; of up to 512 vertices, where two
// are about as far, a look at all.
bool keep_parting(const ConvexPolyhedron& a, const Point3& direction, std::uint32_t extreme_a, std::uint32_t near_b,
                  std::span<KeptParting> kept);

// The same of a direction of the world, from A to B, as A sees it where it is; A's extreme vertex is looked for. Where
// the direction is zero or not finite, nothing is kept. Cost: a walk on A besides.
bool keep_parting_of_world(const RigidlyPlaced& a, const Point3& direction, std::span<KeptParting> kept);

}  // namespace sunder::solid
