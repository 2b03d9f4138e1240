// What a fuzzer demands: else it ends the process, which is its finding.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace sunder::fuzz {

inline void require(bool holds) {
  if (!holds) std::abort();
}

inline void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "fault: %s\n", what.c_str());
  std::abort();
}

}  // namespace sunder::fuzz
