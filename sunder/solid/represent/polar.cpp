#include <sunder/base/contract.h>
#include <sunder/base/error.h>
#include <sunder/number/rounded.h>
#include <sunder/number/vector.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/polar.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace sunder::solid {

namespace {

constexpr std::uint32_t no_vertex = 0xffffffff;

// The plane through a, b, c as seen from the mean of the base d: n = (b - a) x (c - a), 4 h = n.(4 a - the sum of d),
// which is n.((a - d0) + (a - d1) + (a - d2) + (a - d3)). Read makes a number of a double.
template <class Read>
auto plane(const Read& read, std::span<const Point3> points, std::span<const std::uint32_t> facet,
           const std::array<std::uint32_t, 4>& base) {
  using Leaf = decltype(read(0.0));
  const auto lift = [&](std::uint32_t v) {
    return Vector3<Leaf>{read(points[v].x), read(points[v].y), read(points[v].z)};
  };
  const auto a = lift(facet[0]);
  const auto n = cross(lift(facet[1]) - a, lift(facet[2]) - a);
  const auto d0 = a - lift(base[0]), d1 = a - lift(base[1]), d2 = a - lift(base[2]), d3 = a - lift(base[3]);
  const auto sum = [](const auto& i, const auto& j, const auto& k, const auto& l) { return (i + j) + (k + l); };
  const auto x = sum(d0.x, d1.x, d2.x, d3.x);
  const Vector3<std::remove_const_t<decltype(x)>> arrow{x, sum(d0.y, d1.y, d2.y, d3.y), sum(d0.z, d1.z, d2.z, d3.z)};
  struct Result {
    std::remove_const_t<decltype(n)> normal;
    decltype(dot(n, arrow)) height;
  };
  return Result{n, dot(n, arrow)};
}

// Is the error below 2^-30 of the size? Overflow makes the magnitude infinite.
template <int K>
bool is_close(const Rounded<K>& x, double size) {
  return Rounded<K>::bound * x.magnitude <= 0x1p-30 * size;
}

struct RoundedVertex {
  Point3 at;
  double error;
};

RoundedVertex rounded_vertex(std::span<const Point3> points, std::span<const std::uint32_t> facet,
                             const std::array<std::uint32_t, 4>& base) {
  const auto [n, h] = plane(leaf, points, facet, base);
  const double size = std::max({std::fabs(n.x.value), std::fabs(n.y.value), std::fabs(n.z.value)});
  const auto is_tame_vertex = [&](std::uint32_t v) {
    return tame(points[v].x) && tame(points[v].y) && tame(points[v].z);
  };
  if (std::all_of(facet.begin(), facet.begin() + 3, is_tame_vertex) &&
      std::all_of(base.begin(), base.end(), is_tame_vertex) && is_close(n.x, size) && is_close(n.y, size) &&
      is_close(n.z, size) && is_close(h, std::fabs(h.value))) {
    const double scale = 4 / h.value;
    // Relative errors below 2^-30 of the numerators, beside the largest, and of h, and of two roundings.
    const double largest = std::max({n.x.magnitude, n.y.magnitude, n.z.magnitude});
    const double error = (n.x.bound * largest + size * (h.bound * h.magnitude / std::fabs(h.value) + 0x1p-51)) * scale;
    return {{n.x.value * scale, n.y.value * scale, n.z.value * scale}, error * (1 + 0x1p-20)};
  }
  const PolarVertex exact = exact_polar_vertex(points, facet, base);
  const Point3 at{nearest_ratio(exact.n[0], exact.h), nearest_ratio(exact.n[1], exact.h),
                  nearest_ratio(exact.n[2], exact.h)};
  return {at, std::max({std::fabs(at.x), std::fabs(at.y), std::fabs(at.z)}) * 0x1p-52 + 0x1p-1000};
}

// Three vertices of a facet and the one furthest from it, as far as doubles tell; any but the facet's would do.
std::array<std::uint32_t, 4> choose_base(std::span<const Point3> points, std::span<const std::uint32_t> facet) {
  const std::size_t k = facet.size();
  const std::uint32_t a = facet[0], b = facet[k / 3], c = facet[2 * k / 3];
  const auto arrow = [&](std::uint32_t v) {  // halves: no overflow
    return Vector3<double>{points[v].x / 2 - points[a].x / 2, points[v].y / 2 - points[a].y / 2,
                           points[v].z / 2 - points[a].z / 2};
  };
  const Vector3<double> normal = cross(arrow(b), arrow(c));
  std::vector<bool> is_in_facet(points.size());
  for (const std::uint32_t v : facet) is_in_facet[v] = true;
  std::uint32_t furthest = no_vertex;
  double lowest = 0;
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    if (is_in_facet[v]) continue;
    const double height = dot(normal, arrow(v));
    if (furthest != no_vertex && !(height < lowest)) continue;
    furthest = v;
    lowest = height;
  }
  return {a, b, c, furthest};
}

}  // namespace

