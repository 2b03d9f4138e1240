// How predicates run through their stages: the formulas, the roundings counted for them, and who decides.
#include <sunder/base/random.h>
#include <sunder/number/rational_test.h>
#include <sunder/predicate/filter/stages.h>

#include <tests/support/doubles.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <type_traits>
#include <utility>

namespace sunder {
namespace {

using tests::largest, tests::least;

// The roundings of each formula, counted by hand. An image has 3; a difference of points 1, of images 4.
using FromPoint = Vector3<Rounded<0>>;
using FromPosed = Vector3<Rounded<3>>;
static_assert(std::is_same_v<decltype(lift<RoundedStage>(Point3{})), FromPoint>);
static_assert(std::is_same_v<decltype(lift<RoundedStage>(std::declval<Posed3>())), FromPosed>);
template <class P, class Formula, class... More>
using Result = std::invoke_result_t<Formula, P, P, More...>;
static_assert(std::is_same_v<Result<FromPoint, decltype(difference_formula<0>)>, Rounded<1>>);
static_assert(std::is_same_v<Result<FromPosed, decltype(difference_formula<2>)>, Rounded<4>>);
static_assert(std::is_same_v<Result<FromPoint, decltype(orient_2d_formula<1>), FromPoint>, Rounded<4>>);
static_assert(std::is_same_v<Result<FromPosed, decltype(orient_2d_formula<1>), FromPosed>, Rounded<10>>);
static_assert(std::is_same_v<Result<FromPoint, decltype(orient_3d_formula), FromPoint, FromPoint>, Rounded<8>>);
static_assert(std::is_same_v<Result<FromPosed, decltype(orient_3d_formula), FromPosed, FromPosed>, Rounded<17>>);

TEST(StagesTest, VectorsOfWholeNumbers) {
  const Vector3<int> a{1, -2, 3}, b{4, 0, -5};
  const Vector3<int> d = a - b;
  EXPECT_TRUE(d.x == -3 && d.y == -2 && d.z == 8);
  EXPECT_EQ(dot(a, b), -11);
  const Vector3<int> c = cross(a, b);
  EXPECT_TRUE(c.x == 10 && c.y == 17 && c.z == 8);
  EXPECT_EQ(dot(a, c), 0);
  EXPECT_EQ(dot(b, c), 0);
}

TEST(StagesTest, FormulasOfWholeNumbers) {
  using V = Vector3<int>;
  const V o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(orient_3d_formula(o, x, y, z), 1);
  EXPECT_EQ(orient_3d_formula(o, V{2, 0, 0}, V{0, 3, 0}, V{5, 7, -1}), -6);
  EXPECT_EQ(orient_3d_formula(V{1, 1, 1}, V{3, 1, 1}, V{1, 4, 1}, V{6, 8, 0}), -6);
  EXPECT_EQ(orient_2d_formula<0>(o, y, z), 1);
  EXPECT_EQ(orient_2d_formula<1>(o, z, x), 1);
  EXPECT_EQ(orient_2d_formula<2>(o, x, y), 1);
  EXPECT_EQ(orient_2d_formula<2>(V{1, 1, 9}, V{4, 1, -8}, V{1, 3, 7}), 6);
  EXPECT_EQ(difference_formula<0>(V{1, 2, 3}, V{5, 7, 9}), 4);
  EXPECT_EQ(difference_formula<1>(V{1, 2, 3}, V{5, 7, 9}), 5);
  EXPECT_EQ(difference_formula<2>(V{1, 2, 3}, V{5, 7, 9}), 6);
}

// An image in each stage: exact, enclosed, within its bound when tame.
TEST(StagesTest, ImagesOfPosedPoints) {
  Random random(tests::chosen_seed(1));
  const int n = tests::scaled_count(4000, 1000);
  int tame = 0, infinite = 0;
  const auto number = [&](int low, int high) {
    if (random.below(8) == 0) return 0.0;
    return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.between(low, high)));
  };
  for (int i = 0; i < n; ++i) {
    const bool wild = i % 4 == 0;
    const auto any = [&](int low, int high) { return wild ? number(-1080, 1023) : number(low, high); };
    Affine3 pose;
    const int outer = static_cast<int>(random.between(-90, 120)), inner = static_cast<int>(random.between(-90, 120));
    for (double& m : pose.linear) m = any(outer - 9, outer);
    for (double& t : pose.translation) t = any(outer + inner - 30, outer + inner + 9);
    const Point3 x{any(inner, inner), any(inner, inner), any(inner - 9, inner)};
    const Posed3 p = posed(x, pose);
    const auto exact = lift<ExactStage>(p);
    const auto interval = lift<IntervalStage>(p);
    const auto rounded = lift<RoundedStage>(p);
    if (p.tame) ++tame;
    for (std::size_t r = 0; r < 3; ++r) {
      const Rational expected = rational(pose.linear[3 * r]) * rational(x.x) +
                                rational(pose.linear[3 * r + 1]) * rational(x.y) +
                                rational(pose.linear[3 * r + 2]) * rational(x.z) + rational(pose.translation[r]);
      ASSERT_EQ(rational(r == 0 ? exact.x : r == 1 ? exact.y : exact.z), expected) << i;
      const Interval e = r == 0 ? interval.x : r == 1 ? interval.y : interval.z;
      if (std::isinf(e.low) || std::isinf(e.high)) ++infinite;
      ASSERT_TRUE(std::isinf(e.low) || rational(e.low) <= expected) << i;
      ASSERT_TRUE(std::isinf(e.high) || expected <= rational(e.high)) << i;
      const Rounded<3> v = r == 0 ? rounded.x : r == 1 ? rounded.y : rounded.z;
      if (p.tame) {
        ASSERT_LE(abs(rational(v.value) - expected), rational(v.bound * v.magnitude)) << i;
      }
    }
  }
  EXPECT_GT(tame, n / 4);
  EXPECT_LT(tame, n);
  EXPECT_GT(infinite, n / 50);
}

