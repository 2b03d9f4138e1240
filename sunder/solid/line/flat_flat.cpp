#include <sunder/base/contract.h>
#include <sunder/number/exact_vector.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/line/flat_flat.h>
#include <sunder/solid/line/plane_line.h>
#include <sunder/solid/line/plane_plane.h>

#include <optional>
#include <utility>

namespace sunder::solid {

namespace {

Exact3 lifted(const Point3& p) { return coordinates<Dyadic>(p); }
Exact3 negative(const Exact3& v) { return {-v.x, -v.y, -v.z}; }
Exact3 from_to(const Point3& p, const Point3& q) { return lifted(q) - lifted(p); }
std::array<Dyadic, 3> array_of(const Exact3& v) { return {v.x, v.y, v.z}; }
bool is_positive(const Dyadic& x) { return x.sign() == Sign::positive; }

const Plane* plane_of(const Flat& flat) { return std::get_if<Plane>(&flat); }

// Requires no plane.
Linear linear_of(const Flat& flat) {
  if (const auto* line = std::get_if<Line>(&flat)) return *line;
  if (const auto* ray = std::get_if<Ray>(&flat)) return *ray;
  if (const auto* segment = std::get_if<Segment>(&flat)) return *segment;
  return std::get<Point3>(flat);
}

ExactPoint3 over(const Exact3& numerators, const Dyadic& denominator) {
  const bool turn = denominator.sign() == Sign::negative;
  const Exact3 n = turn ? negative(numerators) : numerators;
  return {n.x, n.y, n.z, turn ? -denominator : denominator};
}

ExactPoint3 middle(const Point3& p, const Point3& q) { return over(sum(lifted(p), lifted(q)), 2.0); }

// ---- Two planes.

// Of those that meet in a line, x with m . x = c and n . x = d is (c (n x l) + d (l x m)) / l . l, where l = m x n; of
// one plane, what its normal leads to.
ExactPoint3 of_planes(const Plane& a, const Plane& b, FlatKind kind) {
  const Exact3 m = lifted(a.normal), n = lifted(b.normal), l = cross(m, n);
  if (kind == FlatKind::plane) return over(times(level(a), m), dot(m, m));
  return over(sum(times(level(a), cross(n, l)), times(level(b), cross(l, m))), dot(l, l));
}

// Of planes that are parallel: the levels over the normals' sizes, as one turns with the other.
Exact3 parting_planes(const Plane& a, const Plane& b) {
  const Exact3 m = lifted(a.normal), n = lifted(b.normal);
  const Dyadic both = dot(m, n);
  const Dyadic gap = level(b) * dot(m, m) - level(a) * both;  // b's level along m, times both
  return is_positive(gap * both) ? m : negative(m);
}

// ---- A plane and a line, or a part of one.

ExactPoint3 of_plane(const Plane& plane, const Linear& linear) {
  const Dyadic a = height(plane, exactly(linear.a)), b = height(plane, exactly(linear.b)), rise = b - a;
  if (rise.sign() == Sign::zero) return middle(linear.a, linear.b);  // in the plane
  return over(sum(times(b, lifted(linear.a)), times(-a, lifted(linear.b))), rise);
}

// From the plane to what is on one side of it.
Exact3 from_plane(const Plane& plane, const Linear& linear) {
  const Dyadic a = height(plane, exactly(linear.a));
  const bool is_above = a.sign() == Sign::zero ? is_positive(height(plane, exactly(linear.b))) : is_positive(a);
  const Exact3 n = lifted(plane.normal);
  return is_above ? n : negative(n);
}

// ---- Two lines, or parts of them.

struct Lines {
  const Linear &p, &q;
  Exact3 u = lifted(p.b) - lifted(p.a), v = lifted(q.b) - lifted(q.a), w = lifted(q.a) - lifted(p.a);
  Exact3 n = cross(u, v);
  Dyadic square = dot(n, n);

  bool are_parallel() const { return square.sign() == Sign::zero; }

  // Times the square: where on p the other line crosses, and on q. (Of lines in one plane that are not parallel.)
  Dyadic on_p() const { return dot(cross(w, v), n); }
  Dyadic on_q() const { return dot(cross(w, u), n); }

