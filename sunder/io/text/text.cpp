#include <sunder/base/error.h>
#include <sunder/io/text/text.h>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <system_error>

namespace sunder::io {
namespace {

unsigned byte(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
}

bool within(unsigned value, unsigned low, unsigned high) { return low <= value && value <= high; }

// The length of the printable character that the text begins with; 0 where there is none.
std::size_t printable(std::string_view text) {
  const unsigned a = byte(text, 0), b = byte(text, 1), c = byte(text, 2), d = byte(text, 3);
  if (within(a, 0x20, 0x7e)) return 1;
  if (within(a, 0xc2, 0xdf)) {
    const bool control = a == 0xc2 && b < 0xa0, direction = a == 0xd8 && b == 0x9c;
    return within(b, 0x80, 0xbf) && !control && !direction ? 2 : 0;
  }
  if (within(a, 0xe0, 0xef)) {
    const bool shape = within(b, a == 0xe0 ? 0xa0 : 0x80, a == 0xed ? 0x9f : 0xbf) && within(c, 0x80, 0xbf);
    const bool line_or_direction = a == 0xe2 && ((b == 0x80 && (within(c, 0x8e, 0x8f) || within(c, 0xa8, 0xae))) ||
                                                 (b == 0x81 && within(c, 0xa6, 0xa9)));
    return shape && !line_or_direction ? 3 : 0;
  }
  if (within(a, 0xf0, 0xf4)) {
    const bool shape = within(b, a == 0xf0 ? 0x90 : 0x80, a == 0xf4 ? 0x8f : 0xbf);
    return shape && within(c, 0x80, 0xbf) && within(d, 0x80, 0xbf) ? 4 : 0;
  }
  return 0;
}

bool is_digit(char c) { return '0' <= c && c <= '9'; }

}  // namespace

std::string one_line(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  while (!text.empty()) {
    std::size_t length = printable(text);
    if (length > 0) {
      line.append(text.substr(0, length));
    } else {
      length = 1;
      line += fmt::format("\\x{:02x}", byte(text, 0));
    }
    text.remove_prefix(length);
  }
  return line;
}

std::string shorten(std::string_view text) {
  constexpr std::size_t longest = 40;
  return one_line(text.substr(0, longest)) + (text.size() > longest ? "..." : "");
}

std::string quote(std::string_view text) { return "'" + shorten(text) + "'"; }

std::string count_of(std::uint64_t n, std::string_view noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : noun.ends_with('x') ? "es" : "s");
}

std::string place_text(const Point2& p) { return fmt::format("({:.10g}, {:.10g})", p.x, p.y); }

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string in_small_letters(std::string_view word) {
  std::string small(word);
  for (char& c : small) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return small;
}

std::string ending_of(std::string_view file) {
  return in_small_letters(std::filesystem::path(file).extension().string());
}

const char* parse_number(std::string_view word, double& value) {
  std::string_view number = word;
  if (number.starts_with('+') && !number.substr(1).starts_with('-')) number.remove_prefix(1);
  const char* const end = number.data() + number.size();
  double parsed = 0;
  const auto result = fast_float::from_chars(number.data(), end, parsed);  // beyond the doubles: infinite, or zero
  const bool has_digits = std::any_of(word.begin(), word.end(), is_digit);
  if (result.ec == std::errc::invalid_argument || result.ptr != end) {
    const bool comma = word.find(',') != std::string_view::npos && has_digits;
    return comma ? "is not a number; write a decimal point, not a comma"
                 : "is not a number; write decimal numbers such as -1.5e3";
  }
  if (std::isnan(parsed)) return "is NaN; every number must be finite";
  if (std::isinf(parsed) && has_digits) return "is too large for a double; the largest is 1.7976931348623157e308";
  if (std::isinf(parsed)) return "is infinite; every number must be finite";
  value = parsed;
  return nullptr;
}

bool is_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double ignored = 0;
  return fast_float::from_chars(word.data(), word.data() + word.size(), ignored).ec != std::errc::invalid_argument;
}

bool parse_integer(std::string_view word, std::int64_t& value) {
  if (word.starts_with('+') && !word.substr(1).starts_with('-')) word.remove_prefix(1);
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

void fail_call(const std::string& text, const std::string& place) { throw Error(ErrorCode::bad_call, text, place); }

void fail_file(std::string_view file, const std::string& text) {
  throw Error(ErrorCode::bad_file, text, one_line(file));
}

void fail_line(std::string_view file, std::size_t line, const std::string& text) {
  throw Error(ErrorCode::bad_file, text, fmt::format("{}:{}", one_line(file), line));
}

void fail_byte(std::string_view file, std::size_t offset, const std::string& text) {
  throw Error(ErrorCode::bad_file, text, fmt::format("{}: byte {}", one_line(file), offset));
}

}  // namespace sunder::io
