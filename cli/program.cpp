#include <cli/common.h>
#include <cli/outputs.h>
#include <cli/program.h>

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

int complain(int code, const std::string& text) {
  fmt::print(stderr, "sunder: {}\n", io::one_line(text));
  return code;
}

// Allocates nothing.
int complain_of_memory() {
  std::fputs("sunder: out of memory; give smaller files or more memory\n", stderr);
  return exit_code::internal;
}

std::string names_of_verbs(const CLI::App& program) {
  std::string names;
  for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; })) {
    names += (names.empty() ? "" : ", ") + verb->get_name();
  }
  return names;
}

// What CLI11 found wrong with the call, in one line with a remedy.
int complain(const CLI::App& program, const CLI::ParseError& error, const std::vector<std::string>& words) {
  const auto called = program.get_subcommands();
  if (called.empty()) {
    const auto word =
        std::find_if(words.begin(), words.end(), [](const std::string& w) { return !w.starts_with('-'); });
    const bool verb_missing = word == words.end() && words.empty();
    const std::string what = verb_missing          ? "no verb is given"
                             : word != words.end() ? "there is no verb " + io::quote(*word)
                                                   : "there is no option " + io::quote(words.front());
    return complain(exit_code::bad, fmt::format("{}; verbs are {}; see sunder --help", what, names_of_verbs(program)));
  }
  const std::string verb = called.front()->get_name();
  std::string what = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    const std::vector<std::string> extra = called.front()->remaining();
    const std::string word = extra.empty() ? "" : extra.front();
    what = (word.starts_with('-') ? "there is no option " : "nothing is expected at ") + io::quote(word);
  }
  return complain(exit_code::bad, fmt::format("{}: {}; see sunder {} --help", verb, what, verb));
}

int run_checked(int argc, char** argv) {
  int code = exit_code::no;
  CLI::App program("Sunder tells whether things meet, and proves it.", "sunder");
  program.set_version_flag("--version", "sunder " SUNDER_VERSION);
  program.require_subcommand(1);
  program.footer("Exit code: 0 apart, none, accepted; 1 meet, some, refused; 2 bad input or call; 3 internal error.");
  for (const AddVerb add : verbs) add(program, code);
  for (CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; })) {
    verb->get_formatter()->column_width(28);
    verb->parse_complete_callback([verb] { require_apart(*verb); });
  }
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) words.emplace_back(argv[i]);
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    const auto called = program.get_subcommands();
    print(called.empty() ? program.help() : called.front()->help());
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
  try {
    return run_checked(argc, argv);
  } catch (const Error& error) {
    return complain(exit_code::bad, error.what());
  } catch (const std::bad_alloc&) {
    return complain_of_memory();
  } catch (const std::length_error&) {
    return complain_of_memory();
  } catch (const std::exception& error) {
    return complain(exit_code::internal, std::string("internal error: ") + error.what() + "; please report it");
  } catch (...) {
    return complain(exit_code::internal, "internal error; please report it");
  }
}

}  // namespace sunder::cli
