#include <sunder/certificate/direction.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/pair/polyhedron_polyhedron_warm.h>
#include <sunder/solid/search/axis_scaled.h>
#include <sunder/solid/search/gjk_proposals.h>
#include <sunder/solid/search/support.h>

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

// The direction of the world that A's frame sees as `d` (Placed::pulled), as far as its length does not matter: by the
// cofactors of the linear part, turned where it reflects. Zero where these are too short or long.
Point3 pushed(const Affine3& pose, const Point3& d) {
  const auto& m = pose.linear;
  const Point3 x{m[0], m[1], m[2]}, y{m[3], m[4], m[5]}, z{m[6], m[7], m[8]};
  const Point3 yz = cross(y, z);
  Point3 of_world{dot(yz, d), dot(cross(z, x), d), dot(cross(x, y), d)};
  if (dot(x, yz) < 0) of_world = negated(of_world);
  return make_tame(of_world) ? of_world : Point3{};
}

// From the vertex of A to that of B along the direction, rounded.
double gap_along(const Point3& d, const Placed& a, std::uint32_t of_a, const Placed& b, std::uint32_t of_b) {
  const Vector3<double> from = rounded_image(a[of_a]), to = rounded_image(b[of_b]);
  return d.x * (to.x - from.x) + d.y * (to.y - from.y) + d.z * (to.z - from.z);
}

// The vertices that had a common point, again; nothing where doubles tell that it does not hold any more.
std::optional<Proposal> meet_again(const WarmStart& last, const Placed& a, const Placed& b) {
  if (!may_meet(last, a, b)) return std::nullopt;
  const auto& v = last.vertices;
  Proposal p;
  p.count_a = last.count_a, p.count_b = last.count_b;
  std::copy(v.begin(), v.end(), p.vertices.begin());
  p.near_a = v[0];
  p.near_b = last.count_a < v.size() ? v[last.count_a] : 0;
  return p;
}

// A direction that parted the bodies, again; likewise.
std::optional<Proposal> parted_again(const WarmStart::Parting& last, const Placed& a, const Placed& b, Cost& cost) {
  const std::uint32_t near_a = last.extreme_a, near_b = last.extreme_b;
  if (near_a >= a.graph.vertices.size() || near_b >= b.graph.vertices.size()) return std::nullopt;
  const Point3 d = pushed(a.pose, last.direction);
  if (!(gap_along(d, a, near_a, b, near_b) > 0)) return std::nullopt;  // other vertices only come nearer
  // A's vertex stays the extreme one, as the direction turns with A; the check looks at it.
  const std::uint32_t of_b = support_near(b.graph, negated(b.pulled(d)), near_b, cost.probes);
  if (of_b != near_b && !(gap_along(d, a, near_a, b, of_b) > 0)) return std::nullopt;
  return apart_along(d, near_a, of_b);
}

// Proposes what is kept; true where that holds, and then what held is the first to be looked at next time.
bool propose_again(WarmStart& last, const Placed& a, const Placed& b, const Holds& holds, Cost& cost) {
  if (last.kind == WarmStart::Kind::meet) {
    const std::optional<Proposal> again = meet_again(last, a, b);
    if (again && holds(*again)) return true;
  }
  const std::size_t count = std::min<std::size_t>(last.partings_count, last.partings.size());
  for (std::size_t k = 0; k < count; ++k) {
    const std::optional<Proposal> again = parted_again(last.partings[k], a, b, cost);
    if (!again || !holds(*again)) continue;
    const auto first = last.partings.begin();
    std::rotate(first, first + static_cast<std::ptrdiff_t>(k), first + static_cast<std::ptrdiff_t>(k) + 1);
    return true;
  }
  return false;
}

// The direction in doubles, or zero where these are too short.
Point3 rounded_direction(const Direction& direction, const Placed& a, const Placed& b) {
  if (direction.kind == Direction::Kind::given) return direction.given;
  const PlacedVertices of_a{a.graph.vertices, a.pose, a.tame}, of_b{b.graph.vertices, b.pose, b.tame};
  const Vector3<Interval> exact = world_direction(direction, of_a, of_b).enclosure();
  return {exact.x.low, exact.y.low, exact.z.low};
}

// Keeps what a search has found.
void keep(const PairCertificate& c, const Placed& a, const Placed& b, WarmStart& last) {
  if (const auto* common = std::get_if<CommonVertices>(&c)) {
    last.kind = WarmStart::Kind::meet;
    last.count_a = common->count_a, last.count_b = common->count_b;
    last.vertices = common->vertices;
    return;
  }
  const auto& [direction, extreme_a, extreme_b] = std::get<Separation>(c);
  last.kind = WarmStart::Kind::apart;
  Point3 d = a.pulled(rounded_direction(direction, a, b));
  if (!make_tame(d)) return;
  const auto first = last.partings.begin();
  std::copy_backward(first, last.partings.end() - 1, last.partings.end());
  *first = {d, extreme_a, extreme_b};
  if (last.partings_count < last.partings.size()) ++last.partings_count;
}

}  // namespace

PairAnswer polyhedron_polyhedron_warm(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                      const ConvexPolyhedron& body_b, const Pose& pose_b, WarmStart& last) {
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  bool is_kept = false;
  PairAnswer answer = answer_by(a, b, [&](const Holds& holds, Cost& cost) {
    is_kept = propose_again(last, a, b, holds, cost);
    if (is_kept) return true;
    const auto propose_of = [&](const Placed& p, const Placed& q, const Holds& of) {
      return propose_by_gjk(p, q, of, cost);
    };
    return propose_axis_scaled_where_wanted(a, b, holds, propose_of);
  });
  if (!is_kept) {
    keep(answer.evidence, a, b, last);
  } else if (const auto* apart = std::get_if<Separation>(&answer.evidence)) {
    last.kind = WarmStart::Kind::apart;
    last.partings[0].extreme_a = apart->extreme_a;
    last.partings[0].extreme_b = apart->extreme_b;
  }
  return answer;
}

}  // namespace sunder::solid
