// What a statement says, as a sentence: in the same words as the twin's (verifier/python/sunder_verify/sentences.py).
#pragma once

#include <verifier/cpp/json.h>

#include <cstddef>
#include <string>

namespace sunder_verifier {

constexpr std::size_t most_shown = 100;  // characters of a name

// The text, which is UTF-8; of a longer one so many characters, and dots.
std::string shortened(const std::string& text, std::size_t most);
// The same in quotes, as in JSON: one line of ASCII without control characters.
std::string in_quotes(const std::string& text, std::size_t most);

// Of a body with a radius the title is a word for what it is; the name is in quotes; without one there is none.
struct NamedBody {
  std::string title, quoted;
};

// Of a statement whose form is right; the names are those of the bodies a and b, or of the one that it is about, as the
// first. One line of ASCII.
std::string sentence_of(const Json& item, const NamedBody& a, const NamedBody& b);

}  // namespace sunder_verifier