  bool is_in(const Linear& l, const Dyadic& at) const {
    return !(l.begins && at.sign() == Sign::negative) && !(l.ends && is_positive(at - square));
  }
  // Is the crossing in an end? Then which is the other point?
  std::optional<Point3> beyond_end(const Linear& l, const Dyadic& at) const {
    if (l.begins && at.sign() == Sign::zero) return l.b;
    if (l.ends && (at - square).sign() == Sign::zero) return l.a;
    return std::nullopt;
  }

  // ---- On one line.

  std::size_t axis() const {
    const Linear& l = p.is_point() ? q : p;
    return l.a.x != l.b.x ? 0 : l.a.y != l.b.y ? 1 : 2;
  }
  // The ends of l, the one with the lesser coordinate first.
  std::array<std::optional<Point3>, 2> ends(const Linear& l) const {
    std::array<std::optional<Point3>, 2> result;
    if (l.begins) result[0] = l.a;
    if (l.ends) result[1] = l.b;
    if (l.a[axis()] > l.b[axis()]) std::swap(result[0], result[1]);
    return result;
  }
  bool are_collinear() const {
    const Exact3 along = p.is_point() ? v : u, off = cross(along, w);
    return dot(off, off).sign() == Sign::zero;
  }
  // The ends of what they have in common.
  std::array<std::optional<Point3>, 2> common_ends() const {
    const auto [p_low, p_high] = ends(p);
    const auto [q_low, q_high] = ends(q);
    const std::size_t k = axis();
    return {!q_low || (p_low && (*p_low)[k] >= (*q_low)[k]) ? p_low : q_low,
            !q_high || (p_high && (*p_high)[k] <= (*q_high)[k]) ? p_high : q_high};
  }
  ExactPoint3 point_of_line() const {
    const auto [low, high] = common_ends();
    const std::size_t k = axis();
    if (low && high) return middle(*low, *high);
    if (!low && !high) return exactly(p.a);
    const bool is_up = (p.a[k] < p.b[k]) == low.has_value();
    return over(sum(lifted(low ? *low : *high), is_up ? u : negative(u)), 1.0);
  }
  Exact3 parting_line() const {
    const std::size_t k = axis();
    const auto p_high = ends(p)[1], q_low = ends(q)[0];
    const Dyadic one = p_high && q_low && (*p_high)[k] <= (*q_low)[k] ? 1.0 : -1.0, zero;
    return {k == 0 ? one : zero, k == 1 ? one : zero, k == 2 ? one : zero};
  }

  // ---- All.

  ExactPoint3 point() const {
    if (p.is_point()) return exactly(p.a);
    if (q.is_point()) return exactly(q.a);
    if (are_parallel()) return point_of_line();
    return over(sum(times(square, lifted(p.a)), times(on_p(), u)), square);
  }

