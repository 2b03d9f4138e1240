#include <sunder/base/random.h>
#include <sunder/planar/object/edge_boxes.h>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace sunder::planar {
namespace {

// Of all sizes, and most of them no floats.
double coordinate(Random& random) {
  const double mantissa = static_cast<double>(random.between(-(std::int64_t{1} << 53), std::int64_t{1} << 53));
  return std::ldexp(mantissa, static_cast<int>(random.between(-1127, 970)) * static_cast<int>(random.below(2)));
}

bool holds(const LanesBox& outer, const LanesBox& inner) {
  return outer.low[0] <= inner.low[0] && outer.low[1] <= inner.low[1] && inner.high[0] <= outer.high[0] &&
         inner.high[1] <= outer.high[1];
}

bool are_equal(const LanesBox& a, const LanesBox& b) { return holds(a, b) && holds(b, a); }

TEST(EdgeBoxesTest, CoarseBoxesHoldTrueOnesAndNoMoreThanTheNextFloats) {
  Random random(1);
  for (int round = 0; round < 20000; ++round) {
    const LanesBox box =
        lanes_box_of(Point2{coordinate(random), coordinate(random)}, Point2{coordinate(random), coordinate(random)});
    const CoarseBox outer = coarse(box);
    EXPECT_TRUE(holds(outer.in_doubles(), box));
    const float low = std::nextafter(outer.left, std::numeric_limits<float>::infinity());
    const float high = std::nextafter(outer.top, -std::numeric_limits<float>::infinity());
    EXPECT_GT(static_cast<double>(low), box.low[0]);
    EXPECT_LT(static_cast<double>(high), box.high[1]);
  }
  const LanesBox floats = lanes_box_of(Point2{-1.5, 3}, Point2{0.25, -0x1p-149});
  EXPECT_TRUE(are_equal(coarse(floats).in_doubles(), floats));
}

// Each run's box holds its edges', and a box of the next level its runs'; what else there is meets nothing.
TEST(EdgeBoxesTest, RunsHoldTheirEdges) {
  Random random(2);
  const float infinite = std::numeric_limits<float>::infinity();
  const FourBoxes everything = FourBoxes::all({-infinite, infinite, -infinite, infinite});
  for (std::uint32_t size = 1; size < 300; size = size < 80 ? size + 1 : size + 37) {
    std::vector<LanesBox> edges;
    for (std::uint32_t k = 0; k < size; ++k) {
      edges.push_back(
          lanes_box_of(Point2{coordinate(random), coordinate(random)}, Point2{coordinate(random), coordinate(random)}));
    }
    const EdgeBoxes boxes(edges);
    std::uint32_t members = size;
    for (std::uint32_t l = 0; l <= boxes.top(); ++l) {
      const std::uint32_t runs = (members + EdgeBoxes::fan - 1) / EdgeBoxes::fan;
      for (std::uint32_t k = 0; k < members; ++k) {
        const LanesBox member = l == 0 ? edges[k] : boxes.box(l - 1, k).in_doubles();
        EXPECT_TRUE(holds(boxes.box(l, k / EdgeBoxes::fan).in_doubles(), member));
      }
      std::uint32_t counted = 0;
      for (const FourBoxes& four : boxes.level(l)) {
        const std::uint32_t bits = meeting(four, everything);
        EXPECT_EQ(bits & (bits + 1), 0u);  // the first ones
        counted += static_cast<std::uint32_t>(std::popcount(bits));
      }
      EXPECT_EQ(counted, runs);
      for (std::uint32_t k = 0; k < runs; ++k) {
        EXPECT_TRUE(holds(boxes.whole().in_doubles(), boxes.box(l, k).in_doubles()));
      }
      members = runs;
    }
    EXPECT_LE(members, EdgeBoxes::most);
    EXPECT_TRUE(boxes.top() == 0 || members * EdgeBoxes::fan > EdgeBoxes::most);
  }
}

TEST(EdgeBoxesTest, FourBoxesAtOnceMeetAsEachDoes) {
  Random random(3);
  const auto box = [&] {
    const auto some = [&] { return static_cast<double>(random.between(-3, 3)); };
    const double x = some(), y = some();
    return coarse(lanes_box_of(Point2{x, y}, Point2{x + some(), y + some()}));
  };
  int met = 0;
  for (int round = 0; round < 3000; ++round) {
    const CoarseBox one = box();
    FourBoxes four = FourBoxes::all(box());
    for (std::uint32_t k = 1; k < EdgeBoxes::fan; ++k) four.put(k, box());
    const std::uint32_t bits = meeting(four, FourBoxes::all(one));
    for (std::uint32_t k = 0; k < EdgeBoxes::fan; ++k) {
      const bool both = meet(four[k].in_doubles(), one.in_doubles());
      EXPECT_EQ((bits >> k & 1) != 0, both);
      met += both;
    }
  }
  EXPECT_GT(met, 2000);
  EXPECT_LT(met, 9000);
}

}  // namespace
}  // namespace sunder::planar
