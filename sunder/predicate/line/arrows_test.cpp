// cross_2d and dot_2d against rational numbers: the sign, and that filters decide where they should.
#include <sunder/base/random.h>
#include <sunder/number/rational_test.h>
#include <sunder/predicate/line/arrows.h>

#include <tests/support/doubles.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace sunder {
namespace {

using tests::largest, tests::least;

using RationalPoint = std::array<Rational, 2>;
RationalPoint rational_image(const Point2& p) { return {rational(p.x), rational(p.y)}; }
RationalPoint rational_image(const Posed2& p) {
  const auto& [m, t] = *p.pose;
  const RationalPoint x = rational_image(p.point);
  return {rational(m[0]) * x[0] + rational(m[1]) * x[1] + rational(t[0]),
          rational(m[2]) * x[0] + rational(m[3]) * x[1] + rational(t[1])};
}

// Other forms than those of the library: cross as a difference of expanded products.
template <class P>
std::array<Sign, 2> truth(const P& p, const P& q, const P& r, const P& s) {
  const RationalPoint a = rational_image(p), b = rational_image(q), c = rational_image(r), d = rational_image(s);
  const Rational cross =
      b[0] * d[1] - b[0] * c[1] - a[0] * d[1] + a[0] * c[1] - b[1] * d[0] + b[1] * c[0] + a[1] * d[0] - a[1] * c[0];
  const Rational dot =
      b[0] * d[0] - b[0] * c[0] - a[0] * d[0] + a[0] * c[0] + b[1] * d[1] - b[1] * c[1] - a[1] * d[1] + a[1] * c[1];
  return {static_cast<Sign>(cross.sign()), static_cast<Sign>(dot.sign())};
}

template <class P>
void expect_true_products(const std::array<P, 4>& p, StageTally& tally) {
  const auto [cross, dot] = truth(p[0], p[1], p[2], p[3]);
  ASSERT_EQ(cross_2d(p[0], p[1], p[2], p[3], &tally), cross);
  ASSERT_EQ(dot_2d(p[0], p[1], p[2], p[3], &tally), dot);
  ASSERT_EQ(cross_2d(p[2], p[3], p[0], p[1], &tally), -cross);
  ASSERT_EQ(dot_2d(p[1], p[0], p[2], p[3], &tally), -dot);
}

TEST(ArrowsTest, Examples) {
  const Point2 o{0, 0}, x{1, 0}, y{0, 1};
  EXPECT_EQ(cross_2d(o, x, o, y), Sign::positive);
  EXPECT_EQ(cross_2d(o, y, o, x), Sign::negative);
  EXPECT_EQ(cross_2d(o, x, y, Point2{5, 1}), Sign::zero);
  EXPECT_EQ(dot_2d(o, x, o, y), Sign::zero);
  EXPECT_EQ(dot_2d(o, x, y, Point2{5, 7}), Sign::positive);
  EXPECT_EQ(dot_2d(o, x, Point2{5, 7}, y), Sign::negative);
}

TEST(ArrowsTest, PlainPoints) {
  Random random(41);
  StageTally tally;
  std::array<int, 3> signs{};
  const int count = tests::scaled_count(8000, 1000);
  for (int i = 0; i < count; ++i) {
    const double scale = std::exp2(static_cast<double>(random.between(-1070, 1018)));
    const auto number = [&]() -> double {
      switch (i % 4) {
        case 0: return static_cast<double>(random.between(-4, 4)) * scale;
        case 1: return random.uniform(-1, 1);
        case 2: return 1 + static_cast<double>(random.between(-3, 3)) * 0x1p-52;
        default: return random.uniform(-1, 1) * std::exp2(static_cast<double>(random.between(-1070, 1020)));
      }
    };
    std::array<Point2, 4> p;
    for (Point2& q : p) q = {number(), number()};
    ASSERT_NO_FATAL_FAILURE(expect_true_products(p, tally)) << i;
    ++signs[static_cast<std::size_t>(static_cast<int>(cross_2d(p[0], p[1], p[2], p[3])) + 1)];
  }
  if (count < 8000) return;  // rates of a small run say little
  for (const int of_sign : signs) EXPECT_GT(of_sign, 200);
  EXPECT_GT(tally.exact, 200u);
  EXPECT_GT(tally.rounded, 16000u);
}

// One product only: its sign is sure however small it is.
TEST(ArrowsTest, AxisParallelArrowsNeedNoExactNumbers) {
  StageTally tally;
  for (const double size : {least, 1.0, largest}) {
    for (const double other : {least, 1.0, largest}) {
      EXPECT_EQ(cross_2d(Point2{0, 0}, {size, 0}, {1, 0}, {1, other}, &tally), Sign::positive);
      EXPECT_EQ(cross_2d(Point2{0, 0}, {-size, 0}, {1, 0}, {1, other}, &tally), Sign::negative);
      EXPECT_EQ(cross_2d(Point2{0, 0}, {0, size}, {0, 1}, {other, 1}, &tally), Sign::negative);
      EXPECT_EQ(cross_2d(Point2{0, 0}, {size, 0}, {0, 1}, {other, 1}, &tally), Sign::zero);
      EXPECT_EQ(dot_2d(Point2{0, 0}, {size, 0}, {0, 1}, {other, 1}, &tally), Sign::positive);
      EXPECT_EQ(dot_2d(Point2{0, 0}, {size, 0}, {1, 0}, {1, other}, &tally), Sign::zero);
    }
  }
  EXPECT_EQ(tally.exact, 0u);
  EXPECT_EQ(tally.interval, 0u);
}

TEST(ArrowsTest, PosedPoints) {
  Random random(43);
  StageTally tally;
  const int count = tests::scaled_count(3000, 500);
  for (int i = 0; i < count; ++i) {
    const bool grid = i % 3 == 0;
    const auto number = [&] { return grid ? static_cast<double>(random.between(-3, 3)) : random.uniform(-1, 1); };
    const double shift = std::exp2(static_cast<double>(random.between(-40, 40)));
    std::array<Affine2, 2> poses;
    for (Affine2& pose : poses) {
      for (double& x : pose.linear) x = number();
      for (double& x : pose.translation) x = number() * (grid ? 1 : shift);
    }
    std::array<Posed2, 4> p{};
    for (std::size_t k = 0; k < 4; ++k) {
      const Affine2& pose = poses[k / 2];
      const SizeRange linear = size_range(pose.linear), translation = size_range(pose.translation);
      // Every third one without a known error: the first stage is passed over.
      p[k] = {{number(), number()}, &pose, i % 3 != 1};
      if (i % 3 != 1) p[k].error = image_error(linear, translation, 3);
    }
    ASSERT_NO_FATAL_FAILURE(expect_true_products(p, tally)) << i;
  }
  if (count < 3000) return;  // rates of a small run say little
  EXPECT_GT(tally.rounded, 4000u);
  EXPECT_GT(tally.interval, 500u);
  EXPECT_GT(tally.exact, 150u);
}

// The error of an image is what it says.
TEST(ArrowsTest, ImageErrors) {
  Random random(47);
  double worst = 0;
  for (int i = 0; i < 4000; ++i) {
    Affine2 pose;
    for (double& x : pose.linear) x = random.uniform(-1, 1);
    for (double& x : pose.translation)
      x = random.uniform(-1, 1) * std::exp2(static_cast<double>(random.between(-3, 3)));
    const Posed2 p{{random.uniform(-2, 2), random.uniform(-2, 2)}, &pose, true};
    const double error = image_error(size_range(pose.linear), size_range(pose.translation), 2);
    const Point2 rounded = p.rounded_image();
    const RationalPoint truly = rational_image(p);
    for (const Rational& off : {rational(rounded.x) - truly[0], rational(rounded.y) - truly[1]}) {
      const Rational size = off < 0 ? -off : off;
      ASSERT_LE(size, rational(error));
      worst = std::max(worst, (size / rational(error)).about());
    }
  }
  EXPECT_GT(worst, 0.1);
}

}  // namespace
}  // namespace sunder
