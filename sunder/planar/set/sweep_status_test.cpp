// The list against a plain vector.
#include <sunder/base/random.h>
#include <sunder/planar/set/sweep_status.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace sunder::planar {
namespace {

// Items are ordered by their keys. Grows, shrinks to nothing and grows again, so that blocks are split, dropped,
// reused.
TEST(SweepStatusTest, IsAnOrderedList) {
  Random random(101);
  constexpr std::uint32_t count = 3000;
  std::vector<std::uint64_t> key(count);
  for (std::uint64_t& k : key) k = random.next();
  SweepStatus<std::uint64_t> status(key);
  std::vector<std::uint32_t> listed, absent(count);
  std::iota(absent.begin(), absent.end(), 0u);
  const auto less = [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; };
  std::size_t longest = 0;
  int emptied = 0;
  for (int step = 0; step < 60000; ++step) {
    const bool growing = step / 7500 % 2 == 0;
    const bool insert = listed.empty() || (!absent.empty() && random.below(10) < (growing ? 7u : 2u));
    std::vector<std::uint32_t>& from = insert ? absent : listed;
    const std::size_t pick = random.below(from.size());
    const std::uint32_t item = from[pick];
    from.erase(from.begin() + static_cast<std::ptrdiff_t>(pick));
    const auto place = std::lower_bound(listed.begin(), listed.end(), item, less);
    const std::uint32_t below = place == listed.begin() ? SweepStatus<std::uint64_t>::none : *(place - 1);
    const std::uint32_t above = place == listed.end() ? SweepStatus<std::uint64_t>::none : *place;
    std::uint32_t asked = 0;
    const auto around = insert ? status.insert(item,
                                               [&](std::uint64_t other) {
                                                 ++asked;
                                                 return other < key[item];
                                               })
                               : status.erase(item);
    ASSERT_EQ(around.below, below) << step;
    ASSERT_EQ(around.above, above) << step;
    if (insert) {
      // Halving in the directory and in a block: blocks are at least a single item, so this is generous for few items.
      ASSERT_LE(asked, 2 * std::ceil(std::log2(static_cast<double>(listed.size() + 2))) + 6);
      listed.insert(place, item);
    } else {
      absent.push_back(item);
    }
    longest = std::max(longest, listed.size());
    emptied += listed.empty();
  }
  EXPECT_GT(longest, 1000u);
  EXPECT_GT(emptied, 0);
}

}  // namespace
}  // namespace sunder::planar
