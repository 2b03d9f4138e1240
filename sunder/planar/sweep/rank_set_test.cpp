#include <sunder/base/random.h>
#include <sunder/planar/sweep/rank_set.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace sunder::planar {
namespace {

void expect_neighbours(const RankSet& ranks, const std::set<std::uint32_t>& truth, std::uint32_t k) {
  const auto from = truth.lower_bound(k), after = truth.upper_bound(k);
  ASSERT_EQ(ranks.before(k), from == truth.begin() ? RankSet::none : *std::prev(from)) << k;
  ASSERT_EQ(ranks.after(k), after == truth.end() ? RankSet::none : *after) << k;
}

// Against std::set, dense and sparse, for sizes on both sides of powers of 64.
TEST(RankSetTest, NeighboursOfAnyNumber) {
  Random random(3);
  for (const std::uint32_t count : {1u, 2u, 63u, 64u, 65u, 4095u, 4096u, 4097u, 262144u, 262145u, 1u << 21}) {
    RankSet ranks(count);
    std::set<std::uint32_t> truth;
    expect_neighbours(ranks, truth, 0);
    for (int turn = 0; turn < 4000; ++turn) {
      const bool near_ends = random.below(4) == 0;
      std::uint32_t k = static_cast<std::uint32_t>(random.below(count));
      if (near_ends) k = random.below(2) == 0 ? std::min(count - 1, k % 3) : count - 1 - std::min(count - 1, k % 3);
      const bool growing = turn / 500 % 2 == 0;
      if (random.below(4) == 0 ? !growing : growing) {
        ranks.insert(k);
        truth.insert(k);
      } else if (!truth.empty()) {
        auto member = truth.lower_bound(k);
        if (member == truth.end()) member = truth.begin();
        ranks.erase(*member);
        truth.erase(member);
      }
      ASSERT_NO_FATAL_FAILURE(expect_neighbours(ranks, truth, k)) << count;
      ASSERT_NO_FATAL_FAILURE(expect_neighbours(ranks, truth, static_cast<std::uint32_t>(random.below(count))));
    }
  }
}

TEST(RankSetTest, FarApart) {
  constexpr std::uint32_t count = 1u << 26;
  RankSet ranks(count);
  ranks.insert(0);
  ranks.insert(count - 1);
  EXPECT_EQ(ranks.after(0), count - 1);
  EXPECT_EQ(ranks.before(count - 1), 0u);
  EXPECT_EQ(ranks.before(0), RankSet::none);
  EXPECT_EQ(ranks.after(count - 1), RankSet::none);
  ranks.erase(0);
  EXPECT_EQ(ranks.before(count - 1), RankSet::none);
}

}  // namespace
}  // namespace sunder::planar
