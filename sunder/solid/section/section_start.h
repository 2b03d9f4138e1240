// A place near a plane from which to walk around a convex polyhedron along it (section_walk.h).
//
// On most bodies the table of directions knows a vertex near the plane, and a few steps down from there cross it. Where
// they do not, an edge of the triangulated surfaces of the hierarchy is followed down:
//   T1. The first vertex that comes beyond the plane, going down towards it, has edges to others, none of which is: any
//       of these edges crosses the plane.
//   T2. An edge from above to not above stays until one vertex comes beyond both of its triangles; from that vertex
//       edges go to both ends, and one of these two goes from above to not above.
//   T3. The last one is an edge of the body, or a diagonal of a facet, which is found by halving around its end above;
//       then halving along that facet gives an edge of it.
// So it takes O(log n) signs on every body.
#pragma once

#include <sunder/base/contract.h>
#include <sunder/predicate/point/along.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/search_graph_walk.h>
#include <sunder/solid/represent/half_edges.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/hierarchy_walk.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/search/extreme_vertex.h>
#include <sunder/solid/section/section_walk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace sunder::solid {

class SectionStart {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  // A half-edge that goes down, from above to below; or from a vertex on the plane, where another one goes up.
  struct Found {
    std::uint32_t down, up = none;
  };

  // pulled: the normal as the body's frame sees it. along: the same, exactly. Keeps references to all but it.
  SectionStart(const ConvexPolyhedron& body, const Point3& pulled, Along& along, bool turns_tame, bool is_reflected,
               SectionWalk& walk)
      : body_(body),
        graph_(body.search_graph()),
        edges_(represent::of<HalfEdges>(body)),
        walk_(walk),
        along_(along),
        turns_tame_(turns_tame),
        end_above_(is_reflected ? End::least : End::greatest),
        up_(pulled) {
    if (is_reflected) up_ = {-up_.x, -up_.y, -up_.z};
  }

  // Requires vertices strictly above and below.
  Found find(std::uint32_t above, std::uint32_t below) {
    std::uint32_t edge = descend(near_plane(above));
    if (edge == none) edge = body_.dimension() == 2 ? along_outline(above, below) : down_hierarchy();
    if (walk_.side(edges_.tip(edge)) == Sign::negative) return {edge};
    const std::uint32_t up = edges_.twin[edge];
    return {down_beside(up, below), up};
  }

 private:
  static constexpr std::uint32_t most_down = 64;  // steps from vertex to vertex

  // A vertex above the plane that is near it, as far as the table of directions knows: extreme vertices along
  // directions from the normal round to its opposite are above at first, and below in the end.
  std::uint32_t near_plane(std::uint32_t above) {
    if (graph_.table.empty()) return above;
    const Point3 across = perpendicular(up_);
    double least = 0, greatest = std::numbers::pi;
    std::uint32_t place_above = graph_.place[above], place_below = none;
    for (int step = 0; step < 24 && place_above != place_below; ++step) {
      const double angle = (least + greatest) / 2, c = std::cos(angle), s = std::sin(angle);
      const Point3 d{c * up_.x + s * across.x, c * up_.y + s * across.y, c * up_.z + s * across.z};
      const std::uint32_t place = table_start(graph_, d);
      if (place == place_above || place == place_below) {
        (place == place_above ? least : greatest) = angle;
        if ((greatest - least) * graph_.side < 1) break;
        continue;
      }
      const std::uint32_t v = graph_.block(place).vertex();
      if (walk_.side(v) == Sign::positive) {
        least = angle;
        above = v;
        place_above = place;
      } else {
        greatest = angle;
        place_below = place;
      }
    }
    return above;
  }

  static Point3 perpendicular(const Point3& d) {
    const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
    const Point3 p = x <= y && x <= z ? Point3{0, -d.z, d.y} : y <= z ? Point3{d.z, 0, -d.x} : Point3{-d.y, d.x, 0};
    const double scale = std::sqrt((d.x * d.x + d.y * d.y + d.z * d.z) / (p.x * p.x + p.y * p.y + p.z * p.z));
    return {p.x * scale, p.y * scale, p.z * scale};
  }

  // Down from a vertex above, to the lowest neighbour each time, until one is not above: the half-edge to that one.
  // None where it takes long, or floating point does not tell which neighbours are lower.
  std::uint32_t descend(std::uint32_t v) {
    double height = walk_.height(v);
    for (std::uint32_t step = 0; step < most_down && edges_.degree(v) <= most_around; ++step) {
      std::uint32_t lowest = none;
      for (std::uint32_t k = edges_.begin[v]; k < edges_.begin[v + 1]; ++k) {
        const double at = walk_.height(edges_.tip(edges_.out[k]));
        if (!(at < height)) continue;
        height = at;
        lowest = edges_.out[k];
      }
      if (lowest == none) return none;
      v = edges_.tip(lowest);
      if (walk_.side(v) != Sign::positive) return lowest;
    }
    return none;
  }

