#include <sunder/predicate/point/orient.h>
#include <sunder/solid/mesh/mesh_convexity.h>
#include <sunder/solid/mesh/mesh_sides.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace sunder::solid {

namespace {

constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

bool collinear(const Point3& a, const Point3& b, const Point3& c) {
  for (const int axis : {0, 1, 2}) {
    if (orient_2d_along(axis, a, b, c) != Sign::zero) return false;
  }
  return true;
}

using Side = MeshSides::Side;

class Convexity {
 public:
  Convexity(const MeshView& mesh, const ConvexPolyhedron& hull)
      : mesh_(mesh), hull_(hull), topology_(mesh), sides_(topology_.sides) {
    hull_vertex_.assign(mesh.vertices.size(), no_vertex);
    for (std::uint32_t v = 0; v < hull.vertices().size(); ++v) hull_vertex_[topology_.lowest[hull.source()[v]]] = v;
    facets_at_.resize(hull.vertices().size());
    for (std::uint32_t f = 0; f < hull.facet_count(); ++f) {
      for (const std::uint32_t v : hull.facet(f)) facets_at_[v].push_back(f);
    }
  }

  MeshDefect find() const {
    if (hull_.dimension() < 2) return {MeshDefect::Kind::thin, 0, {}};
    if (const auto edge = open_edge()) return {MeshDefect::Kind::open_edge, 0, *edge};
    bool odd = false;
    for (std::uint32_t f = 0; f < mesh_.polygon_count(); ++f) {
      const auto facet = facet_of(f);
      if (!facet) return defect_off_hull(f);
      if (*facet == 0) odd ^= covers_first_corner(f);
    }
    return {odd ? MeshDefect::Kind::none : MeshDefect::Kind::doubled, 0, {}};
  }

  // Requires C1.
  std::vector<std::uint32_t> facets_beneath() const {
    std::vector<std::uint32_t> facets;
    for (std::uint32_t f = 0; f < mesh_.polygon_count(); ++f) facets.push_back(facet_of(f).value_or(0));
    return facets;
  }

  std::optional<std::uint32_t> face_off_hull() const {
    for (std::uint32_t f = 0; f < mesh_.polygon_count(); ++f) {
      if (!facet_of(f)) return f;
    }
    return std::nullopt;
  }

 private:
  std::span<const std::uint32_t> corners(std::uint32_t f) const { return topology_.corners_of(f); }
  const Point3& at(std::uint32_t v) const { return mesh_.vertices[v]; }
  const Point3& hull_corner(std::uint32_t facet, std::size_t i) const {
    return hull_.vertices()[hull_.facet(facet)[i % hull_.facet(facet).size()]];
  }

  // C2.
  std::optional<std::array<std::uint32_t, 2>> open_edge() const {
    for (std::size_t i = 0; i < sides_.size();) {
      std::size_t j = i;
      while (j < sides_.size() && sides_[j].ends() == sides_[i].ends()) ++j;
      const auto [a, b] = sides_[i].ends();
      if ((j - i) % 2 == 1 && !(hull_.dimension() == 2 && on_rim(a, b))) return std::array{a, b};
      i = j;
    }
    return std::nullopt;
  }

  // Of a flat mesh: is the edge part of an edge of the hull?
  bool on_rim(std::uint32_t a, std::uint32_t b) const {
    for (std::size_t i = 0; i < hull_.facet(0).size(); ++i) {
      const Point3 &p = hull_corner(0, i), &q = hull_corner(0, i + 1);
      if (collinear(p, q, at(a)) && collinear(p, q, at(b))) return true;
    }
    return false;
  }

  // C1: the lowest facet that holds all corners.
  std::optional<std::uint32_t> facet_of(std::uint32_t face) const {
    const auto all = corners(face);
    if (hull_.dimension() == 2) return 0;
    const auto extreme =
        std::find_if(all.begin(), all.end(), [&](std::uint32_t v) { return hull_vertex_[v] != no_vertex; });
    if (extreme != all.end()) {
      for (const std::uint32_t f : facets_at_[hull_vertex_[*extreme]]) {
        if (holds_all(f, all)) return f;
      }
      return std::nullopt;
    }
    for (std::uint32_t f = 0; f < hull_.facet_count(); ++f) {
      if (holds_all(f, all)) return f;
    }
    return std::nullopt;
  }

  bool holds_all(std::uint32_t facet, std::span<const std::uint32_t> points) const {
    return std::all_of(points.begin(), points.end(), [&](std::uint32_t v) {
      if (hull_vertex_[v] != no_vertex) {
        const auto& facets = facets_at_[hull_vertex_[v]];
        return std::binary_search(facets.begin(), facets.end(), facet);
      }
      return orient_3d(hull_corner(facet, 0), hull_corner(facet, 1), hull_corner(facet, 2), at(v)) == Sign::zero;
    });
  }

  // C3: does the face, which lies on facet 0, cover the place just beside the edge from its corner 0 to its corner 1,
  // close to corner 0? A face does, counted modulo two, when an odd number of its edges leaves corner 0 along that
  // edge.
  bool covers_first_corner(std::uint32_t face) const {
    const auto all = corners(face);
    const std::uint32_t origin = hull_.facet(0)[0];
    bool odd = false;
    const auto count = [&](std::uint32_t from, std::uint32_t to) {
      if (hull_vertex_[from] == origin && to != from) odd ^= collinear(at(from), hull_corner(0, 1), at(to));
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::uint32_t next = all[(i + 1) % all.size()];
      count(all[i], next);
      count(next, all[i]);
    }
    return odd;
  }

