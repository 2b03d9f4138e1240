#include <verifier/cpp/json.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <system_error>

namespace sunder_verifier {

const Json& Json::operator[](std::size_t k) const {
  Iterator entry = begin();
  for (; k > 0; --k) ++entry;
  return *entry;
}

const Json* Json::find(std::string_view key) const {
  if (!is_object()) return nullptr;
  for (const Json* member = this + 1; member != next(); member = member[1].next()) {
    if (member->text() == key) return member + 1;
  }
  return nullptr;
}

std::vector<std::pair<std::string_view, const Json*>> Json::members() const {
  std::vector<std::pair<std::string_view, const Json*>> result;
  for (const Json* member = this + 1; member != next(); member = member[1].next()) {
    result.emplace_back(member->text(), member + 1);
  }
  std::sort(result.begin(), result.end());
  return result;
}

class JsonReader {
 public:
  JsonReader(std::string_view text, std::size_t most_read, JsonText& result)
      : begin_(text.data()), at_(begin_), end_(begin_ + text.size()), most_read_(most_read), result_(result) {}

  void read() {
    if (std::string_view(at_, end_).starts_with("\xEF\xBB\xBF")) at_ += 3;
    result_.values.reserve(static_cast<std::size_t>(end_ - at_) /
                           8);  // mostly enough; what is not used takes no memory
    value();
    skip_space();
    if (at_ != end_) fail(at_);
  }

 private:
  using Kind = Json::Kind;

  [[noreturn]] void fail(const char* at) const { throw NotJson{static_cast<std::size_t>(at - begin_), false}; }

  // '\0': the end, or a character that stands nowhere in JSON.
  char next() const { return at_ == end_ ? '\0' : *at_; }

  bool take(char c) {
    const bool is_next = next() == c;
    if (is_next) ++at_;
    return is_next;
  }

  void expect(char c) {
    if (!take(c)) fail(at_);
  }

  void skip_space() {
    while (next() == ' ' || next() == '\n' || next() == '\r' || next() == '\t') ++at_;
  }

  Json& add(Kind kind) { return result_.values.emplace_back(Json(kind)); }

  void value() {
    skip_space();
    switch (next()) {
      case '{': return object();
      case '[': return array();
      case '"': return string();
      case 'n': return word("null", Kind::null);
      case 't': return word("true", Kind::boolean);
      case 'f': return word("false", Kind::boolean);
      default: return number();
    }
  }

  void word(std::string_view expected, Kind kind) {
    for (const char c : expected) expect(c);
    add(kind);
  }

  // ---- Arrays and objects.

  // Where something is opened: in the text, and in the lists. All of its entries come behind it.
  struct Opened {
    const char* at;
    std::size_t place, unescaped;
  };

  Opened open(Kind kind) {
    if (++levels_ > most_levels) throw NotJson{static_cast<std::size_t>(at_ - begin_), true};
    add(kind);
    return {at_++, result_.values.size() - 1, result_.unescaped.size()};
  }

  void close(const Opened& opened, std::size_t size) {
    if (levels_-- == most_read_ + 1) return leave_unread(opened);
    Json& value = result_.values[opened.place];
    value.set_size(size);
    value.length_ = result_.values.size() - opened.place;
  }

  void leave_unread(const Opened& opened) {
    result_.values.erase(result_.values.begin() + static_cast<std::ptrdiff_t>(opened.place), result_.values.end());
    result_.unescaped.resize(opened.unescaped);
    Json& value = add(Kind::unread);
    value.set_size(static_cast<std::size_t>(at_ - opened.at));
    value.text_ = opened.at;
  }

  void array() {
    const Opened opened = open(Kind::array);
    std::size_t size = 0;
    skip_space();
    if (!take(']')) {
      do {
        value();
        ++size;
        skip_space();
      } while (take(','));
      expect(']');
    }
    close(opened, size);
  }

  void object() {
    const Opened opened = open(Kind::object);
    std::vector<std::string_view> keys;
    skip_space();
    if (!take('}')) {
      do {
        skip_space();
        string();
        keys.push_back(result_.values.back().text());
        skip_space();
        expect(':');
        value();
        skip_space();
      } while (take(','));
      expect('}');
    }
    std::sort(keys.begin(), keys.end());
    if (std::adjacent_find(keys.begin(), keys.end()) != keys.end()) result_.has_key_twice = true;
    close(opened, keys.size());
  }

