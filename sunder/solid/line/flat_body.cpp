#include <sunder/number/exact_vector.h>
#include <sunder/number/integer_internal.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/line/flat_body.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace sunder::solid {

namespace {

// From p to x, times the denominator of x.
Exact3 way_to(const ExactPoint3& x, const Point3& p) {
  return Exact3{x.x, x.y, x.z} - times(x.denominator, coordinates<Dyadic>(p));
}

// The double that x is, if it is one.
std::optional<double> as_double(const Dyadic& x) {
  const double value = x.nearest();
  if (!std::isfinite(value) || !(Dyadic(value) == x)) return std::nullopt;
  return value + 0.0;
}

// ---- A point of a plane.

// An odd whole number below 2^53 in size, times 2^exponent; 0 for zero.
struct OddMantissa {
  std::int64_t odd = 0;
  int exponent = 0;
};

OddMantissa odd_mantissa(double x) {
  if (x == 0) return {};
  int exponent = 0;
  auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  exponent -= 53;
  while (mantissa % 2 == 0) {
    mantissa /= 2;
    ++exponent;
  }
  return {mantissa, exponent};
}

// g = s a + t b for odd a, b.
struct Bezout {
  std::int64_t g, s, t;
};
Bezout bezout(std::int64_t a, std::int64_t b) {
  std::int64_t s0 = 1, t0 = 0, s1 = 0, t1 = 1;
  while (b != 0) {
    const std::int64_t q = a / b;
    a = std::exchange(b, a - q * b);
    s0 = std::exchange(s1, s0 - q * s1);
    t0 = std::exchange(t1, t0 - q * t1);
  }
  return {a, s0, t0};
}

// x and y with p x + q y = c, small where there are many. With odd mantissas P, Q of p, q and R 2^k of c for whole
// numbers X, Y: P X + Q Y = R 2^k; the more bits k has, the finer the grid that X and Y may be chosen from.
std::optional<std::array<double, 2>> on_two_axes(double p, double q, double c) {
  const OddMantissa P = odd_mantissa(p), Q = odd_mantissa(q), R = odd_mantissa(c);
  if (P.odd == 0 || Q.odd == 0) return std::nullopt;
  const auto [g, s, t] = bezout(P.odd, Q.odd);
  if (R.odd % g != 0) return std::nullopt;
  const std::int64_t a = P.odd / g, b = Q.odd / g, r = R.odd / g;
  for (const int k : {50, 40, 30, 20, 10, 0}) {
    // X = s r 2^k modulo b, of the size of b at most.
    const Integer shifted = Integer(r) << k, x = Integer(s) * shifted % b, y = (shifted - Integer(a) * x) / b;
    const auto u = as_double(dyadic_of(x, R.exponent - k - P.exponent));
    const auto v = as_double(dyadic_of(y, R.exponent - k - Q.exponent));
    if (u && v) return std::array{*u, *v};
  }
  return std::nullopt;
}

// The point from which the offset is measured, moved by d, if that is exact and on the plane.
std::optional<Point3> moved(const Plane& plane, const std::array<double, 3>& d) {
  Point3 x;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto sum = as_double(Dyadic(plane.point[k]) + Dyadic(d[k]));
    if (!sum) return std::nullopt;
    x[k] = *sum;
  }
  if (height(plane, exactly(x)).sign() != Sign::zero) return std::nullopt;
  return x;
}

// ---- Combinations.

// A list of parts without zeros.
struct Sum {
  Combination combination;

  void add(std::uint32_t entry, const Dyadic& weight) {
    if (weight.sign() != Sign::zero) combination.parts.push_back({entry, weight});
  }
  // The way `forth`, and the one after it, which goes back, both with `both` besides.
  void add_both_ways(std::uint32_t forth, const Dyadic& along, const Dyadic& both) {
    const bool is_back = along.sign() == Sign::negative;
    add(forth, is_back ? both : both + along);
    add(forth + 1, is_back ? both - along : both);
  }
};

// The parameter t with x = a + t (b - a). Requires x on the line through a and b.
ExactFraction parameter(const Point3& a, const Point3& b, const ExactPoint3& x) {
  const Exact3 way = coordinates<Dyadic>(b) - coordinates<Dyadic>(a);
  return {dot(way, way_to(x, a)), dot(way, way) * x.denominator};
}

