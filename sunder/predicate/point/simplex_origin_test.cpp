#include <sunder/predicate/point/simplex_origin.h>

#include <sunder/base/random.h>
#include <tests/support/exact.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace sunder {
namespace {

using tests::Whole;

// The sign of the least weight of the origin, by minors: the weight of point k is the determinant with the last unit
// vector in its stead, over that of all. 2: the points are in one hyperplane.
int exact_least_sign(const std::vector<std::int64_t>& points, std::size_t d) {
  const std::size_t n = d + 1;
  std::vector<std::vector<Whole>> rows(n, std::vector<Whole>(n));
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < d; ++i) rows[i][k] = points[k * d + i];
    rows[d][k] = 1;
  }
  const std::function<Whole(const std::vector<std::vector<Whole>>&)> determinant = [&](const auto& m) -> Whole {
    if (m.size() == 1) return m[0][0];
    Whole sum = 0;
    for (std::size_t c = 0; c < m.size(); ++c) {
      if (m[0][c].is_zero()) continue;
      std::vector<std::vector<Whole>> minor;
      for (std::size_t r = 1; r < m.size(); ++r) {
        std::vector<Whole> row;
        for (std::size_t k = 0; k < m.size(); ++k) {
          if (k != c) row.push_back(m[r][k]);
        }
        minor.push_back(row);
      }
      const Whole part = m[0][c] * determinant(minor);
      sum += c % 2 == 0 ? part : -part;
    }
    return sum;
  };
  const int whole = determinant(rows).sign();
  if (whole == 0) return 2;
  int least_sign = 1;
  for (std::size_t k = 0; k < n; ++k) {
    auto with = rows;
    for (std::size_t i = 0; i < n; ++i) with[i][k] = i == d ? 1 : 0;
    least_sign = std::min(least_sign, determinant(with).sign() * whole);
  }
  return least_sign;
}

TEST(SimplexOrigin, IsPositiveOnlyWhereAllWeightsAre) {
  const int cases = tests::scaled_count(2000, 200);
  Random random(tests::chosen_seed(20261126));
  int positive = 0, unsure_although_inside = 0, not_inside = 0;
  for (int i = 0; i < cases; ++i) {
    const std::size_t d = 2 + random.below(4);
    const std::int64_t reach = random.below(2) == 0 ? 3 : 1000000;
    std::vector<std::int64_t> points;
    std::vector<std::int64_t> sum(d, 0);
    for (std::size_t k = 0; k <= d; ++k) {
      for (std::size_t c = 0; c < d; ++c) {
        // The last point is about opposite to the sum of the others, so that the origin is often inside.
        const std::int64_t x = k < d ? random.between(-reach, reach) : -sum[c] + random.between(-1, 1);
        sum[c] += x;
        points.push_back(x);
      }
    }
    const double scale = std::ldexp(1.0, static_cast<int>(random.between(-300, 300)));
    std::vector<Interval> intervals;
    for (const std::int64_t x : points) intervals.emplace_back(static_cast<double>(x) * scale);
    const Guess guess = least_weight_of_origin(intervals, d);
    const int exact = exact_least_sign(points, d);
    ASSERT_TRUE(guess == Guess::positive || guess == Guess::unsure);
    if (guess == Guess::positive) {
      ASSERT_EQ(exact, 1) << i;
    }
    positive += guess == Guess::positive;
    unsure_although_inside += exact == 1 && guess == Guess::unsure;
    not_inside += exact != 1;
  }
  EXPECT_GT(positive, cases / 4);
  EXPECT_GT(not_inside, cases / 50);
  EXPECT_EQ(unsure_although_inside, 0);  // integers of six digits are far from singular
}

TEST(SimplexOrigin, WideIntervalsAreUnsure) {
  const std::vector<Interval> points{{1.0, 1.0}, {-1.0, -1.0}, {-1.0, -1.0}, {-1.0, -1.0}, {0.0, 0.0}, {1.0, 1.0}};
  EXPECT_EQ(least_weight_of_origin(points, 2), Guess::positive);
  for (std::size_t k = 0; k < points.size(); ++k) {
    auto wide = points;
    wide[k] = {wide[k].low - 3, wide[k].high + 3};
    EXPECT_EQ(least_weight_of_origin(wide, 2), Guess::unsure) << k;
  }
}

}  // namespace
}  // namespace sunder
