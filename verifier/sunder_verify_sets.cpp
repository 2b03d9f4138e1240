#include "sunder_verify_sets.h"

#include "statement.h"
#include "sunder_verify_circles.h"
#include "sunder_verify_convex.h"
#include "sunder_verify_polygons.h"
#include "sunder_verify_regions.h"
#include "sunder_verify_segments.h"

#include <algorithm>
#include <array>
#include <utility>

namespace sunder_verifier {
namespace {

constexpr std::array<const char*, 6> tables{"segments", "circles",     "convex_polygons",
                                            "polygons", "half_planes", "rings"};

Questions questions_of(const json& top) {
  Questions questions;
  add_segment_questions(top, questions);
  add_circle_questions(top, questions);
  add_convex_questions(top, questions);
  add_polygon_questions(top, questions);
  add_region_questions(top, questions);
  return questions;
}

PairResult result_of(const Statement& statement) {
  PairResult result = statement.result;
  try {
    statement.check();
    result.accepted = true;
  } catch (const Refused& refused) {
    result.failed_check = refused.check;
    result.reason = refused.reason;
  }
  return result;
}

}  // namespace

std::vector<PairResult> verify_set(const json& top) {
  const json& version = member(top, "sunder_set_certificate", "the file");
  if (!version.is_number_integer() || version != 1) refuse_form("sunder_set_certificate is not 1");
  if (std::none_of(tables.begin(), tables.end(), [&](const char* table) { return top.contains(table); })) {
    refuse_form("the file has no table");
  }
  const Questions questions = questions_of(top);
  std::vector<Statement> statements;
  for (const json& item : list_member(top, "statements", "the file")) {
    const std::string where = "statements[" + std::to_string(statements.size()) + "]";
    const auto read = questions.find(string_member(item, "question", where));
    if (read == questions.end()) refuse_form(where + ".question is none that the tables of the file allow");
    statements.push_back(read->second(item, where));
  }
  std::vector<PairResult> results;
  results.reserve(statements.size());
  for (const Statement& statement : statements) results.push_back(result_of(statement));
  return results;
}

}  // namespace sunder_verifier
