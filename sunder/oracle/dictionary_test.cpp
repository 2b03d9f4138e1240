#include <sunder/base/random.h>
#include <sunder/oracle/dictionary_internal.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

namespace sunder::oracle {
namespace {

// Equations of small integers in variables 0, 1, .., with right-hand sides that are not negative.
struct Equations {
  std::vector<Integers> rows;  // coefficients, then the right-hand side

  Equations(Random& random, std::size_t count, std::size_t variables) : rows(count, Integers(variables + 1)) {
    for (Integers& row : rows) {
      for (Integer& x : row) x = random.below(3) == 0 ? 0 : random.between(-2, 2);
      if (row.back() < 0) row.back() = -row.back();
    }
  }
  std::size_t variables() const { return rows[0].size() - 1; }
  std::int64_t artificial(std::size_t row) const { return static_cast<std::int64_t>(variables() + row); }

  Dictionary dictionary(bool with_columns) const {
    Dictionary result;
    for (std::size_t k = 0; with_columns && k < variables(); ++k) result.others.push_back(static_cast<std::int64_t>(k));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      result.basic.push_back(artificial(i));
      result.rows.push_back(with_columns ? rows[i] : Integers{rows[i].back()});
    }
    if (with_columns) result.begin_phase_one();
    return result;
  }

  // Is x, over the denominator, with these artificial variables a solution?
  void check(const Dictionary& dictionary) const {
    Integers x(variables() + rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      ASSERT_GE(dictionary.rows[i].back(), 0);
      x[static_cast<std::size_t>(dictionary.basic[i])] = dictionary.rows[i].back();
    }
    Integer sum_of_artificial = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Integer sum = x[variables() + i];
      sum_of_artificial += sum;
      for (std::size_t k = 0; k < variables(); ++k) sum += rows[i][k] * x[k];
      ASSERT_EQ(sum, rows[i].back() * dictionary.denominator);
    }
    for (const Integers& objective : dictionary.objectives) ASSERT_EQ(objective.back(), -sum_of_artificial);
    ASSERT_GT(dictionary.denominator, 0);
  }

  // Multipliers that show that there is no solution: as the objective has them, or the rows.
  Integers multipliers(const Dictionary& dictionary) const {
    Integers result(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
      for (std::size_t i = 0; i < rows.size(); ++i) {
        if (dictionary.basic[i] >= artificial(0)) result[k] += dictionary.inverse(i, artificial(k));
      }
    }
    return result;
  }
  void check_none(const Dictionary& dictionary) const {
    const Integers y = multipliers(dictionary);
    Integers sum(variables() + 1);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!dictionary.objectives.empty()) {
        ASSERT_EQ(dictionary.multiplier(artificial(i)), y[i]);
      }
      for (std::size_t k = 0; k <= variables(); ++k) sum[k] += y[i] * rows[i][k];
    }
    for (std::size_t k = 0; k < variables(); ++k) EXPECT_LE(sum[k], 0);
    EXPECT_GT(sum.back(), 0);
  }
};

