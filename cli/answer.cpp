#include <cli/answer.h>
#include <cli/call.h>
#include <cli/manual.h>
#include <cli/words.h>

#include <sunder/ask/call_words.h>
#include <sunder/ask/report.h>
#include <sunder/ask/verb.h>
#include <sunder/base/error.h>
#include <sunder/io/text/text.h>
#include <sunder/version.h>

#include <fmt/format.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <cstdint>
#include <variant>
#include <vector>

namespace sunder::cli {

namespace {

namespace exit_code = ask::exit_code;
using Words = std::span<const std::string>;

constexpr const char* other_codes = "2 bad input or call; 3 internal error.";

[[noreturn]] void fail_call(const std::string& text) { throw Error(ErrorCode::bad_call, text); }

std::vector<std::string> names_of_verbs(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* verb : verbs_of(program)) names.push_back(verb->get_name());
  return names;
}

bool is_in(Words words, const std::string& word) { return std::find(words.begin(), words.end(), word) != words.end(); }

[[noreturn]] void fail_verb(const CLI::App& program, const std::string& what, const std::string& word) {
  const std::vector<std::string> known = names_of_verbs(program);
  std::vector<std::string> first = known;
  first.emplace_back("help");
  first.emplace_back("version");
  fail_call(
      fmt::format("{}{}; verbs are {}; see sunder --help", what, did_you_mean(word, first), fmt::join(known, ", ")));
}

[[noreturn]] void fail_word(const std::string& after, const std::string& word) {
  fail_call(fmt::format("{}: nothing is expected at {}; see sunder --help", after, io::quote(word)));
}

// help, help VERB
std::string help(const CLI::App& program, Words words) {
  if (words.size() > 2) fail_call("help: name one verb, or none; see sunder --help");
  if (words.size() == 2 && !is_in(names_of_verbs(program), words[1])) {
    fail_verb(program, "there is no verb " + io::quote(words[1]), words[1]);
  }
  return help_text(words.size() == 1 ? program : *program.get_subcommand(words[1]));
}

// A call whose first word is an option, and no verb.
[[noreturn]] void fail_option(const CLI::App& program, const std::string& first) {
  const std::string word = first.substr(0, first.find('='));
  const std::vector<const CLI::App*> verbs = verbs_of(program);
  const bool is_of_verb = word == "--" || std::any_of(verbs.begin(), verbs.end(), [&](auto* verb) {
                            return verb->get_option_no_throw(word) != nullptr;
                          });
  if (is_of_verb) fail_verb(program, "the verb comes first, before " + io::quote(word), "");
  const std::string meant = did_you_mean(word, names_of_options(program));
  fail_verb(program, "there is no option " + io::quote(word) + meant, "");
}

// --completion SHELL, --completion=SHELL
std::string completion_of(const CLI::App& program, Words words) {
  const std::string& first = words[0];
  const std::size_t end = first.find('=');
  const std::size_t expected = end == std::string::npos ? 2 : 1;
  if (words.size() < expected) fail_call("--completion: name the shell: bash, zsh, or fish; see sunder --help");
  if (words.size() > expected) fail_word("--completion", words[expected]);
  return completion(program, expected == 2 ? words[1] : first.substr(end + 1));
}

// What a call without a verb prints.
std::string text_of_program(const CLI::App& program, Words words) {
  if (words.empty()) fail_verb(program, "no verb is given", "");
  const std::string& first = words[0];
  if (first == "help" || first == "--help" || first == "-h") return help(program, words);
  if (first == "--completion" || first.starts_with("--completion=")) return completion_of(program, words);
  const bool is_version = first == "--version" || first == "-V" || first == "version", is_manual = first == "--man";
  if (!is_version && !is_manual) {
    if (first.starts_with('-')) fail_option(program, first);
    fail_verb(program, "there is no verb " + io::quote(first), first);
  }
  if (words.size() > 1) fail_word(first, words[1]);
  return is_version ? fmt::format("sunder {}\n", version) : man_page(program, version);
}

// The option outlives the program.
CLI::Option* add_value(CLI::App& verb, const ask::Option& option) {
  const auto add_limit = [&](std::uint64_t* value) {
    const auto set = [value, &option](const std::string& text) {
      std::int64_t number = 0;
      if (!io::parse_integer(text, number) || number < 0) {
        throw Error(ErrorCode::bad_call, io::quote(text) + " is no number of things; give one like 2000000",
                    option.name);
      }
      *value = static_cast<std::uint64_t>(number);
    };
    return verb.add_option_function<std::string>(option.name, set, option.help);
  };
  if (auto* const* flag = std::get_if<bool*>(&option.value)) return verb.add_flag(option.name, **flag, option.help);
  if (auto* const* text = std::get_if<std::string*>(&option.value)) {
    return verb.add_option(option.name, **text, option.help);
  }
  if (auto* const* number = std::get_if<std::uint64_t*>(&option.value)) return add_limit(*number);
  CLI::Option* list = verb.add_option(option.name, *std::get<std::vector<std::string>*>(option.value), option.help);
  if (option.name.starts_with('-')) list->allow_extra_args(false);
  if (option.most > 0) list->expected(1, option.most);
  return list;
}

// What a call needs beside its words.
struct Call {
  ask::Talk& talk;
  int code = exit_code::no;
  bool quiet = false, json = false;
};

void add_verb(CLI::App& program, const ask::Verb& verb, Call& call) {
  CLI::App* const app = program.add_subcommand(verb.name, verb.about);
  for (const ask::Option& option : verb.options) {
    CLI::Option* added = add_value(*app, option);
    if (!std::holds_alternative<bool*>(option.value)) added->type_name(option.type);
    added->required(option.required);
  }
  for (const ask::Option& option : verb.options) {
    CLI::Option* added = app->get_option(option.name.substr(option.name.find(',') + 1));
    if (!option.needs.empty()) added->needs(app->get_option(option.needs));
    for (const std::string& other : option.excludes) added->excludes(app->get_option(other));
  }
  app->footer(fmt::format("Exit code: {}; {}", verb.codes, other_codes));
  app->add_flag("--quiet", call.quiet, "print only errors; the exit code is the answer");
  app->parse_complete_callback([app, &call] {
    if (call.quiet) call.talk.be_quiet();
    const bool is_taken = takes_standard_output(*app, call.talk);
    require_apart(*app, call.talk);
    if (is_taken) call.talk.leave_output();
  });
  app->callback([&verb, &call] {
    const ask::Report report = ask::run_call(verb, call.talk);
    call.code = report.code;
    if (report.is_told) return;
    call.json ? call.talk.print(ask::to_text(json_of(report)))
              : call.talk.print_for_people(text_of(report), report.has_colours);
  });
}

// For help and completion; text_of_program() obeys them.
void add_options(CLI::App& program) {
  program.set_version_flag("-V,--version", fmt::format("sunder {}", version), "print the version");
  program.add_option("--completion", "print a completion script for bash, zsh or fish")->type_name("SHELL");
  program.add_flag("--man")->description("print the manual page");
  program.footer(fmt::format("Exit code: 0 or 1, the answer (sunder help VERB explains it); {}", other_codes));
}

// What CLI11 finds wrong with the other words of the call.
std::string problem_of(const CLI::App& verb, const CLI::ParseError& error) {
  const std::string text = error.what();
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    return fmt::format("one {} is expected, and more are named", text.substr(0, text.find(':')));
  }
  const std::vector<std::string> extra = verb.remaining();
  const bool is_extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !extra.empty();
  return is_extra ? "nothing is expected at " + io::quote(extra.front()) : text;
}

}  // namespace

int answer(Words words, ask::Talk& talk, Asked& asked) {
  Call call{talk};
  const std::vector<ask::Verb> verbs = ask::verbs();
  CLI::App program(
      "Sunder decides exactly whether geometric objects meet, and can prove each answer. To meet is to have a common "
      "point: touching counts.",
      "sunder");
  program.set_help_flag("-h,--help", "print this help");  // verbs inherit it
  for (const ask::Verb& verb : verbs) add_verb(program, verb, call);
  add_options(program);
  asked.json = is_in(words, "--json");
  if (words.empty() || !is_in(names_of_verbs(program), words[0])) {
    talk.print(text_of_program(program, words));
    return exit_code::no;
  }
  asked.verb = words[0];
  const CLI::App& verb = *program.get_subcommand(asked.verb);
  asked.json = call.json = asks_for_json(verb, words.subspan(1));
  std::string problem = option_problem(verb, words.subspan(1));
  try {
    if (problem.empty()) program.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    talk.print(help_text(verb));
  } catch (const CLI::ParseError& error) {
    problem = problem_of(verb, error);
  }
  if (problem.empty()) return call.code;
  fail_call(fmt::format("{0}: {1}; see sunder {0} --help", asked.verb, problem));
}

}  // namespace sunder::cli
