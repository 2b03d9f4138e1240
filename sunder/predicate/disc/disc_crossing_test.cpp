// Against fractions of many bits: coordinates of crossings cut to 2^-300, for discs of whole numbers and of numbers one
// unit in the last place off them, where no distance that is not zero is that small.
#include <sunder/base/random.h>
#include <sunder/predicate/disc/disc_crossing.h>
#include <sunder/predicate/disc/disc_powers.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>
#include <optional>

namespace sunder {
namespace {

using Whole = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

// Fixed point: numbers times 2^600.
constexpr unsigned fixed_bits = 600;
Whole fixed(double x) {
  int e = 0;
  const Whole n = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &e), 53));
  const int shift = e - 53 + static_cast<int>(fixed_bits);
  return shift < 0 ? Whole(0) : n << static_cast<unsigned>(shift);
}
Whole times(const Whole& a, const Whole& b) { return (a * b) >> fixed_bits; }
Whole over(const Whole& a, const Whole& b) { return (a << fixed_bits) / b; }
Sign sign_of_fixed(const Whole& x) {
  if (boost::multiprecision::abs(x) < Whole(1) << (fixed_bits / 2)) return Sign::zero;
  return x > 0 ? Sign::positive : Sign::negative;
}

struct Place {
  Whole x, y;
};

// As disc_crossing.h has it.
std::optional<Place> crossing(const Disc& a, const Disc& b) {
  const Whole x = fixed(b.center.x) - fixed(a.center.x), y = fixed(b.center.y) - fixed(a.center.y);
  const Whole distance = times(x, x) + times(y, y), r = fixed(a.radius), s = fixed(b.radius);
  if (sign_of_fixed(distance) == Sign::zero) return std::nullopt;
  const Whole along = over(distance + times(r, r) - times(s, s), 2 * distance);
  const Whole square = over(times(r, r), distance) - times(along, along);
  const Sign sign = sign_of_fixed(square);
  if (sign == Sign::negative) return std::nullopt;
  const Whole across = sign == Sign::zero ? Whole(0) : boost::multiprecision::sqrt(square << fixed_bits);
  return Place{fixed(a.center.x) + times(along, x) - times(across, y),
               fixed(a.center.y) + times(along, y) + times(across, x)};
}

Sign side_of_disc(const Place& p, const Disc& k) {
  const Whole x = p.x - fixed(k.center.x), y = p.y - fixed(k.center.y), r = fixed(k.radius);
  return sign_of_fixed(times(r, r) - times(x, x) - times(y, y));
}

Sign turn_to_place(const Point2& s, const Point2& t, const Place& p) {
  return sign_of_fixed(times(fixed(t.x) - fixed(s.x), p.y - fixed(s.y)) -
                       times(fixed(t.y) - fixed(s.y), p.x - fixed(s.x)));
}

// By angle around a point: of halves, then of turns.
Sign angular_order(const Place& p, const Place& q, const Point2& from) {
  const Whole ox = fixed(from.x), oy = fixed(from.y);
  const auto lower = [&](const Place& at) {
    const Sign y = sign_of_fixed(at.y - oy);
    return y == Sign::negative || (y == Sign::zero && at.x < ox);
  };
  if (lower(p) != lower(q)) return lower(p) ? Sign::positive : Sign::negative;
  return sign_of_fixed(times(q.x - ox, p.y - oy) - times(q.y - oy, p.x - ox));
}

class DiscSource {
 public:
  explicit DiscSource(std::uint64_t seed) : random(seed) {}

