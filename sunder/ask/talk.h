// A call that is being answered: where its words go, and what has been said. Nothing here knows a terminal, a stream of
// the process or the environment: who makes the call has those, and gives what it wants to be told of.
#pragma once

#include <sunder/certificate/claims.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::ask {

// What takes the words of an answer. Each may be empty: then nobody wants to hear. What they throw ends the call.
struct Sinks {
  TextSink out{};    // the answer, in pieces
  TextSink note{};   // a line beside it, as soon as it is known
  TextSink error{};  // a line: a part of the call that failed, where others follow

  // Called when a long piece of work begins ("reading"). What it returns is called now and then with the part that is
  // done, 0 to 1, and dies with the work. It may be empty, too.
  std::function<std::function<void(double)>(std::string_view what)> progress{};

  // Returns the sink that takes the text of the output of this name. If it is empty, the text goes to a file of that
  // name.
  std::function<TextSink(const std::filesystem::path&)> file{};

  bool has_colours = false;     // may the text for people have colours of terminals?
  std::string package_paths{};  // folders to search for packages of robots, with colons between
};

class Talk {
 public:
  explicit Talk(Sinks sinks) : sinks_(std::move(sinks)) {}
  Talk(const Talk&) = delete;
  Talk& operator=(const Talk&) = delete;

  const Sinks& sinks() const { return sinks_; }

  void print(std::string_view text);

  // The same for people: what a terminal might obey (control bytes, but for line feeds) goes as \xNN. Names that may
  // hold line feeds are made one line before: io::one_line. has_colours: the text has no control bytes but its own.
  void print_for_people(std::string_view text, bool has_colours = false);

  // A remark, which stands in reports that are made after it, too.
  void note(std::string_view text);
  void note_all(const std::vector<std::string>& texts);
  void complain(std::string_view text);

  const std::vector<std::string>& notes() const { return notes_; }
  std::function<void(double)> progress(std::string_view what) const;

  // Writes the text to the file of this name: whole, or not at all. Of other writers `instead` goes with the name.
  void write_file(const std::string& name, std::string_view text) const;
  TextSink instead(const std::filesystem::path& name) const;

  // From now on only errors are reported, and the exit code is the answer (--quiet).
  void be_quiet();
  bool is_quiet() const { return is_quiet_; }

  // From now on nothing is printed for people: `out` has another use.
  void leave_output() { leaves_output_ = true; }

  // Has `out` another use, or has anything been printed, a part of a report perhaps?
  bool is_output_in_use() const { return leaves_output_ || has_printed_; }

  std::vector<std::string> words;  // of the call, as its proofs have them (call_words.h)

 private:
  Sinks sinks_;
  std::vector<std::string> notes_;
  bool is_quiet_ = false, leaves_output_ = false, has_printed_ = false;
};

}  // namespace sunder::ask
