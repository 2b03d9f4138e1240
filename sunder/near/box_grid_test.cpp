// The pairs of boxes that a grid finds, and those found by halving, against all pairs.
#include <sunder/base/random.h>
#include <sunder/near/box_grid.h>
#include <sunder/near/box_pairs.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sunder {
namespace {

using PairList = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

PairList by_scan(const std::vector<Box2>& boxes) {
  PairList pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (meet(boxes[i], boxes[j])) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

// Adds pairs, and stops after `most`.
auto adding_to(PairList& pairs, std::size_t most = ~std::size_t{0}) {
  return [&pairs, most](std::uint32_t i, std::uint32_t j) {
    EXPECT_LT(i, j);
    pairs.emplace_back(i, j);
    return pairs.size() < most;
  };
}

PairList sorted_pairs(PairList pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<Box2> some_flat_boxes(Random& random, std::size_t count, int family) {
  std::vector<Box2> boxes;
  const auto ordered = [](double x, double y, double z, double w) {
    return Box2{{std::min(x, y), std::min(z, w)}, {std::max(x, y), std::max(z, w)}};
  };
  for (std::size_t k = 0; k < count; ++k) {
    const auto whole = [&](std::uint64_t n) { return static_cast<double>(random.below(n)); };
    switch (family) {
      case 0: boxes.push_back(ordered(whole(9), whole(9), whole(9), whole(9))); break;  // many touch
      case 1: {
        const double x = random.unit(), y = random.unit(), size = 1 / std::sqrt(static_cast<double>(count));
        boxes.push_back(ordered(x, x + size * random.unit(), y, y + size * random.unit()));
        break;
      }
      case 2: boxes.push_back(ordered(random.unit(), random.unit(), whole(3), whole(3))); break;  // long and flat
      case 3: {                                                                                   // points, some huge
        const double x = whole(40), y = whole(40), far = random.below(9) == 0 ? 1e300 : 0;
        boxes.push_back({{x - far, y}, {x, y + far}});
        break;
      }
      default: {  // of all scales
        const auto any = [&] { return std::ldexp(random.unit() - 0.5, static_cast<int>(random.between(-1070, 1023))); };
        const double x = any(), y = any(), z = any(), w = any();
        boxes.push_back(ordered(x, y, z, w));
      }
    }
  }
  return boxes;
}

TEST(BoxPairs, AreThoseOfTheScan) {
  Random random(20261124);
  std::size_t grids = 0, pairs_found = 0, pairs_across = 0;
  const int count_of_sets = tests::scaled_count(1500, 200);
  for (int k = 0; k < count_of_sets; ++k) {
    const std::vector<Box2> boxes = some_flat_boxes(random, random.below(k % 50 == 0 ? 400 : 60), k % 5);
    const std::span<const Box2> all(boxes);
    const PairList expected = by_scan(boxes);
    pairs_found += expected.size();
    PairList found;
    const auto add = adding_to(found);
    EXPECT_TRUE((BoxPairsByHalving<decltype(add)>(boxes, add).run()));
    ASSERT_EQ(sorted_pairs(found), expected) << k;
    found.clear();
    EXPECT_TRUE(for_each_box_pair(all, add));
    ASSERT_EQ(sorted_pairs(found), expected) << k;
    std::vector<std::uint32_t> groups;
    const std::uint64_t count = 1 + random.below(5);
    for (std::size_t i = 0; i < boxes.size(); ++i) groups.push_back(static_cast<std::uint32_t>(random.below(count)));
    PairList across = expected;
    std::erase_if(across, [&](const auto& pair) { return groups[pair.first] == groups[pair.second]; });
    pairs_across += across.size();
    found.clear();
    EXPECT_TRUE((BoxPairsByHalving<decltype(add)>(boxes, add, groups).run()));
    ASSERT_EQ(sorted_pairs(found), across) << k;
    found.clear();
    EXPECT_TRUE(for_each_box_pair(all, add, nullptr, nullptr, groups));
    ASSERT_EQ(sorted_pairs(found), across) << k;
    const std::optional<BoxGrid> grid = BoxGrid::over(boxes, 1, 1e9);
    if (!grid) continue;
    ++grids;
    found.clear();
    EXPECT_TRUE(for_each_near_pair<400>(all, *grid, add));
    ASSERT_EQ(sorted_pairs(found), expected) << k;
    // With crowds: what the grid leaves out is among their members.
    PairList some;
    for_each_near_pair<3>(all, *grid, adding_to(some));
    const std::vector<std::uint32_t> members = members_of_crowds(*grid, 3, boxes.size());
    EXPECT_EQ(members.empty(), crowded(*grid, 3) == 0);
    const auto is_member = [&](std::uint32_t i) { return std::binary_search(members.begin(), members.end(), i); };
    some = sorted_pairs(some);
    for (const auto& pair : expected) {
      const bool given = std::binary_search(some.begin(), some.end(), pair);
      ASSERT_TRUE(given || (is_member(pair.first) && is_member(pair.second)));
    }
    if (expected.size() < 2) continue;
    found.clear();
    EXPECT_FALSE(for_each_box_pair(all, adding_to(found, expected.size() / 2)));
    EXPECT_EQ(found.size(), expected.size() / 2);
  }
  EXPECT_GT(grids, static_cast<std::size_t>(count_of_sets) * 3 / 5);
  EXPECT_GT(pairs_found, static_cast<std::size_t>(count_of_sets) * 67);
  EXPECT_GT(pairs_across, static_cast<std::size_t>(count_of_sets) * 34);
}

TEST(BoxGrid, IsNotMadeWhereItDoesNotPay) {
  EXPECT_FALSE(BoxGrid::over(std::vector<Box2>{}));
  EXPECT_FALSE(BoxGrid::over(std::vector<Box2>{{{0, 0}, {1, 1}}}));
  constexpr double most = std::numeric_limits<double>::max();
  EXPECT_FALSE(BoxGrid::over(std::vector<Box2>{{{-most, 0}, {most, 1}}, {{0, 0}, {1, 1}}}));  // ranges overflow
  std::vector<Box2> crosses;
  for (int k = 0; k < 100; ++k) {
    const double at = k;
    crosses.push_back(k % 2 == 0 ? Box2{{0, at}, {100, at}} : Box2{{at, 0}, {at, 100}});
  }
  EXPECT_FALSE(BoxGrid::over(crosses, 1, 1.5));
  EXPECT_TRUE(BoxGrid::over(std::vector<Box2>{{{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}}));
}

// Halving looks at no more than a multiple of N log N boxes besides the pairs: long ones that do not meet.
TEST(BoxPairs, ByHalvingTakesNearLinearTimeForLongOnes) {
  std::vector<Box2> boxes;
  for (int k = 0; k < 200000; ++k) {
    const double at = k;
    boxes.push_back({{-at, at}, {at, at}});
  }
  PairList found;
  const auto add = adding_to(found);
  EXPECT_TRUE((BoxPairsByHalving<decltype(add)>(boxes, add).run()));
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace sunder
