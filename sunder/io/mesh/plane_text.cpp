#include <sunder/io/mesh/plane_text.h>
#include <sunder/io/text/pose_text.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace sunder::io {

namespace {

// digits / 10^places.
struct Decimal {
  std::int64_t digits = 0;
  int places = 0;
};

constexpr std::int64_t most_digits = 999'999'999'999'999;

constexpr std::int64_t power_of_ten(int n) { return n == 0 ? 1 : 10 * power_of_ten(n - 1); }

[[noreturn]] void refuse(std::string_view text, const char* what, const std::string& place) {
  throw Error(ErrorCode::bad_call, fmt::format("{} {}", quote(text), what), place);
}

Decimal decimal_of(std::string_view word, std::string_view text, const std::string& place) {
  Decimal number;
  const bool is_negative = !word.empty() && word[0] == '-';
  bool has_point = false, has_digit = false;
  for (const char x : word.substr(is_negative ? 1 : 0)) {
    if (x == '.' && !has_point) {
      has_point = true;
      continue;
    }
    const bool is_digit = x >= '0' && x <= '9';
    if (!is_digit || number.digits > most_digits / 10 || number.places > 14) {
      refuse(text, "has a bound or step that is no plain decimal of up to 15 digits; write FROM:TO:STEP like 0:1:0.01",
             place);
    }
    has_digit = true;
    number.digits = 10 * number.digits + (x - '0');
    number.places += has_point;
  }
  if (!has_digit) refuse(text, "lacks a number; write FROM:TO:STEP like 0:1:0.01", place);
  if (is_negative) number.digits = -number.digits;
  return number;
}

// FROM:TO:STEP.
std::vector<double> stack_of(std::string_view text, std::string_view whole, const std::string& place) {
  std::array<Decimal, 3> numbers;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t end = k < 2 ? text.find(':') : text.size();
    if (end == std::string_view::npos) refuse(whole, "is no stack; write FROM:TO:STEP like 0:1:0.01", place);
    numbers[k] = decimal_of(text.substr(0, end), whole, place);
    text.remove_prefix(k < 2 ? end + 1 : end);
  }
  const int places = std::max({numbers[0].places, numbers[1].places, numbers[2].places});
  std::array<std::int64_t, 3> of{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t by = power_of_ten(places - numbers[k].places);
    if (std::abs(numbers[k].digits) > most_digits / by) {
      refuse(whole, "needs more than 15 digits; write fewer", place);
    }
    of[k] = numbers[k].digits * by;
  }
  const auto& [from, to, step] = of;
  if (step <= 0) refuse(whole, "has a step that is not above zero; write FROM:TO:STEP like 0:1:0.01", place);
  if (to < from) refuse(whole, "ends below where it begins; write FROM:TO:STEP like 0:1:0.01", place);
  if (static_cast<std::uint64_t>((to - from) / step) >= most_planes) {
    refuse(whole, "has more than 1000000 planes; give a larger step", place);
  }
  std::vector<double> offsets;  // a quotient of two exact numbers is the nearest double
  const auto unit = static_cast<double>(power_of_ten(places));
  for (std::int64_t at = from; at <= to; at += step) offsets.push_back(static_cast<double>(at) / unit);
  return offsets;
}

}  // namespace

PlaneStack parse_planes(std::string_view text, const std::string& place) {
  const std::string_view whole = trimmed(text);
  PlaneStack stack;
  Point3 normal;
  std::string_view offsets;
  if (whole.size() > 2 && whole[1] == '=' && whole[0] >= 'x' && whole[0] <= 'z') {
    normal[static_cast<std::size_t>(whole[0] - 'x')] = 1;
    stack.name = whole.substr(0, 1);
    offsets = whole.substr(2);
  } else {
    const std::size_t comma = whole.rfind(',');
    if (comma == std::string_view::npos) refuse(whole, "is no plane; write z=0.5, or a,b,c,d", place);
    const std::vector<double> numbers = parse_numbers(whole.substr(0, comma), place);
    if (numbers.size() != 3) refuse(whole, "is no plane of four numbers; write a,b,c,d", place);
    normal = {numbers[0], numbers[1], numbers[2]};
    stack.name = whole.substr(0, comma);
    offsets = whole.substr(comma + 1);
  }
  if (normal == Point3{}) {
    throw Error(ErrorCode::bad_shape, quote(whole) + " has a normal that is zero; give a direction across the plane",
                place);
  }
  stack.plane = solid::Plane::at(normal, 0);
  if (offsets.find(':') != std::string_view::npos) {
    stack.offsets = stack_of(offsets, whole, place);
  } else {
    const std::vector<double> one = parse_numbers(offsets, place);
    if (one.size() != 1) refuse(whole, "is no plane of one offset; write z=0.5, or a,b,c,d", place);
    stack.offsets = one;
  }
  return stack;
}

}  // namespace sunder::io
