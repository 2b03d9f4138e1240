#include <verifier/cpp/reader.h>
#include <verifier/cpp/statements.h>
#include <verifier/cpp/verify.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

std::vector<FileInput> read_inputs(const Json& list) {
  std::vector<FileInput> result;
  for (const Json& entry : list) {
    const std::string where = "inputs[" + std::to_string(result.size()) + "]";
    const ReadNow now(entry);
    const Json& item = *now;
    require_members(item, {"name", "sha256"}, {}, where);
    FileInput input{text_member(item, "name", where), string_member(item, "sha256", where)};
    const bool is_digest =
        input.sha256.size() == 64 && input.sha256.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!is_digest) refuse_form(where + ".sha256 is not 64 small hexadecimal digits");
    result.push_back(std::move(input));
  }
  return result;
}

std::vector<std::string> read_texts(const Json& top, const char* key) {
  std::vector<std::string> result;
  for (const Json& item : list_member(top, key, "the file")) {
    result.push_back(read_text(item, std::string(key) + "[" + std::to_string(result.size()) + "]"));
  }
  return result;
}

constexpr std::int64_t version_needed = 3;

void require_version(const Json& top) {
  const Json* const version = top.find("sunder_certificate");
  const bool is_number = version != nullptr && version->is_integer() &&
                         std::abs(version->integer()) <= static_cast<std::int64_t>(most_number);
  const bool is_first = version == nullptr && top.contains("sunder_set_certificate");
  if (!is_number && !is_first) refuse_form("the file has no version, sunder_certificate");
  const std::int64_t number = is_first ? 1 : version->integer();
  if (number == version_needed) return;
  refuse_form("the file is of version " + std::to_string(number) + ", and version " + std::to_string(version_needed) +
              " is needed; make it again");
}

StatementResult check(const Statement& statement) {
  StatementResult result;
  const bool is_pair = !statement.a.empty();
  result.question = statement.question;
  result.sentence = statement.sentence;
  result.verdict = statement.verdict;
  try {
    for (const Check& one : statement.checks) one.rule.check(one.values.data());
    result.accepted = true;
  } catch (const Refused& refused) {
    result.name_a = is_pair ? statement.a : statement.question;
    result.name_b = is_pair ? statement.b : statement.sentence;
    result.failed_check = refused.check;
    result.reason = refused.reason;
  }
  return result;
}

// The statements of a file. Reads all of them first, for their form. The first ones are kept so: claims take some ten
// times the memory of their text, and each set of parts has a table of its own, so the others are read again where they
// are checked.
class Statements {
 public:
  Statements(const Json& list, const Tables& tables)
      : list_(list), tables_(tables), file_(scope_of_file(tables, proved_)) {
    std::size_t k = 0;
    for (const Json& item : list) {
      Statement statement = read(item, k++);
      if (k <= most_kept && tables_.part_tables_made() <= most_part_tables) kept_.push_back(std::move(statement));
    }
  }

  std::vector<StatementResult> check_all() {
    std::vector<StatementResult> results;
    results.reserve(list_.size());
    std::size_t k = 0;
    for (const Json& item : list_) {
      const Statement statement = k < kept_.size() ? std::move(kept_[k]) : read_again(item, k);
      ++k;
      results.push_back(check(statement));
      if (results.back().accepted) note(statement, tables_, proved_);
    }
    return results;
  }

 private:
  static constexpr std::size_t most_kept = 1000, most_part_tables = 4;

  Statement read(const Json& item, std::size_t k) {
    return read_statement(*ReadNow(item), tables_, file_, "statements[" + std::to_string(k) + "]");
  }

  Statement read_again(const Json& item, std::size_t k) {
    const StepsAreTaken are_taken;
    return read(item, k);
  }

  const Json& list_;
  const Tables& tables_;
  Proved proved_;
  const Scope file_;
  std::vector<Statement> kept_;
};

// The text has the members of the file, and those of its tables, and its statements unread.
void verify_file(const JsonText& text, FileResult& result) {
  const Json& top = text.top();
  if (!top.is_object()) refuse_form("the file is not an object");
  require_version(top);
  require_members(top, {"sunder_certificate", "inputs", "call", "left_out", "tables", "statements"}, {"said"},
                  "the file");
  FileResult read;
  read.inputs = read_inputs(list_member(top, "inputs", "the file"));
  read.call = read_texts(top, "call");
  read.left_out = read_texts(top, "left_out");
  InputNames names;
  for (const FileInput& input : read.inputs) names.push_back(input.name);
  Tables tables = read_tables(top["tables"], std::move(names));
  if (top.contains("said")) read_said(top["said"], tables);
  const Json& statements = list_member(top, "statements", "the file");
  if (statements.empty()) refuse_form("the file states nothing");
  result.statements = Statements(statements, tables).check_all();
  result.inputs = std::move(read.inputs);
  result.call = std::move(read.call);
  result.left_out = std::move(read.left_out);
}

// ---- The text.

std::string line_and_column(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t start = before.rfind('\n');
  const std::size_t column = before.size() - (start == std::string_view::npos ? 0 : start + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

std::string words(const NotJson& error, std::string_view text) {
  if (error.is_too_deep) return "nested too deeply; a certificate needs 7 levels";
  return line_and_column(text, error.at) + ": not JSON, or a number beyond the doubles; write the file again";
}

void verify_into(std::string_view text, const std::string& prefix, FileResult& result) {
  try {
    const JsonText read = read_json(text, 2);
    result.readable = true;
    if (read.has_key_twice) refuse_form("an object has a key twice");
    verify_file(read, result);
  } catch (const NotJson& error) {
    result.error = prefix + words(error, text);
  } catch (const Refused& refused) {
    result.failed_form = refused.reason;
  }
}

}  // namespace

bool FileResult::accepted() const {
  return readable && failed_form.empty() &&
         std::all_of(statements.begin(), statements.end(), [](const StatementResult& one) { return one.accepted; });
}

FileResult verify_text(std::string_view text, std::string_view place, Limit limit) {
  FileResult result;
  const std::string prefix = std::string(place) + ": ";
  lift_limit();
  if (limit == Limit::by_size) limit_steps(text.size());
  try {
    verify_into(text, prefix, result);
  } catch (const TooLong& error) {
    result = FileResult();
    result.error = prefix + "checking it takes more than " + std::to_string(error.most) +
                   " steps, the limit for a file of its size; give --no-limit to check it all the same";
  }
  return result;
}

}  // namespace sunder_verifier
