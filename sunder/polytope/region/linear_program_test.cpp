#include <sunder/polytope/region/linear_program.h>

#include <tests/support/half_space_sets.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

namespace sunder::polytope {
namespace {

Polytope cube(std::size_t d) {
  std::vector<double> rows;
  for (std::size_t c = 0; c < d; ++c) {
    for (const double side : {1.0, -1.0}) {
      std::vector<double> row(d + 1);
      row[c] = side;
      row[d] = 1;
      rows.insert(rows.end(), row.begin(), row.end());
    }
  }
  return Polytope::from_half_spaces(d, std::move(rows));
}

std::vector<double> point_of(const ExactPointN& place) {
  std::vector<double> result;
  for (const Dyadic& x : place.numbers) result.push_back(nearest_ratio(x, place.denominator));
  return result;
}

TEST(LinearProgram, OfCubes) {
  for (std::size_t d = 2; d <= 6; ++d) {
    const Polytope body = cube(d);
    std::vector<double> objective(d, 1.0);
    LinearProgramAnswer answer = linear_program(body, objective);
    EXPECT_EQ(answer.verdict(), Optimum::one);
    EXPECT_TRUE(check(body, objective, answer));
    EXPECT_EQ(point_of(*named_point(answer.evidence)), objective);
    objective[0] = 0;
    answer = linear_program(body, objective);
    EXPECT_EQ(answer.verdict(), Optimum::many);
    EXPECT_TRUE(check(body, objective, answer));
    objective.assign(d, 0);
    answer = linear_program(body, objective);
    EXPECT_EQ(answer.verdict(), Optimum::all);
    EXPECT_TRUE(check(body, objective, answer));
  }
}

// L2, on all families.
TEST(LinearProgram, EachAnswerIsProved) {
  tests::HalfSpaceSets sets(tests::chosen_seed(21003));
  std::array<int, 5> outcomes{};
  const int count = tests::scaled_count(4000, 400);
  for (int k = 0; k < count; ++k) {
    const tests::HalfSpaceSet set = sets.next();
    const LinearProgramAnswer answer = linear_program(set.half_spaces, set.objective);
    ASSERT_TRUE(check(set.half_spaces, set.objective, answer)) << tests::name_of(set.family) << ", " << k;
    ++outcomes[static_cast<std::size_t>(answer.verdict())];
  }
  for (const int n : outcomes) EXPECT_GT(n, count / 100);
}

}  // namespace
}  // namespace sunder::polytope