Combination of_plane(const Plane& plane, const FlatBody& body, const ExactPoint3& x, bool is_inside) {
  const Exact3 d = way_to(x, body.points[0]);
  const std::array<Dyadic, 3> normal{plane.normal.x, plane.normal.y, plane.normal.z};
  const std::array<double, 3> sizes{std::fabs(plane.normal.x), std::fabs(plane.normal.y), std::fabs(plane.normal.z)};
  const auto pivot = static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  const bool is_negative = normal[pivot].sign() == Sign::negative;
  const Dyadic whole = (is_negative ? -normal[pivot] : normal[pivot]) * x.denominator;
  // d is the sum of two ways, with these weights, each over the pivot: (-b, a, 0) is entry 1, (-c, 0, a) 3, (0, -c,
  // b) 5.
  const std::array<std::pair<std::uint32_t, Dyadic>, 2> along =
      pivot == 0   ? std::array{std::pair{1u, d.y}, std::pair{3u, d.z}}
      : pivot == 1 ? std::array{std::pair{1u, -d.x}, std::pair{5u, d.z}}
                   : std::array{std::pair{3u, -d.x}, std::pair{5u, -d.y}};
  Sum sum{{{}, whole}};
  sum.add(0, whole);
  for (const auto& [entry, weight] : along) {
    sum.add_both_ways(entry, is_negative ? -weight : weight, is_inside ? whole : Dyadic());
  }
  return sum.combination;
}

}  // namespace

Dyadic level(const Plane& plane) {
  return dot(coordinates<Dyadic>(plane.normal), coordinates<Dyadic>(plane.point)) + Dyadic(plane.offset);
}

Dyadic height(const Plane& plane, const ExactPoint3& x) {
  return dot(coordinates<Dyadic>(plane.normal), way_to(x, plane.point)) - Dyadic(plane.offset) * x.denominator;
}

std::optional<Point3> exact_point_of(const Plane& plane) {
  if (plane.offset == 0) return plane.point;
  const Point3& n = plane.normal;
  for (std::size_t k = 0; k < 3; ++k) {
    if (n[k] == 0) continue;
    std::array<double, 3> d{};
    d[k] = plane.offset / n[k];
    if (!std::isfinite(d[k])) continue;
    if (const auto found = moved(plane, d)) return found;
  }
  for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
    const auto two = on_two_axes(n[i], n[j], plane.offset);
    if (!two) continue;
    std::array<double, 3> d{};
    d[i] = (*two)[0];
    d[j] = (*two)[1];
    if (const auto found = moved(plane, d)) return found;
  }
  return std::nullopt;
}

std::optional<FlatBody> body_of(const Flat& flat) {
  if (const auto* plane = std::get_if<Plane>(&flat)) {
    const std::optional<Point3> point = exact_point_of(*plane);
    if (!point) return std::nullopt;
    const auto& [a, b, c] = plane->normal;
    FlatBody body{{*point}, {}};
    for (const Point3& way : {Point3{-b, a, 0}, {-c, 0, a}, {0, -c, b}}) {
      body.ways.push_back({{}, {way.x + 0.0, way.y + 0.0, way.z + 0.0}});
      body.ways.push_back({{}, {0.0 - way.x, 0.0 - way.y, 0.0 - way.z}});
    }
    return body;
  }
  if (const auto* point = std::get_if<Point3>(&flat)) return FlatBody{{*point}, {}};
  if (const auto* segment = std::get_if<Segment>(&flat)) {
    return segment->a == segment->b ? FlatBody{{segment->a}, {}} : FlatBody{{segment->a, segment->b}, {}};
  }
  if (const auto* ray = std::get_if<Ray>(&flat)) return FlatBody{{ray->a}, {{ray->a, ray->b}}};
  const auto& line = std::get<Line>(flat);
  return FlatBody{{line.a}, {{line.a, line.b}, {line.b, line.a}}};
}

Combination combination_of(const Flat& flat, const FlatBody& body, const ExactPoint3& x, bool is_inside) {
  if (const auto* plane = std::get_if<Plane>(&flat)) return of_plane(*plane, body, x, is_inside);
  if (body.points.size() == 1 && body.ways.empty()) return {{{0, 1.0}}};
  if (const auto* segment = std::get_if<Segment>(&flat)) {
    const auto [part, whole] = parameter(segment->a, segment->b, x);
    Sum sum{{{}, whole}};
    sum.add(0, whole - part);
    sum.add(1, part);
    return sum.combination;
  }
  const auto* ray = std::get_if<Ray>(&flat);
  const auto [part, whole] =
      ray != nullptr ? parameter(ray->a, ray->b, x) : parameter(std::get<Line>(flat).a, std::get<Line>(flat).b, x);
  Sum sum{{{}, whole}};
  sum.add(0, whole);
  if (ray != nullptr) {
    sum.add(1, part);
  } else {
    sum.add_both_ways(1, part, is_inside ? whole : Dyadic());
  }
  return sum.combination;
}

}  // namespace sunder::solid
