#include <sunder/base/error.h>
#include <sunder/solid/round/round_contact.h>
#include <sunder/solid/round/round_finish.h>
#include <sunder/solid/round/round_round.h>
#include <tests/support/round_oracle.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace sunder::solid {
namespace {

Pose shifted(double x, double y, double z) { return Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {x, y, z}); }

Verdict verdict(const RoundBody& a, const RoundBody& b, const Pose& pose_b = Pose()) {
  return round_round(a, Pose(), b, pose_b).verdict();
}
Relation contact(const RoundBody& a, const RoundBody& b, const Pose& pose_b = Pose()) {
  return relation_of(round_round_contact(a, Pose(), b, pose_b));
}

ConvexPolyhedron cube(double half) {
  std::vector<Point3> corners;
  for (const double x : {-half, half}) {
    for (const double y : {-half, half}) {
      for (const double z : {-half, half}) corners.push_back({x, y, z});
    }
  }
  return ConvexPolyhedron(corners);
}

TEST(RoundBody, WhatIsRefused) {
  EXPECT_THROW((void)RoundBody::ball({0, 0, 0}, -1), Error);
  EXPECT_THROW((void)RoundBody::ball({0, 0, 0}, HUGE_VAL), Error);
  EXPECT_THROW((void)RoundBody::ball({std::nan(""), 0, 0}, 1), Error);
  EXPECT_THROW((void)RoundBody::cylinder({1, 2, 3}, {1, 2, 3}, 1), Error);
  EXPECT_THROW((void)RoundBody::cone({1, 2, 3}, {1, 2, 3}, 0), Error);
  EXPECT_THROW((void)RoundBody::ellipsoid({0, 0, 0}, {1, 0, 1}), Error);
  EXPECT_EQ(RoundBody::cylinder({0, 0, 0}, {0, 0, 1}, 0).kind(), RoundKind::hull);
}

TEST(RoundBody, PosesThatScale) {
  const Pose twice = Pose::from_matrix({2, 0, 0, 0, 2, 0, 0, 0, 2}, {0, 0, 0});
  const Pose sheared = Pose::from_matrix({1, 0.001, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0});
  for (const Pose& pose : {twice, sheared}) {
    EXPECT_THROW(require_rigid(RoundBody::ball({0, 0, 0}, 1), pose), Error);
    EXPECT_THROW(require_rigid(RoundBody::cylinder({0, 0, 0}, {0, 0, 1}, 1), pose), Error);
    EXPECT_NO_THROW(require_rigid(RoundBody::ellipsoid({0, 0, 0}, {1, 2, 3}), pose));
    EXPECT_NO_THROW(require_rigid(RoundBody::rounded(cube(1), 0), pose));
  }
  // The ellipsoid's own map, then the pose.
  EXPECT_EQ(
      round_round(RoundBody::ellipsoid({1, 0, 0}, {1, 2, 3}), twice, RoundBody::ball({5, 0, 0}, 1), Pose()).verdict(),
      Verdict::meet);
  EXPECT_EQ(
      round_round(RoundBody::ellipsoid({1, 0, 0}, {1, 2, 3}), twice, RoundBody::ball({6, 0, 0}, 1), Pose()).verdict(),
      Verdict::apart);
}

TEST(RoundRound, HullsToTheLastBit) {
  const RoundBody a = RoundBody::ball({0, 0, 0}, 2);
  EXPECT_EQ(verdict(a, RoundBody::ball({3, 4, 0}, 3)), Verdict::meet);
  EXPECT_EQ(verdict(a, RoundBody::ball({3, 4, 0}, std::nextafter(3, 0))), Verdict::apart);
  EXPECT_EQ(contact(a, RoundBody::ball({3, 4, 0}, 3)), Relation::touching);
  EXPECT_EQ(contact(a, RoundBody::ball({3, 4, 0}, std::nextafter(3, 4))), Relation::overlapping);
  EXPECT_EQ(contact(a, RoundBody::ball({3, 4, 0}, 2)), Relation::none);
  // The sum of the radii is no double: 1 + 2^-60.
  EXPECT_EQ(verdict(RoundBody::ball({0, 0, 0}, 1), RoundBody::ball({1, 0, 0}, 0x1p-60)), Verdict::meet);
  EXPECT_EQ(contact(RoundBody::ball({0, 0, 0}, 1), RoundBody::ball({1, 0, 0}, 0x1p-60)), Relation::overlapping);
  EXPECT_EQ(contact(RoundBody::ball({0, 0, 0}, 1), RoundBody::ball({1, 0, 0}, 0)), Relation::touching);
}

