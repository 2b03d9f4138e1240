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
};
inline constexpr int family_count = 10;
std::string_view name_of(Family);

struct PairCase {
  Family family;
  solid::ConvexPolyhedron a, b;
  solid::Pose pose_a, pose_b;
  bool touches_exactly = false;  // known by construction
};

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
  PairCase touching_case(Family family);

  Random random_;
  std::vector<solid::ConvexPolyhedron> pool_;
  std::vector<solid::ConvexPolyhedron> large_;
  int turn_ = 0;
};

}  // namespace sunder::tests
