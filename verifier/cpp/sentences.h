// What a statement says, as a sentence: in the same words as the twin's (verifier/python/sunder_verify/sentences.py).
#pragma once

#include <verifier/cpp/json.h>

#include <string>

namespace sunder_verifier {

// Of a body with a radius the title is a word for what it is; without a name there is none.
struct NamedBody {
  std::string title, name;
};

// Of a statement whose form is right; the names are those of the bodies a and b, or of the one that it is about, as the
// first. One line of ASCII.
std::string sentence_of(const Json& item, const NamedBody& a, const NamedBody& b);

}  // namespace sunder_verifier
