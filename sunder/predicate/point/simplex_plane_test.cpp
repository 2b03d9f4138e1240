#include <sunder/predicate/point/simplex_plane.h>

#include <sunder/base/random.h>
#include <tests/support/exact.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace sunder {
namespace {

using tests::Whole;
using Rows = std::vector<std::vector<Whole>>;

Whole determinant(const Rows& m) {
  if (m.size() == 1) return m[0][0];
  Whole sum = 0;
  for (std::size_t c = 0; c < m.size(); ++c) {
    Rows rest(m.begin() + 1, m.end());
    for (auto& row : rest) row.erase(row.begin() + static_cast<std::ptrdiff_t>(c));
    const Whole term = m[0][c] * determinant(rest);
    c % 2 == 0 ? sum += term : sum -= term;
  }
  return sum;
}

std::vector<Whole> whole_numbers(const std::vector<double>& numbers) {
  std::vector<Whole> result;
  for (const double x : numbers) result.push_back(x == 0 ? Whole(0) : tests::Exact(x).at(-500));
  return result;
}

std::vector<Whole> minus(const std::vector<Whole>& p, const std::vector<Whole>& q) {
  std::vector<Whole> result;
  for (std::size_t c = 0; c < p.size(); ++c) result.push_back(p[c] - q[c]);
  return result;
}

// det(q - p0, p1 - p0, ..), by its definition.
int side_of(const Rows& points, std::size_t d, std::size_t q) {
  Rows m{minus(points[q], points[0])};
  for (std::size_t i = 1; i < d; ++i) m.push_back(minus(points[i], points[0]));
  return determinant(m).sign();
}

// d corners, then points: at random, in the plane but for rounding, exactly in it (a corner, or the middle of two).
std::vector<std::vector<double>> some_points(std::size_t d, int family, Random& random) {
  std::vector<std::vector<double>> points;
  const int exponent = static_cast<int>(random.between(-300, 300));
  for (std::size_t k = 0; k < d; ++k) {
    std::vector<double> p;
    for (std::size_t c = 0; c < d; ++c) {
      const double x = family == 1 ? static_cast<double>(random.between(-8, 8)) : random.uniform(-1, 1);
      p.push_back(family == 2 && c == 1 ? std::ldexp(x, exponent) : family == 3 ? 1 + x * 0x1p-45 : x);
    }
    points.push_back(p);
  }
  std::vector<double> near(d), middle(d), other(d);
  for (std::size_t c = 0; c < d; ++c) {
    for (std::size_t k = 0; k < d; ++k) near[c] += points[k][c] * (k == 0 ? 0.5 : 0.5 / static_cast<double>(d - 1));
    middle[c] = points[0][c] + points[1][c];
    other[c] = family == 1 ? static_cast<double>(random.between(-8, 8)) : random.uniform(-1, 1);
  }
  if (family == 1) {  // whole numbers: on the line of two corners
    points.push_back(middle);
    for (std::size_t c = 0; c < d; ++c) points.back()[c] = 2 * points[0][c] - points[1][c];
  }
  points.push_back(near);
  points.push_back(other);
  points.push_back(points[1]);
  return points;
}

TEST(SimplexPlane, EachStageSaysWhatTheDeterminantIs) {
  Random random(tests::chosen_seed(20261201));
  int sure = 0, closer = 0, all = 0, zero = 0;
  for (int turn = 0; turn < tests::scaled_count(400, 40); ++turn) {
    const std::size_t d = 2 + static_cast<std::size_t>(turn % 5);
    const auto points = some_points(d, turn / 5 % 4, random);
    std::vector<double> flat;
    Rows exact;
    for (const auto& p : points) {
      flat.insert(flat.end(), p.begin(), p.end());
      exact.push_back(whole_numbers(p));
    }
    const PlanePoints of(d, flat);
    // The same as fractions: each times a weight.
    std::vector<Dyadic> fractions;
    for (const auto& p : points) {
      const auto weight = static_cast<double>(random.between(1, 1000));
      for (const double x : p) fractions.push_back(Dyadic(x) * weight);
      fractions.emplace_back(weight);
    }
    const PlanePoints as_fractions(d, fractions);
    SimplexCorners corners{}, exchanged{};
    for (std::uint32_t i = 0; i < d; ++i) corners[i] = exchanged[i] = i;
    std::swap(exchanged[0], exchanged[d - 1]);
    std::vector<Sign> sides;
    for (std::uint32_t q = 0; q < points.size(); ++q) sides.push_back(static_cast<Sign>(side_of(exact, d, q)));
    for (const PlanePoints* both : {&of, &as_fractions}) {
      const RoundedPlane rounded = both->rounded_plane(corners);
      const auto plane = both->exact_plane(corners), opposite = both->exact_plane(exchanged);
      for (std::uint32_t q = 0; q < points.size(); ++q) {
        const Sign wanted = sides[q];
        ASSERT_EQ(both->exact_side(plane, q), wanted) << turn;
        ASSERT_EQ(both->exact_side(opposite, q), -wanted) << turn;
        const Guess first = both->rounded_side(rounded, q), second = both->closer_side(corners, q);
        ASSERT_TRUE(!is_sure(first) || to_sign(first) == wanted) << turn << " " << q;
        ASSERT_TRUE(!is_sure(second) || to_sign(second) == wanted) << turn << " " << q;
        if (q < d) continue;
        ++all;
        sure += is_sure(first) ? 1 : 0;
        closer += is_sure(second) ? 1 : 0;
        zero += wanted == Sign::zero ? 1 : 0;
      }
    }
  }
  std::printf("%d sides, %d zero: floating point is sure of %d, with a bound for the point of %d\n", all, zero, sure,
              closer);
  EXPECT_GT(sure, all / 4);
  EXPECT_GT(closer, sure);
  EXPECT_GT(zero, all / 10);
  EXPECT_LT(closer, all);
}

TEST(SimplexPlane, AConeHoldsWhatItsCornersMake) {
  Random random(tests::chosen_seed(20261202));
  int inside = 0, all = 0;
  for (int turn = 0; turn < tests::scaled_count(300); ++turn) {
    const std::size_t d = 2 + static_cast<std::size_t>(turn % 5);
    const int size = turn % 3 == 0 ? 1 : 50;
    std::vector<double> flat;
    Rows ways;
    std::vector<Dyadic> center;
    for (std::size_t c = 0; c < d; ++c) center.emplace_back(static_cast<double>(random.between(-3, 3)));
    center.emplace_back(7.0);
    for (std::size_t k = 0; k <= d + 3; ++k) {
      ways.emplace_back();
      for (std::size_t c = 0; c < d; ++c) {
        const auto x = random.between(-size, size);
        flat.push_back(static_cast<double>(x));
        ways.back().push_back(Whole(7 * x) - Whole(static_cast<std::int64_t>(center[c].nearest())));
      }
    }
    const Rows cone(ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(d));
    const Whole whole_cone = determinant(cone);
    if (whole_cone == 0) continue;
    const PlanePoints points(d, flat);
    SimplexCorners corners{};
    for (std::uint32_t i = 0; i < d; ++i) corners[i] = i;
    for (std::uint32_t q = 0; q <= d + 3; ++q) {
      bool wanted = true;
      for (std::size_t i = 0; i < d; ++i) {
        Rows changed = cone;
        changed[i] = ways[q];
        wanted = wanted && (determinant(changed) * whole_cone).sign() >= 0;
      }
      EXPECT_EQ(points.in_cone(center, corners, q), wanted);
      ++all;
      inside += wanted ? 1 : 0;
    }
  }
  EXPECT_GT(inside, all / 10);
  EXPECT_LT(inside, all * 9 / 10);
}

}  // namespace
}  // namespace sunder
