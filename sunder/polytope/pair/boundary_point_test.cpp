#include <sunder/base/random.h>
#include <sunder/polytope/pair/boundary_point.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace sunder::polytope {
namespace {

// Integers. Some boundaries are combinations of others, in any order: the point is on them, too, and in what is free it
// is the one given, whatever the unit.
TEST(BoundaryPoint, IsOnBoundariesThatDependOnOthers) {
  Random random(tests::chosen_seed(20261127));
  for (int round = 0; round < tests::scaled_count(300, 60); ++round) {
    const std::size_t d = 2 + random.below(5), free = 1 + random.below(d - 1), count = d + 1 - random.below(2);
    std::vector<std::vector<double>> rows(count, std::vector<double>(d + 1));
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t c = 0; c <= d; ++c) {
        if (k + free < d) rows[k][c] = static_cast<double>(random.between(-50, 50));
        for (std::size_t i = 0; k + free >= d && i + free < d; ++i)
          rows[k][c] += static_cast<double>(1 + (i + k) % 3) * rows[i][c];
      }
    }
    for (std::size_t k = count; k > 1; --k) std::swap(rows[k - 1], rows[random.below(k)]);
    const double unit = std::ldexp(1.0, static_cast<int>(random.between(-300, 300)));
    std::vector<ExactVector> exact;
    for (const std::vector<double>& row : rows) {
      exact.emplace_back(row.begin(), row.end());
      exact.back()[d] = exact.back()[d] * Dyadic(unit);
    }
    ColumnNumbers near{};
    for (std::size_t c = 0; c < d; ++c) near[c] = random.uniform(-4, 4) * unit;
    const auto point = boundary_point(exact, near, unit);
    ASSERT_TRUE(point) << round;
    EXPECT_EQ(point->denominator.sign(), Sign::positive);
    std::size_t as_given = 0;
    for (std::size_t c = 0; c < d; ++c) {
      const double off = nearest_ratio(point->numbers[c], point->denominator) - near[c];
      as_given += std::fabs(off) < 0x1p-39 * unit ? 1u : 0u;
    }
    EXPECT_GE(as_given, free) << round;
    for (const ExactVector& row : exact) EXPECT_TRUE(dot(row, point->numbers) == row[d] * point->denominator) << round;
  }
}

TEST(BoundaryPoint, IsNoneWhereDoublesCannotHoldIt) {
  EXPECT_FALSE(boundary_point(std::vector<ExactVector>{{1.0, 0.0, 1.0}}, {0, HUGE_VAL}, 1));
  EXPECT_FALSE(boundary_point(std::vector<ExactVector>{{1.0, 0.0, 1.0}}, {0, std::nan("")}, 1));
  // Independent as doubles have them, (10, 8) and (3, 3) times 2^-1074, and parallel.
  const Dyadic tiny = Dyadic::power_of_two(-1074);
  const auto times = [&](double x) { return Dyadic(x) * tiny; };
  const std::vector<ExactVector> parallel{{times(10), times(8), 1.0}, {times(3.4375), times(2.75), 1.0}};
  EXPECT_FALSE(boundary_point(parallel, {}, 1));
  // Beyond all doubles.
  const Dyadic huge = Dyadic::power_of_two(2000);
  EXPECT_FALSE(boundary_point(std::vector<ExactVector>{{huge, huge, 1.0}}, {}, 1));
}

}  // namespace
}  // namespace sunder::polytope
