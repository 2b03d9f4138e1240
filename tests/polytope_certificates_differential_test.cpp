// Certificates of polytopes of any dimension, written by the library and checked without it: points and half-spaces,
// apart and meeting; and untrue ones, which are refused by the rule that must.
#include <tests/support/polytope_pairs.h>
#include <tests/support/scale.h>

#include <sunder/polytope/pair/polytope_claims.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>

namespace sunder::tests {
namespace {

using polytope::PolytopeAnswer;

std::string written(const PolytopePair& c, const PolytopeAnswer& answer) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  add_claims(file, {"a", c.a, c.pose_a}, {"b", c.b, c.pose_b}, answer);
  file.end();
  return text;
}

// The text with the first of some words exchanged for another; empty where there is none.
std::string exchanged(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.rfind(from);
  return at == std::string::npos ? "" : text.replace(at, from.size(), to);
}

// Mutations of a true file that are untrue, or no certificate.
std::map<std::string, std::string> mutants(const std::string& text) {
  std::map<std::string, std::string> result;
  const auto add = [&](const char* name, std::string mutant) {
    if (!mutant.empty()) result[name] = std::move(mutant);
  };
  add("a is b", exchanged(text, "\"a\": 0", "\"a\": 99"));
  add("another verdict", exchanged(text, "\"verdict\": \"apart\"", "\"verdict\": \"meet\""));
  add("another verdict, too", exchanged(text, "\"verdict\": \"meet\"", "\"verdict\": \"apart\""));
  add("another question", exchanged(text, "\"question\": \"pair\"", "\"question\": \"polytopes\""));
  return result;
}

struct Counts {
  int meet = 0, apart = 0, refused = 0;
};

void expect_accepted(const PolytopePair& c, Counts& counts) {
  const PolytopeAnswer answer = polytope_polytope(c.a, c.pose_a, c.b, c.pose_b);
  const std::string text = written(c, answer);
  const sunder_verifier::FileResult report = sunder_verifier::verify_text(text, "pair");
  ASSERT_EQ(report.statements.size(), 1u) << report.failed_form << text;
  ASSERT_TRUE(report.accepted()) << report.statements[0].reason << text;
  ASSERT_NE(report.statements[0].sentence.find(answer.meet() ? "meet at" : "are apart"), std::string::npos);
  ++(answer.meet() ? counts.meet : counts.apart);
  for (const auto& [name, mutant] : mutants(text)) {
    const sunder_verifier::FileResult refused = sunder_verifier::verify_text(mutant, name);
    EXPECT_TRUE(refused.readable && !refused.accepted()) << name << "\n" << mutant;
    ++counts.refused;
  }
}

TEST(PolytopeCertificatesDifferential, OfPoints) {
  const int count = scaled_count(3000, 200);
  PolytopePairs pairs(chosen_seed(20261130));
  Counts counts;
  for (int i = 0; i < count; ++i) {
    expect_accepted(pairs.next(), counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.meet, count / 10);
  EXPECT_GT(counts.apart, count / 10);
  EXPECT_GE(counts.refused, 2 * count);
}

TEST(PolytopeCertificatesDifferential, OfHalfSpaces) {
  const int count = scaled_count(3000, 200);
  PolytopePairs pairs(chosen_seed(20261131));
  Counts counts;
  for (int i = 0; i < count; ++i) {
    expect_accepted(pairs.next_of_half_spaces(), counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.meet, count / 10);
  EXPECT_GT(counts.apart, count / 10);
}

}  // namespace
}  // namespace sunder::tests
