#include <sunder/base/random.h>
#include <sunder/near/box_sweep.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace sunder {
namespace {

std::vector<std::array<std::uint32_t, 2>> by_all_pairs(const std::vector<Box3>& boxes) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (meet(boxes[i], boxes[j])) pairs.push_back({i, j});
    }
  }
  return pairs;
}

TEST(BoxSweep, IsAllPairs) {
  Random random(3);
  std::size_t pairs = 0, empty = 0, infinite = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<Box3> boxes(random.below(60));
    const std::int64_t spread = random.between(1, 15);  // small: equal ends, touching boxes, and boxes in boxes
    for (Box3& box : boxes) {
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = static_cast<double>(random.between(-spread, spread));
        box.high[k] = box.low[k] + static_cast<double>(random.below(4));
        if (random.below(200) == 0) {
          box.low[k] = -std::numeric_limits<double>::infinity();
          ++infinite;
        }
        if (random.below(200) == 0) box.high[k] = std::numeric_limits<double>::infinity();
      }
    }
    const auto expected = by_all_pairs(boxes);
    ASSERT_EQ(meeting_boxes(std::span<const Box3>(boxes)), expected);
    pairs += expected.size();
    empty += expected.empty();
  }
  EXPECT_GT(pairs, 10000u);
  EXPECT_GT(empty, 10u);
  EXPECT_GT(infinite, 100u);
}

std::vector<std::array<std::uint32_t, 2>> of_equal_boxes(std::size_t count) {
  const std::vector<Box3> boxes(count);
  return meeting_boxes(std::span<const Box3>(boxes));
}

TEST(BoxSweep, NoBoxOneBox) {
  EXPECT_TRUE(meeting_boxes(std::span<const Box3>()).empty());
  EXPECT_TRUE(of_equal_boxes(1).empty());
  EXPECT_EQ(of_equal_boxes(3).size(), 3u);  // equal boxes
}

}  // namespace
}  // namespace sunder
