#include <sunder/base/contract.h>
#include <sunder/base/json.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace sunder {

Json::Json(std::string text) : kind_(Kind::text), text_(std::move(text)) {}

Json::Json(std::initializer_list<Json> entries) : kind_(Kind::array) {
  const bool names = std::all_of(entries.begin(), entries.end(), [](const Json& entry) {
    return entry.kind_ == Kind::array && entry.size() == 2 && entry[0].kind_ == Kind::text;
  });
  if (!names) {
    items_ = entries;
    return;
  }
  kind_ = Kind::object;
  for (const Json& entry : entries) (*this)[entry[0].text_] = entry[1];
}

Json Json::array(std::initializer_list<Json> entries) {
  Json json;
  json.kind_ = Kind::array;
  json.items_ = entries;
  return json;
}

Json Json::object() {
  Json json;
  json.kind_ = Kind::object;
  return json;
}

Json Json::written(std::string text) {
  Json json;
  json.kind_ = Kind::written;
  json.text_ = std::move(text);
  return json;
}

Json::Json(const Json&) = default;
Json::Json(Json&&) noexcept = default;
Json& Json::operator=(const Json&) = default;
Json& Json::operator=(Json&&) noexcept = default;
Json::~Json() = default;

Json& Json::operator[](std::string_view key) {
  SUNDER_REQUIRE(is_object() || is_null());
  kind_ = Kind::object;
  const auto found = std::find(keys_.begin(), keys_.end(), key);
  if (found != keys_.end()) return items_[static_cast<std::size_t>(found - keys_.begin())];
  keys_.emplace_back(key);
  return items_.emplace_back();
}

const Json& Json::operator[](std::string_view key) const {
  SUNDER_REQUIRE(contains(key));
  return items_[static_cast<std::size_t>(std::find(keys_.begin(), keys_.end(), key) - keys_.begin())];
}

bool Json::contains(std::string_view key) const { return std::find(keys_.begin(), keys_.end(), key) != keys_.end(); }

void Json::erase(std::string_view key) {
  const auto found = std::find(keys_.begin(), keys_.end(), key);
  if (found == keys_.end()) return;
  items_.erase(items_.begin() + (found - keys_.begin()));
  keys_.erase(found);
}

void Json::erase(std::size_t k) { items_.erase(items_.begin() + static_cast<std::ptrdiff_t>(k)); }

void Json::update(const Json& object) {
  for (std::size_t k = 0; k < object.keys_.size(); ++k) (*this)[object.keys_[k]] = object.items_[k];
}

void Json::push_back(Json entry) {
  SUNDER_REQUIRE(kind_ == Kind::array || is_null());
  kind_ = Kind::array;
  items_.push_back(std::move(entry));
}

void Json::append(std::string& text, std::string_view comma, std::string_view colon) const {
  switch (kind_) {
    case Kind::null: text += "null"; return;
    case Kind::boolean: text += whole_ != 0 ? "true" : "false"; return;
    case Kind::integer: text += std::to_string(static_cast<std::int64_t>(whole_)); return;
    case Kind::natural: text += std::to_string(whole_); return;
    case Kind::real: text += std::isfinite(real_) ? json_number(real_) : "null"; return;
    case Kind::text: text += json_string(text_); return;
    case Kind::written: text += text_; return;
    case Kind::array:
    case Kind::object: break;
  }
  text += is_object() ? '{' : '[';
  for (std::size_t k = 0; k < size(); ++k) {
    if (k > 0) text += comma;
    if (is_object()) text.append(json_string(keys_[k])).append(colon);
    items_[k].append(text, comma, colon);
  }
  text += is_object() ? '}' : ']';
}

std::string Json::compact() const {
  std::string text;
  append(text, ",", ":");
  return text;
}

std::string Json::on_one_line() const {
  std::string text;
  append(text, ", ", ": ");
  return text;
}

std::size_t utf8_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
  const unsigned first = byte(at), second = byte(at + 1);
  if (first < 0x80) return 1;
  const std::size_t length = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
  for (std::size_t k = 1; k < length; ++k) {
    if (byte(at + k) >> 6 != 2) return 0;
  }
  // Longer than need be, surrogates, beyond the last character.
  if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f)) return 0;
  if ((first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f)) return 0;
  return length;
}

std::string json_string(std::string_view text) {
  std::string out = "\"";
  for (std::size_t i = 0, length = 0; i < text.size(); i += std::max<std::size_t>(length, 1)) {
    const char c = text[i];
    length = utf8_length(text, i);
    if (length != 1) {
      out += length == 0 ? "\\ufffd" : text.substr(i, length);
    } else if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      constexpr char digits[] = "0123456789abcdef";
      out += "\\u00";
      out += digits[static_cast<unsigned char>(c) >> 4];
      out += digits[static_cast<unsigned char>(c) & 15];
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string json_number(double value) {
  // Digits and exponent of the shortest: d.ddde+XX.
  std::array<char, 32> room;
  const auto end =
      std::to_chars(room.data(), room.data() + room.size(), std::fabs(value), std::chars_format::scientific).ptr;
  const std::string_view text(room.data(), static_cast<std::size_t>(end - room.data()));
  const std::size_t e = text.find('e');
  std::string digits(1, text[0]);
  if (e > 1) digits += text.substr(2, e - 2);
  int exponent = 0;
  std::from_chars(text.data() + e + (text[e + 1] == '+' ? 2 : 1), end, exponent);
  const int point = exponent + 1, count = static_cast<int>(digits.size());  // the point stands behind so many digits
  const std::string sign = std::signbit(value) ? "-" : "";
  constexpr int most = 15, least = -4;
  if (count <= point && point <= most)
    return sign + digits + std::string(static_cast<std::size_t>(point - count), '0') + ".0";
  if (0 < point && point <= most) return sign + digits.insert(static_cast<std::size_t>(point), 1, '.');
  if (least < point && point <= 0) return sign + "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  if (count > 1) digits.insert(1, 1, '.');
  return sign + digits + std::string(text.substr(e));
}

}  // namespace sunder