std::size_t Polar::memory() const {
  return sizeof(Polar) + vertices.size() * (sizeof(Point3) + sizeof(double)) +
         (edge_begin.size() + neighbours.size() + facet_begin.size() + facet_vertices.size()) * sizeof(std::uint32_t);
}

PolarVertex exact_polar_vertex(std::span<const Point3> vertices, std::span<const std::uint32_t> facet,
                               const std::array<std::uint32_t, 4>& base) {
  SUNDER_REQUIRE(facet.size() >= 3);
  const auto [n, h] = plane([](double x) { return Dyadic(x); }, vertices, facet, base);
  return {{n.x.scaled(2), n.y.scaled(2), n.z.scaled(2)}, h};
}

PolarVertexOf<Estimate> estimated_polar_vertex(std::span<const Point3> vertices, std::span<const std::uint32_t> facet,
                                               const std::array<std::uint32_t, 4>& base) {
  SUNDER_REQUIRE(facet.size() >= 3);
  const auto [n, h] = plane([](double x) { return Estimate(x); }, vertices, facet, base);
  return {{n.x * 4.0, n.y * 4.0, n.z * 4.0}, h};
}

Polar Polar::make(const ConvexPolyhedron& body) { return make_polar(body, body.vertices()); }

Polar make_polar(const ConvexPolyhedron& body, std::span<const Point3> vertices) {
  if (body.dimension() != 3) {
    throw Error(ErrorCode::bad_shape, "a polyhedron without an interior has no polar about a point inside");
  }
  const std::span<const std::uint32_t> corner_begin = body.facet_begin(), corners = body.facet_vertices();
  const std::uint32_t n = static_cast<std::uint32_t>(vertices.size()), facet_count = body.facet_count();

  Polar polar;
  polar.base = choose_base(vertices, body.facet(0));
  for (std::size_t k = 0; k < 3; ++k) {
    for (const std::uint32_t v : polar.base) polar.center[k] += vertices[v][k] / 4;
  }
  polar.vertices.reserve(facet_count);
  polar.errors.reserve(facet_count);
  for (std::uint32_t f = 0; f < facet_count; ++f) {
    const RoundedVertex rounded = rounded_vertex(vertices, body.facet(f), polar.base);
    polar.vertices.push_back(rounded.at);
    polar.errors.push_back(rounded.error);
  }

  // By vertices, the facets that have it, in any order at first.
  struct Corner {
    std::uint32_t facet, before, after;  // the vertices before and after it
    std::uint32_t edge;                  // the place in `corners` of the edge from `before` to it
  };
  polar.facet_begin.assign(n + 1, 0);
  for (const std::uint32_t v : corners) ++polar.facet_begin[v + 1];
  for (std::uint32_t v = 0; v < n; ++v) polar.facet_begin[v + 1] += polar.facet_begin[v];
  std::vector<Corner> at(corners.size());
  std::vector<std::uint32_t> next(polar.facet_begin.begin(), polar.facet_begin.end() - 1);
  for (std::uint32_t f = 0; f < facet_count; ++f) {
    const std::span<const std::uint32_t> cycle = body.facet(f);
    for (std::size_t j = 0, last = cycle.size() - 1; j <= last; ++j) {
      const std::size_t before = j == 0 ? last : j - 1;
      at[next[cycle[j]]++] = {f, cycle[before], cycle[j == last ? 0 : j + 1],
                              static_cast<std::uint32_t>(corner_begin[f] + before)};
    }
  }

  // About v, a facet lies to the left of its edge from v to `after`, and the next one counter-clockwise to the left of
  // the edge from v to `before`: it is across the facet's edge from `before` to v, too.
  polar.edge_begin.assign(corner_begin.begin(), corner_begin.end());
  polar.neighbours.resize(corners.size());
  polar.facet_vertices.reserve(corners.size());
  std::vector<std::uint32_t> left_of(n);  // of the edge from v to this vertex: a place in `at`
  for (std::uint32_t v = 0; v < n; ++v) {
    const std::uint32_t begin = polar.facet_begin[v], end = polar.facet_begin[v + 1];
    for (std::uint32_t i = begin; i < end; ++i) left_of[at[i].after] = i;
    std::uint32_t i = begin;
    for (std::uint32_t j = begin; j < end; ++j) {
      const std::uint32_t following = left_of[at[i].before];
      polar.facet_vertices.push_back(at[i].facet);
      polar.neighbours[at[i].edge] = at[following].facet;
      i = following;
    }
  }
  return polar;
}

}  // namespace sunder::solid
