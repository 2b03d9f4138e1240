#include <sunder/planar/pair/extreme_vertex.h>
#include <sunder/planar/pair/in_world.h>
#include <sunder/planar/pair/polygon_half_plane.h>

namespace sunder::planar {

namespace {

template <class Method>
PolygonHalfPlane ask(const ConvexPolygon& polygon, const Pose& pose, const HalfPlane& half_plane,
                     const Method& furthest_left) {
  return with_placed(polygon, pose, [&](const auto& p) {
    using Vertex = typename std::remove_cvref_t<decltype(p)>::Vertex;
    const Vertex a = in_world<Vertex>(half_plane.a), b = in_world<Vertex>(half_plane.b);
    PolygonHalfPlane answer;
    StageTally tally;
    const std::uint32_t w = furthest_left(p, a, b, answer.cost, tally);
    ++answer.cost.probes;
    const Sign side = cross_2d(a, b, a, p[w], &tally);
    answer.meet = side != Sign::negative;
    answer.touching = side == Sign::zero;
    answer.witness = p.number(w);
    conclude(answer, tally.exact);
    return answer;
  });
}

}  // namespace

PolygonHalfPlane polygon_half_plane(const ConvexPolygon& polygon, const Pose& pose, const HalfPlane& half_plane) {
  return ask(polygon, pose, half_plane, [](const auto& p, const auto& a, const auto& b, Cost& cost, StageTally& tally) {
    return extreme_vertex_by_bisection(p, a, b, cost, tally);
  });
}

PolygonHalfPlane polygon_half_plane_by_scan(const ConvexPolygon& polygon, const Pose& pose,
                                            const HalfPlane& half_plane) {
  return ask(polygon, pose, half_plane, [](const auto& p, const auto& a, const auto& b, Cost& cost, StageTally& tally) {
    return extreme_vertices_by_scan(p, a, b, cost, tally).left;
  });
}

}  // namespace sunder::planar
