#include <sunder/ask/evidence.h>

#include <sunder/certificate/rounded_evidence.h>
#include <sunder/solid/mesh/mesh_cover.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>
#include <sunder/solid/mesh/mesh_round_claims.h>

#include <cstdint>
#include <string>
#include <vector>

namespace sunder::ask {

namespace {

Json json_of(const Separation& c, const PlacedVertices& a, const PlacedVertices& b) {
  const RoundedGap gap = rounded_gap(c, a, b);
  return {{"direction_about", to_json(gap.direction)},
          {"gap_about", gap.width},
          {"extreme_a", c.extreme_a},
          {"extreme_b", c.extreme_b}};
}

Json json_of(const CommonVertices& c, const PlacedVertices& a, const PlacedVertices& b) {
  const auto begin = c.vertices.begin(), middle = begin + c.count_a;
  return {{"point", to_json(rounded_common_point(c, a, b))},
          {"vertices_a", std::vector<std::uint32_t>(begin, middle)},
          {"vertices_b", std::vector<std::uint32_t>(middle, middle + c.count_b)}};
}

}  // namespace

Json evidence_json(const PairCertificate& certificate, const PlacedVertices& a, const PlacedVertices& b) {
  return std::visit([&](const auto& held) { return json_of(held, a, b); }, certificate);
}

Json evidence_json(const solid::RoundEvidence& evidence, const solid::PlacedRound& a, const solid::PlacedRound& b) {
  const PlacedVertices in_a{a.body.core().vertices(), a.pose.affine(), false},
      in_b{b.body.core().vertices(), b.pose.affine(), false};
  if (const auto* apart = std::get_if<Separation>(&evidence)) return json_of(*apart, in_a, in_b);
  if (const auto* common = std::get_if<CommonVertices>(&evidence)) return json_of(*common, in_a, in_b);
  const Verdict verdict = verdict_of(evidence);
  if (verdict == Verdict::meet) return {{"point", to_json(rounded_point_of(a, b, evidence))}};
  if (verdict == Verdict::undecided) return {{"direction_about", to_json(rounded_direction(a, b, evidence))}};
  const RoundedGap gap = rounded_gap(a, b, evidence);
  return {{"direction_about", to_json(gap.direction)}, {"gap_about", gap.width}};
}

Json evidence_json(const solid::MeshEvidence& evidence, const solid::Mesh& a, const solid::Pose& pose_a,
                   const solid::Mesh& b, const solid::Pose& pose_b) {
  if (verdict_of(evidence) == Verdict::apart) {
    const solid::MeshCover cover = mesh_cover(a, pose_a, b, pose_b);
    return {{"planes", cover.directions.size()}, {"rays", cover.rays_a.size() + cover.rays_b.size()}};
  }
  const Json point = to_json(rounded_point_of(a, pose_a, b, pose_b, evidence));
  if (const auto* meeting = std::get_if<solid::MeetingTriangles>(&evidence)) {
    return {{"point", point}, {"face_a", a.face_of(meeting->of_a)}, {"face_b", b.face_of(meeting->of_b)}};
  }
  return {{"corner", point}, {"within", std::get<solid::PointWithin>(evidence).is_of_a ? "B" : "A"}};
}

Json evidence_json(const solid::MeshRoundEvidence& evidence, const solid::Mesh& mesh, const solid::Pose& pose,
                   const solid::PlacedRound& round, bool is_mesh_a) {
  if (const auto* near = std::get_if<solid::RoundNearTriangle>(&evidence)) {
    const solid::RoundBody triangle = body_of_triangle(mesh, near->triangle);
    const solid::PlacedRound placed(triangle, pose);
    const solid::PlacedRound &a = is_mesh_a ? placed : round, &b = is_mesh_a ? round : placed;
    return {{"direction_about", to_json(rounded_direction(a, b, round_round(a, b).evidence))}};
  }
  if (verdict_of(evidence) == Verdict::apart) {
    const solid::PartsBeside parts = parts_beside(mesh, pose, round);
    return {{"planes", parts.ends.size()}, {"rays", parts.away.size()}};
  }
  const Json point = to_json(rounded_point_of(mesh, pose, round, evidence));
  if (const auto* meeting = std::get_if<solid::RoundOnTriangle>(&evidence)) {
    return {{"point", point}, {"face", mesh.face_of(meeting->triangle)}};
  }
  return {{"point", point}, {"within", is_mesh_a ? "A" : "B"}};
}

void add_numbers(const solid::RoundWords& words, Json& json) {
  json["points"] = Json::array();
  for (const Point3& p : words.points) json["points"].push_back(to_json(p));
  const std::string name(words.sizes_name);
  if (words.sizes.size() == 1) {
    json[name] = words.sizes[0];
  } else {
    json[name] = words.sizes;
  }
}

}  // namespace sunder::ask
