#include <sunder/base/error.h>
#include <sunder/planar/object/convex_either_way.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace sunder::planar {
namespace {

using Points = std::vector<Point2>;

std::string refusal_either_way(const Points& vertices) {
  try {
    convex_either_way(vertices);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ConvexEitherWayTest, ClockwiseVerticesAreReversed) {
  const Points kite{{0, 0}, {2, -1}, {5, 0}, {2, 3}};
  EXPECT_FALSE(convex_either_way(kite).reversed);
  Points clockwise(kite.rbegin(), kite.rend());
  const EitherWay turned = convex_either_way(clockwise);
  EXPECT_TRUE(turned.reversed);
  ASSERT_EQ(turned.polygon.size(), 4u);
  for (std::uint32_t k = 0; k < 4; ++k) EXPECT_EQ(turned.polygon[k], clockwise[3 - k]) << k;
  EXPECT_FALSE(convex_either_way({{1, 2}}).reversed);
  EXPECT_FALSE(convex_either_way({{1, 2}, {0, 0}}).reversed);
}

// What is wrong is named by the vertex as it was given, in both directions.
TEST(ConvexEitherWayTest, FaultsKeepTheirNumbers) {
  const Points dented{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}, straight{{0, 0}, {2, 0}, {4, 0}, {4, 4}};
  EXPECT_EQ(refusal_either_way(dented).substr(0, 16), "vertex 3: reflex");
  EXPECT_EQ(refusal_either_way(straight).substr(0, 19), "vertex 1: collinear");
  EXPECT_EQ(refusal_either_way(Points(dented.rbegin(), dented.rend())).substr(0, 16), "vertex 1: reflex");
  EXPECT_EQ(refusal_either_way(Points(straight.rbegin(), straight.rend())).substr(0, 19), "vertex 2: collinear");
  EXPECT_NE(refusal_either_way({{0, 0}, {0, 1.0 / 0.0}, {1, 1}}), "accepted");
  EXPECT_NE(refusal_either_way({}), "accepted");
}

}  // namespace
}  // namespace sunder::planar
