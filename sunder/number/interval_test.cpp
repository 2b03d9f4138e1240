// I1 of interval.h: results enclose what exact arithmetic gives, over the whole range of doubles and beyond it.
#include <sunder/base/random.h>
#include <sunder/number/interval.h>

#include <tests/support/exact.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <array>

namespace sunder {
namespace {

using tests::Exact, tests::infinity, tests::largest, tests::least;

bool encloses(const Interval& i, const Exact& x) {
  if (!(i.low <= i.high) || i.low == infinity || i.high == -infinity) return false;
  return (i.low == -infinity || Exact(i.low) <= x) && (i.high == infinity || x <= Exact(i.high));
}

constexpr std::array special_ends{
    0.0,     -0.0,     1.0,         least,       2 * least, 0x1p-1022, 0x1.fffffffffffffp-1023,
    1e-300,  0x1p-537, 0x1.8p-538,  1e300,       0x1p511,   0x1p512,   0x1.fffffffffffffp511,
    largest, 0x1p1023, 1 + 0x1p-52, 1 - 0x1p-53, 3.0,       0x1p-970};

double nasty_end(Random& random) {
  const double sign = random.below(2) ? 1 : -1;
  switch (random.below(4)) {
    case 0: return sign * special_ends[random.below(special_ends.size())];
    case 1: return sign * std::ldexp(1 + random.unit(), static_cast<int>(random.between(-1080, 1023)));
    case 2: return sign * static_cast<double>(random.below(5));
    default: return sign * std::ldexp(1 + random.unit(), static_cast<int>(random.between(-4, 4)));
  }
}

// An interval and a member of it, which need not be an end, nor a double.
struct Member {
  Interval interval;
  Exact value;
};

Member member(Random& random) {
  double low = nasty_end(random), high = random.below(3) == 0 ? low : nasty_end(random);
  if (random.below(4) == 0) high = std::nextafter(low, infinity);
  if (low > high) std::swap(low, high);
  if (!std::isfinite(high)) high = largest;
  const Interval interval(low, high);
  const Exact middle = (Exact(low) + Exact(high)) * Exact(0.5);
  switch (random.below(8)) {
    case 0: return {interval, Exact(low)};
    case 1: return {interval, Exact(high)};
    case 2: return {{-infinity, high}, random.below(2) ? Exact(high) - Exact(largest) * Exact(4) : Exact(low)};
    case 3: return {{low, infinity}, random.below(2) ? Exact(low) + Exact(largest) * Exact(1e300) : Exact(high)};
    default: return {interval, middle};
  }
}

Member combined(Random& random, const Member& a, const Member& b) {
  switch (random.below(3)) {
    case 0: return {a.interval + b.interval, a.value + b.value};
    case 1: return {a.interval - b.interval, a.value - b.value};
    default: return {a.interval * b.interval, a.value * b.value};
  }
}

bool same(const Interval& a, double low, double high) { return a.low == low && a.high == high; }

TEST(IntervalTest, ResultsEncloseExactOnes) {
  Random random(tests::chosen_seed(1));
  const int n = tests::scaled_count(60000, 1000);
  int sure = 0, infinite = 0, tiny = 0;
  for (int i = 0; i < n; ++i) {
    const Member a = member(random), b = member(random);
    const Member c = combined(random, a, b);
    ASSERT_TRUE(encloses(c.interval, c.value)) << "instance " << i << ": [" << a.interval.low << ", " << a.interval.high
                                               << "], [" << b.interval.low << ", " << b.interval.high << "]";
    const Guess guess = sign(c.interval);
    if (is_sure(guess)) {
      ASSERT_EQ(static_cast<int>(guess), c.value.n.sign()) << i;
      ++sure;
    }
    if (std::isinf(c.interval.low) || std::isinf(c.interval.high)) ++infinite;
    if (std::fabs(c.interval.low) < 0x1p-1020 && std::fabs(c.interval.high) < 0x1p-1020) ++tiny;
  }
  EXPECT_GT(sure, n / 4);
  EXPECT_GT(infinite, n / 10);
  EXPECT_GT(tiny, n / 50);
}

TEST(IntervalTest, LongExpressionsEncloseExactOnes) {
  Random random(tests::chosen_seed(2));
  const int n = tests::scaled_count(15000, 1000);
  int sure = 0, narrow = 0;
  for (int i = 0; i < n; ++i) {
    std::array<Member, 4> pool{member(random), member(random), member(random), member(random)};
    for (int step = 0; step < 4; ++step) {
      Member next = combined(random, pool[random.below(4)], pool[random.below(4)]);
      ASSERT_TRUE(encloses(next.interval, next.value)) << "instance " << i << ", step " << step;
      if (is_sure(sign(next.interval))) ++sure;
      if (std::isfinite(next.interval.high - next.interval.low)) ++narrow;
      pool[static_cast<std::size_t>(step)] = std::move(next);
    }
  }
  EXPECT_GT(sure, n / 2);
  EXPECT_GT(narrow, n);
}

TEST(IntervalTest, PointsWidenByAFewUnits) {
  Random random(tests::chosen_seed(3));
  const int n = tests::scaled_count(20000, 1000);
  for (int i = 0; i < n; ++i) {
    const double x = nasty_end(random), y = nasty_end(random);
    for (const auto& [r, exact] : {std::pair{Interval(x) + Interval(y), Exact(x) + Exact(y)},
                                   std::pair{Interval(x) - Interval(y), Exact(x) - Exact(y)},
                                   std::pair{Interval(x) * Interval(y), Exact(x) * Exact(y)}}) {
      ASSERT_TRUE(encloses(r, exact));
      if (!std::isfinite(r.low) || !std::isfinite(r.high)) continue;
      const double size = std::max(std::fabs(r.low), std::fabs(r.high));
      ASSERT_LE(r.high - r.low, size * 0x1p-50 + 4 * least) << x << " " << y;
    }
  }
}

TEST(IntervalTest, WidenedByOneUnitOrMore) {
  Random random(tests::chosen_seed(4));
  const int n = tests::scaled_count(50000, 1000);
  for (int i = 0; i < n; ++i) {
    const double x =
        i < static_cast<int>(special_ends.size()) ? special_ends[static_cast<std::size_t>(i)] : nasty_end(random);
    const Interval w = interval_detail::widened(x, x);
    ASSERT_LE(w.low, std::nextafter(x, -infinity)) << x;
    ASSERT_GE(w.high, std::nextafter(x, infinity)) << x;
  }
}

TEST(IntervalTest, ExactZeroStaysZero) {
  const Interval zero, wide(-3, 5), endless(-infinity, infinity);
  EXPECT_TRUE(same(zero * wide, 0, 0));
  EXPECT_TRUE(same(wide * zero, 0, 0));
  EXPECT_TRUE(same(zero * endless, 0, 0));
  EXPECT_TRUE(same(endless * Interval(-0.0), 0, 0));
  EXPECT_TRUE(same(wide + zero, -3, 5));
  EXPECT_TRUE(same(zero + wide, -3, 5));
  EXPECT_TRUE(same(wide - zero, -3, 5));
  EXPECT_TRUE(same(zero - wide, -5, 3));
  EXPECT_EQ(sign(zero * wide + zero * endless), Guess::zero);
  // A rounded zero is none.
  EXPECT_EQ(sign(Interval(3) - Interval(3)), Guess::unsure);
  EXPECT_EQ(sign(Interval(least) * Interval(least)), Guess::unsure);
}

// I1 for quotients: with an exact quotient at hand, which lies between those of the ends, no division is needed.
TEST(IntervalTest, QuotientsEncloseExactOnes) {
  Random random(tests::chosen_seed(6));
  const int n = tests::scaled_count(40000, 1000);
  const auto times = [](const Exact& x, const Exact& y) { return x * y; };
  int finite = 0, whole = 0, infinite = 0, tiny = 0, sure = 0;
  for (int i = 0; i < n; ++i) {
    const Member a = member(random), b = member(random);
    const Interval r = a.interval / b.interval;
    ASSERT_TRUE(r.low <= r.high && r.low < infinity && r.high > -infinity) << i;
    if (b.interval.low <= 0 && b.interval.high >= 0) {
      ASSERT_TRUE(same(r, -infinity, infinity)) << i;
      ++whole;
      continue;
    }
    // low <= a / b <= high, times |b|.
    const bool negative = b.value.n < 0;
    const Exact size = negative ? -b.value : b.value, value = negative ? -a.value : a.value;
    ASSERT_TRUE(std::isinf(r.low) || times(r.low, size) <= value) << i;
    ASSERT_TRUE(std::isinf(r.high) || value <= times(r.high, size)) << i;
    const Guess guess = sign(r);
    if (is_sure(guess)) {
      ASSERT_EQ(static_cast<int>(guess), value.n.sign()) << i;
      ++sure;
    }
    const bool is_finite = std::isfinite(r.low) && std::isfinite(r.high);
    ++(is_finite ? finite : infinite);
    tiny += std::fabs(r.low) < 0x1p-1020 && std::fabs(r.high) < 0x1p-1020;
    const bool points = a.interval.low == a.interval.high && b.interval.low == b.interval.high;
    if (points && is_finite) {
      const double largest_end = std::max(std::fabs(r.low), std::fabs(r.high));
      ASSERT_LE(r.high - r.low, largest_end * 0x1p-50 + 4 * least) << i;
    }
  }
  EXPECT_GT(finite, n / 10);
  EXPECT_GT(whole, n / 20);
  EXPECT_GT(infinite, n / 20);
  EXPECT_GT(tiny, n / 100);
  EXPECT_GT(sure, n / 10);
}

TEST(IntervalTest, QuotientsByHand) {
  const Interval third = Interval(1) / Interval(3), zero;
  EXPECT_LT(third.low, 1.0 / 3);
  EXPECT_GT(third.high, 1.0 / 3);
  EXPECT_TRUE(same(Interval(1) / Interval(-0.0), -infinity, infinity));
  EXPECT_TRUE(same(Interval(1) / Interval(0, 1), -infinity, infinity));
  EXPECT_TRUE(same(Interval(1) / Interval(-1, -0.0), -infinity, infinity));
  EXPECT_TRUE(same(zero / zero, -infinity, infinity));
  EXPECT_TRUE(same(zero / Interval(-2, -1), 0, 0));
  EXPECT_TRUE(same(Interval(1) / Interval(least), largest, infinity));
  EXPECT_TRUE(same(Interval(-1) / Interval(least), -infinity, -largest));
  EXPECT_EQ(sign(Interval(least) / Interval(largest)), Guess::unsure);
  const Interval beyond(largest, infinity);
  EXPECT_TRUE(same(beyond / beyond, -infinity, infinity));
  const Interval least_share = Interval(1) / beyond;
  EXPECT_LE(least_share.low, 0);
  EXPECT_GE(least_share.high, 0x1p-1024);
  EXPECT_LE((Interval(-6, 3) / Interval(-3, -1)).low, -3);
  EXPECT_GE((Interval(-6, 3) / Interval(-3, -1)).high, 6);
}

TEST(IntervalTest, Overflow) {
  const Interval sum = Interval(largest) + Interval(largest);
  EXPECT_TRUE(same(sum, largest, infinity));
  EXPECT_TRUE(same(-sum, -infinity, -largest));
  EXPECT_TRUE(same(Interval(largest) * Interval(-2), -infinity, -largest));
  EXPECT_EQ(sign(sum), Guess::positive);
  EXPECT_EQ(sign(sum * Interval(-1)), Guess::negative);
  EXPECT_EQ(sign(sum - Interval(largest)), Guess::unsure);
  EXPECT_EQ(sign(sum - sum), Guess::unsure);
  EXPECT_TRUE(encloses(sum - Interval(largest), Exact(largest)));
  EXPECT_TRUE(same(Interval(-infinity, 1) * Interval(0, 1), -infinity, infinity));
  EXPECT_TRUE(same(Interval(-infinity, infinity) * Interval(-infinity, infinity), -infinity, infinity));
}

TEST(IntervalTest, Sign) {
  EXPECT_EQ(sign(Interval(least, 1)), Guess::positive);
  EXPECT_EQ(sign(Interval(-1, -least)), Guess::negative);
  EXPECT_EQ(sign(Interval(0, 0)), Guess::zero);
  EXPECT_EQ(sign(Interval(-0.0, 0)), Guess::zero);
  EXPECT_EQ(sign(Interval(0, least)), Guess::unsure);
  EXPECT_EQ(sign(Interval(-least, 0)), Guess::unsure);
  EXPECT_EQ(sign(Interval(-1, 1)), Guess::unsure);
  EXPECT_EQ(sign(Interval(-infinity, infinity)), Guess::unsure);
}

}  // namespace
}  // namespace sunder
