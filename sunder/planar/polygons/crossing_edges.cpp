#include <sunder/planar/polygons/crossing_edges.h>
#include <sunder/predicate/line/crossing.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>

namespace sunder::planar {

namespace {

// Looks for a vertex in the point where edge e of a and edge f of b cross.
class VertexSearch {
 public:
  VertexSearch(const Polygon& a, std::uint32_t e, const Polygon& b, std::uint32_t f, std::uint64_t& probes)
      : s_(sorted(a.edge(e))), t_(sorted(b.edge(f))), probes_(probes) {
    const LanesBox of_s = lanes_box_of(s_.a, s_.b), of_t = lanes_box_of(t_.a, t_.b);
    box_ = {greater_of(of_s.low, of_t.low), smaller_of(of_s.high, of_t.high)};
    around_ = FourBoxes::all(common_part(a.edge_boxes().box(0, e / fan), b.edge_boxes().box(0, f / fan)));
  }

  // The edge is the polygon's own one of the two: its ends are not in the point.
  bool finds_one_of(const Polygon& polygon, std::uint32_t edge) {
    ends_ = {edge, polygon.next(edge)};
    const std::uint32_t top = polygon.edge_boxes().top();
    const auto fours = static_cast<std::uint32_t>(polygon.edge_boxes().level(top).size());
    for (std::uint32_t k = 0; k < fours; ++k) {
      if (is_in_four(polygon, top, k)) return true;
    }
    return false;
  }

 private:
  static constexpr std::uint32_t fan = EdgeBoxes::fan;

  // Of the runs from fan k on.
  bool is_in_four(const Polygon& polygon, std::uint32_t level, std::uint32_t k) {
    probes_ += fan;
    for (std::uint32_t near = meeting(polygon.edge_boxes().level(level)[k], around_); near != 0; near &= near - 1) {
      const std::uint32_t run = fan * k + static_cast<std::uint32_t>(std::countr_zero(near));
      if (level > 0 ? is_in_four(polygon, level - 1, run) : is_in_run(polygon, run)) return true;
    }
    return false;
  }

  bool is_in_run(const Polygon& polygon, std::uint32_t run) {
    probes_ += fan;
    const std::span<const Point2> vertices = std::span(polygon.vertices()).subspan(fan * run);
    std::uint32_t near = 0;  // a bit for each vertex that is in the box. Without branches: no one can predict these
    for (std::uint32_t k = 0; k < std::min<std::size_t>(fan, vertices.size()); ++k) {
      const Lanes v = lanes_at(&vertices[k].x);
      near |= std::uint32_t{meet({v, v}, box_)} << k;
    }
    for (const std::uint32_t end : ends_) near &= ~(std::uint32_t{end / fan == run} << end % fan);
    for (; near != 0; near &= near - 1) {
      if (is_common(vertices[static_cast<std::size_t>(std::countr_zero(near))])) return true;
    }
    return false;
  }

  bool is_common(const Point2& v) {
    if (++compared_ == few) narrow();
    return orient_2d(s_.a, s_.b, v) == Sign::zero && orient_2d(t_.a, t_.b, v) == Sign::zero;
  }

  // From what is common to the boxes of both edges to what surely holds the point.
  void narrow() {
    const Enclosure2 in = enclosure(Crossing{s_.a, s_.b, t_.a, t_.b});
    box_ = {greater_of(box_.low, Lanes{in.x.low, in.y.low}), smaller_of(box_.high, Lanes{in.x.high, in.y.high})};
    around_ = FourBoxes::all(coarse(box_));
  }

  static constexpr std::uint32_t few = 16;  // vertices that are compared in the time that it takes to narrow

  Segment s_, t_;
  LanesBox box_;  // holds the point
  FourBoxes around_;
  std::array<std::uint32_t, 2> ends_{};
  std::uint32_t compared_ = 0;  // vertices
  std::uint64_t& probes_;
};

}  // namespace

bool overlap_at_crossing(const Polygon& a, std::uint32_t e, const Polygon& b, std::uint32_t f, std::uint64_t& probes) {
  if (a.strictly_convex() || b.strictly_convex()) return true;  // on an edge it has no vertex
  VertexSearch search(a, e, b, f, probes);
  return !search.finds_one_of(a, e) || !search.finds_one_of(b, f);
}

}  // namespace sunder::planar
