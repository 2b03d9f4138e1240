#include <sunder/solid/hull/merge_coplanar.h>

#include <algorithm>
#include <numeric>

// An edge between two triangles that are not coplanar is a crease. The triangles of one maximal facet are coplanar and
// hang together by edges that are no creases, so the creases are the outlines of the facets.
// M1. A corner in the interior of a facet has no crease, one in the interior of an edge of the hull has two, and an
//     extreme one has three or more, one for each edge of the hull there.
// M2. The outline of a facet is one cycle, because the facet is a convex polygon. Its extreme corners are its vertices,
//     and any three consecutive ones turn strictly.
// Everything is collected in the order of the triangles, which is good for the memory caches, and put in order in the
// end.

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
    number_vertices();
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (const int place : {0, 1, 2}) {
        const Edge edge{t, place};
        if (!is_crease(edge) || !is_extreme(start_of(edge))) continue;
        const std::uint32_t v = number_[start_of(edge)];
        if (hull_.neighbours[hull_.neighbour_begin[v]] == none) collect_neighbours(v, edge);
        if (!is_outlined(edge)) collect_facet(edge);
      }
    }
    order_facets();
    return std::move(hull_);
  }

 private:
  // An edge, as the triangle on its left and the place of its first corner there.
  struct Edge {
    std::uint32_t triangle;
    int place;
    friend bool operator==(const Edge&, const Edge&) = default;
  };

  void find_creases() {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const Triangle& triangle = triangles_[t];
      if (triangle.removed) continue;
      for (const int place : {0, 1, 2}) {
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
    ++crease_count_[start_of(edge)];
  }

  void number_vertices() {
    for (std::uint32_t p = 0; p < points_.size(); ++p) {
      if (crease_count_[p] < 3) continue;
      number_[p] = static_cast<std::uint32_t>(hull_.vertices.size());
      hull_.vertices.push_back(p);
      hull_.neighbour_begin.push_back(hull_.neighbour_begin.back() + crease_count_[p]);
    }
    hull_.neighbours.assign(hull_.neighbour_begin.back(), none);
  }

  bool is_extreme(std::uint32_t p) const { return number_[p] != none; }

  static std::uint8_t crease_mark(int place) { return static_cast<std::uint8_t>(1 << place); }
  static std::uint8_t outline_mark(int place) { return static_cast<std::uint8_t>(8 << place); }
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

  // The number of the vertex where the edge of the hull ends that begins with a crease.
  std::uint32_t end_of_hull_edge(Edge crease) const {
    while (!is_extreme(end_of(crease))) crease = next_on_outline(crease);
    return number_[end_of(crease)];
  }

  // The neighbours of vertex v, where the given crease begins.
  void collect_neighbours(std::uint32_t v, const Edge& first) {
    cycle_.clear();
    const std::uint32_t pivot = start_of(first);
    Edge edge = first;
    do {
      if (is_crease(edge)) cycle_.push_back(end_of_hull_edge(edge));
      edge = beyond({edge.triangle, previous(edge.place)}, pivot);
    } while (edge != first);
    const auto lowest = std::min_element(cycle_.begin(), cycle_.end());
    std::rotate_copy(cycle_.begin(), lowest, cycle_.end(), hull_.neighbours.begin() + hull_.neighbour_begin[v]);
  }

  // The facet on the left of a crease.
  void collect_facet(const Edge& first) {
    cycle_.clear();
    for (Edge crease = first; !is_outlined(crease); crease = next_on_outline(crease)) {
      marks_[crease.triangle] |= outline_mark(crease.place);
      if (is_extreme(start_of(crease))) cycle_.push_back(number_[start_of(crease)]);
    }
    const auto lowest = std::min_element(cycle_.begin(), cycle_.end());
    facet_vertices_.insert(facet_vertices_.end(), lowest, cycle_.end());
    facet_vertices_.insert(facet_vertices_.end(), cycle_.begin(), lowest);
    facet_begin_.push_back(static_cast<std::uint32_t>(facet_vertices_.size()));
  }

  // By first vertex, in linear time, then by second: no two facets agree in both.
  void order_facets() {
    const std::size_t facet_count = facet_begin_.size() - 1;
    std::vector<std::uint32_t> rank_begin(hull_.vertices.size() + 1);
    for (std::size_t f = 0; f < facet_count; ++f) ++rank_begin[facet_vertices_[facet_begin_[f]] + 1];
    std::partial_sum(rank_begin.begin(), rank_begin.end(), rank_begin.begin());

    std::vector<std::uint32_t> order(facet_count);
    std::vector<std::uint32_t> rank = rank_begin;
    for (std::uint32_t f = 0; f < facet_count; ++f) order[rank[facet_vertices_[facet_begin_[f]]]++] = f;
    const auto second_lower = [&](std::uint32_t f, std::uint32_t g) {
      return facet_vertices_[facet_begin_[f] + 1] < facet_vertices_[facet_begin_[g] + 1];
    };
    for (std::size_t v = 0; v < hull_.vertices.size(); ++v) {
      std::sort(order.begin() + rank_begin[v], order.begin() + rank_begin[v + 1], second_lower);
    }

    hull_.facet_begin.reserve(facet_begin_.size());
    hull_.facet_vertices.reserve(facet_vertices_.size());
    for (const std::uint32_t f : order) {
      hull_.facet_vertices.insert(hull_.facet_vertices.end(), facet_vertices_.begin() + facet_begin_[f],
                                  facet_vertices_.begin() + facet_begin_[f + 1]);
      hull_.facet_begin.push_back(static_cast<std::uint32_t>(hull_.facet_vertices.size()));
    }
  }

  std::span<const Point3> points_;
  const std::vector<Triangle>& triangles_;
  std::vector<std::uint8_t> marks_;           // of each triangle: which edges are creases, which are outlined
  std::vector<std::uint32_t> crease_count_;   // of each point
  std::vector<std::uint32_t> number_;         // of each extreme point: its vertex number; of others: none
  std::vector<std::uint32_t> facet_begin_{0};     // facets in the order found, as in ConvexHull
  std::vector<std::uint32_t> facet_vertices_;
  std::vector<std::uint32_t> cycle_;          // of the latest vertex or facet, in the order found
  ConvexHull hull_;
};

}  // namespace

ConvexHull merge_coplanar(std::span<const Point3> points, const std::vector<Triangle>& triangles) {
  return Merger(points, triangles).run();
}

}  // namespace sunder::solid
