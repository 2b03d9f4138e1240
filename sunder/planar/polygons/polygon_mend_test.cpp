// What mend changes of rings, and what it leaves.
#include <sunder/planar/polygons/polygon_mend.h>

#include <gtest/gtest.h>

#include <vector>

namespace sunder::planar {
namespace {

using Ring = std::vector<Point2>;

TEST(PolygonMend, WholeRingsStay) {
  const PolygonRings whole{{{0, 0}, {9, 0}, {9, 9}, {0, 0}}, {{5, 1}, {8, 4}, {8, 1}, {5, 1}}};
  PolygonRings rings = whole;
  EXPECT_EQ(mend(rings).all(), 0u);
  EXPECT_EQ(rings, whole);
}

TEST(PolygonMend, RingsAreClosedAndRidOfSpikesAndRepeatedVertices) {
  PolygonRings rings{{{0, 0}, {2, 0}, {4, 0}, {4, 0}, {4, 4}, {4, 6}, {4, 4}, {0, 4}}};  // a spike up from (4, 4)
  const MendedRings mended = mend(rings);
  EXPECT_EQ(rings, (PolygonRings{{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}}));
  EXPECT_EQ(mended.closed, 1u);
  EXPECT_EQ(mended.spikes, 1u);
  EXPECT_EQ(mended.repeated, 2u);
  EXPECT_EQ(mended.left_out, 0u);
}

TEST(PolygonMend, ASpikeMayBeWhereTheRingBegins) {
  PolygonRings rings{{{-3, 0}, {0, 0}, {4, 0}, {4, 4}, {0, 0}, {-3, 0}}};
  EXPECT_GT(mend(rings).spikes, 0u);
  EXPECT_EQ(rings, (PolygonRings{{{0, 0}, {4, 0}, {4, 4}, {0, 0}}}));
}

TEST(PolygonMend, RingsWithoutAreaAreLeftOut) {
  const Ring shell{{0, 0}, {9, 0}, {9, 9}, {0, 0}}, line{{5, 1}, {6, 1}, {5, 1}};
  PolygonRings with_hole{shell, line};
  EXPECT_EQ(mend(with_hole).left_out, 1u);
  EXPECT_EQ(with_hole, PolygonRings{shell});
  PolygonRings without_shell{line, shell};  // with the shell go its holes
  EXPECT_EQ(mend(without_shell).left_out, 2u);
  EXPECT_TRUE(without_shell.empty());
}

TEST(PolygonMend, CrossingsStay) {
  const PolygonRings hourglass{{{0, 0}, {4, 4}, {4, 0}, {0, 4}, {0, 0}}};
  PolygonRings rings = hourglass;
  EXPECT_EQ(mend(rings).all(), 0u);
  EXPECT_EQ(rings, hourglass);
}

TEST(PolygonMend, RepeatedVerticesAreLeftOutAllAround) {
  Ring open{{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 0}, {0, 0}};
  leave_out_repeated(open);
  EXPECT_EQ(open, (Ring{{0, 0}, {4, 0}, {4, 4}, {0, 0}}));  // it was closed, and stays so
  Ring same{{1, 1}, {1, 1}};
  leave_out_repeated(same);
  EXPECT_EQ(same, (Ring{{1, 1}}));
}

}  // namespace
}  // namespace sunder::planar
