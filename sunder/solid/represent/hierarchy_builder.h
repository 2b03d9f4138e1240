// How hierarchies are made, of whatever has vertices that are exactly in convex position.
#pragma once

#include <sunder/base/contract.h>
#include <sunder/number/sign.h>
#include <sunder/solid/represent/hierarchy.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

// A vertex w is taken away with its star, whose rim is a cycle of at most most_degree vertices, and the hull of the
// others has a patch over the rim. No two that go at once are adjacent, so their patches have no triangle in common.
//
// P1. The patch has the rim's vertices and no others: what it covers of the old surface is the star, where no other
//     vertex is, and all vertices are extreme.
// P2. A triangle of the patch at an edge is one that no other vertex of the rim is above. It is found by going through
//     them, as around the edge they lie within half a turn.
// P3. Where several are in its plane, any of them will do: those of the rim in one plane are the corners of one convex
//     polygon, all of it in the patch. For the facet in that plane had w as a corner before, and the star's part of it
//     without w is convex; or there was no facet in that plane.
// P4. The four vertices of the tetrahedron stay, so there is always an inside.

namespace sunder::solid::hierarchy_detail {

inline constexpr std::uint32_t none = Hierarchy::none;

constexpr std::uint32_t after(std::uint32_t place) { return place == 2 ? 0 : place + 1; }
constexpr std::uint32_t before(std::uint32_t place) { return place == 0 ? 2 : place - 1; }

struct Face {
  std::array<std::uint32_t, 3> corner;    // counter-clockwise from outside
  std::array<std::uint32_t, 3> adjacent;  // beyond the edge from corner[i] to corner[i + 1]
  std::uint32_t beyond = none;            // the vertex whose going made it

  std::uint32_t place_of(std::uint32_t v) const { return corner[0] == v ? 0 : corner[1] == v ? 1 : 2; }
};

// A hierarchy in the making: takes vertex numbers, and holds ranks, the last that went first.
struct History {
  Hierarchy hierarchy;
  std::vector<std::uint32_t> rank;  // of a vertex

  History(std::uint32_t size, std::span<const std::uint32_t> last, std::span<const std::uint32_t> taken,
          std::vector<std::uint32_t> level_end)
      : rank(size) {
    hierarchy.level_end = std::move(level_end);
    hierarchy.nodes.resize(size);
    for (std::uint32_t k = 0; k < size; ++k) {
      Hierarchy::Node& node = hierarchy.nodes[k];
      node.vertex = k < last.size() ? last[k] : taken[size - 1 - k];
      rank[node.vertex] = k;
    }
  }

  void add(std::uint32_t to_star_of, const Hierarchy::Triangle& t) {
    Hierarchy::Node& node = hierarchy.nodes[rank[to_star_of]];
    const std::uint32_t k = node.size++;
    node.rim[k] = rank[t.a];
    if (k == 0 && t.b != none) node.rim[1] = rank[t.b];  // should it be the only one
    node.beyond[k] = t.beyond == none ? none : rank[t.beyond];
  }
};

// Vertices, whatever they are made of: at(v), a Point3, where doubles see it; orient(a, b, c, d), the sign of
// predicate/point/orient.h, exactly.
template <class Vertices>
class HierarchyBuilder {
 public:
  struct Middle {
    Point3 direction;
    std::uint32_t face = none;  // none: it is the direction
    std::array<std::uint32_t, 2> with{};
  };

  // The vertices have the numbers below `size`; facets as ConvexPolyhedron has them.
  HierarchyBuilder(const Vertices& vertices, std::uint32_t size, std::span<const std::uint32_t> facet_begin,
                   std::span<const std::uint32_t> facet_vertices)
      : vertices_(vertices), size_(size), face_of_(size, none), degree_(size, 0), blocked_(size, 0) {
    triangulate(facet_begin, facet_vertices);
    choose_tetrahedron();
  }

