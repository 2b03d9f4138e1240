// What a statement says, as a sentence: in the same words as the twin's (verifier/python/sunder_verify/sentences.py).
#pragma once

#include <verifier/cpp/json.h>

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace sunder_verifier {

constexpr std::size_t most_shown = 100;  // characters of a name

// The text, which is UTF-8; of a longer one so many characters, and dots.
std::string shortened(const std::string& text, std::size_t most);
// The same in quotes, as in JSON: one line of ASCII without control characters.
std::string in_quotes(const std::string& text, std::size_t most = most_shown);

// A word, a number, a point of numbers as they stand in the file, or a list of entries.
std::string shown(const Json& value);

// "1 box", "2 boxes".
std::string counted(std::size_t n, std::string_view one);

using Words = std::map<std::string, std::string>;

// The text, with words in the place of {their names}.
std::string filled(const std::string& text, const Words& words);

// What a statement is about: a body, say. Without a title there is none.
struct Thing {
  std::string title;   // what it is, of how many points, and its name
  std::string quoted;  // its name
  std::string said;    // what it is said to be made of; empty: nothing
};

// The text, filled with the members of a statement whose form is right, about a and b, or about one thing, which is a,
// or about the table, of so many entries. One line of ASCII.
std::string sentence_of(const Json& item, const std::string& text, const Thing& a, const Thing& b,
                        const std::string& table, std::size_t size);

}  // namespace sunder_verifier
