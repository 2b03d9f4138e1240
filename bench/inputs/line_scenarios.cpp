#include <bench/inputs/line_scenarios.h>

#include <tests/support/shapes.h>

#include <sunder/base/random.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace bench {
namespace {

using sunder::CutKind;
using sunder::Point3;
using sunder::Random;
using sunder::solid::Line;
using sunder::solid::Plane;

constexpr int kBits = 40;  // of vertices; one more for the middles of edges
constexpr double kInside = 0.5, kNearGap = 1e-6, kFarGap = 1e-3;
constexpr double kChord = 0.5;  // of two vertices that share no facet

Point3 plus(const Point3& p, const Point3& q, double by = 1) {
  return {p.x + by * q.x, p.y + by * q.y, p.z + by * q.z};
}
double dot(const Point3& p, const Point3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
Point3 cross(const Point3& p, const Point3& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
Point3 unit(const Point3& p) { return plus({}, p, 1 / std::sqrt(dot(p, p))); }
Point3 middle(const Point3& p, const Point3& q) { return plus({}, plus(p, q), 0.5); }

Point3 in_ball(double radius, Random& random) {
  return plus({}, sunder::tests::on_sphere(random), radius * std::cbrt(random.unit()));
}
// Of length 1, across u.
Point3 across(const Point3& u, Random& random) { return unit(cross(u, sunder::tests::on_sphere(random))); }

const Point3& some_vertex(const SphereBody& body, Random& random) {
  const auto vertices = body.hull.vertices();
  return vertices[random.below(vertices.size())];
}

struct Edge {
  Point3 a, b;
  Point3 outward;  // between the normals of its two facets
};
Edge some_edge(const SphereBody& body, Random& random) {
  const auto vertices = body.hull.vertices();
  const auto v = static_cast<std::uint32_t>(random.below(vertices.size()));
  const auto others = body.hull.neighbours(v);
  const std::size_t k = random.below(others.size()), size = others.size();
  const auto way = [&](std::size_t i) { return plus(vertices[others[i % size]], vertices[v], -1); };
  const Point3 right = unit(cross(way(k + size - 1), way(k))), left = unit(cross(way(k), way(k + 1)));
  return {vertices[v], vertices[others[k]], plus(left, right)};
}

// --- Lines -----------------------------------------------------------------------------------------------------------

// What its ends are is not known yet.
LineQuery through(const Point3& a, const Point3& b, CutKind kind) {
  LineQuery query;
  query.line = Line::through(a, b);
  query.way = unit(plus(b, a, -1));
  query.foot = plus(a, query.way, -dot(a, query.way));
  query.kind = kind;
  return query;
}

// Its ends are these points of it.
LineQuery with_ends(LineQuery query, const Point3& p, const Point3& q) {
  query.first = query.along(p.x, p.y, p.z);
  query.last = query.along(q.x, q.y, q.z);
  if (query.first > query.last) std::swap(query.first, query.last);
  return query;
}

LineQuery touching(const Point3& at, const Point3& way) {
  return with_ends(through(at, plus(at, way), CutKind::point), at, at);
}

LineQuery by_vertices(const SphereBody& body, std::size_t k, Random& random) {
  const Point3 v = some_vertex(body, random);
  if (k % 3 == 0) return through(v, in_ball(kInside, random), CutKind::across);
  if (k % 3 == 1) {
    for (;;) {
      const Point3& w = some_vertex(body, random);
      const Point3 chord = plus(w, v, -1);
      if (dot(chord, chord) > kChord * kChord) return with_ends(through(v, w, CutKind::across), v, w);
    }
  }
  return touching(v, across(v, random));
}

LineQuery by_edges(const SphereBody& body, std::size_t k, Random& random) {
  const auto [a, b, outward] = some_edge(body, random);
  if (k % 3 == 0) return with_ends(through(a, b, CutKind::along), a, b);
  const Point3 at = middle(a, b);
  if (k % 3 == 1) return through(at, in_ball(kInside, random), CutKind::across);
  const Point3 over = unit(cross(outward, plus(b, a, -1)));
  return touching(at, unit(plus(over, unit(plus(b, a, -1)), random.uniform(-1, 1))));
}

LineQuery by_family(const SphereBody& body, LineFamily family, std::size_t k, Random& random) {
  switch (family) {
    case LineFamily::hits: {
      const Point3 p = in_ball(0.9, random);
      return through(plus(p, sunder::tests::on_sphere(random), random.uniform(1, 3)), p, CutKind::across);
    }
    case LineFamily::vertices: return by_vertices(body, k, random);
    case LineFamily::edges: return by_edges(body, k, random);
    case LineFamily::near_misses: {
      const Point3 v = some_vertex(body, random), way = across(v, random);
      const Point3 p = plus(v, v, random.log_uniform(kNearGap, kFarGap));
      return through(plus(p, way, random.uniform(-2, -1)), plus(p, way, random.uniform(1, 2)), CutKind::nothing);
    }
    default: {
      const Point3 u = sunder::tests::on_sphere(random), way = across(u, random);
      const Point3 p = plus({}, u, random.uniform(1.1, 3));
      return through(plus(p, way, random.uniform(-2, -1)), plus(p, way, random.uniform(1, 2)), CutKind::nothing);
    }
  }
}

struct Facet {
  Point3 normal;
  double offset = 0;
};

std::vector<Facet> facets_of(const SphereBody& body) {
  std::vector<Facet> facets;
  const auto vertices = body.hull.vertices();
  for (const auto& [i, j, k] : body.triangles) {
    const Point3& p = vertices[i];
    const Point3 normal = cross(plus(vertices[j], p, -1), plus(vertices[k], p, -1));
    facets.push_back({normal, dot(normal, p)});
  }
  return facets;
}

// Of a line through the inside: from the planes of all facets.
void find_ends(const std::vector<Facet>& facets, LineQuery& query) {
  double first = -HUGE_VAL, last = HUGE_VAL;
  for (const Facet& f : facets) {
    const double rise = dot(f.normal, query.way), at = (f.offset - dot(f.normal, query.foot)) / rise;
    if (rise < 0) first = std::max(first, at);
    if (rise > 0) last = std::min(last, at);
  }
  query.first = first;
  query.last = last;
}

// --- Planes ----------------------------------------------------------------------------------------------------------

// 0: a vertex is on the plane. Without rounding: the numbers are multiples of 2^-40 below 2^12.
std::uint64_t edges_across(const SphereBody& body, const Plane& plane) {
  const auto vertices = body.hull.vertices();
  std::vector<signed char> signs;
  for (const Point3& v : vertices) {
    const double height = dot(plane.normal, v) - plane.offset;
    if (height == 0) return 0;
    signs.push_back(height > 0 ? 1 : -1);
  }
  std::uint64_t count = 0;
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    for (const std::uint32_t w : body.hull.neighbours(v)) count += signs[v] < signs[w];
  }
  return count;
}

Point3 some_normal(PlaneFamily family, Random& random) {
  if (family == PlaneFamily::level) return {0, 0, 1};
  for (;;) {
    const Point3 normal = sunder::tests::on_grid(random, 1000);
    if (normal != Point3{}) return normal;
  }
}

}  // namespace

std::string_view name_of(LineFamily family) {
  constexpr std::array<std::string_view, 5> names{"hits", "by vertices", "by edges", "near misses", "far misses"};
  return names.at(static_cast<std::size_t>(family));
}

SphereBody make_sphere_body(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point3> points;
  for (const Point3& p : sunder::tests::points_on_sphere(n, random)) {
    points.push_back(
        {sunder::tests::snapped(p.x, kBits), sunder::tests::snapped(p.y, kBits), sunder::tests::snapped(p.z, kBits)});
  }
  SphereBody body{sunder::solid::ConvexPolyhedron(points), {}};
  if (body.hull.vertices().size() != n) throw std::logic_error("not all points are vertices");
  for (std::uint32_t f = 0; f < body.hull.facet_count(); ++f) {
    const auto facet = body.hull.facet(f);
    for (std::size_t k = 1; k + 1 < facet.size(); ++k) body.triangles.push_back({facet[0], facet[k], facet[k + 1]});
  }
  return body;
}

LineScenario make_line_scenario(const SphereBody& body, LineFamily family, std::size_t queries, std::uint64_t seed) {
  Random random(seed);
  LineScenario made{&body, {}};
  const std::vector<Facet> facets = facets_of(body);
  for (std::size_t k = 0; k < queries; ++k) {
    LineQuery query = by_family(body, family, k, random);
    if (query.meet() && query.first == HUGE_VAL) find_ends(facets, query);
    made.queries.push_back(query);
  }
  return made;
}

SectionScenario make_section_scenario(const SphereBody& body, PlaneFamily family, std::size_t queries,
                                      std::uint64_t seed) {
  Random random(seed);
  SectionScenario made{&body, {}};
  while (made.queries.size() < queries) {
    const Point3 normal = some_normal(family, random);
    const double offset = sunder::tests::snapped(random.uniform(-0.95, 0.95) * std::sqrt(dot(normal, normal)), kBits);
    const Plane plane = Plane::at(normal, offset);
    const std::uint64_t corners = edges_across(body, plane);
    if (corners > 0) made.queries.push_back({plane, corners});
  }
  if (family == PlaneFamily::level) {
    std::sort(made.queries.begin(), made.queries.end(),
              [](const SectionQuery& p, const SectionQuery& q) { return p.plane.offset < q.plane.offset; });
  }
  return made;
}

PolygonScenario make_polygon_scenario(const SphereBody& body, std::size_t queries, std::uint64_t seed) {
  Random random(seed);
  PolygonScenario made{&body, {}};
  while (made.queries.size() < queries) {
    const Point3 v = some_vertex(body, random);
    if (std::fabs(v.z) > kInside) continue;
    const bool meet = made.queries.size() % 2 == 0;
    const double gap = random.log_uniform(kNearGap, kFarGap);
    // The body lies within the cylinder about the axis through v, at the height of v.
    const double distance = std::hypot(v.x, v.y), from = (meet ? -gap : gap) / distance, radius = 1;
    const Point3 near{v.x * (1 + from), v.y * (1 + from), v.z};
    const Point3 center{near.x + radius * v.x / distance, near.y + radius * v.y / distance, v.z};
    const double begin = std::atan2(near.y - center.y, near.x - center.x);
    std::vector<Point3> points{near};
    for (std::size_t k = 1; k < kPolygonVertices; ++k) {
      const double angle =
          begin + 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(kPolygonVertices);
      points.push_back({center.x + radius * std::cos(angle), center.y + radius * std::sin(angle), v.z});
    }
    made.queries.push_back({sunder::solid::ConvexPolyhedron(points), meet});
  }
  return made;
}

SideScenario make_side_scenario(const SphereBody& body, std::size_t queries, std::uint64_t seed) {
  Random random(seed);
  SideScenario made{&body, {}};
  for (std::size_t k = 0; k < queries; ++k) {
    const Point3 v = some_vertex(body, random);
    const double gap = random.log_uniform(kNearGap, kFarGap);
    const bool meet = k % 2 == 0;
    made.queries.push_back({Plane::through(plus(v, v, meet ? -gap : gap), v), meet});
  }
  return made;
}

}  // namespace bench
