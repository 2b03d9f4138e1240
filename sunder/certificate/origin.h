// Where the tables of a certificate file come from (docs/claims.md, `inputs` and `left_out`). Neither is proved.
#pragma once

#include <string>
#include <vector>

namespace sunder {

// A file that was read.
struct InputFile {
  std::string name;    // as somebody gave it; "-": standard input
  std::string sha256;  // of its bytes: 64 hexadecimal digits (io/sha256.h)
  friend bool operator==(const InputFile&, const InputFile&) = default;
};

using InputFiles = std::vector<InputFile>;

struct Origin {
  InputFiles inputs{};                  // all that the tables were made of
  std::vector<std::string> left_out{};  // what of these the file does not speak of, in words
};

}  // namespace sunder
