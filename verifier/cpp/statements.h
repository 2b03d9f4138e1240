// Statements, and what proves them, as data: docs/claims.md, "Statements".
#pragma once

#include <verifier/cpp/json.h>
#include <verifier/cpp/values.h>

#include <memory>
#include <string>
#include <vector>

namespace sunder_verifier {

// A rule, with the values that it takes.
struct Check {
  Rule rule;
  std::vector<const Value*> values;            // as many as the rule takes
  std::shared_ptr<const Scope> said, brought;  // these hold them
};

struct Statement {
  std::string question, verdict;
  std::string sentence;  // what it says, and of what
  std::string a, b;      // of a pair: the names of the bodies
  std::shared_ptr<const Scope> said;
  std::vector<Check> checks;
};

// What all statements of a file may speak of. The tables, and what is proved when a statement is checked, must outlive
// it.
Scope scope_of_file(const Tables& tables, const Proved& proved);

// Reads a statement: throws Refused where its form is wrong. Tables and scope must outlive it.
Statement read_statement(const Json& item, const Tables& tables, const Scope& file, const std::string& where);

// What a statement that is accepted has proved, for those after it.
void note(const Statement& statement, const Tables& tables, Proved& proved);

}  // namespace sunder_verifier
