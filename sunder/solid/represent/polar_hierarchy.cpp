#include <sunder/number/vector.h>
#include <sunder/predicate/posed.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/bounded_builder.h>
#include <sunder/solid/represent/hierarchy_builder.h>
#include <sunder/solid/represent/polar.h>
#include <sunder/solid/represent/polar_hierarchy.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace sunder::solid {

namespace {

// A power of two by which every coordinate is multiplied exactly: it makes the points about 1 long along the axis, or
// where a coordinate would vanish, as long as need be.
double power_to_one(std::span<const Point3> points, double Point3::* axis) {
  const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                               [&](const Point3& p, const Point3& q) { return p.*axis < q.*axis; });
  const double half = (*high).*axis / 2 - (*low).*axis / 2;  // halves: no overflow
  if (!(half > 0)) return 1;
  SizeRange sizes;
  for (const Point3& p : points) sizes.include(p.*axis);
  const int least = std::min(-1022 - std::ilogb(sizes.least), 0);  // all are normal numbers then, or not made smaller
  return std::ldexp(1.0, std::clamp(std::max(-std::ilogb(half) - 1, least), -1022, 1022));
}

// What a linear map M makes of planes n.x = h: the normals are n' with n'.M x = n.x, all times the determinant of M.
template <class T>
class MapOfForms {
 public:
  explicit MapOfForms(const RoundFrame& map) {
    const auto lift = [](const Point3& p) { return Vector3<T>{T(p.x), T(p.y), T(p.z)}; };
    const Vector3<T> i = lift(map.row[0]), j = lift(map.row[1]), k = lift(map.row[2]);
    row_ = {cross(j, k), cross(k, i), cross(i, j)};
    determinant_ = dot(i, row_[0]);
  }
  PolarVertexOf<T> operator()(const PolarVertexOf<T>& plane) const {
    const Vector3<T> n{plane.n[0], plane.n[1], plane.n[2]};
    return {{dot(row_[0], n), dot(row_[1], n), dot(row_[2], n)}, determinant_ * plane.h};
  }

 private:
  std::array<Vector3<T>, 3> row_;
  T determinant_;
};

struct RoundedPolarVertex {
  Point3 at;
  double error;  // of each coordinate
  bool is_close = true;
};

RoundedPolarVertex rounded_vertex(const PolarVertexOf<Estimate>& v) {
  const double h = v.h.value.high;
  RoundedPolarVertex result{{v.n[0].value.high / h, v.n[1].value.high / h, v.n[2].value.high / h}, 0};
  const double size = std::max({std::fabs(result.at.x), std::fabs(result.at.y), std::fabs(result.at.z)});
  const double error_n = std::max({v.n[0].error, v.n[1].error, v.n[2].error});
  // Relative errors below 2^-30, or it is not close; three roundings; the quotients here.
  result.error = (error_n / h + size * (v.h.error / h + 0x1p-50)) * (1 + 0x1p-20);
  result.is_close = h > 0 && result.error <= 0x1p-30 * size && size > 0x1p-900 && size < 0x1p900;
  return result;
}
RoundedPolarVertex rounded_vertex(const PolarVertex& v) {
  const Point3 at{nearest_ratio(v.n[0], v.h), nearest_ratio(v.n[1], v.h), nearest_ratio(v.n[2], v.h)};
  return {at, std::max({std::fabs(at.x), std::fabs(at.y), std::fabs(at.z)}) * 0x1p-52 + 0x1p-1000};
}

