#include <sunder/predicate/point/facet_plane.h>

#include <sunder/base/random.h>

#include <tests/support/doubles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sunder {
namespace {

// Rounded as the points of a box are: highest corner minus lowest.
Point3 extent_of(const std::array<Point3, 4>& points) {
  Point3 low = points[0], high = points[0];
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return {high.x - low.x, high.y - low.y, high.z - low.z};
}

// How often the filter was sure.
struct Tally {
  int sure = 0;
  int asked = 0;
};

// Whatever the filter is sure of is so, and the side is orient_3d's.
void check_side(const std::array<Point3, 4>& points, const Point3& extent, Tally& tally) {
  const auto& [a, b, c, q] = points;
  const FacetPlane plane(a, b, c, extent);
  const Sign side = orient_3d(a, b, c, q);
  EXPECT_EQ(plane.side(a, b, c, q), side);
  const Guess guess = plane.guess_side(a, q);
  if (is_sure(guess)) {
    EXPECT_EQ(to_sign(guess), side);
  }
  tally.sure += is_sure(guess);
  ++tally.asked;
}

Point3 random_point(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

// Three points, and one at about the given height over their plane, in units of their size.
std::array<Point3, 4> near_plane(Random& random, double size, double height) {
  const Point3 a = random_point(random, size), b = random_point(random, size), c = random_point(random, size);
  const double s = random.uniform(-1, 1), t = random.uniform(-1, 1);
  const auto on_plane = [&](double p, double q, double r) { return p + s * (q - p) + t * (r - p) + height * size; };
  return {a, b, c, {on_plane(a.x, b.x, c.x), on_plane(a.y, b.y, c.y), on_plane(a.z, b.z, c.z)}};
}

TEST(FacetPlane, FarFromThePlaneTheFilterIsSure) {
  Random random(1);
  Tally tally;
  for (int i = 0; i < 10000; ++i) {
    const std::array<Point3, 4> points{random_point(random, 1), random_point(random, 1), random_point(random, 1),
                                       random_point(random, 1)};
    check_side(points, extent_of(points), tally);
  }
  EXPECT_GT(tally.sure, tally.asked - 5);
}

TEST(FacetPlane, NearThePlaneTheFilterIsRight) {
  Random random(2);
  Tally tally;
  for (int i = 0; i < 40000; ++i) {
    const double height = (i % 2 == 0 ? 1 : -1) * random.log_uniform(0x1p-60, 0x1p-40);
    const std::array<Point3, 4> points = near_plane(random, 1, height);
    check_side(points, extent_of(points), tally);
  }
  EXPECT_GT(tally.sure, tally.asked / 4);
  EXPECT_LT(tally.sure, tally.asked * 3 / 4);
}

TEST(FacetPlane, OnThePlaneTheFilterIsUnsure) {
  Random random(3);
  const auto whole = [&] { return static_cast<double>(random.between(-1000, 1000)); };
  Tally tally;
  for (int i = 0; i < 5000; ++i) {
    std::array<Point3, 4> points;
    for (Point3& p : points) {
      p = {whole(), whole(), 0};
      p.z = 3 * p.x - 7 * p.y;
    }
    check_side(points, extent_of(points), tally);
    EXPECT_EQ(orient_3d(points[0], points[1], points[2], points[3]), Sign::zero);
  }
  EXPECT_EQ(tally.sure, 0);
}

TEST(FacetPlane, UnderflowIsInTheBound) {
  // From 2^-340 on, what floating point makes of the determinant is more and more wrong, and zero in the end.
  Random random(4);
  Tally some, none;
  for (int exponent = -370; exponent <= -330; ++exponent) {
    for (int i = 0; i < 2000; ++i) {
      const double height = i % 2 == 0 ? random.log_uniform(0x1p-60, 1) : -random.log_uniform(0x1p-60, 1);
      const std::array<Point3, 4> points = near_plane(random, std::ldexp(1.0, exponent), height);
      check_side(points, extent_of(points), some);
    }
  }
  EXPECT_GT(some.sure, some.asked / 4);
  EXPECT_LT(some.sure, some.asked * 3 / 4);
  for (const int exponent : {-1000, -600, -400}) {
    for (int i = 0; i < 200; ++i) {
      const std::array<Point3, 4> points = near_plane(random, std::ldexp(1.0, exponent), 0.5);
      check_side(points, extent_of(points), none);
    }
  }
  EXPECT_EQ(none.sure, 0);
}

TEST(FacetPlane, UnderflowOfOnePartIsInTheBound) {
  // Components of any size: what underflows in the normal counts again when it is multiplied by a large coordinate.
  Random random(5);
  Tally tally;
  const auto value = [&] { return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.between(-600, 330))); };
  for (int i = 0; i < 40000; ++i) {
    std::array<double, 3> common;  // some coordinates repeat, so that differences are zero or small
    for (double& x : common) x = value();
    std::array<Point3, 4> points;
    for (Point3& p : points) {
      const auto pick = [&](double x) { return random.below(2) == 0 ? x : value(); };
      p = {pick(common[0]), pick(common[1]), pick(common[2])};
    }
    check_side(points, extent_of(points), tally);
  }
  EXPECT_GT(tally.sure, tally.asked / 20);
  EXPECT_LT(tally.sure, tally.asked);
}

