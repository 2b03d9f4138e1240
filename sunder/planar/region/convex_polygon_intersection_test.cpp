#include <sunder/base/random.h>
#include <sunder/planar/region/convex_polygon_intersection.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace sunder::planar {
namespace {

using tests::regular_polygon, tests::shuffle;

using PartKind = PolygonsPartKind;
using Polygons = std::vector<ConvexPolygon>;
using Points = std::vector<Point2>;

ConvexPolygon polygon(Points points) { return ConvexPolygon::from_vertices(std::move(points)); }

Points rounded(const Polygons& set, const PolygonsPart& part) {
  Points out;
  for (const PolygonsCorner& c : part.corners) {
    const ExactPoint2 p = exact_point(corner_point(set, c));
    out.push_back({nearest_ratio(p.x, p.denominator), nearest_ratio(p.y, p.denominator)});
  }
  return out;
}

PolygonsPart common_part(const Polygons& set) {
  const PolygonsPart front = convex_polygon_intersection(set);
  for (const auto method : {convex_polygon_intersection_by_division, convex_polygon_intersection_by_edges,
                            convex_polygon_intersection_by_batches, convex_polygon_intersection_by_scan}) {
    const PolygonsPart other = method(set);
    EXPECT_EQ(other.kind, front.kind);
    EXPECT_EQ(rounded(set, other), rounded(set, front));
    EXPECT_EQ(other.kind == PartKind::empty, is_contradiction(set, other.supports()));
  }
  return front;
}
Points points(const Polygons& set) { return rounded(set, common_part(set)); }
PartKind kind(const Polygons& set) { return common_part(set).kind; }

TEST(ConvexPolygonsTest, FewPolygons) {
  const ConvexPolygon square = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}),
                      diamond = polygon({{-1, 2}, {2, -1}, {5, 2}, {2, 5}});
  EXPECT_EQ(kind({}), PartKind::plane);
  EXPECT_EQ(points({square}), (Points{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  EXPECT_EQ(points({square, square}), (Points{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  EXPECT_EQ(points({square, diamond}), (Points{{0, 1}, {1, 0}, {3, 0}, {4, 1}, {4, 3}, {3, 4}, {1, 4}, {0, 3}}));
  EXPECT_EQ(points({square, polygon({{4, 1}, {6, 0}, {6, 3}})}), (Points{{4, 1}}));
  EXPECT_EQ(points({square, polygon({{4, 1}, {6, 1}, {6, 3}, {4, 3}})}), (Points{{4, 1}, {4, 3}}));
  EXPECT_EQ(points({square, polygon({{1, 4}, {3, 4}, {2, 6}})}), (Points{{1, 4}, {3, 4}}));
  EXPECT_EQ(points({square, polygon({{2, 4}, {3, 6}, {1, 6}})}), (Points{{2, 4}}));
  EXPECT_EQ(points({square, polygon({{1, -2}, {3, -2}, {2, 0}})}), (Points{{2, 0}}));
  EXPECT_EQ(kind({square, polygon({{5, 1}, {6, 0}, {6, 3}})}), PartKind::empty);
  EXPECT_EQ(kind({square, polygon({{1, 5}, {3, 5}, {2, 6}})}), PartKind::empty);
  EXPECT_EQ(points({polygon({{0, 0}, {3, 0}, {0, 3}}), polygon({{1, 1}, {3, 3}, {1, 3}})}),
            (Points{{1, 1}, {1.5, 1.5}, {1, 2}}));
}

TEST(ConvexPolygonsTest, NamesOfCorners) {
  const Polygons set{polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), polygon({{2, 1}, {6, 1}, {6, 3}, {2, 3}})};
  const PolygonsPart part = common_part(set);
  const std::vector<PolygonsCorner> expected{
      {true, {1, 0}, {}}, {false, {1, 0}, {0, 1}}, {false, {0, 1}, {1, 2}}, {true, {1, 3}, {}}};
  EXPECT_EQ(part.corners, expected);
  // Of edges in one line, that of the lowest polygon.
  const Polygons turned{set[0], polygon({{0, 1}, {4, 1}, {4, 5}, {0, 5}})};
  const std::vector<PolygonsCorner> of_lowest{
      {false, {0, 3}, {1, 0}}, {false, {1, 0}, {0, 1}}, {true, {0, 2}, {}}, {true, {0, 3}, {}}};
  EXPECT_EQ(common_part(turned).corners, of_lowest);
}

TEST(ConvexPolygonsTest, PointsAndSegments) {
  const ConvexPolygon square = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  EXPECT_EQ(points({square, polygon({{1, 2}})}), (Points{{1, 2}}));
  EXPECT_EQ(points({square, polygon({{4, 4}})}), (Points{{4, 4}}));
  EXPECT_EQ(kind({square, polygon({{5, 2}})}), PartKind::empty);
  EXPECT_EQ(kind({square, polygon({{2, 5}})}), PartKind::empty);
  EXPECT_EQ(kind({polygon({{2, 1}}), polygon({{2, 2}})}), PartKind::empty);
  EXPECT_EQ(points({polygon({{2, 1}}), polygon({{2, 1}}), square}), (Points{{2, 1}}));
  EXPECT_EQ(points({square, polygon({{-1, 1}, {6, 1}})}), (Points{{0, 1}, {4, 1}}));
  EXPECT_EQ(points({square, polygon({{2, -1}, {2, 9}})}), (Points{{2, 0}, {2, 4}}));
  EXPECT_EQ(points({polygon({{0, 0}, {2, 2}}), polygon({{1, 1}, {5, 5}})}), (Points{{1, 1}, {2, 2}}));
  EXPECT_EQ(points({polygon({{0, 0}, {2, 2}}), polygon({{2, 2}, {5, 5}})}), (Points{{2, 2}}));
  EXPECT_EQ(points({polygon({{0, 0}, {2, 2}}), polygon({{0, 2}, {2, 0}})}), (Points{{1, 1}}));
  EXPECT_EQ(points({polygon({{0, 0}, {0, 2}}), polygon({{0, 1}, {0, 4}})}), (Points{{0, 1}, {0, 2}}));
  EXPECT_EQ(kind({polygon({{0, 0}, {0, 2}}), polygon({{0, 3}, {0, 4}})}), PartKind::empty);
  EXPECT_EQ(kind({polygon({{0, 0}, {1, 1}}), polygon({{2, 2}, {5, 5}})}), PartKind::empty);
  EXPECT_EQ(kind({polygon({{0, 0}, {4, 4}}), polygon({{1, 0}, {4, 3}})}), PartKind::empty);  // parallel
  EXPECT_EQ(kind({polygon({{0, 0}, {0, 9}}), polygon({{-1, 1}, {1, 3}}), polygon({{-1, 3}, {1, 2}})}), PartKind::empty);
  const double largest = 1.7976931348623157e308;
  EXPECT_EQ(points({polygon({{largest, 0}, {largest, 2}}), polygon({{0, 1}, {largest, 1}})}), (Points{{largest, 1}}));
}

// Three that meet two by two: nothing, a point, a triangle as wide as a unit in the last place.
TEST(ConvexPolygonsTest, LastBit) {
  for (const double scale : {1.0, 0x1p-1000, 0x1p1000}) {
    const auto set = [&](double y) {
      return Polygons{polygon({{-4 * scale, -4 * scale}, {4 * scale, -4 * scale}, {4 * scale, 4 * scale}}),   // y <= x
                      polygon({{-4 * scale, 4 * scale}, {-4 * scale, -4 * scale}, {4 * scale, -4 * scale}}),  // y <= -x
                      polygon({{-4 * scale, y}, {4 * scale, y}, {0, 4 * scale}})};
    };
    EXPECT_EQ(kind(set(0)), PartKind::point);
    EXPECT_EQ(kind(set(5e-324)), PartKind::empty);
    EXPECT_EQ(kind(set(-5e-324)), PartKind::polygon);
  }
}

TEST(ConvexPolygonsTest, UntrueContradictionsAreRefused) {
  const Polygons set{polygon({{0, 0}, {2, 0}, {1, 1}}), polygon({{0, 2}, {2, 1}, {1, 2}})};
  const PolygonsPart part = common_part(set);
  ASSERT_EQ(part.kind, PartKind::empty);
  ASSERT_TRUE(is_contradiction(set, part.supports()));
  const auto is_refused = [&](const auto& change) {
    PolygonsPart other = part;
    change(other);
    return !is_contradiction(set, other.supports());
  };
  EXPECT_TRUE(is_refused([](PolygonsPart& p) { --p.contradiction_size; }));
  for (std::uint32_t k = 0; k < part.contradiction_size; ++k) {
    EXPECT_TRUE(is_refused([&](PolygonsPart& p) { std::swap(p.contradiction[k].from, p.contradiction[k].to); })) << k;
    EXPECT_TRUE(is_refused([&](PolygonsPart& p) { p.contradiction[k].vertex.polygon = 2; })) << k;
    EXPECT_TRUE(is_refused([&](PolygonsPart& p) { p.contradiction[k].vertex.number = 3; })) << k;
    EXPECT_TRUE(is_refused([&](PolygonsPart& p) { p.contradiction[k].to = p.contradiction[k].from; })) << k;
  }
  EXPECT_FALSE(is_contradiction({}, {}));
}

// Both boundaries break at one abscissa, and edges there are parallel: two supports do, and no third is named.
TEST(ConvexPolygonsTest, ContradictionsAreMinimal) {
  const Polygons above{polygon({{1, 0}, {2, 0}, {4, 1}, {2, 1}}), polygon({{0, 3}, {2, 3}, {3, 4}})};
  EXPECT_EQ(common_part(above).contradiction_size, 2u);
  const Polygons below{polygon({{1, 0}, {2, -1}, {4, -1}, {2, 0}}), polygon({{0, -3}, {3, -4}, {2, -3}})};
  EXPECT_EQ(common_part(below).kind, PartKind::empty);
}

// Wedges end where another polygon does, on a slanted edge: wherever in the order that one comes.
TEST(ConvexPolygonsTest, OnePolygonBoundsManyWedges) {
  const ConvexPolygon wedge = polygon({{0, 0}, {10, -1}, {10, 1}}),
                      last = polygon({{-1, -5}, {3, -5}, {4, 5}, {-1, 5}}),
                      to_the_left = polygon({{0, 0}, {-10, 1}, {-10, -1}}),
                      first = polygon({{1, -5}, {1, 5}, {-4, 5}, {-3, -5}});
  for (std::size_t at = 0; at < 60; ++at) {
    Polygons set(60, wedge), mirrored(60, to_the_left);
    set[at] = last;
    mirrored[at] = first;
    for (const Polygons& each : {set, mirrored}) {
      const PolygonsPart part = convex_polygon_intersection_by_division(each);
      EXPECT_EQ(part.corners.size(), 3u);
      EXPECT_EQ(convex_polygon_intersection_by_batches(each).corners, part.corners) << at;
    }
  }
}

TEST(ConvexPolygonsTest, Symmetries) {
  Random random(17);
  std::size_t polygons = 0;
  for (int i = 0; i < 1500; ++i) {
    std::vector<Points> given;
    for (std::int64_t n = random.between(1, 6); n > 0; --n) {
      given.emplace_back();
      for (std::int64_t k = random.between(3, 8); k > 0; --k) {
        given.back().push_back({random.uniform(-1, 1), random.uniform(-1, 1)});
      }
    }
    const auto part_of = [&](const auto& change) {
      Polygons set;
      for (const Points& p : given) {
        Points changed;
        for (const Point2& v : p) changed.push_back(change(v));
        set.push_back(ConvexPolygon::hull_of(changed));
      }
      return rounded(set, convex_polygon_intersection(set));
    };
    const auto sorted = [](Points p) {
      std::sort(p.begin(), p.end(),
                [](const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
      return p;
    };
    const Points part = part_of([](const Point2& v) { return v; });
    polygons += part.size() > 2;
    Points expected;
    for (const Point2& v : part) expected.push_back({-v.y * 4, v.x * 4});
    ASSERT_EQ(sorted(part_of([](const Point2& v) { return Point2{-v.y * 4, v.x * 4}; })), sorted(expected)) << i;
    expected.clear();
    for (const Point2& v : part) expected.push_back({v.x, -v.y});
    ASSERT_EQ(sorted(part_of([](const Point2& v) { return Point2{v.x, -v.y}; })), sorted(expected)) << i;
    std::reverse(given.begin(), given.end());
    ASSERT_EQ(part_of([](const Point2& v) { return v; }), part) << i;
  }
  EXPECT_GT(polygons, 300u);
}

// Theorem 14: a constant times N k log N, whether few edges bound the part or all of them do; with batches the first
// ones take about N k. All methods agree on large sets.
TEST(ConvexPolygonsTest, ProbesGrowAsTheTheoremSays) {
  constexpr std::uint32_t k = 8;
  for (std::uint32_t n = 1u << 4; n <= 1u << 14; n *= 4) {
    Random random(n);
    Polygons few, all, none;
    for (std::uint32_t i = 0; i < n; ++i) {
      const Point2 near{random.uniform(-1, 1), random.uniform(-1, 1)};
      few.push_back(regular_polygon(k, random.uniform(1.7, 3), random.uniform(0, 7), near));
      none.push_back(regular_polygon(k, random.uniform(1.2, 3), random.uniform(0, 7), near));
      all.push_back(regular_polygon(k, 1, 6.283185307179586 / k * (i + 0.4 * random.unit()) / n, {0, 0}));
    }
    shuffle(all, random);
    const double edges = k * n, bound = edges * (1.2 * std::log2(n) + 4);
    const PolygonsPart few_left = convex_polygon_intersection_by_division(few),
                       all_left = convex_polygon_intersection_by_division(all);
    EXPECT_EQ(few_left.kind, PartKind::polygon);
    EXPECT_LT(few_left.corners.size(), 60u);
    EXPECT_EQ(all_left.corners.size(), k * n);
    EXPECT_LE(static_cast<double>(few_left.cost.probes), bound) << n;
    EXPECT_LE(static_cast<double>(all_left.cost.probes), bound) << n;
    const PolygonsPart fast = convex_polygon_intersection_by_batches(few);
    EXPECT_EQ(fast.corners, few_left.corners);
    EXPECT_LE(static_cast<double>(fast.cost.probes), 1.5 * edges + 8000) << n;
    const PolygonsPart all_by_batches = convex_polygon_intersection_by_batches(all);
    EXPECT_EQ(all_by_batches.corners, all_left.corners);
    EXPECT_LE(static_cast<double>(all_by_batches.cost.probes), bound + 6 * edges) << n;
    const PolygonsPart of_edges = convex_polygon_intersection_by_edges(few);
    EXPECT_EQ(of_edges.corners, few_left.corners);
    EXPECT_LE(static_cast<double>(of_edges.cost.probes), edges * (1.2 * std::log2(edges) + 4)) << n;
    for (const auto method : {convex_polygon_intersection_by_division, convex_polygon_intersection_by_batches}) {
      const PolygonsPart part = method(none);
      EXPECT_EQ(part.kind == PartKind::empty, part.corners.empty());
      if (n < 1000) continue;
      EXPECT_EQ(part.kind, PartKind::empty);
      EXPECT_TRUE(is_contradiction(none, part.supports()));
    }
  }
}

}  // namespace
}  // namespace sunder::planar
