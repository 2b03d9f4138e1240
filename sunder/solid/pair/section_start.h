// A place near a plane from which to walk around a convex polyhedron along it (section_walk.h).
#pragma once

#include <sunder/predicate/orient.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/pair/section_walk.h>
#include <sunder/solid/represent/search_graph_walk.h>

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

  // pulled: the normal as the body's frame sees it.
  SectionStart(const ConvexPolyhedron& body, const Point3& pulled, bool is_reflected, SectionWalk& walk)
      : body_(body), graph_(body.search_graph()), edges_(body.half_edges()), walk_(walk), up_(pulled) {
    if (is_reflected) up_ = {-up_.x, -up_.y, -up_.z};
  }

  // Requires vertices strictly above and below.
  Found find(std::uint32_t above, std::uint32_t below) {
    const std::uint32_t edge = descend(near_plane(above));
    if (edge != none) return from_edge_down(edge, below);
    return by_scan(below);
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

  // From a half-edge whose start is above, and whose tip is not.
  Found from_edge_down(std::uint32_t edge, std::uint32_t below) {
    if (walk_.side(edges_.tip(edge)) == Sign::negative) return {edge};
    const std::uint32_t up = edges_.twin[edge];
    return {down_beside(up, below), up};
  }

  // Of the half-edges that start where this one does, on the plane, one that goes below.
  std::uint32_t down_beside(std::uint32_t up, std::uint32_t) {
    std::uint32_t k = 1;
    while (walk_.side(edges_.tip(edges_.turned(up, k))) != Sign::negative) ++k;
    return edges_.turned(up, k);
  }

  Found by_scan(std::uint32_t below) {
    std::uint32_t e = 0;
    while (walk_.side(edges_.origin[e]) != Sign::positive || walk_.side(edges_.tip(e)) == Sign::positive) ++e;
    return from_edge_down(e, below);
  }

  const ConvexPolyhedron& body_;
  const SearchGraph& graph_;
  const HalfEdges& edges_;
  SectionWalk& walk_;
  Point3 up_;
};

}  // namespace sunder::solid