TEST(FacetPlane, UnderflowOfTheNormalIsInTheBound) {
  // Three points so close that little is left of the normal, and one far away.
  Random random(8);
  Tally tally;
  for (int i = 0; i < 20000; ++i) {
    const double size = std::ldexp(1.0, static_cast<int>(random.between(-542, -520)));
    const double far = std::ldexp(1.0, static_cast<int>(random.between(-20, 300)));
    const std::array<Point3, 4> points{random_point(random, size), random_point(random, size),
                                       random_point(random, size), random_point(random, far)};
    check_side(points, extent_of(points), tally);
  }
  EXPECT_GT(tally.sure, tally.asked / 3);
  EXPECT_LT(tally.sure, tally.asked * 9 / 10);
}

TEST(FacetPlane, OverflowMakesTheFilterUnsure) {
  Random random(6);
  Tally tally;
  for (const int exponent : {345, 400, 600, 1000, 1023}) {
    for (int i = 0; i < 200; ++i) {
      const std::array<Point3, 4> points{
          random_point(random, std::ldexp(1.0, exponent)), random_point(random, std::ldexp(1.0, exponent)),
          random_point(random, std::ldexp(1.0, exponent)), random_point(random, std::ldexp(1.0, exponent))};
      check_side(points, extent_of(points), tally);
    }
  }
  EXPECT_EQ(tally.sure, 0);
  const FacetPlane plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, tests::infinity});
  EXPECT_EQ(plane.guess_side({0, 0, 0}, {0, 0, 1}), Guess::unsure);
}

TEST(FacetPlane, ALargerExtentOnlyMakesItLessSure) {
  Random random(7);
  Tally tight, wide;
  for (int i = 0; i < 10000; ++i) {
    const double height = (i % 2 == 0 ? 1 : -1) * random.log_uniform(0x1p-50, 0x1p-10);
    const std::array<Point3, 4> points = near_plane(random, 1, height);
    const Point3 extent = extent_of(points);
    check_side(points, extent, tight);
    check_side(points, {0x1p20 * extent.x, 0x1p20 * extent.y, 0x1p20 * extent.z}, wide);
  }
  EXPECT_GT(wide.sure, wide.asked / 4);
  EXPECT_GT(tight.sure, wide.sure + tight.asked / 4);
}

TEST(FacetPlane, HeightHasTheSignAndTheScaleOfTheDeterminant) {
  const FacetPlane plane({1, 1, 1}, {3, 1, 1}, {1, 4, 1}, {10, 10, 10});
  EXPECT_EQ(plane.height({1, 1, 1}, {7, 8, 2}), 6);
  EXPECT_EQ(plane.height({1, 1, 1}, {7, 8, -1}), -12);
}

}  // namespace
}  // namespace sunder
