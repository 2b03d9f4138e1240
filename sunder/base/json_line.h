// JSON that is written into a text as it goes, as Json::on_one_line has it: for lines of which there are thousands.
//   JsonLine(text).open('{').member("row", 7u).key("pairs").open('[').close(']').close('}');   {"row": 7, "pairs": []}
#pragma once

#include <sunder/base/json.h>

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace sunder {

class JsonLine {
 public:
  explicit JsonLine(std::string& text) : text_(text) {}

  JsonLine& open(char bracket) { return before_value().then(bracket, false); }  // '{' or '['
  JsonLine& close(char bracket) { return then(bracket, true); }
  JsonLine& key(std::string_view name);  // plain letters; its value follows
  JsonLine& written(std::string_view json);

  // A truth, a number, a text, or a range of such.
  template <class Value>
  JsonLine& value(const Value& value) {
    if constexpr (std::same_as<Value, bool>) {
      return written(value ? "true" : "false");
    } else if constexpr (std::unsigned_integral<Value>) {
      return whole(value);
    } else if constexpr (std::same_as<Value, double>) {
      return number(value);
    } else if constexpr (std::convertible_to<Value, std::string_view>) {
      return written(json_string(value));
    } else {
      open('[');
      for (const auto& entry : value) this->value(entry);
      return close(']');
    }
  }
  template <class Value>
  JsonLine& member(std::string_view name, const Value& value) {
    return key(name).value(value);
  }

 private:
  JsonLine& before_value() {
    if (needs_comma_) text_ += ", ";
    return *this;
  }
  JsonLine& then(char bracket, bool needs_comma) {
    text_ += bracket;
    needs_comma_ = needs_comma;
    return *this;
  }
  JsonLine& whole(std::uint64_t value);
  JsonLine& number(double value);

  std::string& text_;
  bool needs_comma_ = false;
};

}  // namespace sunder