  Exact3 parting(bool touch) const {
    if (are_parallel()) {
      const Exact3& along = p.is_point() ? v : u;
      if (p.is_point() && q.is_point()) return w;
      if (are_collinear()) return parting_line();
      return times(dot(along, along), w) - times(dot(along, w), along);  // across the lines
    }
    const Dyadic apart = dot(n, w);
    if (apart.sign() != Sign::zero) return is_positive(apart) ? n : negative(n);
    // Within their plane: along what is across one of the lines, and the other thing is on one side of that.
    const Dyadic at_p = on_p(), at_q = on_q();
    const auto of_p = beyond_end(p, at_p), of_q = beyond_end(q, at_q);
    if (touch ? of_p.has_value() : !is_in(p, at_p)) {
      const Exact3 across = cross(n, v);
      return is_positive(dot(across, lifted(touch ? *of_p : p.a) - lifted(q.a))) ? negative(across) : across;
    }
    const Exact3 across = cross(n, u);
    return is_positive(dot(across, lifted(touch ? *of_q : q.a) - lifted(p.a))) ? across : negative(across);
  }
};

}  // namespace

FlatCommon flat_flat(const Flat& a, const Flat& b) {
  const Plane *plane_a = plane_of(a), *plane_b = plane_of(b);
  if (plane_a != nullptr && plane_b != nullptr) return plane_plane(*plane_a, *plane_b);
  if (plane_a != nullptr) return plane_linear(*plane_a, linear_of(b));
  if (plane_b != nullptr) return plane_linear(*plane_b, linear_of(a));
  return linear_linear(linear_of(a), linear_of(b));
}

ExactPoint3 common_point(const Flat& a, const Flat& b, const FlatCommon& common) {
  SUNDER_REQUIRE(common.meet());
  const Plane *plane_a = plane_of(a), *plane_b = plane_of(b);
  if (plane_a != nullptr && plane_b != nullptr) return of_planes(*plane_a, *plane_b, common.evidence.kind);
  if (plane_a != nullptr) return of_plane(*plane_a, linear_of(b));
  if (plane_b != nullptr) return of_plane(*plane_b, linear_of(a));
  const Linear p = linear_of(a), q = linear_of(b);
  return Lines{p, q}.point();
}

std::array<Dyadic, 3> parting(const Flat& a, const Flat& b, const FlatCommon& common) {
  SUNDER_REQUIRE(common.evidence.contact != Relation::overlapping);
  const Plane *plane_a = plane_of(a), *plane_b = plane_of(b);
  if (plane_a != nullptr && plane_b != nullptr) return array_of(parting_planes(*plane_a, *plane_b));
  if (plane_a != nullptr) return array_of(from_plane(*plane_a, linear_of(b)));
  if (plane_b != nullptr) return array_of(negative(from_plane(*plane_b, linear_of(a))));
  const Linear p = linear_of(a), q = linear_of(b);
  return array_of(Lines{p, q}.parting(common.meet()));
}

std::optional<FlatPart> common_part(const Flat& a, const Flat& b, const FlatCommon& common) {
  if (common.evidence.kind != FlatKind::point && common.evidence.kind != FlatKind::segment) return std::nullopt;
  const Plane *plane_a = plane_of(a), *plane_b = plane_of(b);
  const bool is_point = common.evidence.kind == FlatKind::point;
  if (plane_a != nullptr || plane_b != nullptr) {
    const Linear linear = linear_of(plane_a != nullptr ? b : a);
    if (linear.is_point()) return std::nullopt;
    if (!is_point)
      return FlatPart{exactly(linear.a), exactly(linear.b), from_to(linear.a, linear.b), plane_b != nullptr};
    const ExactPoint3 x = common_point(a, b, common);
    return FlatPart{x, x, lifted((plane_a != nullptr ? plane_a : plane_b)->normal), plane_b != nullptr};
  }
  const Linear p = linear_of(a), q = linear_of(b);
  if (p.is_point() && q.is_point()) return std::nullopt;
  const Lines lines{p, q};
  if (!lines.are_parallel()) return FlatPart{lines.point(), lines.point(), cross(lines.n, lines.u), false};
  const Exact3& along = q.is_point() ? lines.u : lines.v;
  if (is_point) return FlatPart{lines.point(), lines.point(), along, q.is_point()};
  const auto [low, high] = lines.common_ends();
  return FlatPart{exactly(*low), exactly(*high), from_to(*low, *high), false};
}

void add_common_part(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b, const Flat& a,
                     const FlatBody& body_a, const Flat& b, const FlatBody& body_b, const FlatPart& part) {
  const auto point = [&](const ExactPoint3& x) {
    CommonPoint result{x, combination_of(a, body_a, x, false), combination_of(b, body_b, x, false)};
    if (part.along_a) std::swap(result.of_a, result.of_b);
    return result;
  };
  if (part.along_a) std::swap(index_a, index_b);
  pairs.add_common_part(index_a, index_b, point(part.first), point(part.last), array_of(negative(part.across)),
                        array_of(part.across));
}

void add_claims(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b, const Flat& a, const FlatBody& body_a,
                const Flat& b, const FlatBody& body_b, const FlatCommon& common, bool tells_contact) {
  if (!common.meet()) return pairs.add_apart(index_a, index_b, parting(a, b, common));
  const ExactPoint3 x = common_point(a, b, common);
  const bool is_inside = tells_contact && common.evidence.contact == Relation::overlapping;
  const CommonPoint point{x, combination_of(a, body_a, x, is_inside), combination_of(b, body_b, x, is_inside)};
  if (!tells_contact) return pairs.add_meet(index_a, index_b, point);
  if (is_inside) return pairs.add_overlapping(index_a, index_b, point);
  pairs.add_touching(index_a, index_b, point, parting(a, b, common));
}

}  // namespace sunder::solid
