#include <sunder/base/random.h>
#include <sunder/certificate/rounded_evidence.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sunder::solid {
namespace {

using tests::shift;

struct Pair {
  ConvexPolyhedron a, b;
  Pose pose_a, pose_b;
  PairAnswer answer = intersect(a, pose_a, b, pose_b);

  PlacedVertices in_a() const { return {a.vertices(), pose_a.affine(), false}; }
  PlacedVertices in_b() const { return {b.vertices(), pose_b.affine(), false}; }
};

ConvexPolyhedron box(double size) { return ConvexPolyhedron(tests::cube_corners(-size, size)); }

TEST(RoundedEvidence, GapOfBoxes) {
  for (const int exponent : {-1000, -300, 0, 300, 1000}) {
    const double unit = std::ldexp(1.0, exponent);
    const Pair pair{box(unit), box(unit), Pose(), shift(5 * unit, 0, 0)};
    ASSERT_FALSE(pair.answer.meet());
    const RoundedGap gap = rounded_gap(std::get<Separation>(pair.answer.evidence), pair.in_a(), pair.in_b());
    EXPECT_GT(gap.direction.x, 0.5) << exponent;
    EXPECT_GT(gap.width, 0) << exponent;
    EXPECT_LE(gap.width, 3 * unit * (1 + 1e-9)) << exponent;
    const Point3& d = gap.direction;
    EXPECT_NEAR(d.x * d.x + d.y * d.y + d.z * d.z, 1, 1e-12) << exponent;
  }
}

TEST(RoundedEvidence, AxisGivesTheWidthExactly) {
  const Pair pair{box(1), box(1), Pose(), shift(0, 5, 0)};
  Separation certificate;
  certificate.direction.given = {0, 4, 0};
  for (std::uint32_t v = 0; v < 8; ++v) {
    if (pair.a.vertices()[v].y == 1) certificate.extreme_a = v;
    if (pair.b.vertices()[v].y == -1) certificate.extreme_b = v;
  }
  const RoundedGap gap = rounded_gap(certificate, pair.in_a(), pair.in_b());
  EXPECT_EQ(gap.width, 3);
  EXPECT_EQ(gap.direction, (Point3{0, 1, 0}));
}

TEST(RoundedEvidence, CommonPointIsInBoth) {
  Random random(6);
  int meeting = 0;
  for (int round = 0; round < 500; ++round) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.between(-1000, 1000)));
    const auto u = [&] { return scale * random.uniform(-1.2, 1.2); };
    const Pair pair{box(scale), box(scale), Pose(), shift(u(), u(), u())};
    if (!pair.answer.meet()) continue;
    ++meeting;
    const Point3 p = rounded_common_point(std::get<CommonVertices>(pair.answer.evidence), pair.in_a(), pair.in_b());
    const auto& t = pair.pose_b.affine().translation;
    const double limit = scale * (1 + 1e-12);
    EXPECT_LE(std::fabs(p.x), limit);
    EXPECT_LE(std::fabs(p.y), limit);
    EXPECT_LE(std::fabs(p.z), limit);
    EXPECT_LE(std::fabs(p.x - t[0]), limit);
    EXPECT_LE(std::fabs(p.y - t[1]), limit);
    EXPECT_LE(std::fabs(p.z - t[2]), limit);
  }
  EXPECT_GT(meeting, 300);
}

TEST(RoundedEvidence, CommonPointOfCorners) {
  const std::vector<Point3> one{{0.1, -7, 1e-300}};
  const Pair pair{ConvexPolyhedron(one), ConvexPolyhedron(one), Pose(), Pose()};
  ASSERT_TRUE(pair.answer.meet());
  EXPECT_EQ(rounded_common_point(std::get<CommonVertices>(pair.answer.evidence), pair.in_a(), pair.in_b()), one[0]);
}

}  // namespace
}  // namespace sunder::solid
