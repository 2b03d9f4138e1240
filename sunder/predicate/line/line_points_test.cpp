// Against the exact coordinates of the points, by fractions.
#include <sunder/base/random.h>
#include <sunder/predicate/line/line_points.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace sunder {
namespace {

class LinePointSource {
 public:
  explicit LinePointSource(std::uint64_t seed) : random(seed) {}

  double number(int kind) {
    switch (kind) {
      case 0: return static_cast<double>(random.between(-3, 3));
      case 1: return random.uniform(-1, 1);
      default: return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.between(-1060, 1020)));
    }
  }
  Point2 point(int kind) { return {number(kind), number(kind)}; }

  LinePoint line_point_of(int kind) {
    if (random.below(4) == 0) return line_point(point(kind));
    for (;;) {
      const Crossing c{point(kind), point(kind), point(kind), point(kind)};
      if (cross_2d(c.a, c.b, c.c, c.d) != Sign::zero) return line_point(c);
    }
  }

  Random random;
};

TEST(LinePointsTest, AgainstFractions) {
  LinePointSource source(11);
  std::array<std::array<int, 3>, 3> signs{};
  StageTally tally;
  for (int i = 0; i < 9000; ++i) {
    const int kind = i % 3;
    const LinePoint p = source.line_point_of(kind), q = source.random.below(8) == 0 ? p : source.line_point_of(kind),
                    r = source.line_point_of(kind);
    const ExactPoint2 a = exact_point(p), b = exact_point(q), c = exact_point(r);
    const auto note = [&](std::size_t what, Sign sign) {
      ++signs[what][static_cast<std::size_t>(static_cast<std::int8_t>(sign) + 1)];
    };
    const Sign by_x = (a.x * b.denominator - b.x * a.denominator).sign();
    ASSERT_EQ(compare_x(p, q, &tally), by_x) << i;
    note(0, by_x);

    // Differences over products of denominators, which are positive.
    const auto from_a = [&](const ExactPoint2& t) {
      return std::array{t.x * a.denominator - a.x * t.denominator, t.y * a.denominator - a.y * t.denominator};
    };
    const auto u = from_a(b), v = from_a(c);
    const Sign turn = (u[0] * v[1] - u[1] * v[0]).sign();
    ASSERT_EQ(orient_2d(p, q, r, &tally), turn) << i;
    note(1, turn);

    const Point2 s = source.point(kind), t = source.point(kind);
    const Sign side = ((Dyadic(t.x) - Dyadic(s.x)) * (a.y - Dyadic(s.y) * a.denominator) -
                       (Dyadic(t.y) - Dyadic(s.y)) * (a.x - Dyadic(s.x) * a.denominator))
                          .sign();
    ASSERT_EQ(orient_2d(s, t, p, &tally), side) << i;
    note(2, side);

    const Point2 low = source.point(kind), high = source.point(kind);
    const Enclosure2 box{{std::min(low.x, high.x), std::max(low.x, high.x)},
                         {std::min(low.y, high.y), std::max(low.y, high.y)}};
    if (!is_surely_left(s, t, box)) continue;
    for (const Point2 corner :
         {Point2{box.x.low, box.y.low}, {box.x.high, box.y.low}, {box.x.low, box.y.high}, {box.x.high, box.y.high}}) {
      ASSERT_EQ(orient_2d(s, t, line_point(corner)), Sign::positive) << i;
    }
  }
  for (const auto& of : signs) {
    for (const int n : of) EXPECT_GT(n, 200);
  }
  EXPECT_GT(tally.interval, 3000u);
  EXPECT_GT(tally.exact, 1000u);
}

TEST(LinePointsTest, SurelyLeft) {
  const Enclosure2 box{{0, 1}, {0, 1}};
  EXPECT_TRUE(is_surely_left({-1, -1}, {2, -0.5}, box));
  EXPECT_FALSE(is_surely_left({-1, -1}, {2, 0.5}, box));
  EXPECT_FALSE(is_surely_left({2, -0.5}, {-1, -1}, box));
  EXPECT_TRUE(is_surely_left({1.5, -1}, {1.25, 2}, box));
  EXPECT_TRUE(is_surely_left({0, 3}, {-1, 0}, box));
  EXPECT_FALSE(is_surely_left({0, 2}, {-1, 0.5}, {{-1, 1}, {0, 1}}));
  EXPECT_FALSE(is_surely_left({0, 0}, {0, 0}, box));
}

TEST(LinePointsTest, Contradictions) {
  const LeftOfMoved up{{0, 1}, {0, 0}, {1, 0}}, down{{0, 0}, {1, 0}, {0, 0}}, lower_up{{0, 0}, {0, 0}, {1, 0}};
  EXPECT_TRUE(have_no_common_point(std::array{up, down}));
  EXPECT_FALSE(have_no_common_point(std::array{lower_up, down}));  // a line
  EXPECT_FALSE(have_no_common_point(std::array{up, up}));
  EXPECT_FALSE(have_no_common_point(std::array{up}));
  // Left of three arrows around a triangle, turned either way; through one point; one unit apart.
  const LeftOfMoved a{{0, 0}, {0, 0}, {1, 0}}, b{{1, 0}, {0, 0}, {-1, 1}}, c{{0, 0}, {0, 0}, {-1, -3}};
  const auto turned = [](const LeftOfMoved& h) { return LeftOfMoved{h.at, h.to, h.from}; };
  EXPECT_FALSE(have_no_common_point(std::array{a, b, c}));
  EXPECT_TRUE(have_no_common_point(std::array{turned(a), turned(b), turned(c)}));
  EXPECT_TRUE(have_no_common_point(std::array{turned(b), turned(a), turned(c)}));
  EXPECT_FALSE(have_no_common_point(std::array{turned(a), b, c}));
  LeftOfMoved through = turned(b);
  through.at = {0, 0};
  EXPECT_FALSE(have_no_common_point(std::array{turned(a), through, turned(c)}));
  through.at = {5e-324, 0};
  EXPECT_TRUE(have_no_common_point(std::array{turned(a), through, turned(c)}));
}

}  // namespace
}  // namespace sunder
