// sunder verify FILE...: are the certificates true? And are they made of these files?
#include <sunder/ask/call_words.h>
#include <sunder/ask/made_again.h>
#include <sunder/ask/report.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>

#include <verifier/cpp/verify.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace sunder::ask {

namespace {

struct VerifyCall {
  std::vector<std::string> files, against;
  bool no_limit = false;
  bool json = false;
};

using sunder_verifier::StatementResult;

struct File {
  std::string name;
  sunder_verifier::FileResult result;
  bool is_set = false;
  std::vector<std::pair<std::string, std::uint64_t>> accepted;  // how many of each verdict; "apart" or "none" first
  std::vector<std::size_t> refused;                             // numbers of statements
  std::optional<std::string> not_made_of;  // where it is held against files: what shows that it is not; empty: it is

  bool holds() const { return result.accepted() && not_made_of.value_or("").empty(); }
};

bool is_pair(const StatementResult& result) {
  return result.question.empty() ? result.verdict == "apart" || result.verdict == "meet" : result.question == "pair";
}

// Throws Error bad_file where it cannot be read. against: is it made of these? Their names do not count.
File verify(const std::string& name, std::span<const GivenInput> against, bool no_limit) {
  using sunder_verifier::Limit;
  File file;
  file.name = io::one_line(name);
  const std::string bytes = io::read_file(name);
  file.result = sunder_verifier::verify_text(bytes, file.name, no_limit ? Limit::none : Limit::by_size);
  if (!file.result.readable) {
    // The verifier's line begins with the place already.
    std::string text = file.result.error;
    if (text.starts_with(file.name + ": ")) text = text.substr(file.name.size() + 2);
    io::fail_file(name, text);
  }
  const std::vector<StatementResult>& statements = file.result.statements;
  file.is_set = !std::all_of(statements.begin(), statements.end(), is_pair);
  // Both verdicts about pairs, and both about sets, are always told.
  if (std::any_of(statements.begin(), statements.end(), is_pair)) file.accepted = {{"apart", 0}, {"meet", 0}};
  const std::string first = statements.empty() ? "" : statements[0].verdict;
  if (first == "none" || first == "some") file.accepted = {{"none", 0}, {"some", 0}};
  for (std::size_t i = 0; i < statements.size(); ++i) {
    if (!statements[i].accepted) {
      file.refused.push_back(i);
      continue;
    }
    auto known = std::find_if(file.accepted.begin(), file.accepted.end(),
                              [&](const auto& entry) { return entry.first == statements[i].verdict; });
    if (known == file.accepted.end()) known = file.accepted.insert(known, {io::one_line(statements[i].verdict), 0});
    ++known->second;
  }
  if (!against.empty() && file.result.failed_form.empty()) {
    InputFiles inputs;
    for (const auto& [input, sha256] : file.result.inputs) inputs.push_back({input, sha256});
    file.not_made_of = difference_made_again(bytes, inputs, file.result.call, against);
  }
  return file;
}

constexpr std::size_t most_told = 10;  // statements of a file; of more it is told how many there are of each verdict
constexpr std::size_t most_refused = 100;  // of a file, told one by one

// "proved: exactly 2 pairs of segments meet: 0 1 crossing, 0 2 touch", line by line.
std::string proved_text(const File& file) {
  std::string text;
  const std::vector<StatementResult>& statements = file.result.statements;
  const bool tells_pairs = statements.size() <= most_told;  // else what is said of all of them, if that is not as long
  const auto count =
      statements.size() - static_cast<std::size_t>(std::count_if(statements.begin(), statements.end(), is_pair));
  if (!tells_pairs && count > most_told) return text;
  for (const StatementResult& statement : statements) {
    if (statement.accepted && (tells_pairs || !is_pair(statement))) {
      text += fmt::format("  proved: {}\n", statement.sentence);
    }
  }
  return text;
}

std::string counts_text(const File& file) {
  std::string text;
  for (const auto& [verdict, count] : file.accepted) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, verdict);
  }
  return text.empty() ? "" : fmt::format(" ({})", text);
}

// That reading is this program's has to be said: the checker knows tables only.
std::string against_text(const File& file) {
  const std::string& difference = *file.not_made_of;
  std::string text = difference.empty()
                         ? "  made of these files: this program, not the checker, reads the same tables from them, by\n"
                         : fmt::format("  not made of these files: {}\n", difference);
  if (!file.result.call.empty()) text += fmt::format("    {}\n", call_text(file.result.call));
  return text;
}

