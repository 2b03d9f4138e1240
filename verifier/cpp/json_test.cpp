// The reader of JSON against nlohmann's, of whole texts and of spoilt ones.
#include <tests/support/scale.h>
#include <verifier/cpp/json.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <string>

namespace sunder_verifier {
namespace {

using Other = nlohmann::json;

// A text of JSON, and what a byte of it may be replaced with.
class JsonTexts {
 public:
  std::string whole() {
    std::string text = up_to(20) == 0 ? "\xEF\xBB\xBF" : "";
    add_value(text, 0);
    return text + space();
  }

  std::string spoilt(std::string text) {
    static const std::string bytes =
        "\"\\/{}[],:.+-eE0123456789abfnrtudDC8 \n\t\x01\x1f\x7f\x80\xbf\xc0\xc2\xe0\xed\xf0\xf4\xf8";
    for (unsigned k = up_to(2); k < 3; ++k) {
      const std::size_t at = up_to(static_cast<unsigned>(text.size()));
      const char byte = bytes[up_to(static_cast<unsigned>(bytes.size()) - 1)];
      switch (up_to(2)) {
        case 0: text.insert(at, 1, byte); break;
        case 1: text.replace(at, 1, 1, byte); break;
        default: text.erase(at, 1);
      }
    }
    return text;
  }

 private:
  unsigned up_to(unsigned most) { return static_cast<unsigned>(random_() % (most + 1)); }
  std::string space() { return std::array<const char*, 6>{"", "", "", " ", "\n\t", "\r "}[up_to(5)]; }

  void add_value(std::string& text, int depth) {
    text += space();
    switch (up_to(depth < 4 ? 9 : 5)) {
      case 0: text += std::array<const char*, 3>{"null", "true", "false"}[up_to(2)]; break;
      case 1:
      case 2: add_string(text); break;
      case 3:
      case 4:
      case 5: add_number(text); break;
      default: add_list(text, depth, up_to(1) == 0);
    }
    text += space();
  }

  void add_list(std::string& text, int depth, bool is_object) {
    text += is_object ? "{" : "[";
    const unsigned count = up_to(3);
    for (unsigned k = 0; k < count; ++k) {
      if (k > 0) text += ",";
      if (is_object) {
        text += space();
        add_string(text);
        text += space() + ":";
      }
      add_value(text, depth + 1);
    }
    text += space() + (is_object ? "}" : "]");
  }

  void add_string(std::string& text) {
    static const std::array<const char*, 24> pieces{"a",
                                                    "b",
                                                    "c",
                                                    "0x1.8p+3",
                                                    "\x7f",
                                                    "\xc2\x80",
                                                    "\xdf\xbf",
                                                    "\xe0\xa0\x80",
                                                    "\xed\x9f\xbf",
                                                    "\xee\x80\x80",
                                                    "\xf0\x90\x80\x80",
                                                    "\xf4\x8f\xbf\xbf",
                                                    "\\\"",
                                                    "\\\\",
                                                    "\\/",
                                                    "\\b",
                                                    "\\n",
                                                    "\\u0000",
                                                    "\\u0041",
                                                    "\\u07fF",
                                                    "\\uD7ff",
                                                    "\\uffFF",
                                                    "\\ud800\\udc00",
                                                    "\\uDBFF\\uDFFF"};
    text += '"';
    for (unsigned k = up_to(4); k > 0; --k) text += pieces[up_to(pieces.size() - 1)];
    text += '"';
  }

  void add_number(std::string& text) {
    static const std::array<const char*, 20> numbers{"0",
                                                     "-0",
                                                     "7",
                                                     "-1",
                                                     "12",
                                                     "10",
                                                     "1.5",
                                                     "-0.25",
                                                     "1e5",
                                                     "1E-5",
                                                     "2e+3",
                                                     "9223372036854775807",
                                                     "9223372036854775808",
                                                     "-9223372036854775808",
                                                     "-9223372036854775809",
                                                     "18446744073709551615",
                                                     "18446744073709551616",
                                                     "1e308",
                                                     "1e309",
                                                     "1e-999"};
    text += numbers[up_to(up_to(9) == 0 ? 19 : 17)];
  }