TEST(Dictionary, PhaseOneIsProvedEitherWay) {
  Random random(tests::chosen_seed(20261204));
  const int count = tests::scaled_count(1000, 200);
  int solved = 0;
  for (int round = 0; round < count; ++round) {
    const std::size_t size = 1 + random.below(5);
    const Equations equations(random, size, 2 * size);
    Dictionary whole = equations.dictionary(true);
    const auto is_own = [&](std::int64_t variable) { return variable < equations.artificial(0); };
    while (const auto entering = whole.entering(whole.objectives[0], is_own)) {
      whole.pivot(*whole.leaving(*entering), *entering);
      equations.check(whole);
    }
    const bool is_solved = whole.objectives[0].back() == 0;
    solved += is_solved;
    if (!is_solved) equations.check_none(whole);
    // With columns that come as they pay.
    Dictionary few = equations.dictionary(false);
    for (bool pays = true; pays;) {
      pays = false;
      for (std::size_t k = 0; k < equations.variables(); ++k) {
        Integers column;
        for (const Integers& row : equations.rows) column.push_back(row[k]);
        const Integers y = equations.multipliers(few);
        if (std::inner_product(y.begin(), y.end(), column.begin(), Integer(0)) <= 0) continue;
        pays = true;
        few.add_column(static_cast<std::int64_t>(k), column, equations.artificial(0));
        const std::size_t last = few.others.size() - 1;
        few.pivot(*few.leaving(last), last);
        equations.check(few);
        if (is_own(few.others.back())) few.drop_last_column();
        break;  // the first that pays: Bland's rule
      }
    }
    if (!is_solved) equations.check_none(few);
    for (std::size_t i = 0; i < few.rows.size() && is_solved; ++i) {
      EXPECT_TRUE(is_own(few.basic[i]) || few.rows[i].back() == 0);
    }
  }
  EXPECT_GT(solved, count / 8);
  EXPECT_LT(solved, count * 7 / 8);
}

// 3 x + y + 2 s = 7 and so on: of any pivot, also a negative one, the same solutions are left.
TEST(Dictionary, AnyPivotKeepsTheEquations) {
  Random random(tests::chosen_seed(20261205));
  int negative = 0;
  for (int round = 0; round < tests::scaled_count(300, 100); ++round) {
    const std::size_t size = 1 + random.below(5), n = 3;
    Dictionary dictionary = Equations(random, size, n).dictionary(true);
    // Some values of the first other variables give those of the basic ones, times the denominator, which is 1.
    Integers values(n + size);
    for (std::size_t k = 0; k < n; ++k) values[k] = random.between(-9, 9);
    for (std::size_t i = 0; i < size; ++i) {
      values[n + i] = dictionary.rows[i].back();
      for (std::size_t k = 0; k < n; ++k) values[n + i] -= dictionary.rows[i][k] * values[k];
    }
    for (int turn = 0; turn < 6; ++turn) {
      const std::size_t r = random.below(size), c = random.below(n);
      if (dictionary.rows[r][c].is_zero()) continue;
      negative += dictionary.rows[r][c] < 0;
      dictionary.pivot(r, c);
      ASSERT_GT(dictionary.denominator, 0);
      for (std::size_t i = 0; i < size; ++i) {
        Integer sum = dictionary.rows[i].back();
        for (std::size_t j = 0; j < n; ++j) {
          sum -= dictionary.rows[i][j] * values[static_cast<std::size_t>(dictionary.others[j])];
        }
        ASSERT_EQ(sum, dictionary.denominator * values[static_cast<std::size_t>(dictionary.basic[i])]);
      }
    }
  }
  EXPECT_GT(negative, 100);
}

// Where several columns or rows are equally good, the least variable is chosen.
TEST(Dictionary, BlandsRule) {
  Dictionary dictionary;
  dictionary.others = {5, 2, 3};
  dictionary.basic = {7, 6, 8};
  dictionary.rows = {{1, 2, 0, 4}, {1, 1, 0, 2}, {1, 1, -1, 3}};
  const Integers objective{-1, -1, 0, 0};
  const auto any = [](std::int64_t) { return true; };
  EXPECT_EQ(dictionary.entering(objective, any), std::optional<std::size_t>(1));
  EXPECT_EQ(dictionary.entering(objective, [](std::int64_t k) { return k != 2; }), std::optional<std::size_t>(0));
  EXPECT_EQ(dictionary.entering(Integers{0, 1, 0, 0}, any), std::nullopt);
  EXPECT_EQ(dictionary.leaving(1), std::optional<std::size_t>(1));  // 4 / 2, 2 / 1 and 3 / 1: the variables 7 and 6
  EXPECT_EQ(dictionary.leaving(2), std::nullopt);
}

}  // namespace
}  // namespace sunder::oracle
