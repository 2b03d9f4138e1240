// Checks certificate files exactly (docs/certificates.md). Knows the format only: no code of the library is used.
// The twin of sunder_verify.py, for large evidence: the same statements, the same checks in the same order.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sunder_verifier {

// What became of one pair of a file, or of one statement.
struct PairResult {
  std::string question;      // of version 2: "pair", ..; then the names are those of two bodies, where it is about two,
                             // else the question, and in words what it is about. Empty in version 1
  std::string name_a;        // the name of the first placed body, as in the file: any UTF-8 text
  std::string name_b;        // the name of the second
  std::string verdict;       // "apart" or "meet", of sets and regions one of their words: stated, not what is true
  bool accepted = false;     // the statement is proved
  std::string failed_check;  // "A1" .. "A3", "M1" .. "M3": the first check that failed; empty if accepted
  std::string reason;        // what failed, in words; empty if accepted
};

// What a file says that its tables were made of.
struct FileInput {
  std::string name;    // any UTF-8 text
  std::string sha256;  // 64 hexadecimal digits
};

// What became of a file. One of three: not readable, wrong in form, or a result for each pair.
struct FileResult {
  bool readable = false;          // the text is JSON, and checking it did not take too long
  std::string error;              // one line with the place; empty if readable
  std::string failed_form;        // check F failed: what, in words; empty otherwise
  std::string note;               // what the file says that it does not speak of: any UTF-8 text, to be printed with
                                  // the verdict, control characters escaped. Empty: none, or failed_form
  std::vector<FileInput> inputs;  // of version 2, to be printed likewise
  std::vector<std::string> left_out;  // of version 2, where there is no note
  std::vector<PairResult> pairs;      // in the order of the file; empty if not readable or wrong in form

  // Readable, right in form, and every pair accepted. True for a file without pairs.
  bool accepted() const;
};

enum class Limit : std::uint8_t {
  none,
  by_size,  // a file that takes more steps than docs/certificates.md allows one of its size is not readable
};

// Checks the text of a certificate file. `place` says where the text is from and starts `error`.
//
// 1. Never throws, whatever the text.
// 2. Needs memory in proportion to the text. Time for a pair: apart, the number of vertices of its two bodies times the
//    length of its direction; meet, at most the square of the length of its own numbers. With a limit, time is in
//    proportion to the text, too. JSON nested more than 500 deep is not readable.
// 3. An accepted pair is proved. A refused one may still be true: only its evidence is wrong.
FileResult verify_text(std::string_view text, std::string_view place, Limit limit = Limit::by_size);

}  // namespace sunder_verifier