  // Of the half-edges that start where this one does, on the plane, one that goes below. This one goes up. The plane
  // through it and a vertex below parts the others in two, and has a direction that goes below between these.
  std::uint32_t down_beside(std::uint32_t up, std::uint32_t below) {
    const std::uint32_t n = edges_.degree(edges_.origin[up]);
    const auto is_down = [&](std::uint32_t k) {
      return walk_.side(edges_.tip(edges_.turned(up, k))) == Sign::negative;
    };
    for (const std::uint32_t k : {1u, n - 1}) {
      if (is_down(k)) return edges_.turned(up, k);
    }
    const auto side_of = [&](std::uint32_t k) {
      return side(edges_.origin[up], edges_.tip(up), below, edges_.tip(edges_.turned(up, k)));
    };
    const Sign first = side_of(1);
    const std::uint32_t k = last(1, n - 1, [&](std::uint32_t j) { return side_of(j) == first; });
    return edges_.turned(up, is_down(k) ? k : k + 1);
  }

  // The last k in [least, end) that is good: all from there up to it are, and none after it.
  template <class IsGood>
  static std::uint32_t last(std::uint32_t least, std::uint32_t end, const IsGood& is_good) {
    while (end - least > 1) {
      const std::uint32_t k = least + (end - least) / 2;
      (is_good(k) ? least : end) = k;
    }
    return least;
  }

  // orient_3d of vertices, as they are in the body.
  Sign side(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    ++walk_.cost().probes;
    const auto& at = graph_.vertices;
    return orient_3d(at[a], at[b], at[c], at[d], &walk_.tally());
  }

  // Along a facet from a half-edge that starts above, to the one of it that goes from above to not above; so many
  // places further a half-edge starts where it is not above.
  std::uint32_t change_along(std::uint32_t e, std::uint32_t not_above) {
    return edges_.along(e, last(0, not_above, [&](std::uint32_t k) {
                          return walk_.side(edges_.origin[edges_.along(e, k)]) == Sign::positive;
                        }));
  }

  // Of a flat body.
  std::uint32_t along_outline(std::uint32_t above, std::uint32_t below) {
    const auto on_first = [&](std::uint32_t v) {
      const std::uint32_t e = edges_.out[edges_.begin[v]];
      return edges_.facet[e] == 0 ? e : edges_.turned(e, 1);
    };
    const std::uint32_t from = on_first(above), to = on_first(below), n = edges_.facet_size(0);
    return change_along(from, (to + n - from) % n);
  }

  // T1 to T3.
  std::uint32_t down_hierarchy() {
    const Hierarchy& hierarchy = represent::of<Hierarchy>(body_);
    Tracked edge = first_crossing(hierarchy);
    while (edge.beyond[0] != none || edge.beyond[1] != none) follow(hierarchy, edge);
    return on_surface(hierarchy.nodes[edge.above].vertex, hierarchy.nodes[edge.other].vertex);
  }

  // An edge of a surface between ranks, with what comes beyond its two triangles.
  struct Tracked {
    std::uint32_t above, other;  // not above
    std::array<std::uint32_t, 2> beyond;
  };

  bool is_above(const Hierarchy& hierarchy, std::uint32_t rank) {
    return walk_.side(hierarchy.nodes[rank].vertex) == Sign::positive;
  }

  Tracked first_crossing(const Hierarchy& hierarchy) {
    std::uint32_t above = none, other = none;
    for (std::uint32_t rank = 0; rank < 4; ++rank) (is_above(hierarchy, rank) ? above : other) = rank;
    if (above != none && other != none) return {above, other, beyond_first(hierarchy, above, other)};
    const bool up = above == none;
    const auto towards = [&](Sign sign) { return up == (end_above_ == End::greatest) ? sign : -sign; };
    const auto at = [&](std::uint32_t rank) -> const Point3& { return hierarchy.nodes[rank].at; };
    const auto compare = [&](std::uint32_t i, std::uint32_t j) {
      return towards(along_.compare(at(i), at(j), &walk_.tally()));
    };
    const auto turn = [&](std::uint32_t v, std::uint32_t i, std::uint32_t j) {
      const Hierarchy::Node& node = hierarchy.nodes[v];
      if (node.has_middle_in_doubles()) {
        return towards(along_.turn(node.middle, node.at, at(i), at(j), turns_tame_, &walk_.tally()));
      }
      const auto& [p, q] = node.middle_triangle;
      return towards(along_.turn_about_normal(at(p), at(q), node.at, at(i), at(j), &walk_.tally()));
    };
    HierarchyWalk search(hierarchy, compare, turn, walk_.cost().probes);
    search.start();
    while (true) {
      const std::uint32_t w = search.next();
      if (!search.is_further(w)) {
        search.pass(w);
      } else if (is_above(hierarchy, w) != up) {
        search.go_to(w);
      } else {
        const std::uint32_t beside = hierarchy.nodes[w].rim[0];
        const auto beyond = beyond_star(hierarchy, w, beside);
        return up ? Tracked{w, beside, beyond} : Tracked{beside, w, beyond};
      }
    }
  }