// The facets as vertices of the polar.
class FacetsAsPoints {
 public:
  FacetsAsPoints(std::span<const Point3> points, std::span<const std::uint32_t> corner_begin,
                 std::span<const std::uint32_t> corners, const RoundFrame& to_round, Polar& polar)
      : points_(points),
        corner_begin_(corner_begin),
        corners_(corners),
        polar_(polar),
        to_round_(to_round),
        place_about_corner_(corners.size()),
        place_(polar.vertices.size(), 0) {
    for (std::uint32_t v = 0; v + 1 < polar.facet_begin.size(); ++v) {
      for (std::uint32_t place = polar.facet_begin[v]; place < polar.facet_begin[v + 1]; ++place) {
        const std::uint32_t f = polar.facet_vertices[place];
        if (facet(f).size() > most_corners) continue;
        for (std::uint32_t i = corner_begin[f]; i < corner_begin[f + 1]; ++i) {
          if (corners[i] == v) place_about_corner_[i] = place;
        }
      }
    }
    if (to_round.is_identity) return;
    const MapOfForms<Estimate> estimate(to_round);
    const MapOfForms<Dyadic> exact(to_round);
    for (std::uint32_t f = 0; f < polar.vertices.size(); ++f) {
      RoundedPolarVertex mapped = rounded_vertex(estimate(estimated_polar_vertex(points, facet(f), polar.base)));
      if (!mapped.is_close) mapped = rounded_vertex(exact(exact_polar_vertex(points, facet(f), polar.base)));
      polar.vertices[f] = mapped.at;
      polar.errors[f] = mapped.error;
    }
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(polar_.vertices.size()); }
  const Point3& at(std::uint32_t f) const { return polar_.vertices[f]; }

  // For bounded_builder.h. Cut points are made in the frame before it is made round, and held in the round one.
  ExactPoint3 exact(std::uint32_t f) const {
    const PolarVertex v = exact_polar_vertex(points_, facet(f), polar_.base);
    return {v.n[0], v.n[1], v.n[2], v.h};
  }
  EstimatedPoint3 estimated(std::uint32_t f) const {
    const PolarVertexOf<Estimate> v = estimated_polar_vertex(points_, facet(f), polar_.base);
    return {{v.n[0], v.n[1], v.n[2]}, v.h};
  }
  Point3 rounded(std::uint32_t f) const {
    if (to_round_.is_identity) return at(f);
    const EstimatedPoint3 v = estimated(f);
    const double h = v.denominator.value.high;
    return {v.numerators.x.value.high / h, v.numerators.y.value.high / h, v.numerators.z.value.high / h};
  }
  std::array<Point3, 2> at(const ExactPoint3& p, const EstimatedPoint3& estimate) const {
    if (to_round_.is_identity) return hierarchy_detail::rounded_and_rest(p, estimate);
    const PolarVertex v = MapOfForms<Dyadic>(to_round_)({{p.x, p.y, p.z}, p.denominator});
    const ExactPoint3 mapped{v.n[0], v.n[1], v.n[2], v.h};
    return hierarchy_detail::rounded_and_rest(mapped, sunder::estimated(mapped));
  }

  Sign orient(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    if (const std::optional<Sign> sure = orient_rounded(a, b, c, d)) return *sure;
    if (const std::optional<Sign> sure = orient_by_corners({a, b, c, d})) return *sure;
    switch (sign(determinant(estimates_of({a, b, c, d})))) {
      case Guess::positive: return Sign::negative;
      case Guess::negative: return Sign::positive;
      default: return -determinant(exact({a, b, c, d})).sign();
    }
  }

  std::span<const std::uint32_t> facet(std::uint32_t f) const {
    return corners_.subspan(corner_begin_[f], corner_begin_[f + 1] - corner_begin_[f]);
  }

  // From o to the mean of the facet's corners.
  Point3 middle(std::uint32_t f) const {
    return to_round_.is_identity ? middle_in<double>(f) : middle_in<DoubleDouble>(f);
  }

