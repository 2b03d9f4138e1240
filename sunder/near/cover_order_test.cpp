// Each number once, medians, groups where they help, and boxes beyond the doubles.
#include <sunder/base/random.h>
#include <sunder/near/cover_order.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace sunder {
namespace {

constexpr std::uint64_t all_looks = std::numeric_limits<std::uint64_t>::max();

std::vector<Box2> row_of(std::uint32_t n, double step) {
  std::vector<Box2> boxes;
  for (std::uint32_t i = 0; i < n; ++i) boxes.push_back({{step * i, 0}, {step * i + 1, 1}});
  return boxes;
}

TEST(CoverOrderTest, NamesEachOnce) {
  Random random(5);
  constexpr double inf = std::numeric_limits<double>::infinity();
  for (std::uint32_t n = 0; n < 40; ++n) {
    std::vector<Box2> boxes;
    std::vector<std::uint32_t> groups, numbers(n);
    for (std::uint32_t i = 0; i < n; ++i) {
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      boxes.push_back(i % 7 == 3 ? Box2{{-inf, -inf}, {inf, inf}} : Box2{{x, y}, {x + 0.1, y + 0.1}});
      groups.push_back(static_cast<std::uint32_t>(random.below(3)));
    }
    std::iota(numbers.begin(), numbers.end(), 0u);
    for (const Groups& given : {Groups{}, Groups{groups}}) {
      std::vector<std::uint32_t> order = cover_order(boxes, given);
      std::sort(order.begin(), order.end());
      EXPECT_EQ(order, numbers);
    }
  }
}

// A row stands as it is, whatever the numbers are: n nodes with themselves and one look for each two that are apart.
TEST(CoverOrderTest, OfARow) {
  std::vector<Box2> boxes = row_of(1024, 2);
  std::vector<std::uint32_t> in_order(1024), mixed(1024);
  std::iota(in_order.begin(), in_order.end(), 0u);
  EXPECT_EQ(cover_order(boxes), in_order);
  EXPECT_EQ(cover_looks(in_order, boxes, {}, all_looks), 1024u + 2 * 1023);
  EXPECT_EQ(cover_looks(in_order, boxes, {}, 100), 100u);
  for (std::uint32_t i = 0; i < 1024; ++i) mixed[i] = i * 509 % 1024;
  EXPECT_GT(cover_looks(mixed, boxes, {}, all_looks), 100u * 1024);
  for (Box2& box : boxes) box = {{box.low.y, box.low.x}, {box.high.y, box.high.x}};
  EXPECT_EQ(cover_order(boxes), in_order);
}

// Halves are made where the least or the greatest coordinates differ most: one long box does not part the others.
// A coordinate that is infinite for all tells nothing; the order is by the other axis.
TEST(CoverOrderTest, OfStrips) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  std::vector<Box2> strips, finite;
  for (std::uint32_t i = 0; i < 1024; ++i) {
    const double y = 2.0 * (i * 509 % 1024);
    strips.push_back({{-inf, y}, {inf, y + 1}});
    finite.push_back({{-1, y}, {1, y + 1}});
  }
  EXPECT_EQ(cover_order(strips), cover_order(finite));
}

TEST(CoverOrderTest, OfOneLongBox) {
  std::vector<Box2> boxes = row_of(1023, 2);
  boxes.push_back({{0, 0}, {1e6, 1}});
  EXPECT_LE(cover_looks(cover_order(boxes), boxes, {}, all_looks), 8u * 1024);
}

// Of members of a group that lie on each other, and would all be looked at, the group is one node.
TEST(CoverOrderTest, OfGroups) {
  std::vector<Box2> boxes;
  std::vector<std::uint32_t> crowds, pairs;
  for (std::uint32_t i = 0; i < 4096; ++i) {
    const double x = 0.001 * (i / 2) + (i % 2 == 0 ? 0 : 10);
    boxes.push_back({{x, 0}, {x + 3, 1}});
    crowds.push_back(i % 2);
    pairs.push_back(i / 2);
  }
  EXPECT_LE(cover_looks(cover_order(boxes, crowds), boxes, crowds, all_looks), 8u);
  EXPECT_GT(cover_looks(cover_order(boxes), boxes, {}, all_looks), 1000u * 4096);
  const std::vector<Box2> row = row_of(4096, 2);
  EXPECT_EQ(cover_order(row, pairs), cover_order(row));
}

}  // namespace
}  // namespace sunder
