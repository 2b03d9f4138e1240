#include <sunder/number/vector.h>
#include <sunder/predicate/posed.h>
#include <sunder/solid/represent/hierarchy_builder.h>
#include <sunder/solid/represent/polar.h>
#include <sunder/solid/represent/polar_hierarchy.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace sunder::solid {

namespace {

// A power of two by which every coordinate is multiplied exactly: it makes the points about 1 long along the axis, or
// where a coordinate would vanish, as long as need be.
double to_one(std::span<const Point3> points, double Point3::* axis) {
  const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                               [&](const Point3& p, const Point3& q) { return p.*axis < q.*axis; });
  const double half = (*high).*axis / 2 - (*low).*axis / 2;  // halves: no overflow
  if (!(half > 0)) return 1;
  SizeRange sizes;
  for (const Point3& p : points) sizes.include(p.*axis);
  const int least = std::min(-1022 - std::ilogb(sizes.least), 0);  // all are normal numbers then, or not made smaller
  return std::ldexp(1.0, std::clamp(std::max(-std::ilogb(half) - 1, least), -1022, 1022));
}

// The facets as vertices of the polar.
class FacetsAsPoints {
 public:
  FacetsAsPoints(std::span<const Point3> points, std::span<const std::uint32_t> corner_begin,
                 std::span<const std::uint32_t> corners, const Polar& polar)
      : points_(points),
        corner_begin_(corner_begin),
        corners_(corners),
        polar_(polar),
        place_(polar.vertices.size(), 0) {}

  const Point3& at(std::uint32_t f) const { return polar_.vertices[f]; }

  Sign orient(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    if (const std::optional<Sign> sure = orient_rounded(a, b, c, d)) return *sure;
    if (have_common_corner({a, b, c, d})) return Sign::zero;
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
    Point3 sum{0, 0, 0};
    for (const std::uint32_t v : facet(f)) {
      for (const std::uint32_t o : polar_.base) {
        const Point3 &p = points_[v], &q = points_[o];
        sum = {sum.x + (p.x - q.x), sum.y + (p.y - q.y), sum.z + (p.z - q.z)};
      }
    }
    const double part = 0.25 / static_cast<double>(facet(f).size());
    return {sum.x * part, sum.y * part, sum.z * part};
  }

 private:
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

  // Not told of facets of many corners, of which there are few.
  bool have_common_corner(const std::array<std::uint32_t, 4>& facets) const {
    constexpr std::size_t many = 16;
    for (const std::uint32_t f : facets) {
      if (facet(f).size() > many) return false;
    }
    const auto is_corner_of_all = [&](std::uint32_t v) {
      return std::all_of(facets.begin() + 1, facets.end(), [&](std::uint32_t f) {
        const auto cycle = facet(f);
        return std::find(cycle.begin(), cycle.end(), v) != cycle.end();
      });
    };
    const auto first = facet(facets[0]);
    return std::any_of(first.begin(), first.end(), is_corner_of_all);
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

  std::span<const Point3> points_;
  std::span<const std::uint32_t> corner_begin_, corners_;
  const Polar& polar_;
  mutable std::vector<PolarVertexOf<Estimate>> estimates_;
  mutable std::vector<std::uint32_t> place_;  // of a facet in these, and one; 0: nowhere
};

}  // namespace

PolarHierarchy make_polar_hierarchy(std::span<const Point3> vertices, std::span<const std::uint32_t> corner_begin,
                                    std::span<const std::uint32_t> corners) {
  PolarHierarchy made;
  made.to_one = {to_one(vertices, &Point3::x), to_one(vertices, &Point3::y), to_one(vertices, &Point3::z)};
  std::vector<Point3> points(vertices.begin(), vertices.end());
  for (Point3& p : points) p = {p.x * made.to_one.x, p.y * made.to_one.y, p.z * made.to_one.z};
  const Polar polar = make_polar(points, corner_begin, corners);
  made.base = polar.base;
  const FacetsAsPoints facets(points, corner_begin, corners, polar);
  using Builder = hierarchy_detail::HierarchyBuilder<FacetsAsPoints>;
  Builder builder(facets, static_cast<std::uint32_t>(polar.vertices.size()), polar.facet_begin, polar.facet_vertices);
  made.hierarchy = builder.run([&](std::uint32_t f) { return Builder::Middle{facets.middle(f)}; });
  return made;
}

}  // namespace sunder::solid
