// Signs about half-planes against rational numbers, and that filters decide where they should.
#include <sunder/base/random.h>
#include <sunder/number/rational_test.h>
#include <sunder/predicate/line/constraints.h>

#include <tests/support/doubles.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace sunder {
namespace {

struct Line {
  Rational a, b, c;
  Rational excess(const std::array<Rational, 2>& p) const { return a * p[0] + b * p[1] - c; }
};
Line line(const Constraint& i) { return {rational(i.a), rational(i.b), rational(i.c)}; }
// Not seen from anywhere: a second form.
Line line(const LeftOf& i) {
  const Rational px = rational(i.from.x), py = rational(i.from.y), qx = rational(i.to.x), qy = rational(i.to.y);
  return {qy - py, px - qx, px * qy - py * qx};
}

Sign sign_of_fraction(const Rational& x) { return static_cast<Sign>(x.sign()); }

// The common point of two lines by substitution.
std::array<Rational, 2> common_point(const Line& i, const Line& j) {
  if (i.a == 0) {
    const Rational y = i.c / i.b;
    return {(j.c - j.b * y) / j.a, y};
  }
  const Rational factor = j.a / i.a, y = (j.c - factor * i.c) / (j.b - factor * i.b);
  return {(i.c - i.b * y) / i.a, y};
}

std::array<int, 4> corner_signs{};  // negative, zero, positive, parallel

template <class Half>
void expect_true_corners(const Half& i, const Half& j, const Half& k, StageTally* tally) {
  const Line u = line(i), v = line(j), w = line(k);
  const Sign turned = sign_of_fraction(u.a * v.b - u.b * v.a), faced = sign_of_fraction(u.a * v.a + u.b * v.b);
  ASSERT_EQ(turn(i, j, tally), turned);
  ASSERT_EQ(turn(j, i, tally), -turned);
  ASSERT_EQ(facing(i, j, tally), faced);
  ASSERT_EQ(points_down(i), u.b < 0 || (u.b == 0 && u.a < 0));
  if (turned == Sign::zero) {
    ++corner_signs[3];
    // A point of the line of i, and how far it is outside of j.
    const Rational scale = u.c / (u.a * u.a + u.b * u.b);
    const Sign outside = sign_of_fraction(v.excess({u.a * scale, u.b * scale}));
    if (faced == Sign::positive) {
      ASSERT_EQ(tighter(i, j, tally), -outside);
      ASSERT_EQ(tighter(j, i, tally), outside);
    } else {
      ASSERT_EQ(gap(i, j, tally), -outside);
      ASSERT_EQ(gap(j, i, tally), -outside);
    }
    return;
  }
  const std::array<Rational, 2> p = common_point(u, v);
  const Sign side = sign_of_fraction(w.excess(p));
  if (turned == Sign::positive) {
    ASSERT_EQ(corner_side(i, j, k, tally), side);
  } else {
    ASSERT_EQ(corner_side(j, i, k, tally), side);
  }
  ++corner_signs[static_cast<std::size_t>(static_cast<int>(side) + 1)];
  const ExactPoint2 corner = exact_corner(i, j), on = exact_point_on(i);
  ASSERT_EQ(corner.denominator.sign(), Sign::positive);
  const ExactConstraint half = exact_constraint(i), other = exact_constraint(j);
  ASSERT_EQ((half.a * corner.x + half.b * corner.y - half.c * corner.denominator).sign(), Sign::zero);
  ASSERT_EQ((other.a * corner.x + other.b * corner.y - other.c * corner.denominator).sign(), Sign::zero);
  ASSERT_EQ((half.a * on.x + half.b * on.y - half.c * on.denominator).sign(), Sign::zero);
}

// Numbers of a sort that the turn n tells.
double number(Random& random, int n, double scale) {
  switch (n % 5) {
    case 0: return static_cast<double>(random.between(-4, 4)) * scale;
    case 1: return random.uniform(-1, 1) * scale;
    case 2: return 1 + static_cast<double>(random.between(-3, 3)) * 0x1p-52;
    case 3:
      if (n % 4 > 0) return random.uniform(-1, 1);  // rational numbers are slow with great exponents
      return random.uniform(-1, 1) * std::exp2(static_cast<double>(random.between(-1074, 1023)));
    default: return static_cast<double>(random.between(-4, 4));
  }
}

TEST(ConstraintsTest, SignsOfConstraints) {
  Random random(71);
  StageTally tally;
  corner_signs = {};
  const int count = tests::scaled_count(4000, 600);
  for (int n = 0; n < count && !testing::Test::HasFailure(); ++n) {
    std::array<Constraint, 3> h;
    const double scale = n % 6 > 0 ? 1 : std::exp2(static_cast<double>(random.between(-1070, 1018)));
    for (Constraint& i : h) {
      do {
        i = {number(random, n, scale), number(random, n, scale), number(random, n, scale)};
      } while (i.a == 0 && i.b == 0);
    }
    if (n % 3 == 0) h[1] = {-2 * h[0].a, -2 * h[0].b, -2 * h[0].c};
    if (n % 7 == 0) h[2] = {h[0].a, h[0].b, std::nextafter(h[0].c, 0)};
    if (n % 3 == 0 && (!std::isfinite(h[1].a) || !std::isfinite(h[1].b) || !std::isfinite(h[1].c))) continue;
    expect_true_corners(h[0], h[1], h[2], &tally);
    expect_true_corners(h[1], h[2], h[0], &tally);
  }
  if (count < 4000) return;  // rates of a small run say little
  for (const int of_sign : corner_signs) EXPECT_GT(of_sign, 200);
  EXPECT_GT(tally.rounded, 8000u);
  EXPECT_GT(tally.exact, 500u);
}

TEST(ConstraintsTest, SignsOfArrows) {
  Random random(72);
  StageTally tally;
  corner_signs = {};
  const int count = tests::scaled_count(4000, 600);
  for (int n = 0; n < count && !testing::Test::HasFailure(); ++n) {
    std::array<LeftOf, 3> h;
    const double scale = n % 6 > 0 ? 1 : std::exp2(static_cast<double>(random.between(-1070, 1018)));
    for (LeftOf& i : h) {
      do {
        i = {{number(random, n, scale), number(random, n, scale)},
             {number(random, n, scale), number(random, n, scale)}};
      } while (i.from == i.to);
    }
    if (n % 3 == 0) h[1] = {h[0].to, h[0].from};
    if (n % 11 == 0) h[1].from.x = std::nextafter(h[1].from.x, 0);
    if (n % 7 == 0) h[2].from = h[0].to;
    bool arrows = true;
    for (const LeftOf& i : h) arrows = arrows && i.from != i.to;
    if (!arrows) continue;
    expect_true_corners(h[0], h[1], h[2], &tally);
    expect_true_corners(h[1], h[2], h[0], &tally);
  }
  if (count < 4000) return;  // rates of a small run say little
  for (const int of_sign : corner_signs) EXPECT_GT(of_sign, 150);
  EXPECT_GT(tally.rounded, 8000u);
  EXPECT_GT(tally.exact, 500u);
}

TEST(ConstraintsTest, FloatingPointDecidesWhereThereIsRoom) {
  Random random(73);
  StageTally tally;
  for (int n = 0; n < 3000; ++n) {
    const double x = random.uniform(-9, 9), y = random.uniform(-9, 9), turned = random.uniform(0.1, 3);
    const double angle = random.uniform(0, 7), other = random.uniform(0, 7);
    const auto through = [&](double t, double off) {
      return Constraint{std::cos(t), std::sin(t), std::cos(t) * x + std::sin(t) * y + off};
    };
    const auto arrow = [&](double t, double off) {
      const Point2 p{x + off * std::cos(t), y + off * std::sin(t)};
      return LeftOf{p, {p.x - std::sin(t), p.y + std::cos(t)}};
    };
    for (const double off : {-1e-10, 1e-10}) {
      const Sign wanted = off < 0 ? Sign::positive : Sign::negative;
      EXPECT_EQ(corner_side(through(angle, 0), through(angle + turned, 0), through(other, off), &tally), wanted);
      EXPECT_EQ(corner_side(arrow(angle, 0), arrow(angle + turned, 0), arrow(other, off), &tally), wanted);
    }
  }
  EXPECT_EQ(tally.interval + tally.exact, 0u);
}

TEST(ConstraintsTest, Extremes) {
  constexpr double most = tests::largest, little = tests::least;
  const Constraint x{little, 0, little}, y{0, most, most};  // x <= 1, y <= 1
  EXPECT_EQ(turn(x, y), Sign::positive);
  EXPECT_EQ(corner_side(x, y, {1, 1, 2}), Sign::zero);
  EXPECT_EQ(corner_side(x, y, {1, 1, std::nextafter(2, 0)}), Sign::positive);
  EXPECT_EQ(corner_side(x, y, {most, most, most}), Sign::positive);
  EXPECT_EQ(corner_side(x, y, {most, -most, 0}), Sign::zero);
  EXPECT_EQ(corner_side(x, y, {most, -most, little}), Sign::negative);
  EXPECT_EQ(nearest(exact_corner(x, y)), (Point2{1, 1}));
  EXPECT_EQ(nearest(exact_corner(Constraint{3, 0, 1}, Constraint{0, 7, 1})), (Point2{1.0 / 3, 1.0 / 7}));
  const LeftOf down{{-most, most}, {-most, -most}}, right{{-most, -most}, {most, -most}};
  EXPECT_EQ(turn(down, right), Sign::positive);
  EXPECT_EQ(nearest(exact_corner(down, right)), (Point2{-most, -most}));
  EXPECT_EQ(corner_side(down, right, {{most, most}, {-most, -most}}), Sign::zero);
  EXPECT_EQ(corner_side(down, right, {{most, most}, {-most, little}}), Sign::negative);
  EXPECT_EQ(through_origin<LeftOf>(3, 4), (LeftOf{{0, 0}, {-4, 3}}));
  EXPECT_EQ(turn(through_origin<LeftOf>(3, 4), through_origin<LeftOf>(-4, 3)), Sign::positive);
}

}  // namespace
}  // namespace sunder
