#include <sunder/planar/pair/minkowski_difference_search.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_boundary.h>

namespace sunder::planar {

namespace {

// Is p strictly to the left of all edges of q? The vertex of p that is furthest to the right of an edge goes once
// around p, counter-clockwise, as the edge goes once around q.
template <class P, class Q>
bool is_inside(const P& p, const Q& q, Cost& cost, StageTally& tally) {
  const std::uint32_t n = p.size(), m = q.size();
  if (m < 3) return false;
  std::uint32_t i = position(p, edges_to_left(p, q[0], q[1], cost, tally).begin);
  for (std::uint32_t j = 0; j < m; ++j) {
    const auto from = q[j];
    const auto to = vertex_at(q, j + 1);
    for (std::uint32_t turned = 0; n > 1 && turned < n; ++turned) {
      ++cost.probes;
      if (cross_2d(from, to, p[i], vertex_at(p, i + 1), &tally) != Sign::negative) break;
      i = position(p, i + 1);
    }
    ++cost.probes;
    if (cross_2d(from, to, from, p[i], &tally) != Sign::positive) return false;
  }
  return true;
}

RelationAnswer answer_of(bool meet, bool a_inside, bool b_inside, Cost cost, const StageTally& tally) {
  cost.exact += tally.exact;
  return {relation_of_boundaries(meet, a_inside, b_inside), cost};
}

}  // namespace

RelationAnswer polygon_polygon_boundary(const ConvexPolygon& a, const Pose& pose_a,  //
                                        const ConvexPolygon& b, const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b, [](const auto& in_a, const auto& in_b) {
    PairCertificate certificate;
    Cost cost;
    StageTally tally;
    const bool meet = search_difference(in_a, 0, in_b, 0, certificate, cost, tally).meet;
    const bool a_inside = meet && is_inside(in_a, in_b, cost, tally);
    const bool b_inside = meet && !a_inside && is_inside(in_b, in_a, cost, tally);
    return answer_of(meet, a_inside, b_inside, cost, tally);
  });
}

RelationAnswer polygon_polygon_boundary_by_scan(const ConvexPolygon& a, const Pose& pose_a,  //
                                                const ConvexPolygon& b, const Pose& pose_b) {
  Cost cost;
  StageTally tally;
  const PosedPolygon in_a(a, pose_a), in_b(b, pose_b);
  const auto inside = [&](const PosedPolygon& p, const PosedPolygon& q) {
    if (q.size() < 3) return false;
    for (std::uint32_t i = 0; i < p.size(); ++i) {
      for (std::uint32_t j = 0; j < q.size(); ++j) {
        ++cost.probes;
        if (cross_2d(q[j], q[(j + 1) % q.size()], q[j], p[i], &tally) != Sign::positive) return false;
      }
    }
    return true;
  };
  const bool meet = polygon_polygon_by_scan(a, pose_a, b, pose_b).meet();
  return answer_of(meet, inside(in_a, in_b), inside(in_b, in_a), cost, tally);
}

}  // namespace sunder::planar