TEST(RoundRound, EachKindOnABox) {
  const RoundBody box = RoundBody::rounded(cube(1), 0);
  const double up = std::nextafter(1, 2);
  for (const RoundBody& body : {RoundBody::ball({0, 0, 1}, 1), RoundBody::capsule({-5, 0, 1}, {5, 0, 1}, 1),
                                RoundBody::rounded(cube(1), 1), RoundBody::cylinder({-3, 0, 1}, {3, 0, 1}, 1),
                                RoundBody::cylinder({0, 0, 0}, {0, 0, 3}, 2), RoundBody::cone({0, 0, 3}, {0, 0, 0}, 2),
                                RoundBody::cone({0, 0, 0}, {0, 0, 2}, 3), RoundBody::ellipsoid({0, 0, 2}, {1, 3, 2})}) {
    const double off = body.kind() == RoundKind::hull && body.core().dimension() == 3 ? 2 : 0;
    EXPECT_EQ(contact(box, body, shifted(0, 0, 1 + off)), Relation::touching);
    EXPECT_EQ(contact(box, body, shifted(0, 0, 0.5 + off)), Relation::overlapping);
    EXPECT_EQ(verdict(box, body, shifted(0, 0, off + (off > 0 ? std::nextafter(1, 2) : up) + 0x1p-50)), Verdict::apart);
  }
}

TEST(RoundRound, AFacetThatOnlyTheAxisPierces) {
  // A large triangle across a cone, and across its disc.
  const ConvexPolyhedron sheet(std::vector<Point3>{{-100, -100, 1}, {100, -100, 1}, {0, 100, 1}});
  const RoundBody cone = RoundBody::cone({0, 0, 0}, {0, 0, 4}, 2);
  EXPECT_EQ(verdict(cone, RoundBody::rounded(sheet, 0)), Verdict::meet);
  const ConvexPolyhedron wall(std::vector<Point3>{{1.5, -100, -100}, {1.5, 100, -100}, {1.5, 0, 100}});
  EXPECT_EQ(verdict(cone, RoundBody::rounded(wall, 0)), Verdict::meet);
  EXPECT_EQ(verdict(cone, RoundBody::rounded(wall, 0), shifted(0.5, 0, 0)), Verdict::meet);
  EXPECT_EQ(verdict(cone, RoundBody::rounded(wall, 0), shifted(0.5 + 0x1p-40, 0, 0)), Verdict::apart);
}

// The exact methods by themselves, whatever the search would have found.
CurvedVerdict finished(const RoundBody& curved, const RoundBody& polyhedron) {
  Cost cost;
  StageTally tally;
  const PlacedRound a(curved, Pose()), b(polyhedron, Pose());
  CurvedVerdict found = *curved_polyhedron(a, b, 0, cost, tally);
  if (found.direction && !found.point) {
    // It parts them, every vertex.
    const WorldDirection d(*found.direction);
    for (std::size_t v = 0; v < polyhedron.core().vertices().size(); ++v) {
      RoundShape vertex = b.shape;
      vertex.points[0] = polyhedron.core().vertices()[v];
      EXPECT_EQ(gap_sign(d, a.shape, vertex), Sign::positive);
    }
  }
  return found;
}

// Deep in each other, and so thin that hardly a point of doubles is in either; far away they are thin sooner.
TEST(RoundRound, WhatIsThinnerThanDoublesTell) {
  for (const double far : {0.0, 1e6}) {
    const double x = far, y = far / 4;
    const Pose pose_a = Pose::from_quaternion(0.3, 0.5, -0.2, 0.7, {x + 0.1, y + 0.2, 0.3});
    const Pose pose_b = Pose::from_quaternion(0.9, 0.1, 0.4, -0.2, {x + 0.35, y + 0.5, 0.35});
    const Pose pose_c = Pose::from_quaternion(0.9, 0.1, 0.4, -0.2, {x + 6.35, y + 0.5, 0.35});
    for (const double h : {0x1p-45, 0x1p-60, 0x1p-130, 0x1p-1000}) {
      const RoundBody coin = RoundBody::cylinder({0, 0, -h}, {0, 0, h}, 1);
      const RoundBody hat = RoundBody::cone({0, 0, 0}, {0, 0, h}, 1);
      const RoundBody lens = RoundBody::ellipsoid({0, 0, 0}, {1, 1, h});
      const RoundBody needle = RoundBody::ellipsoid({0, 0, 0}, {1, h, h});
      const RoundBody bar = RoundBody::capsule({-1, -0.2, 0.25}, {1, 0.3, 0.25}, 0.5);
      int k = 0;
      for (const RoundBody* a : {&coin, &hat, &lens, &needle, &bar}) {
        for (const RoundBody* b : {&coin, &hat, &lens, &bar}) {
          SCOPED_TRACE(std::to_string(std::ilogb(h)) + " " + std::to_string(far) + " " + std::to_string(k++));
          const RoundAnswer answer = round_round(*a, pose_a, *b, pose_b);
          ASSERT_EQ(answer.verdict(), Verdict::meet);
          EXPECT_TRUE(tests::is_proved(PlacedRound(*a, pose_a), PlacedRound(*b, pose_b), answer.evidence));
          EXPECT_EQ(round_round(*a, pose_a, *b, pose_c).verdict(), Verdict::apart);
        }
      }
    }
  }
}

