// Once around a convex polyhedron along a plane, from facet to facet, by exact signs of vertices.
// Also called: marching around a contour; rotation system.
//
// Let some vertices be above and some below. In a facet with both, vertices in order (counter-clockwise from outside)
// are above, perhaps one on the plane, below, perhaps one on the plane: two changes, as a line crosses a convex
// polygon. Around a vertex on the plane the neighbours, too, are above, perhaps one on it, below, perhaps one on it:
// the plane cuts the cone of the body there, which has both above and below (else the vertex was furthest along the
// normal).
//   W1. A facet is entered where its vertices go from above to below, and left where they go back up. The half-edge
//       that goes up has its twin in the next facet, going down: so facets are passed counter-clockwise seen from
//       above.
//   W2. At a vertex the walk goes on where neighbours, counter-clockwise, go from below to above: along the edge to one
//       that is on the plane, or into the facet between.
// One change is known from where the walk comes; the other one is alone in the rest of the cycle, so halving finds it.
#pragma once

#include <sunder/predicate/point/plane_sides.h>
#include <sunder/solid/represent/half_edges.h>
#include <sunder/solid/section/polyhedron_plane_section.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::solid {

// Above and below are meant as seen from a body that is not reflected: of a reflected one they are the other way round.
class SectionWalk {
 public:
  // Keeps references to all but the numbers.
  SectionWalk(std::span<const Point3> vertices, const HalfEdges& edges, PlaneSides& sides, bool is_reflected,
              Cost& cost, StageTally& tally)
      : vertices_(vertices), edges_(edges), sides_(sides), is_reflected_(is_reflected), cost_(cost), tally_(tally) {}

  Sign side(std::uint32_t v) {
    ++cost_.probes;
    const Sign sign = sides_(vertices_[v], &tally_);
    return is_reflected_ ? -sign : sign;
  }
  Cost& cost() { return cost_; }
  StageTally& tally() { return tally_; }
  double height(std::uint32_t v) const {  // as PlaneSides::height
    const double height = sides_.height(vertices_[v]);
    return is_reflected_ ? -height : height;
  }

  // All corners, from that on the edge which this half-edge goes down, from above to below.
  void go_from_edge(std::uint32_t down, std::vector<SectionCorner>& corners) {
    corners.push_back(edge_corner(down));
    go(down, down, none, corners);
  }

  // All corners, from the vertex on the plane at which two half-edges start: one goes down, one goes up.
  void go_from_vertex(std::uint32_t down, std::uint32_t up, std::vector<SectionCorner>& corners) {
    const std::uint32_t v = edges_.origin[down], n = edges_.degree(v);
    corners.push_back({v, v});
    const std::uint32_t to_up = (edges_.around[up] + n - edges_.around[down]) % n;
    const std::uint32_t next = go_on_from_vertex(down, 0, to_up, v, corners);
    if (next != none) go(next, none, v, corners);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  static constexpr std::uint32_t few = 8;  // so many are gone through one by one

  SectionCorner edge_corner(std::uint32_t down) const {
    const std::uint32_t above = edges_.origin[down], below = edges_.tip(down);
    return is_reflected_ ? SectionCorner{below, above} : SectionCorner{above, below};
  }

  struct Change {
    std::uint32_t at;
    Sign side;  // of what is there: not negative
  };

  // The first k after `below` at which side_at is not negative. It is negative at `below`, positive at `above`, which
  // is later; between them it changes once, perhaps by a zero.
  template <class SideAt>
  Change change(std::uint32_t below, std::uint32_t above, const SideAt& side_at) {
    Change found{above, Sign::positive};
    while (found.at - below > 1) {
      const std::uint32_t k = found.at - below <= few ? below + 1 : below + (found.at - below) / 2;
      const Sign side = side_at(k);
      if (side == Sign::negative) {
        below = k;
      } else {
        found = {k, side};
      }
    }
    return found;
  }

  // From the facet that `down` enters on, until the half-edge `last` would be gone down again, or `last_vertex` be come
  // to.
  void go(std::uint32_t down, std::uint32_t last, std::uint32_t last_vertex, std::vector<SectionCorner>& corners) {
    while (true) {
      const std::uint32_t n = edges_.facet_size(edges_.facet[down]);
      const Change up =
          change(0, n - 1, [&](std::uint32_t k) { return side(edges_.origin[edges_.along(down, k + 1)]); });
      const std::uint32_t back = edges_.twin[edges_.along(down, up.at)];
      if (up.side == Sign::positive) {
        if (back == last) return;
        corners.push_back(edge_corner(back));
        down = back;
      } else {
        const std::uint32_t v = edges_.origin[back];
        if (v == last_vertex) return;
        corners.push_back({v, v});
        down = go_on_from_vertex(back, 0, edges_.degree(v) - 1, last_vertex, corners);
        if (down == none) return;
      }
    }
  }

  // W2: `from` starts at a vertex on the plane; its tip is on the plane, too, and the next one is below, or, where
  // `below` is 0, it is itself; so many places further, the tip is above. Goes along edges in the plane until none goes
  // on; returns the half-edge that goes down into the next facet.
  std::uint32_t go_on_from_vertex(std::uint32_t from, std::uint32_t below, std::uint32_t above,
                                  std::uint32_t last_vertex, std::vector<SectionCorner>& corners) {
    while (true) {
      const Change found =
          change(below, above, [&](std::uint32_t k) { return side(edges_.tip(edges_.turned(from, k))); });
      if (found.side == Sign::positive) return edges_.turned(from, found.at - 1);
      from = edges_.twin[edges_.turned(from, found.at)];
      const std::uint32_t v = edges_.origin[from];
      if (v == last_vertex) return none;
      corners.push_back({v, v});
      below = 1;
      above = edges_.degree(v) - 1;
    }
  }

  std::span<const Point3> vertices_;
  const HalfEdges& edges_;
  PlaneSides& sides_;
  bool is_reflected_;
  Cost& cost_;
  StageTally& tally_;
};

}  // namespace sunder::solid