  std::mt19937 random_{11};
};

// As the other reader has it.
Other converted(const Json& value, const Other& like) {
  if (value.is_string()) return std::string(value.text());
  if (value.is_integer()) return value.integer();
  if (value.is_array()) {
    Other list = Other::array();
    if (!like.is_array() || like.size() != value.size()) return list;
    for (const Json& entry : value) list.push_back(converted(entry, like[list.size()]));
    return list;
  }
  if (value.is_object()) {
    Other object = Other::object();
    for (const auto& [key, member] : value.members()) {
      const std::string name(key);
      object[name] = converted(*member, like.contains(name) ? like[name] : Other());
      EXPECT_EQ(value.find(key), member);
    }
    return object;
  }
  // What else there is, is not told apart.
  const bool is_long = like.is_number_unsigned() && like.get<std::uint64_t>() >> 63 != 0;
  const bool is_other = like.is_boolean() || like.is_number_float() || is_long;
  return value.is_null() != is_other ? like : Other("neither null nor another");
}

std::optional<JsonText> read(const std::string& text) {
  try {
    return read_json(text);
  } catch (const NotJson&) {
    return std::nullopt;
  }
}

void expect_alike(const std::string& text) {
  const std::optional<JsonText> found = read(text);
  const Other other = Other::parse(text, nullptr, false);
  ASSERT_EQ(found.has_value(), !other.is_discarded()) << text;
  if (!found || found->has_key_twice) return;
  ASSERT_EQ(converted(found->top(), other), other) << text;
}

TEST(Json, WholeAndSpoiltTextsAreReadAsByAnother) {
  JsonTexts texts;
  int spoilt = 0, read_still = 0;
  const int count = sunder::tests::scaled_count(50000, 5000);
  for (int k = 0; k < count; ++k) {
    const std::string text = texts.whole();
    expect_alike(text);
    const std::string other = texts.spoilt(text);
    expect_alike(other);
    if (::testing::Test::HasFatalFailure()) return;
    ++spoilt;
    if (read(other)) ++read_still;
  }
  EXPECT_GT(read_still, spoilt / 10);
  EXPECT_LT(read_still, spoilt / 2);
}

TEST(Json, EachByteOfAStringIsJudgedAlike) {
  for (unsigned first = 1; first < 256; ++first) {
    for (unsigned second = 1; second < 256; second += sunder::tests::is_scaled_down() ? 7u : 1u) {
      for (const char* rest : {"", "\x80", "\x80\x80"}) {
        const std::string text = std::string("\"") + static_cast<char>(first) + static_cast<char>(second) + rest + '"';
        expect_alike(text);
        if (::testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

TEST(Json, ARepeatedKeyIsTold) {
  for (const char* text :
       {R"({"a": 1, "a": 1})", R"([{"b": 0}, {"c": {"b": 1, "a": 2, "\u0062": 3}}])", R"({"": 0, "": 0})"}) {
    EXPECT_TRUE(read_json(text).has_key_twice) << text;
  }
  for (const char* text :
       {R"({"a": {"a": {"a": 1}}, "b": {"a": 2}})", R"([{"a": 1}, {"a": 1}])", R"({"a": "a", "A": "a"})"}) {
    EXPECT_FALSE(read_json(text).has_key_twice) << text;
  }
}

// Where a text stops to be JSON; 1000 and more: it is too deep.
std::size_t place(const std::string& text) {
  try {
    read_json(text);
  } catch (const NotJson& error) {
    return error.at + (error.is_too_deep ? 1000 : 0);
  }
  return 999;
}

TEST(Json, TheFirstWrongByteIsTold) {
  EXPECT_EQ(place(""), 0u);
  EXPECT_EQ(place("  ?"), 2u);
  EXPECT_EQ(place("[1, 2"), 5u);
  EXPECT_EQ(place("[1, 2,]"), 6u);
  EXPECT_EQ(place("[1] 2"), 4u);
  EXPECT_EQ(place("{\"a\" 1}"), 5u);
  EXPECT_EQ(place("{a: 1}"), 1u);
  EXPECT_EQ(place("[nul]"), 4u);
  EXPECT_EQ(place("[01]"), 2u);
  EXPECT_EQ(place("[1, 2e999]"), 4u);
  EXPECT_EQ(place("[\"a\\x\"]"), 3u);
  EXPECT_EQ(place("[\"\xff\"]"), 2u);
  EXPECT_EQ(place(std::string("[0,\0]", 5)), 3u);
}

TEST(Json, LevelsAreLimited) {
  const auto nested = [](std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
  EXPECT_EQ(place(nested(most_levels)), 999u);
  EXPECT_EQ(place(nested(most_levels + 1)), 1000 + most_levels);
  EXPECT_EQ(place(std::string(10000000, '[')), 1000 + most_levels);
  EXPECT_EQ(place("[" + nested(most_levels - 1) + "," + nested(most_levels - 1) + "]"), 999u);
}

TEST(Json, WhatIsDeepIsKeptAsItsText) {
  std::string text = R"({"tables": {"a": [[1], {"b\n": "\u00e4"}]}, "statements": [)";
  for (int k = 0; k < 1000; ++k) text += R"({"claims": [1, 2, [3, "\n"]]},)";
  text += R"(7], "more": [[{"a": 1, "a": 2}]]})";
  const JsonText read = read_json(text, 2);
  EXPECT_LT(read.values.size(), 1020u);  // of each statement one
  EXPECT_TRUE(read.unescaped.empty());
  EXPECT_TRUE(read.has_key_twice);
  const Json& statements = read.top()["statements"];
  ASSERT_EQ(statements.size(), 1001u);
  EXPECT_TRUE(statements[999].is_unread());
  EXPECT_EQ(statements[999].text(), R"({"claims": [1, 2, [3, "\n"]]})");
  EXPECT_EQ(statements[1000].integer(), 7);
  const ReadNow last(statements[1000]), claim(statements[999]), table(read.top()["tables"]["a"]);
  EXPECT_EQ((*last).integer(), 7);
  EXPECT_EQ((*claim)["claims"][2][1].text(), "\n");
  EXPECT_EQ((*table)[1]["b\n"].text(), "\xc3\xa4");
  EXPECT_THROW(read_json(text.replace(text.find("[3,"), 3, "[3;"), 2), NotJson);
}

}  // namespace
}  // namespace sunder_verifier
