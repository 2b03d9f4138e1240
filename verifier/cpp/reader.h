// How certificate files are read: numbers, indices and members of objects. Whatever is not as it must be is refused by
// rule F, the form.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sunder_verifier {

using Integer = boost::multiprecision::cpp_int;
using Integers = std::vector<Integer>;
using nlohmann::json;

// A check failed. Never leaves the verifier.
struct Refused {
  std::string check;
  std::string reason;
};

// Checking takes more steps than a file of its size may take. Never leaves the verifier.
struct TooLong {
  std::uint64_t most;
};

// How much work is left of what the file that this thread checks may take: docs/claims.md, "Limits".
void limit_steps(std::size_t bytes);
void lift_limit();
// So many looks at a number of a bits and one of b bits. Throws TooLong.
void take_steps(std::uint64_t looks, std::size_t a, std::size_t b);

// Throws Refused where the condition does not hold.
void require(bool condition, const char* check, const std::string& reason);
[[noreturn]] void refuse_form(const std::string& reason);

// The number n / d * 2^e, with d > 0.
struct Number {
  Integer n;
  Integer d = 1;
  std::int64_t e = 0;
};

using Numbers = std::vector<Number>;

// Numbers brought to a common denominator: each is its integer / d * 2^e, with d > 0.
struct Common {
  Integers integers;
  Integer d = 1;
  std::int64_t e = 0;
};

Common common(const Numbers& values);
Common common_weights(const Numbers& values);  // the same of weights; takes the steps

std::size_t bits(const Integer& n);
std::size_t bits(std::span<const Integer> integers);  // of the longest
std::size_t length(const Numbers& values);            // all bits together, exponents counted as they are

constexpr std::size_t most_weights = 16;               // of one body or polygon; 4 are always enough
constexpr std::size_t most_name = 4000;                // characters
Integer shifted(const Integer& n, std::int64_t bits);  // n * 2^bits; requires bits >= 0

// `where` names the value in a refusal.
Number read_number(const json& value, const std::string& where);
Number read_double(const json& value, const std::string& where);
Numbers read_numbers(const json& value, std::size_t count, Number (*read)(const json&, const std::string&),
                     const std::string& where);
const json& member(const json& item, const char* key, const std::string& where);
const json& list_member(const json& item, const char* key, const std::string& where);
std::string string_member(const json& item, const char* key, const std::string& where);
std::size_t characters(const std::string& text);  // of UTF-8
std::size_t read_index(const json& value, std::size_t size, const std::string& where);
std::size_t index_member(const json& item, const char* key, std::size_t size, const std::string& where);

constexpr std::size_t no_index = static_cast<std::size_t>(-1);

// A list of indices below `size`; of `count` entries, unless that is no_index.
std::vector<std::size_t> index_list(const json& item, const char* key, std::size_t size, std::size_t count,
                                    const std::string& where);

// The rule of a statement, "nothing", "shared-endpoint" or "touch".
std::string read_rule(const json& item, const std::string& where);

// `groups` of an object: a whole number of at most 15 digits for each of `size`.
std::vector<std::int64_t> read_groups(const json& item, std::size_t size, const std::string& where);

bool is_minus_one(const json& value);

}  // namespace sunder_verifier