  // The mesh is closed, and this face is not on the hull: why?
  MeshDefect defect_off_hull(std::uint32_t face) const {
    for (std::uint32_t f = 0; f < mesh_.polygon_count(); ++f) {
      if (const auto plane = plane_of(f)) {
        for (const std::uint32_t v : corners(f)) {
          if (orient_3d((*plane)[0], (*plane)[1], (*plane)[2], at(v)) != Sign::zero) {
            return {MeshDefect::Kind::bent_face, f, {}};
          }
        }
      }
    }
    if (const auto edge = reflex_edge()) return {MeshDefect::Kind::reflex_edge, face, *edge};
    return {MeshDefect::Kind::inner_face, face, {}};
  }

  // Three corners, in their cyclic order, that are not on one line.
  std::optional<std::array<Point3, 3>> plane_of(std::uint32_t face) const {
    const auto all = corners(face);
    for (std::size_t i = 1; i + 1 < all.size(); ++i) {
      if (!collinear(at(all[0]), at(all[i]), at(all[i + 1]))) return std::array{at(all[0]), at(all[i]), at(all[i + 1])};
    }
    return std::nullopt;
  }

  // How the mesh bends at the edge that two faces share: the side of the first face's plane on which the second lies.
  // Zero where they are in one plane, and nothing where they are turned inconsistently or one is flat.
  // Reads triangles rightly; of larger faces only convex ones.
  std::optional<Sign> bend(const Side& s, const Side& t) const {
    const auto plane = plane_of(s.face);
    if (!plane || !plane_of(t.face) || s.from != t.to) return std::nullopt;
    for (const std::uint32_t v : corners(t.face)) {
      const Sign side = orient_3d((*plane)[0], (*plane)[1], (*plane)[2], at(v));
      if (side != Sign::zero) return side;
    }
    return Sign::zero;
  }

  // Which sign of `bend` is convex? Around an extreme vertex of the hull the mesh is a cone; an extreme ray of the
  // hull of that cone is an edge at which the mesh is convex.
  std::optional<Sign> convex_bend() const {
    std::vector<std::uint32_t> star;
    const std::uint32_t apex = corners_of_hull_vertex(0);
    for (const Side& s : sides_) {
      if (s.from == apex) star.push_back(s.to);
      if (s.to == apex) star.push_back(s.from);
    }
    std::vector<Point3> points{at(apex)};
    for (const std::uint32_t v : star) points.push_back(at(v));
    const ConvexPolyhedron cone(points);
    const auto source = cone.source();
    for (std::uint32_t v = 0; v < source.size(); ++v) {
      if (source[v] != 0) continue;
      for (const std::uint32_t w : cone.neighbours(v)) {
        const auto sign = bend_at(apex, star[source[w] - 1]);
        if (sign && *sign != Sign::zero) return sign;
      }
    }
    return std::nullopt;
  }

  std::uint32_t corners_of_hull_vertex(std::uint32_t v) const {
    const auto found = std::find(hull_vertex_.begin(), hull_vertex_.end(), v);
    return static_cast<std::uint32_t>(found - hull_vertex_.begin());
  }

  std::optional<Sign> bend_at(std::uint32_t a, std::uint32_t b) const {
    const std::pair<std::uint32_t, std::uint32_t> ends = std::minmax(a, b);
    const auto [first, last] = std::equal_range(sides_.begin(), sides_.end(), Side{ends.first, ends.second, 0},
                                                [](const Side& s, const Side& t) { return s.ends() < t.ends(); });
    return last - first == 2 ? bend(first[0], first[1]) : std::nullopt;
  }

  std::optional<std::array<std::uint32_t, 2>> reflex_edge() const {
    const auto convex = convex_bend();
    if (!convex) return std::nullopt;
    for (std::size_t i = 0; i + 1 < sides_.size(); ++i) {
      const bool two = sides_[i].ends() == sides_[i + 1].ends() &&
                       (i == 0 || sides_[i - 1].ends() != sides_[i].ends()) &&
                       (i + 2 == sides_.size() || sides_[i + 2].ends() != sides_[i].ends());
      if (two && bend(sides_[i], sides_[i + 1]) == -*convex) {
        return std::array{sides_[i].ends().first, sides_[i].ends().second};
      }
    }
    return std::nullopt;
  }

  const MeshView& mesh_;
  const ConvexPolyhedron& hull_;
  MeshSides topology_;
  const std::vector<Side>& sides_;                     // by their ends
  std::vector<std::uint32_t> hull_vertex_;             // of a vertex of the mesh; no_vertex where it is not extreme
  std::vector<std::vector<std::uint32_t>> facets_at_;  // a vertex of the hull
};

}  // namespace

MeshDefect find_mesh_defect(const MeshView& mesh, const ConvexPolyhedron& hull) { return Convexity(mesh, hull).find(); }

std::vector<std::uint32_t> facets_beneath(const MeshView& mesh, const ConvexPolyhedron& hull) {
  return Convexity(mesh, hull).facets_beneath();
}

std::optional<std::uint32_t> face_off_hull(const MeshView& mesh, const ConvexPolyhedron& hull) {
  return Convexity(mesh, hull).face_off_hull();
}

}  // namespace sunder::solid