std::string human_text(const File& file) {
  const sunder_verifier::FileResult& result = file.result;
  if (!result.failed_form.empty())
    return fmt::format("{}: REFUSED: check F: {}\n", file.name, io::one_line(result.failed_form));
  std::string text = fmt::format("{}: {}: {} of {} accepted{}\n", file.name, file.holds() ? "accepted" : "REFUSED",
                                 result.statements.size() - file.refused.size(),
                                 count_of(result.statements.size(), file.is_set ? "statement" : "pair"),
                                 file.is_set && result.statements.size() <= most_told ? "" : counts_text(file));
  text += proved_text(file);
  if (file.not_made_of) text += against_text(file);
  for (const std::string& what : result.left_out) text += fmt::format("  left out: {}\n", io::one_line(what));
  for (const sunder_verifier::FileInput& input : result.inputs) {
    text += fmt::format("  of {}, SHA-256 {}\n", io::one_line(input.name), input.sha256);
  }
  if (!result.call.empty() && !file.not_made_of) {
    text += fmt::format("  said to be made by {}\n", call_text(result.call));
  }
  const std::size_t told = std::min(file.refused.size(), most_refused);
  for (const std::size_t i : std::span(file.refused).first(told)) {
    const StatementResult& pair = result.statements[i];
    text += fmt::format("  {} {}, which states that {}: check {}: {}\n", file.is_set ? "statement" : "pair", i,
                        pair.sentence, pair.failed_check, io::one_line(pair.reason));
  }
  if (told < file.refused.size()) text += fmt::format("  {} more are refused\n", file.refused.size() - told);
  return text;
}

Json json_of(const File& file) {
  const sunder_verifier::FileResult& result = file.result;
  Json json{{"file", file.name},
            {"answer", file.holds() ? "accepted" : "refused"},
            {"statements", result.statements.size()},
            {"accepted", Json::object()}};
  for (const auto& [verdict, count] : file.accepted) json["accepted"][verdict] = count;
  if (!result.left_out.empty()) json["without"] = result.left_out;
  for (const sunder_verifier::FileInput& input : result.inputs) {
    json["inputs"].push_back({{"file", input.name}, {"sha256", input.sha256}});
  }
  if (!result.call.empty()) json["call"] = result.call;
  if (file.not_made_of) {
    json["against"] = {{"answer", file.not_made_of->empty() ? "made of these" : "not made of these"},
                       {"read_by", "the program"}};
    if (!file.not_made_of->empty()) json["against"]["why"] = *file.not_made_of;
  }
  for (const StatementResult& statement : result.statements) {
    if (statement.accepted) json["proved"].push_back(statement.sentence);
  }
  json["refused"] = Json::array();
  if (!result.failed_form.empty()) json["refused"].push_back({{"check", "F"}, {"reason", result.failed_form}});
  for (const std::size_t i : file.refused) {
    const StatementResult& pair = result.statements[i];
    json["refused"].push_back({{"statement", i},
                               {"a", pair.name_a},
                               {"b", pair.name_b},
                               {"verdict", pair.verdict},
                               {"check", pair.failed_check},
                               {"reason", pair.reason}});
  }
  return json;
}

// Throws Error again, where it is about no file.
void add_unread(Talk& talk, const std::vector<std::string>& names, const Error& error, Report& report) {
  if (error.code() != ErrorCode::bad_file) throw Error(error);
  talk.complain(error.what());
  report.code = exit_code::bad;
  const Json told{{"kind", "bad-file"}, {"place", error.place()}, {"text", io::one_line(error.what())}};
  if (report.facts.empty()) report.add("error", told);
  for (const std::string& name : names) {
    report.objects.push_back({{"file", io::one_line(name)}, {"answer", nullptr}, {"error", told}});
  }
}

// Verdicts are told as they are known; what cannot be read is told in between, and does not end the call.
Report run(const VerifyCall& call, Talk& talk) {
  Report report{.verb = "verify"};
  std::vector<GivenInput> against;
  try {
    for (const std::string& name : call.against) against.push_back(read_given(name));
  } catch (const Error& error) {
    add_unread(talk, call.files, error, report);
  }
  const bool is_ready = report.code == exit_code::no;
  for (const std::string& name : is_ready ? call.files : std::vector<std::string>()) {
    try {
      const File file = verify(name, against, call.no_limit);
      if (!file.holds()) report.code = std::max(report.code, exit_code::yes);
      call.json ? report.objects.push_back(json_of(file)) : talk.print_for_people(human_text(file));
    } catch (const Error& error) {
      add_unread(talk, {name}, error, report);
    }
  }
  if (report.code != exit_code::bad) report.answer = report.code == exit_code::no ? "accepted" : "refused";
  report.notes = talk.notes();
  report.is_told = !call.json;
  return report;
}

}  // namespace

Verb verify_verb() {
  const auto call = std::make_shared<VerifyCall>();
  return {
      "verify",
      "Are these certificates true? The checker shares no code with the solvers.",
      "0 all accepted; 1 some refused",
      {{"FILE", &call->files, "certificate files", "", true},
       {"--against", &call->against,
        "also check that the certificate was made from these files: give all inputs that it names, in the same order; "
        "the program reads them again, and repeats the call that the certificate names",
        "FILE"},
       {"--no-limit", &call->no_limit,
        "also check certificates that take long for their size (default: refuse to start)"},
       json_option(call->json)},
      [call](Talk& talk) { return run(*call, talk); }};
}

}  // namespace sunder::ask
