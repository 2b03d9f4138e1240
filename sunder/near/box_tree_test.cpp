#include <sunder/base/random.h>
#include <sunder/near/box_tree.h>

#include <tests/support/doubles.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace sunder {
namespace {

using tests::infinity;

// The square of how far apart boxes are.
double gap(const Box3& a, const Box3& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double along = std::max({0.0, a.low[k] - b.high[k], b.low[k] - a.high[k]});
    sum += along * along;
  }
  return sum;
}

std::vector<Box3> some_boxes(std::size_t count, Random& random) {
  std::vector<Box3> boxes(count);
  for (Box3& box : boxes) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = static_cast<double>(random.between(-6, 6));
      box.high[k] = box.low[k] + static_cast<double>(random.below(3));
      if (random.below(100) == 0) box.low[k] = -infinity;
      if (random.below(100) == 0) box.high[k] = infinity;
    }
  }
  return boxes;
}

TEST(BoxTree, FindsWhatALookAtAllFinds) {
  Random random(91);
  std::uint64_t met = 0, near = 0, left_out = 0;
  const int rounds = tests::scaled_count(300, 100);
  for (int round = 0; round < rounds; ++round) {
    std::vector<Box3> boxes = some_boxes(random.below(60), random);
    const bool has_groups = random.below(2) == 0;
    std::vector<std::uint32_t> groups;
    for (std::size_t i = 0; has_groups && i < boxes.size(); ++i) {
      groups.push_back(static_cast<std::uint32_t>(random.below(1 + random.below(4))));
    }
    BoxTree tree(boxes, groups);
    if (round % 3 == 0) {  // what moves counts after both
      for (Box3& box : boxes) {
        const auto i = static_cast<std::uint32_t>(&box - boxes.data());
        tree.box(i) = box = some_boxes(1, random)[0];
      }
      round % 2 == 0 ? tree.refit() : tree.build();
    }
    for (int question = 0; question < 10; ++question) {
      const Box3 asked = some_boxes(1, random)[0];
      const std::uint32_t group = has_groups ? static_cast<std::uint32_t>(random.below(4)) : BoxTree::no_group;
      const auto counts = [&](std::uint32_t i) { return group == BoxTree::no_group || groups[i] != group; };
      const double most = static_cast<double>(random.below(30));
      std::vector<std::uint32_t> meeting, found, within, found_within;
      for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        left_out += !counts(i) && meet(boxes[i], asked);
        if (counts(i) && meet(boxes[i], asked)) meeting.push_back(i);
        if (counts(i) && gap(boxes[i], asked) <= most) within.push_back(i);
      }
      tree.for_each_meeting(asked, group, [&](std::uint32_t i) { found.push_back(i); });
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, meeting) << round;
      const auto to_asked = [&](const Box3& box) { return gap(box, asked); };
      tree.for_each_near(group, to_asked, most, [&](std::uint32_t i, double at) {
        EXPECT_EQ(at, gap(boxes[i], asked));
        found_within.push_back(i);
      });
      std::sort(found_within.begin(), found_within.end());
      ASSERT_EQ(found_within, within) << round;
      met += meeting.size();
      near += within.size();
      // The nearest, by a bound that shrinks.
      double least = infinity, expected = infinity;
      for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (counts(i)) expected = std::min(expected, gap(boxes[i], asked));
      }
      tree.for_each_near(group, to_asked, least, [&](std::uint32_t, double at) { least = at; });
      ASSERT_EQ(least, expected);
    }
  }
  const auto some = static_cast<std::uint64_t>(rounds);
  EXPECT_GT(met, 2 * some);
  EXPECT_GT(near, 20 * some);
  EXPECT_GT(left_out, some / 4);
}

// A node of which all is of the group is not looked into.
TEST(BoxTree, PassesOverAGroupAtOnce) {
  constexpr std::size_t count = 1 << 14;
  std::vector<Box3> boxes(count, Box3{{0, 0, 0}, {1, 1, 1}});
  std::vector<std::uint32_t> groups(count, 7);
  boxes.back() = {{9, 9, 9}, {9, 9, 9}};
  groups.back() = 8;
  const BoxTree tree(boxes, groups);
  const auto none = [](std::uint32_t) { FAIL(); };
  EXPECT_LT(tree.for_each_meeting(boxes.front(), 7, none), 100u);
  EXPECT_GT(tree.for_each_meeting(boxes.front(), 8, [](std::uint32_t) {}), count);
}

}  // namespace
}  // namespace sunder
