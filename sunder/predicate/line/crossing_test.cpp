// Where two segments cross, against whole numbers: every double is one, times 2^-1074.
#include <sunder/base/random.h>
#include <sunder/number/integer_internal.h>
#include <sunder/predicate/line/crossing.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace sunder {
namespace {

using Whole = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

Whole whole(double x) {
  int e = 0;
  const double m = std::frexp(x, &e);
  const Whole n = static_cast<std::int64_t>(std::ldexp(m, 53));
  const int shift = e - 53 + 1074;  // below zero for subnormal numbers, whose last bits are zero then
  return shift < 0 ? n >> static_cast<unsigned>(-shift) : n << static_cast<unsigned>(shift);
}

// The oracle's points and lines: three homogeneous coordinates.
using Triple = std::array<Whole, 3>;
Triple triple(const Point2& p) { return {whole(p.x), whole(p.y), 1}; }
Triple cross(const Triple& u, const Triple& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
Whole dot(const Triple& u, const Triple& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

// The common point of two lines, the third coordinate positive; nothing for parallel ones.
std::optional<Triple> common(const Crossing& c) {
  Triple p = cross(cross(triple(c.a), triple(c.b)), cross(triple(c.c), triple(c.d)));
  if (p[2] == 0) return std::nullopt;
  if (p[2] < 0) p = {-p[0], -p[1], -p[2]};
  return p;
}
Sign order(const Triple& p, const Triple& q) {
  const Whole by_x = p[0] * q[2] - q[0] * p[2], by_y = p[1] * q[2] - q[1] * p[2];
  return static_cast<Sign>((by_x != 0 ? by_x : by_y).sign());
}
Sign turn_to_crossing(const Point2& s, const Point2& t, const Triple& p) {
  return static_cast<Sign>(dot(cross(triple(s), triple(t)), p).sign());
}

bool holds(const Interval& i, const Whole& n, const Whole& d) {
  return (std::isinf(i.low) || whole(i.low) * d <= n) && (std::isinf(i.high) || n <= whole(i.high) * d) &&
         i.low <= i.high && i.low < HUGE_VAL && i.high > -HUGE_VAL;
}
// x / denominator = n / (d 2^1074)?
bool equal(const Dyadic& x, const Dyadic& denominator, const Whole& n, const Whole& d) {
  const std::int64_t shift = x.exponent() - denominator.exponent() + 1074;
  Whole left = Whole(mantissa_of(x)) * d, right = n * Whole(mantissa_of(denominator));
  (shift > 0 ? left : right) <<= static_cast<unsigned>(std::abs(shift));
  return left == right;
}

enum CrossingKind { small_grid, generic_crossing, any_size, nearly_parallel, one_place, crossing_kinds };

class CrossingSource {
 public:
  explicit CrossingSource(std::uint64_t seed) : random(seed) {}

  double number(CrossingKind kind) {
    switch (kind) {
      case small_grid: return static_cast<double>(random.between(-3, 3));
      case any_size: return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.between(-1074, 1023)));
      default: return random.uniform(-1, 1);
    }
  }
  Point2 point(CrossingKind kind) { return {number(kind), number(kind)}; }

  Crossing crossing(CrossingKind kind) {
    Crossing c{point(kind), point(kind), point(kind), point(kind)};
    const auto near = [&](double x) { return x + static_cast<double>(random.between(-2, 2)) * 0x1p-52; };
    if (kind == nearly_parallel) {
      c.c = {near(c.a.x), near(c.a.y)};
      c.d = {near(c.b.x), near(c.b.y)};
    }
    if (kind == one_place) {  // exactly through (1/4, 1/2), or one unit beside it
      const double u = std::ldexp(static_cast<double>(random.between(-512, 512)), -10), v = u / 4;
      const Point2 m{0.25, random.below(4) == 0 ? near(0.5) : 0.5};
      c = {{m.x - u, m.y - v}, {m.x + u, m.y + v}, {m.x - v, m.y + u}, {m.x + v, m.y - u}};
    }
    return c;
  }

  Random random;
};

struct CrossingCount {
  int all = 0, interval = 0, exact = 0, zero = 0;
  void add(const StageTally& tally, Sign sign) {
    EXPECT_EQ(tally.rounded, 0u);
    EXPECT_EQ(tally.interval + tally.exact, 1u);
    ++all;
    interval += static_cast<int>(tally.interval);
    exact += static_cast<int>(tally.exact);
    zero += sign == Sign::zero;
  }
};

TEST(CrossingTest, AgainstWholeNumbers) {
  CrossingSource source(41);
  std::map<CrossingKind, CrossingCount> with_crossing, with_point, side;
  const int count = tests::scaled_count(6000, 1000);
  for (int i = 0; i < count; ++i) {
    const CrossingKind kind = static_cast<CrossingKind>(i % crossing_kinds);
    const Crossing c = source.crossing(kind), d = source.crossing(kind);
    const auto p = common(c), q = common(d);
    if (!p || !q) continue;
    const ExactPoint2 exact = exact_point(c);
    ASSERT_EQ(exact.denominator.sign(), Sign::positive) << i;
    ASSERT_TRUE(equal(exact.x, exact.denominator, (*p)[0], (*p)[2])) << i;
    ASSERT_TRUE(equal(exact.y, exact.denominator, (*p)[1], (*p)[2])) << i;
    const Enclosure2 in = enclosure(c), other_in = enclosure(d);
    ASSERT_TRUE(holds(in.x, (*p)[0], (*p)[2]) && holds(in.y, (*p)[1], (*p)[2])) << i;

    StageTally tally;
    const Sign by_crossing = order(*p, *q);
    ASSERT_EQ(compare(c, in, d, other_in, &tally), by_crossing) << i;
    ASSERT_EQ(compare(d, other_in, c, in), -by_crossing) << i;
    with_crossing[kind].add(tally, by_crossing);

    // A point of its own, or the double nearest to the crossing, or that with another y.
    Point2 r = source.point(kind);
    if (i % 2 == 0) r.x = nearest_ratio(exact.x, exact.denominator);
    if (i % 4 == 0) r.y = nearest_ratio(exact.y, exact.denominator);
    if (std::isinf(r.x) || std::isinf(r.y)) continue;
    tally = {};
    const Sign by_point = order(*p, triple(r));
    ASSERT_EQ(compare(c, in, r, &tally), by_point) << i;
    with_point[kind].add(tally, by_point);

    const Point2 s = i % 3 == 0 ? d.a : r, t = source.point(kind);
    tally = {};
    const Sign by_side = turn_to_crossing(s, t, *p);
    ASSERT_EQ(orient_2d(s, t, c, in, &tally), by_side) << i;
    ASSERT_EQ(orient_2d(t, s, c, in), -by_side) << i;
    side[kind].add(tally, by_side);
  }
  if (count < 6000) return;  // rates of a small run say little
  for (auto* counts : {&with_crossing, &with_point, &side}) {
    for (const CrossingKind kind : {small_grid, generic_crossing, any_size, nearly_parallel, one_place}) {
      EXPECT_GT((*counts)[kind].all, 300) << kind;
    }
    EXPECT_GT((*counts)[small_grid].zero, counts == &with_crossing ? 0 : 20);
    EXPECT_GT((*counts)[one_place].zero, 50);
    EXPECT_GT((*counts)[any_size].exact, 50);
  }
  EXPECT_GE(with_crossing[generic_crossing].interval, with_crossing[generic_crossing].all - 5);
  EXPECT_GT(side[generic_crossing].interval,
            side[generic_crossing].all * 3 / 4);  // the nearest double is on the line but for rounding
  EXPECT_GT(with_crossing[one_place].exact, 200);
}

TEST(CrossingTest, KnownOnes) {
  const Crossing c{{0, 0}, {4, 4}, {0, 3}, {3, 0}}, same{{1, 0}, {2, 3}, {0, 1.5}, {5, 1.5}},
      above{{1.5, 0}, {1.5, 9}, {0, 2}, {3, 2}};
  const Enclosure2 in = enclosure(c);
  EXPECT_LE(in.x.low, 1.5);
  EXPECT_GE(in.x.high, 1.5);
  EXPECT_LT(in.x.high - in.x.low, 1e-14);
  EXPECT_EQ(compare(c, in, Point2{1.5, 1.5}), Sign::zero);
  EXPECT_EQ(compare(c, in, Point2{1.5, 1.25}), Sign::positive);
  EXPECT_EQ(compare(c, in, Point2{std::nextafter(1.5, 2), 0}), Sign::negative);
  EXPECT_EQ(compare(c, in, same, enclosure(same)), Sign::zero);
  EXPECT_EQ(compare(c, in, above, enclosure(above)), Sign::negative);  // by y
  EXPECT_EQ(orient_2d({0, 3}, {1.5, 1.5}, c, in), Sign::zero);
  EXPECT_EQ(orient_2d({0, 0}, {2, 1}, c, in), Sign::positive);
  // Enclosures may be of no use at all.
  const Enclosure2 line{{-HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, HUGE_VAL}};
  EXPECT_EQ(compare(c, line, Point2{1.5, 1.25}), Sign::positive);
  EXPECT_EQ(compare(c, line, above, line), Sign::negative);
  EXPECT_EQ(orient_2d({0, 0}, {2, 1}, c, line), Sign::positive);
}

}  // namespace
}  // namespace sunder
