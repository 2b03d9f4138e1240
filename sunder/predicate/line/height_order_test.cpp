// The order of heights against integer arithmetic, and which stage decides.
#include <sunder/base/random.h>
#include <sunder/predicate/line/height_order.h>
#include <sunder/predicate/multiples_test.h>

#include <tests/support/doubles.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sunder {
namespace {

using tests::largest, tests::least, tests::Whole;

// The oracle: all numbers as multiples of 2^-1126, each height as a fraction.
Sign order_by_integers(const Point2& a, const Point2& b, const Point2& c, const Point2& d, double x) {
  const auto numerator = [&](const Point2& p, const Point2& q) -> Whole {
    return multiple(p.y) * (multiple(q.x) - multiple(x)) + multiple(q.y) * (multiple(x) - multiple(p.x));
  };
  const Whole left = numerator(a, b) * (multiple(d.x) - multiple(c.x)),
              right = numerator(c, d) * (multiple(b.x) - multiple(a.x));
  return left > right ? Sign::positive : left < right ? Sign::negative : Sign::zero;
}

class Lines {
 public:
  StageTally tally;
  int zeros = 0;

  void compare(Point2 a, Point2 b, Point2 c, Point2 d, double x) {
    if (a.x > b.x) std::swap(a, b);
    if (c.x > d.x) std::swap(c, d);
    if (a.x == b.x || c.x == d.x) return;
    const Sign truth = order_by_integers(a, b, c, d, x);
    ASSERT_EQ(height_order(a, b, c, d, x, &tally), truth) << a.x << ' ' << a.y << ' ' << b.x << ' ' << b.y << ' ' << c.x
                                                          << ' ' << c.y << ' ' << d.x << ' ' << d.y << " at " << x;
    ASSERT_EQ(height_order(c, d, a, b, x), -truth);
    ASSERT_EQ(height_order_further(a, b, c, d, x, nullptr), truth);
    zeros += truth == Sign::zero;
  }
};

TEST(HeightOrderTest, Examples) {
  EXPECT_EQ(height_order({0, 0}, {4, 4}, {0, 4}, {4, 0}, 1), Sign::negative);
  EXPECT_EQ(height_order({0, 0}, {4, 4}, {0, 4}, {4, 0}, 2), Sign::zero);
  EXPECT_EQ(height_order({0, 0}, {4, 4}, {0, 4}, {4, 0}, 3), Sign::positive);
  EXPECT_EQ(height_order({0, 0}, {1, 0}, {5, least}, {6, least}, 9), Sign::negative);
}

TEST(HeightOrderTest, AgreesWithIntegers) {
  Random random(tests::chosen_seed(20261124));
  Lines small, close, wild;
  const auto integer = [&] { return static_cast<double>(random.between(-4, 4)); };
  const auto unit = [&] { return random.uniform(-1, 1); };
  const auto any = [&] {
    const double sign = random.below(2) == 0 ? 1 : -1;
    switch (random.below(6)) {
      case 0: return sign * least * static_cast<double>(random.below(9));
      case 1: return sign * largest;
      case 2: return sign * random.log_uniform(1e-160, 1e-100);
      case 3: return sign * random.log_uniform(1e100, 1e160);
      case 4: return sign * random.log_uniform(1e-307, 1e307);
      default: return integer();
    }
  };
  for (int i = 0; i < tests::scaled_count(20000, 1000); ++i) {
    small.compare({integer(), integer()}, {integer(), integer()}, {integer(), integer()}, {integer(), integer()},
                  integer());
    wild.compare({any(), any()}, {any(), any()}, {any(), any()}, {any(), any()}, any());
    // At, or next to, where they cross.
    const Point2 a{unit(), unit()}, b{unit(), unit()}, c{unit(), unit()}, d{unit(), unit()};
    const double m = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
    const double x = a.x + (b.x - a.x) * (((c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x)) / m);
    if (!std::isfinite(x)) continue;
    for (const double at : {x, std::nextafter(x, 2.0), x + random.log_uniform(1e-18, 1e-12)}) {
      close.compare(a, b, c, d, at);
    }
    close.compare(a, b, a, d, a.x);
  }
  if (tests::scaled_count(20000, 1000) < 20000) return;  // too few for the rates below
  EXPECT_GT(small.zeros, 300);
  EXPECT_GT(small.tally.rounded, 0u);
  for (const Lines* lines : {&small, &close, &wild}) {
    const StageTally& t = lines->tally;
    std::printf("rounded %u interval %u exact %u, zero %d\n", t.rounded, t.interval, t.exact, lines->zeros);
    EXPECT_GT(t.rounded, 100u);
    EXPECT_GT(t.exact, 100u);
  }
  EXPECT_GT(wild.tally.interval, 100u);
}

}  // namespace
}  // namespace sunder
