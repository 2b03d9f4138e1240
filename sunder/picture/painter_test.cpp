#include <sunder/picture/painter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace sunder::picture {
namespace {

// A rectangle between two corners; depth grows to the right from `left_depth` to `right_depth`.
Piece rectangle(std::uint32_t part, double left, double top, double right, double bottom, double left_depth,
                double right_depth) {
  return {
      part,
      part,
      1,
      {{left, top, left_depth}, {right, top, right_depth}, {right, bottom, right_depth}, {left, bottom, left_depth}},
      std::vector<bool>(4, true)};
}

std::vector<std::uint32_t> parts_of(const std::vector<Piece>& pieces) {
  std::vector<std::uint32_t> parts;
  for (const Piece& piece : pieces) parts.push_back(piece.part);
  return parts;
}

TEST(Painter, NearerOnesComeLater) {
  const Piece far = rectangle(0, 0, 0, 4, 4, 0, 0), near = rectangle(1, 1, 1, 2, 2, 1, 1);
  EXPECT_EQ(parts_of(in_painters_order({near, far})), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(parts_of(in_painters_order({far, near})), (std::vector<std::uint32_t>{0, 1}));
}

TEST(Painter, TheMiddleDoesNotDecide) {
  // A long slope whose middle is farther than a small patch that it hides at its near end.
  const Piece slope = rectangle(0, 0, 0, 10, 1, 0, 10), patch = rectangle(1, 8, 0, 9, 1, 6, 6);
  EXPECT_EQ(parts_of(in_painters_order({slope, patch})), (std::vector<std::uint32_t>{1, 0}));
}

TEST(Painter, CrossingPiecesAreCut) {
  const Piece a = rectangle(0, 0, 0, 4, 4, 0, 4), b = rectangle(1, 0, 0, 4, 4, 4, 0);
  const std::vector<Piece> order = in_painters_order({a, b});
  ASSERT_EQ(order.size(), 3u);
  EXPECT_NE(order[0].part, order[1].part);  // one half behind the other piece, one before it
  EXPECT_EQ(order[0].part, order[2].part);
  for (const Piece& half : {order[0], order[2]}) {
    ASSERT_EQ(half.corners.size(), 4u);
    EXPECT_TRUE(half.is_cut);
    EXPECT_EQ(std::count(half.outline.begin(), half.outline.end(), false), 1);
    double low = 4, high = 0;
    for (const Seen& p : half.corners) {
      low = std::min(low, p.x);
      high = std::max(high, p.x);
    }
    EXPECT_NEAR(high - low, 2, 1e-9);
  }
}

TEST(Painter, OnePartIsNotCut) {
  const Piece a = rectangle(0, 0, 0, 4, 4, 0, 4), b = rectangle(0, 0, 0, 4, 4, 4, 0);
  EXPECT_EQ(in_painters_order({a, b}).size(), 2u);
}

double area(const Piece& piece) {
  double twice = 0;
  for (std::size_t i = 0; i < piece.corners.size(); ++i) {
    const Seen &p = piece.corners[i], &q = piece.corners[(i + 1) % piece.corners.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return std::fabs(twice) / 2;
}

TEST(Painter, NothingIsLost) {
  // Bars that cross each other, and hide each other in a circle.
  const auto bar = [](std::uint32_t part, double x0, double y0, double d0, double x1, double y1, double d1) {
    return Piece{part,
                 part,
                 1,
                 {{x0, y0, d0}, {x1, y1, d1}, {x1 + 0.3, y1 + 0.4, d1}, {x0 + 0.3, y0 + 0.4, d0}},
                 std::vector<bool>(4, false)};
  };
  const std::vector<Piece> bars{bar(0, 0, 0, 0, 4, 0, 2), bar(1, 4, -1, 0, 2, 4, 2), bar(2, 2, 4, 0, 0, -1, 2)};
  const std::vector<Piece> order = in_painters_order(bars);
  EXPECT_GT(order.size(), 3u);
  for (const Piece& whole : bars) {
    double sum = 0;
    for (const Piece& piece : order) sum += piece.part == whole.part ? area(piece) : 0;
    EXPECT_NEAR(sum, area(whole), 1e-9) << whole.part;
  }
}

TEST(Painter, LinesDotsAndNothing) {
  EXPECT_TRUE(in_painters_order({}).empty());
  const Piece line{0, 0, 1, {{0, 0, 5}, {4, 4, 5}}, {true, true}};
  const Piece dot{1, 1, 1, {{1, 1, 9}}, {true}};
  const Piece wall = rectangle(2, 0, 0, 4, 4, 7, 7);
  const std::vector<std::uint32_t> order = parts_of(in_painters_order({dot, wall, line}));
  EXPECT_EQ(order.front(), 0u);
  EXPECT_EQ(order.size(), 3u);
}

}  // namespace
}  // namespace sunder::picture
