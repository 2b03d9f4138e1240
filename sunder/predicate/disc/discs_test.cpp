// Signs against exact numbers, stage by stage.
#include <sunder/base/random.h>
#include <sunder/number/dyadic.h>
#include <sunder/predicate/disc/discs.h>

#include <gtest/gtest.h>

#include <cmath>

namespace sunder {
namespace {

struct Pair {
  Point2 p, q;
  double r = 0, s = 0;
};

// By one formula in exact numbers; the second radius with its sign in the sum.
Sign exact_sign(const Pair& d, bool sum) {
  const Dyadic x = Dyadic(d.q.x) - Dyadic(d.p.x), y = Dyadic(d.q.y) - Dyadic(d.p.y);
  const Dyadic reach = sum ? Dyadic(d.r) + Dyadic(d.s) : Dyadic(d.r) - Dyadic(d.s);
  return (x * x + y * y - reach * reach).sign();
}

void expect_exact(const Pair& d, StageTally* tally) {
  const Sign sum = exact_sign(d, true), difference = exact_sign(d, false);
  ASSERT_EQ(distance_against_sum(d.p, d.r, d.q, d.s, tally), sum);
  ASSERT_EQ(distance_against_sum(d.q, d.s, d.p, d.r), sum);
  ASSERT_EQ(distance_against_difference(d.p, d.r, d.q, d.s, tally), difference);
  ASSERT_EQ(distance_against_difference(d.q, d.s, d.p, d.r), difference);
}

TEST(DiscsTest, KnownPairs) {
  const auto sum = [](double x, double y, double r, double s) {
    return distance_against_sum({1, 1}, r, {1 + x, 1 + y}, s);
  };
  const auto difference = [](double x, double y, double r, double s) {
    return distance_against_difference({1, 1}, r, {1 + x, 1 + y}, s);
  };
  EXPECT_EQ(sum(3, 4, 2, 3), Sign::zero);
  EXPECT_EQ(sum(3, 4, 2, 2), Sign::positive);
  EXPECT_EQ(sum(3, 4, 2, 4), Sign::negative);
  EXPECT_EQ(sum(0, 0, 0, 0), Sign::zero);
  EXPECT_EQ(difference(3, 4, 2, 7), Sign::zero);
  EXPECT_EQ(difference(3, 4, 7, 2), Sign::zero);
  EXPECT_EQ(difference(3, 4, 2, 6), Sign::positive);
  EXPECT_EQ(difference(3, 4, 8, 2), Sign::negative);
  EXPECT_EQ(difference(0, 0, 2, 2), Sign::zero);
}

// Where only one of the differences and the sum is no double, and off by less than one sees.
TEST(DiscsTest, OneIsRounded) {
  for (const double little : {0x1p-60, -0x1p-60}) {
    const Sign nearer = little > 0 ? Sign::negative : Sign::positive;
    EXPECT_EQ(distance_against_sum({little, 0}, 0.5, {1, 0}, 0.5), nearer);
    EXPECT_EQ(distance_against_sum({0, little}, 0.5, {0, 1}, 0.5), nearer);
    EXPECT_EQ(distance_against_difference({little, 0}, 1.5, {1, 0}, 0.5), nearer);
    EXPECT_EQ(distance_against_difference({0, little}, 0.5, {0, 1}, 1.5), nearer);
  }
  EXPECT_EQ(distance_against_sum({0, 0}, 1, {1, 0}, 0x1p-60), Sign::negative);
  EXPECT_EQ(distance_against_difference({0, 0}, 1, {1, 0}, 0x1p-60), Sign::positive);
}

// Small integers, which touch often, as they are and at sizes where squares over- or underflow.
TEST(DiscsTest, IntegersAtAnyScale) {
  Random random(11);
  const auto small = [&] { return static_cast<double>(random.between(-6, 6)); };
  const auto radius = [&] { return static_cast<double>(random.below(8)); };
  int outside = 0, within = 0;
  for (int turn = 0; turn < 20000; ++turn) {
    const double scale = std::ldexp(1, static_cast<int>(turn % 3 == 0 ? 0 : random.between(-1074, 1020)));
    Pair d{{small(), small()}, {small(), small()}, radius(), radius()};
    const Pair scaled{{scale * d.p.x, scale * d.p.y}, {scale * d.q.x, scale * d.q.y}, scale * d.r, scale * d.s};
    StageTally tally;
    ASSERT_NO_FATAL_FAILURE(expect_exact(scaled, &tally)) << turn;
    ASSERT_EQ(exact_sign(scaled, true), exact_sign(d, true));
    if (turn % 3 == 0) {  // what floating point does not decide, exact differences do
      ASSERT_EQ(tally.interval, 0u);
    }
    ASSERT_EQ(tally.rounded + tally.interval + tally.exact, 2u);
    outside += exact_sign(d, true) == Sign::zero;
    within += exact_sign(d, false) == Sign::zero;
  }
  EXPECT_GT(outside, 200);
  EXPECT_GT(within, 200);
}

// A radius that is right to the last bit, or some bits off: every stage has its part.
TEST(DiscsTest, NearTouching) {
  Random random(12);
  StageTally all;
  int zeros = 0;
  for (int turn = 0; turn < 20000; ++turn) {
    Pair d{{random.uniform(-1, 1), random.uniform(-1, 1)}, {random.uniform(-1, 1), random.uniform(-1, 1)}, 0, 0};
    if (turn % 4 == 0) d.q.y = d.p.y;
    const double apart = std::hypot(d.q.x - d.p.x, d.q.y - d.p.y);
    d.r = apart * random.unit();
    d.s = turn % 2 == 0 ? apart - d.r : apart + d.r;
    const double gap = random.log_uniform(0x1p-56, 1);
    d.s += (turn % 8 < 4 ? gap : -gap) * d.s;
    StageTally tally;
    ASSERT_NO_FATAL_FAILURE(expect_exact(d, &tally)) << turn;
    all.rounded += tally.rounded;
    all.interval += tally.interval;
    all.exact += tally.exact;
    zeros += exact_sign(d, true) == Sign::zero || exact_sign(d, false) == Sign::zero;
  }
  EXPECT_GT(all.rounded, 30000u);
  EXPECT_GT(all.exact, 500u);
  EXPECT_GT(zeros, 50);
}

// Any sizes in one pair; the sums of radii overflow too.
TEST(DiscsTest, MixedScales) {
  Random random(13);
  StageTally all;
  for (int turn = 0; turn < 20000; ++turn) {
    const auto any = [&] { return std::ldexp(random.uniform(-2, 2), static_cast<int>(random.between(-1074, 1022))); };
    Pair d{{any(), any()}, {any(), any()}, std::fabs(any()), std::fabs(any())};
    if (turn % 4 == 1) d = {{0x1.fp1023, d.p.y}, {-0x1.fp1023, d.q.y}, 0x1.fp1023, 0x1.fp1023};
    if (turn % 4 == 2) d = {{d.p.x, 0}, {0, 0}, std::fabs(d.p.x), turn % 8 == 2 ? 5e-324 : 0};
    if (turn % 4 == 3) {  // whose squares are not far from the least double
      const auto tiny = [&] { return random.uniform(-0x1p-536, 0x1p-536); };
      d = {{tiny(), tiny()}, {tiny(), tiny()}, std::fabs(tiny()), std::fabs(tiny())};
    }
    ASSERT_NO_FATAL_FAILURE(expect_exact(d, &all)) << turn;
  }
  EXPECT_GT(all.interval, 500u);
}

TEST(DiscsTest, Sums) {
  Random random(14);
  constexpr double greatest = 0x1.fffffffffffffp1023;
  EXPECT_EQ(compare_sums(1, 0x1p-60, 1, 0), Sign::positive);
  EXPECT_EQ(compare_sums(1, -0x1p-60, 1, 0), Sign::negative);
  EXPECT_EQ(compare_sums(0.0, -0.0, -0.0, 0.0), Sign::zero);
  EXPECT_EQ(compare_sums(greatest, greatest, greatest, 0x1p1000), Sign::positive);
  EXPECT_EQ(compare_sums(greatest, greatest, greatest, greatest), Sign::zero);
  EXPECT_EQ(compare_sums(greatest, 5e-324, greatest, 0), Sign::positive);
  EXPECT_EQ(compare_sums(-greatest, -greatest, -greatest, -0x1p1000), Sign::negative);
  int ties = 0;
  StageTally tally;
  for (int turn = 0; turn < 30000; ++turn) {
    const double unit = std::ldexp(1, static_cast<int>(random.between(-1074, 970)));
    const auto small = [&] { return unit * static_cast<double>(random.between(-4, 4)); };
    const auto any = [&] { return std::ldexp(random.uniform(-2, 2), static_cast<int>(random.between(-60, 0))); };
    double a = small(), b = small(), c = small(), d = small();
    if (turn % 3 == 1) a = any(), b = any(), c = any(), d = (a + b) - c;
    if (turn % 3 == 2) a = 1e308 + unit, c = 1e308, d = b;
    const Sign truth = ((Dyadic(a) + Dyadic(b)) - (Dyadic(c) + Dyadic(d))).sign();
    ASSERT_EQ(compare_sums(a, b, c, d, &tally), truth) << turn;
    ASSERT_EQ(compare_sums(c, d, a, b), -truth) << turn;
    ties += truth == Sign::zero;
  }
  EXPECT_GT(ties, 3000);
  EXPECT_GT(tally.rounded, 3000u);
  EXPECT_GT(tally.exact, 3000u);
}

}  // namespace
}  // namespace sunder
