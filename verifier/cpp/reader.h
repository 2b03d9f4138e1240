// Values, lists and members as a certificate file must have them. Whatever is not so is refused by rule F; `where`
// names the value in the refusal.
#pragma once

#include <verifier/cpp/json.h>
#include <verifier/cpp/numbers.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sunder_verifier {

constexpr std::size_t most_weights = 16;  // of one body or polygon; d + 1 are always enough
constexpr std::size_t most_multipliers = 64;
constexpr std::size_t most_of_half_spaces = 256;
constexpr std::size_t most_name = 4000;                   // characters
constexpr std::size_t most_number = 999'999'999'999'999;  // all readers of JSON agree about numbers up to this

// A double that is a number: n * 2^e, with n odd or zero.
struct Double {
  std::int64_t n = 0, e = 0;
};

using Doubles = std::vector<Double>;

Number number_of(const Double& value);

Number read_number(const Json& value, const std::string& where);
Double read_double(const Json& value, const std::string& where);
Numbers read_numbers(const Json& value, std::size_t count, const std::string& where);
Doubles read_doubles(const Json& value, std::size_t count, const std::string& where);
// Doubles read_doubles(value, count, where[k]), added to the others.
void add_doubles(const Json& value, std::size_t count, const std::string& where, std::size_t k, Doubles& doubles);

const Json& member(const Json& item, const char* key, const std::string& where);
const Json& list_member(const Json& item, const char* key, const std::string& where);
std::string string_member(const Json& item, const char* key, const std::string& where);
// A string of 1 to most_name characters.
std::string read_text(const Json& value, const std::string& where);
std::string text_member(const Json& item, const char* key, const std::string& where);
std::size_t read_index(const Json& value, std::size_t size, const std::string& where);
std::size_t index_member(const Json& item, const char* key, std::size_t size, const std::string& where);

std::size_t characters(std::string_view text);  // of UTF-8

bool is_minus_one(const Json& value);

constexpr std::size_t no_index = static_cast<std::size_t>(-1);

// Requires that it is one.
const Json& as_list(const Json& value, const std::string& where);
const Json& as_list(const Json&& value, const std::string& where) = delete;

// A list of indices below `size`; of `count` entries, unless that is no_index.
std::vector<std::size_t> read_indices(const Json& value, std::size_t size, const std::string& where,
                                      std::size_t count = no_index);

// An object has these members, and besides at most those.
void require_members(const Json& item, const std::vector<std::string>& needed, const std::vector<std::string>& allowed,
                     const std::string& where);

}  // namespace sunder_verifier
