// A call as words: a verb, its options and its files; or help, version, completions, the manual page.
#pragma once

#include <sunder/ask/talk.h>

#include <span>
#include <string>

namespace sunder::cli {

// What is asked for, as far as the words tell.
struct Asked {
  std::string verb;  // empty: none that there is
  bool json = false;
};

// Answers the call. Returns the exit code. asked: what is known, also where it throws.
// Throws Error bad_call for words that are no call, in one line with a remedy; Error for bad input.
int answer(std::span<const std::string> words, ask::Talk& talk, Asked& asked);

}  // namespace sunder::cli
