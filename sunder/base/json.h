// JSON to be written: a value that is built member by member, and the text of it. Objects keep the order in which their
// members are made. (Reading is io/text/json_internal.h's.)
//
// A braced list is an object where each of its entries is a braced pair that begins with a string, else an array:
//   Json report{{"answer", "apart"}, {"gap", 0.5}, {"vertices", {1, 2, 3}}};
// Throws only std::bad_alloc. Cost: linear in the text; of a member by its name, in the members of its object.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunder {

class Json {
 public:
  Json() = default;  // null
  Json(std::nullptr_t) {}
  Json(std::same_as<bool> auto value) : kind_(Kind::boolean), whole_(value ? 1 : 0) {}
  Json(std::signed_integral auto value)
      : kind_(Kind::integer), whole_(static_cast<std::uint64_t>(std::int64_t{value})) {}
  template <std::unsigned_integral T>
    requires(!std::same_as<T, bool>)
  Json(T value) : kind_(Kind::natural), whole_(value) {}
  Json(float value) : Json(static_cast<double>(value)) {}
  Json(double value) : kind_(Kind::real), real_(value) {}  // null where it is no number, or infinite
  Json(const char* text) : Json(std::string(text)) {}
  Json(std::string_view text) : Json(std::string(text)) {}
  Json(std::string text);
  Json(std::initializer_list<Json> entries);
  template <class T>
  Json(const std::vector<T>& entries) : Json(std::span<const T>(entries)) {}
  template <class T, std::size_t size>
  Json(const std::array<T, size>& entries) : Json(std::span<const T>(entries)) {}
  template <class T>
  Json(std::span<const T> entries) : kind_(Kind::array) {
    for (const T& entry : entries) push_back(entry);
  }

  static Json array(std::initializer_list<Json> entries = {});  // of one Json, too, which {x} may copy
  static Json object();
  static Json written(std::string text);  // what is JSON already, as it stands

  Json(const Json&);
  Json(Json&&) noexcept;
  Json& operator=(const Json&);
  Json& operator=(Json&&) noexcept;
  ~Json();

  bool is_null() const { return kind_ == Kind::null; }
  bool is_object() const { return kind_ == Kind::object; }
  bool is_structured() const { return is_object() || kind_ == Kind::array; }
  std::size_t size() const { return items_.size(); }  // of what is structured, else 0
  bool empty() const { return items_.empty(); }

  // The entries of an array, or the values of an object in the order of keys().
  std::span<const Json> items() const { return items_; }
  std::span<const std::string> keys() const { return keys_; }
  const Json& operator[](std::size_t k) const { return items_[k]; }
  Json& operator[](std::size_t k) { return items_[k]; }
  Json& back() { return items_.back(); }

  // The member of that name, made where it is missing. Requires an object, or null, which becomes one.
  Json& operator[](std::string_view key);
  const Json& operator[](std::string_view key) const;  // requires that there is one
  bool contains(std::string_view key) const;
  void erase(std::string_view key);
  void erase(std::size_t k);        // of an array
  void update(const Json& object);  // sets its members here

  // Requires an array, or null, which becomes one.
  void push_back(Json entry);

  std::string compact() const;      // {"a":1,"b":[2,3]}
  std::string on_one_line() const;  // {"a": 1, "b": [2, 3]}

 private:
  enum class Kind : std::uint8_t { null, boolean, integer, natural, real, text, written, array, object };

  void append(std::string& text, std::string_view comma, std::string_view colon) const;

  Kind kind_ = Kind::null;
  std::uint64_t whole_ = 0;
  double real_ = 0;
  std::string text_;
  std::vector<Json> items_;
  std::vector<std::string> keys_;
};

// A string of JSON, with its quotes. What is not UTF-8 becomes the replacement character.
std::string json_string(std::string_view text);

// The shortest decimal number that is read as this double; with a point or an exponent: 1.0, 0.25, 1e-07, 1e+20.
std::string json_number(double value);

// The length of the character of UTF-8 that begins there, 1 to 4; 0 where none does.
std::size_t utf8_length(std::string_view text, std::size_t at);

}  // namespace sunder