  Disc disc(int kind) {
    const auto whole = [&](std::int64_t low, std::int64_t high) {
      return static_cast<double>(random.between(low, high));
    };
    if (kind == 2) return {{random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(0.5, 1.5)};
    // About whole points through (0, 0) or (5, 0), or anything of a small grid.
    static constexpr std::array<std::array<double, 3>, 5> through{
        {{3, 4, 5}, {4, 3, 5}, {0, 5, 5}, {5, 12, 13}, {-3, 4, 5}}};
    const auto& t = through[random.below(through.size())];
    Disc d = random.below(4) ? Disc{{t[0] + 5 * whole(0, 1), random.below(2) ? t[1] : -t[1]}, t[2]}
                             : Disc{{whole(-4, 4), whole(-4, 4)}, whole(0, 6)};
    if (kind == 1) {
      for (double* x : {&d.center.x, &d.center.y, &d.radius}) {
        if (*x != 0 && random.below(3) == 0) *x = std::nextafter(*x, random.below(2) ? 100 : -100);
      }
    }
    return d;
  }

  Random random;
};

bool holds_fixed(const Interval& in, const Whole& x) {
  const Whole little = Whole(1) << (fixed_bits / 2);
  return fixed(in.low) <= x + little && x <= fixed(in.high) + little;
}

TEST(DiscCrossingTest, AgainstManyBits) {
  DiscSource source(7);
  StageTally sides, turns, orders;
  std::array<std::array<int, 3>, 3> signs{};
  const auto note = [&](std::size_t what, Sign sign) {
    ++signs[what][static_cast<std::size_t>(static_cast<std::int8_t>(sign) + 1)];
  };
  int crossings = 0;
  const int count = tests::scaled_count(9000, 1500);
  for (int i = 0; i < count; ++i) {
    const int kind = i % 3;
    const Disc a = source.disc(kind), b = source.disc(kind), c = source.disc(kind), d = source.disc(kind);
    const auto p = crossing(a, b);
    if (!p) continue;
    ++crossings;
    const DiscCrossing at{a, b};
    const Enclosure2 in = enclosure(at);
    ASSERT_TRUE(holds_fixed(in.x, p->x) && holds_fixed(in.y, p->y)) << i;

    const Sign by_side = side_of_disc(at, c, &sides);
    ASSERT_EQ(by_side, side_of_disc(*p, c)) << i;
    note(0, by_side);

    const Point2 s = source.random.below(2) ? a.center : c.center, t = source.random.below(2) ? b.center : d.center;
    const Sign by_turn = orient_2d(s, t, at, &turns);
    ASSERT_EQ(by_turn, turn_to_place(s, t, *p)) << i;
    note(1, by_turn);

    const std::uint64_t way = source.random.below(6);
    const DiscCrossing other = way == 0 ? DiscCrossing{b, a} : way == 1 ? DiscCrossing{a, c} : DiscCrossing{c, d};
    const auto of_other = crossing(other.a, other.b);
    if (!of_other) continue;
    const Point2 from = source.random.below(2) ? Point2{0.5, 0.25} : a.center;
    const auto is_at = [&](const Place& place) {
      return sign_of_fixed(place.x - fixed(from.x)) == Sign::zero &&
             sign_of_fixed(place.y - fixed(from.y)) == Sign::zero;
    };
    if (is_at(*p) || is_at(*of_other)) continue;
    const Viewpoint view = viewpoint(from);
    const Bearing of_p = bearing(at, view), of_q = bearing(other, view);
    ASSERT_LE(of_p.low, of_p.high);
    const Sign by_angle = compare_bearings(at, of_p, other, of_q, view, &orders);
    ASSERT_EQ(by_angle, angular_order(*p, *of_other, from)) << i;
    ASSERT_EQ(compare_bearings(other, of_q, at, of_p, view), -by_angle) << i;
    const Bearing any{0, 4};  // nothing known: exact arithmetic alone
    ASSERT_EQ(compare_bearings(at, any, other, any, view), by_angle) << i;
    note(2, by_angle);
    ASSERT_EQ(is_bearing_zero(at, of_p, view),
              sign_of_fixed(p->y - fixed(from.y)) == Sign::zero && p->x > fixed(from.x))
        << i;
  }
  if (count < 9000) return;  // rates of a small run say little
  EXPECT_GT(crossings, 4000);
  for (const auto& of : signs) {
    for (const int n : of) EXPECT_GT(n, 30);
  }
  for (const StageTally& tally : {sides, turns}) {
    EXPECT_GT(tally.rounded, 2000u);
    EXPECT_GT(tally.interval, 5u);
    EXPECT_GT(tally.exact, 200u);
  }
  EXPECT_GT(orders.interval, 1000u);
  EXPECT_GT(orders.exact, 40u);
}

// The double on each side is not nearer; touching circles and whole points exactly.
TEST(DiscCrossingTest, NearestDoubles) {
  DiscSource source(8);
  int exact = 0, count = 0;
  for (int i = 0; i < 3000; ++i) {
    const Disc a = source.disc(i % 3), b = source.disc(i % 3);
    const auto p = crossing(a, b);
    if (!p) continue;
    ++count;
    const Point2 q = nearest(DiscCrossing{a, b});
    const auto far = [](const Whole& x, double y) -> Whole { return boost::multiprecision::abs(x - fixed(y)); };
    for (const auto& [x, y] : {std::pair{p->x, q.x}, std::pair{p->y, q.y}}) {
      const Whole little = Whole(1) << (fixed_bits / 2);
      ASSERT_LE(far(x, y), far(x, std::nextafter(y, HUGE_VAL)) + little) << i;
      ASSERT_LE(far(x, y), far(x, std::nextafter(y, -HUGE_VAL)) + little) << i;
      exact += far(x, y) < little;
    }
  }
  EXPECT_GT(count, 1000);
  EXPECT_GT(exact, 200);
  const Point2 far = nearest(DiscCrossing{{{1.5e308, 0}, 1.5e308}, {{1.6e308, 0}, 1.4e308}});
  EXPECT_EQ(far.x, HUGE_VAL);
  EXPECT_EQ(far.y, 0);
  const Point2 near = nearest(DiscCrossing{{{0, 0}, 5e-324}, {{5e-324, 0}, 5e-324}});  // (1/2, 0.87) units
  EXPECT_EQ(near.x, 0);
  EXPECT_EQ(near.y, 5e-324);
}

TEST(DiscCrossingTest, WhichOfTheTwo) {
  const Disc a{{0, 0}, 5}, b{{6, 0}, 5};
  EXPECT_EQ(nearest(DiscCrossing{a, b}), (Point2{3, 4}));
  EXPECT_EQ(nearest(DiscCrossing{b, a}), (Point2{3, -4}));
  EXPECT_TRUE(circles_cross(a, b));
  EXPECT_FALSE(circles_cross(a, {{10, 0}, 5}));  // touch
  EXPECT_FALSE(circles_cross(a, {{2, 0}, 3}));   // touch from inside
  EXPECT_FALSE(circles_cross(a, a));
}

// The floor under the first stage: where all would underflow.
TEST(DiscCrossingTest, SmallestNumbers) {
  const double u = 5e-324;
  const Disc a{{0, 0}, 5 * u}, b{{6 * u, 0}, 5 * u};
  StageTally tally;
  EXPECT_EQ(side_of_disc({a, b}, {{3 * u, 0}, 4 * u}, &tally), Sign::zero);
  EXPECT_EQ(side_of_disc({a, b}, {{3 * u, 0}, 3 * u}, &tally), Sign::negative);
  EXPECT_EQ(side_of_disc({a, b}, {{3 * u, u}, 4 * u}, &tally), Sign::positive);
  EXPECT_EQ(tally.rounded, 0u);
  EXPECT_EQ(tally.exact, 3u);
}

}  // namespace
}  // namespace sunder
