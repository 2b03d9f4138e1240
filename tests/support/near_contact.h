// Two bodies placed so that whether they meet is hard to tell: for tests that count what an answer costs.
#pragma once

#include <tests/support/shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace sunder::tests {

enum class Placement : std::uint8_t {
  random,    // turned; about half meet
  near,      // turned, and then apart, and meeting, by a log-uniform part of 2^-53 to 1/10
  last_bit,  // turned, and then the last distance at which they are apart, and the first at which they meet
  tilted,    // as that, but turned by an angle of 2^-53 to 1/10 only, and moved along an axis or any way
  touching,  // the body and its mirror image in one of its vertices, which is all that they have in common
};
inline constexpr std::array<std::string_view, 5> placement_names{"random", "near", "last bit", "tilted", "touching"};

struct PlacedPair {
  solid::Pose a, b;
};

inline solid::Pose turned_at_random(Random& random, const Point3& to) {
  std::array<double, 4> q;
  for (double& x : q) x = random.uniform(-1, 1);
  return solid::Pose::from_quaternion(q[0], q[1], q[2], q[3], {to.x, to.y, to.z});
}

// One or two pairs of poses. Bodies are about one long. Needles keep to the axes, and move along the one in which they
// are 1 wide. `touching` is about `a` alone.
inline std::vector<PlacedPair> places_of(Placement placement, const solid::ConvexPolyhedron& a,
                                         const solid::ConvexPolyhedron& b, bool are_needles, Random& random) {
  if (placement == Placement::touching) {
    const Point3 v = a.vertices()[random.below(a.vertices().size())];
    return {{solid::Pose(), solid::Pose::from_matrix({-1, 0, 0, 0, -1, 0, 0, 0, -1}, {2 * v.x, 2 * v.y, 2 * v.z})}};
  }
  const auto [low, high] = a.box();
  const Point3 size{high.x - low.x, high.y - low.y, high.z - low.z};
  const double reach = are_needles ? 1 : std::max({size.x, size.y, size.z});
  if (placement == Placement::random && !are_needles) {
    const Point3 way = on_sphere(random);
    const double by = reach * random.uniform(0.2, 1);
    return {{turned_at_random(random, {}), turned_at_random(random, {by * way.x, by * way.y, by * way.z})}};
  }
  solid::Pose here, there = shift(0, reach, 0);
  if (!are_needles) {
    Point3 way = on_sphere(random);
    const bool is_tilted = placement == Placement::tilted;
    if (is_tilted && random.below(2) == 0) {
      way = {0, 0, 0};
      way[random.below(3)] = random.below(2) == 0 ? -1 : 1;
    }
    way = {reach * way.x, reach * way.y, reach * way.z};
    if (is_tilted) {
      const double angle = random.log_uniform(0x1p-53, 0.1);
      const Point3 about = on_sphere(random);
      there = solid::Pose::from_quaternion(1, angle * about.x, angle * about.y, angle * about.z, {way.x, way.y, way.z});
    } else {
      here = turned_at_random(random, {});
      there = turned_at_random(random, way);
    }
  }
  const auto at = [&](double distance) {
    const std::array<double, 3>& t = there.affine().translation;
    return solid::Pose::from_matrix(there.affine().linear, {t[0] * distance, t[1] * distance, t[2] * distance});
  };
  double meeting = 0, parted = 8;
  for (int i = 0; i < 60 && meeting < parted; ++i) {
    const double middle = (meeting + parted) / 2;
    (polyhedron_polyhedron(a, here, b, at(middle)).meet() ? meeting : parted) = middle;
  }
  const bool has_gap = placement == Placement::near || placement == Placement::random;
  const double gap = has_gap ? random.log_uniform(0x1p-53, 0.1) : 0;
  return {{here, at(parted + gap)}, {here, at(meeting - gap)}};
}

}  // namespace sunder::tests
