#include <sunder/solid/line/line_support_search.h>
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/line/polyhedron_line_support.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace sunder::solid {
namespace {

// From -1 to 1; vertex x + 2 y + 4 z of the signs.
const ConvexPolyhedron& support_cube() {
  static const ConvexPolyhedron cube([] {
    std::vector<Point3> points;
    for (int k = 0; k < 8; ++k) {
      points.push_back({k % 2 == 0 ? -1.0 : 1.0, k / 2 % 2 == 0 ? -1.0 : 1.0, k < 4 ? -1.0 : 1.0});
    }
    return points;
  }());
  return cube;
}

// The places of the vertices, in the order of the points.
std::vector<Point3> points_of(const CutFeature& feature) {
  std::vector<Point3> points;
  for (const std::uint32_t v : vertices_of(support_cube(), feature)) points.push_back(support_cube().vertices()[v]);
  return points;
}

std::array<LineSupport, 4> by_all(const Line& line) {
  const ConvexPolyhedron& cube = support_cube();
  return {polyhedron_line_support(cube, Pose(), line), polyhedron_line_support_by_drums(cube, Pose(), line),
          polyhedron_line_support_by_hierarchy(cube, Pose(), line),
          polyhedron_line_support_by_scan(cube, Pose(), line)};
}

// Is this coordinate of all points so much?
bool all_at(const std::vector<Point3>& points, std::size_t axis, double value) {
  for (const Point3& p : points) {
    if (p[axis] != value) return false;
  }
  return !points.empty();
}

TEST(LineSupport, BesideTheCube) {
  // Upwards, beyond a side: seen against its direction a half-plane turns from y = -1 to y = 1 ... around x = 3.
  for (const LineSupport& found : by_all(Line::through({3, 0, 0}, {3, 0, 1}))) {
    const auto& apart = std::get<SupportApart>(found.evidence);
    EXPECT_FALSE(found.meet());
    EXPECT_EQ(apart.first.touches.place, CutPlace::edge);
    EXPECT_EQ(apart.last.touches.place, CutPlace::edge);
    const auto first = points_of(apart.first.touches), last = points_of(apart.last.touches);
    EXPECT_TRUE(all_at(first, 0, 1) && all_at(first, 1, 1));
    EXPECT_TRUE(all_at(last, 0, 1) && all_at(last, 1, -1));
    EXPECT_EQ(apart.first.side, Sign::positive);
    EXPECT_EQ(apart.last.side, Sign::negative);
  }
  // In the plane of a facet, and across: a facet and a vertex.
  for (const LineSupport& found : by_all(Line::through({3, 0, 1}, {3, 1, 1.25}))) {
    const auto& apart = std::get<SupportApart>(found.evidence);
    EXPECT_EQ(apart.first.touches.place, CutPlace::vertex);
    EXPECT_EQ(apart.last.touches.place, CutPlace::vertex);
  }
  for (const LineSupport& found : by_all(Line::through({3, 0, 1}, {3, 1, 1}))) {
    const auto& apart = std::get<SupportApart>(found.evidence);
    const bool first_is_top = apart.first.touches.place == CutPlace::facet;
    EXPECT_TRUE(all_at(points_of((first_is_top ? apart.first : apart.last).touches), 2, 1));
    EXPECT_EQ((first_is_top ? apart.last : apart.first).touches.place, CutPlace::edge);
  }
}

TEST(LineSupport, AtAVertex) {
  for (const LineSupport& found : by_all(Line::through({1, 1, 1}, {2, 0, 1.25}))) {
    const auto& range = std::get<SupportRange>(found.evidence);
    EXPECT_TRUE(found.meet());
    EXPECT_EQ(points_of(range.at), std::vector<Point3>({{1, 1, 1}}));
    EXPECT_EQ(range.first.touches.place, CutPlace::edge);
    EXPECT_EQ(range.last.touches.place, CutPlace::edge);
    EXPECT_FALSE(range.first.touches == range.last.touches);
  }
  // In the plane of the top: that is one of the two.
  for (const LineSupport& found : by_all(Line::through({1, 1, 1}, {2, 0, 1}))) {
    const auto& range = std::get<SupportRange>(found.evidence);
    const bool first_is_top = range.first.touches.place == CutPlace::facet;
    EXPECT_TRUE(all_at(points_of((first_is_top ? range.first : range.last).touches), 2, 1));
  }
}

TEST(LineSupport, AlongAnEdge) {
  for (const LineSupport& found : by_all(Line::through({1, 1, 5}, {1, 1, 6}))) {
    const auto& range = std::get<SupportRange>(found.evidence);
    EXPECT_EQ(range.at.place, CutPlace::edge);
    EXPECT_TRUE(all_at(points_of(range.first.touches), 1, 1));
    EXPECT_TRUE(all_at(points_of(range.last.touches), 0, 1));
  }
}

TEST(LineSupport, AcrossAnEdgeAndInAFacet) {
  for (const LineSupport& found : by_all(Line::through({1, 1, 0}, {2, 0, 3}))) {
    const auto& only = std::get<SupportOnly>(found.evidence);
    EXPECT_EQ(only.plane.touches.place, CutPlace::edge);
    EXPECT_EQ(points_of(only.plane.touches).size(), 2u);
  }
  for (const Line& line : {Line::through({0, 0, 1}, {3, 1, 1}), Line::through({1, 1, 1}, {-1, -1, 1})}) {
    for (const LineSupport& found : by_all(line)) {
      EXPECT_TRUE(all_at(points_of(std::get<SupportOnly>(found.evidence).plane.touches), 2, 1));
    }
  }
}

TEST(LineSupport, ThroughTheInside) {
  for (const LineSupport& found : by_all(Line::through({0, 0, 0}, {1, 2, 3}))) {
    EXPECT_TRUE(std::holds_alternative<SupportNone>(found.evidence));
    EXPECT_EQ(name_of(found.evidence), "none");
    EXPECT_TRUE(planes_of(found.evidence).empty());
  }
}

// Lemma 12: of an edge at whose end the line touches the body, or along which it is; of a vertex where it goes along an
// edge, or on in a facet.
TEST(LineSupport, WhatIsKnownMayBeMore) {
  const ConvexPolyhedron& cube = support_cube();
  const auto vertex = [&](const Point3& p) {
    for (std::uint32_t v = 0;; ++v) {
      if (cube.vertices()[v] == p) return v;
    }
  };
  const std::uint32_t corner = vertex({1, 1, 1}), below = vertex({1, 1, -1});
  const CutFeature edge{CutPlace::edge, std::min(corner, below), std::max(corner, below)};
  const CutFeature at{CutPlace::vertex, corner, 0};
  const auto known = [&](const Line& line, const CutFeature& feature) {
    return planes_of_support_at(cube, Pose(), line, feature).evidence;
  };
  const Line along = Line::through({1, 1, 5}, {1, 1, 6}), touching = Line::through({1, 1, 1}, {2, 0, 1.25}),
             in_top = Line::through({1, 1, 1}, {-1, -1, 1}), across = Line::through({1, 1, 0}, {2, 0, 3});
  EXPECT_EQ(std::get<SupportRange>(known(along, edge)).at, edge);
  EXPECT_EQ(std::get<SupportRange>(known(along, at)).at, edge);
  EXPECT_EQ(std::get<SupportRange>(known(touching, edge)).at, at);
  EXPECT_EQ(std::get<SupportRange>(known(touching, at)).at, at);
  EXPECT_TRUE(all_at(points_of(std::get<SupportOnly>(known(in_top, at)).plane.touches), 2, 1));
  EXPECT_TRUE(all_at(points_of(std::get<SupportOnly>(known(in_top, edge)).plane.touches), 2, 1));
  EXPECT_EQ(std::get<SupportOnly>(known(across, edge)).plane.touches, edge);
}

// Two pyramids on a polygon of 48 corners: at their tops there are more edges than are looked at one by one.
TEST(LineSupport, HoldsOfExtremeVerticesAlone) {
  std::vector<Point3> points{{0, 0, 1}, {0, 0, -1}};
  for (int k = 0; k < 48; ++k) {
    const double angle = 2 * std::numbers::pi * k / 48;
    points.push_back({std::cos(angle), std::sin(angle), 0});
  }
  const ConvexPolyhedron body(points);
  int held = 0, refused = 0;
  for (const double z : {1.0, -1.0}) {  // as it is, and mirrored
    const Pose pose = Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, z}, {0, 0, 0});
    const Placed placed(body, pose);
    for (int k = 0; k < 24; ++k) {
      const double angle = std::numbers::pi * k / 12;
      const Line line = Line::through({2 * std::cos(angle), 0.1, 2 * std::sin(angle)}, {0.3, 3, 1.5});
      if (polyhedron_line(body, pose, line).meet()) continue;
      LineSupportSearch search(placed, line);
      for (const Sign side : {Sign::positive, Sign::negative}) {
        for (std::uint32_t v = 0; v < points.size(); ++v) {
          bool is_extreme = true;
          for (std::uint32_t w = 0; w < points.size(); ++w) is_extreme &= search.past(v, w) != -side;
          ASSERT_EQ(search.holds(side, v), is_extreme) << k << ' ' << v;
          if (body.neighbours(v).size() == 48) ++(is_extreme ? held : refused);
        }
      }
    }
  }
  EXPECT_GT(held, 10);
  EXPECT_GT(refused, 10);
}

}  // namespace
}  // namespace sunder::solid
