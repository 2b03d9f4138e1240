// Orientation and comparison of points that are fractions, against rationals.
#include <sunder/base/random.h>
#include <sunder/predicate/point/along.h>
#include <sunder/predicate/point/exact_orient.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>

namespace sunder {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Vector = std::array<Rational, 3>;

// Numerators and denominators of few bits, so that points are often in one plane; or of many.
ExactPoint3 some_point(Random& random, bool is_simple) {
  const auto part = [&]() -> Dyadic {
    const auto few = [&] { return static_cast<double>(random.between(-3, 3)); };
    if (is_simple) return few();
    return Dyadic(random.uniform(-1, 1)) * Dyadic(random.uniform(-1, 1)) + Dyadic(few()).scaled(-140);
  };
  const Dyadic denominator = is_simple ? Dyadic(static_cast<double>(random.between(1, 3)))
                                       : Dyadic(random.uniform(0.1, 4)) * Dyadic(random.uniform(0.1, 4));
  return {part(), part(), part(), denominator};
}

Rational rational(const Dyadic& x) {
  Rational sum = 0;
  for (Dyadic rest = x; rest.sign() != Sign::zero;) {
    const double high = rest.nearest();
    sum += Rational(high);
    rest = rest - Dyadic(high);
  }
  return sum;
}
Vector vector(const ExactPoint3& p) {
  const Rational w = rational(p.denominator);
  return {rational(p.x) / w, rational(p.y) / w, rational(p.z) / w};
}
Sign sign_of_rational(const Rational& x) { return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero; }

Sign orient_by_rationals(const std::array<ExactPoint3, 4>& p) {
  std::array<Vector, 3> r;
  const Vector origin = vector(p[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    r[i] = vector(p[i + 1]);
    for (std::size_t k = 0; k < 3; ++k) r[i][k] -= origin[k];
  }
  Rational sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    sum += r[0][k] * r[1][l] * r[2][m] - r[0][k] * r[1][m] * r[2][l];
  }
  return sign_of_rational(sum);
}

TEST(ExactOrient, AgreesWithRationals) {
  Random random(tests::chosen_seed(151));
  int zeros = 0;
  StageTally tally;
  const int times = tests::scaled_count(1000);
  for (int i = 0; i < times; ++i) {
    const bool is_simple = i % 2 == 0;
    std::array<ExactPoint3, 4> p;
    for (ExactPoint3& point : p) point = some_point(random, is_simple);
    // Now and then the last in the plane of the others, or within 2^-150 of it.
    if (i % 5 == 4) {
      const auto mean = [&](auto axis) {
        return axis(p[0]) * p[1].denominator * p[2].denominator + axis(p[1]) * p[0].denominator * p[2].denominator +
               axis(p[2]) * p[0].denominator * p[1].denominator;
      };
      const Dyadic w = Dyadic(3.0) * p[0].denominator * p[1].denominator * p[2].denominator;
      p[3] = {mean([](const ExactPoint3& q) { return q.x; }), mean([](const ExactPoint3& q) { return q.y; }),
              mean([](const ExactPoint3& q) { return q.z; }) + (i % 10 == 4 ? Dyadic(1.0).scaled(-150) : Dyadic()), w};
    }
    const Sign expected = orient_by_rationals(p);
    ASSERT_EQ(orient_3d(p[0], p[1], p[2], p[3], &tally), expected) << i;
    const Guess guess = guess_orient_3d(estimated(p[0]), estimated(p[1]), estimated(p[2]), estimated(p[3]));
    ASSERT_TRUE(!is_sure(guess) || to_sign(guess) == expected) << i;
    zeros += expected == Sign::zero;
  }
  EXPECT_GT(zeros, times / 100);
  EXPECT_GT(tally.rounded, tally.exact);
  EXPECT_GT(tally.exact, 0u);
}

TEST(ExactOrient, ComparesAlongDirections) {
  Random random(tests::chosen_seed(157));
  const Affine3 pose{{0.5, 1, -2, 0.25, 3, 1, -1, 0.125, 7}, {1, 2, 3}};
  int sure = 0, zeros = 0;
  const int times = tests::scaled_count(1000);
  for (int i = 0; i < times; ++i) {
    const ExactPoint3 a = some_point(random, i % 2 == 0), b = some_point(random, i % 2 == 0);
    const auto part = [&] { return i % 4 < 2 ? static_cast<double>(random.between(-1, 1)) : random.uniform(-1, 1); };
    const WorldDirection d(Point3{part(), part(), part()});
    Along along(d, pose, true);
    Rational height = 0;
    const Vector from = vector(a), to = vector(b);
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        height += Rational(d.doubles()[r]) * Rational(pose.linear[3 * r + c]) * (to[c] - from[c]);
      }
    }
    ASSERT_EQ(along.compare(a, b), sign_of_rational(height)) << i;
    const Guess guess = along.compare_within(nearest(a), nearest(b), 0x1p-40);
    ASSERT_TRUE(!is_sure(guess) || to_sign(guess) == sign_of_rational(height)) << i;
    sure += is_sure(guess);
    zeros += sign_of_rational(height) == Sign::zero;
  }
  EXPECT_GT(sure, times / 2);
  EXPECT_GT(zeros, times / 100);
}

// An error just as large as it is said to be: never sure on the wrong side.
TEST(ExactOrient, ComparesWithinTheError) {
  Random random(tests::chosen_seed(163));
  const Affine3 identity;
  int sure = 0;
  for (int i = 0; i < 2000; ++i) {
    const double error = random.log_uniform(0x1p-50, 0x1p-3);
    const WorldDirection d(Point3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
    Along along(d, identity, true);
    const auto point = [&] { return Point3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}; };
    const Point3 from = point(), to{from.x + random.uniform(-16, 16) * error, from.y, from.z};
    const Guess guess = along.compare_within(from, to, error);
    if (!is_sure(guess)) continue;
    ++sure;
    // Each coordinate of both moved against the guess.
    const double side = guess == Guess::positive ? 1 : -1;
    const auto moved = [&](const Point3& p, double by) {
      const auto axis = [&](double x, double along_x) { return Dyadic(x) + Dyadic(along_x > 0 ? by : -by); };
      return ExactPoint3{axis(p.x, d.doubles().x), axis(p.y, d.doubles().y), axis(p.z, d.doubles().z), 1.0};
    };
    ASSERT_EQ(along.compare(moved(from, side * error), moved(to, -side * error)), to_sign(guess)) << i;
  }
  EXPECT_GT(sure, 100);
}

}  // namespace
}  // namespace sunder
