// How two solids lie to each other, by looking at both sides of all parts of their surfaces: each triangle is cut along all
// triangles of both that go through it, and the middle of each part says what is on either side, by a ray. In fractions, without
// the library's code, and slow: for meshes of some dozen triangles.
#pragma once

#include <sunder/predicate/point.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace sunder::tests {

// What there is beside the surfaces: points inside of both, of A alone, of B alone.
struct Insides {
  bool both = false, a_alone = false, b_alone = false;
};

namespace two_cells {

using Number =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
using Vector = std::array<Number, 3>;

// With what it is about, in doubles. Coordinates are below 100 in size: so signs of products in doubles are right where these are
// well beyond their errors, which saves most fractions.
struct Corner {
  Corner(Vector at) : exact(std::move(at)) {
    for (std::size_t c = 0; c < 3; ++c) about[c] = static_cast<double>(exact[c]);
  }
  Vector exact;
  std::array<double, 3> about{};
};
using Triangle = std::array<Corner, 3>;
using Polygon = std::vector<Corner>;
constexpr double sure = 1e-5;

template <class Row>
Row minus(const Row& p, const Row& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
template <class Row>
auto dot(const Row& p, const Row& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
template <class Row>
Row cross(const Row& p, const Row& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
inline bool is_zero(const Vector& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }
inline int sign(const Number& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
inline int sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

inline Vector normal_of(const Triangle& t) {
  return cross(minus(t[1].exact, t[0].exact), minus(t[2].exact, t[0].exact));
}

// Through a point, with a normal: on which side is another point?
struct Plane {
  Corner normal, at;

  Number height(const Corner& p) const { return dot(normal.exact, minus(p.exact, at.exact)); }
  int side(const Corner& p) const {
    const double about = dot(normal.about, minus(p.about, at.about));
    return std::fabs(about) > sure ? sign(about) : sign(height(p));
  }
};

// Closed triangles, with an area, and their planes; is what is inside told by the winding number, or by the parity?
struct Solid {
  void add(const Triangle& t) {
    triangles.push_back(t);
    planes.push_back({normal_of(t), t[0]});
  }
  std::vector<Triangle> triangles;
  std::vector<Plane> planes;
  bool by_winding = true;
};

// On the way from p, which is above or below the plane, to q, which is on its other side.
inline Corner crossing(const Plane& plane, const Corner& p, const Corner& q) {
  const Number h = plane.height(p), t = h / (h - plane.height(q));
  Vector at;
  for (std::size_t c = 0; c < 3; ++c) at[c] = p.exact[c] + t * (q.exact[c] - p.exact[c]);
  return at;
}

// What of a convex polygon is on either side of a plane; empty: no area.
inline std::array<Polygon, 2> halves(const Polygon& polygon, const Plane& plane) {
  std::vector<int> sides;
  for (const Corner& p : polygon) sides.push_back(plane.side(p));
  if (std::find(sides.begin(), sides.end(), -1) == sides.end()) return {polygon, {}};
  if (std::find(sides.begin(), sides.end(), 1) == sides.end()) return {Polygon(), polygon};
  std::array<Polygon, 2> result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::size_t next = (k + 1) % polygon.size();
    if (sides[k] >= 0) result[0].push_back(polygon[k]);
    if (sides[k] <= 0) result[1].push_back(polygon[k]);
    if (sides[k] * sides[next] >= 0) continue;
    const Corner between = crossing(plane, polygon[k], polygon[next]);
    for (Polygon& half : result) half.push_back(between);
  }
  return result;
}

// Are the points all beyond one edge of a polygon with that normal, or on its line?
inline bool are_beside(const Polygon& polygon, const Corner& normal, std::span<const Corner> points) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Corner& next = polygon[(k + 1) % polygon.size()];
    const auto about = cross(normal.about, minus(next.about, polygon[k].about));
    std::optional<Plane> edge;
    if (std::all_of(points.begin(), points.end(), [&](const Corner& p) {
          const double height = dot(about, minus(p.about, polygon[k].about));
          if (std::fabs(height) > 100 * sure) return height < 0;
          if (!edge) edge = Plane{cross(normal.exact, minus(next.exact, polygon[k].exact)), polygon[k]};
          return sign(edge->height(p)) <= 0;
        })) {
      return true;
    }
  }
  return false;
}

// Cuts the parts of a triangle, which are in the plane, along another one.
inline void cut(std::vector<Polygon>& parts, const Plane& plane, const Triangle& by, const Plane& plane_of_other) {
  std::array<int, 3> sides;
  for (std::size_t k = 0; k < 3; ++k) sides[k] = plane.side(by[k]);
  if (sides[0] != 0 && sides[0] == sides[1] && sides[0] == sides[2]) return;
  const bool is_flat = sides == std::array{0, 0, 0};
  std::vector<Corner> seen;  // what of the other one is in the plane
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (sides[k] == 0) seen.push_back(by[k]);
    if (sides[k] * sides[next] < 0) seen.push_back(crossing(plane, by[k], by[next]));
  }
  std::vector<Polygon> result;
  for (const Polygon& part : parts) {
    if (are_beside(part, plane.normal, seen)) {
      result.push_back(part);
      continue;
    }
    std::vector<Polygon> pieces{part};
    for (std::size_t k = 0; k < (is_flat ? 3u : 1u); ++k) {
      const Plane across =
          is_flat ? Plane{cross(plane.normal.exact, minus(by[(k + 1) % 3].exact, by[k].exact)), by[k]} : plane_of_other;
      std::vector<Polygon> next;
      for (const Polygon& piece : pieces) {
        for (Polygon& half : halves(piece, across)) {
          if (!half.empty()) next.push_back(std::move(half));
        }
      }
      pieces = std::move(next);
    }
    result.insert(result.end(), pieces.begin(), pieces.end());
  }
  parts = std::move(result);
}

// How a ray along a direction from a point turns around the edge from p to q.
inline int turn(const Corner& point, const Corner& p, const Corner& q, const Corner& along) {
  const double about = dot(cross(minus(p.about, point.about), minus(q.about, point.about)), along.about);
  if (std::fabs(about) > 100 * sure) return sign(about);
  return sign(dot(cross(minus(p.exact, point.exact), minus(q.exact, point.exact)), along.exact));
}

// The winding numbers before a point of a triangle with that normal, and behind it. Nothing: the line of the ray meets an edge.
inline std::optional<std::array<int, 2>> windings(const Solid& solid, const Corner& point, const Corner& normal,
                                                  const Corner& along) {
  int before = 0, step = 0;
  for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
    const Triangle& t = solid.triangles[i];
    const std::array turns{turn(point, t[0], t[1], along), turn(point, t[1], t[2], along),
                           turn(point, t[2], t[0], along)};
    const auto [least, greatest] = std::minmax_element(turns.begin(), turns.end());
    if (*least < 0 && *greatest > 0) continue;
    if (*least == 0 || *greatest == 0) return std::nullopt;
    const Plane& plane = solid.planes[i];
    const int side = plane.side(point);  // 0: the triangle has the point
    if (side == 0) {
      step += sign(dot(plane.normal.exact, normal.exact));
    } else if (side != turns[0]) {
      before += turns[0];  // as the sign of its normal along the ray
    }
  }
  return std::array{before, before + step};
}