  // Of an edge of the tetrahedron.
  static std::array<std::uint32_t, 2> beyond_first(const Hierarchy& hierarchy, std::uint32_t i, std::uint32_t j) {
    std::array<std::uint32_t, 2> beyond{none, none};
    std::size_t found = 0;
    for (const std::uint32_t of : {2u, 3u}) {
      for (const Hierarchy::Triangle t : hierarchy.nodes[of].star()) {
        const auto has = [&](std::uint32_t k) { return of == k || t.a == k || t.b == k; };
        if (has(i) && has(j)) beyond[found++] = t.beyond;
      }
    }
    return beyond;
  }

  // Of an edge from a vertex that comes to one of its rim.
  static std::array<std::uint32_t, 2> beyond_star(const Hierarchy& hierarchy, std::uint32_t w, std::uint32_t rim) {
    std::array<std::uint32_t, 2> beyond{none, none};
    for (const Hierarchy::Triangle t : hierarchy.nodes[w].star()) {
      if (t.a == rim) beyond[0] = t.beyond;
      if (t.b == rim) beyond[1] = t.beyond;
    }
    return beyond;
  }

  // T2: to where the next vertex comes beyond a triangle of the edge.
  void follow(const Hierarchy& hierarchy, Tracked& edge) {
    const std::uint32_t w = std::min(edge.beyond[0], edge.beyond[1]);
    if (edge.beyond[0] == edge.beyond[1]) {
      (is_above(hierarchy, w) ? edge.above : edge.other) = w;
      edge.beyond = beyond_star(hierarchy, w, edge.above == w ? edge.other : edge.above);
      return;
    }
    for (const Hierarchy::Triangle t : hierarchy.nodes[w].star()) {
      const bool is_there = (t.a == edge.above && t.b == edge.other) || (t.a == edge.other && t.b == edge.above);
      if (is_there) edge.beyond[edge.beyond[0] == w ? 0 : 1] = t.beyond;
    }
  }

  // T3: from p, above, to q, which is not, and in a facet with it.
  std::uint32_t on_surface(std::uint32_t p, std::uint32_t q) {
    const std::uint32_t n = edges_.degree(p), first = edges_.out[edges_.begin[p]];
    const auto tip = [&](std::uint32_t k) { return edges_.tip(edges_.turned(first, k)); };
    if (tip(0) == q) return first;
    // Fans from the first edge: what comes after one has this sign.
    const Sign after = side(p, tip(0), tip(1), tip(2));
    const std::uint32_t k = last(1, n, [&](std::uint32_t j) { return side(p, tip(0), tip(j), q) != -after; });
    for (const std::uint32_t sector : {k, k - 1}) {
      const std::uint32_t e = edges_.turned(first, sector), place = place_along(e, q);
      if (place != none) return change_along(e, place);
    }
    SUNDER_REQUIRE(false);  // some facet has both
    return none;
  }

  // How far along its facet from where e starts the vertex q is; or none.
  std::uint32_t place_along(std::uint32_t e, std::uint32_t q) {
    const std::uint32_t n = edges_.facet_size(edges_.facet[e]), p = edges_.origin[e];
    const auto corner = [&](std::uint32_t k) { return edges_.origin[edges_.along(e, k)]; };
    const std::uint32_t beside = edges_.tip(edges_.turned(e, 2));  // not in the plane of the facet
    const Sign after = side(p, corner(1), beside, corner(2));
    const std::uint32_t k = last(1, n, [&](std::uint32_t j) { return side(p, corner(j), beside, q) != -after; });
    return corner(k) == q ? k : none;
  }

  const ConvexPolyhedron& body_;
  const SearchGraph& graph_;
  const HalfEdges& edges_;
  SectionWalk& walk_;
  Along& along_;
  bool turns_tame_;
  End end_above_;
  Point3 up_;
};

}  // namespace sunder::solid
