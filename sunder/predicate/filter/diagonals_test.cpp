#include <sunder/base/random.h>
#include <sunder/number/dyadic.h>
#include <sunder/predicate/filter/diagonals.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sunder {
namespace {

// What is said to be apart is so in exact numbers, also where sums overflow or lose their last bits.
TEST(DiagonalExtents, ApartIsExact) {
  Random random(20261128);
  int apart = 0, missed = 0;
  for (int k = 0; k < 20000; ++k) {
    const int scale = k % 3 == 0 ? 1023 : k % 3 == 1 ? 0 : -1070;
    const auto some = [&] {
      const double x = std::ldexp(1 + random.unit() * 0x1p-50, scale), y = static_cast<double>(random.between(-1, 1));
      return random.below(2) == 0 ? x : random.below(2) == 0 ? std::ldexp(y, scale) : std::nextafter(-x, y);
    };
    std::vector<Point2> a(1 + random.below(2)), b(1 + random.below(2));
    DiagonalExtents of_a, of_b;
    for (auto* set : {&a, &b}) {
      for (Point2& p : *set) {
        p.x = some();
        p.y = some();
        (set == &a ? of_a : of_b).include(p);
      }
    }
    const auto all_beyond = [](const std::vector<Point2>& p, const std::vector<Point2>& q, double along_y) {
      for (const Point2& s : p) {
        for (const Point2& t : q) {
          const Dyadic d =
              (Dyadic(t.x) + Dyadic(along_y) * Dyadic(t.y)) - (Dyadic(s.x) + Dyadic(along_y) * Dyadic(s.y));
          if (d.sign() != Sign::positive) return false;
        }
      }
      return true;
    };
    const bool truly = all_beyond(a, b, 1) || all_beyond(b, a, 1) || all_beyond(a, b, -1) || all_beyond(b, a, -1);
    apart += surely_apart(of_a, of_b);
    missed += truly && !surely_apart(of_a, of_b);
    ASSERT_TRUE(truly || !surely_apart(of_a, of_b)) << k;
  }
  EXPECT_GT(apart, 5000);
  EXPECT_GT(missed, 100);
}

}  // namespace
}  // namespace sunder
