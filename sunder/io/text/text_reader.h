// Walks over text line by line and word by word, and knows where it is when something is wrong.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sunder::io {

// A line ends with LF, CR LF or CR. Words are parted by spaces, tabs and other blanks; a word that begins with '#' ends
// the line where comments are on. A byte order mark at the beginning is skipped.
// The reader keeps views of `text` and `file`; both must outlive it. Words are views of the text. Cost: linear.
class TextReader {
 public:
  struct Options {
    bool comments = false;   // '#' to the end of the line
    bool continued = false;  // a backslash at the end of a line joins the next line to it (not inside a comment)
  };

  // file: its name, for messages.
  TextReader(std::string_view text, std::string_view file, Options options);

  // Goes to the next line that has a word (the first one to begin with), over what is left of this line.
  // False, and it stays at the last line, when there is none.
  bool next_line();

  // The next word of this line; empty at its end.
  std::string_view word();

  // The next word of this line or of a later one; empty at the end of the text.
  std::string_view word_of_any_line();

  // What is left of this line, without blanks around it and with comments.
  std::string_view rest_of_line();

  // The next word as a number. `what` names it in the message: "x".
  double number(std::string_view what);

  // The next three words as a point; `what` names it in the message: "vertex".
  Point3 point(std::string_view what);

  // The next word as an integer from `lowest` to `highest`.
  std::int64_t integer(std::string_view what, std::int64_t lowest, std::int64_t highest);

  // The word as a number, wherever it came from.
  double to_number(std::string_view word, std::string_view what) const;

  // 1 for the first line.
  std::size_t line() const { return line_; }

  // Where the line after this one begins.
  std::size_t end_of_line() const;

  // Throws Error bad_file: "FILE:LINE: text".
  [[noreturn]] void fail(const std::string& text) const;

 private:
  std::size_t after_break(std::size_t at) const;         // behind the line break at `at`, or `at`
  std::size_t after_continuation(std::size_t at) const;  // behind the backslash and line break at `at`, or `at`
  void skip_blanks();
  bool at_end_of_line() const;

  std::string_view text_, file_;
  Options options_;
  std::size_t at_ = 0, line_ = 1;
  bool begun_ = false;
};

}  // namespace sunder::io