inline std::array<bool, 2> insides(const Solid& solid, const Corner& point, const Corner& normal, std::uint32_t& dice) {
  while (true) {
    const auto next = [&] { return Number(static_cast<int>((dice = dice * 1664525u + 1013904223u) >> 24) - 128); };
    Vector along{next(), next(), next()};
    if (dot(along, normal.exact) == 0) continue;
    if (dot(along, normal.exact) < 0) along = {-along[0], -along[1], -along[2]};
    const auto found = windings(solid, point, normal, along);
    if (!found) continue;
    const auto is_inside = [&](int n) { return solid.by_winding ? n != 0 : n % 2 != 0; };
    return {is_inside((*found)[0]), is_inside((*found)[1])};
  }
}

inline Insides look(const Solid& a, const Solid& b) {
  Insides result;
  std::uint32_t dice = 1;
  for (const Solid* of : {&a, &b}) {
    for (std::size_t i = 0; i < of->triangles.size(); ++i) {
      const Triangle& t = of->triangles[i];
      std::vector<Polygon> parts{Polygon(t.begin(), t.end())};
      for (const Solid* other : {&a, &b}) {
        for (std::size_t k = 0; k < other->triangles.size(); ++k) {
          if (&other->triangles[k] != &t) cut(parts, of->planes[i], other->triangles[k], other->planes[k]);
        }
      }
      for (const Polygon& part : parts) {
        Vector middle{0, 0, 0};
        for (const Corner& p : part) {
          for (std::size_t c = 0; c < 3; ++c) middle[c] += p.exact[c] / static_cast<int>(part.size());
        }
        const Corner& normal = of->planes[i].normal;
        const auto in_a = insides(a, middle, normal, dice), in_b = insides(b, middle, normal, dice);
        for (const std::size_t side : {0u, 1u}) {
          result.both |= in_a[side] && in_b[side];
          result.a_alone |= in_a[side] && !in_b[side];
          result.b_alone |= in_b[side] && !in_a[side];
        }
      }
    }
  }
  return result;
}

}  // namespace two_cells
}  // namespace sunder::tests
