#include <sunder/number/interval.h>
#include <sunder/predicate/along.h>
#include <sunder/scene/world_box.h>

namespace sunder::scene {

namespace {

// Encloses coordinate k of the image.
Interval coordinate(std::size_t k, const Posed3& point) {
  const auto& m = point.pose->linear;
  const Point3& p = point.point;
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
    box.lowest[k] = solid::extreme_vertex_from(body, along, solid::End::least, near.lowest[k], cost, tally);
    box.highest[k] = solid::extreme_vertex_from(body, along, solid::End::greatest, near.highest[k], cost, tally);
    box.low[k] = coordinate(k, body[box.lowest[k]]).low;
    box.high[k] = coordinate(k, body[box.highest[k]]).high;
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
