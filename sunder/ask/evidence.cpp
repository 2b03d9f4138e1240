#include <sunder/ask/evidence.h>

#include <sunder/certificate/rounded_evidence.h>

#include <cstdint>
#include <vector>

namespace sunder::ask {

PlacedVertices placed_vertices(const solid::ConvexPolyhedron& shape, const solid::Pose& pose) {
  return {shape.vertices(), pose.affine(), false};
}

Json evidence_json(const PairCertificate& c, const PlacedVertices& a, const PlacedVertices& b) {
  if (c.verdict == Verdict::meet) {
    const auto begin = c.vertices.begin(), middle = begin + c.count_a;
    return {{"point", to_json(rounded_common_point(c, a, b))},
            {"vertices_a", std::vector<std::uint32_t>(begin, middle)},
            {"vertices_b", std::vector<std::uint32_t>(middle, middle + c.count_b)}};
  }
  const RoundedGap gap = rounded_gap(c, a, b);
  return {{"direction_about", to_json(gap.direction)},
          {"gap_about", gap.width},
          {"extreme_a", c.extreme_a},
          {"extreme_b", c.extreme_b}};
}

Json evidence_json(const solid::RoundEvidence& evidence, const solid::PlacedRound& a, const solid::PlacedRound& b) {
  if (evidence.verdict == Verdict::meet) return {{"point", to_json(rounded_point_of(a, b, evidence))}};
  if (evidence.verdict == Verdict::undecided) {
    return {{"direction_about", to_json(rounded_direction(evidence))}};
  }
  const RoundedGap gap = rounded_gap(evidence, a, b);
  return {{"direction_about", to_json(gap.direction)}, {"gap_about", gap.width}};
}

std::string_view shape_name(const solid::RoundBody& body) {
  switch (body.kind()) {
    case RoundKind::cylinder: return "cylinder";
    case RoundKind::cone: return "cone";
    case RoundKind::ellipsoid: return "ellipsoid";
    case RoundKind::hull: break;
  }
  const std::size_t points = body.points().size();
  return points == 1 ? "ball" : points == 2 ? "capsule" : "rounded hull";
}

}  // namespace sunder::ask
