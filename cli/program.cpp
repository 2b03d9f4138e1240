#include <cli/common.h>
#include <cli/manual.h>
#include <cli/outputs.h>
#include <cli/program.h>
#include <cli/words.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>

#include <fmt/format.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#ifndef SUNDER_VERSION
#define SUNDER_VERSION "unknown"
#endif

namespace sunder::cli {

namespace {

constexpr std::array<AddVerb, 11> verbs{add_pair,   add_scene,  add_segments, add_simple, add_circles, add_polygons,
                                        add_region, add_kernel, add_hull,     add_info,   add_verify};

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

std::vector<std::string> names_of_verbs(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(verb->get_name());
  }
  return names;
}

// The verb that is called, for a report; null where there is none of this name.
Json verb_of(const std::vector<std::string>& words) {
  CLI::App program;
  int code = exit_code::no;
  for (const AddVerb add : verbs) add(program, code);
  const std::vector<std::string> known = names_of_verbs(program);
  return std::find(known.begin(), known.end(), words[0]) == known.end() ? Json(nullptr) : Json(words[0]);
}

// One line on standard error; on standard output a report, where the call asks for JSON.
int complain(const std::vector<std::string>& words, int code, const std::string& text,
             std::string_view kind = kind_of(ErrorCode::bad_call), const std::string& place = "") {
  fmt::print(stderr, "sunder: {}\n", io::one_line(text));
  const bool wants_json = std::find(words.begin(), words.end(), "--json") != words.end();
  if (!wants_json || has_printed()) return code;
  try {
    print(to_text(error_report(verb_of(words), kind, place, text)));
  } catch (const Error&) {  // where standard output is what cannot be written
  }
  return code;
}

// Allocates nothing.
int complain_of_memory() {
  std::fputs("sunder: out of memory; give smaller files or more memory\n", stderr);
  return exit_code::internal;
}

std::vector<std::string> names_of_options(const CLI::App& verb) {
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

int complain_of_verb(const CLI::App& program, const std::vector<std::string>& words, const std::string& what,
                     const std::string& word) {
  const std::vector<std::string> known = names_of_verbs(program);
  return complain(
      words, exit_code::bad,
      fmt::format("{}{}; verbs are {}; see sunder --help", what, did_you_mean(word, known), fmt::join(known, ", ")));
}

// help, help VERB
int help(const CLI::App& program, const std::vector<std::string>& words) {
  if (words.size() > 2) return complain(words, exit_code::bad, "help: name one verb, or none; see sunder --help");
  if (words.size() == 1) {
    print(program.help());
    return exit_code::no;
  }
  const std::vector<std::string> known = names_of_verbs(program);
  if (std::find(known.begin(), known.end(), words[1]) == known.end())
    return complain_of_verb(program, words, "there is no verb " + io::quote(words[1]), words[1]);
  print(program.get_subcommand(words[1])->help("sunder"));
  return exit_code::no;
}

// What CLI11 found wrong with the call, in one line with a remedy.
int complain(const CLI::App& program, const CLI::ParseError& error, const std::vector<std::string>& words) {
  const auto called = program.get_subcommands();
  if (called.empty()) {
    const auto word =
        std::find_if(words.begin(), words.end(), [](const std::string& w) { return !w.starts_with('-'); });
    const std::string what =
        word != words.end() ? "there is no verb " + io::quote(*word) : "there is no option " + io::quote(words.front());
    return complain_of_verb(program, words, what, word != words.end() ? *word : "");
  }
  const std::string verb = called.front()->get_name();
  std::string what = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    const std::vector<std::string> extra = called.front()->remaining();
    const std::string word = extra.empty() ? "" : extra.front();
    const bool is_option = word.starts_with('-');
    what = (is_option ? "there is no option " : "nothing is expected at ") + io::quote(word) +
           (is_option ? did_you_mean(word, names_of_options(*called.front())) : "");
  }
  return complain(words, exit_code::bad, fmt::format("{}: {}; see sunder {} --help", verb, what, verb));
}

int run_checked(int argc, char** argv, const std::vector<std::string>& words) {
  int code = exit_code::no;
  CLI::App program("Sunder tells whether things meet, and proves it.", "sunder");
  program.set_version_flag("--version", "sunder " SUNDER_VERSION);
  program.require_subcommand(0, 1);
  program.footer("Exit code: 0 apart, none, accepted; 1 meet, some, refused; 2 bad input or call; 3 internal error.");
  for (const AddVerb add : verbs) add(program, code);
  std::string shell;
  bool man = false, quiet = false;
  program.add_option("--completion", shell, "print a script that completes calls in bash, zsh or fish")
      ->type_name("SHELL");
  program.add_flag("--man", man, "print the manual page");
  for (CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; })) {
    verb->get_formatter()->column_width(28);
    verb->add_flag("--quiet", quiet, "print nothing but errors: the exit code is the answer");
    verb->parse_complete_callback([verb, &quiet] {
      const bool is_taken = takes_standard_output(*verb);
      require_apart(*verb);
      if (is_taken || quiet) be_quiet();
    });
  }
  if (!words.empty() && words[0] == "help") return help(program, words);
  try {
    program.parse(argc, argv);
    if (!shell.empty()) {
      print(completion(program, shell));
    } else if (man) {
      print(man_page(program, SUNDER_VERSION));
    } else if (program.get_subcommands().empty()) {
      return complain_of_verb(program, words, "no verb is given", "");
    }
  } catch (const CLI::CallForHelp&) {
    const auto called = program.get_subcommands();
    print(called.empty() ? program.help() : called.front()->help("sunder"));
  } catch (const CLI::CallForVersion& version) {
    print(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& error) {
    return complain(program, error, words);
  }
  return code;
}

}  // namespace

int run(int argc, char** argv) {
  handle_signals();
  std::vector<std::string> words;
  try {
    words.assign(argv + 1, argv + argc);
    return run_checked(argc, argv, words);
  } catch (const Error& error) {
    return complain(words, exit_code::bad, error.what(), kind_of(error.code()), error.place());
  } catch (const std::bad_alloc&) {
    return complain_of_memory();
  } catch (const std::length_error&) {
    return complain_of_memory();
  } catch (const std::exception& error) {
    return complain(words, exit_code::internal, std::string("internal error: ") + error.what() + "; please report it",
                    "internal");
  } catch (...) {
    return complain(words, exit_code::internal, "internal error; please report it", "internal");
  }
}

}  // namespace sunder::cli
