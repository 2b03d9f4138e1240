#include <tests/support/exact.h>

#include <sunder/base/random.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/predicate/point/plane_side.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace sunder {
namespace {

TEST(PlaneSideTest, ByHand) {
  const Affine3 identity, turned{{0, -1, 0, 1, 0, 0, 0, 0, 2}, {10, 0, 0}};
  EXPECT_EQ(side_of_plane({0, 0, 3}, {5, 5, 1}, 0, posed({0, 0, 1}, identity)), Sign::zero);
  EXPECT_EQ(side_of_plane({0, 0, 3}, {5, 5, 1}, 0, posed({0, 0, std::nextafter(1, 2)}, identity)), Sign::positive);
  EXPECT_EQ(side_of_plane({0, 0, 3}, {5, 5, 0}, 3, posed({0, 0, std::nextafter(1, 0)}, identity)), Sign::negative);
  EXPECT_EQ(side_of_plane({1, 0, 0}, {}, 8, posed({0, 2, 0}, turned)), Sign::zero);
  EXPECT_EQ(side_of_plane({1, 0, 0}, {}, 8, posed({0, 3, 0}, turned)), Sign::negative);
  EXPECT_EQ(side_of_plane({0, 0, 1}, {0, 0, 1}, 1, posed({0, 0, 1}, turned)), Sign::zero);
}

// Against exact arithmetic written out here; many on the plane by construction, at all sizes.
TEST(PlaneSideTest, ByExactArithmetic) {
  Random random(7);
  int zeros = 0, exact = 0;
  for (int round = 0; round < 20000; ++round) {
    const auto small = [&] { return std::floor(random.uniform(-8, 9)); };
    const double size = std::ldexp(1.0, static_cast<int>(random.uniform(-300, 300)));
    const Point3 n{small(), small(), small()}, on{small() * size, small() * size, small() * size};
    const Point3 x{small() * size, small() * size, small() * size};
    Affine3 pose;
    for (double& m : pose.linear) m = small();
    for (double& t : pose.translation) t = small() * size;
    double offset = small() * size;
    const auto value = [&]<class Number>(Number) {
      const auto row = [&](std::size_t i) {
        return Number(pose.linear[3 * i]) * Number(x.x) + Number(pose.linear[3 * i + 1]) * Number(x.y) +
               Number(pose.linear[3 * i + 2]) * Number(x.z) + Number(pose.translation[i]);
      };
      return Number(n.x) * (row(0) + Number(-on.x)) + Number(n.y) * (row(1) + Number(-on.y)) +
             Number(n.z) * (row(2) + Number(-on.z));
    };
    if (round % 2 == 0) offset = value(0.0);  // small integers times the size: exactly
    if (round % 4 == 0) offset = std::nextafter(offset, offset + size);
    StageTally tally;
    const Sign sign = side_of_plane(n, on, offset, posed(x, pose), &tally);
    ASSERT_EQ(static_cast<int>(sign), (value(tests::Exact(0.0)) + tests::Exact(-offset)).sign());
    zeros += sign == Sign::zero ? 1 : 0;
    exact += tally.exact > 0 ? 1 : 0;
  }
  EXPECT_GT(zeros, 4000);
  EXPECT_GT(exact, 4000);
}

// Planes through three points; every second point is in the plane but for the last bits of one coordinate.
TEST(PlaneSideTest, OfEstimates) {
  Random random(8);
  int zeros = 0, exact = 0, sure = 0;
  for (int round = 0; round < 2000; ++round) {
    const auto any = [&] { return Point3{random.unit(), random.unit(), random.unit()}; };
    const Point3 a = any(), b = any(), c = any();
    Point3 p = any();
    if (round % 2 == 0) p = {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, std::nextafter(a.z / 2 + b.z / 2, round % 4 - 1)};
    if (round % 5 == 0) p = c;
    const auto normal = [&]<class Number>(Number) {
      const Vector3<Number> from = coordinates<Number>(a);
      return cross(coordinates<Number>(b) - from, coordinates<Number>(c) - from);
    };
    StageTally tally;
    const Sign side = side_of_plane(
        normal(Estimate()), coordinates<Estimate>(a), coordinates<Estimate>(p),
        [&] { return dot(normal(Dyadic()), coordinates<Dyadic>(p) - coordinates<Dyadic>(a)); }, &tally);
    ASSERT_EQ(side, orient_3d(a, b, c, p)) << round;
    ASSERT_EQ(tally.rounded, 0u);
    ASSERT_EQ(tally.interval + tally.exact, 1u);
    zeros += side == Sign::zero;
    exact += tally.exact > 0;
    sure += tally.interval > 0;
  }
  EXPECT_GE(zeros, 400);
  EXPECT_GE(exact, 400);
  EXPECT_GT(sure, 1500);
}

}  // namespace
}  // namespace sunder
