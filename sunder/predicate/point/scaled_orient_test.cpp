// Against exact numbers, at all sizes; and that floating point decides what it is there for.
#include <sunder/base/random.h>
#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/point/scaled_orient.h>

#include <tests/support/doubles.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace sunder {
namespace {

using tests::largest, tests::least;

Sign exact_side(const std::array<Point3, 4>& p) {
  return orient_3d_formula(lift<ExactStage>(p[0]), lift<ExactStage>(p[1]), lift<ExactStage>(p[2]),
                           lift<ExactStage>(p[3]))
      .sign();
}

struct SideCount {
  int all = 0, sure = 0, zero = 0;

  void check(const std::array<Point3, 4>& p) {
    const Sign expected = exact_side(p);
    const Guess guess = scaled_orient_3d(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(orient_3d_of_any_size(p[0], p[1], p[2], p[3]), expected);
    ++all;
    zero += expected == Sign::zero;
    if (!is_sure(guess)) return;
    ++sure;
    ASSERT_EQ(to_sign(guess), expected);
  }
};

// A number of any size, some as small as there are or as large.
double of_any_size(Random& random) {
  const double sign = random.below(2) != 0 ? 1 : -1;
  switch (random.below(6)) {
    case 0: return 0;
    case 1: return sign * least * static_cast<double>(1 + random.below(5));
    case 2: return sign * largest;
    case 3: return sign;
    default: return sign * std::ldexp(1 + random.unit(), static_cast<int>(random.between(-1070, 1022)));
  }
}

TEST(ScaledOrient, AnyNumbers) {
  Random random(tests::chosen_seed(41));
  SideCount count;
  for (int i = tests::scaled_count(20000, 5000); i > 0; --i) {
    std::array<Point3, 4> p;
    for (Point3& q : p) q = {of_any_size(random), of_any_size(random), of_any_size(random)};
    if (random.below(4) == 0) p[3] = {p[1].x, p[2].y, p[0].z};
    count.check(p);
    if (HasFatalFailure()) FAIL() << i;
  }
  EXPECT_GT(count.sure, count.all / 2);
  EXPECT_GT(count.zero, count.all / 100);
}

// Three points of a parabola that crowd together at the origin, and one far from them: in any order.
TEST(ScaledOrient, PointsThatCrowdTogether) {
  Random random(tests::chosen_seed(42));
  SideCount count;
  for (int i = tests::scaled_count(20000, 5000); i > 0; --i) {
    std::array<Point3, 4> p{Point3{0.5, 0.6, 1}};
    const double t = std::exp2(-random.uniform(0, 500));
    for (std::size_t k = 1; k < 4; ++k) {
      const double s = t * std::exp2(-random.uniform(0, 3));
      p[k] = {s, s * s, 0};
    }
    for (std::size_t k = 3; k > 0; --k) std::swap(p[k], p[random.below(k + 1)]);
    count.check(p);
    if (HasFatalFailure()) FAIL() << i;
  }
  EXPECT_GT(count.sure, count.all * 99 / 100);
}

// One axis is scaled by 2^600, or 2^-600.
TEST(ScaledOrient, AxesThatAreScaledApart) {
  Random random(tests::chosen_seed(43));
  SideCount count;
  for (int i = tests::scaled_count(20000, 5000); i > 0; --i) {
    std::array<Point3, 4> p;
    const double by = random.below(2) != 0 ? 0x1p600 : 0x1p-600;
    for (Point3& q : p) q = {by * random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    count.check(p);
    if (HasFatalFailure()) FAIL() << i;
  }
  EXPECT_GT(count.sure, count.all * 99 / 100);
}

// Nearly in a plane, and in it.
TEST(ScaledOrient, NearTies) {
  Random random(tests::chosen_seed(44));
  SideCount count;
  for (int i = tests::scaled_count(20000, 5000); i > 0; --i) {
    std::array<Point3, 4> p;
    const double by = std::ldexp(1.0, static_cast<int>(random.between(-1000, 900)));
    const auto whole = [&] { return static_cast<double>(random.between(-9, 9)); };
    for (Point3& q : p) q = {whole(), whole(), whole()};
    const double s = whole(), t = whole();
    const auto mixed = [&](double a, double b, double c) { return a + s * (b - a) + t * (c - a); };
    p[3] = {mixed(p[0].x, p[1].x, p[2].x), mixed(p[0].y, p[1].y, p[2].y), mixed(p[0].z, p[1].z, p[2].z)};
    if (random.below(2) != 0) p[3].z = std::nextafter(p[3].z, random.below(2) != 0 ? 1e9 : -1e9);
    for (Point3& q : p) q = {by * q.x, by * q.y, q.z};
    count.check(p);
    if (HasFatalFailure()) FAIL() << i;
  }
  EXPECT_GT(count.zero, count.all / 4);
}

}  // namespace
}  // namespace sunder
