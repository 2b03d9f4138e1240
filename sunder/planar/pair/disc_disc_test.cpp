// Kinds of contact and common points of two discs.
#include <sunder/base/random.h>
#include <sunder/planar/pair/disc_disc.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace sunder::planar {
namespace {

DiscContact disc_contact(const Disc& c, const Disc& d) {
  EXPECT_EQ(disc_disc(c, d), disc_disc(d, c));
  return disc_disc(c, d);
}

TEST(DiscDiscTest, EachKind) {
  const Disc unit{{0, 0}, 5};
  EXPECT_EQ(disc_contact(unit, {{6, 8}, 4}), DiscContact::none);
  EXPECT_EQ(disc_contact(unit, {{6, 8}, 5}), DiscContact::touching);
  EXPECT_EQ(disc_contact(unit, {{6, 8}, 6}), DiscContact::overlapping);
  EXPECT_EQ(disc_contact(unit, {{6, 8}, 14}), DiscContact::overlapping);
  EXPECT_EQ(disc_contact(unit, {{6, 8}, 15}), DiscContact::inside);  // touching it from inside
  EXPECT_EQ(disc_contact(unit, {{6, 8}, 16}), DiscContact::inside);
  EXPECT_EQ(disc_contact(unit, {{0, 0}, 1}), DiscContact::inside);
  EXPECT_EQ(disc_contact(unit, unit), DiscContact::inside);
}

TEST(DiscDiscTest, Points) {
  const Disc disc{{0, 0}, 5};
  EXPECT_EQ(disc_contact(disc, {{3, 4}, 0}), DiscContact::touching);
  EXPECT_EQ(disc_contact(disc, {{3, 3}, 0}), DiscContact::inside);
  EXPECT_EQ(disc_contact(disc, {{0, 0}, 0}), DiscContact::inside);
  EXPECT_EQ(disc_contact(disc, {{4, 4}, 0}), DiscContact::none);
  EXPECT_EQ(disc_contact({{1, 1}, 0}, {{1, 1}, 0}), DiscContact::touching);
  EXPECT_EQ(disc_contact({{1, 1}, 0}, {{1, 2}, 0}), DiscContact::none);
}

TEST(DiscDiscTest, Names) {
  EXPECT_EQ(name_of(DiscContact::none), "none");
  EXPECT_EQ(name_of(DiscContact::touching), "touching");
  EXPECT_EQ(name_of(DiscContact::overlapping), "overlapping");
  EXPECT_EQ(name_of(DiscContact::inside), "inside");
}

// The sign of |p - c|^2 - r^2, times the squared denominator.
Sign beyond(const ExactPoint2& p, const Disc& c) {
  const Dyadic x = p.x - Dyadic(c.center.x) * p.denominator, y = p.y - Dyadic(c.center.y) * p.denominator;
  const Dyadic r = Dyadic(c.radius) * p.denominator;
  return (x * x + y * y - r * r).sign();
}

// P1 of common_point, for every kind, at any scale.
TEST(DiscDiscTest, TheCommonPointIsInBoth) {
  Random random(21);
  std::map<DiscContact, int> kinds;
  for (int turn = 0; turn < 20000; ++turn) {
    const double scale = std::ldexp(1, static_cast<int>(turn % 2 == 0 ? 0 : random.between(-1074, 1018)));
    const auto number = [&] {
      return turn % 4 < 2 ? static_cast<double>(random.between(-4, 4)) : random.uniform(-4, 4);
    };
    const Disc c{{scale * number(), scale * number()}, scale * std::fabs(number())};
    const Disc d{{scale * number(), scale * number()}, scale * std::fabs(number())};
    const DiscContact met = disc_contact(c, d);
    ++kinds[met];
    if (met == DiscContact::none) continue;
    for (const ExactPoint2& p : {common_point(c, d), common_point(d, c)}) {
      ASSERT_EQ(p.denominator.sign(), Sign::positive);
      const Sign of_c = beyond(p, c), of_d = beyond(p, d);
      ASSERT_NE(of_c, Sign::positive);
      ASSERT_NE(of_d, Sign::positive);
      ASSERT_EQ(of_c == Sign::zero && of_d == Sign::zero, met == DiscContact::touching);
    }
    if (turn % 2 == 0) {
      const ExactPoint2 p = common_point(c, d);
      const Point2 rounded = common_point_rounded(c, d);
      ASSERT_EQ(rounded.x, nearest_ratio(p.x, p.denominator));
      ASSERT_EQ(rounded.y, nearest_ratio(p.y, p.denominator));
    }
  }
  for (const DiscContact met : {DiscContact::none, DiscContact::overlapping, DiscContact::inside}) {
    EXPECT_GT(kinds[met], 2000) << name_of(met);
  }
  EXPECT_GT(kinds[DiscContact::touching], 200);
}

TEST(DiscDiscTest, KnownCommonPoints) {
  const Point2 touch = common_point_rounded({{0, 0}, 5}, {{9, 12}, 10});
  EXPECT_EQ(touch, (Point2{3, 4}));
  EXPECT_EQ(common_point_rounded({{0, 0}, 1}, {{3, 0}, 2.5}), (Point2{3 / 3.5, 0}));
  EXPECT_EQ(common_point_rounded({{0, 0}, 9}, {{3, 1}, 1}), (Point2{3, 1}));
  EXPECT_EQ(common_point_rounded({{7, 1}, 0}, {{7, 1}, 0}), (Point2{7, 1}));
}

}  // namespace
}  // namespace sunder::planar
