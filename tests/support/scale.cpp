#include <tests/support/scale.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace sunder::tests {

namespace {

template <class Number>
Number whole_text(const char* name, std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw std::invalid_argument(std::string(name) + " is '" + std::string(text) + "'");
  }
  return value;
}

}  // namespace

double scale_of(const char* text) {
  if (text == nullptr) return 1;
  const double scale = whole_text<double>("SUNDER_TEST_SCALE", text);
  if (!(scale > 0) || !std::isfinite(scale)) {
    throw std::invalid_argument("SUNDER_TEST_SCALE is '" + std::string(text) + "', not a number above 0");
  }
  return scale;
}

std::uint64_t seed_moved_by(const char* text, std::uint64_t own) {
  return text == nullptr ? own : own + 1000003 * whole_text<std::uint64_t>("SUNDER_TEST_SEED", text);
}

int scaled_count(int count, int at_least) {
  const double scaled = std::floor(count * scale_of(std::getenv("SUNDER_TEST_SCALE")));
  if (scaled > std::numeric_limits<int>::max()) throw std::invalid_argument("SUNDER_TEST_SCALE is too large");
  return std::max(std::min(count, at_least), static_cast<int>(scaled));
}

bool is_scaled_down() { return scaled_count(10, 0) < 1; }

std::uint64_t chosen_seed(std::uint64_t own) { return seed_moved_by(std::getenv("SUNDER_TEST_SEED"), own); }

}  // namespace sunder::tests
