// Certificates of polytopes of any dimension, written by the library and checked without it: points and half-spaces,
// apart and meeting; and untrue ones, which are refused by the rule that must.
#include <tests/support/polytope_pairs.h>
#include <tests/support/scale.h>

#include <sunder/polytope/pair/hyperplanes.h>
#include <sunder/polytope/pair/polytope_claims.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

namespace sunder::tests {
namespace {

using polytope::PolytopeAnswer;

std::string written_certificate(const PolytopePair& c, const polytope::HyperplaneEvidence& evidence) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  add_claims(file, {"a", c.a, c.pose_a}, {"b", c.b, c.pose_b}, evidence);
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
  int meet = 0, apart = 0, refused = 0, hyperplanes = 0;
};

void expect_answer_accepted(const PolytopePair& c, const PolytopeAnswer& answer, Counts& counts) {
  std::string text;
  prove([&](std::string_view piece) { text += piece; }, AskedPair{c.a, c.pose_a, c.b, c.pose_b, "a", "b"}, answer);
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

// The list of this key exchanged for another one.
std::string with(const std::string& text, const std::string& key, const std::string& list) {
  const std::size_t begin = text.rfind("\"" + key + "\": [");
  if (begin == std::string::npos) return "";
  std::size_t end = text.find('[', begin);
  int depth = 0;
  do {
    depth += (text[end] == '[') - (text[end] == ']');
    ++end;
  } while (depth > 0);
  return text.substr(0, begin) + "\"" + key + "\": " + list + text.substr(end);
}

// By several hyperplanes; mutants are refused by the rule.
void expect_hyperplanes_accepted(const PolytopePair& c, const polytope::HierarchicalTree& a,
                                 const polytope::HierarchicalTree& b, const PolytopeAnswer& answer, Counts& counts) {
  const polytope::HyperplaneEvidence evidence = parting_hyperplanes(a, c.pose_a, b, c.pose_b, answer);
  const std::string text = written_certificate(c, evidence);
  const sunder_verifier::FileResult report = sunder_verifier::verify_text(text, "pair");
  ASSERT_EQ(report.statements.size(), 1u) << report.failed_form << text;
  ASSERT_TRUE(report.accepted()) << report.statements[0].reason << text;
  ASSERT_NE(report.statements[0].sentence.find("by half-spaces that hold them"), std::string::npos);
  ++counts.hyperplanes;
  const bool is_one_alone = std::all_of(evidence.direction.begin(), evidence.direction.end(),
                                        [](const Dyadic& x) { return x.sign() == Sign::zero; });
  for (const char* key : {"by_a", "by_b"}) {
    const std::string mutant = with(text, key, "[]");
    if (mutant == text || is_one_alone) continue;
    const sunder_verifier::FileResult refused = sunder_verifier::verify_text(mutant, key);
    ASSERT_EQ(refused.statements.size(), 1u) << refused.failed_form << mutant;
    EXPECT_EQ(refused.statements[0].failed_check, "parted_by_hyperplanes") << mutant;
    ++counts.refused;
  }
  const sunder_verifier::FileResult refused = sunder_verifier::verify_text(with(text, "planes_a", "[\"1\"]"), "F");
  EXPECT_FALSE(refused.failed_form.empty());
}

void expect_accepted(const PolytopePair& c, Counts& counts) {
  expect_answer_accepted(c, polytope_polytope(c.a, c.pose_a, c.b, c.pose_b), counts);
  const polytope::HierarchicalTree a = small_tree(c.a), b = small_tree(c.b);
  const PolytopeAnswer answer = polytope_polytope_by_columns(a, c.pose_a, b, c.pose_b);
  expect_answer_accepted(c, answer, counts);
  if (!answer.meet()) expect_hyperplanes_accepted(c, a, b, answer, counts);
}

TEST(PolytopeCertificatesDifferential, OfPoints) {
  const int count = scaled_count(3000, 60);
  PolytopePairs pairs(chosen_seed(20261130));
  Counts counts;
  for (int i = 0; i < count; ++i) {
    expect_accepted(pairs.next(), counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.meet, count / 10);
  EXPECT_GT(counts.apart, count / 10);
  EXPECT_GT(counts.hyperplanes, count / 10);
  EXPECT_GE(counts.refused, 2 * count);
}

TEST(PolytopeCertificatesDifferential, OfHalfSpaces) {
  const int count = scaled_count(3000, 60);
  PolytopePairs pairs(chosen_seed(20261131));
  Counts counts;
  for (int i = 0; i < count; ++i) {
    expect_accepted(pairs.next_of_half_spaces(), counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.meet, count / 10);
  EXPECT_GT(counts.apart, count / 10);
  EXPECT_GT(counts.hyperplanes, count / 10);
}

}  // namespace
}  // namespace sunder::tests
