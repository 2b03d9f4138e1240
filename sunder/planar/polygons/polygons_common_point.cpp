// Two polygons that overlap do so as near as one likes to the place that shows it. So some sector between the edges
// there is inside of both; and of a ray within the sector, what comes before it meets another edge.
#include <sunder/number/vector.h>
#include <sunder/planar/polygons/polygons_common_point.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace sunder::planar {

namespace {

using Vector = Vector2<Dyadic>;

Sign cross_sign(const Vector& u, const Vector& v) { return cross(u, v).sign(); }
bool is_zero(const Vector& u) { return u.x.sign() == Sign::zero && u.y.sign() == Sign::zero; }
// Is u left, or straight below, of the origin?
bool is_before(const Vector& u) {
  return u.x.sign() == Sign::negative || (u.x.sign() == Sign::zero && u.y.sign() == Sign::negative);
}

// An edge seen from a place, its lexicographically first end first; all times the denominator of the place.
struct Edge {
  Vector a, b;

  bool holds_origin() const {
    if (is_zero(a) || is_zero(b)) return true;
    return is_before(a) && !is_before(b) && cross_sign(a, b) == Sign::zero;
  }
};

std::vector<Edge> edges_from(const Polygon& polygon, const ExactPoint2& place) {
  const auto from = [&](const Point2& p) {
    return Vector{Dyadic(p.x) * place.denominator - place.x, Dyadic(p.y) * place.denominator - place.y};
  };
  std::vector<Edge> edges;
  edges.reserve(polygon.size());
  for (std::uint32_t k = 0; k < polygon.size(); ++k) {
    const Segment s = sorted(polygon.edge(k));
    edges.push_back({from(s.a), from(s.b)});
  }
  return edges;
}

// Is the vector inside, by the number of edges below its point? Requires that this is on no edge.
bool is_inside(const std::vector<Edge>& edges, const Vector& v) {
  bool inside = false;
  for (const Edge& edge : edges) {
    const Vector from_a = v - edge.a, from_b = v - edge.b;
    if (is_before(from_a) || !is_before(from_b)) continue;
    inside ^= cross_sign(from_a, from_b) == Sign::negative;
  }
  return inside;
}

// A power of two below the fraction, which is positive.
Dyadic power_below(const ExactFraction& x) { return Dyadic::power_of_two(x.numerator.top() - x.denominator.top() - 1); }

// How many times the direction the ray goes until it meets the edge.
std::optional<ExactFraction> way_to(const Edge& edge, const Vector& direction) {
  const Dyadic at_a = cross(direction, edge.a), at_b = cross(direction, edge.b);
  if (at_a.sign() == Sign::zero || at_b.sign() == Sign::zero) {
    const Vector& end = at_a.sign() == Sign::zero ? edge.a : edge.b;  // one at the nearer end ends there too
    const Dyadic n = dot(direction, end);
    if (n.sign() == Sign::positive) return ExactFraction{n, dot(direction, direction)};
    return std::nullopt;
  }
  if (at_a.sign() == at_b.sign()) return std::nullopt;
  const Dyadic d = at_b - at_a, n = cross(edge.a, edge.b);
  if (n.sign() != d.sign()) return std::nullopt;
  return ExactFraction::quotient(n, d);
}

// One direction within each sector at the place.
std::vector<Vector> between_edges(const std::array<std::vector<Edge>, 2>& edges) {
  const Dyadic one(1.0), none;
  std::vector<Vector> all{{one, none}, {none, one}, {-one, none}, {none, -one}};  // so sectors are a quarter at most
  for (const std::vector<Edge>& of_polygon : edges) {
    for (const Edge& edge : of_polygon) {
      if (!edge.holds_origin()) continue;
      if (!is_zero(edge.a)) all.push_back(edge.a);
      if (!is_zero(edge.b)) all.push_back(edge.b);
    }
  }
  const auto less = [](const Vector& u, const Vector& v) {
    if (is_before(u) != is_before(v)) return is_before(v);
    return cross_sign(u, v) == Sign::positive;
  };
  std::sort(all.begin(), all.end(), less);
  std::vector<Vector> between;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Vector &u = all[k], &v = all[k + 1 == all.size() ? 0 : k + 1];
    if (cross_sign(u, v) == Sign::positive) between.push_back(u + v);
  }
  return between;
}

std::optional<ExactPoint2> inside_both_near(const Polygon& a, const Polygon& b, const ExactPoint2& place) {
  const std::array<std::vector<Edge>, 2> edges{edges_from(a, place), edges_from(b, place)};
  for (const Vector& direction : between_edges(edges)) {
    std::optional<ExactFraction> least;
    for (const std::vector<Edge>& of_polygon : edges) {
      for (const Edge& edge : of_polygon) {
        if (edge.holds_origin()) continue;
        const std::optional<ExactFraction> way = way_to(edge, direction);
        if (way && (!least || *way < *least)) least = way;
      }
    }
    if (!least) continue;  // the ray leaves both
    const Dyadic part = power_below(*least);
    const Vector v{direction.x * part, direction.y * part};
    if (!is_inside(edges[0], v) || !is_inside(edges[1], v)) continue;
    return ExactPoint2{place.x + v.x, place.y + v.y, place.denominator};
  }
  return std::nullopt;
}

}  // namespace

ExactPoint2 found_point(const Polygon& a, const Polygon& b, const PolygonsContact& found) {
  if (found.kind == ContactKind::none) {
    return exactly(found.i_inside ? a.vertices()[found.of_i] : b.vertices()[found.of_j]);
  }
  return common_point(sorted(a.edge(found.of_i)), sorted(b.edge(found.of_j)));
}

ExactPoint2 common_point(const Polygon& a, const Polygon& b, const PolygonsContact& found) {
  if (found.kind == ContactKind::none) {
    const ExactPoint2 vertex = found_point(a, b, found);
    return inside_both_near(a, b, vertex).value_or(vertex);
  }
  const Segment s = sorted(a.edge(found.of_i)), t = sorted(b.edge(found.of_j));
  const auto [first, last] = common_part(s, t);
  const bool is_overlap = found.kind == ContactKind::overlap;
  ExactPoint2 common = is_overlap ? ExactPoint2{Dyadic(first.x) + Dyadic(last.x), Dyadic(first.y) + Dyadic(last.y), 2.0}
                                  : common_point(s, t);
  if (found.contact != Relation::overlapping) return common;
  if (!is_overlap) return inside_both_near(a, b, common).value_or(common);
  for (const Point2& end : {first, last}) {
    if (const std::optional<ExactPoint2> inside = inside_both_near(a, b, exactly(end))) return *inside;
  }
  return common;
}

}  // namespace sunder::planar
