// Small pieces of text: numbers as written in files, words quoted in messages, and errors that name their place.
//
// Everything that comes out of a file and goes into a message passes through here, so that a message is one line of
// valid UTF-8 whatever the file holds.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sunder::io {

// The text with every control byte, line separator, mark of the direction of writing (U+202E and the like) and byte
// that is not well-formed UTF-8 written as \xNN.
std::string one_line(std::string_view text);

// The text as one line, cut to 40 bytes (then ending in "..."); quote: in single quotes.
std::string shorten(std::string_view text);
std::string quote(std::string_view text);

// "1 pair", "2 pairs", "2 boxes".
std::string count_of(std::uint64_t n, std::string_view noun);

// "(x, y)", ten digits.
std::string place_text(const Point2& p);

// What parts words within a line, and the text without what of it stands at its ends.
inline constexpr std::string_view blanks = " \t\r\f\v";
std::string_view trimmed(std::string_view text);

// The word with A to Z made small, in any locale.
std::string in_small_letters(std::string_view word);

// The ending of a file's name, in small letters: ".wkt"; empty where there is none.
std::string ending_of(std::string_view file);

// Reads the whole word as a finite decimal number, rounded once to the nearest double (so 1e-400 is 0).
// Forms: what std::from_chars reads, in any locale, and a leading '+'.
// Returns nullptr when `value` was set; otherwise the problem and its remedy, to stand after the quoted word: "is NaN;
// ...", "is infinite; ...", "is too large for a double; ...", "is not a number; ...". Allocates nothing.
const char* parse_number(std::string_view word, double& value);

// Is it a decimal number, also one that is NaN, infinite or beyond the doubles, with anything behind it?
bool is_number(std::string_view word);

// Reads the whole word as a decimal integer, with an optional sign. False when it is none, or does not fit.
bool parse_integer(std::string_view word, std::int64_t& value);

// Throws Error bad_call.
[[noreturn]] void fail_call(const std::string& text, const std::string& place);

// Throw Error bad_file at "FILE", "FILE:LINE", "FILE: byte OFFSET".
[[noreturn]] void fail_file(std::string_view file, const std::string& text);
[[noreturn]] void fail_line(std::string_view file, std::size_t line, const std::string& text);
[[noreturn]] void fail_byte(std::string_view file, std::size_t offset, const std::string& text);

}  // namespace sunder::io
