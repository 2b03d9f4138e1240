// The surface of a hierarchy in the making: triangles over vertices in convex position, of which some are taken out.
#pragma once

#include <sunder/number/sign.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

// A vertex w is taken out with its star, whose rim is a cycle of vertices, and the hull of the others has a patch over
// the rim.
//
// Or w is cut off by a plane: each of its edges gets a new vertex near w, and these are the corners of a polygon. What
// is in one plane is triangulated here, too: an edge from w between triangles of one plane is no edge of the
// polyhedron, and gets no vertex, which would be no corner.
//
// P1. The patch has the rim's vertices and no others: what it covers of the old surface is the star, where no other
//     vertex is, and all vertices are extreme.
// P2. A triangle of the patch at an edge is one that no other vertex of the rim is above. It is found by going through
//     them, as around the edge they lie within half a turn.
// P3. Where several are in its plane, any of them will do: those of the rim in one plane are the corners of one convex
//     polygon, all of it in the patch. For the facet in that plane had w as a corner before, and the star's part of it
//     without w is convex; or there was no facet in that plane.

namespace sunder::solid::hierarchy_detail {

inline constexpr std::uint32_t none = 0xffffffff;

constexpr std::uint32_t after(std::uint32_t place) { return place == 2 ? 0 : place + 1; }
constexpr std::uint32_t before(std::uint32_t place) { return place == 0 ? 2 : place - 1; }

struct Face {
  std::array<std::uint32_t, 3> corner;    // counter-clockwise from outside
  std::array<std::uint32_t, 3> adjacent;  // beyond the edge from corner[i] to corner[i + 1]
  std::uint32_t beyond = none;            // the vertex whose going made it

  std::uint32_t place_of(std::uint32_t v) const { return corner[0] == v ? 0 : corner[1] == v ? 1 : 2; }
};

// Vertices, whatever they are made of: orient(a, b, c, d), the sign of predicate/point/orient.h, exactly.
template <class Vertices>
class HierarchySurface {
 public:
  // The vertices have the numbers below `size`; facets as ConvexPolyhedron has them.
  HierarchySurface(const Vertices& vertices, std::uint32_t size, std::span<const std::uint32_t> facet_begin,
                   std::span<const std::uint32_t> facet_vertices)
      : vertices_(vertices), face_of_(size, none), degree_(size, 0) {
    triangulate(facet_begin, facet_vertices);
  }

  const Face& face(std::uint32_t t) const { return faces_[t]; }
  std::uint32_t face_at(std::uint32_t v) const { return face_of_[v]; }  // none: it was taken out
  std::uint32_t degree(std::uint32_t v) const { return degree_[v]; }

  // Calls take(face, place of v in it) counter-clockwise about v.
  template <class Take>
  void for_each_around(std::uint32_t v, const Take& take) const {
    std::uint32_t t = face_of_[v];
    do {
      const std::uint32_t place = faces_[t].place_of(v);
      take(t, place);
      t = faces_[t].adjacent[before(place)];
    } while (t != face_of_[v]);
  }

  // Takes w out. Calls take(face, place of w in it) counter-clockwise about it before. Its rim stays until the next.
  template <class Take>
  void take_out(std::uint32_t w, const Take& take) {
    lift_star(w, take);
    const std::uint32_t last = static_cast<std::uint32_t>(rim_.size() - 1);
    link_beyond(last, fill(w, 0, last, beyond_rim_[last]));
  }
  std::span<const std::uint32_t> rim() const { return rim_; }

  // The other ends of the edges of the polyhedron at w, counter-clockwise; those inside of facets are left out.
  std::vector<std::uint32_t> true_neighbours(std::uint32_t w) const {
    std::vector<std::uint32_t> around, found;
    for_each_around(w, [&](std::uint32_t t, std::uint32_t place) { around.push_back(faces_[t].corner[after(place)]); });
    for (std::size_t i = 0; i < around.size(); ++i) {
      const std::uint32_t previous = around[i > 0 ? i - 1 : around.size() - 1];
      const std::uint32_t next = around[i + 1 < around.size() ? i + 1 : 0];
      if (vertices_.orient(w, previous, around[i], next) != Sign::zero) found.push_back(around[i]);
    }
    return found;
  }

