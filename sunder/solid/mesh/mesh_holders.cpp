#include <sunder/solid/mesh/mesh_holders.h>

#include <sunder/base/interruption.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/line/polyhedron_line.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>

namespace sunder::solid {

namespace {

Sign times(Sign s, Sign t) { return s == Sign::negative ? -t : s == Sign::zero ? s : t; }

// The point takes the place of each corner in turn: no tetrahedron that is made so is turned the other way round. False
// where the four corners are in one plane.
bool is_in_tetrahedron(const std::array<Point3, 4>& corners, const Point3& p) {
  const auto side = [](const std::array<Point3, 4>& c) { return orient_3d(c[0], c[1], c[2], c[3]); };
  const Sign whole = side(corners);
  if (whole == Sign::zero) return false;
  for (std::size_t k = 0; k < 4; ++k) {
    std::array<Point3, 4> with = corners;
    with[k] = p;
    if (times(whole, side(with)) == Sign::negative) return false;
  }
  return true;
}

// Along an axis, along which the corners are not on a line.
std::optional<int> axis_of(const Point3& a, const Point3& b, const Point3& c) {
  for (const int axis : {0, 1, 2}) {
    if (orient_2d_along(axis, a, b, c) != Sign::zero) return axis;
  }
  return std::nullopt;
}

bool is_in_triangle(const std::array<Point3, 3>& corners, const Point3& p) {
  const auto axis = axis_of(corners[0], corners[1], corners[2]);
  if (!axis || orient_3d(corners[0], corners[1], corners[2], p) != Sign::zero) return false;
  const auto side = [&](const std::array<Point3, 3>& c) { return orient_2d_along(*axis, c[0], c[1], c[2]); };
  const Sign whole = side(corners);
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<Point3, 3> with = corners;
    with[k] = p;
    if (times(whole, side(with)) == Sign::negative) return false;
  }
  return true;
}

// A facet is cut from its first vertex into triangles (first, i, i + 1); with vertex 0 of a body, into tetrahedra.
class Holders {
 public:
  Holders(const Mesh& mesh, const ConvexPolyhedron& body) : mesh_(mesh), body_(body) {
    for (std::uint32_t v = 0; v < body.vertices().size(); ++v) vertices_.try_emplace(key(body.vertices()[v]), v);
  }

  template <class Find>  // find(point): a simplex that has it
  std::optional<MeshHolders> all(const Find& find) {
    for (const Point3& p : mesh_.points()) {
      may_be_interrupted(10);
      const auto vertex = vertices_.find(key(p));
      const auto holder = vertex != vertices_.end() ? std::optional(Simplex{vertex->second}) : find(p);
      if (!holder) return std::nullopt;
      const auto [known, is_new] = numbers_.try_emplace(*holder, static_cast<std::uint32_t>(result_.holders.size()));
      if (is_new) result_.holders.push_back(*holder);
      result_.held.push_back(known->second);
    }
    return std::move(result_);
  }

  using Simplex = std::vector<std::uint32_t>;

  std::optional<Simplex> in_facet(std::uint32_t facet, const Point3& p) const {
    const std::span<const std::uint32_t> all = body_.facet(facet);
    const Point3 &apex = at(0), &first = at(all[0]);
    // Is it beyond the ray from the first vertex to another, or the plane that it spans with vertex 0, or on it? First
    // it is, then no longer.
    const auto axis = is_flat() ? axis_of(first, at(all[1]), at(all[2])) : std::nullopt;
    const auto side = [&](std::uint32_t v, const Point3& q) {
      return axis ? orient_2d_along(*axis, first, at(v), q) : orient_3d(apex, first, at(v), q);
    };
    const Sign way = side(all[1], at(all[2]));
    if (way == Sign::zero) return std::nullopt;
    const auto beyond = std::partition_point(all.begin() + 2, all.end() - 1,
                                             [&](std::uint32_t v) { return times(way, side(v, p)) != Sign::negative; });
    Simplex simplex = simplex_of(facet, static_cast<std::uint32_t>(beyond - all.begin()) - 1);
    return holds(simplex, p) ? std::optional(std::move(simplex)) : std::nullopt;
  }

  std::optional<Simplex> in_any(const Point3& p) const {
    for (std::uint32_t f = 0; f < body_.facet_count(); ++f) {
      for (std::uint32_t i = 1; i + 1 < body_.facet(f).size(); ++i) {
        if (Simplex simplex = simplex_of(f, i); holds(simplex, p)) return simplex;
      }
    }
    return std::nullopt;
  }

  bool is_flat() const { return body_.dimension() == 2; }
  const Point3& at(std::uint32_t v) const { return body_.vertices()[v]; }

 private:
  static std::array<double, 3> key(const Point3& p) { return {p.x, p.y, p.z}; }

  Simplex simplex_of(std::uint32_t facet, std::uint32_t i) const {
    const std::span<const std::uint32_t> all = body_.facet(facet);
    Simplex simplex{all[0], all[i], all[i + 1]};
    if (!is_flat()) simplex.push_back(0);
    return simplex;
  }

  bool holds(const Simplex& s, const Point3& p) const {
    return s.size() == 3 ? is_in_triangle({at(s[0]), at(s[1]), at(s[2])}, p)
                         : is_in_tetrahedron({at(s[0]), at(s[1]), at(s[2]), at(s[3])}, p);
  }

  const Mesh& mesh_;
  const ConvexPolyhedron& body_;
  std::map<std::array<double, 3>, std::uint32_t> vertices_;
  std::map<Simplex, std::uint32_t> numbers_;
  MeshHolders result_;
};

}  // namespace

std::optional<MeshHolders> mesh_holders(const Mesh& mesh, const ConvexPolyhedron& body) {
  Holders holders(mesh, body);
  return holders.all([&](const Point3& p) -> std::optional<Holders::Simplex> {
    if (body.dimension() < 2) return std::nullopt;
    if (holders.is_flat()) return holders.in_facet(0, p);
    // The plane of the facet by which the line leaves has vertex 0 strictly behind it.
    const auto facets = facets_of(polyhedron_line(body, Line{holders.at(0), p}).evidence);
    return facets ? holders.in_facet(facets->leaves, p) : std::nullopt;
  });
}

std::optional<MeshHolders> mesh_holders_by_scan(const Mesh& mesh, const ConvexPolyhedron& body) {
  Holders holders(mesh, body);
  return holders.all([&](const Point3& p) -> std::optional<Holders::Simplex> {
    return body.dimension() < 2 ? std::nullopt : holders.in_any(p);
  });
}

}  // namespace sunder::solid
