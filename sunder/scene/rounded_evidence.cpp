#include <sunder/base/contract.h>
#include <sunder/certificate/common_point.h>
#include <sunder/scene/rounded_evidence.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace sunder::scene {

Point3 rounded_common_point(const PairCertificate& c, const PlacedVertices& a, const PlacedVertices& b) {
  return nearest(common_point(c, a, b).at);
}

RoundedGap rounded_gap(const PairCertificate& c, const PlacedVertices& a, const PlacedVertices& b) {
  SUNDER_REQUIRE(c.verdict == Verdict::apart);
  const Vector3<Dyadic> d = world_direction(c.direction, a, b).exact();
  Dyadic longest;  // the largest magnitude of an entry
  for (const Dyadic* entry : {&d.x, &d.y, &d.z}) {
    const Dyadic size = entry->sign() == Sign::negative ? -*entry : *entry;
    if ((size - longest).sign() == Sign::positive) longest = size;
  }
  const Point3 near{nearest_ratio(d.x, longest), nearest_ratio(d.y, longest), nearest_ratio(d.z, longest)};
  const double length = std::sqrt(near.x * near.x + near.y * near.y + near.z * near.z);
  const Vector3<Dyadic> between = lift<ExactStage>(b[c.extreme_b]) - lift<ExactStage>(a[c.extreme_a]);
  return {{near.x / length, near.y / length, near.z / length},
          nearest_ratio(dot(d, between), longest * Dyadic(length))};
}

Point3 rounded_common_point(const PartPair& pair, const Part& a, const Part& b) {
  SUNDER_REQUIRE(pair.meet());
  if (pair.round) {
    return rounded_point_of(solid::PlacedRound(a.shape, a.pose), solid::PlacedRound(b.shape, b.pose), *pair.round);
  }
  return rounded_common_point(pair.answer.certificate(), {a.shape.points(), a.pose.affine(), false},
                              {b.shape.points(), b.pose.affine(), false});
}

Point3 rounded_direction(const solid::RoundEvidence& evidence) {
  SUNDER_REQUIRE(evidence.verdict != Verdict::meet);
  const Point3& d = evidence.direction;
  const double largest = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  const Point3 e{d.x / largest, d.y / largest, d.z / largest};
  const double length = std::sqrt(e.x * e.x + e.y * e.y + e.z * e.z);
  return {e.x / length + 0.0, e.y / length + 0.0, e.z / length + 0.0};
}

RoundedGap rounded_gap(const solid::RoundEvidence& evidence, const solid::PlacedRound& a, const solid::PlacedRound& b) {
  SUNDER_REQUIRE(evidence.verdict == Verdict::apart);
  return {rounded_direction(evidence), gap_about(a, b, evidence)};
}

}  // namespace sunder::scene
