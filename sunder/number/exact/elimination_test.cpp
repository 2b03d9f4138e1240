#include <sunder/base/random.h>
#include <sunder/number/exact/elimination_internal.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace sunder {
namespace {

using Matrix = std::vector<std::vector<Integer>>;

// By its first row (Laplace).
Integer determinant(const Matrix& m) {
  if (m.empty()) return 1;
  Integer sum = 0;
  for (std::size_t c = 0; c < m.size(); ++c) {
    Matrix minor(m.begin() + 1, m.end());
    for (auto& row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(c));
    sum += (c % 2 == 0 ? m[0][c] : -m[0][c]) * determinant(minor);
  }
  return sum;
}

Integer product(const std::vector<Integer>& u, const std::vector<Integer>& v) {
  return std::inner_product(u.begin(), u.end(), v.begin(), Integer(0));
}

TEST(Elimination, RowsAreReducedAndOfMinors) {
  Random random(tests::chosen_seed(20261129));
  int dependent = 0, full = 0;
  const int count = tests::scaled_count(1000, 200);
  for (int round = 0; round < count; ++round) {
    const std::size_t width = 1 + random.below(6), rank = 1 + random.below(width);
    const int most = round % 2 == 0 ? 2 : 1 << 30;
    const auto some = [&](std::size_t n) {
      std::vector<Integer> row(n);
      for (Integer& x : row) x = random.between(-most, most);
      return row;
    };
    Matrix base(rank);
    for (auto& row : base) row = some(width);
    Elimination elimination(width);
    Matrix added;
    for (std::size_t turn = 0; turn < rank + 2; ++turn) {  // combinations of `rank` rows
      std::vector<Integer> row(width);
      for (const auto& of : base) {
        const Integer by = random.between(-2, 2);
        for (std::size_t k = 0; k < width; ++k) row[k] += by * of[k];
      }
      if (elimination.add(row)) {
        added.push_back(row);
      } else {
        ++dependent;
      }
      ASSERT_EQ(elimination.rank(), added.size());
      ASSERT_LE(elimination.rank(), rank);
      // The pivot is the minor of the columns of pivots, but for its sign.
      Matrix minor(added.size());
      for (std::size_t i = 0; i < added.size(); ++i) {
        for (const Elimination::Row& of : elimination.rows()) minor[i].push_back(added[i][of.column]);
      }
      ASSERT_EQ(boost::multiprecision::abs(determinant(minor)), elimination.pivot());
      ASSERT_GT(elimination.pivot(), 0);
      for (const Elimination::Row& of : elimination.rows()) {
        for (const Elimination::Row& other : elimination.rows()) {
          ASSERT_EQ(other.numbers[of.column], &of == &other ? elimination.pivot() : Integer(0));
        }
      }
      // All that was given is a combination of the rows, by what it has in their columns.
      for (std::size_t k = 0; k < width; ++k) {
        Integer sum = 0;
        for (const Elimination::Row& of : elimination.rows()) sum += row[of.column] * of.numbers[k];
        ASSERT_EQ(sum, row[k] * elimination.pivot());
      }
    }
    const auto across = elimination.across();
    ASSERT_EQ(across.has_value(), elimination.rank() < width);
    full += elimination.rank() == width;
    if (!across) continue;
    EXPECT_TRUE(std::any_of(across->begin(), across->end(), [](const Integer& x) { return x != 0; }));
    for (const auto& row : added) ASSERT_EQ(product(row, *across), 0);
    Integer common = 0;
    for (const Integer& x : *across) common = gcd(common, x);
    EXPECT_EQ(common, 1);
  }
  EXPECT_GT(dependent, count / 2);
  EXPECT_GT(full, count / 20);
}

TEST(Elimination, OfNumbersOfAnySize) {
  const std::vector<Dyadic> tiny{0x1p-1074, 0x1p-1000, 0.0}, large{0x1p900, 0x1p974, 1.0};
  Elimination elimination(3);
  EXPECT_FALSE(elimination.add(std::vector<Dyadic>(3)));
  EXPECT_TRUE(elimination.add(tiny));
  EXPECT_FALSE(elimination.add(std::vector<Dyadic>{1.0, 0x1p74, 0.0}));
  EXPECT_TRUE(elimination.add(large));
  EXPECT_EQ(*elimination.across(), (std::vector<Integer>{Integer(1) << 74, -1, 0}));
}

TEST(ExactInverse, IsExact) {
  const int cases = tests::scaled_count(500, 100);
  Random random(tests::chosen_seed(20261126));
  int singular = 0;
  for (int i = 0; i < cases; ++i) {
    const std::size_t d = 2 + random.below(5);
    std::vector<double> matrix(d * d);
    const bool small = random.below(2) == 0;
    for (double& x : matrix) {
      x = small ? static_cast<double>(random.between(-1, 1))
                : random.uniform(-1, 1) * random.log_uniform(1e-200, 1e200);
    }
    const auto inverse = exact_inverse(d, matrix);
    if (!inverse) {
      ++singular;
      EXPECT_TRUE(small);
      continue;
    }
    EXPECT_EQ(inverse->denominator.sign(), Sign::positive);
    for (std::size_t r = 0; r < d; ++r) {
      for (std::size_t c = 0; c < d; ++c) {
        Dyadic sum;
        for (std::size_t k = 0; k < d; ++k) sum = sum + Dyadic(matrix[r * d + k]) * inverse->numbers[k * d + c];
        EXPECT_TRUE(sum == (r == c ? inverse->denominator : Dyadic()));
      }
    }
  }
  EXPECT_GT(singular, cases / 50);
}

}  // namespace
}  // namespace sunder