 private:
  template <class Real>
  Point3 middle_in(std::uint32_t f) const {
    Vector3<Real> sum{0, 0, 0};
    for (const std::uint32_t v : facet(f)) {
      for (const std::uint32_t o : polar_.base) {
        const Point3 &p = points_[v], &q = points_[o];
        const auto along = [](const Real& s, double to, double from) { return s + (Real(to) - Real(from)); };
        sum = {along(sum.x, p.x, q.x), along(sum.y, p.y, q.y), along(sum.z, p.z, q.z)};
      }
    }
    const Vector3<Real> mapped = to_round_(sum);
    const double part = 0.25 / static_cast<double>(facet(f).size());
    return {nearest(mapped.x) * part, nearest(mapped.y) * part, nearest(mapped.z) * part};
  }

  // With the errors of the vertices and the roundings here. With e a bound of the errors of a row's numbers and m one
  // of their sizes, errors included, a determinant of three rows, a sum of six products, is off by at most
  // 6 (e1 m2 m3 + m1 e2 m3 + m1 m2 e3) for the rows and 6 * 6 u m1 m2 m3 for rounding.
  std::optional<Sign> orient_rounded(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    struct Row {
      Vector3<double> v;
      double size, error;
    };
    const auto row = [&](std::uint32_t f) {
      const Point3 &p = at(a), &q = at(f);
      const Vector3<double> v{q.x - p.x, q.y - p.y, q.z - p.z};
      const double size = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
      const double error = polar_.errors[a] + polar_.errors[f] + 0x1p-52 * size;
      return Row{v, size + error, error};
    };
    const Row r = row(b), s = row(c), t = row(d);
    const double value = dot(cross(r.v, s.v), t.v);
    const double sizes = r.size * s.size * t.size;
    const double error =
        6.5 * (r.error * s.size * t.size + r.size * s.error * t.size + r.size * s.size * t.error) + 0x1p-46 * sizes;
    if (!(sizes > 0x1p-900 && sizes < 0x1p900)) return std::nullopt;
    if (value > error) return Sign::positive;
    if (value < -error) return Sign::negative;
    return std::nullopt;
  }

