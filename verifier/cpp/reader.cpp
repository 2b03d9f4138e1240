#include <verifier/cpp/reader.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <string_view>

namespace sunder_verifier {
namespace {

constexpr std::size_t most_characters = 20000;  // of a number
constexpr std::int64_t most_exponent = 20000;   // E of a hexadecimal number, either sign

// The value of each character as a digit; 16: it is none.
constexpr std::array<std::uint8_t, 256> digit_values = [] {
  std::array<std::uint8_t, 256> values{};
  values.fill(16);
  for (std::uint8_t k = 0; k < 10; ++k) values['0' + std::size_t{k}] = k;
  for (std::uint8_t k = 10; k < 16; ++k) values['a' + std::size_t{k} - 10] = values['A' + std::size_t{k} - 10] = k;
  return values;
}();

unsigned digit_value(char c) { return digit_values[static_cast<unsigned char>(c)]; }

// Takes the longest run of digits off the front of text.
std::string_view take_digits(std::string_view& text, unsigned base) {
  std::size_t length = 0;
  while (length < text.size() && digit_value(text[length]) < base) ++length;
  const std::string_view digits = text.substr(0, length);
  text.remove_prefix(length);
  return digits;
}

bool take(std::string_view& text, std::string_view expected) {
  if (!text.starts_with(expected)) return false;
  text.remove_prefix(expected.size());
  return true;
}

// A text -?0xH(.H)?pE, in its parts.
struct Hexadecimal {
  bool is_negative = false;
  std::string_view whole, fraction;
  std::int64_t exponent = 0;  // beyond most_exponent: something beyond it
};

// False: it is not of this form.
bool parse(std::string_view text, Hexadecimal& parts) {
  parts.is_negative = take(text, "-");
  if (!take(text, "0x")) return false;
  parts.whole = take_digits(text, 16);
  const bool point = take(text, ".");
  parts.fraction = point ? take_digits(text, 16) : std::string_view();
  if (parts.whole.empty() || (point && parts.fraction.empty()) || !take(text, "p")) return false;
  const bool is_down = take(text, "-");
  if (!is_down) take(text, "+");
  const std::string_view exponent = take_digits(text, 10);
  if (exponent.empty() || !text.empty()) return false;
  for (const char c : exponent) {
    parts.exponent = std::min<std::int64_t>(10 * parts.exponent + (c - '0'), most_exponent + 1);
  }
  if (is_down) parts.exponent = -parts.exponent;
  return true;
}

bool has_small_exponent(const Hexadecimal& parts) { return std::abs(parts.exponent) <= most_exponent; }

// n, followed by more digits, which are hexadecimal. False: they do not fit, but for zeros at the end; these are
// counted.
bool append_digits(std::string_view digits, std::uint64_t& n, std::size_t& zeros) {
  for (const char c : digits) {
    ++zeros;
    const unsigned digit = digit_value(c);
    if (digit == 0) continue;
    if (n != 0 && (zeros >= 16 || n >> (64 - 4 * zeros) != 0)) return false;
    n = (n == 0 ? 0 : n << 4 * zeros) | digit;
    zeros = 0;
  }
  return true;
}

// False: the text is no double in hexadecimal form.
bool parse_double(std::string_view text, Double& number) {
  Hexadecimal parts;
  std::uint64_t n = 0;
  std::size_t zeros = 0;  // digits behind those of n
  if (text.size() > most_characters || !parse(text, parts) || !has_small_exponent(parts)) return false;
  if (!append_digits(parts.whole, n, zeros) || !append_digits(parts.fraction, n, zeros)) return false;
  number = {};
  if (n == 0) return true;
  const int down = std::countr_zero(n);
  n >>= down;
  number.n = static_cast<std::int64_t>(n);
  number.e =
      parts.exponent + 4 * (static_cast<std::int64_t>(zeros) - static_cast<std::int64_t>(parts.fraction.size())) + down;
  if (parts.is_negative) number.n = -number.n;
  return std::bit_width(n) <= 53 && number.e >= -1074 &&
         static_cast<std::int64_t>(std::bit_width(n)) + number.e <= 1024;
}

// value, followed by more digits.
Integer append_digits(Integer value, std::string_view digits, unsigned base) {
  while (!digits.empty()) {
    std::int64_t chunk = 0, scale = 1;
    const std::size_t length = std::min<std::size_t>(digits.size(), 15);  // 16^15 < 2^63
    for (const char c : digits.substr(0, length)) {
      chunk = chunk * base + digit_value(c);
      scale *= base;
    }
    value *= scale;
    value += chunk;
    digits.remove_prefix(length);
  }
  return value;
}

Number number_of(const Hexadecimal& parts) {
  Number number;
  number.n = append_digits(append_digits(0, parts.whole, 16), parts.fraction, 16);
  number.e = parts.exponent - 4 * static_cast<std::int64_t>(parts.fraction.size());
  if (number.n == 0) return number;
  const unsigned zeros = boost::multiprecision::lsb(number.n);
  number.n >>= zeros;
  number.e += zeros;
  if (parts.is_negative) number.n = -number.n;
  return number;
}

// D or D/D. False: not of this form.
bool parse(std::string_view text, Number& number) {
  const bool is_negative = take(text, "-");
  const std::string_view above = take_digits(text, 10);
  const bool slash = take(text, "/");
  const std::string_view below = slash ? take_digits(text, 10) : std::string_view("1");
  if (above.empty() || below.empty() || !text.empty()) return false;
  number.n = append_digits(0, above, 10);
  number.d = append_digits(0, below, 10);
  if (is_negative) number.n = -number.n;
  return true;
}

void require_list(const Json& value, std::size_t count, const std::string& where) {
  if (!value.is_array() || value.size() != count) refuse_form(where + " is not a list of " + std::to_string(count));
}

}  // namespace

Number number_of(const Double& value) {
  Number number;
  number.n = value.n;
  number.e = value.e;
  return number;
}

Number read_number(const Json& value, const std::string& where) {
  if (!value.is_string() || value.size() > most_characters) refuse_form(where + " is not a number as a string");
  Hexadecimal parts;
  if (parse(value.text(), parts)) {
    if (!has_small_exponent(parts)) refuse_form(where + " has too large an exponent");
    return number_of(parts);
  }
  Number number;
  if (!parse(value.text(), number)) refuse_form(where + " is not a number of one of the three forms");
  if (number.d == 0) refuse_form(where + " has denominator zero");
  return number;
}

Double read_double(const Json& value, const std::string& where) {
  Double number;
  if (value.is_string() && parse_double(value.text(), number)) return number;
  read_number(value, where);  // refuses what is no number at all
  refuse_form(where + " is not a hexadecimal double");
}

Numbers read_numbers(const Json& value, std::size_t count, const std::string& where) {
  require_list(value, count, where);
  Numbers result;
  for (const Json& entry : value) result.push_back(read_number(entry, where));
  return result;
}

Doubles read_doubles(const Json& value, std::size_t count, const std::string& where) {
  require_list(value, count, where);
  Doubles result;
  for (const Json& entry : value) result.push_back(read_double(entry, where));
  return result;
}

void add_doubles(const Json& value, std::size_t count, const std::string& where, std::size_t k, Doubles& doubles) {
  const std::size_t size = doubles.size();
  bool are_doubles = value.is_array() && value.size() == count;
  for (auto entry = value.begin(); are_doubles && entry != value.end(); ++entry) {
    are_doubles = (*entry).is_string() && parse_double((*entry).text(), doubles.emplace_back());
  }
  if (are_doubles) return;
  doubles.resize(size);  // what is wrong, in words
  const Doubles row = read_doubles(value, count, where + "[" + std::to_string(k) + "]");
  doubles.insert(doubles.end(), row.begin(), row.end());
}

const Json& member(const Json& item, const char* key, const std::string& where) {
  if (!item.is_object()) refuse_form(where + " is not an object");
  const Json* found = item.find(key);
  if (found == nullptr) refuse_form(where + " has no " + key);
  return *found;
}

const Json& as_list(const Json& value, const std::string& where) {
  if (!value.is_array()) refuse_form(where + " is not a list");
  return value;  // NOLINT(bugprone-return-const-ref-from-parameter): temporaries are refused
}

const Json& list_member(const Json& item, const char* key, const std::string& where) {
  return as_list(member(item, key, where), where + "." + key);
}

std::string string_member(const Json& item, const char* key, const std::string& where) {
  const Json& value = member(item, key, where);
  if (!value.is_string()) refuse_form(where + "." + key + " is not a string");
  return std::string(value.text());
}

std::string read_text(const Json& value, const std::string& where) {
  const std::size_t size = value.is_string() ? characters(value.text()) : 0;
  if (size == 0 || size > most_name) {
    refuse_form(where + " is not a text of 1 to " + std::to_string(most_name) + " characters");
  }
  return std::string(value.text());
}

std::string text_member(const Json& item, const char* key, const std::string& where) {
  return read_text(member(item, key, where), where + "." + key);
}

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::size_t read_index(const Json& value, std::size_t size, const std::string& where) {
  const bool in_range =
      value.is_integer() && value.integer() >= 0 && static_cast<std::uint64_t>(value.integer()) < size;
  if (!in_range) refuse_form(where + " is not an index in range");
  return static_cast<std::size_t>(value.integer());
}

std::size_t index_member(const Json& item, const char* key, std::size_t size, const std::string& where) {
  return read_index(member(item, key, where), size, where + "." + key);
}

bool is_minus_one(const Json& value) { return value.is_integer() && value.integer() == -1; }

std::vector<std::size_t> read_indices(const Json& value, std::size_t size, const std::string& where,
                                      std::size_t count) {
  std::vector<std::size_t> result;
  const std::string entry_where = where + " entry";
  as_list(value, where);
  if (count != no_index) require_list(value, count, where);
  for (const Json& entry : value) result.push_back(read_index(entry, size, entry_where));
  return result;
}

void require_members(const Json& item, const std::vector<std::string>& needed, const std::vector<std::string>& allowed,
                     const std::string& where) {
  if (!item.is_object()) refuse_form(where + " is not an object");
  const auto is_in = [](const std::vector<std::string>& keys, std::string_view key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  for (const auto& [key, value] : item.members()) {
    if (is_in(needed, key) || is_in(allowed, key)) continue;
    refuse_form(where + " has \"" + std::string(key) + "\", which means nothing");
  }
  for (const std::string& key : needed) {
    if (!item.contains(key)) refuse_form(where + " has no " + key);
  }
}

}  // namespace sunder_verifier