  // Cuts w off: the k-th of true_neighbours(w), `ends`, has the new vertex `first` + k on its edge from w. New vertices
  // are numbered on from those that there are. No sign is asked for.
  void cut_off(std::uint32_t w, std::span<const std::uint32_t> ends) {
    lift_star(w, [](std::uint32_t, std::uint32_t) {});
    const std::uint32_t first = static_cast<std::uint32_t>(face_of_.size());
    const std::uint32_t count = static_cast<std::uint32_t>(ends.size());
    face_of_.resize(first + count, none);
    degree_.resize(first + count, 0);
    // Between two edges of the polyhedron: the polygon of both new vertices and the rim between them.
    std::vector<Side> left(count), right(count), top(count), sides;
    std::vector<std::uint32_t> corners;
    std::size_t i = static_cast<std::size_t>(std::find(rim_.begin(), rim_.end(), ends[0]) - rim_.begin());
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t next = k + 1 < count ? k + 1 : 0;
      const std::size_t begin = i;
      corners.assign({first + k, rim_[i]});
      do {
        i = i + 1 < rim_.size() ? i + 1 : 0;
        corners.push_back(rim_[i]);
      } while (rim_[i] != ends[next]);
      corners.push_back(first + next);
      fill_flat(w, corners, degree_[ends[k]] <= degree_[ends[next]], sides);
      for (std::size_t c = 1; c + 2 < corners.size(); ++c) {
        const std::size_t edge = (begin + c - 1) % rim_.size();
        faces_[sides[c].face].adjacent[sides[c].place] = beyond_rim_[edge];
        link_beyond(static_cast<std::uint32_t>(edge), sides[c].face);
      }
      left[k] = sides.front();
      right[next] = sides[corners.size() - 2];
      top[k] = sides.back();
    }
    corners.resize(count);
    std::iota(corners.begin(), corners.end(), first);
    fill_flat(w, corners, true, sides);
    for (std::uint32_t k = 0; k < count; ++k) {
      link(left[k], right[k]);
      link(top[k], sides[k]);
    }
  }

 private:
  struct Side {  // an edge of a face: from its corner of this place
    std::uint32_t face, place;
  };

  void link(const Side& a, const Side& b) {
    faces_[a.face].adjacent[a.place] = b.face;
    faces_[b.face].adjacent[b.place] = a.face;
  }

  // Triangulates a convex polygon to and fro, so that no corner gets more than two diagonals; from the edge between its
  // last and its first corner. sides[i] becomes that from corner i to the next.
  void fill_flat(std::uint32_t w, std::span<const std::uint32_t> corners, bool from_the_left,
                 std::vector<Side>& sides) {
    sides.resize(corners.size());
    std::size_t l = 0, r = corners.size() - 1;
    std::optional<Side> base;
    for (bool of_left = from_the_left; r - l > 1; of_left = !of_left) {
      const std::size_t apex = of_left ? l + 1 : r - 1;
      const std::uint32_t t = new_face();
      faces_[t] = {{corners[r], corners[l], corners[apex]}, {none, none, none}, w};
      enter(t);
      if (base) {
        link(*base, {t, 0});
      } else {
        sides[r] = {t, 0};
      }
      if (of_left) {
        sides[l] = {t, 1};
        base = Side{t, 2};
        l = apex;
      } else {
        sides[apex] = {t, 2};
        base = Side{t, 1};
        r = apex;
      }
    }
    sides[l] = *base;
  }

  std::uint32_t new_face() {
    if (free_.empty()) {
      faces_.emplace_back();
      return static_cast<std::uint32_t>(faces_.size() - 1);
    }
    const std::uint32_t t = free_.back();
    free_.pop_back();
    return t;
  }

  // Takes the star of w away, and leaves its rim.
  template <class Take>
  void lift_star(std::uint32_t w, const Take& take) {
    rim_.clear();
    beyond_rim_.clear();
    free_.clear();
    for_each_around(w, [&](std::uint32_t t, std::uint32_t place) {
      rim_.push_back(faces_[t].corner[after(place)]);
      beyond_rim_.push_back(faces_[t].adjacent[after(place)]);
      free_.push_back(t);
      take(t, place);
    });
    face_of_[w] = none;
    for (const std::uint32_t v : rim_) degree_[v] -= 2;
  }

