#include <sunder/base/random.h>
#include <sunder/certificate/check.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/round/world_box.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

namespace sunder::solid {
namespace {

Pose random_pose(Random& random, double scale) {
  const auto u = [&] { return random.uniform(-1, 1); };
  return Pose::from_quaternion(u(), u(), u(), u() + 1.5, {scale * u(), scale * u(), scale * u()});
}

ConvexPolyhedron random_body(Random& random, double scale, int points) {
  std::vector<Point3> all;
  for (int i = 0; i < points; ++i) {
    all.push_back({scale * random.uniform(-1, 1), scale * random.uniform(-1, 1), scale * random.uniform(-1, 1)});
  }
  return ConvexPolyhedron(all);
}

// Compares a bound, which is a double, with the image of a point exactly.
Sign from_bound_to_image(int axis, double bound, const Posed3& image) {
  const Affine3 identity;
  const Point3 at{axis == 0 ? bound : 0, axis == 1 ? bound : 0, axis == 2 ? bound : 0};
  return compare_coordinate(axis, posed(at, identity), image);
}

TEST(WorldBox, HoldsEveryImageExactly) {
  Random random(1);
  int tight = 0, bounds = 0, loose = 0;
  for (int round = 0; round < 300; ++round) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.between(-900, 900)));
    const ConvexPolyhedron body = random_body(random, scale, static_cast<int>(random.between(1, 40)));
    const Pose pose = random_pose(random, scale);
    const Placed placed(body, pose);
    WorldBox near;  // of the first vertices, or of any
    if (round % 2 == 0) {
      for (auto* ends : {&near.lowest, &near.highest}) {
        for (std::uint32_t& v : *ends) v = static_cast<std::uint32_t>(random.below(body.vertices().size()));
      }
    }
    const WorldBox box = world_box(placed, near);
    const Box3 rough = rough_world_box(placed);
    ASSERT_TRUE(holds(rough, box));
    loose += !holds(box, rough);
    for (const int axis : {0, 1, 2}) {
      const std::size_t k = static_cast<std::size_t>(axis);
      for (std::uint32_t v = 0; v < body.vertices().size(); ++v) {
        ASSERT_NE(from_bound_to_image(axis, box.low[k], placed[v]), Sign::negative);
        ASSERT_NE(from_bound_to_image(axis, box.high[k], placed[v]), Sign::positive);
        ASSERT_NE(compare_coordinate(axis, placed[box.lowest[k]], placed[v]), Sign::negative);
        ASSERT_NE(compare_coordinate(axis, placed[v], placed[box.highest[k]]), Sign::negative);
      }
      const double slack = 16 * scale * std::numeric_limits<double>::epsilon();
      bounds += 2;
      tight += from_bound_to_image(axis, box.low[k] + slack, placed[box.lowest[k]]) == Sign::negative;
      tight += from_bound_to_image(axis, box.high[k] - slack, placed[box.highest[k]]) == Sign::positive;
    }
  }
  EXPECT_EQ(tight, bounds);
  EXPECT_GT(loose, 200);
}

TEST(WorldBox, OverflowIsInfinite) {
  const std::vector<Point3> points{{1e308, 0, 0}, {-1e308, 1, 0}};
  const ConvexPolyhedron body(points);
  const Pose pose = Pose::from_matrix({10, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0});
  const WorldBox box = world_box(Placed(body, pose));
  EXPECT_EQ(rough_world_box(Placed(body, pose)).high[0], std::numeric_limits<double>::infinity());
  EXPECT_EQ(box.low[0], -std::numeric_limits<double>::infinity());
  EXPECT_EQ(box.high[0], std::numeric_limits<double>::infinity());
  EXPECT_TRUE(meet(box, box));
  EXPECT_FALSE(apart_by_boxes(box, box));
}

// Cubes on a lattice: boxes touch in faces, edges and corners, exactly and by one step of doubles more or less.
TEST(WorldBox, NeverPartsWhatTouches) {
  const std::vector<Point3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                    {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  const ConvexPolyhedron cube(corners);
  int touching = 0;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const Pose here,
            there = Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1},
                                      {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
        const WorldBox a = world_box(Placed(cube, here)), b = world_box(Placed(cube, there));
        ASSERT_TRUE(meet(a, b));
        ASSERT_FALSE(apart_by_boxes(a, b));
        ++touching;
      }
    }
  }
  EXPECT_EQ(touching, 27);
}

TEST(WorldBox, CertificatesHold) {
  Random random(2);
  int parted = 0, near_miss = 0;
  std::array<int, 6> directions{};
  const int count = tests::scaled_count(4000, 1000);
  for (int round = 0; round < count; ++round) {
    const ConvexPolyhedron body_a = random_body(random, 1, 12), body_b = random_body(random, 1, 12);
    const Pose pose_a = random_pose(random, 3), pose_b = random_pose(random, 3);
    const Placed a(body_a, pose_a), b(body_b, pose_b);
    const WorldBox box_a = world_box(a), box_b = world_box(b);
    const auto certificate = apart_by_boxes(box_a, box_b);
    ASSERT_EQ(certificate.has_value(), !meet(box_a, box_b));
    if (!certificate) {
      ++near_miss;
      continue;
    }
    ++parted;
    const PlacedVertices in_a{body_a.vertices(), pose_a.affine(), false},
        in_b{body_b.vertices(), pose_b.affine(), false};
    ASSERT_EQ(check_absolutely(*certificate, in_a, in_b), CheckResult::accepted);
    const Point3& d = certificate->direction.given;
    ++directions[d.x > 0 ? 0 : d.x < 0 ? 1 : d.y > 0 ? 2 : d.y < 0 ? 3 : d.z > 0 ? 4 : 5];
  }
  EXPECT_GT(parted, count / 4);
  const int part = count < 4000 ? 2 : 1;  // shares of a smaller run differ more
  EXPECT_GT(part * near_miss, count / 8);
  for (const int along : directions) EXPECT_GT(part * along, count / 80);
}

// Vertices are named of two polyhedra alone: of another body they are of its core, and not where it ends.
TEST(WorldBox, PartsBodiesOfAnyKind) {
  const std::vector<Point3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const RoundBody simplex = ConvexPolyhedron(corners), ball = RoundBody::ball({0, 0, 0}, 1);
  const Pose here, there = Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, -5, 0});
  for (const RoundBody& a : {simplex, ball}) {
    for (const RoundBody& b : {simplex, ball}) {
      const WorldBox of_a = world_box(a, here), of_b = world_box(b, there);
      const std::optional<RoundEvidence> apart = apart_by_boxes(a, of_a, b, of_b);
      ASSERT_TRUE(apart);
      const auto* vertices = std::get_if<Separation>(&*apart);
      EXPECT_EQ(vertices != nullptr, a.is_polyhedron() && b.is_polyhedron());
      const Point3 d =
          vertices != nullptr ? vertices->direction.given : std::get<SeparatingDirection>(*apart).direction;
      EXPECT_EQ(d, (Point3{0, -1, 0}));
      EXPECT_FALSE(apart_by_boxes(a, of_a, b, world_box(b, here)));
    }
  }
  EXPECT_EQ(reach_beyond_core(simplex), 0);
  EXPECT_EQ(reach_beyond_core(RoundBody::cylinder({0, 0, 0}, {0, 0, 1}, 2)), 2);
  EXPECT_TRUE(std::isinf(reach_beyond_core(RoundBody::ellipsoid({0, 0, 0}, {1, 2, 3}))));
}

}  // namespace
}  // namespace sunder::solid
