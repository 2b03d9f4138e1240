// Doubles in hexadecimal form, against the C library's reading of them.
#include <tests/support/scale.h>
#include <verifier/cpp/reader.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

namespace sunder_verifier {
namespace {

class NumberTexts {
 public:
  std::string next() {
    std::string text = up_to(1) == 0 ? "0x" : "-0x";
    text += std::string(up_to(3) == 0 ? up_to(40) : 0, '0') + digits(up_to(3) == 0 ? 15 : 1);
    if (text.back() == 'x') text += '0';
    if (up_to(3) != 0) {
      text += "." + std::string(up_to(3) == 0 ? up_to(20) : 0, '0') + digits(14);
      if (up_to(3) == 0 || text.back() == '.') text += std::string(up_to(30) + 1, '0');
    }
    constexpr std::array<int, 6> middles{0, 0, 52, 1023, -1022, -1074};
    const int e = middles[up_to(5)] + static_cast<int>(up_to(60)) - 30;
    return text + "p" + (e >= 0 && up_to(1) == 0 ? "+" : "") + std::to_string(e);
  }

 private:
  unsigned up_to(unsigned most) { return static_cast<unsigned>(random_() % (most + 1)); }

  std::string digits(unsigned most) {
    std::string text;
    const unsigned count = up_to(2) == 0 ? up_to(most) : most;
    for (unsigned k = 0; k < count; ++k) text += "0123456789abcdefABCDEF000f"[up_to(25)];
    return text;
  }

  std::mt19937 random_{7};
};

// The number that the text says, from its digits.
Number exact(const std::string& text) {
  Number number;
  const std::size_t p = text.find('p'), point = text.find('.');
  for (const char c : text.substr(text.find('x') + 1, p - text.find('x') - 1)) {
    if (c != '.') number.n = number.n * 16 + std::stoi(std::string(1, c), nullptr, 16);
  }
  if (text[0] == '-') number.n = -number.n;
  number.e = std::stoi(text.substr(p + 1)) - (point < p ? 4 * static_cast<int>(p - point - 1) : 0);
  return number;
}

bool equal(const Number& s, const Number& t) {
  if (s.n == 0 || t.n == 0) return s.n == t.n;
  const std::int64_t e = std::min(s.e, t.e);
  return shifted(s.n, s.e - e) == shifted(t.n, t.e - e);
}

bool is_read(const std::string& text, Double& result) {
  const std::string quoted = '"' + text + '"';
  const JsonText json = read_json(quoted);
  try {
    result = read_double(json.top(), "a number");
    return true;
  } catch (const Refused& refused) {
    EXPECT_EQ(refused.check, "F");
    return false;
  }
}

TEST(Reader, ReadsDoublesAndNoOtherNumbers) {
  NumberTexts texts;
  int doubles = 0, others = 0;
  const int count = sunder::tests::scaled_count(100000, 10000);
  for (int k = 0; k < count; ++k) {
    const std::string text = texts.next();
    const double nearest = std::strtod(text.c_str(), nullptr);
    int e = 0;
    const double fraction = std::isfinite(nearest) ? std::frexp(nearest, &e) : 0;
    Number number;
    number.n = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    number.e = e - 53;
    const bool is_double = std::isfinite(nearest) && equal(exact(text), number);
    Double found;
    ASSERT_EQ(is_read(text, found), is_double) << text;
    (is_double ? doubles : others) += 1;
    if (!is_double) continue;
    ASSERT_TRUE(equal(number_of(found), number)) << text;
    ASSERT_TRUE(found.n % 2 != 0 || (found.n == 0 && found.e == 0)) << text;
  }
  EXPECT_GT(doubles, count / 5);
  EXPECT_GT(others, count / 5);
}

TEST(Reader, NumbersHaveLimits) {
  Double found;
  const std::string zeros(20000, '0');
  EXPECT_TRUE(is_read("0x1." + zeros.substr(0, 20000 - 6) + "p0", found));
  EXPECT_FALSE(is_read("0x1." + zeros.substr(0, 20000 - 5) + "p0", found));
  EXPECT_TRUE(is_read("0x0." + zeros.substr(0, 4999) + "1p20000", found));
  EXPECT_EQ(found.e, 0);
  EXPECT_FALSE(is_read("0x0p20001", found));
  EXPECT_FALSE(is_read("0x0p-99999999999999999999999", found));
  EXPECT_TRUE(is_read("-0x0p-20000", found));
  for (const char* text :
       {"",       "-",       "0x",      "0x.8p0",    "0x1.p0", "0x1p",  "0x1", "1p0", "0x1p0 ", " 0x1p0", "+0x1p0",
        "0x1pp0", "0x1p+-1", "0x1g0p0", "0x1.0.0p0", "0X1p0",  "0x1P0", "0",   "1",   "1/2",    "nan",    "inf"}) {
    EXPECT_FALSE(is_read(text, found)) << text;
  }
}

}  // namespace
}  // namespace sunder_verifier