  // The fan from the first vertex of each facet.
  void triangulate(std::span<const std::uint32_t> facet_begin, std::span<const std::uint32_t> facet_vertices) {
    faces_.reserve(2 * face_of_.size());
    for (std::size_t f = 0; f + 1 < facet_begin.size(); ++f) {
      const auto cycle = facet_vertices.subspan(facet_begin[f], facet_begin[f + 1] - facet_begin[f]);
      for (std::size_t k = 1; k + 1 < cycle.size(); ++k) {
        const std::uint32_t t = static_cast<std::uint32_t>(faces_.size());
        faces_.push_back(
            {{cycle[0], cycle[k], cycle[k + 1]}, {k > 1 ? t - 1 : none, none, k + 2 < cycle.size() ? t + 1 : none}});
        enter(t);
      }
    }
    link_facets();
  }

  // A face that is new, with its corners.
  void enter(std::uint32_t t) {
    for (const std::uint32_t v : faces_[t].corner) {
      face_of_[v] = t;
      ++degree_[v];
    }
  }

  // Each edge between two facets is there once from each: they are brought together at its lower end.
  void link_facets() {
    struct Edge {
      std::uint32_t to, face, place;
    };
    const auto for_each_edge = [&](const auto& take) {
      for (std::uint32_t t = 0; t < faces_.size(); ++t) {
        for (const std::uint32_t place : {0u, 1u, 2u}) {
          if (faces_[t].adjacent[place] != none) continue;
          const auto [from, to] = std::minmax(faces_[t].corner[place], faces_[t].corner[after(place)]);
          take(from, Edge{to, t, place});
        }
      }
    };
    std::vector<std::uint32_t> begin(face_of_.size() + 1, 0);
    for_each_edge([&](std::uint32_t from, const Edge&) { ++begin[from + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Edge> edges(begin.back());
    std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
    for_each_edge([&](std::uint32_t from, const Edge& edge) { edges[end[from]++] = edge; });
    for (std::uint32_t v = 0; v < face_of_.size(); ++v) {
      const auto first = edges.begin() + begin[v], last = edges.begin() + begin[v + 1];
      std::sort(first, last, [](const Edge& a, const Edge& b) { return a.to < b.to; });
      for (auto edge = first; edge != last; edge += 2) {
        faces_[edge[0].face].adjacent[edge[0].place] = edge[1].face;
        faces_[edge[1].face].adjacent[edge[1].place] = edge[0].face;
      }
    }
  }

  // Edge i of the rim, from rim_[i] to the next, has this triangle inside.
  void link_beyond(std::uint32_t i, std::uint32_t inside) {
    Face& beyond = faces_[beyond_rim_[i]];
    beyond.adjacent[beyond.place_of(rim_[i + 1 < rim_.size() ? i + 1 : 0])] = inside;
  }

  // Fills the polygon rim_[i], ..., rim_[j], whose last edge, from rim_[j] to rim_[i], has `outer` beyond it. Returns
  // the triangle inside that edge, or what is beyond an edge of the rim.
  std::uint32_t fill(std::uint32_t w, std::uint32_t i, std::uint32_t j, std::uint32_t outer) {
    if (j == i + 1) {
      link_beyond(i, outer);
      return beyond_rim_[i];
    }
    std::uint32_t apex = i + 1;
    for (std::uint32_t k = i + 2; k < j; ++k) {
      if (is_above(rim_[j], rim_[i], rim_[apex], rim_[k])) apex = k;
    }
    const std::uint32_t t = new_face();
    faces_[t] = {{rim_[j], rim_[i], rim_[apex]}, {outer, none, none}, w};
    enter(t);
    faces_[t].adjacent[1] = fill(w, i, apex, t);
    faces_[t].adjacent[2] = fill(w, apex, j, t);
    return t;
  }

  // Is x above the plane of a, b, c: on the side from which they are counter-clockwise?
  bool is_above(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t x) const {
    return vertices_.orient(a, b, c, x) == Sign::positive;
  }

  const Vertices& vertices_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> face_of_;  // a face at each vertex; none where it was taken out
  std::vector<std::uint32_t> degree_;
  std::vector<std::uint32_t> rim_, beyond_rim_, free_;
};

}  // namespace sunder::solid::hierarchy_detail
