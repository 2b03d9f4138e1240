#include <sunder/base/error.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/segments.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace sunder::planar {

namespace {

std::string vertex(std::size_t v) { return "vertex " + std::to_string(v); }

void require_points(std::span<const Point2> points) {
  if (points.empty()) throw Error(ErrorCode::bad_shape, "a convex polygon has no vertices; give one at least");
  if (points.size() >= std::size_t{1} << 31) {
    throw Error(ErrorCode::bad_shape, "a convex polygon has 2^31 vertices or more; give fewer");
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!std::isfinite(points[v].x) || !std::isfinite(points[v].y)) {
      throw Error(ErrorCode::bad_value, "a coordinate is not finite; give finite numbers", vertex(v));
    }
  }
}

struct Fault {
  std::size_t vertex;
  const char* what;
};

// What keeps three vertices and more, or two, from being strictly convex and counter-clockwise.
std::optional<Fault> fault_of(std::span<const Point2> p) {
  const std::size_t n = p.size();
  if (n == 1) return {};
  for (std::size_t v = 0; v < n; ++v) {
    if (p[v] == p[(v + 1) % n]) return Fault{(v + 1) % n, "the same point as the one before; give each vertex once"};
  }
  if (n == 2) return {};
  std::size_t left = 0;
  std::optional<Fault> straight, reflex;
  for (std::size_t v = 0; v < n; ++v) {
    const Sign turn = orient_2d(p[(v + n - 1) % n], p[v], p[(v + 1) % n]);
    if (turn == Sign::positive) ++left;
    if (turn == Sign::negative && !reflex) {
      reflex = Fault{v, "reflex: the polygon is not convex here; give a convex one, or ask for the hull"};
    }
    if (turn == Sign::zero && !straight) straight = Fault{v, "collinear with its neighbours; leave it out"};
  }
  if (reflex && left == 0) return Fault{0, "the first one of a clockwise polygon; give the vertices counter-clockwise"};
  if (reflex) return reflex;
  if (straight) return straight;
  // All turns are to the left. Once around, the direction along x changes from left to right once.
  std::size_t starts = 0;
  for (std::size_t v = 0; v < n; ++v) {
    const auto to_right = [&](std::size_t k) { return lexicographically_less(p[k % n], p[(k + 1) % n]); };
    if (!to_right(v + n - 1) && to_right(v)) ++starts;
  }
  if (starts != 1)
    return Fault{0, "the first one of a boundary that winds about more than once; give a simple polygon"};
  return {};
}

[[noreturn]] void refuse(const Fault& fault, std::size_t index) {
  throw Error(ErrorCode::bad_shape, fault.what, vertex(index));
}

}  // namespace

ConvexPolygon::ConvexPolygon(std::vector<Point2> vertices) : vertices_(std::move(vertices)) {
  for (std::uint32_t v = 0; v < size(); ++v) {
    if (lexicographically_less(vertices_[v], vertices_[leftmost_])) leftmost_ = v;
    if (lexicographically_less(vertices_[rightmost_], vertices_[v])) rightmost_ = v;
    sizes_.include(vertices_[v].x);
    sizes_.include(vertices_[v].y);
  }
}

ConvexPolygon ConvexPolygon::from_vertices(std::vector<Point2> vertices) {
  require_points(vertices);
  if (const auto fault = fault_of(vertices)) refuse(*fault, fault->vertex);
  return ConvexPolygon(std::move(vertices));
}

ConvexPolygon ConvexPolygon::mended(std::span<const Point2> given) {
  require_points(given);
  std::vector<std::size_t> kept;  // numbers of vertices
  const auto at = [&](std::size_t k) { return given[kept[k]]; };
  for (std::size_t v = 0; v < given.size(); ++v) {
    if (kept.empty() || given[v] != given[kept.back()]) kept.push_back(v);
  }
  while (kept.size() > 1 && given[kept.back()] == given[kept.front()]) kept.pop_back();
  // Those in line with their neighbours and between them, until there are none: all the way round, from the lowest.
  std::size_t first = 0;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    if (lexicographically_less(at(k), at(first))) first = k;
  }
  std::rotate(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
  std::vector<std::size_t> corners;
  // Is the last corner in line with the one before it and with v, and between these?
  const auto is_between = [&](std::size_t v) {
    const Point2 &p = given[corners[corners.size() - 2]], &q = given[corners.back()], &r = given[v];
    return orient_2d(p, q, r) == Sign::zero && lexicographically_less(p, q) == lexicographically_less(q, r);
  };
  for (const std::size_t v : kept) {
    while (corners.size() > 1 && is_between(v)) corners.pop_back();
    corners.push_back(v);
  }
  while (corners.size() > 2 && is_between(corners.front())) corners.pop_back();
  std::size_t left = 0, right = 0;
  const std::size_t n = corners.size();
  for (std::size_t k = 0; n > 2 && k < n; ++k) {
    const Sign turn = orient_2d(given[corners[(k + n - 1) % n]], given[corners[k]], given[corners[(k + 1) % n]]);
    if (turn == Sign::positive) ++left;
    if (turn == Sign::negative) ++right;
  }
  if (right > left) std::reverse(corners.begin(), corners.end());
  std::vector<Point2> vertices;
  vertices.reserve(n);
  for (const std::size_t v : corners) vertices.push_back(given[v]);
  if (const auto fault = fault_of(vertices)) refuse(*fault, corners[fault->vertex]);
  return ConvexPolygon(std::move(vertices));
}

ConvexPolygon ConvexPolygon::hull_of(std::span<const Point2> points) {
  require_points(points);
  std::vector<Point2> p(points.begin(), points.end());
  std::sort(p.begin(), p.end(), lexicographically_less);
  p.erase(std::unique(p.begin(), p.end()), p.end());
  if (p.size() < 3) return ConvexPolygon(std::move(p));
  std::vector<Point2> hull;  // the chain below, then that above
  const auto extend = [&hull](const Point2& q, std::size_t begin) {
    while (hull.size() > begin + 1 && orient_2d(hull[hull.size() - 2], hull.back(), q) != Sign::positive)
      hull.pop_back();
    hull.push_back(q);
  };
  for (const Point2& q : p) extend(q, 0);
  const std::size_t rightmost = hull.size() - 1;
  for (std::size_t k = p.size() - 1; k-- > 0;) extend(p[k], rightmost);
  hull.pop_back();
  return ConvexPolygon(std::move(hull));
}

}  // namespace sunder::planar
