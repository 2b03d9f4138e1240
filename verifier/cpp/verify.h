// Checks certificate files exactly (docs/claims.md). Knows the format only: no code of the library is used. The twin of
// the Python package sunder_verify, for large evidence: the same statements, the same rules in the same order.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sunder_verifier {

// What became of one statement of a file.
struct StatementResult {
  std::string question;   // "pair", ..
  std::string name_a;     // of one that is refused, where it is about two bodies the name of the first, UTF-8, cut as
                          // in sentences; else the question
  std::string name_b;     // the name of the second; else the sentence
  std::string sentence;   // what is stated, in words: one line of ASCII
  std::string verdict;    // stated, not what is true
  bool accepted = false;  // the statement is proved
  std::string failed_check;  // the first rule that failed; empty if accepted
  std::string reason;        // what failed, in words; empty if accepted
};

// Does the format have a statement of this question with this verdict?
bool is_verdict_of(std::string_view question, std::string_view verdict);

// What a file says that its tables were made of.
struct FileInput {
  std::string name;    // any UTF-8 text
  std::string sha256;  // 64 hexadecimal digits
};

// What became of a file. One of three: not readable, wrong in form, or a result for each statement.
struct FileResult {
  bool readable = false;                    // the text is JSON, and checking it did not take too long
  std::string error;                        // one line with the place; empty if readable
  std::string failed_form;                  // rule F failed: what, in words; empty otherwise
  std::vector<FileInput> inputs;            // to be printed with the verdict, control characters escaped
  std::vector<std::string> call;            // likewise: the words that it was made by
  std::vector<std::string> left_out;        // likewise: what the file does not speak of
  std::vector<StatementResult> statements;  // in the order of the file; empty if not readable or wrong in form

  // Readable, right in form, and every statement accepted.
  bool accepted() const;
};

enum class Limit : std::uint8_t {
  none,
  by_size,  // a file that takes more steps than docs/claims.md allows one of its size is not readable
};

// Checks the text of a certificate file. `place` says where the text is from and starts `error`.
//
// 1. Throws only std::bad_alloc and std::length_error, where memory runs out, whatever the text.
// 2. Needs memory in proportion to the text; with a limit, time, too. JSON nested more than 500 deep is not readable.
// 3. An accepted statement is proved. A refused one may still be true: only its evidence is wrong.
FileResult verify_text(std::string_view text, std::string_view place, Limit limit = Limit::by_size);

}  // namespace sunder_verifier
