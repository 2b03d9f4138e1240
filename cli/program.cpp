#include <cli/answer.h>
#include <cli/call.h>
#include <cli/program.h>
#include <cli/progress.h>

#include <sunder/ask/report.h>
#include <sunder/base/error.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace sunder::cli {

namespace {

namespace exit_code = ask::exit_code;

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

// Standard output, and what is on it. Throws Error bad_call where it cannot be written (a full disk).
void write_out(std::string_view text) {
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (written) return;
  throw Error(ErrorCode::bad_call,
              fmt::format("cannot be written ({}); check where it goes", std::generic_category().message(errno)),
              "standard output");
}

// One line on standard error. What cannot be written there is lost, and that is no error.
void write_error(std::string_view text) {
  const std::string line = fmt::format("sunder: {}\n", io::one_line(text));
  static_cast<void>(std::fwrite(line.data(), 1, line.size(), stderr));
}

ask::Sinks sinks_of_process() {
  const char* packages = std::getenv("ROS_PACKAGE_PATH");
  return {.out = write_out,
          .note = [](std::string_view text) { write_error(fmt::format("note: {}", text)); },
          .error = write_error,
          .progress = progress_on_terminal,
          .has_colours = isatty(STDOUT_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr,
          .package_paths = packages == nullptr ? "" : packages};
}

// A call of the program, and what is known of it.
struct Program {
  std::vector<std::string> words;
  ask::Talk talk{sinks_of_process()};
  Asked asked;

  // One line on standard error; on standard output a report, where the call asks for JSON.
  int complain(int code, const std::string& text, std::string_view kind, const std::string& place) {
    write_error(text);
    if (!asked.json || talk.is_output_in_use() || prints_over_input(words)) return code;
    Json report = ask::error_report(talk, asked.verb, kind, place, text);
    if (asked.verb.empty()) report["verb"] = nullptr;
    try {
      talk.print(ask::to_text(report));
    } catch (const Error&) {  // where standard output is what cannot be written
    }
    return code;
  }
};

// Allocates nothing.
int complain_of_memory() {
  std::fputs("sunder: out of memory; give smaller files or more memory\n", stderr);
  return exit_code::internal;
}

}  // namespace

int run(int argc, char** argv) {
  handle_signals();
  hold_closed_streams();
  try {
    Program program;
    try {
      program.words.assign(argv + 1, argv + argc);
      return answer(program.words, program.talk, program.asked);
    } catch (const Error& error) {
      return program.complain(exit_code::bad, error.what(), name_of(error.code()), error.place());
    } catch (const std::bad_alloc&) {
      return complain_of_memory();
    } catch (const std::length_error&) {
      return complain_of_memory();
    } catch (const std::exception& error) {
      return program.complain(exit_code::internal,
                              std::string("internal error: ") + error.what() + "; please report it", "internal", "");
    } catch (...) {
      return program.complain(exit_code::internal, "internal error; please report it", "internal", "");
    }
  } catch (const std::bad_alloc&) {
    return complain_of_memory();
  }
}

}  // namespace sunder::cli
