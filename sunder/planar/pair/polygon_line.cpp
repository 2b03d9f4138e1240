#include <sunder/planar/pair/cut_by_scan.h>
#include <sunder/planar/pair/extreme_vertex.h>
#include <sunder/planar/pair/line_search.h>
#include <sunder/planar/pair/polygon_line.h>

namespace sunder::planar {

namespace {

template <class FurthestLeft>
PolygonCut cut(const ConvexPolygon& polygon, const Pose& pose, const Line& line, const FurthestLeft& furthest_left) {
  return with_placed(polygon, pose, [&](const auto& p) {
    using Vertex = typename std::remove_cvref_t<decltype(p)>::Vertex;
    return conclude_cut(p, [&](Cost& cost, StageTally& tally) {
      const auto extreme = [&](const Vertex& from, const Vertex& to, Cost& c, StageTally& t) {
        return furthest_left(p, from, to, c, t);
      };
      return cut_by_line(p, in_world<Vertex>(line.a), in_world<Vertex>(line.b), extreme, cost, tally);
    });
  });
}

}  // namespace

PolygonCut polygon_line(const ConvexPolygon& polygon, const Pose& pose, const Line& line) {
  return cut(polygon, pose, line, [](const auto& p, const auto& from, const auto& to, Cost& cost, StageTally& tally) {
    return extreme_vertex_by_bisection(p, from, to, cost, tally);
  });
}

PolygonCut polygon_line_by_fibonacci(const ConvexPolygon& polygon, const Pose& pose, const Line& line) {
  return cut(polygon, pose, line, [](const auto& p, const auto& from, const auto& to, Cost& cost, StageTally& tally) {
    return extreme_vertices_by_fibonacci(p, from, to, cost, tally).left;
  });
}

PolygonCut polygon_line_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Line& line) {
  return cut_by_scan(polygon, pose, line.a, line.b, {});
}

}  // namespace sunder::planar