enum class Stage { rounded, interval, exact };

template <class Formula, class... Points>
std::pair<Sign, Stage> decided(const Formula& formula, const Points&... points) {
  StageTally t;
  const Sign sign = decide(&t, formula, points...);
  EXPECT_EQ(t.rounded + t.interval + t.exact, 1u);
  EXPECT_EQ(decide(nullptr, formula, points...), sign);
  return {sign, t.rounded ? Stage::rounded : t.interval ? Stage::interval : Stage::exact};
}

TEST(StagesTest, FirstSureStageDecides) {
  const auto product = [](const auto& p) { return p.x * p.y - p.z; };
  using P = Point3;
  EXPECT_EQ(decided(product, P{2, 3, 5}), (std::pair{Sign::positive, Stage::rounded}));
  EXPECT_EQ(decided(product, P{2, 3, 7}), (std::pair{Sign::negative, Stage::rounded}));
  EXPECT_EQ(decided(product, P{0, 3, 0}), (std::pair{Sign::zero, Stage::rounded}));
  EXPECT_EQ(decided(product, P{2, 3, 6}), (std::pair{Sign::zero, Stage::exact}));
  EXPECT_EQ(decided(product, P{3, 1 + 0x1p-52, 3}), (std::pair{Sign::positive, Stage::exact}));
  // Not tame: intervals at the earliest.
  EXPECT_EQ(decided(product, P{1e200, 1, 1e100}), (std::pair{Sign::positive, Stage::interval}));
  EXPECT_EQ(decided(product, P{1e-100, 1, 0}), (std::pair{Sign::positive, Stage::interval}));
  EXPECT_EQ(decided(product, P{1e200, 1e200, 1}), (std::pair{Sign::positive, Stage::interval}));
  EXPECT_EQ(decided(product, P{0, least, 0}), (std::pair{Sign::zero, Stage::interval}));
  EXPECT_EQ(decided(product, P{1e-300, 1e-300, 0}), (std::pair{Sign::positive, Stage::exact}));
  EXPECT_EQ(decided(product, P{-least, least, 0}), (std::pair{Sign::negative, Stage::exact}));
  EXPECT_EQ(decided(product, P{1e300, 1e300, 1e308}), (std::pair{Sign::positive, Stage::interval}));
  EXPECT_EQ(decided(product, P{1e300, 1e300, largest}), (std::pair{Sign::positive, Stage::exact}));
  // All points must be tame.
  const auto lower = [](const auto& p, const auto& q) { return p.x * p.y - q.x * q.y; };
  EXPECT_EQ(decided(lower, P{2, 2, 0}, P{1, 1, 0}), (std::pair{Sign::positive, Stage::rounded}));
  EXPECT_EQ(decided(lower, P{2, 2, 0}, P{1, 1, least}), (std::pair{Sign::positive, Stage::interval}));
  EXPECT_EQ(decided(lower, P{2, 2, 1e200}, P{1, 1, 0}), (std::pair{Sign::positive, Stage::interval}));
}

TEST(StagesTest, PosedPointsSayWhetherTheyAreTame) {
  const auto height = [](const auto& p) { return p.z; };
  const Affine3 pose{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, -3}};
  EXPECT_EQ(decided(height, Posed3{{0, 0, 4}, &pose, true}), (std::pair{Sign::positive, Stage::rounded}));
  EXPECT_EQ(decided(height, Posed3{{0, 0, 4}, &pose, false}), (std::pair{Sign::positive, Stage::interval}));
  EXPECT_EQ(decided(height, posed({0, 0, 3}, pose)), (std::pair{Sign::zero, Stage::exact}));
}

}  // namespace
}  // namespace sunder
