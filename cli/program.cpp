#include <cli/call.h>
#include <cli/manual.h>
#include <cli/program.h>
#include <cli/words.h>

#include <sunder/ask/call_words.h>
#include <sunder/ask/report.h>
#include <sunder/ask/verb.h>
#include <sunder/base/error.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>
#include <sunder/version.h>

#include <fmt/format.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace sunder::cli {

namespace {

namespace exit_code = ask::exit_code;
using ask::print;

constexpr const char* other_codes = "2 bad input or call; 3 internal error.";

// What is asked of the program, as far as it is known.
struct Asked {
  std::vector<std::string> words;
  std::string verb;  // empty: none that there is
  bool json = false;
};

// Signals that end the program unless it does something about them.
constexpr std::array ending_signals{SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU, SIGXFSZ};

extern "C" void end_by_signal(int signal) {
  io::remove_unfinished_files();
  raise(signal);  // which is as it was before, and ends the program when this returns
}

void handle_signals() {
  struct sigaction action = {};
  action.sa_handler = end_by_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : ending_signals) {
    struct sigaction before = {};
    const bool is_known = sigaction(signal, nullptr, &before) == 0;
    if (is_known && before.sa_handler == SIG_DFL) sigaction(signal, &action, nullptr);  // nohup ignores some
  }
}

// A stream that is closed would be the first file that is opened. Reading and writing fail as before.
void hold_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool is_closed = fcntl(stream, F_GETFD) == -1;
    if (is_closed) static_cast<void>(open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

std::string_view kind_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::bad_value: return "bad-value";
    case ErrorCode::bad_shape: return "bad-shape";
    case ErrorCode::bad_pose: return "bad-pose";
    case ErrorCode::bad_file: return "bad-file";
    case ErrorCode::bad_call: return "bad-call";
  }
  return "";
}

// One line on standard error; on standard output a report, where the call asks for JSON.
int complain(const Asked& asked, int code, const std::string& text,
             std::string_view kind = kind_of(ErrorCode::bad_call), const std::string& place = "") {
  ask::print_error(text);
  if (!asked.json || ask::is_output_in_use() || prints_over_input(asked.words)) return code;
  Json report = ask::error_report(asked.verb, kind, place, text);
  if (asked.verb.empty()) report["verb"] = nullptr;
  try {
    print(ask::to_text(report));
  } catch (const Error&) {  // where standard output is what cannot be written
  }
  return code;
}

// Allocates nothing.
int complain_of_memory() {
  std::fputs("sunder: out of memory; give smaller files or more memory\n", stderr);
  return exit_code::internal;
}

std::vector<std::string> names_of_verbs(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* verb : verbs_of(program)) names.push_back(verb->get_name());
  return names;
}

