// The claims R1 to R3 of rounded.h, against rational arithmetic.
#include <sunder/base/random.h>
#include <sunder/number/rational_test.h>
#include <sunder/number/rounded.h>

#include <tests/support/doubles.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

namespace sunder {
namespace {

using tests::infinity, tests::largest;

constexpr double u = 0x1p-53;

// The exact value, X of R1 (a sum or product of two leaves counts as one term), and whether it is a leaf.
struct Terms {
  Rational value, size;
  bool is_leaf;
};
Terms terms(double x) { return {rational(x), abs(rational(x)), true}; }
Terms operator+(const Terms& a, const Terms& b) {
  const Rational sum = a.value + b.value;
  return {sum, a.is_leaf && b.is_leaf ? abs(sum) : a.size + b.size, false};
}
Terms operator-(const Terms& a, const Terms& b) { return a + Terms{-b.value, b.size, b.is_leaf}; }
Terms operator*(const Terms& a, const Terms& b) { return {a.value * b.value, a.size * b.size, false}; }

Rational power(const Rational& x, int n) {
  Rational result = 1;
  for (int i = 0; i < n; ++i) result *= x;
  return result;
}

template <int K>
constexpr int roundings(const Rounded<K>&) {
  return K;
}

// What is known of R1 to R3 for one formula, over many inputs.
struct Record {
  int count = 0, sure = 0, zero = 0;
  double worst = 0;  // the greatest error, in units of u times the magnitude

