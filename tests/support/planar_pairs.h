// Pairs of placed convex polygons for differential tests: random and nasty, from a seed.
#pragma once

#include <tests/support/shapes.h>

#include <sunder/base/random.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>

#include <string_view>
#include <vector>

namespace sunder::tests {

enum class PlanarFamily : int {
  grid,          // hulls of points of a small integer grid, integer poses, reflecting ones too: every degeneracy
  general,       // random polygons, random rotations, near enough that about half meet
  near_contact,  // moved apart or together to within a log-uniform gap of contact, down to the last bits
  touching,      // a polygon and its image in a point of its boundary (vertex or edge): they touch exactly
  last_bit,      // the same, then shifted by a few units in the last place
  degenerate,    // points and segments among them, on lines and vertices of the other
  sliver,        // thin and long
  any_scale,     // 1e-300 to 1e300, also mixed with ordinary ones
  contained,     // one well inside the other, or sharing vertices with it
  large,         // some thousand vertices, regular ones among them
};
inline constexpr int planar_family_count = 10;
std::string_view name_of(PlanarFamily);

struct PlanarCase {
  PlanarFamily family;
  planar::ConvexPolygon a, b;
  planar::Pose pose_a{}, pose_b{};
  bool touches_exactly = false;  // known by construction
};

// An endless stream of cases, family after family in turn.
class PlanarPairs {
 public:
  explicit PlanarPairs(std::uint64_t seed);
  PlanarCase next();
  PlanarCase next(PlanarFamily family);

  Random& random() { return random_; }

 private:
  planar::ConvexPolygon some_polygon();
  planar::ConvexPolygon some_grid_polygon(int most);
  planar::ConvexPolygon some_short_one();
  planar::Pose some_turn(double distance);
  planar::Pose some_grid_pose();
  PlanarCase touching_case(PlanarFamily family);

  Random random_;
  std::vector<planar::ConvexPolygon> large_;
  int turn_ = 0;
};

}  // namespace sunder::tests
