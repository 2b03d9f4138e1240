// Statements: what a question is about, and says; and of each verdict what it says more, its claims in their order, each
// with what it is bound to, and the sentence. What is in [..] may be missing. docs/claims.md, "Statements".
#pragma once

#include <string>
#include <vector>

namespace sunder_verifier {

struct VerdictRow {
  std::string name, says, claims, sentence;
};

struct QuestionRow {
  std::string name, table, says;
  std::vector<VerdictRow> verdicts;
};

extern const std::vector<QuestionRow> question_rows;

}  // namespace sunder_verifier
