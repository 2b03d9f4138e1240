#include <sunder/base/random.h>
#include <sunder/number/dyadic.h>
#include <sunder/number/rational_test.h>

#include <tests/support/doubles.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <set>
#include <string>

namespace sunder {
namespace {

using tests::infinity, tests::largest, tests::least;

constexpr std::array special_doubles{0.0,    -0.0,  1.0,     least,   2 * least,   0x1p-1022,   0x1.fffffffffffffp-1023,
                                     1e-300, 1e300, 0x1p511, largest, 1 + 0x1p-52, 1 - 0x1p-53, 0x1p53};

double nasty_double(Random& random) {
  const double sign = random.below(2) ? 1 : -1;
  switch (random.below(4)) {
    case 0: return sign * special_doubles[random.below(special_doubles.size())];
    case 1: return sign * std::ldexp(1 + random.unit(), static_cast<int>(random.between(-1080, 1023)));
    case 2: return sign * static_cast<double>(random.below(100));
    default: return sign * std::ldexp(1 + random.unit(), static_cast<int>(random.between(-60, 60)));
  }
}

// A number that is seldom a double: a sum, a product, halfway between two doubles, or nearly so.
Dyadic some_dyadic(Random& random) {
  const double x = nasty_double(random), y = nasty_double(random);
  switch (random.below(5)) {
    case 0: return Dyadic(x) + Dyadic(y);
    case 1: return Dyadic(x) * Dyadic(y);
    case 2: return Dyadic(x) * Dyadic(y) - Dyadic(y) * Dyadic(nasty_double(random));
    default: break;
  }
  const double next = std::nextafter(x, infinity);
  if (std::isinf(next)) return Dyadic(x);
  const Dyadic halfway = (Dyadic(x) + Dyadic(next)) * Dyadic(0.5);
  const Dyadic tiny = dyadic_of(Integer(random.between(-1, 1)), random.between(-2500, -1500));
  return halfway + tiny * Dyadic(x);
}

// The nearest double, found by looking at neighbours: is it `x`?
void expect_nearest(const Rational& r, double x) {
  const Rational end = rational(1, 1024) - rational(1, 970);  // halfway from the largest double to 2^1024
  if (abs(r) >= end) {
    ASSERT_EQ(x, r > 0 ? infinity : -infinity);
    return;
  }
  ASSERT_TRUE(std::isfinite(x));
  const Rational error = abs(r - rational(x));
  int e = 0;
  const double m = std::frexp(x, &e);
  const int bits = std::min(53, e + 1074);  // those of the mantissa; fewer for a subnormal number
  const bool even = x == 0 || std::fmod(std::ldexp(m, bits), 2) == 0;
  for (const double towards : {infinity, -infinity}) {
    const double next = std::nextafter(x, towards);
    if (std::isinf(next)) continue;
    const Rational other = abs(r - rational(next));
    ASSERT_TRUE(error < other || (error == other && even)) << x;
  }
}

TEST(DyadicTest, DoublesAreExact) {
  Random random(tests::chosen_seed(1));
  const int n = tests::scaled_count(20000, 1000);
  for (int i = 0; i < n; ++i) {
    const double x = i < static_cast<int>(special_doubles.size()) ? special_doubles[static_cast<std::size_t>(i)]
                                                                  : nasty_double(random);
    const Dyadic d(x);
    ASSERT_EQ(rational(d), rational(x)) << x;
    ASSERT_TRUE(mantissa_of(d) == 0 || (mantissa_of(d) & 1) == 1);
    ASSERT_EQ(static_cast<int>(d.sign()), (x > 0) - (x < 0));
    ASSERT_EQ(d.nearest(), x);
    ASSERT_EQ(d.enclosure().low, x);
    ASSERT_EQ(d.enclosure().high, x);
  }
  EXPECT_EQ(Dyadic().sign(), Sign::zero);
  EXPECT_EQ(Dyadic(-0.0).sign(), Sign::zero);
}

TEST(DyadicTest, ArithmeticIsExact) {
  Random random(tests::chosen_seed(2));
  const int n = tests::scaled_count(1500, 1000);
  int zeros = 0;
  for (int i = 0; i < n; ++i) {
    const Dyadic a = some_dyadic(random), b = random.below(8) == 0 ? a : some_dyadic(random);
    const Rational x = rational(a), y = rational(b);
    ASSERT_EQ(rational(a + b), x + y) << i;
    ASSERT_EQ(rational(a - b), x - y) << i;
    ASSERT_EQ(rational(a * b), x * y) << i;
    ASSERT_EQ(rational(-a), -x) << i;
    ASSERT_EQ(a == b, x == y) << i;
    ASSERT_EQ(static_cast<int>((a - b).sign()), (x - y).sign()) << i;
    ASSERT_EQ(static_cast<int>(sign(a - b)), (x - y).sign()) << i;
    if (x == y) ++zeros;
  }
  EXPECT_GT(zeros, n / 20);
  EXPECT_EQ(dyadic_of(Integer(4), 0), dyadic_of(Integer(1), 2));  // one number in two forms
}

TEST(DyadicTest, NearestAndEnclosure) {
  Random random(tests::chosen_seed(3));
  const int n = tests::scaled_count(3000, 1000);
  int points = 0, infinite = 0, subnormal = 0, ties = 0;
  for (int i = 0; i < n; ++i) {
    const Dyadic d = some_dyadic(random);
    const Rational r = rational(d);
    const double x = d.nearest();
    expect_nearest(r, x);
    if (HasFatalFailure()) FAIL() << "instance " << i << ": " << d.hexadecimal();
    const Interval e = d.enclosure();
    if (e.low == e.high) {
      ASSERT_EQ(rational(e.low), r);
      ++points;
      continue;
    }
    ASSERT_EQ(std::nextafter(e.low, infinity), e.high) << i;
    ASSERT_TRUE(e.low == -infinity || rational(e.low) < r) << i;
    ASSERT_TRUE(e.high == infinity || r < rational(e.high)) << i;
    ASSERT_TRUE(x == e.low || x == e.high) << i;
    if (!std::isfinite(e.low) || !std::isfinite(e.high)) {
      ++infinite;
    } else if (r - rational(e.low) == rational(e.high) - r) {
      ++ties;
    }
    if (x != 0 && std::fabs(x) < 0x1p-1022) ++subnormal;
  }
  EXPECT_GT(points, n / 20);
  EXPECT_GT(infinite, n / 100);
  EXPECT_GT(subnormal, n / 100);
  EXPECT_GT(ties, n / 20);
}

TEST(DyadicTest, NearestAtTheEndsOfTheRange) {
  const Dyadic end = dyadic_of(Integer(1), 1024) - dyadic_of(Integer(1), 970);  // halfway from `largest` to 2^1024
  const Dyadic tiny = dyadic_of(Integer(1), -5000);
  EXPECT_EQ(end.nearest(), infinity);
  EXPECT_EQ((-end).nearest(), -infinity);
  EXPECT_EQ((end - tiny).nearest(), largest);
  EXPECT_EQ((tiny - end).nearest(), -largest);
  EXPECT_EQ(dyadic_of(Integer(1), 1024).nearest(), infinity);
  EXPECT_EQ(dyadic_of(Integer(1), 1000000).nearest(), infinity);
  EXPECT_EQ(dyadic_of(Integer(-3), 100000).enclosure().low, -infinity);
  EXPECT_EQ(dyadic_of(Integer(-3), 100000).enclosure().high, -largest);
  EXPECT_EQ(dyadic_of(Integer(1), 1024).enclosure().low, largest);
  EXPECT_EQ(end.enclosure().low, largest);
  EXPECT_EQ(end.enclosure().high, infinity);

  EXPECT_EQ(dyadic_of(Integer(1), -1075).nearest(), 0);  // a tie, to even
  EXPECT_EQ(dyadic_of(Integer(3), -1075).nearest(), 2 * least);
  EXPECT_EQ(dyadic_of(Integer(5), -1076).nearest(), least);
  EXPECT_EQ((dyadic_of(Integer(1), -1075) + tiny).nearest(), least);
  EXPECT_EQ((dyadic_of(Integer(-1), -1075) - tiny).nearest(), -least);
  EXPECT_EQ(tiny.nearest(), 0);
  EXPECT_EQ(tiny.enclosure().low, 0);
  EXPECT_EQ(tiny.enclosure().high, least);
  EXPECT_EQ((-tiny).enclosure().low, -least);
  EXPECT_EQ((-tiny).enclosure().high, 0);
  EXPECT_EQ(sign(tiny.enclosure()), Guess::unsure);
  // Rounded up over a power of two, to the first normal number, to a number with 54 bits.
  EXPECT_EQ((Dyadic(1.0) - Dyadic(0x1p-60)).nearest(), 1);
  EXPECT_EQ((Dyadic(0x1p-1022) - dyadic_of(Integer(1), -1076)).nearest(), 0x1p-1022);
  EXPECT_EQ((Dyadic(0x1p53) + Dyadic(1.0)).nearest(), 0x1p53);
  EXPECT_EQ((Dyadic(0x1p53) + Dyadic(3.0)).nearest(), 0x1p53 + 4);
}

TEST(DyadicTest, NearestRatio) {
  Random random(tests::chosen_seed(6));
  const int n = tests::scaled_count(1000, 1000);
  int infinite = 0, subnormal = 0, zero = 0, ties = 0;
  for (int i = 0; i < n; ++i) {
    Dyadic b = some_dyadic(random);
    if (b.sign() == Sign::zero) b = Dyadic(-7.0);
    // Any quotient; or one that is given: a double, halfway between two, or nearly so.
    const bool given = random.below(2) == 0;
    const Dyadic quotient = some_dyadic(random);
    const Dyadic a = given ? quotient * b : quotient;
    const double x = nearest_ratio(a, b);
    const Rational r = rational(a) / rational(b);
    expect_nearest(r, x);
    if (HasFatalFailure()) FAIL() << "instance " << i << ": " << fraction_text(a, b);
    ASSERT_EQ(nearest_ratio(-a, b), -x) << i;
    ASSERT_EQ(nearest_ratio(a, -b), -x) << i;
    infinite += std::isinf(x);
    subnormal += x != 0 && std::fabs(x) < 0x1p-1022;
    zero += x == 0;
    if (!given || !std::isfinite(x) || r == rational(x)) continue;
    const double next = std::nextafter(x, r > rational(x) ? infinity : -infinity);
    if (std::isfinite(next)) ties += abs(r - rational(x)) == abs(r - rational(next));
  }
  EXPECT_GT(infinite, n / 50);
  EXPECT_GT(subnormal, n / 100);
  EXPECT_GT(zero, n / 50);
  EXPECT_GT(ties, n / 20);
}

TEST(DyadicTest, NearestRatioByHand) {
  const auto ratio = [](double n, double d) { return nearest_ratio(Dyadic(n), Dyadic(d)); };
  EXPECT_EQ(ratio(1, 3), 1.0 / 3);  // the machine divides correctly rounded
  EXPECT_EQ(ratio(-2, 3), -2.0 / 3);
  EXPECT_EQ(ratio(0, -3), 0);
  EXPECT_EQ(ratio(6, -3), -2);
  EXPECT_EQ(ratio(largest, 0.5), infinity);
  EXPECT_EQ(ratio(-largest, least), -infinity);
  EXPECT_EQ(ratio(least, 2), 0);  // a tie, to even
  EXPECT_EQ(ratio(3 * least, 2), 2 * least);
  EXPECT_EQ(ratio(least, 1 + 0x1p-52), least);
  EXPECT_EQ(ratio(least, -largest), 0);
  EXPECT_EQ(ratio(0x1p-1022, 3), 0x1p-1022 / 3);
  // One part in 2^1000 off a tie: the rest counts, however small it is.
  const Dyadic tie = Dyadic(1.0) + Dyadic(0x1p-53), odd_tie = Dyadic(1.0) + Dyadic(3 * 0x1p-53), tiny(0x1p-1000),
               seven(7.0);
  EXPECT_EQ(nearest_ratio(tie * seven, seven), 1);
  EXPECT_EQ(nearest_ratio(odd_tie * seven, seven), 1 + 0x1p-51);
  EXPECT_EQ(nearest_ratio(tie * seven + tiny, seven), 1 + 0x1p-52);
  EXPECT_EQ(nearest_ratio(odd_tie * seven - tiny, seven), 1 + 0x1p-52);
  EXPECT_EQ(nearest_ratio(-tie * seven - tiny, seven), -1 - 0x1p-52);
}

TEST(DyadicTest, HexadecimalOfKnownNumbers) {
  EXPECT_EQ(Dyadic().hexadecimal(), "0x0p+0");
  EXPECT_EQ(Dyadic(-0.0).hexadecimal(), "0x0p+0");
  EXPECT_EQ(Dyadic(1.0).hexadecimal(), "0x1p+0");
  EXPECT_EQ(Dyadic(-3.0).hexadecimal(), "-0x3p+0");
  EXPECT_EQ(Dyadic(160.0).hexadecimal(), "0x5p+5");
  EXPECT_EQ(Dyadic(-0.75).hexadecimal(), "-0x3p-2");
  EXPECT_EQ(Dyadic(least).hexadecimal(), "0x1p-1074");
  EXPECT_EQ(Dyadic(largest).hexadecimal(), "0x1fffffffffffffp+971");
  EXPECT_EQ(dyadic_of(Integer("0xabcdef0123456789abcdef0123456789"), -8).hexadecimal(),
            "0xabcdef0123456789abcdef0123456789p-8");
  EXPECT_EQ(dyadic_of(Integer(48), -4).hexadecimal(), "0x3p+0");
}

TEST(DyadicTest, HexadecimalReadsBack) {
  const std::regex form("(-?)0x([0-9a-f]+)p([+-][0-9]+)");
  Random random(tests::chosen_seed(4));
  const int n = tests::scaled_count(2000, 1000);
  std::set<std::size_t> lengths;
  for (int i = 0; i < n; ++i) {
    const Dyadic d = some_dyadic(random);
    const std::string text = d.hexadecimal();
    std::smatch parts;
    ASSERT_TRUE(std::regex_match(text, parts, form)) << text;
    tests::Integer mantissa = 0;
    for (const char c : parts[2].str()) mantissa = mantissa * 16 + (c <= '9' ? c - '0' : c - 'a' + 10);
    if (parts[1].length() != 0) mantissa = -mantissa;
    ASSERT_EQ(rational(mantissa, std::stoll(parts[3].str())), rational(d)) << text;
    ASSERT_EQ(std::strtod(text.c_str(), nullptr), d.nearest()) << text;  // the C library rounds correctly too
    lengths.insert(text.size());
  }
  EXPECT_GT(lengths.size(), 20u);
}

boost::multiprecision::cpp_rational lowest_terms(const Dyadic& x) {
  const boost::multiprecision::cpp_int n(mantissa_of(x).str()), power = 1;
  const auto e = static_cast<unsigned>(std::abs(x.exponent()));
  return x.exponent() < 0 ? boost::multiprecision::cpp_rational(n, power << e)
                          : boost::multiprecision::cpp_rational(n << e);
}

TEST(DyadicTest, FractionText) {
  const auto text = [](double n, double d) { return fraction_text(Dyadic(n), Dyadic(d)); };
  EXPECT_EQ(text(0, 5), "0");
  EXPECT_EQ(text(-0.0, -5), "0");
  EXPECT_EQ(text(6, 3), "2");
  EXPECT_EQ(text(6, -4), "-3/2");
  EXPECT_EQ(text(-6, -4), "3/2");
  EXPECT_EQ(text(-1, 3), "-1/3");
  EXPECT_EQ(text(0.5, 3), "1/6");
  EXPECT_EQ(text(3, 0.25), "12");
  EXPECT_EQ(text(0.75, 0.375), "2");
  Random random(tests::chosen_seed(5));
  const int n = tests::scaled_count(2000, 1000);
  int wholes = 0;
  for (int i = 0; i < n; ++i) {
    const bool small = random.below(2) == 0;
    const Dyadic a = small ? dyadic_of(Integer(random.between(-50, 50)), random.between(-3, 3)) : some_dyadic(random);
    Dyadic b = small ? dyadic_of(Integer(random.between(-9, 9)), random.between(-3, 3)) : some_dyadic(random);
    if (b.sign() == Sign::zero) b = Dyadic(-7.0);
    const auto r = lowest_terms(a) / lowest_terms(b);
    const std::string expected =
        denominator(r) == 1 ? numerator(r).str() : numerator(r).str() + "/" + denominator(r).str();
    ASSERT_EQ(fraction_text(a, b), expected) << i;
    if (denominator(r) == 1) ++wholes;
  }
  EXPECT_GT(wholes, n / 20);
}

#ifdef SUNDER_CONTRACTS
TEST(DyadicTest, NothingIsDividedByZero) {
  EXPECT_DEATH(nearest_ratio(Dyadic(1.0), Dyadic(0.0)), "dyadic.cpp:[0-9]+: requires denominator");
  EXPECT_DEATH(fraction_text(Dyadic(1.0), Dyadic(0.0)), "dyadic.cpp:[0-9]+: requires denominator");
}
#endif

}  // namespace
}  // namespace sunder
