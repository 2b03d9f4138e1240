// Properties of convex_polygons_any by number, and every method against the scan on small nasty sets.
#include <sunder/base/random.h>
#include <sunder/certificate/check.h>
#include <sunder/planar/set/convex_chains.h>
#include <sunder/planar/set/convex_polygons_any.h>
#include <tests/support/scale.h>

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
  return ConvexPolygon::from_vertices({{left, bottom}, {right, bottom}, {right, top}, {left, top}});
}

CheckResult check(const PairCertificate& certificate, const ConvexPolygon& a, const ConvexPolygon& b) {
  const auto in_space = [](const ConvexPolygon& p) {
    std::vector<Point3> vertices;
    for (const Point2& v : p.vertices()) vertices.push_back({v.x, v.y, 0});
    return vertices;
  };
  const std::vector<Point3> in_a = in_space(a), in_b = in_space(b);
  const Affine3 in_place;
  return check_absolutely(certificate, {in_a, in_place, false}, {in_b, in_place, false});
}

using Method = ConvexPolygonsAnswer(std::span<const ConvexPolygon>, const SetOptions&);
constexpr std::array<Method*, 4> methods{convex_polygons_any_by_scan, convex_polygons_any_by_sweep,
                                         convex_polygons_any_by_grid, convex_polygons_any};

Contact contact_in(const ConvexPolygonsAnswer& answer) { return answer.meet() ? answer.found->kind : Contact::none; }

Contact contact(const Polygons& polygons, Allowed allowed = Allowed::nothing) {
  const Contact by_scan = contact_in(convex_polygons_any_by_scan(polygons, {allowed, {}, nullptr}));
  for (Method* method : methods) {
    const ConvexPolygonsAnswer answer = method(polygons, {allowed, {}, nullptr});
    EXPECT_EQ(answer.meet(), by_scan != Contact::none);
    if (polygons.size() == 2) {
      EXPECT_EQ(contact_in(answer), by_scan);
    }
  }
  return by_scan;
}

