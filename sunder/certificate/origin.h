// Where the tables of a certificate file come from (docs/claims.md, `inputs`, `call`, `left_out` and
// `said`). Nothing of it is proved.
#pragma once

#include <sunder/certificate/said.h>

#include <string>
#include <vector>

namespace sunder {

// A file that was read.
struct InputFile {
  std::string name;    // as somebody gave it; "-": standard input
  std::string sha256;  // of its bytes: 64 hexadecimal digits (io/text/sha256.h)
  friend bool operator==(const InputFile&, const InputFile&) = default;
};

using InputFiles = std::vector<InputFile>;

struct Origin {
  InputFiles inputs{};                  // all that the tables were made of
  std::vector<std::string> left_out{};  // what of these the file does not speak of, in words
  std::vector<std::string> call{};      // the words of the call that say how these are read
  std::vector<SaidOfRows> said{};       // what the entries of tables of rows are made of
};

}  // namespace sunder
