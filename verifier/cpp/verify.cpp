#include <verifier/cpp/questions.h>
#include <verifier/cpp/reader.h>
#include <verifier/cpp/verify.h>

#include <algorithm>
#include <exception>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

constexpr std::size_t kMaxDepth = 500;  // of nested JSON; a certificate needs 7 levels

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

void verify_file(const json& top, FileResult& result) {
  if (!top.is_object()) refuse_form("the file is not an object");
  const auto version = top.find("sunder_certificate");
  require(!top.contains("sunder_set_certificate") && (version == top.end() || *version != 1), "F",
          "this is a certificate of version 1, which is no longer read; make it again");
  require_members(top, {"sunder_certificate", "tables", "statements"}, {"inputs", "left_out"}, "the file");
  require(top["sunder_certificate"].is_number_integer() && top["sunder_certificate"] == 2, "F",
          "sunder_certificate is not 2");
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

// ---- The text.

std::string line_and_column(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t start = before.rfind('\n');
  const std::size_t column = before.size() - (start == std::string_view::npos ? 0 : start + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

// Reads JSON without keeping it: finds what is not JSON, nesting too deep, and keys given twice.
class FirstReading : public nlohmann::json_sax<json> {
 public:
  explicit FirstReading(std::string_view text) : text_(text) {}

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(std::int64_t) override { return true; }
  bool number_unsigned(std::uint64_t) override { return true; }
  bool number_float(double, const std::string&) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(json::binary_t&) override { return true; }
  bool start_object(std::size_t) override { return start(); }
  bool key(std::string& key) override {
    repeated |= !keys_.back().insert(key).second;
    return true;
  }
  bool end_object() override { return end(); }
  bool start_array(std::size_t) override { return start(); }
  bool end_array() override { return end(); }
  bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception&) override {
    error = line_and_column(text_, byte) + ": not JSON, or a number beyond the doubles; write the file again";
    return false;
  }

  std::string error;  // empty if the text is JSON
  bool repeated = false;

 private:
  bool start() {
    keys_.emplace_back();
    if (keys_.size() > kMaxDepth) error = "nested too deeply; a certificate needs 7 levels";
    return error.empty();
  }
  bool end() {
    keys_.pop_back();
    return true;
  }

  std::string_view text_;
  std::vector<std::set<std::string>> keys_;  // of the objects around the place of reading; of a list, none
};

void verify_into(std::string_view text, const std::string& prefix, FileResult& result) {
  if (text.find('\0') != std::string_view::npos) {  // the JSON reader takes it for the end
    result.error = prefix + "not text; write the file again";
    return;
  }
  FirstReading first(text);
  json::sax_parse(text.begin(), text.end(), &first);
  if (!first.error.empty()) {
    result.error = prefix + first.error;
    return;
  }
  result.readable = true;
  try {
    if (first.repeated) refuse_form("an object has a key twice");
    verify_file(json::parse(text.begin(), text.end()), result);
  } catch (const Refused& refused) {
    result.failed_form = refused.reason;
  }
}

}  // namespace

bool FileResult::accepted() const {
  return readable && failed_form.empty() &&
         std::all_of(pairs.begin(), pairs.end(), [](const PairResult& pair) { return pair.accepted; });
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
  } catch (const std::exception& error) {  // memory ran out
    result = FileResult();
    result.error = error.what();
  }
  return result;
}

}  // namespace sunder_verifier
