// How certificate files are read: numbers, indices and members of objects, for the parts of the C++ verifier. Whatever
// is not as it must be is refused by check F.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
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
Integer shifted(const Integer& n, std::int64_t bits);  // n * 2^bits; requires bits >= 0

// `where` names the value in a refusal.
Number read_number(const json& value, const std::string& where);
Number read_double(const json& value, const std::string& where);
Numbers read_numbers(const json& value, std::size_t count, Number (*read)(const json&, const std::string&),
                     const std::string& where);
const json& member(const json& item, const char* key, const std::string& where);
const json& list_member(const json& item, const char* key, const std::string& where);
std::string string_member(const json& item, const char* key, const std::string& where);
std::size_t read_index(const json& value, std::size_t size, const std::string& where);
std::size_t index_member(const json& item, const char* key, std::size_t size, const std::string& where);

}  // namespace sunder_verifier
