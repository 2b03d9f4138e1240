// Which claims prove which statement, as data: docs/claims.md, "Statements".
#pragma once

#include <verifier/cpp/rules.h>
#include <verifier/cpp/tables.h>

#include <functional>
#include <string>
#include <vector>

namespace sunder_verifier {

struct ClaimedStatement {
  std::string question, verdict;
  std::string sentence;  // what it says, and of what
  std::string a, b;      // of a pair: the names of the bodies
  std::size_t index_a = 0, index_b = 0;
  Number least;             // of a clearance
  std::size_t hull_of = 0;  // of a hull: the index of its body
  ProvedHull hull;          // and what is proved of it
  std::vector<std::function<void()>> checks;
};

// Reads a statement: throws Refused where its form is wrong. The tables, and what has been proved when it is checked,
// must outlive its checks.
ClaimedStatement read_statement(const Json& item, const Tables& tables, const Proved& proved, const std::string& where);

}  // namespace sunder_verifier
