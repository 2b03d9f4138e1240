#include <sunder/base/json_line.h>

#include <array>
#include <charconv>
#include <cmath>

namespace sunder {

JsonLine& JsonLine::key(std::string_view name) {
  before_value();
  text_ += '"';
  (text_ += name) += "\": ";
  needs_comma_ = false;
  return *this;
}

JsonLine& JsonLine::written(std::string_view json) {
  before_value();
  text_ += json;
  needs_comma_ = true;
  return *this;
}

JsonLine& JsonLine::whole(std::uint64_t value) {
  std::array<char, 20> digits;
  return written({digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr});
}

JsonLine& JsonLine::number(double value) { return written(std::isfinite(value) ? json_number(value) : "null"); }

}  // namespace sunder
