#include <sunder/number/interval.h>
#include <sunder/number/rounded.h>
#include <sunder/predicate/along.h>
#include <sunder/scene/world_box.h>
#include <sunder/solid/pair/support.h>

#include <utility>

namespace sunder::scene {

namespace {

// Encloses coordinate k of the image.
Interval coordinate(std::size_t k, const Posed3& point) {
  const auto& m = point.pose->linear;
  const Point3& p = point.point;
  if (point.tame) {
    const auto at = (leaf(m[3 * k]) * leaf(p.x) + leaf(m[3 * k + 1]) * leaf(p.y)) +
                    (leaf(m[3 * k + 2]) * leaf(p.z) + leaf(point.pose->translation[k]));
    // The value is not greater than the magnitude; so two units more pay for the rounding of its sum with the error.
    const double error = (decltype(at)::bound + 0x1p-52) * at.magnitude;
    return {at.value - error, at.value + error};
  }
  return (Interval(m[3 * k]) * p.x + Interval(m[3 * k + 1]) * p.y) +
         (Interval(m[3 * k + 2]) * p.z + Interval(point.pose->translation[k]));
}

Point3 axis(std::size_t k) { return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0}; }

}  // namespace

WorldBox world_box(const solid::Placed& body) { return world_box(body, {}); }

WorldBox world_box(const solid::Placed& body, const WorldBox& near) {
  WorldBox box;
  Cost cost;
  StageTally tally;
  for (std::size_t k = 0; k < 3; ++k) {
    const WorldDirection direction(axis(k));
    Along along(direction, body.pose, body.tame);
    const double* const row = &body.pose.linear[3 * k];
    const std::uint32_t low = solid::support_near(body.graph, {-row[0], -row[1], -row[2]}, near.lowest[k], cost.probes);
    const std::uint32_t high = solid::support_near(body.graph, {row[0], row[1], row[2]}, near.highest[k], cost.probes);
    box.lowest[k] = solid::extreme_vertex_from(body, along, solid::End::least, low, cost, tally);
    box.highest[k] = solid::extreme_vertex_from(body, along, solid::End::greatest, high, cost, tally);
    box.low[k] = coordinate(k, body[box.lowest[k]]).low;
    box.high[k] = coordinate(k, body[box.highest[k]]).high;
  }
  return box;
}

Box3 rough_world_box(const solid::Placed& body) {
  Box3 box;
  for (std::size_t k = 0; k < 3; ++k) {
    // Along an axis of the world a corner is furthest that each axis of the body alone takes furthest.
    const Point3 &low = body.graph.low, &high = body.graph.high;
    Point3 least = low, greatest = high;
    for (std::size_t j = 0; j < 3; ++j) {
      if (body.pose.linear[3 * k + j] < 0) std::swap(least[j], greatest[j]);
    }
    box.low[k] = coordinate(k, {least, &body.pose, body.tame}).low;
    box.high[k] = coordinate(k, {greatest, &body.pose, body.tame}).high;
  }
  return box;
}

std::optional<PairCertificate> apart_by_boxes(const WorldBox& a, const WorldBox& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const bool up = a.high[k] < b.low[k];
    if (!up && !(b.high[k] < a.low[k])) continue;
    const Point3 d = axis(k);
    PairCertificate certificate;
    certificate.verdict = Verdict::apart;
    certificate.direction.given = up ? d : Point3{0 - d.x, 0 - d.y, 0 - d.z};
    certificate.extreme_a = up ? a.highest[k] : a.lowest[k];
    certificate.extreme_b = up ? b.lowest[k] : b.highest[k];
    return certificate;
  }
  return std::nullopt;
}

}  // namespace sunder::scene
