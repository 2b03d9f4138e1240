// The word that was meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sunder::cli {

// How many letters must be put in, left out, changed, or swapped with the next one, to make one word the other; of
// swapped ones none is changed again. Cost: the product of the lengths.
std::size_t edits_between(std::string_view a, std::string_view b);

// The first of the words that is fewest edits from this one: at most two, and fewer than half its letters; or that
// begins with it, if only one does and it has two letters or more. Empty: none.
std::string nearest_word(std::string_view word, std::span<const std::string> words);

// "; did you mean --json?", or nothing.
std::string did_you_mean(std::string_view word, std::span<const std::string> words);

}  // namespace sunder::cli
