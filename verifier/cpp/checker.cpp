#include <verifier/cpp/checker.h>
#include <verifier/cpp/questions.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

std::vector<FileInput> read_inputs(const json& list) {
  std::vector<FileInput> result;
  for (const json& item : list) {
    const std::string where = "inputs[" + std::to_string(result.size()) + "]";
    require_members(item, {"name", "sha256"}, {}, where);
    FileInput input{text_member(item, "name", where), string_member(item, "sha256", where)};
    const bool is_digest =
        input.sha256.size() == 64 && input.sha256.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!is_digest) refuse_form(where + ".sha256 is not 64 small hexadecimal digits");
    result.push_back(std::move(input));
  }
  return result;
}

std::vector<std::string> read_left_out(const json& list) {
  std::vector<std::string> result;
  for (const json& item : list) {
    const std::string where = "left_out[" + std::to_string(result.size()) + "]";
    if (!item.is_string()) refuse_form(where + " is not a text of 1 to " + std::to_string(most_name) + " characters");
    const std::string text = item.get<std::string>();
    const std::size_t size = characters(text);
    if (size == 0 || size > most_name) {
      refuse_form(where + " is not a text of 1 to " + std::to_string(most_name) + " characters");
    }
    result.push_back(text);
  }
  return result;
}

PairResult check(const ClaimedStatement& statement) {
  PairResult result;
  const bool is_pair = !statement.a.empty();
  result.question = statement.question;
  result.name_a = is_pair ? statement.a : statement.question;
  result.name_b = is_pair ? statement.b : statement.words;
  result.verdict = statement.verdict;
  try {
    for (const auto& check : statement.checks) check();
    result.accepted = true;
  } catch (const Refused& refused) {
    result.failed_check = refused.check;
    result.reason = refused.reason;
  }
  return result;
}

}  // namespace

bool is_of_claims(const json& top) {
  return top.is_object() && !top.contains("sunder_set_certificate") && top.contains("sunder_certificate") &&
         top["sunder_certificate"] == 2;
}

void verify_claims(const json& top, FileResult& result) {
  require_members(top, {"sunder_certificate", "tables", "statements"}, {"inputs", "left_out"}, "the file");
  if (!top["sunder_certificate"].is_number_integer()) refuse_form("sunder_certificate is not 2");
  FileResult read;
  if (top.contains("inputs")) read.inputs = read_inputs(list_member(top, "inputs", "the file"));
  if (top.contains("left_out")) read.left_out = read_left_out(list_member(top, "left_out", "the file"));
  const Tables tables = read_tables(top["tables"]);
  const json& statements = list_member(top, "statements", "the file");
  if (statements.empty()) refuse_form("the file states nothing");
  std::vector<ClaimedStatement> claimed;
  for (const json& item : statements) {
    claimed.push_back(read_statement(item, tables, "statements[" + std::to_string(claimed.size()) + "]"));
  }
  for (const ClaimedStatement& statement : claimed) read.pairs.push_back(check(statement));
  result.inputs = std::move(read.inputs);
  result.left_out = std::move(read.left_out);
  result.pairs = std::move(read.pairs);
}

}  // namespace sunder_verifier
