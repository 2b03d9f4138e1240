#include <sunder/predicate/posed.h>

#include <tests/support/doubles.h>

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace sunder {
namespace {

SizeRange sizes(const std::vector<double>& numbers) { return size_range(std::span<const double>(numbers)); }

TEST(PosedTest, SizeRange) {
  using tests::infinity, tests::largest, tests::least;
  const SizeRange none;
  EXPECT_EQ(none.least, infinity);
  EXPECT_EQ(none.greatest, 0);
  const SizeRange zeros = sizes({0, -0.0});
  EXPECT_EQ(zeros.least, infinity);
  EXPECT_EQ(zeros.greatest, 0);
  const SizeRange some = sizes({-3, 0, 0.5, 2});
  EXPECT_EQ(some.least, 0.5);
  EXPECT_EQ(some.greatest, 3);
  const SizeRange extremes = sizes({-least, largest});
  EXPECT_EQ(extremes.least, least);
  EXPECT_EQ(extremes.greatest, largest);
  const std::array<Point3, 2> points{{{1, 0, -7}, {-0.25, 3, 0}}};
  const SizeRange of_points = size_range(std::span<const Point3>(points));
  EXPECT_EQ(of_points.least, 0.25);
  EXPECT_EQ(of_points.greatest, 7);
  EXPECT_EQ(size_range(std::span<const Point3>()).greatest, 0);
}

TEST(PosedTest, TameLimits) {
  using tests::infinity, tests::largest, tests::least;
  const SizeRange one = sizes({1}), none;
  const auto below = [](double x) { return std::nextafter(x, 0); };
  const auto above = [](double x) { return std::nextafter(x, infinity); };
  EXPECT_TRUE(images_are_tame(one, none, one));
  EXPECT_TRUE(images_are_tame(none, none, none));
  EXPECT_TRUE(images_are_tame(one, one, none));
  EXPECT_TRUE(images_are_tame(none, one, one));
  // Products of the matrix and the points.
  EXPECT_TRUE(images_are_tame(one, none, sizes({0x1p-200, 0x1p250})));
  EXPECT_FALSE(images_are_tame(one, none, sizes({below(0x1p-200), 1})));
  EXPECT_FALSE(images_are_tame(one, none, sizes({above(0x1p250), 1})));
  EXPECT_TRUE(images_are_tame(sizes({0x1p-100, 0x1p125}), none, sizes({0x1p-100, 0x1p125})));
  EXPECT_FALSE(images_are_tame(sizes({below(0x1p-100)}), none, sizes({0x1p-100})));
  EXPECT_FALSE(images_are_tame(sizes({0x1p125}), none, sizes({above(0x1p125)})));
  EXPECT_TRUE(images_are_tame(sizes({0x1p-900}), none, sizes({0x1p700, 0x1p1023})));
  EXPECT_TRUE(images_are_tame(sizes({0x1p800}), none, sizes({0x1p-1000})));
  EXPECT_TRUE(images_are_tame(sizes({0x1p1000}), none, sizes({least})));
  // The matrix alone, which is multiplied by directions.
  EXPECT_FALSE(images_are_tame(sizes({below(0x1p-900)}), none, sizes({0x1p900})));
  EXPECT_FALSE(images_are_tame(sizes({least}), none, sizes({0x1p1000})));
  // The translation.
  EXPECT_TRUE(images_are_tame(one, sizes({0x1p-250, 0x1p250}), one));
  EXPECT_FALSE(images_are_tame(one, sizes({below(0x1p-250)}), one));
  EXPECT_FALSE(images_are_tame(one, sizes({above(0x1p250)}), one));
  EXPECT_FALSE(images_are_tame(one, sizes({least}), one));
  // Underflow and overflow of the products themselves.
  EXPECT_FALSE(images_are_tame(sizes({1e-300}), none, sizes({1e-300})));
  EXPECT_FALSE(images_are_tame(sizes({1e300}), none, sizes({1e300})));
  EXPECT_FALSE(images_are_tame(sizes({least, largest}), none, one));
}

TEST(PosedTest, FindsOutByItself) {
  using tests::least;
  const Affine3 identity;
  EXPECT_TRUE(posed({1, 2, 3}, identity).tame);
  EXPECT_TRUE(posed({0, 0, 0}, identity).tame);
  EXPECT_FALSE(posed({1, 2, 1e300}, identity).tame);
  EXPECT_FALSE(posed({1, least, 3}, identity).tame);
  const Affine3 far{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 1e300}};
  EXPECT_FALSE(posed({1, 2, 3}, far).tame);
  const Affine3 tiny{{1, 0, 0, 0, 1, 0, 0, 0, least}, {0, 0, 0}};
  EXPECT_FALSE(posed({1, 2, 3}, tiny).tame);
  const Posed3 p = posed({1, 2, 3}, far);
  EXPECT_EQ(p.point, (Point3{1, 2, 3}));
  EXPECT_EQ(p.pose, &far);
}

}  // namespace
}  // namespace sunder
