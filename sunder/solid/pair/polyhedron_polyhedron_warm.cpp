#include <sunder/certificate/direction.h>
#include <sunder/solid/pair/gjk_proposals.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/pair/polyhedron_polyhedron_warm.h>
#include <sunder/solid/pair/stretched.h>

#include <algorithm>

namespace sunder::solid {

namespace {

Proposal proposal_of(const WarmStart& last) {
  const auto& v = last.vertices;
  if (last.kind == WarmStart::Kind::apart) return apart_along(last.direction, v[0], v[1]);
  Proposal p;
  p.count_a = last.count_a, p.count_b = last.count_b;
  std::copy(v.begin(), v.end(), p.vertices.begin());
  p.near_a = v[0];
  p.near_b = last.count_a < v.size() ? v[last.count_a] : 0;
  return p;
}

// The direction in doubles, or zero where these are too short.
Point3 rounded_direction(const Direction& direction, const Placed& a, const Placed& b) {
  if (direction.kind == Direction::Kind::given) return direction.given;
  const PlacedVertices of_a{a.graph.vertices, a.pose, a.tame}, of_b{b.graph.vertices, b.pose, b.tame};
  const Vector3<Interval> exact = world_direction(direction, of_a, of_b).enclosure();
  Point3 d{exact.x.low, exact.y.low, exact.z.low};
  return make_tame(d) ? d : Point3{};
}

WarmStart left_by(const PairCertificate& c, const Placed& a, const Placed& b) {
  if (c.verdict == Verdict::meet) return {WarmStart::Kind::meet, c.count_a, c.count_b, c.vertices, {}};
  const Point3 d = rounded_direction(c.direction, a, b);
  if (d == Point3{}) return {};
  return {WarmStart::Kind::apart, 0, 0, {c.extreme_a, c.extreme_b}, d};
}

}  // namespace

PairAnswer polyhedron_polyhedron_warm(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                      const ConvexPolyhedron& body_b, const Pose& pose_b, WarmStart& last) {
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  bool is_kept = false;
  PairAnswer answer = answer_by(a, b, [&](const auto& holds, Cost& cost) {
    is_kept = last.kind != WarmStart::Kind::none && holds(proposal_of(last));
    if (is_kept) return true;
    const bool has_direction = last.kind == WarmStart::Kind::apart;
    const auto propose_of = [&](const Placed& p, const Placed& q, const auto& of) {
      GjkSearch<double> search(p, q);
      // Of bodies that are stretched for the search, its directions are others.
      search.direction = has_direction && &p == &a ? last.direction : search.first_direction();
      return propose_by_gjk(p, q, search, of, cost);
    };
    return propose_stretched_where_wanted(a, b, holds, propose_of);
  });
  if (is_kept && !answer.meet()) {
    last.vertices[0] = answer.evidence.extreme_a;
    last.vertices[1] = answer.evidence.extreme_b;
  } else if (!is_kept) {
    last = left_by(answer.evidence, a, b);
  }
  return answer;
}

}  // namespace sunder::solid
