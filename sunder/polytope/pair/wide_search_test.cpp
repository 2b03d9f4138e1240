#include <sunder/base/random.h>
#include <sunder/polytope/pair/polytope_polytope.h>
#include <sunder/polytope/pair/wide_game.h>
#include <sunder/polytope/pair/wide_search.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>
#include <vector>

namespace sunder::polytope {
namespace {

// What refers to its body and pose takes no temporary ones.
static_assert(std::is_constructible_v<Placed, const Polytope&, const Pose&>);
static_assert(!std::is_constructible_v<Placed, const Polytope&, Pose>);
static_assert(!std::is_constructible_v<Placed, Polytope, const Pose&>);
static_assert(!std::is_constructible_v<Placed, const HierarchicalTree&, Pose>);

// Half-spaces about the origin, or not, and points, with exponents between -range and range.
struct WidePair {
  Polytope half_spaces, points;

  static WidePair make(Random& random, std::size_t d, std::size_t count, std::int64_t range) {
    const auto number = [&] {
      return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.between(-range, range)));
    };
    const bool holds_origin = random.below(3) == 0;
    std::vector<double> rows, at;
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t c = 0; c < d; ++c) rows.push_back(number());
      rows.push_back(holds_origin ? std::fabs(number()) : number());
      for (std::size_t c = 0; c < d; ++c) at.push_back(number());
    }
    return {Polytope::from_half_spaces(d, rows), Polytope::from_points(d, at)};
  }
};

// Proved each, and by the search: the simplex method in integers would take up to two seconds each.
TEST(WideSearch, DecidesWhatDoublesCannotHold) {
  Random random(tests::chosen_seed(20261206));
  const int count = tests::scaled_count(90, 8);
  int decided = 0, meeting = 0;
  for (int i = 0; i < count; ++i) {
    const std::size_t d = 2 + random.below(5);
    const std::int64_t range = i % 3 == 0 ? 1000 : random.between(150, 1000);
    const WidePair pair = WidePair::make(random, d, i % 10 == 9 ? 60 : 20, range);
    const Pose here(d);
    Pose moved(d);
    std::vector<double> linear(d * d), by(d, 0x1p-300);
    for (std::size_t c = 0; c < d; ++c) linear[c * d + (c + 1) % d] = c + 1 < d || d % 2 == 1 ? 1 : -1;  // a turn
    if (i % 5 == 4) moved = Pose::from_matrix(d, linear, by);
    Placed half_spaces(pair.half_spaces, moved), points(pair.points, here);
    Cost cost;
    const auto decision = search_widely(half_spaces, points, cost);
    const PolytopeAnswer answer = polytope_polytope(pair.points, here, pair.half_spaces, moved);
    EXPECT_TRUE(check(pair.points, here, pair.half_spaces, moved, answer.verdict(),
                      exact_evidence(pair.points, here, pair.half_spaces, moved, answer)));
    if (!decision) continue;
    EXPECT_EQ(decision->verdict, answer.verdict()) << i;
    ++decided;
    meeting += answer.meet();
  }
  EXPECT_GE(decided, count - count / 20);
  EXPECT_GT(meeting, count / 8);
  EXPECT_LT(meeting, count - count / 8);
}

TEST(WideSearch, IsTheScansAnswer) {
  Random random(tests::chosen_seed(20261207));
  for (int i = 0; i < tests::scaled_count(60, 20); ++i) {
    const std::size_t d = 2 + random.below(2);
    const WidePair pair = WidePair::make(random, d, 2 + random.below(4), 200);
    const Pose here(d);
    Placed half_spaces(pair.half_spaces, here), points(pair.points, here);
    Cost cost;
    const auto decision = search_widely(half_spaces, points, cost);
    ASSERT_TRUE(decision.has_value()) << i;
    EXPECT_EQ(decision->verdict, polytope_polytope_by_scan(pair.half_spaces, here, pair.points, here).verdict());
  }
}

TEST(WideSearch, LeavesNumbersOfLikeSizesToDoubles) {
  const Polytope half_spaces = Polytope::from_half_spaces(2, {1, 0, 1, 0, 1, 1}),
                 points = Polytope::from_points(2, {0, 0});
  const Pose here(2);
  Placed a(half_spaces, here), b(points, here);
  Cost cost;
  EXPECT_FALSE(search_widely(a, b, cost).has_value());
  EXPECT_EQ(cost.proposals, 0u);
}

// The winner's weights win: of columns, no row is positive, of rows, each column is. Degenerate games, too.
TEST(WideGame, WeightsWin) {
  Random random(tests::chosen_seed(20261208));
  int of_columns = 0;
  const int count = tests::scaled_count(300, 60);
  for (int turn = 0; turn < count; ++turn) {
    const std::size_t rows = 1 + random.below(8), columns = 1 + random.below(8);
    std::vector<Dyadic> payoffs(rows * columns);
    for (Dyadic& x : payoffs) {
      const std::int64_t size = turn % 2 == 0 ? 0 : random.between(-400, 400);
      x = Dyadic(static_cast<double>(random.between(-2, 2))).scaled(size);
    }
    WideGame game(12000);
    for (std::size_t j = 0; j < columns; ++j) game.add_column([](std::size_t) { return Dyadic(); });
    for (std::size_t i = 0; i < rows; ++i) game.add_row([&](std::size_t j) { return payoffs[i * columns + j]; });
    ASSERT_TRUE(game.solve()) << turn;
    of_columns += game.columns_win();
    Dyadic total;
    for (const Dyadic& weight : game.weights()) {
      EXPECT_NE(weight.sign(), Sign::negative);
      total = total + weight;
    }
    EXPECT_EQ(total.sign(), Sign::positive);
    const LongFloats to{12000};
    for (std::size_t k = 0; k < (game.columns_win() ? rows : columns); ++k) {
      Dyadic sum;
      for (std::size_t w = 0; w < game.weights().size(); ++w) {
        const Dyadic& payoff = game.columns_win() ? payoffs[k * columns + w] : payoffs[w * columns + k];
        sum = to.sum(sum, to.product(game.weights()[w], payoff));
      }
      if (game.columns_win()) {
        EXPECT_NE(sum.sign(), Sign::positive) << turn;
      } else {
        EXPECT_EQ(sum.sign(), Sign::positive) << turn;
      }
    }
  }
  EXPECT_GT(of_columns, count / 10);
  EXPECT_LT(of_columns, count - count / 10);
}

}  // namespace
}  // namespace sunder::polytope