  template <class Formula>
  void check(const Formula& formula, const std::array<double, 8>& x) {
    const auto rounded = formula(
        std::array{leaf(x[0]), leaf(x[1]), leaf(x[2]), leaf(x[3]), leaf(x[4]), leaf(x[5]), leaf(x[6]), leaf(x[7])});
    const Terms exact = formula(std::array{terms(x[0]), terms(x[1]), terms(x[2]), terms(x[3]), terms(x[4]), terms(x[5]),
                                           terms(x[6]), terms(x[7])});
    constexpr int k = roundings(decltype(rounded){});
    const Rational error = abs(rational(rounded.value) - exact.value);
    ASSERT_LE(error, (power(1 + rational(u), k) - 1) * exact.size) << "R1";
    ASSERT_LE(exact.size * power(1 - rational(u), k), rational(rounded.magnitude)) << "R2";
    ASSERT_LE(error, rational(rounded.bound * rounded.magnitude)) << "R3";
    const Guess guess = sign(rounded);
    ++count;
    if (is_sure(guess)) {
      ASSERT_EQ(static_cast<int>(guess), exact.value.sign());
      ++sure;
    }
    if (exact.value == 0) ++zero;
    if (rounded.magnitude != 0) worst = std::max(worst, (error / rational(u * rounded.magnitude)).about());
  }
};

// All by 2^scale: near-degenerate in many ways, because the last numbers are rounded combinations of the first.
std::array<double, 8> inputs(Random& random, int scale) {
  std::array<double, 8> x{};
  const std::uint64_t kind = random.below(4);
  for (double& v : x) {
    v = kind == 0 ? static_cast<double>(random.between(-3, 3)) : random.uniform(-1, 1);
    if (kind == 2) v = std::ldexp(v, static_cast<int>(random.between(-40, 0)));
  }
  if (kind == 3) {
    x[3] = x[1] * x[2] / x[0];
    x[5] = -(x[0] + x[1] * x[2]);
    x[7] = x[6] * (1 + static_cast<double>(random.between(-2, 2)) * 0x1p-52);
  }
  for (double& v : x) v = std::ldexp(v, scale);
  return x;
}

constexpr auto sum_2 = [](const auto& x) { return x[0] + x[1]; };
constexpr auto difference_2 = [](const auto& x) { return x[6] - x[7]; };
constexpr auto product_2 = [](const auto& x) { return x[0] * x[1]; };
constexpr auto sum_5 = [](const auto& x) { return (((x[0] + x[1]) - x[2]) + x[3]) - x[4]; };
constexpr auto determinant_2 = [](const auto& x) { return x[0] * x[3] - x[1] * x[2]; };
constexpr auto turn = [](const auto& x) { return (x[0] - x[2]) * (x[3] - x[1]) - (x[4] - x[2]) * (x[5] - x[1]); };
constexpr auto image = [](const auto& x) { return (x[0] * x[1] + x[2] * x[3]) + (x[4] * x[5] + x[6]); };
constexpr auto cubic = [](const auto& x) {
  return ((x[0] - x[1]) * (x[2] - x[3]) - (x[4] - x[5]) * (x[6] - x[7])) * (x[1] - x[2]) - x[0] * x[3] * x[7];
};

static_assert(sum_roundings<0, 0> == 1 && sum_roundings<3, 1> == 4 && sum_roundings<1, 3> == 4);
static_assert(std::is_same_v<decltype(leaf(1)), Rounded<0>>);
static_assert(std::is_same_v<decltype(leaf(1) * leaf(1)), Rounded<1>>);
static_assert(std::is_same_v<decltype((leaf(1) - leaf(1)) * (leaf(1) * leaf(1))), Rounded<3>>);

template <class Formula>
Record record(const Formula& formula, std::uint64_t number, int count) {
  Random random(tests::chosen_seed(number));
  Record result;
  for (int i = 0; i < count; ++i) {
    // Up to the ends of the tame range, whose least numbers serve the formulas with three factors.
    const int scale = i % 4 == 0 ? -240 : i % 4 == 1 ? 280 : static_cast<int>(random.between(-240, 280));
    result.check(formula, inputs(random, scale));
    if (::testing::Test::HasFatalFailure()) {
      ADD_FAILURE() << "formula " << number << ", instance " << i;
      break;
    }
  }
  return result;
}

TEST(RoundedTest, BoundsHoldForEachFormula) {
  const int n = tests::scaled_count(1500, 1000);
  const Record records[] = {record(sum_2, 1, n), record(difference_2, 2, n),  record(product_2, 3, n),
                            record(sum_5, 4, n), record(determinant_2, 5, n), record(turn, 6, n),
                            record(image, 7, n), record(cubic, 8, n)};
  int zeros = 0;
  for (const Record& r : records) {
    EXPECT_EQ(r.count, n);
    EXPECT_GT(r.sure, n / 2);
    EXPECT_GT(r.worst, 0.4);  // in u: errors were near their bounds, so that much smaller ones would not have held
    zeros += r.zero;
  }
  EXPECT_GT(zeros, n / 10);
  EXPECT_GT(records[0].worst, 0.8);
  EXPECT_GT(records[4].worst, 0.8);
}

TEST(RoundedTest, BoundIsNearlyReachedByLongSums) {
  // 1 + u + u + ...: every addition loses u.
  const auto s3 = leaf(1) + leaf(u) + leaf(u) + leaf(u);
  static_assert(roundings(decltype(s3){}) == 3);
  EXPECT_EQ(s3.value, 1);
  EXPECT_GT(s3.bound * s3.magnitude, 3 * u);
  const auto s6 = s3 + leaf(u) + leaf(u) + leaf(u);
  EXPECT_EQ(s6.value, 1);
  EXPECT_GT(s6.bound * s6.magnitude, 6 * u);
  // The exact difference is positive, the computed one negative.
  const auto difference = s6 - leaf(1 + 4 * u);
  EXPECT_LT(difference.value, 0);
  EXPECT_EQ(sign(difference), Guess::unsure);
}

TEST(RoundedTest, OneRoundingIsSure) {
  // The difference of two doubles has the right sign however near they are.
  EXPECT_EQ(sign(leaf(1 + 2 * u) - leaf(1)), Guess::positive);
  EXPECT_EQ(sign(leaf(1 - u) - leaf(1)), Guess::negative);
  EXPECT_EQ(sign(leaf(1) - leaf(1)), Guess::zero);
  EXPECT_EQ(sign(leaf(1e300) - leaf(1)), Guess::positive);
}

TEST(RoundedTest, Zero) {
  EXPECT_EQ(sign(leaf(0)), Guess::zero);
  EXPECT_EQ(sign(leaf(-0.0)), Guess::zero);
  EXPECT_EQ(sign(leaf(0) * leaf(3) + leaf(5) * leaf(-0.0)), Guess::zero);
  EXPECT_EQ(sign((leaf(2) - leaf(2)) * leaf(3) - leaf(0)), Guess::zero);
  // Terms that cancel are no zero by themselves: rounding may have done it.
  EXPECT_EQ(sign(leaf(2) * leaf(3) - leaf(3) * leaf(2)), Guess::unsure);
}

TEST(RoundedTest, OverflowIsUnsure) {
  EXPECT_EQ(sign(leaf(largest) + leaf(largest)), Guess::unsure);
  EXPECT_EQ(sign(leaf(largest) * leaf(-2)), Guess::unsure);
  EXPECT_EQ(sign(leaf(largest) * leaf(2) - leaf(largest) * leaf(2)), Guess::unsure);
  EXPECT_EQ(sign(leaf(largest) * leaf(2) * leaf(0)), Guess::unsure);
  EXPECT_EQ(sign(Rounded<3>{std::numeric_limits<double>::quiet_NaN(), 1}), Guess::unsure);
  EXPECT_EQ(sign(Rounded<3>{1, infinity}), Guess::unsure);
}

TEST(RoundedTest, SignComparesWithTheBound) {
  constexpr double bound = Rounded<5>::bound;
  EXPECT_EQ(bound, 6 * u);
  EXPECT_EQ(sign(Rounded<5>{bound, 1}), Guess::unsure);
  EXPECT_EQ(sign(Rounded<5>{-bound, 1}), Guess::unsure);
  EXPECT_EQ(sign(Rounded<5>{bound * (1 + 2 * u), 1}), Guess::positive);
  EXPECT_EQ(sign(Rounded<5>{-bound * (1 + 2 * u), 1}), Guess::negative);
}

TEST(RoundedTest, TameLimits) {
  for (const double sign : {1.0, -1.0}) {
    EXPECT_TRUE(tame(sign * 0.0));
    EXPECT_TRUE(tame(sign * 0x1p-280));
    EXPECT_TRUE(tame(sign));
    EXPECT_TRUE(tame(sign * 0x1p280));
    EXPECT_FALSE(tame(sign * std::nextafter(0x1p-280, 0)));
    EXPECT_FALSE(tame(sign * std::nextafter(0x1p280, infinity)));
    EXPECT_FALSE(tame(sign * std::numeric_limits<double>::denorm_min()));
    EXPECT_FALSE(tame(sign * largest));
    EXPECT_FALSE(tame(sign * infinity));
  }
  EXPECT_FALSE(tame(std::numeric_limits<double>::quiet_NaN()));
}

TEST(RoundedTest, TameNumbersDoNotUnderflow) {
  // Differences of neighbours at the lower end, the least that there are: their product of three is exact and normal.
  const double lowest = 0x1p-280;
  const auto tiny = leaf(std::nextafter(lowest, 1)) - leaf(lowest);
  EXPECT_EQ(tiny.value, 0x1p-332);
  const auto product = tiny * tiny * tiny;
  EXPECT_EQ(product.value, 0x1p-996);
  EXPECT_GE(product.value, std::numeric_limits<double>::min());
  EXPECT_EQ(sign(product), Guess::positive);
  const auto greatest = leaf(0x1p280) - leaf(-0x1p280);
  const auto high = greatest * greatest * greatest + greatest * greatest * greatest;
  EXPECT_LT(high.magnitude, 0x1p850);
  EXPECT_EQ(sign(high), Guess::positive);

  // Random ones near the lower end: R1 to R3 hold to the last bit.
  Random random(tests::chosen_seed(9));
  Record cubics;
  const int n = tests::scaled_count(1500, 1000);
  for (int i = 0; i < n; ++i) {
    std::array<double, 8> x{};
    for (double& v : x) {
      v = std::ldexp(random.uniform(1, 2), static_cast<int>(random.between(-280, -270))) * (random.below(2) ? 1 : -1);
      ASSERT_TRUE(tame(v));
    }
    x[2] = x[1] * (1 + 2 * u);  // one factor with a single bit
    x[3] = std::nextafter(x[2], 1);
    cubics.check(cubic, x);
    if (HasFatalFailure()) FAIL() << "instance " << i;
  }
  EXPECT_EQ(cubics.count, n);
  EXPECT_GT(cubics.sure, n / 2);
  EXPECT_GT(cubics.worst, 0.4);
}

TEST(RoundedTest, UnderflowIsNotSeen) {
  // What `tame` is for: without it the sign would be sure, and wrong.
  const auto wrong = leaf(0x1p-600) * leaf(0x1p-600) - leaf(0) * leaf(1);
  EXPECT_FALSE(tame(0x1p-600));
  EXPECT_EQ(sign(wrong), Guess::zero);
}

}  // namespace
}  // namespace sunder