// A cone of 5e-9 of its width, whose rim is 8e-7 deep in a ball: the point of the search is of the rim.
TEST(RoundRound, TheRimOfAFlatCone) {
  const RoundBody ball =
      RoundBody::ball({0x1.2fed9741b6306p-1, 0x1.a0bef3f17f0dcp-1, 0x1.eee5a2aafd088p-1}, 0x1.60f2a608d024bp+1);
  const RoundBody cone = RoundBody::cone({0, 0, 0x1.6d054aa99d1a4p-28}, {0, 0, 0}, 0x1.08ed37c000a23p+0);
  const Pose pose_a = Pose::from_matrix({0, 0, -1, -1, 0, 0, 0, -1, 0}, {0, 0, 0});
  const Pose pose_b = Pose::from_matrix(
      {0x1.4df6b8f01164bp-1, 0x1.b8cee5814325bp-2, -0x1.3f6d90eb31796p-1, 0x1.050682a694e17p-1, -0x1.b76c156abf19ap-1,
       -0x1.e4bcc5f75a518p-5, -0x1.1f309115ba20ap-1, -0x1.1e2d08c53996p-2, -0x1.8efd15089d413p-1},
      {-0x1.1f50fd9f9da9ep+2, 0, 0});
  const RoundAnswer answer = round_round(ball, pose_a, cone, pose_b);
  ASSERT_EQ(answer.verdict(), Verdict::meet);
  EXPECT_TRUE(tests::is_proved(PlacedRound(ball, pose_a), PlacedRound(cone, pose_b), answer.evidence));
}

TEST(RoundFinish, ACylinderAndAnEdgeThatLeavesItsSlab) {
  const RoundBody cylinder = RoundBody::cylinder({0, 0, 0}, {0, 0, 2}, 1);
  for (const double side : {1.0, -1.0}) {
    // Nearest to the axis in the plane of the top, or of the base; beyond it the edge goes on inwards.
    const auto edge = [&](double from) {
      return side > 0 ? RoundBody::capsule({from, 0, 1}, {0, 0, 1 + from}, 0)
                      : RoundBody::capsule({from, 0, 1}, {0, 0, 1 - from}, 0);
    };
    EXPECT_EQ(finished(cylinder, edge(4)).sign, Sign::negative);
    EXPECT_TRUE(finished(cylinder, edge(4)).direction);
    EXPECT_EQ(finished(cylinder, edge(2)).sign, Sign::zero);
    EXPECT_TRUE(finished(cylinder, edge(2)).point);
    EXPECT_EQ(finished(cylinder, edge(1.5)).sign, Sign::positive);
  }
  EXPECT_EQ(finished(cylinder, RoundBody::capsule({-1, 0, 3}, {1, 0, 4}, 0)).sign, Sign::negative);
  EXPECT_EQ(finished(cylinder, RoundBody::capsule({-1, 0, -3}, {1, 0, -4}, 0)).sign, Sign::negative);
}

TEST(RoundFinish, AConeAndAnEdge) {
  // Upright, and upside down: edges go along the axis and against it.
  const auto meets = [&](const Point3& p, const Point3& q) {
    const auto found = [&](double up) {
      const RoundBody edge = RoundBody::capsule({p.x, p.y, up * p.z}, {q.x, q.y, up * q.z}, 0);
      return finished(RoundBody::cone({0, 0, 0}, {0, 0, up * 4}, 2), edge).point.has_value();
    };
    EXPECT_EQ(found(1), found(-1));
    return found(1);
  };
  for (const double side : {1.0, -1.0}) {
    EXPECT_TRUE(meets({side * 5, 0.5, 1}, {side * 1, 0.5, 1}));  // one end inside, the first or the second
    EXPECT_FALSE(meets({side * 5, 0.5, 1}, {side * 2, 0.5, 1}));
    EXPECT_TRUE(meets({-4, side * 1.5, 1}, {4, side * 1.5, 1}));  // touches in the middle
    EXPECT_FALSE(meets({-4, side * 1.5625, 1}, {4, side * 1.5625, 1}));
    EXPECT_FALSE(meets({-4, side * 0.25, 5}, {4, side * 0.25, 5}));    // the other half of the double cone
    EXPECT_FALSE(meets({side * 5, 0.25, 1}, {side * 0.25, 0.25, 6}));  // from beside into that half
    EXPECT_FALSE(meets({side * 0.25, 0.25, 7}, {side * 5, 0.25, -1}));
    EXPECT_TRUE(meets({side * 2, 0, -1}, {side * 2, 0, 1}));  // the rim
    EXPECT_FALSE(meets({side * 2, 0.0625, -1}, {side * 2, 0.0625, 1}));
  }
}

}  // namespace
}  // namespace sunder::solid
