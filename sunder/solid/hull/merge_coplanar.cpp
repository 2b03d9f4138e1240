#include <sunder/solid/hull/merge_coplanar.h>

#include <utility>

// An edge between two triangles that are not coplanar is a crease. The triangles of one maximal facet are coplanar and
// hang together by edges that are no creases, so the creases are the outlines of the facets.
// M1. A corner in the interior of a facet has no crease, one in the interior of an edge of the hull has two, and an
//     extreme one has three or more, one for each edge of the hull there.
// M2. The outline of a facet is one cycle, because the facet is a convex polygon. Its extreme corners are its vertices,
//     and any three consecutive ones turn strictly.
// Everything is collected in the order of the triangles, which is good for the memory caches.

namespace sunder::solid {

namespace {

constexpr std::uint32_t none = Triangle::none;

class Merger {
 public:
  Merger(std::span<const Point3> points, const std::vector<Triangle>& triangles)
      : points_(points),
        triangles_(triangles),
        marks_(triangles.size()),
        crease_count_(points.size()),
        number_(points.size(), none) {}

  ConvexHull run() {
    hull_.dimension = 3;
    find_creases();
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (const std::uint32_t place : {0u, 1u, 2u}) {
        const Edge edge{t, place};
        if (!is_crease(edge) || !is_extreme(start_of(edge))) continue;
        if (number_[start_of(edge)] == none) collect_vertex(edge);
        if (!is_outlined(edge)) collect_facet(edge);
      }
    }
    // So far `neighbours` and `facet_vertices` hold points.
    for (std::uint32_t& p : hull_.neighbours) p = number_[p];
    for (std::uint32_t& p : hull_.facet_vertices) p = number_[p];
    return std::move(hull_);
  }

 private:
  // An edge, as the triangle on its left and the place of its first corner there.
  struct Edge {
    std::uint32_t triangle;
    std::uint32_t place;
    friend bool operator==(const Edge&, const Edge&) = default;
  };

  void find_creases() {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const Triangle& triangle = triangles_[t];
      if (triangle.removed) continue;
      for (const std::uint32_t place : {0u, 1u, 2u}) {
        if (triangle.adjacent[place] < t) continue;
        const Edge edge{t, place};
        const Edge twin = beyond(edge, end_of(edge));
        const std::uint32_t apex = start_of({twin.triangle, previous(twin.place)});
        if (triangle.side(points_, points_[apex]) == Sign::zero) continue;
        add_crease(edge);
        add_crease(twin);
      }
    }
  }

  void add_crease(const Edge& edge) {
    marks_[edge.triangle] |= crease_mark(edge.place);
    std::uint8_t& count = crease_count_[start_of(edge)];
    if (count < 3) ++count;
  }

  bool is_extreme(std::uint32_t p) const { return crease_count_[p] == 3; }

  static std::uint8_t crease_mark(std::uint32_t place) { return static_cast<std::uint8_t>(1u << place); }
  static std::uint8_t outline_mark(std::uint32_t place) { return static_cast<std::uint8_t>(8u << place); }
  bool is_crease(const Edge& edge) const { return (marks_[edge.triangle] & crease_mark(edge.place)) != 0; }
  bool is_outlined(const Edge& edge) const { return (marks_[edge.triangle] & outline_mark(edge.place)) != 0; }

  std::uint32_t start_of(const Edge& edge) const { return triangles_[edge.triangle].corner[edge.place]; }
  std::uint32_t end_of(const Edge& edge) const { return triangles_[edge.triangle].corner[next(edge.place)]; }

  // The edge from corner p in the triangle beyond the given edge, which begins or ends at p.
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

  // The vertex where the edge of the hull ends that begins with a crease.
  std::uint32_t end_of_hull_edge(Edge crease) const {
    while (!is_extreme(end_of(crease))) crease = next_on_outline(crease);
    return end_of(crease);
  }

  // The vertex where a crease begins, and its neighbours.
  void collect_vertex(const Edge& first) {
    const std::uint32_t v = start_of(first);
    number_[v] = static_cast<std::uint32_t>(hull_.vertices.size());
    hull_.vertices.push_back(v);
    Edge edge = first;
    do {
      if (is_crease(edge)) hull_.neighbours.push_back(end_of_hull_edge(edge));
      edge = beyond({edge.triangle, previous(edge.place)}, v);
    } while (edge != first);
    hull_.neighbour_begin.push_back(static_cast<std::uint32_t>(hull_.neighbours.size()));
  }

  // The facet on the left of a crease.
  void collect_facet(const Edge& first) {
    for (Edge crease = first; !is_outlined(crease); crease = next_on_outline(crease)) {
      marks_[crease.triangle] |= outline_mark(crease.place);
      if (is_extreme(start_of(crease))) hull_.facet_vertices.push_back(start_of(crease));
    }
    hull_.facet_begin.push_back(static_cast<std::uint32_t>(hull_.facet_vertices.size()));
  }

  std::span<const Point3> points_;
  const std::vector<Triangle>& triangles_;
  std::vector<std::uint8_t> marks_;         // of each triangle: which edges are creases, which are outlined
  std::vector<std::uint8_t> crease_count_;  // of each point: 3 stands for 3 or more
  std::vector<std::uint32_t> number_;       // of each vertex found: its number
  ConvexHull hull_;
};

}  // namespace

ConvexHull merge_coplanar(std::span<const Point3> points, const std::vector<Triangle>& triangles) {
  return Merger(points, triangles).run();
}

}  // namespace sunder::solid
