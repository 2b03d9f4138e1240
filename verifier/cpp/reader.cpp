#include <verifier/cpp/reader.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string_view>

namespace sunder_verifier {

void require(bool condition, const char* check, const std::string& reason) {
  if (!condition) throw Refused{check, reason};
}

void refuse_form(const std::string& reason) { throw Refused{"F", reason}; }

Integer shifted(const Integer& n, std::int64_t bits) { return n << static_cast<unsigned>(bits); }  // bits >= 0

namespace {

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();
thread_local std::uint64_t most_steps = no_limit, steps_left = no_limit;

}  // namespace

void limit_steps(std::size_t bytes) { most_steps = steps_left = 300 * std::max<std::uint64_t>(bytes, 1'000'000); }

void lift_limit() { most_steps = steps_left = no_limit; }

void take_steps(std::uint64_t looks, std::size_t a, std::size_t b) {
  if (steps_left == no_limit) return;
  const std::uint64_t steps = looks * (16 + std::uint64_t{a / 64 + 1} * (b / 64 + 1));
  if (steps > steps_left) throw TooLong{most_steps};
  steps_left -= steps;
}

std::size_t bits(const Integer& n) { return n == 0 ? 0 : boost::multiprecision::msb(abs(n)) + std::size_t{1}; }

std::size_t bits(std::span<const Integer> integers) {
  std::size_t most = 0;
  for (const Integer& n : integers) most = std::max(most, bits(n));
  return most;
}

std::size_t length(const Numbers& values) {
  std::size_t sum = 0;
  for (const Number& value : values) sum += bits(value.n) + bits(value.d) + static_cast<std::size_t>(std::abs(value.e));
  return sum;
}

Common common_weights(const Numbers& values) {
  const std::size_t whole = length(values);
  take_steps(values.size() / 4 + 1, whole, whole);
  return common(values);
}

Common common(const Numbers& values) {
  Common result;
  bool first = true;
  for (const Number& value : values) {
    if (value.n != 0 && (first || value.e < result.e)) {
      result.e = value.e;
      first = false;
    }
  }
  for (const Number& value : values) {
    if (value.d != 1) {
      for (Integer& integer : result.integers) integer *= value.d;
    }
    const Integer scaled = value.n * result.d;
    result.integers.push_back(value.n == 0 ? Integer(0) : shifted(scaled, value.e - result.e));
    result.d *= value.d;
  }
  return result;
}

namespace {

constexpr std::size_t kMaxCharacters = 20000;  // of a number
constexpr std::int64_t kMaxExponent = 20000;   // E of a hexadecimal number, either sign

bool is_digit(char c, int base) {
  const bool letter = (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
  return (c >= '0' && c <= '9') || (base == 16 && letter);
}

int digit_value(char c) {
  if (c >= 'a') return c - 'a' + 10;
  if (c >= 'A') return c - 'A' + 10;
  return c - '0';
}

// Takes the longest run of digits off the front of text.
std::string_view take_digits(std::string_view& text, int base) {
  std::size_t length = 0;
  while (length < text.size() && is_digit(text[length], base)) ++length;
  const std::string_view digits = text.substr(0, length);
  text.remove_prefix(length);
  return digits;
}

bool take(std::string_view& text, std::string_view expected) {
  if (text.substr(0, expected.size()) != expected) return false;
  text.remove_prefix(expected.size());
  return true;
}

// value, followed by more digits.
Integer append_digits(Integer value, std::string_view digits, int base) {
  while (!digits.empty()) {
    std::int64_t chunk = 0, scale = 1;
    const std::size_t length = std::min<std::size_t>(digits.size(), 15);  // 16^15 < 2^63
    for (char c : digits.substr(0, length)) {
      chunk = chunk * base + digit_value(c);
      scale *= base;
    }
    value *= scale;
    value += chunk;
    digits.remove_prefix(length);
  }
  return value;
}

// (hexadecimal integer or fraction) p E. The result's n is odd or zero. False: not of this form.
bool parse_hexadecimal(std::string_view text, Number& number, const std::string& where) {
  const bool negative = take(text, "-");
  if (!take(text, "0x")) return false;
  const std::string_view whole = take_digits(text, 16);
  const bool point = take(text, ".");
  const std::string_view fraction = point ? take_digits(text, 16) : std::string_view();
  if (whole.empty() || (point && fraction.empty()) || !take(text, "p")) return false;
  const bool negative_exponent = take(text, "-");
  if (!negative_exponent) take(text, "+");
  const std::string_view exponent = take_digits(text, 10);
  if (exponent.empty() || !text.empty()) return false;
  std::int64_t e = 0;
  for (char c : exponent) {
    e = 10 * e + digit_value(c);
    if (e > kMaxExponent) refuse_form(where + " has too large an exponent");
  }
  number.n = append_digits(append_digits(0, whole, 16), fraction, 16);
  number.d = 1;
  number.e = (negative_exponent ? -e : e) - 4 * static_cast<std::int64_t>(fraction.size());
  if (number.n != 0) {
    const unsigned zeros = boost::multiprecision::lsb(number.n);
    number.n >>= zeros;
    number.e += zeros;
    if (negative) number.n = -number.n;
  }
  return true;
}

// D or D/D. False: not of this form.
bool parse_decimal(std::string_view text, Number& number, const std::string& where) {
  const bool negative = take(text, "-");
  const std::string_view above = take_digits(text, 10);
  const bool slash = take(text, "/");
  const std::string_view below = slash ? take_digits(text, 10) : std::string_view("1");
  if (above.empty() || below.empty() || !text.empty()) return false;
  number.n = append_digits(0, above, 10);
  number.d = append_digits(0, below, 10);
  number.e = 0;
  if (negative) number.n = -number.n;
  if (number.d == 0) refuse_form(where + " has denominator zero");
  return true;
}

}  // namespace

Number read_number(const json& value, const std::string& where) {
  const auto* text = value.get_ptr<const std::string*>();
  if (text == nullptr || text->size() > kMaxCharacters) refuse_form(where + " is not a number as a string");
  Number number;
  if (!parse_hexadecimal(*text, number, where) && !parse_decimal(*text, number, where)) {
    refuse_form(where + " is not a number of one of the three forms");
  }
  return number;
}

Number read_double(const json& value, const std::string& where) {
  const Number number = read_number(value, where);
  bool is_double = value.get_ref<const std::string&>().find('x') != std::string::npos;
  if (number.n != 0) {
    const std::int64_t bits = static_cast<std::int64_t>(boost::multiprecision::msb(abs(number.n))) + 1;
    is_double = is_double && bits <= 53 && number.e >= -1074 && bits + number.e <= 1024;
  }
  if (!is_double) refuse_form(where + " is not a hexadecimal double");
  return number;
}

Numbers read_numbers(const json& value, std::size_t count, Number (*read)(const json&, const std::string&),
                     const std::string& where) {
  if (!value.is_array() || value.size() != count) {
    refuse_form(where + " is not a list of " + std::to_string(count));
  }
  Numbers result;
  for (const json& item : value) result.push_back(read(item, where));
  return result;
}

const json& member(const json& item, const char* key, const std::string& where) {
  if (!item.is_object()) refuse_form(where + " is not an object");
  const auto found = item.find(key);
  if (found == item.end()) refuse_form(where + " has no " + key);
  return *found;
}

const json& list_member(const json& item, const char* key, const std::string& where) {
  const json& value = member(item, key, where);
  if (!value.is_array()) refuse_form(where + "." + key + " is not a list");
  return value;
}

std::string string_member(const json& item, const char* key, const std::string& where) {
  const json& value = member(item, key, where);
  if (!value.is_string()) refuse_form(where + "." + key + " is not a string");
  return value.get<std::string>();
}

std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::size_t read_index(const json& value, std::size_t size, const std::string& where) {
  const bool in_range = value.is_number_integer() && (value.is_number_unsigned() || value.get<std::int64_t>() >= 0) &&
                        value.get<std::uint64_t>() < size;
  if (!in_range) refuse_form(where + " is not an index in range");
  return value.get<std::size_t>();
}

std::size_t index_member(const json& item, const char* key, std::size_t size, const std::string& where) {
  return read_index(member(item, key, where), size, where + "." + key);
}

namespace {

const json& list_of(const json& item, const char* key, std::size_t count, const std::string& where) {
  const json& list = list_member(item, key, where);
  if (count != no_index && list.size() != count) {
    refuse_form(where + "." + key + " is not a list of " + std::to_string(count));
  }
  return list;
}

}  // namespace

std::vector<std::size_t> index_list(const json& item, const char* key, std::size_t size, std::size_t count,
                                    const std::string& where) {
  std::vector<std::size_t> result;
  const std::string entry_where = where + "." + key + " entry";
  for (const json& entry : list_of(item, key, count, where)) result.push_back(read_index(entry, size, entry_where));
  return result;
}

std::string read_rule(const json& item, const std::string& where) {
  std::string rule = string_member(item, "allowed", where);
  if (rule != "nothing" && rule != "shared-endpoint" && rule != "touch") {
    refuse_form(where + ".allowed is none of nothing, shared-endpoint, touch");
  }
  return rule;
}

std::vector<std::int64_t> read_groups(const json& item, std::size_t size, const std::string& where) {
  constexpr std::int64_t most = 999'999'999'999'999;  // all JSON readers agree about whole numbers up to this
  std::vector<std::int64_t> result;
  for (const json& entry : list_of(item, "groups", size, where)) {
    const bool is_small = entry.is_number_unsigned() ? entry.get<std::uint64_t>() <= most
                                                     : entry.is_number_integer() && entry.get<std::int64_t>() >= -most;
    if (!is_small) refuse_form(where + ".groups has an entry that is not a whole number of at most 15 digits");
    result.push_back(entry.get<std::int64_t>());
  }
  return result;
}

bool is_minus_one(const json& value) {
  return value.is_number_integer() && !value.is_number_unsigned() && value.get<std::int64_t>() == -1;
}

}  // namespace sunder_verifier
