// Polygons, poses and points for the tests of questions about one convex polygon.
#pragma once

#include <sunder/base/error.h>
#include <sunder/base/random.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>
#include <tests/support/shapes.h>

#include <tests/support/scale.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace sunder::planar {

using tests::regular_polygon;

// Everything on an integer grid of a small side, all of it scaled by one power of two; under poses of small integers,
// reflecting ones too. The points are integers of the grid and about it, halves and quarters.
struct NastyCase {
  ConvexPolygon polygon;
  Pose pose;
  double scale = 1;
  std::int64_t side = 3;
};

inline NastyCase nasty_case(Random& random) {
  const std::int64_t side = random.between(3, 9);
  const double scale = random.below(4) > 0 ? 1 : random.below(2) > 0 ? 0x1p900 : 0x1p-900;
  std::vector<Point2> points(1 + random.below(12));
  const auto coordinate = [&] { return scale * static_cast<double>(random.between(0, side - 1)); };
  for (Point2& p : points) p = {coordinate(), coordinate()};
  // The hull begins with its first vertex: begin it anywhere.
  const ConvexPolygon hull = ConvexPolygon::hull_of(points);
  points.assign(hull.vertices().begin(), hull.vertices().end());
  const auto begin = static_cast<std::ptrdiff_t>(random.below(points.size()));
  std::rotate(points.begin(), points.begin() + begin, points.end());
  NastyCase made{ConvexPolygon::from_vertices(points), Pose(), scale, side};
  while (random.below(2) == 0) {
    const auto entry = [&] { return static_cast<double>(random.between(-2, 2)); };
    const std::array<double, 4> m{entry(), entry(), entry(), entry()};
    if (m[0] * m[3] == m[1] * m[2]) continue;
    made.pose = Pose::from_matrix(m, {scale * entry(), scale * entry()});
    break;
  }
  return made;
}

// A point of the world: often a vertex, in line with an edge, or on it; exact, as the numbers are small.
inline Point2 nasty_point(const NastyCase& c, Random& random) {
  const auto image = [&](std::uint64_t v) {
    const auto& [m, t] = c.pose.affine();
    const Point2& p = c.polygon[static_cast<std::uint32_t>(v)];
    return Point2{m[0] * p.x + m[1] * p.y + t[0], m[2] * p.x + m[3] * p.y + t[1]};
  };
  const Point2 p = image(random.below(c.polygon.size())), q = image(random.below(c.polygon.size()));
  const auto near = [&](double x) { return x + c.scale * static_cast<double>(random.between(-2, 2)); };
  switch (random.below(6)) {
    case 0: return p;
    case 1: return {(p.x + q.x) / 2, (p.y + q.y) / 2};
    case 2: return {p.x + (p.x - q.x), p.y + (p.y - q.y)};
    case 3: return {p.x + (q.x - p.x) / 4, p.y + (q.y - p.y) / 4};
    case 4: return {near((p.x + q.x) / 2), near((p.y + q.y) / 2)};
    default: return {near(p.x), near(p.y)};
  }
}

// A number of any size, from the least double to 2^1020.
inline double wild_number(Random& random) {
  const double sign = random.below(2) == 0 ? 1 : -1;
  switch (random.below(5)) {
    case 0: return sign * 5e-324 * static_cast<double>(random.below(4));
    case 1: return sign * random.log_uniform(1e-307, 1e307);
    case 2: return sign * 0x1p1020;
    case 3: return sign * random.log_uniform(1e-170, 1e-150);
    default: return static_cast<double>(random.between(-3, 3));
  }
}

// The hull of some points of any size, half of them under a pose of any size.
inline NastyCase wild_case(Random& random) {
  std::vector<Point2> points(1 + random.below(12));
  for (Point2& p : points) p = {wild_number(random), wild_number(random)};
  NastyCase made{ConvexPolygon::hull_of(points), Pose()};
  while (random.below(2) == 0) {
    const std::array<double, 4> m{wild_number(random), wild_number(random), wild_number(random), wild_number(random)};
    try {
      made.pose = Pose::from_matrix(m, {wild_number(random), wild_number(random)});
      break;
    } catch (const Error&) {  // singular
    }
  }
  return made;
}

// For a wild case: a vertex or half-way between two, if there is no pose; else anything.
inline Point2 wild_point(const NastyCase& c, Random& random) {
  const auto vertex = [&] { return c.polygon[static_cast<std::uint32_t>(random.below(c.polygon.size()))]; };
  const Point2 p = vertex(), q = vertex();
  switch (c.pose.is_identity() ? random.below(4) : 3) {
    case 0: return p;
    case 1: return {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2};
    case 2: return {p.x, q.y};
    default: return {wild_number(random), wild_number(random)};
  }
}

// Points of a parabola: one half has all edges but one.
inline ConvexPolygon parabola(std::uint32_t n, std::uint32_t begin = 0) {
  std::vector<Point2> p(n);
  for (std::uint32_t k = 0; k < n; ++k) {
    const double x = (begin + k) % n;
    p[k] = {x, x * x};
  }
  return ConvexPolygon::from_vertices(std::move(p));
}

}  // namespace sunder::planar
