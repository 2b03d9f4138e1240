// Proofs of answers about two meshes, as their checker sees them.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/solid/mesh/mesh_distance.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>
#include <sunder/solid/mesh/mesh_round_claims.h>
#include <sunder/solid/round/round_claims.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace sunder::tests {

// Checks a whole file, and returns the verdicts of its statements, in their order.
inline std::string proved_verdicts(const std::string& text) {
  std::string verdicts;
  const auto result = sunder_verifier::verify_text(text, "certificate", sunder_verifier::Limit::none);
  EXPECT_TRUE(result.accepted()) << result.failed_form << result.error << "\n" << text.substr(0, 3000);
  for (const auto& statement : result.statements) {
    EXPECT_EQ(statement.reason, "");
    verdicts += (verdicts.empty() ? "" : " ") + statement.verdict;
  }
  return verdicts;
}

// Writes it, checks it, and returns the verdict that it states. tells_relation: that they overlap, where that is found.
inline std::string proved_pair(const solid::Mesh& a, const solid::Pose& pose_a, const solid::Mesh& b,
                               const solid::Pose& pose_b, const solid::MeshAnswer& answer,
                               bool tells_relation = false) {
  std::string text;
  AskedPair asked{a, pose_a, b, pose_b};
  asked.tells_relation = tells_relation;
  prove([&](std::string_view piece) { text += piece; }, asked, answer);
  const auto result = sunder_verifier::verify_text(text, "certificate", sunder_verifier::Limit::none);
  EXPECT_EQ(result.statements.size(), 1u) << result.failed_form << result.error;
  EXPECT_TRUE(result.accepted()) << (result.statements.empty() ? "" : result.statements[0].reason) << "\n"
                                 << text.substr(0, 3000);
  EXPECT_TRUE(!result.statements.empty() && (result.statements[0].verdict != "apart") == answer.meet());
  return result.statements.empty() ? "" : result.statements[0].verdict;
}

// The same of how far apart they are, and of whether that is `least`; which are stated as two, in this order.
inline std::string proved_measures(const solid::Mesh& a, const solid::Pose& pose_a, const solid::Mesh& b,
                                   const solid::Pose& pose_b, const solid::MeshDistance& distance, double least) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_origin({});
  solid::MeshClaims meshes(file);
  const std::uint32_t of_a = meshes.add_mesh("A", a), of_b = meshes.add_mesh("B", b);
  const solid::StatedMesh stated_a{meshes.add_placed("placed A", of_a, pose_a), a, pose_a},
      stated_b{meshes.add_placed("placed B", of_b, pose_b), b, pose_b};
  meshes.end_table();
  meshes.add_distance(stated_a, stated_b, distance);
  meshes.add_clearance(stated_a, stated_b, distance, least);
  file.end();
  return proved_verdicts(text);
}

// The same of two that move.
inline std::string proved_motion(const solid::Mesh& a, const solid::Translation& of_a, const solid::Mesh& b,
                                 const solid::Translation& of_b, const solid::MeshMotion& answer) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_origin({});
  solid::add_claims(file, {"A", a, of_a}, {"B", b, of_b}, answer);
  file.end();
  return proved_verdicts(text);
}

// The same of a mesh and a body with a radius: whether they meet, and, where `least` is above 0, whether they are so far
// apart. Requires that both are decided.
inline std::string proved_beside(const solid::Mesh& mesh, const solid::Pose& pose, const solid::PlacedRound& body,
                                 const solid::MeshRoundAnswer& met, double least = 0,
                                 const solid::MeshRoundAnswer& clearance = {}) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_origin({});
  const solid::StatedMesh stated = solid::add_table(file, {"A", mesh, pose});
  PairClaims pairs(file);
  const std::uint32_t index = add_round(pairs, "B", body);
  add_claims(pairs, stated, index, body, met.evidence);
  if (least > 0) add_clearance(pairs, stated, index, body, clearance.evidence, least);
  pairs.end();
  return proved_verdicts(text);
}

}  // namespace sunder::tests
