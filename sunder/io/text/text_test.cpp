#include <sunder/base/error.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/text_reader.h>

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>

namespace sunder::io {
namespace {

double read(std::string_view word) {
  double value = 0.125;
  const char* problem = parse_number(word, value);
  EXPECT_EQ(problem, nullptr) << word << " " << (problem ? problem : "");
  return value;
}

std::string problem(std::string_view word) {
  double value = 0.125;
  const char* text = parse_number(word, value);
  EXPECT_EQ(value, text ? 0.125 : value) << "a refused number must leave the value alone";
  return text ? text : "";
}

TEST(ParseNumber, ReadsTheNearestDouble) {
  EXPECT_EQ(read("0.1"), 0.1);
  EXPECT_EQ(read("-1.5e3"), -1500);
  EXPECT_EQ(read("+2"), 2);
  EXPECT_EQ(read("1."), 1);
  EXPECT_EQ(read(".5"), 0.5);
  EXPECT_EQ(read("1E+2"), 100);
  EXPECT_EQ(read("9007199254740993"), 9007199254740992.0);  // a tie: to even
  EXPECT_EQ(read("9007199254740993.0000000000000000000000000000001"), 9007199254740994.0);
  EXPECT_EQ(read("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(read("5e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(read("2.2250738585072011e-308"), 2.2250738585072011e-308);
}

TEST(ParseNumber, RoundsWhatIsTooSmallToZero) {
  EXPECT_EQ(read("1e-400"), 0);
  EXPECT_EQ(read("-123456e-999999999999999999999"), 0);
  EXPECT_EQ(read("0." + std::string(500, '0') + "1"), 0);
  EXPECT_EQ(read("0e999999"), 0);
}

TEST(ParseNumber, TellsWhatIsWrong) {
  EXPECT_NE(problem("1e309").find("too large"), std::string::npos);
  EXPECT_NE(problem("-1" + std::string(400, '0')).find("too large"), std::string::npos);
  EXPECT_NE(problem("1e99999999999999999999999").find("too large"), std::string::npos);
  EXPECT_NE(problem("1" + std::string(500, '0') + "e-100").find("too large"), std::string::npos);
  for (const char* word : {"nan", "NaN", "-nan", "nan(1)"}) EXPECT_NE(problem(word).find("is NaN"), std::string::npos);
  for (const char* word : {"inf", "-Infinity", "+INF"}) EXPECT_NE(problem(word).find("infinite"), std::string::npos);
  EXPECT_NE(problem("1,5").find("comma"), std::string::npos);
  for (const char* word : {"", "+", "-", "+-1", "++1", "1e", "1x", "0x10", "e5", "1 2", "1e999x", ","}) {
    EXPECT_NE(problem(word).find("is not a number"), std::string::npos) << word;
  }
}

TEST(ParseNumber, IgnoresTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) GTEST_SKIP() << "no German locale here";
  EXPECT_EQ(read("1.5"), 1.5);
  std::setlocale(LC_ALL, before.c_str());
}

TEST(ParseInteger, ReadsWholeWordsOnly) {
  std::int64_t value = 0;
  EXPECT_TRUE(parse_integer("-12", value));
  EXPECT_EQ(value, -12);
  EXPECT_TRUE(parse_integer("+7", value));
  EXPECT_EQ(value, 7);
  for (const char* word : {"", "+", "+-1", "1.0", "1e3", "0x1", "9223372036854775808", " 1"}) {
    EXPECT_FALSE(parse_integer(word, value)) << word;
  }
}

TEST(OneLine, KeepsTextAndEscapesTheRest) {
  EXPECT_EQ(one_line("plain ~ text"), "plain ~ text");
  EXPECT_EQ(one_line("Gr\xc3\xb6\xc3\x9f"
                     "e \xe2\x82\xac \xf0\x9f\x98\x80"),
            "Gr\xc3\xb6\xc3\x9f"
            "e \xe2\x82\xac \xf0\x9f\x98\x80");
  EXPECT_EQ(one_line("a\nb\r\t\x1b\x7f"), "a\\x0ab\\x0d\\x09\\x1b\\x7f");
  EXPECT_EQ(one_line(std::string_view("\0", 1)), "\\x00");
  EXPECT_EQ(one_line("\xff\xc3"), "\\xff\\xc3");                    // no UTF-8; cut short
  EXPECT_EQ(one_line("\xc0\xaf"), "\\xc0\\xaf");                    // too long a form
  EXPECT_EQ(one_line("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // half a surrogate pair
  EXPECT_EQ(one_line("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond Unicode
  EXPECT_EQ(one_line("\xc2\x85"), "\\xc2\\x85");                    // next line
  EXPECT_EQ(one_line("\xe2\x80\xa8"), "\\xe2\\x80\\xa8");           // line separator
  // Marks of the direction of writing.
  EXPECT_EQ(one_line("\xe2\x80\xae"), "\\xe2\\x80\\xae");
  EXPECT_EQ(one_line("\xe2\x81\xa9\xd8\x9c"), "\\xe2\\x81\\xa9\\xd8\\x9c");
  EXPECT_EQ(one_line("\xe2\x80\xb0"), "\xe2\x80\xb0");
}

TEST(Quote, CutsLongText) {
  EXPECT_EQ(quote("x"), "'x'");
  EXPECT_EQ(quote(std::string(40, 'a')), "'" + std::string(40, 'a') + "'");
  EXPECT_EQ(quote(std::string(41, 'a')), "'" + std::string(40, 'a') + "...'");
}

TEST(Fail, NamesThePlaceInOneLine) {
  try {
    fail_line("a\nb.obj", 7, "wrong");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_EQ(error.place(), "a\\x0ab.obj:7");
    EXPECT_STREQ(error.what(), "a\\x0ab.obj:7: wrong");
  }
}

TEST(TextReader, CountsLinesOfEveryEnding) {
  TextReader reader("a\nb\r\nc\rd", "f", {});
  std::string seen;
  while (reader.next_line()) seen += std::string(reader.word()) + std::to_string(reader.line());
  EXPECT_EQ(seen, "a1b2c3d4");
  EXPECT_EQ(reader.line(), 4u);
}

TEST(TextReader, SkipsBlankLinesAndComments) {
  TextReader reader("\xef\xbb\xbf\n  # nothing \\\n\t\r\n a b#c #d\n#e", "f", {.comments = true, .continued = true});
  ASSERT_TRUE(reader.next_line());
  EXPECT_EQ(reader.line(), 4u);
  EXPECT_EQ(reader.word(), "a");
  EXPECT_EQ(reader.word(), "b#c");
  EXPECT_EQ(reader.word(), "");
  EXPECT_EQ(reader.word(), "");
  EXPECT_FALSE(reader.next_line());
  EXPECT_FALSE(reader.next_line());
}

TEST(TextReader, JoinsContinuedLines) {
  TextReader reader("a \\\n b\\\r\n\\\nc d\\e \\\nf\ng\\", "f", {.comments = true, .continued = true});
  ASSERT_TRUE(reader.next_line());
  for (const char* expected : {"a", "b", "c", "d\\e", "f", ""}) EXPECT_EQ(reader.word(), expected);
  EXPECT_EQ(reader.line(), 5u);
  ASSERT_TRUE(reader.next_line());
  EXPECT_EQ(reader.line(), 6u);
  EXPECT_EQ(reader.word(), "g");
  EXPECT_EQ(reader.word(), "");
}

TEST(TextReader, GoesOverTheRestOfALine) {
  TextReader reader("a b c\nd  e f \n", "f", {});
  ASSERT_TRUE(reader.next_line());
  EXPECT_EQ(reader.word(), "a");
  ASSERT_TRUE(reader.next_line());
  EXPECT_EQ(reader.word(), "d");
  EXPECT_EQ(reader.rest_of_line(), "e f");
  EXPECT_FALSE(reader.next_line());
  EXPECT_EQ(reader.line(), 2u) << "a line break at the end begins no new line";
}

TEST(TextReader, ReadsNothingFromNothing) {
  for (const char* text : {"", "\n", "  ", "\xef\xbb\xbf", "\\\n"}) {
    TextReader reader(text, "f", {.comments = true, .continued = true});
    EXPECT_FALSE(reader.next_line());
    EXPECT_EQ(TextReader(text, "f", {}).word_of_any_line().empty(), std::string_view(text) != "\\\n");
  }
}

}  // namespace
}  // namespace sunder::io
