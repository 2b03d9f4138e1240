#include <sunder/base/random.h>
#include <sunder/predicate/filter/sharp_stage.h>
#include <sunder/predicate/line/crossing.h>
#include <sunder/predicate/line/height_order.h>
#include <sunder/predicate/point/orient.h>

#include <gtest/gtest.h>

#include <cmath>

namespace sunder {
namespace {

// Segments that run along one line to within some units in the last place: what intervals cannot tell.
class NearlyOneLine {
 public:
  explicit NearlyOneLine(std::uint64_t seed, double scale) : random_(seed), scale_(scale) {}

  Point2 left() { return at(random_.uniform(0.1, 0.2)); }
  Point2 right() { return at(random_.uniform(1.1, 1.2)); }
  Random& random() { return random_; }

 private:
  Point2 at(double x) { return {scale_ * x, scale_ * (0.7310585786300049 * x + random_.uniform(-3, 3) * 0x1p-50)}; }

  Random random_;
  double scale_;
};

Sign exact_height_order(const Point2& a, const Point2& b, const Point2& c, const Point2& d, double x) {
  const auto p = lift<ExactStage>(a), q = lift<ExactStage>(b), r = lift<ExactStage>(c), s = lift<ExactStage>(d);
  const auto u = q - p, v = s - r;
  const Dyadic at(x);
  return ((p.y - r.y) * (u.x * v.x) + v.x * (u.y * (at - p.x)) - u.x * (v.y * (at - r.x))).sign();
}

TEST(SharpStage, TellsNearlyAllThatIntervalsCannotAndIsRight) {
  for (const double scale : {1.0, 0x1p-120, 0x1p120, 0x1p-300, 0x1p300}) {
    NearlyOneLine near(20261128, scale);
    StageTally heights, turns, points, crossings;
    constexpr int count = 3000;
    for (int i = 0; i < count; ++i) {
      const Point2 a = near.left(), b = near.right(), c = near.left(), d = near.right(), s = near.left();
      const double x = scale * near.random().uniform(0.2, 1.1);
      EXPECT_EQ(height_order(a, b, c, d, x, &heights), exact_height_order(a, b, c, d, x));
      const Dyadic area =
          orient_2d_formula<2>(lift<ExactStage>(Point3{a.x, a.y, 0}), lift<ExactStage>(Point3{b.x, b.y, 0}),
                               lift<ExactStage>(Point3{s.x, s.y, 0}));
      EXPECT_EQ(orient_2d(a, b, s, &turns), area.sign());
      const Crossing p{a, b, c, d}, q{a, near.right(), s, d};
      const ExactPoint2 e = exact_point(p), f = exact_point(q);
      if (e.denominator.sign() == Sign::zero || f.denominator.sign() == Sign::zero) continue;
      const Enclosure2 in = enclosure(p), other_in = enclosure(q);
      const auto low = [&](const Dyadic& x_of_e, double bound) {
        return (x_of_e - Dyadic(bound) * e.denominator).sign();
      };
      if (std::isfinite(in.x.low)) {
        EXPECT_NE(low(e.x, in.x.low), Sign::negative);
      }
      if (std::isfinite(in.x.high)) {
        EXPECT_NE(low(e.x, in.x.high), Sign::positive);
      }
      if (std::isfinite(in.y.low)) {
        EXPECT_NE(low(e.y, in.y.low), Sign::negative);
      }
      if (std::isfinite(in.y.high)) {
        EXPECT_NE(low(e.y, in.y.high), Sign::positive);
      }
      const Sign by_x = (e.x * f.denominator - f.x * e.denominator).sign();
      if (by_x != Sign::zero) {
        EXPECT_EQ(compare(p, in, q, other_in, &crossings), by_x);
      }
      // The nearest double is nearer than the stage tells, others are not.
      for (const Point2 at : {Point2{nearest(e).x, s.y}, Point2{nearest(e).x * (1 + 0x1p-40), s.y}}) {
        const Sign by_point = (e.x - Dyadic(at.x) * e.denominator).sign();
        if (by_point != Sign::zero) {
          EXPECT_EQ(compare(p, in, at, &points), by_point);
        }
      }
      const Vector2<Dyadic> from_s{e.x - Dyadic(s.x) * e.denominator, e.y - Dyadic(s.y) * e.denominator};
      EXPECT_EQ(orient_2d(s, d, p, in), cross(lift<ExactStage>(d) - lift<ExactStage>(s), from_s).sign());
    }
    if (scale > 0x1p200 || scale < 0x1p-200) continue;
    EXPECT_LT(heights.exact, count / 20u) << scale;
    EXPECT_LT(turns.exact, count / 20u) << scale;
    EXPECT_LT(crossings.exact, count / 10u) << scale;
    EXPECT_LT(points.exact, count * 11 / 10u) << scale;
  }
}

// Faces that are flush but for rounding: points of one plane, under poses that turn by the same angle, computed otherwise.
TEST(SharpStage, TellsOfFlushFacesAndIsRight) {
  Random random(20261130);
  StageTally tally;
  constexpr int count = 3000;
  int zeros = 0;
  for (int i = 0; i < count; ++i) {
    const double scale = i % 3 == 0 ? 1 : i % 3 == 1 ? 0x1p-90 : 0x1p60;
    const double angle = random.uniform(0, 6), part = random.uniform(0, 6), rest = angle - part;
    const auto turned = [&](double c, double n) {  // about an axis, by the angle of this cosine and sine
      return Affine3{{c, -n, 0, n * 0.6, c * 0.6, -0.8, n * 0.8, c * 0.8, 0.6},
                     {0.1 * scale, 0.2 * scale, 0.7 * scale}};
    };
    const Affine3 first = turned(std::cos(angle), std::sin(angle)),
                  second = turned(std::cos(part) * std::cos(rest) - std::sin(part) * std::sin(rest),
                                  std::sin(part) * std::cos(rest) + std::cos(part) * std::sin(rest));
    const auto point = [&] {
      return Point3{scale * random.uniform(-1, 1), scale * random.uniform(-1, 1), 0.3 * scale};
    };
    const Posed3 a = posed(point(), first), b = posed(point(), first), c = posed(point(), first),
                 d = posed(point(), i % 50 == 0 ? first : second);
    const Sign exact =
        orient_3d_formula(lift<ExactStage>(a), lift<ExactStage>(b), lift<ExactStage>(c), lift<ExactStage>(d)).sign();
    ASSERT_EQ(orient_3d(a, b, c, d, &tally), exact) << i;
    zeros += exact == Sign::zero;
  }
  EXPECT_LT(zeros, count / 3);
  EXPECT_LE(tally.exact, static_cast<unsigned>(zeros) + count / 50);
}

TEST(SharpStage, IsUnsureOfZeroAndOfWhatUnderflowsOrOverflows) {
  const Sharp one = SharpLeaf{1} - SharpLeaf{0}, tiny = SharpLeaf{0x1p-700} - SharpLeaf{0};
  const Sharp huge = SharpLeaf{0x1p700} - SharpLeaf{0};
  EXPECT_EQ(sign(one), Guess::positive);
  EXPECT_EQ(sign(one - one), Guess::unsure);
  EXPECT_EQ(sign(tiny), Guess::positive);
  EXPECT_EQ(sign(tiny * tiny), Guess::unsure);
  EXPECT_EQ(sign(huge * huge), Guess::unsure);
  EXPECT_EQ(sign(one - huge * huge), Guess::unsure);
  const Sharp nearly_one = SharpLeaf{1} - SharpLeaf{0x1p-60};
  EXPECT_EQ(sign(nearly_one - one), Guess::negative);
  EXPECT_EQ(sign(nearly_one * nearly_one * nearly_one - one), Guess::negative);
  const Sharp third = nearly_one * nearly_one;  // 1 - 2^-59 + 2^-120: the last is not held
  EXPECT_EQ(sign(third - one * third), Guess::unsure);
}

}  // namespace
}  // namespace sunder
