// How hierarchies are made, of whatever has vertices that are exactly in convex position: vertices are taken out of a
// surface (hierarchy_surface.h), each with its star of at most most_degree triangles. No two that go at once are
// adjacent, so their patches have no triangle in common. The four vertices of the tetrahedron stay, so there is always
// an inside.
#pragma once

#include <sunder/base/contract.h>
#include <sunder/number/sign.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/hierarchy_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace sunder::solid::hierarchy_detail {

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
      : vertices_(vertices), size_(size), surface_(vertices, size, facet_begin, facet_vertices), blocked_(size, 0) {
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

  const HierarchySurface<Vertices>& surface() const { return surface_; }

 private:
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
    const auto& [i, j, k] = surface_.face(0).corner;
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
      const std::uint32_t degree = surface_.degree(v);
      if (degree <= Hierarchy::most_degree && !is_in_tetrahedron(v)) by_degree[degree].push_back(v);
    }
    ++round_;
    for (const std::vector<std::uint32_t>& some : by_degree) {
      for (const std::uint32_t v : some) {
        if (blocked_[v] != round_) take_away(v);
      }
    }
    std::vector<std::uint32_t> stay;
    for (const std::uint32_t v : here) {
      if (surface_.face_at(v) != none) stay.push_back(v);
    }
    return stay;
  }

  void take_away(std::uint32_t w) {
    surface_.take_out(w, [&](std::uint32_t t, std::uint32_t place) {
      const Face& face = surface_.face(t);
      triangles_.push_back({face.corner[after(place)], face.corner[before(place)], face.beyond});
    });
    taken_.push_back(w);
    end_.push_back(static_cast<std::uint32_t>(triangles_.size()));
    for (const std::uint32_t v : surface_.rim()) blocked_[v] = round_;
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
    const Face& beside = surface_.face(surface_.face_at(top));
    const Face& base = surface_.face(beside.adjacent[after(beside.place_of(top))]);
    const std::uint32_t place = base.place_of(last[2]);
    made.add(last[2], {base.corner[after(place)], base.corner[before(place)], base.beyond});
    surface_.for_each_around(top, [&](std::uint32_t t, std::uint32_t at) {
      const Face& face = surface_.face(t);
      made.add(top, {face.corner[after(at)], face.corner[before(at)], face.beyond});
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
  HierarchySurface<Vertices> surface_;
  std::vector<Middle> middle_;
  std::array<std::uint32_t, 4> tetrahedron_{};

  std::vector<std::uint32_t> blocked_;  // the round in which a neighbour of a vertex went
  std::uint32_t round_ = 0;

  std::vector<std::uint32_t> taken_;              // in the order in which they went
  std::vector<std::uint32_t> end_;                // of the star of each
  std::vector<Hierarchy::Triangle> triangles_{};  // of the stars, with vertex numbers
};

}  // namespace sunder::solid::hierarchy_detail
