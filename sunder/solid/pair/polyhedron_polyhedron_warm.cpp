#include <sunder/certificate/direction.h>
#include <sunder/solid/pair/gjk_proposals.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/pair/polyhedron_polyhedron_warm.h>
#include <sunder/solid/pair/stretched.h>
#include <sunder/solid/pair/support.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace sunder::solid {

namespace {

// May the hulls of the vertices still meet? False where their boxes in doubles are apart, as they are after a jump: to
// find that out exactly costs more.
bool may_meet(const WarmStart& last, const Placed& a, const Placed& b) {
  const std::size_t count = std::size_t{last.count_a} + last.count_b;
  std::array<Point3, 2> low, high;
  for (std::size_t i = 0; i < count && i < last.vertices.size(); ++i) {
    const std::size_t of = i < last.count_a ? 0 : 1;
    const Placed& body = of == 0 ? a : b;
    if (last.vertices[i] >= body.graph.vertices.size()) return false;
    const Vector3<double> p = rounded_image(body[last.vertices[i]]);
    const Point3 at{p.x, p.y, p.z};
    const bool is_first = i == 0 || i == last.count_a;
    for (std::size_t k = 0; k < 3; ++k) {
      low[of][k] = is_first ? at[k] : std::min(low[of][k], at[k]);
      high[of][k] = is_first ? at[k] : std::max(high[of][k], at[k]);
    }
  }
  const auto are_apart = [&](std::size_t k) { return low[0][k] > high[1][k] || low[1][k] > high[0][k]; };
  return !(are_apart(0) || are_apart(1) || are_apart(2));
}

// What was there last, again; nothing where doubles tell that it does not hold any more.
std::optional<Proposal> proposed_again(const WarmStart& last, const Placed& a, const Placed& b, Cost& cost) {
  const auto& v = last.vertices;
  if (last.kind == WarmStart::Kind::apart) {
    const Point3& d = last.direction;
    if (v[0] >= a.graph.vertices.size() || v[1] >= b.graph.vertices.size()) return std::nullopt;
    const std::uint32_t of_a = support_near(a.graph, a.pulled(d), v[0], cost.probes),
                        of_b = support_near(b.graph, negated(b.pulled(d)), v[1], cost.probes);
    const Vector3<double> from = rounded_image(a[of_a]), to = rounded_image(b[of_b]);
    if (d.x * (to.x - from.x) + d.y * (to.y - from.y) + d.z * (to.z - from.z) < 0) return std::nullopt;
    return apart_along(d, of_a, of_b);
  }
  if (last.kind == WarmStart::Kind::none || !may_meet(last, a, b)) return std::nullopt;
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
    const std::optional<Proposal> again = proposed_again(last, a, b, cost);
    is_kept = again && holds(*again);
    if (is_kept) return true;
    const auto propose_of = [&](const Placed& p, const Placed& q, const auto& of) {
      GjkSearch<double> search(p, q);
      search.direction = search.first_direction();
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
