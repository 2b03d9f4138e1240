#include <sunder/solid/hull/merge_coplanar.h>

#include <algorithm>

// An edge between two triangles that are not coplanar is a crease. The triangles of one maximal facet are coplanar and
// hang together by edges that are no creases, so the creases are the outlines of the facets.
// M1. A corner in the interior of a facet has no crease, one in the interior of an edge of the hull has two, and an
//     extreme one has three or more, one for each maximal facet at it.
// M2. The outline of a facet is one cycle, because the facet is a convex polygon.

namespace sunder::solid {

namespace {

class Merger {
 public:
  Merger(std::span<const Point3> points, const std::vector<Triangle>& triangles)
      : triangles_(triangles),
        marks_(triangles.size()),
        crease_count_(points.size()),
        some_triangle_(points.size()),
        number_(points.size()) {
    find_creases(points);
  }

  ConvexHull run() {
    hull_.dimension = 3;
    for (std::uint32_t p = 0; p < crease_count_.size(); ++p) {
      if (!is_extreme(p)) continue;
      number_[p] = static_cast<std::uint32_t>(hull_.vertices.size());
      hull_.vertices.push_back(p);
    }
    for (const std::uint32_t p : hull_.vertices) append_vertex(p);
    return std::move(hull_);
  }

 private:
  // An edge, as the triangle on its left and the place of its first corner there.
  struct Edge {
    std::uint32_t triangle;
    int place;
  };

  // An edge of the hull: the first of the creases that it consists of, and the number of the vertex where it ends.
  struct HullEdge {
    std::uint32_t end;
    Edge crease;
  };

  void find_creases(std::span<const Point3> points) {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const Triangle& triangle = triangles_[t];
      if (triangle.removed) continue;
      for (const int e : {0, 1, 2}) {
        const std::uint32_t beyond = triangle.adjacent[e];
        if (beyond < t) continue;
        const std::uint32_t a = triangle.corner[e];
        const std::uint32_t b = triangle.corner[next(e)];
        const int from_b = triangles_[beyond].place_of(b);
        const std::uint32_t apex = triangles_[beyond].corner[previous(from_b)];
        if (triangle.side(points, points[apex]) == Sign::zero) continue;
        add_crease({t, e}, a);
        add_crease({beyond, from_b}, b);
      }
    }
  }

  void add_crease(const Edge& edge, std::uint32_t from) {
    marks_[edge.triangle] |= crease_mark(edge.place);
    if (crease_count_[from] < 3) ++crease_count_[from];
    some_triangle_[from] = edge.triangle;
  }

  bool is_extreme(std::uint32_t p) const { return crease_count_[p] == 3; }

  static std::uint8_t crease_mark(int place) { return static_cast<std::uint8_t>(1 << place); }
  static std::uint8_t outline_mark(int place) { return static_cast<std::uint8_t>(8 << place); }
  bool is_crease(const Edge& edge) const { return (marks_[edge.triangle] & crease_mark(edge.place)) != 0; }
  bool is_outlined(const Edge& edge) const { return (marks_[edge.triangle] & outline_mark(edge.place)) != 0; }

  std::uint32_t start_of(const Edge& edge) const { return triangles_[edge.triangle].corner[edge.place]; }
  std::uint32_t end_of(const Edge& edge) const { return triangles_[edge.triangle].corner[next(edge.place)]; }

  // The next edge from corner p beyond the given edge, which begins or ends there.
  Edge beyond(const Edge& edge, std::uint32_t p) const {
    const std::uint32_t t = triangles_[edge.triangle].adjacent[edge.place];
    return {t, triangles_[t].place_of(p)};
  }

  // The crease that follows on the outline of the facet on the left.
  Edge next_on_outline(const Edge& crease) const {
    const std::uint32_t pivot = end_of(crease);
    Edge edge{crease.triangle, next(crease.place)};
    while (!is_crease(edge)) edge = beyond(edge, pivot);
    return edge;
  }

  // The neighbours of vertex p, and the facets of which it is the lowest vertex.
  void append_vertex(std::uint32_t p) {
    fan_.clear();
    const Edge first{some_triangle_[p], triangles_[some_triangle_[p]].place_of(p)};
    Edge edge = first;
    do {
      if (is_crease(edge)) fan_.push_back({end_of_hull_edge(edge), edge});
      edge = beyond({edge.triangle, previous(edge.place)}, p);
    } while (edge.triangle != first.triangle);

    const auto lower = [](const HullEdge& e, const HullEdge& f) { return e.end < f.end; };
    std::rotate(fan_.begin(), std::min_element(fan_.begin(), fan_.end(), lower), fan_.end());
    for (const HullEdge& e : fan_) hull_.neighbours.push_back(e.end);
    hull_.neighbour_begin.push_back(static_cast<std::uint32_t>(hull_.neighbours.size()));

    // A facet with a lower vertex is outlined by now. Those left begin at p and differ in their second vertex.
    std::sort(fan_.begin(), fan_.end(), lower);
    for (const HullEdge& e : fan_) {
      if (!is_outlined(e.crease)) append_facet(e.crease);
    }
  }

  std::uint32_t end_of_hull_edge(Edge crease) const {
    while (!is_extreme(end_of(crease))) crease = next_on_outline(crease);
    return number_[end_of(crease)];
  }

  // The facet on the left of an edge from its lowest vertex.
  void append_facet(const Edge& first) {
    for (Edge crease = first; !is_outlined(crease); crease = next_on_outline(crease)) {
      marks_[crease.triangle] |= outline_mark(crease.place);
      if (is_extreme(start_of(crease))) hull_.facet_vertices.push_back(number_[start_of(crease)]);
    }
    hull_.facet_begin.push_back(static_cast<std::uint32_t>(hull_.facet_vertices.size()));
  }

  const std::vector<Triangle>& triangles_;
  std::vector<std::uint8_t> marks_;           // of each triangle: which edges are creases, which are outlined
  std::vector<std::uint8_t> crease_count_;    // of each point: 3 stands for 3 or more
  std::vector<std::uint32_t> some_triangle_;  // of each point with a crease: one of its triangles
  std::vector<std::uint32_t> number_;         // of each extreme point: its vertex number
  std::vector<HullEdge> fan_;                 // the edges at the latest vertex
  ConvexHull hull_;
};

}  // namespace

ConvexHull merge_coplanar(std::span<const Point3> points, const std::vector<Triangle>& triangles) {
  return Merger(points, triangles).run();
}

}  // namespace sunder::solid