  // Told by common corners. Facets with a corner v in common are the vertices of one facet of the polar, a convex
  // polygon, whose order is known; all other vertices are on the inner side of its plane. Not told of facets of many
  // corners, of which there are few.
  std::optional<Sign> orient_by_corners(const std::array<std::uint32_t, 4>& facets) const {
    for (const std::uint32_t f : facets) {
      if (facet(f).size() > most_corners) return std::nullopt;
    }
    for (const std::size_t first : {0u, 1u}) {
      for (const std::uint32_t v : facet(facets[first])) {
        std::array<std::uint32_t, 4> place{};
        std::size_t others = 0, other = 0;  // those that do not have v
        for (std::size_t k = 0; k < 4; ++k) {
          place[k] = place_about(v, facets[k]);
          if (place[k] == none) ++others, other = k;
        }
        if (others == 0) return Sign::zero;
        if (others > 1) continue;
        std::array<std::uint32_t, 3> p{};
        for (std::size_t k = 0, i = 0; k < 4; ++k) {
          if (k != other) p[i++] = place[k];
        }
        if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) return Sign::zero;  // one facet, asked about twice
        const bool is_counter_clockwise = int{p[0] < p[1]} + int{p[1] < p[2]} + int{p[2] < p[0]} == 2;
        return is_counter_clockwise == (other % 2 == 1) ? Sign::negative : Sign::positive;
      }
    }
    return std::nullopt;
  }
  // In the cycle of facets about v; none: v is not a corner.
  std::uint32_t place_about(std::uint32_t v, std::uint32_t f) const {
    for (std::uint32_t i = corner_begin_[f]; i < corner_begin_[f + 1]; ++i) {
      if (corners_[i] == v) return place_about_corner_[i];
    }
    return none;
  }

  // The determinant of the rows (n, h) is that of the points with ones, times all h, which are positive; and orient is
  // its opposite.
  template <class T>
  static T determinant(const std::array<PolarVertexOf<T>, 4>& row) {
    const auto minor = [&](std::size_t i, std::size_t j, std::size_t k) {
      const auto &p = row[i].n, &q = row[j].n, &r = row[k].n;
      return dot(cross(Vector3<T>{p[0], p[1], p[2]}, Vector3<T>{q[0], q[1], q[2]}), Vector3<T>{r[0], r[1], r[2]});
    };
    return (row[3].h * minor(0, 1, 2) - row[2].h * minor(0, 1, 3)) +
           (row[1].h * minor(0, 2, 3) - row[0].h * minor(1, 2, 3));
  }
  std::array<PolarVertex, 4> exact(const std::array<std::uint32_t, 4>& facets) const {
    std::array<PolarVertex, 4> row;
    for (std::size_t k = 0; k < 4; ++k) row[k] = exact_polar_vertex(points_, facet(facets[k]), polar_.base);
    return row;
  }
  // Made when they are first asked for.
  std::array<PolarVertexOf<Estimate>, 4> estimates_of(const std::array<std::uint32_t, 4>& facets) const {
    std::array<PolarVertexOf<Estimate>, 4> row;
    for (std::size_t k = 0; k < 4; ++k) {
      std::uint32_t& place = place_[facets[k]];
      if (place == 0) {
        estimates_.push_back(estimated_polar_vertex(points_, facet(facets[k]), polar_.base));
        place = static_cast<std::uint32_t>(estimates_.size());
      }
      row[k] = estimates_[place - 1];
    }
    return row;
  }

  static constexpr std::uint32_t none = 0xffffffff;
  static constexpr std::size_t most_corners = 16;  // of a facet, for orient_by_corners

  std::span<const Point3> points_;
  std::span<const std::uint32_t> corner_begin_, corners_;
  const Polar& polar_;
  const RoundFrame& to_round_;
  std::vector<std::uint32_t> place_about_corner_;  // by corners: of the facet in the cycle about the corner
  mutable std::vector<PolarVertexOf<Estimate>> estimates_;
  mutable std::vector<std::uint32_t> place_;  // of a facet in these, and one; 0: nowhere
};

// What both kinds of hierarchies begin with; then make(facets, polar) makes the one.
template <class Made, class Make>
Made make_in_frame(const ConvexPolyhedron& body, const Make& make) {
  const std::span<const Point3> vertices = body.vertices();
  Made made;
  made.to_one = {power_to_one(vertices, &Point3::x), power_to_one(vertices, &Point3::y),
                 power_to_one(vertices, &Point3::z)};
  std::vector<Point3> points(vertices.begin(), vertices.end());
  for (Point3& p : points) p = {p.x * made.to_one.x, p.y * made.to_one.y, p.z * made.to_one.z};
  made.to_round = make_round_frame(points);
  Polar polar = make_polar(body, points);
  made.base = polar.base;
  const FacetsAsPoints facets(points, body.facet_begin(), body.facet_vertices(), made.to_round, polar);
  made.hierarchy = make(facets, polar);
  return made;
}

}  // namespace

PolarHierarchy PolarHierarchy::make(const ConvexPolyhedron& body) {
  return make_in_frame<PolarHierarchy>(body, [](const FacetsAsPoints& facets, const Polar& polar) {
    using Builder = hierarchy_detail::HierarchyBuilder<FacetsAsPoints>;
    Builder builder(facets, facets.size(), polar.facet_begin, polar.facet_vertices);
    return builder.run([&](std::uint32_t f) { return Builder::Middle{facets.middle(f)}; });
  });
}

BoundedPolarHierarchy BoundedPolarHierarchy::make(const ConvexPolyhedron& body) {
  return make_in_frame<BoundedPolarHierarchy>(body, [](const FacetsAsPoints& facets, const Polar& polar) {
    return hierarchy_detail::BoundedBuilder(facets, polar.facet_begin, polar.facet_vertices, {}, nullptr).run();
  });
}

}  // namespace sunder::solid