  // middle_of(v): of all vertices, before any goes.
  template <class MiddleOf>
  Hierarchy run(const MiddleOf& middle_of) {
    const std::uint32_t n = size_;
    for (std::uint32_t v = 0; v < n; ++v) middle_.push_back(middle_of(v));
    std::vector<std::uint32_t> here(n);
    std::iota(here.begin(), here.end(), 0u);
    std::vector<std::uint32_t> level_end;
    while (here.size() > 4) {
      level_end.push_back(static_cast<std::uint32_t>(here.size()));
      here = take_away(here);
    }
    level_end.push_back(4);
    std::reverse(level_end.begin(), level_end.end());
    return history(here, std::move(level_end));
  }

  const Face& face(std::uint32_t t) const { return faces_[t]; }
  std::uint32_t face_at(std::uint32_t v) const { return face_of_[v]; }

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

 private:
  // The fan from the first vertex of each facet.
  void triangulate(std::span<const std::uint32_t> facet_begin, std::span<const std::uint32_t> facet_vertices) {
    faces_.reserve(2 * std::size_t{size_});
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
    std::vector<std::uint32_t> begin(size_ + 1, 0);
    for_each_edge([&](std::uint32_t from, const Edge&) { ++begin[from + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Edge> edges(begin.back());
    std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
    for_each_edge([&](std::uint32_t from, const Edge& edge) { edges[end[from]++] = edge; });
    for (std::uint32_t v = 0; v < size_; ++v) {
      const auto first = edges.begin() + begin[v], last = edges.begin() + begin[v + 1];
      std::sort(first, last, [](const Edge& a, const Edge& b) { return a.to < b.to; });
      for (auto edge = first; edge != last; edge += 2) {
        faces_[edge[0].face].adjacent[edge[0].place] = edge[1].face;
        faces_[edge[1].face].adjacent[edge[1].place] = edge[0].face;
      }
    }
  }

  // Four vertices that span space, far from each other as far as doubles tell.
  void choose_tetrahedron() {
    const auto furthest = [&](const auto& distance) {
      std::uint32_t best = 0;
      for (std::uint32_t v = 1; v < size_; ++v) {
        if (distance(at(v)) > distance(at(best))) best = v;
      }
      return best;
    };
    const auto from = [](const Point3& a, const Point3& b) { return Point3{b.x - a.x, b.y - a.y, b.z - a.z}; };
    const auto length = [](const Point3& a) { return a.x * a.x + a.y * a.y + a.z * a.z; };
    const auto normal = [](const Point3& a, const Point3& b) {
      return Point3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    };
    const std::uint32_t a = furthest([](const Point3& p) { return -p.x; });
    const std::uint32_t b = furthest([&](const Point3& p) { return length(from(at(a), p)); });
    const Point3 ab = from(at(a), at(b));
    const std::uint32_t c = furthest([&](const Point3& p) { return length(normal(ab, from(at(a), p))); });
    const Point3 abc = normal(ab, from(at(a), at(c)));
    const std::uint32_t d = furthest([&](const Point3& p) {
      const Point3 q = from(at(a), p);
      return std::fabs(abc.x * q.x + abc.y * q.y + abc.z * q.z);
    });
    tetrahedron_ = {a, b, c, d};
    if (vertices_.orient(a, b, c, d) != Sign::zero) return;
    // The first facet, and the first vertex outside of its plane.
    const auto& [i, j, k] = faces_[0].corner;
    for (std::uint32_t v = 0; v < size_; ++v) {
      if (vertices_.orient(i, j, k, v) != Sign::zero) {
        tetrahedron_ = {i, j, k, v};
        return;
      }
    }
    SUNDER_REQUIRE(false);  // no interior
  }

  // Takes an independent set of low degrees away; returns those that stay. Each goes at once: what it changes has its
  // rim as corners, which stay in this round.
  std::vector<std::uint32_t> take_away(const std::vector<std::uint32_t>& here) {
    std::array<std::vector<std::uint32_t>, Hierarchy::most_degree + 1> by_degree;
    for (const std::uint32_t v : here) {
      if (degree_[v] <= Hierarchy::most_degree && !is_in_tetrahedron(v)) by_degree[degree_[v]].push_back(v);
    }
    ++round_;
    for (const std::vector<std::uint32_t>& some : by_degree) {
      for (const std::uint32_t v : some) {
        if (blocked_[v] != round_) take_away(v);
      }
    }
    std::vector<std::uint32_t> stay;
    for (const std::uint32_t v : here) {
      if (face_of_[v] != none) stay.push_back(v);
    }
    return stay;
  }

  void take_away(std::uint32_t w) {
    rim_.clear();
    beyond_rim_.clear();
    free_.clear();
    for_each_around(w, [&](std::uint32_t t, std::uint32_t place) {
      const Face& face = faces_[t];
      rim_.push_back(face.corner[after(place)]);
      beyond_rim_.push_back(face.adjacent[after(place)]);
      free_.push_back(t);
      triangles_.push_back({face.corner[after(place)], face.corner[before(place)], face.beyond});
    });
    taken_.push_back(w);
    end_.push_back(static_cast<std::uint32_t>(triangles_.size()));
    face_of_[w] = none;
    for (const std::uint32_t v : rim_) {
      degree_[v] -= 2;
      blocked_[v] = round_;
    }
    const std::uint32_t last = static_cast<std::uint32_t>(rim_.size() - 1);
    link_beyond(last, fill(w, 0, last, beyond_rim_[last]));
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
    const std::uint32_t t = free_.back();
    free_.pop_back();
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

  bool is_in_tetrahedron(std::uint32_t v) const {
    return std::find(tetrahedron_.begin(), tetrahedron_.end(), v) != tetrahedron_.end();
  }

  Hierarchy history(const std::vector<std::uint32_t>& last, std::vector<std::uint32_t> level_end) const {
    History made(size_, last, taken_, std::move(level_end));
    for (Hierarchy::Node& node : made.hierarchy.nodes) node.at = at(node.vertex);
    for (Hierarchy::Node& node : made.hierarchy.nodes) {
      const Middle& middle = middle_[node.vertex];
      node.middle = middle.direction;
      if (middle.face == none) continue;
      node.middle_triangle = {made.rank[middle.with[0]], made.rank[middle.with[1]]};
    }
    // Of the tetrahedron: the triangle without its last vertex, and those about that one.
    const std::uint32_t top = last[3];
    const Face& base = faces_[faces_[face_of_[top]].adjacent[after(faces_[face_of_[top]].place_of(top))]];
    const std::uint32_t place = base.place_of(last[2]);
    made.add(last[2], {base.corner[after(place)], base.corner[before(place)], base.beyond});
    for_each_around(top, [&](std::uint32_t t, std::uint32_t at) {
      made.add(top, {faces_[t].corner[after(at)], faces_[t].corner[before(at)], faces_[t].beyond});
    });
    std::uint32_t t = 0;
    for (std::size_t k = 0; k < taken_.size(); ++k) {
      for (; t < end_[k]; ++t) made.add(taken_[k], triangles_[t]);
    }
    return std::move(made.hierarchy);
  }

  Point3 at(std::uint32_t v) const { return vertices_.at(v); }

  const Vertices& vertices_;
  std::uint32_t size_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> face_of_;  // a face at each vertex; none where it went
  std::vector<std::uint32_t> degree_;
  std::vector<Middle> middle_;
  std::array<std::uint32_t, 4> tetrahedron_{};

  std::vector<std::uint32_t> blocked_;  // the round in which a neighbour of a vertex went
  std::uint32_t round_ = 0;
  std::vector<std::uint32_t> rim_, beyond_rim_, free_;

  std::vector<std::uint32_t> taken_;              // in the order in which they went
  std::vector<std::uint32_t> end_;                // of the star of each
  std::vector<Hierarchy::Triangle> triangles_{};  // of the stars, with vertex numbers
};

}  // namespace sunder::solid::hierarchy_detail
