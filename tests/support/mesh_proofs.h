// The proof of an answer about two meshes, as its checker sees it.
#pragma once

#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace sunder::tests {

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

}  // namespace sunder::tests
