// Reads JSON (RFC 8259) in one pass, into one list of values: the text of a certificate can have 10^8 of them. What is
// deep inside can be left as its text, and read later, piece by piece.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder_verifier {

// A value. Behind it, in the list that it is in, stand its entries with all that is in them; of an object a key and a
// value each. So it is not copied.
class Json {
 public:
  enum class Kind : std::uint8_t { null, boolean, integer, other_number, string, array, object, unread };

  Json(Json&&) = default;
  Json& operator=(Json&&) = default;
  Json(const Json&) = delete;
  Json& operator=(const Json&) = delete;
  ~Json() = default;

  bool is_null() const { return kind() == Kind::null; }
  bool is_integer() const { return kind() == Kind::integer; }  // without a point or an exponent, of at most 64 bits
  bool is_string() const { return kind() == Kind::string; }
  bool is_array() const { return kind() == Kind::array; }
  bool is_object() const { return kind() == Kind::object; }
  bool is_unread() const { return kind() == Kind::unread; }  // an array or an object, of which the text is kept

  std::int64_t integer() const { return integer_; }          // requires is_integer()
  std::string_view text() const { return {text_, size()}; }  // UTF-8; requires is_string() or is_unread()
  std::size_t size() const { return size_; }                 // entries, members, or bytes; else 0
  bool empty() const { return size() == 0; }

  // The entries of an array. Requires is_array().
  class Iterator {
   public:
    explicit Iterator(const Json* at) : at_(at) {}
    const Json& operator*() const { return *at_; }
    Iterator& operator++() {
      at_ = at_->next();
      return *this;
    }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    const Json* at_;
  };
  Iterator begin() const { return Iterator(this + 1); }
  Iterator end() const { return Iterator(next()); }
  // Entry k < size(), in time k.
  const Json& operator[](std::size_t k) const;

  // The value of a member; nullptr: there is none, or this is no object.
  const Json* find(std::string_view key) const;
  bool contains(std::string_view key) const { return find(key) != nullptr; }
  const Json& operator[](std::string_view key) const { return *find(key); }  // requires contains(key)
  // Ordered by key. Requires is_object().
  std::vector<std::pair<std::string_view, const Json*>> members() const;

 private:
  friend class JsonReader;
  explicit Json(Kind kind) : kind_(static_cast<std::uint64_t>(kind) & 7u), size_(0), integer_(0) {}

  void set_size(std::size_t size) { size_ = size & (~std::uint64_t{0} >> 3); }  // as if there were longer texts

  Kind kind() const { return static_cast<Kind>(kind_); }
  const Json* next() const { return this + (is_array() || is_object() ? length_ : 1); }

  std::uint64_t kind_ : 3, size_ : 61;
  union {
    std::int64_t integer_;
    const char* text_;
    std::size_t length_;  // of an array or an object: the number of all values from it on that belong to it
  };
};

struct JsonText {
  std::vector<Json> values;           // the first one is the whole text
  std::deque<std::string> unescaped;  // strings with escapes
  bool has_key_twice = false;         // an object has

  const Json& top() const { return values.front(); }
};

// Why a text cannot be read.
struct NotJson {
  std::size_t at;    // the first byte that cannot stand there; of a number, where it begins
  bool is_too_deep;  // it opens one level of nesting too many
};

// Levels of arrays and objects that a text may have.
constexpr std::size_t most_levels = 500;

// The text must outlive the result. It may begin with a byte order mark. Numbers are none that are beyond the doubles.
// Arrays and objects in more than so many others are looked at whole, and are unread in the result. Throws NotJson.
JsonText read_json(std::string_view text, std::size_t most_read = most_levels);

// A value, read now if it is unread. The text, and the value, must outlive it.
class ReadNow {
 public:
  explicit ReadNow(const Json& value) : value_(value) {
    if (value.is_unread()) text_ = read_json(value.text());
  }
  const Json& operator*() const { return value_.is_unread() ? text_.top() : value_; }

 private:
  const Json& value_;
  JsonText text_;
};

}  // namespace sunder_verifier
