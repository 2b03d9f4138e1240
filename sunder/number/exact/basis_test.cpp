#include <sunder/base/random.h>
#include <sunder/number/exact/basis_internal.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace sunder {
namespace {

using Column = std::vector<Integer>;

Integer product(std::span<const Integer> u, std::span<const Integer> v) {
  return std::inner_product(u.begin(), u.end(), v.begin(), Integer(0));
}

// Equations sum x_k columns[k] = right, of small integers or large ones, and many zeros.
struct Problem {
  std::vector<Column> columns;
  Column right;

  Problem(Random& random, std::size_t rows, std::size_t count, int most) {
    for (std::size_t k = 0; k < count; ++k) columns.push_back(some(random, rows, most));
    right = some(random, rows, most);
  }
  static Column some(Random& random, std::size_t rows, int most) {
    Column result(rows);
    for (Integer& x : result) x = random.below(3) == 0 ? 0 : random.between(-most, most);
    return result;
  }

  // The column of a basic variable of this problem.
  Column column(const BasicVariable& variable) const {
    if (variable.kind != BasicVariable::artificial) return columns[variable.index];
    Column unit(right.size());
    unit[variable.index] = right[variable.index] < 0 ? -1 : 1;
    return unit;
  }

  // The inverse is that of the basis, and the values are those of its variables.
  void check(const IntegerBasis& basis) const {
    ASSERT_GT(basis.denominator(), 0);
    Column sum(right.size());
    for (std::size_t i = 0; i < basis.rows(); ++i) {
      const Column own = column(basis.variable(i));
      for (std::size_t j = 0; j < basis.rows(); ++j) {
        ASSERT_EQ(product(basis.inverse(j), own), i == j ? basis.denominator() : Integer(0));
      }
      for (std::size_t k = 0; k < right.size(); ++k) sum[k] += basis.value(i) * own[k];
    }
    for (std::size_t k = 0; k < right.size(); ++k) ASSERT_EQ(sum[k], right[k] * basis.denominator());
  }
};

TEST(Basis, PhaseOneEndsWithASolutionOrAProofThatThereIsNone) {
  Random random(tests::chosen_seed(20261130));
  const int count = tests::scaled_count(1000, 200);
  int solved = 0, degenerate = 0;
  for (int round = 0; round < count; ++round) {
    const std::size_t rows = 1 + random.below(6);
    const Problem problem(random, rows, 3 * rows, round % 4 == 0 ? 1 << 30 : 1);
    IntegerBasis basis(problem.right);
    problem.check(basis);
    for (bool pays = true; pays && !basis.is_solved();) {
      pays = false;
      for (std::uint32_t k = 0; k < problem.columns.size(); ++k) {
        const Integer price = basis.price(problem.columns[k]);
        ASSERT_EQ(price, product(basis.multipliers(), problem.columns[k]));
        const bool entered = basis.enter_if_it_pays({0, k}, problem.columns[k]);
        ASSERT_EQ(entered, price > 0);
        if (!entered) continue;
        pays = true;
        problem.check(basis);
        for (std::size_t i = 0; i < rows; ++i) {
          ASSERT_GE(basis.value(i), 0);
          degenerate += basis.value(i).is_zero();
        }
      }
      ASSERT_LT(basis.pivots(), 1000u);
    }
    Integer rest = 0;  // the sum of the artificial variables, which is that of y and the right-hand sides
    for (std::size_t i = 0; i < rows; ++i) rest += basis.is_artificial(i) ? basis.value(i) : 0;
    EXPECT_EQ(product(basis.multipliers(), problem.right), rest);
    EXPECT_EQ(basis.is_solved(), rest == 0);
    solved += basis.is_solved();
    if (basis.is_solved()) continue;
    for (const Column& column : problem.columns) EXPECT_LE(product(basis.multipliers(), column), 0);
  }
  EXPECT_GT(solved, count / 8);
  EXPECT_LT(solved, count * 7 / 8);
  EXPECT_GT(degenerate, count);
}

TEST(Basis, TakesAnyPivot) {
  Random random(tests::chosen_seed(20261201));
  int negative = 0;
  for (int round = 0; round < tests::scaled_count(300, 100); ++round) {
    const std::size_t rows = 1 + random.below(6);
    const Problem problem(random, rows, 10, 3);
    IntegerBasis basis(problem.right);
    for (std::uint32_t k = 0; k < problem.columns.size(); ++k) {
      const std::size_t r = random.below(rows);
      const Column t = basis.in_terms(problem.columns[k]);
      if (t[r].is_zero()) continue;
      negative += t[r] < 0;
      basis.pivot(r, {0, k}, t);
      problem.check(basis);
    }
  }
  EXPECT_GT(negative, 100);
}

// The one that leaves has the least ratio, and of those that have, the lexicographically least row of the inverse.
TEST(Basis, LeavesLexicographically) {
  Random random(tests::chosen_seed(20261202));
  int ties = 0;
  for (int round = 0; round < tests::scaled_count(500, 200); ++round) {
    const std::size_t rows = 2 + random.below(5);
    const Problem problem(random, rows, 8, 1);
    IntegerBasis basis(problem.right);
    for (std::uint32_t k = 0; k < problem.columns.size(); ++k) {
      const Column t = basis.in_terms(problem.columns[k]);
      const std::size_t r = basis.leaving_row(t);
      if (r == rows) {
        for (const Integer& x : t) ASSERT_LE(x, 0);
        continue;
      }
      for (std::size_t i = 0; i < rows; ++i) {
        ASSERT_TRUE(basis.is_positive(i));
        if (i == r || t[i] <= 0) continue;
        Integer difference = basis.value(i) * t[r] - basis.value(r) * t[i];
        ties += difference.is_zero();
        for (std::size_t j = 0; j < rows && difference.is_zero(); ++j) {
          difference = basis.inverse(i)[j] * t[r] - basis.inverse(r)[j] * t[i];
        }
        ASSERT_GT(difference, 0);
      }
      basis.pivot(r, {0, k}, t);
    }
  }
  EXPECT_GT(ties, 100);
}

// The problems have small integers, of which only quotients are rounded.
TEST(Basis, LongFloatingPointAgrees) {
  Random random(tests::chosen_seed(20261203));
  int solved = 0;
  const int count = tests::scaled_count(300, 100);
  for (int round = 0; round < count; ++round) {
    const std::size_t rows = 1 + random.below(6);
    const Problem problem(random, rows, 3 * rows, 2);
    const auto dyadics = [](std::span<const Integer> numbers) {
      std::vector<Dyadic> result;
      for (const Integer& x : numbers) result.push_back(dyadic_of(x, 0));
      return result;
    };
    IntegerBasis exact(problem.right);
    LongFloatBasis rounded(dyadics(problem.right), {LongFloats{300}});
    for (bool pays = true; pays;) {
      pays = false;
      for (std::uint32_t k = 0; k < problem.columns.size(); ++k) {
        const bool entered = exact.enter_if_it_pays({0, k}, problem.columns[k]);
        ASSERT_EQ(entered, rounded.enter_if_it_pays({0, k}, dyadics(problem.columns[k])));
        pays = pays || entered;
      }
    }
    ASSERT_EQ(exact.is_solved(), rounded.is_solved());
    solved += exact.is_solved();
    for (std::size_t i = 0; i < rows; ++i) {
      ASSERT_EQ(exact.variable(i).index, rounded.variable(i).index);
      EXPECT_NEAR(nearest_ratio(dyadic_of(exact.value(i), 0), dyadic_of(exact.denominator(), 0)),
                  rounded.value(i).nearest(), 1e-12);
    }
  }
  EXPECT_GT(solved, count / 8);
}

}  // namespace
}  // namespace sunder