bool is_in(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

int complain_of_verb(const CLI::App& program, const Asked& asked, const std::string& what, const std::string& word) {
  const std::vector<std::string> known = names_of_verbs(program);
  std::vector<std::string> first = known;
  first.emplace_back("help");
  first.emplace_back("version");
  return complain(
      asked, exit_code::bad,
      fmt::format("{}{}; verbs are {}; see sunder --help", what, did_you_mean(word, first), fmt::join(known, ", ")));
}

int complain_of_word(const Asked& asked, const std::string& after, const std::string& word) {
  return complain(asked, exit_code::bad,
                  fmt::format("{}: nothing is expected at {}; see sunder --help", after, io::quote(word)));
}

// help, help VERB
int help(const CLI::App& program, const Asked& asked) {
  const std::vector<std::string>& words = asked.words;
  if (words.size() > 2) return complain(asked, exit_code::bad, "help: name one verb, or none; see sunder --help");
  if (words.size() == 2 && !is_in(names_of_verbs(program), words[1]))
    return complain_of_verb(program, asked, "there is no verb " + io::quote(words[1]), words[1]);
  print(help_text(words.size() == 1 ? program : *program.get_subcommand(words[1])));
  return exit_code::no;
}

// A call whose first word is an option, and no verb.
int complain_of_option(const CLI::App& program, const Asked& asked) {
  const std::string word = asked.words[0].substr(0, asked.words[0].find('='));
  const std::vector<const CLI::App*> verbs = verbs_of(program);
  const bool is_of_verb = word == "--" || std::any_of(verbs.begin(), verbs.end(), [&](auto* verb) {
                            return verb->get_option_no_throw(word) != nullptr;
                          });
  if (is_of_verb) return complain_of_verb(program, asked, "the verb comes first, before " + io::quote(word), "");
  const std::string meant = did_you_mean(word, names_of_options(program));
  return complain_of_verb(program, asked, "there is no option " + io::quote(word) + meant, "");
}

// --completion SHELL, --completion=SHELL
int complete(const CLI::App& program, const Asked& asked) {
  const std::string& first = asked.words[0];
  const std::size_t end = first.find('=');
  const std::size_t expected = end == std::string::npos ? 2 : 1;
  if (asked.words.size() < expected) {
    return complain(asked, exit_code::bad, "--completion: name the shell: bash, zsh, or fish; see sunder --help");
  }
  if (asked.words.size() > expected) return complain_of_word(asked, "--completion", asked.words[expected]);
  print(completion(program, expected == 2 ? asked.words[1] : first.substr(end + 1)));
  return exit_code::no;
}

// A call without a verb.
int run_program(const CLI::App& program, const Asked& asked) {
  if (asked.words.empty()) return complain_of_verb(program, asked, "no verb is given", "");
  const std::string& first = asked.words[0];
  if (first == "help" || first == "--help" || first == "-h") return help(program, asked);
  if (first == "--completion" || first.starts_with("--completion=")) return complete(program, asked);
  const bool is_version = first == "--version" || first == "-V" || first == "version", is_manual = first == "--man";
  if (!is_version && !is_manual) {
    return first.starts_with('-') ? complain_of_option(program, asked)
                                  : complain_of_verb(program, asked, "there is no verb " + io::quote(first), first);
  }
  if (asked.words.size() > 1) return complain_of_word(asked, first, asked.words[1]);
  print(is_version ? fmt::format("sunder {}\n", version) : man_page(program, version));
  return exit_code::no;
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

void add_verb(CLI::App& program, const ask::Verb& verb, int& code, bool& quiet) {
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
  app->add_flag("--quiet", quiet, "print only errors; the exit code is the answer");
  app->parse_complete_callback([app, &quiet] {
    if (quiet) ask::be_quiet();
    const bool is_taken = takes_standard_output(*app);
    require_apart(*app);
    if (is_taken) ask::leave_standard_output();
  });
  app->callback([&verb, &code] { code = ask::run_call(verb); });
}

// For help and completion; run_program() obeys them.
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

int run_checked(int argc, char** argv, Asked& asked) {
  int code = exit_code::no;
  bool quiet = false;
  const std::vector<ask::Verb> verbs = ask::verbs();
  CLI::App program(
      "Sunder decides exactly whether geometric objects meet, and can prove each answer. To meet is to have a common "
      "point: touching counts.",
      "sunder");
  program.set_help_flag("-h,--help", "print this help");  // verbs inherit it
  for (const ask::Verb& verb : verbs) add_verb(program, verb, code, quiet);
  add_options(program);
  const std::vector<std::string>& words = asked.words;
  asked.json = is_in(words, "--json");
  if (words.empty() || !is_in(names_of_verbs(program), words[0])) return run_program(program, asked);
  asked.verb = words[0];
  const CLI::App& verb = *program.get_subcommand(asked.verb);
  const std::span<const std::string> rest = std::span(words).subspan(1);
  asked.json = asks_for_json(verb, rest);
  std::string problem = option_problem(verb, rest);
  try {
    if (problem.empty()) program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    print(help_text(verb));
  } catch (const CLI::ParseError& error) {
    problem = problem_of(verb, error);
  }
  if (problem.empty()) return code;
  return complain(asked, exit_code::bad, fmt::format("{0}: {1}; see sunder {0} --help", asked.verb, problem));
}

}  // namespace

int run(int argc, char** argv) {
  handle_signals();
  hold_closed_streams();
  Asked asked;
  try {
    asked.words.assign(argv + 1, argv + argc);
    return run_checked(argc, argv, asked);
  } catch (const Error& error) {
    return complain(asked, exit_code::bad, error.what(), kind_of(error.code()), error.place());
  } catch (const std::bad_alloc&) {
    return complain_of_memory();
  } catch (const std::length_error&) {
    return complain_of_memory();
  } catch (const std::exception& error) {
    return complain(asked, exit_code::internal, std::string("internal error: ") + error.what() + "; please report it",
                    "internal");
  } catch (...) {
    return complain(asked, exit_code::internal, "internal error; please report it", "internal");
  }
}

}  // namespace sunder::cli