  // ---- Numbers.

  void digits() {
    if (next() < '0' || next() > '9') fail(at_);
    while (next() >= '0' && next() <= '9') ++at_;
  }

  void number() {
    const char* start = at_;
    take('-');
    if (!take('0')) digits();
    const char* whole_end = at_;
    if (take('.')) digits();
    if (take('e') || take('E')) {
      if (!take('-')) take('+');
      digits();
    }
    std::int64_t integer = 0;
    if (at_ == whole_end && std::from_chars(start, at_, integer).ec == std::errc()) {
      add(Kind::integer).integer_ = integer;
    } else {
      if (!std::isfinite(std::strtod(std::string(start, at_).c_str(), nullptr))) fail(start);
      add(Kind::other_number);
    }
  }

  // ---- Strings.

  void string() {
    expect('"');
    const char* start = at_;
    skip_characters();
    std::string_view text(start, at_);
    if (next() == '\\') {
      std::string& unescaped = result_.unescaped.emplace_back(text);
      while (next() == '\\') {
        escape(unescaped);
        start = at_;
        skip_characters();
        unescaped.append(start, at_);
      }
      text = unescaped;
    }
    expect('"');
    Json& value = add(Kind::string);
    value.set_size(text.size());
    value.text_ = text.data();
  }

  // Characters that stand for themselves.
  void skip_characters() {
    while (at_ != end_ && *at_ != '"' && *at_ != '\\') {
      const auto byte = static_cast<unsigned char>(*at_);
      if (byte < 0x20) fail(at_);
      if (byte < 0x80) {
        ++at_;
      } else {
        skip_character_beyond_ascii();
      }
    }
  }

  void skip_character_beyond_ascii() {
    const char* start = at_;
    const auto lead = static_cast<unsigned char>(*at_++);
    const unsigned more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
    std::uint32_t code = lead & (0x3Fu >> more);
    for (unsigned k = 0; k < more; ++k) {
      const auto byte = static_cast<unsigned char>(next());
      if ((byte & 0xC0u) != 0x80) fail(start);
      code = code << 6 | (byte & 0x3Fu);
      ++at_;
    }
    const std::uint32_t least = more == 3 ? 0x10000 : more == 2 ? 0x800 : 0x80;
    if (lead < 0xC0 || lead > 0xF4 || code < least || code > 0x10FFFF || is_surrogate(code)) fail(start);
  }

  static bool is_surrogate(std::uint32_t code) { return code >= 0xD800 && code < 0xE000; }

  void escape(std::string& text) {
    const char* start = at_++;
    const char c = next();
    constexpr std::string_view names = "\"\\/bfnrt", meant = "\"\\/\b\f\n\r\t";
    const std::size_t k = names.find(c);
    if (c != 'u' && k == std::string_view::npos) fail(start);
    ++at_;
    if (c != 'u') {
      text += meant[k];
      return;
    }
    std::uint32_t code = hexadecimal();
    if (is_surrogate(code)) {  // it has another half
      const bool is_first = code < 0xDC00 && take('\\') && take('u');
      const std::uint32_t second = is_first ? hexadecimal() : 0;
      if (second < 0xDC00 || second >= 0xE000) fail(start);
      code = 0x10000 + ((code - 0xD800) << 10) + (second - 0xDC00);
    }
    append(text, code);
  }

  std::uint32_t hexadecimal() {
    std::uint32_t code = 0;
    const char* start = at_;
    at_ = std::from_chars(start, start + std::min<std::ptrdiff_t>(4, end_ - start), code, 16).ptr;
    if (at_ != start + 4) fail(at_);
    return code;
  }

  static void append(std::string& text, std::uint32_t code) {
    if (code < 0x80) {
      text += static_cast<char>(code);
      return;
    }
    const unsigned more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    text += static_cast<char>((0xF0u << (3 - more) & 0xFFu) | code >> 6 * more);
    for (unsigned k = more; k-- > 0;) text += static_cast<char>(0x80u | (code >> 6 * k & 0x3Fu));
  }

  const char *begin_, *at_, *end_;
  const std::size_t most_read_;
  JsonText& result_;
  std::size_t levels_ = 0;
};

JsonText read_json(std::string_view text, std::size_t most_read) {
  JsonText result;
  JsonReader(text, most_read, result).read();
  return result;
}

}  // namespace sunder_verifier
