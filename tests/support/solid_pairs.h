// Pairs of placed convex polyhedra for differential tests: random and nasty, from a seed.
#pragma once

#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>

#include <array>
#include <string_view>
#include <vector>

namespace sunder::tests {

enum class Family : int {
  general,       // random bodies, random rotations, near enough that about half meet
  near_contact,  // moved apart or together to within a log-uniform gap of contact, down to the last bits
  touching,      // a body and its mirror image in a point of its surface (vertex, edge or facet): they touch exactly
  last_bit,      // the same, then shifted by a few units in the last place
  grid,          // small integer coordinates and shifts: every degeneracy
  flat,          // points, segments and polygons among them
  needle,        // thin and long bodies
  tiny_or_huge,  // scales from 1e-300 to 1e300, also mixed with ordinary ones
  contained,     // one well inside the other, or sharing vertices with it
  large,         // some thousand vertices
  // Of tests/support/solid_shapes.h, mostly of 8 to 200 vertices, some of 2000; needles of 8 to 24:
  shapes,            // as near_contact, for all but the needles
  shapes_touching,   // as touching, in a vertex where rounding would spoil the shape
  stretched,         // the needles: 1e300 : 1 : 1e-300, along the axes
  stretched_turned,  // one of them turned: what decides lies hundreds of digits below the coordinates of the images
  caps,              // two prisms cap on cap: coplanar, or apart or overlapping by one unit in the last place
  plates,            // near contact, thin as 1e-14 to 1e-3 of the length, along no axis; in one of three cases parallel
};
inline constexpr int family_count = 16;
std::string_view name_of(Family);

// Are sizes of a body hundreds of orders of magnitude apart, so that scaling may lose bits?
inline bool is_stretched(Family family) { return family == Family::stretched || family == Family::stretched_turned; }

struct PairCase {
  Family family;
  solid::ConvexPolyhedron a, b;
  solid::Pose pose_a, pose_b;
  bool touches_exactly = false;  // known by construction
};

// A pose, and then: a reflection in x = 0; a scale by a power of two; a shift by (by, 0, -by).
solid::Pose reflected(const solid::Pose& pose);
solid::Pose scaled_pose(const solid::Pose& pose, double by);
solid::Pose shifted(const solid::Pose& pose, double by);

// An endless stream of cases, family after family in turn.
class SolidPairs {
 public:
  explicit SolidPairs(std::uint64_t seed);
  PairCase next();
  PairCase next(Family family);

  Random& random() { return random_; }

 private:
  std::vector<Point3> grid_points(int n, int side);
  solid::ConvexPolyhedron some_body();
  solid::ConvexPolyhedron some_flat_body();
  solid::Pose some_pose(double distance);
  solid::Pose some_affine_pose();
  PairCase near_contact_case(Family family, const solid::ConvexPolyhedron& a, const solid::ConvexPolyhedron& b);
  PairCase near_contact_case(Family family, const solid::ConvexPolyhedron& a, const solid::ConvexPolyhedron& b,
                             const solid::Pose& here, const solid::Pose& there);
  PairCase touching_case(Family family, const solid::ConvexPolyhedron& body);
  PairCase stretched_case(Family family);
  PairCase caps_case();
  PairCase plates_case(const solid::ConvexPolyhedron& a, const solid::ConvexPolyhedron& b);

  Random random_;
  std::vector<solid::ConvexPolyhedron> pool_;
  std::vector<solid::ConvexPolyhedron> large_;
  std::vector<solid::ConvexPolyhedron> shapes_, needles_, prisms_;
  int turn_ = 0;
};

}  // namespace sunder::tests
