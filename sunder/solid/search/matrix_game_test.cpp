// Matrix games against what von Neumann's theorem promises: neither player can do better than the value.
#include <sunder/solid/search/matrix_game.h>

#include <sunder/base/random.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sunder::solid {
namespace {

using Game = MatrixGame<double, 10>;

// What the rows gain at least by their mix, and the columns lose at most by theirs.
std::pair<double, double> guaranteed(const Game& game) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (std::size_t j = 0; j < game.columns; ++j) {
    double sum = 0;
    for (std::size_t i = 0; i < game.rows; ++i) sum += game.row_weight[i] * game.pay[i][j];
    least = std::min(least, sum);
  }
  for (std::size_t i = 0; i < game.rows; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < game.columns; ++j) sum += game.column_weight[j] * game.pay[i][j];
    most = std::max(most, sum);
  }
  return {least, most};
}

double total(const std::array<double, 10>& weight, std::size_t n) {
  double sum = 0;
  for (std::size_t k = 0; k < n; ++k) sum += weight[k];
  return sum;
}

void expect_solved(Game& game) {
  ASSERT_TRUE(game.solve());
  const auto [least, most] = guaranteed(game);
  EXPECT_NEAR(least, game.value, 1e-12);
  EXPECT_NEAR(most, game.value, 1e-12);
  EXPECT_NEAR(total(game.row_weight, game.rows), 1, 1e-12);
  EXPECT_NEAR(total(game.column_weight, game.columns), 1, 1e-12);
  EXPECT_GE(*std::min_element(game.row_weight.begin(), game.row_weight.end()), 0);
  EXPECT_GE(*std::min_element(game.column_weight.begin(), game.column_weight.end()), 0);
}

TEST(MatrixGame, NeitherPlayerCanDoBetter) {
  Random random(tests::chosen_seed(61));
  int positive = 0;
  const int count = tests::scaled_count(20000);
  for (int i = 0; i < count; ++i) {
    Game game;
    game.rows = 1 + random.below(10), game.columns = 1 + random.below(10);
    const bool whole = i % 3 == 0, of_low_rank = i % 3 == 1;  // many ties; as of points and half-spaces
    for (std::size_t r = 0; r < game.rows; ++r) {
      for (std::size_t c = 0; c < game.columns; ++c) {
        game.pay[r][c] = whole ? static_cast<double>(random.between(-2, 2)) / 2 : random.uniform(-1, 1);
        if (of_low_rank && c > 1) game.pay[r][c] = (game.pay[r][0] + game.pay[r][1] * static_cast<double>(c)) / 11;
      }
    }
    ASSERT_NO_FATAL_FAILURE(expect_solved(game)) << i;
    positive += game.value > 0;
  }
  EXPECT_GT(positive, count / 10);
  EXPECT_LT(positive, count - count / 10);
}

TEST(MatrixGame, SmallOnes) {
  Game pennies;
  pennies.rows = pennies.columns = 2;
  pennies.pay[0] = {1, -1}, pennies.pay[1] = {-1, 1};
  expect_solved(pennies);
  EXPECT_NEAR(pennies.value, 0, 1e-15);
  EXPECT_NEAR(pennies.row_weight[0], 0.5, 1e-15);

  Game saddle;  // a row for certain
  saddle.rows = 2, saddle.columns = 3;
  saddle.pay[0] = {0.5, 0.25, 0.75}, saddle.pay[1] = {1, -1, 0};
  expect_solved(saddle);
  EXPECT_NEAR(saddle.value, 0.25, 1e-15);
  EXPECT_NEAR(saddle.row_weight[0], 1, 1e-15);
  EXPECT_NEAR(saddle.column_weight[1], 1, 1e-15);
}

TEST(MatrixGame, InDoubleDoublesToTheirPrecision) {
  MatrixGame<DoubleDouble, 10> game;
  game.rows = game.columns = 2;
  game.pay[0] = {DoubleDouble(1), DoubleDouble(-1)};
  game.pay[1] = {DoubleDouble(-1), DoubleDouble(1) + DoubleDouble(0x1p-80)};
  ASSERT_TRUE(game.solve());
  // (1 (1 + e) - 1) / (4 + e)
  EXPECT_NEAR(nearest(game.value) * 0x1p82, 1, 1e-4);
}

}  // namespace
}  // namespace sunder::solid
