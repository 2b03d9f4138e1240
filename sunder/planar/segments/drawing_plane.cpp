// First no two vertices may have one place. Then edges that share an end share a vertex, and the rest is the question
// of segments with shared ends allowed. Vertices without edges are segments of length zero: where one lies on an edge's
// inside, that is a touch; on its end it cannot lie.
#include <sunder/base/error.h>
#include <sunder/planar/segments/drawing_plane.h>
#include <sunder/planar/segments/segments_any.h>
#include <sunder/planar/sweep/ends_in_order.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace sunder::planar {

namespace {

using Of = DrawingContact::Of;

void check(std::span<const Point2> vertices, std::span<const DrawingEdge> edges) {
  constexpr std::size_t most = std::size_t{1} << 30;
  if (vertices.size() >= most || edges.size() >= most) {
    throw Error(ErrorCode::bad_shape, "there are 2^30 vertices or edges, or more; split the drawing");
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (std::isfinite(vertices[i].x) && std::isfinite(vertices[i].y)) continue;
    throw Error(ErrorCode::bad_value, "coordinates are finite numbers", "vertex " + std::to_string(i));
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [u, v] = edges[i];
    if (u < vertices.size() && v < vertices.size() && u != v) continue;
    throw Error(ErrorCode::bad_shape, "an edge names two different vertices of the drawing",
                "edge " + std::to_string(i));
  }
}

bool report(DrawingAnswer& answer, Of of, ContactKind kind, std::uint32_t i, std::uint32_t j) {
  const bool is_mixed = of == Of::vertex_and_edge;
  answer.found = {of, is_mixed ? i : std::min(i, j), is_mixed ? j : std::max(i, j), kind};
  return true;
}

}  // namespace

DrawingAnswer drawing_plane(std::span<const Point2> vertices, std::span<const DrawingEdge> edges) {
  check(vertices, edges);
  DrawingAnswer answer;
  std::vector<Segment> points;
  points.reserve(vertices.size());
  for (const Point2& p : vertices) points.push_back({p, p});
  const std::vector<std::uint32_t> ends = ends_in_order(points);  // each point's two follow each other
  for (std::size_t k = 2; k < ends.size(); k += 2) {
    ++answer.cost.probes;
    const std::uint32_t u = ends[k - 2] / 2, v = ends[k] / 2;
    if (vertices[u] == vertices[v]) return report(answer, Of::vertices, ContactKind::none, u, v), answer;
  }
  std::vector<Segment> segments;
  std::vector<bool> has_edge(vertices.size());
  for (const auto& [u, v] : edges) {
    segments.push_back(sorted({vertices[u], vertices[v]}));
    has_edge[u] = has_edge[v] = true;
  }
  std::vector<std::uint32_t> alone;
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    if (has_edge[v]) continue;
    alone.push_back(v);
    segments.push_back(points[v]);
  }
  const SegmentsAnswer found = segments_any(Segments(std::move(segments)), {Allowed::shared_endpoint});
  answer.cost.probes += found.cost.probes;
  if (!found.meet()) return answer;
  const auto [i, j, kind] = *found.found;
  const std::uint32_t edge_count = static_cast<std::uint32_t>(edges.size());
  if (j < edge_count) {
    report(answer, Of::edges, kind, i, j);
  } else {
    report(answer, Of::vertex_and_edge, kind, alone[j - edge_count], i);
  }
  return answer;
}

DrawingAnswer drawing_plane_by_scan(std::span<const Point2> vertices, std::span<const DrawingEdge> edges) {
  check(vertices, edges);
  DrawingAnswer answer;
  const auto segment = [&](std::uint32_t e) { return sorted({vertices[edges[e][0]], vertices[edges[e][1]]}); };
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    for (std::uint32_t u = 0; u < v; ++u) {
      ++answer.cost.probes;
      if (vertices[u] == vertices[v]) return report(answer, Of::vertices, ContactKind::none, u, v), answer;
    }
  }
  for (std::uint32_t f = 0; f < edges.size(); ++f) {
    for (std::uint32_t e = 0; e < f; ++e) {
      ++answer.cost.probes;
      const ContactKind kind = segment_segment(segment(e), segment(f));
      if (!counts(kind, Allowed::shared_endpoint)) continue;  // vertices differ: a shared end is a common vertex
      return report(answer, Of::edges, kind, e, f), answer;
    }
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
      if (v == edges[f][0] || v == edges[f][1]) continue;
      const bool alone =
          std::none_of(edges.begin(), edges.end(), [v](const auto& e) { return e[0] == v || e[1] == v; });
      if (!alone) continue;
      ++answer.cost.probes;
      const ContactKind kind = segment_segment(segment(f), {vertices[v], vertices[v]});
      if (kind != ContactKind::none) return report(answer, Of::vertex_and_edge, kind, v, f), answer;
    }
  }
  return answer;
}

}  // namespace sunder::planar
