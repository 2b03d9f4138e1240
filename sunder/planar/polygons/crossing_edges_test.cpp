// Known cases of overlap_at_crossing. (What follows for polygons: polygons_any_test.cpp and
// tests/planar/polygons_differential_test.cpp.)
#include <sunder/planar/polygons/crossing_edges.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sunder::planar {
namespace {

using Ring = std::vector<Point2>;
using Rings = std::vector<Ring>;

// Edge 0 of the first one and edge 0 of the second one cross.
bool overlap(const Rings& a, const Rings& b) {
  const Polygon of_a(a), of_b(b);
  std::uint64_t probes = 0;
  const bool forward = overlap_at_crossing(of_a, 0, of_b, 0, probes);
  EXPECT_EQ(probes > 0, !of_a.strictly_convex() && !of_b.strictly_convex());
  EXPECT_EQ(overlap_at_crossing(of_b, 0, of_a, 0, probes), forward);
  return forward;
}

const Ring upper{{-8, 0}, {8, 0}, {0, 8}}, right{{0, -8}, {0, 8}, {8, 0}};
const Ring notch_up{{0, 0}, {2, 4}, {-2, 4}}, notch_right{{0, 0}, {4, -2}, {4, 2}};

TEST(CrossingEdges, OnlyVerticesOfBothInThePointLeaveItOpen) {
  EXPECT_TRUE(overlap({upper}, {right}));
  EXPECT_TRUE(overlap({upper, notch_up}, {right}));
  EXPECT_TRUE(overlap({upper}, {right, notch_right}));
  EXPECT_FALSE(overlap({upper, notch_up}, {right, notch_right}));
  // Of the same ring, and elsewhere in it.
  EXPECT_FALSE(overlap({{{-8, 0}, {8, 0}, {8, 8}, {2, 4}, {0, 0}, {-2, 4}, {-8, 8}}}, {right, notch_right}));
  // Near to it.
  const double least = 0x1p-1074;
  EXPECT_TRUE(overlap({upper, {{0, least}, {2, 4}, {-2, 4}}}, {right, notch_right}));
  EXPECT_TRUE(overlap({upper, notch_up}, {right, {{least, 0}, {4, -2}, {4, 2}}}));
}

// Of any scale; and where the point is no double, but has vertices around it, as near as can be.
TEST(CrossingEdges, VerticesAreTheExactPoint) {
  for (const int scale : {-1070, 1015}) {
    std::vector<Rings> both{{upper, notch_up}, {right, notch_right}};
    for (Rings& rings : both) {
      for (Ring& ring : rings) {
        for (Point2& p : ring) p = {std::ldexp(p.x, scale), std::ldexp(p.y, scale)};
      }
    }
    EXPECT_FALSE(overlap(both[0], both[1]));
  }
  const double third = 1.0 / 3;
  const Ring falling{{0, 1}, {1, -1}, {1, 1}}, rising{{0, 0}, {1, 1}, {0, 1}};  // they cross in (1/3, 1/3)
  EXPECT_TRUE(overlap({falling, {{third, third}, {0.75, 0.5}, {0.5, 0.75}}},
                      {rising, {{third, third}, {0.125, 0.5}, {0.125, 0.75}}}));
}

// Many vertices, of which those near the point are found through the boxes.
TEST(CrossingEdges, OfManyVerticesFewAreLookedAt) {
  Ring saw{{-4096, 0}, {4096, 0}};
  for (int k = 4095; k > -4096; --k) saw.push_back({static_cast<double>(k), k == 0 ? 0.0 : k % 2 == 0 ? 1.0 : 2.0});
  const Polygon a(Rings{saw}), b(Rings{right, notch_right}), c(Rings{{{1, -8}, {1, 8}, {8, 0}}});
  std::uint64_t probes = 0;
  EXPECT_FALSE(overlap_at_crossing(a, 0, b, 0, probes));
  EXPECT_TRUE(overlap_at_crossing(a, 0, c, 0, probes));
  EXPECT_LE(probes, 400u);
}

// Many vertices within the boxes of both edges: chains beside diagonals, of which one vertex of each may be on both.
TEST(CrossingEdges, ManyVerticesWithinTheBoxesOfBothEdges) {
  const auto chain = [](bool falls, bool touches) {
    Ring ring{{0, 0}, {64, 64}};
    for (int k = 63; k > 0; --k) {
      const double x = k;
      ring.push_back({x, k == 32 && touches ? x : x - 1});
    }
    for (Point2& p : ring) p.y = falls ? 64 - p.y : p.y;
    return Polygon(Rings{ring});
  };
  for (const bool first : {false, true}) {
    for (const bool second : {false, true}) {
      std::uint64_t probes = 0;
      EXPECT_EQ(overlap_at_crossing(chain(false, first), 0, chain(true, second), 0, probes), !first || !second);
    }
  }
}

}  // namespace
}  // namespace sunder::planar
