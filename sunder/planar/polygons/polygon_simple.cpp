#include <sunder/base/prefetch.h>
#include <sunder/near/near_pairs.h>
#include <sunder/planar/polygons/polygon_simple.h>
#include <sunder/planar/segments/segment_boxes.h>
#include <sunder/planar/segments/segments_any.h>
#include <sunder/planar/sweep/ends_in_order.h>

#include <algorithm>
#include <array>

namespace sunder::planar {

namespace {

// Two vertices u < v that are equal. Of the edges at one and the other some two
// have a contact that counts: where the vertices do not follow each other, any two that do not; where they do, the edge
// between them has length zero, and those around it share its point, or are one edge (a ring of three), whose two
// directions overlap, or have length zero too.
void report_equal_vertices(const Polygon& polygon, std::uint32_t u, std::uint32_t v, PolygonSimpleAnswer& answer) {
  for (const std::uint32_t i : {u, polygon.previous(u)}) {
    for (const std::uint32_t j : {v, polygon.previous(v)}) {
      if (i == j) continue;
      const ContactKind kind = counted_contact(polygon, i, j);
      if (kind != ContactKind::none) return void(answer.found = contact_of(i, j, kind));
    }
  }
}

Segments edges_of(const Polygon& polygon) {
  std::vector<Segment> edges;
  edges.reserve(polygon.size());
  for (std::uint32_t k = 0; k < polygon.size(); ++k) edges.push_back(polygon.edge(k));
  return Segments(std::move(edges));
}

// A vertex is the end of two edges. Where three ends come together, two vertices are equal.
PolygonSimpleAnswer by_sweep(const Polygon& polygon, const Segments& edges, std::vector<std::uint32_t>& ends) {
  PolygonSimpleAnswer answer;
  const std::vector<Point2>& p = polygon.vertices();
  const auto vertex_at = [&](std::uint32_t end) {
    const std::uint32_t k = end / 2;
    const bool is_point = edges[k].a == edges[k].b;
    return (is_point ? end % 2 == 0 : end_point(edges.all(), end) == p[k]) ? k : polygon.next(k);
  };
  ends = ends_in_order(edges.all());
  constexpr std::size_t ahead = 16;
  for (std::size_t k = 2; k < ends.size(); ++k) {
    if (k + ahead < ends.size()) prefetch(edges[ends[k + ahead] / 2]);
    ++answer.cost.probes;
    if (end_point(edges.all(), ends[k - 2]) != end_point(edges.all(), ends[k])) continue;
    std::array vertices{vertex_at(ends[k - 2]), vertex_at(ends[k - 1]), vertex_at(ends[k])};
    std::sort(vertices.begin(), vertices.end());
    report_equal_vertices(polygon, vertices[0], vertices[2], answer);
    return answer;
  }
  const SegmentsAnswer contact = segments_any_by_sweep_over(edges, ends, {Allowed::shared_endpoint});
  answer.cost.probes += contact.cost.probes;
  answer.found = contact.found;
  return answer;
}

}  // namespace

ContactKind counted_contact(const Polygon& polygon, std::uint32_t i, std::uint32_t j) {
  const ContactKind kind = segment_segment(sorted(polygon.edge(i)), sorted(polygon.edge(j)));
  const bool follow = polygon.next(i) == j || polygon.next(j) == i;
  const auto is_point = [&](std::uint32_t k) { return polygon.edge(k).a == polygon.edge(k).b; };
  const bool both_points = is_point(i) && is_point(j);  // three equal vertices in turn
  return follow && kind == ContactKind::shared_endpoint && !both_points ? ContactKind::none : kind;
}

PolygonSimpleAnswer polygon_simple(const Polygon& polygon) { return polygon_simple_by_grid(polygon); }

PolygonSimpleAnswer polygon_simple_by_grid(const Polygon& polygon) {
  std::vector<std::uint32_t> ends;
  return polygon_simple(polygon, edges_of(polygon), ends);
}

PolygonSimpleAnswer polygon_simple(const Polygon& polygon, const Segments& edges, std::vector<std::uint32_t>& ends) {
  const std::optional<BoxGrid> grid = grid_over(edges);
  if (!grid || crowded(*grid, crowd_for_any) > 0) return by_sweep(polygon, edges, ends);
  PolygonSimpleAnswer answer;
  const auto of_pair = [&](std::uint32_t i, std::uint32_t j) {
    ++answer.cost.probes;
    const ContactKind kind = counted_contact(polygon, i, j);
    if (kind != ContactKind::none) answer.found = contact_of(i, j, kind);
    return !answer.meet();
  };
  for_each_near_pair<crowd_for_any>(edges.all(), *grid, of_pair);
  return answer;
}

PolygonSimpleAnswer polygon_simple_by_sweep(const Polygon& polygon) {
  std::vector<std::uint32_t> ends;
  return by_sweep(polygon, edges_of(polygon), ends);
}

PolygonSimpleAnswer polygon_simple_by_scan(const Polygon& polygon) {
  PolygonSimpleAnswer answer;
  for (std::uint32_t i = 0; i < polygon.size(); ++i) {
    for (std::uint32_t j = i + 1; j < polygon.size(); ++j) {
      ++answer.cost.probes;
      const ContactKind kind = counted_contact(polygon, i, j);
      if (kind == ContactKind::none) continue;
      answer.found = contact_of(i, j, kind);
      return answer;
    }
  }
  return answer;
}

}  // namespace sunder::planar