TEST(ConvexPolygonsAny, KnownCases) {
  EXPECT_EQ(contact({}), Contact::none);
  EXPECT_EQ(contact({box(0, 0, 1, 1)}), Contact::none);
  EXPECT_EQ(contact({box(0, 0, 1, 1), box(2, 0, 3, 1)}), Contact::none);
  EXPECT_EQ(contact({box(0, 0, 1, 1), box(1, 0, 3, 1)}), Contact::touching);
  EXPECT_EQ(contact({box(0, 0, 1, 1), box(1, 1, 3, 3)}), Contact::touching);
  EXPECT_EQ(contact({box(0, 0, 1, 1), box(1, 0, 3, 1)}, Allowed::touch), Contact::none);
  EXPECT_EQ(contact({box(0, 0, 4, 4), box(1, 1, 2, 2)}, Allowed::touch), Contact::overlapping);  // inside
  EXPECT_EQ(contact({box(0, 0, 4, 4), box(0, 0, 4, 4)}, Allowed::touch), Contact::overlapping);
  EXPECT_EQ(contact({box(0, 0, 4, 4), hull({{2, 2}})}, Allowed::touch), Contact::overlapping);
  EXPECT_EQ(contact({box(0, 0, 4, 4), hull({{4, 2}})}), Contact::touching);
  EXPECT_EQ(contact({hull({{1, 1}}), hull({{1, 1}})}, Allowed::touch), Contact::overlapping);  // equal points
  EXPECT_EQ(contact({hull({{1, 1}}), hull({{0, 0}, {2, 2}})}, Allowed::touch), Contact::overlapping);
  EXPECT_EQ(contact({hull({{2, 2}}), hull({{0, 0}, {2, 2}})}), Contact::touching);
  EXPECT_EQ(contact({hull({{0, 0}, {2, 2}}), hull({{1, 1}, {3, 3}})}, Allowed::touch), Contact::overlapping);
  EXPECT_EQ(contact({hull({{0, 0}, {2, 2}}), hull({{2, 2}, {3, 3}})}), Contact::touching);
  EXPECT_EQ(contact({hull({{0, 0}, {2, 2}}), hull({{1, 1}, {3, 2}})}), Contact::touching);
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

// Small sets: of hulls on a grid, of triangles and squares of a tessellation, nested, slivers, of all scales.
Polygons some_polygons(Random& random, int family) {
  Polygons polygons;
  const auto at = [&](std::uint64_t side) { return static_cast<double>(random.below(side)); };
  const std::size_t count = 2 + random.below(7);
  switch (family) {
    case 0:
      for (std::size_t k = 0; k < count; ++k) {  // small ones on a larger grid
        const double x = at(12), y = at(12);
        std::vector<Point2> points(1 + random.below(5));
        for (Point2& p : points) p = {x + at(4), y + at(4)};
        polygons.push_back(hull(points));
      }
      break;
    case 1:  // parts of the plane that share sides and corners, and some more
      for (double x = 0; x < 3; ++x) {
        for (double y = 0; y < 3; ++y) {
          const std::array<Point2, 4> corners{{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
          const std::size_t first = random.below(2);
          for (const std::size_t from : {first, first + 2}) {
            if (random.below(3) == 0) continue;
            polygons.push_back(hull({corners[from], corners[(from + 1) % 4], corners[(from + 2) % 4]}));
          }
          if (random.below(9) == 0) polygons.push_back(hull({corners[first], corners[first + 1]}));
          if (random.below(9) == 0) polygons.push_back(hull({corners[first]}));
        }
      }
      if (random.below(4) == 0) {
        polygons.push_back(hull({{at(7) / 2, at(7) / 2}, {at(7) / 2, at(7) / 2}, {at(7) / 2, at(7) / 2}}));
      }
      break;
    case 2:  // slivers through a small grid, nearly parallel
      for (std::size_t k = 0; k < count; ++k) {
        const double y = at(40);
        polygons.push_back(hull({{at(3), y}, {20 + at(3), y + at(4)}, {10 + at(3), y + at(3)}}));
      }
      break;
    case 3:  // one on or next to a vertex or edge of another one, to the last bit
      for (std::size_t k = 0; k < 2 + count / 3; ++k) {
        std::vector<Point2> points(1 + random.below(4));
        for (Point2& p : points) p = {random.uniform(-3, 3), random.uniform(-3, 3)};
        if (k > 0) {
          const ConvexPolygon& other = polygons.back();
          const Point2 p = other[static_cast<std::uint32_t>(random.below(other.size()))];
          const double right = 4 * static_cast<double>(random.below(3)) - 4;
          const Point2 on = random.below(2) == 0 ? p : Point2{std::nextafter(p.x, right), p.y};
          for (Point2& q : points) q = {on.x + std::fabs(q.x), on.y + std::fabs(q.y)};
          points.push_back(on);
        }
        polygons.push_back(hull(points));
      }
      break;
    case 4:  // stacked: each inside of, above or touching the last one
      for (std::size_t k = 0; k < count; ++k) {
        const double x = at(4), y = 3 * static_cast<double>(k);
        polygons.push_back(hull({{x, y}, {x + at(9), y + at(5)}, {x + at(9), y + at(4)}, {x + at(9), y}}));
      }
      break;
    case 5:  // two long ones that may meet at their far ends, with short ones between their near ends
      polygons.push_back(hull({{0, 0}, {1, -at(4)}, {30, 10 + at(3)}}));
      polygons.push_back(hull({{0, 30}, {1, 30 + at(4)}, {30, 11 + at(3)}}));
      for (std::size_t k = 0; k < count; ++k) {
        const double x = at(6), y = 5 + 3 * static_cast<double>(k);
        polygons.push_back(hull({{x, y}, {x + 1 + at(4), y + at(3)}, {x + 1, y + at(3)}}));
      }
      break;
    default:  // some scale
      polygons = some_polygons(random, static_cast<int>(random.below(6)));
      const double scale = std::ldexp(1, static_cast<int>(random.between(-1000, 1000)));
      for (ConvexPolygon& polygon : polygons) {
        std::vector<Point2> points;
        for (const Point2& p : polygon.vertices()) points.push_back({scale * p.x, scale * p.y});
        polygon = hull(points);
      }
  }
  return polygons;
}
constexpr int families = 7;

TEST(ConvexPolygonsAny, MethodsAgreeWithTheScan) {
  const int count = tests::scaled_count(6000);
  Random random(tests::chosen_seed(20261122));
  std::array<std::array<int, 2>, families> meet{};
  std::array<int, 3> contacts{};
  for (int k = 0; k < count; ++k) {
    const int family = k % families;
    const Polygons polygons = some_polygons(random, family);
    std::vector<std::uint32_t> groups;
    if (random.below(4) == 0) {
      for (std::size_t i = 0; i < polygons.size(); ++i) groups.push_back(static_cast<std::uint32_t>(random.below(3)));
    }
    for (const Allowed allowed : {Allowed::nothing, Allowed::touch}) {
      const SetOptions options{allowed, groups, nullptr};
      const bool some = convex_polygons_any_by_scan(polygons, options).meet();
      if (groups.empty()) meet[static_cast<std::size_t>(family)][allowed == Allowed::touch] += some;
      for (Method* method : {convex_polygons_any_by_sweep, convex_polygons_any_by_grid}) {
        const ConvexPolygonsAnswer answer = method(polygons, options);
        ASSERT_EQ(answer.meet(), some) << k << " family " << family << " " << name_of(allowed);
        if (!answer.meet()) continue;
        ++contacts[static_cast<std::size_t>(answer.found->kind)];
        ASSERT_LT(answer.found->i, answer.found->j);
        ASSERT_LT(answer.found->j, polygons.size());
        ASSERT_FALSE(may_meet(groups, answer.found->i, answer.found->j));
        ASSERT_TRUE(counts(answer.found->kind, allowed));
        if (k % 4 != 0) continue;
        ASSERT_EQ(check(answer.found->evidence, polygons[answer.found->i], polygons[answer.found->j]),
                  CheckResult::accepted);
        const Polygons pair{polygons[answer.found->i], polygons[answer.found->j]};
        ASSERT_EQ(answer.found->kind, convex_polygons_any_by_scan(pair, {allowed, {}, nullptr}).found->kind);
      }
    }
  }
  std::printf("touching %d, overlapping %d\n", contacts[1], contacts[2]);
  for (std::size_t f = 0; f < families; ++f) std::printf("family %zu: %d %d\n", f, meet[f][0], meet[f][1]);
  if (count < 2000) return;
  for (const std::size_t contact : {1u, 2u}) EXPECT_GT(contacts[contact], count / 10);
  for (std::size_t f = 0; f < families; ++f) {
    const int of_family = count / families * 3 / 4;
    EXPECT_GT(meet[f][1], of_family / 20) << f;
    EXPECT_LT(meet[f][1], of_family - of_family / 20) << f;
    if (f != 1) {
      EXPECT_LT(meet[f][0], of_family - of_family / 50) << f;
    }
  }
}

}  // namespace
}  // namespace sunder::planar
