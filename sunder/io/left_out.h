// What a file holds and a reader does not take, for readers and those who ask them.
#pragma once

#include <cstdint>
#include <string>

namespace sunder::io {

// Things of one kind that were not taken. An answer about the rest is silent about them, so callers must show them.
struct LeftOut {
  std::string kind;         // a noun in the singular, in one line of UTF-8: "cylinder", "line"
  std::string of;           // the name of what they belong to, such as a link; empty: the file
  std::uint64_t count = 1;  // at least 1
};

}  // namespace sunder::io
