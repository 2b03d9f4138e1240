// Properties of convex_polygons_any by number, and every method against the scan on small nasty sets.
#include <sunder/base/random.h>
#include <sunder/certificate/check.h>
#include <sunder/planar/polygons/convex_chains.h>
#include <sunder/planar/polygons/convex_polygons_any.h>
#include <tests/support/convex_polygon_sets.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace sunder::planar {
namespace {

using Polygons = std::vector<ConvexPolygon>;

ConvexPolygon hull(const std::vector<Point2>& points) { return ConvexPolygon::hull_of(points); }
ConvexPolygon box(double left, double bottom, double right, double top) {
  return ConvexPolygon::from_vertices(tests::box_ring(left, bottom, right, top));
}

CheckResult check_convex_pair(const PairCertificate& certificate, const ConvexPolygon& a, const ConvexPolygon& b) {
  const std::vector<Point3> in_a = tests::in_space(a), in_b = tests::in_space(b);
  const Affine3 in_place;
  return check_absolutely(certificate, {in_a, in_place, false}, {in_b, in_place, false});
}

using ConvexMethod = ConvexPolygonsAnswer(std::span<const ConvexPolygon>, const SetOptions&);
constexpr std::array<ConvexMethod*, 4> convex_methods{convex_polygons_any_by_scan, convex_polygons_any_by_sweep,
                                                      convex_polygons_any_by_grid, convex_polygons_any};

Relation convex_contact_in(const ConvexPolygonsAnswer& answer) {
  return answer.meet() ? answer.found->kind : Relation::none;
}

Relation convex_contact(const Polygons& polygons, Allowed allowed = Allowed::nothing) {
  const Relation by_scan = convex_contact_in(convex_polygons_any_by_scan(polygons, {allowed, {}, nullptr}));
  for (ConvexMethod* method : convex_methods) {
    const ConvexPolygonsAnswer answer = method(polygons, {allowed, {}, nullptr});
    EXPECT_EQ(answer.meet(), by_scan != Relation::none);
    if (polygons.size() == 2) {
      EXPECT_EQ(convex_contact_in(answer), by_scan);
    }
  }
  return by_scan;
}

TEST(ConvexPolygonsAny, KnownCases) {
  EXPECT_EQ(convex_contact({}), Relation::none);
  EXPECT_EQ(convex_contact({box(0, 0, 1, 1)}), Relation::none);
  EXPECT_EQ(convex_contact({box(0, 0, 1, 1), box(2, 0, 3, 1)}), Relation::none);
  EXPECT_EQ(convex_contact({box(0, 0, 1, 1), box(1, 0, 3, 1)}), Relation::touching);
  EXPECT_EQ(convex_contact({box(0, 0, 1, 1), box(1, 1, 3, 3)}), Relation::touching);
  EXPECT_EQ(convex_contact({box(0, 0, 1, 1), box(1, 0, 3, 1)}, Allowed::touch), Relation::none);
  EXPECT_EQ(convex_contact({box(0, 0, 4, 4), box(1, 1, 2, 2)}, Allowed::touch), Relation::overlapping);  // inside
  EXPECT_EQ(convex_contact({box(0, 0, 4, 4), box(0, 0, 4, 4)}, Allowed::touch), Relation::overlapping);
  EXPECT_EQ(convex_contact({box(0, 0, 4, 4), hull({{2, 2}})}, Allowed::touch), Relation::overlapping);
  EXPECT_EQ(convex_contact({box(0, 0, 4, 4), hull({{4, 2}})}), Relation::touching);
  EXPECT_EQ(convex_contact({hull({{1, 1}}), hull({{1, 1}})}, Allowed::touch), Relation::overlapping);  // equal points
  EXPECT_EQ(convex_contact({hull({{1, 1}}), hull({{0, 0}, {2, 2}})}, Allowed::touch), Relation::overlapping);
  EXPECT_EQ(convex_contact({hull({{2, 2}}), hull({{0, 0}, {2, 2}})}), Relation::touching);
  EXPECT_EQ(convex_contact({hull({{0, 0}, {2, 2}}), hull({{1, 1}, {3, 3}})}, Allowed::touch), Relation::overlapping);
  EXPECT_EQ(convex_contact({hull({{0, 0}, {2, 2}}), hull({{2, 2}, {3, 3}})}), Relation::touching);
  EXPECT_EQ(convex_contact({hull({{0, 0}, {2, 2}}), hull({{1, 1}, {3, 2}})}), Relation::touching);
}

// Where a point is, by orientations against all edges.
TEST(ConvexChains, HeightIsThatOfAllEdges) {
  Random random(5);
  std::array<int, 6> seen{};
  for (int k = 0; k < 3000; ++k) {
    std::vector<Point2> points(1 + random.below(9));
    for (Point2& p : points) p = {static_cast<double>(random.below(7)), static_cast<double>(random.below(7))};
    const ConvexPolygon polygon = hull(points);
    const Point2 p{static_cast<double>(random.below(7)), static_cast<double>(random.below(7))};
    const Point2 first = polygon[polygon.leftmost()], last = polygon[polygon.rightmost()];
    if (lexicographically_less(p, first) || lexicographically_less(last, p)) continue;
    std::uint64_t probes = 0;
    const Height height = height_of(p, polygon, probes);
    EXPECT_LE(static_cast<double>(probes), 2 * std::log2(polygon.size()) + 6);
    ++seen[static_cast<std::size_t>(height)];
    bool below = false, above = false, on_lower = polygon.size() == 1, on_upper = on_lower;
    for (std::uint32_t v = 0; polygon.size() > 1 && v < polygon.size(); ++v) {
      const Point2 &a = polygon[v], &b = polygon[(v + 1) % polygon.size()];
      const bool lower = lexicographically_less(a, b);
      const Segment edge = sorted({a, b});
      if (lexicographically_less(p, edge.a) || lexicographically_less(edge.b, p)) continue;
      const Sign side = orient_2d(edge.a, edge.b, p);
      (lower ? on_lower : on_upper) |= side == Sign::zero;
      below |= lower && side == Sign::negative;
      above |= !lower && side == Sign::positive;
    }
    EXPECT_EQ(height == Height::below, below);
    EXPECT_EQ(height == Height::above, above);
    EXPECT_EQ(height == Height::on_lower_chain, on_lower && !on_upper);
    EXPECT_EQ(height == Height::on_upper_chain, on_upper && !on_lower);
    EXPECT_EQ(height == Height::on_both_chains, on_upper && on_lower);
  }
  for (const int count : seen) EXPECT_GT(count, 50);
}

TEST(ConvexPolygonsAny, MethodsAgreeWithTheScan) {
  const int count = tests::scaled_count(6000);
  Random random(tests::chosen_seed(20261122));
  std::array<std::array<int, 2>, tests::convex_family_count> meet{};
  std::array<int, 3> contacts{};
  for (int k = 0; k < count; ++k) {
    const int family = k % tests::convex_family_count;
    const Polygons polygons = tests::some_convex_polygons(random, family);
    std::vector<std::uint32_t> groups;
    if (random.below(4) == 0) {
      for (std::size_t i = 0; i < polygons.size(); ++i) groups.push_back(static_cast<std::uint32_t>(random.below(3)));
    }
    for (const Allowed allowed : {Allowed::nothing, Allowed::touch}) {
      const SetOptions options{allowed, groups, nullptr};
      const bool some = convex_polygons_any_by_scan(polygons, options).meet();
      if (groups.empty()) meet[static_cast<std::size_t>(family)][allowed == Allowed::touch] += some;
      for (ConvexMethod* method : {convex_polygons_any_by_sweep, convex_polygons_any_by_grid}) {
        const ConvexPolygonsAnswer answer = method(polygons, options);
        ASSERT_EQ(answer.meet(), some) << k << " family " << family << " " << name_of(allowed);
        if (!answer.meet()) continue;
        ++contacts[static_cast<std::size_t>(answer.found->kind)];
        ASSERT_LT(answer.found->i, answer.found->j);
        ASSERT_LT(answer.found->j, polygons.size());
        ASSERT_FALSE(may_meet(groups, answer.found->i, answer.found->j));
        ASSERT_TRUE(counts(answer.found->kind, allowed));
        if (k % 4 != 0) continue;
        ASSERT_EQ(check_convex_pair(answer.found->evidence, polygons[answer.found->i], polygons[answer.found->j]),
                  CheckResult::accepted);
        const Polygons pair{polygons[answer.found->i], polygons[answer.found->j]};
        ASSERT_EQ(answer.found->kind, convex_polygons_any_by_scan(pair, {allowed, {}, nullptr}).found->kind);
      }
    }
  }
  std::printf("touching %d, overlapping %d\n", contacts[1], contacts[2]);
  for (std::size_t f = 0; f < tests::convex_family_count; ++f)
    std::printf("family %zu: %d %d\n", f, meet[f][0], meet[f][1]);
  if (count < 2000) return;
  for (const std::size_t contact : {1u, 2u}) EXPECT_GT(contacts[contact], count / 10);
  for (std::size_t f = 0; f < tests::convex_family_count; ++f) {
    const int of_family = count / tests::convex_family_count * 3 / 4;
    EXPECT_GT(meet[f][1], of_family / 20) << f;
    EXPECT_LT(meet[f][1], of_family - of_family / 20) << f;
    if (f != 1) {
      EXPECT_LT(meet[f][0], of_family - of_family / 50) << f;
    }
  }
}

}  // namespace
}  // namespace sunder::planar
