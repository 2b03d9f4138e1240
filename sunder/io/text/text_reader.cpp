#include <sunder/io/text/text.h>
#include <sunder/io/text/text_reader.h>

#include <fmt/format.h>

namespace sunder::io {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

bool is_break(char c) { return c == '\n' || c == '\r'; }

}  // namespace

TextReader::TextReader(std::string_view text, std::string_view file, Options options)
    : text_(text), file_(file), options_(options), at_(text.starts_with("\xef\xbb\xbf") ? 3 : 0) {}

std::size_t TextReader::after_break(std::size_t at) const {
  if (at == text_.size() || !is_break(text_[at])) return at;
  return at + (text_.substr(at).starts_with("\r\n") ? 2 : 1);
}

std::size_t TextReader::after_continuation(std::size_t at) const {
  if (!options_.continued || at == text_.size() || text_[at] != '\\') return at;
  const std::size_t behind = after_break(at + 1);
  return behind > at + 1 || behind == text_.size() ? behind : at;
}

void TextReader::skip_blanks() {
  while (at_ < text_.size()) {
    if (is_blank(text_[at_])) {
      ++at_;
    } else if (const std::size_t behind = after_continuation(at_); behind > at_) {
      at_ = behind;
      ++line_;
    } else {
      return;
    }
  }
}

bool TextReader::at_end_of_line() const {
  return at_ == text_.size() || is_break(text_[at_]) || (options_.comments && text_[at_] == '#');
}

bool TextReader::next_line() {
  for (;;) {
    if (begun_) {
      while (!word().empty()) {
      }
      at_ = end_of_line();
      if (at_ == text_.size()) return false;
      ++line_;
    }
    begun_ = true;
    skip_blanks();
    if (!at_end_of_line()) return true;
  }
}

std::string_view TextReader::word() {
  skip_blanks();
  if (at_end_of_line()) return {};
  const std::size_t begin = at_;
  while (at_ < text_.size() && !is_blank(text_[at_]) && !is_break(text_[at_]) && after_continuation(at_) == at_) ++at_;
  return text_.substr(begin, at_ - begin);
}

std::string_view TextReader::word_of_any_line() {
  for (;;) {
    if (begun_) {
      if (const std::string_view found = word(); !found.empty()) return found;
    }
    if (!next_line()) return {};
  }
}

std::string_view TextReader::rest_of_line() {
  skip_blanks();
  const std::size_t begin = at_;
  while (at_ < text_.size() && !is_break(text_[at_])) ++at_;
  std::size_t end = at_;
  while (end > begin && is_blank(text_[end - 1])) --end;
  return text_.substr(begin, end - begin);
}

double TextReader::to_number(std::string_view word, std::string_view what) const {
  double value = 0;
  if (const char* problem = parse_number(word, value)) fail(fmt::format("{} {} {}", what, quote(word), problem));
  return value;
}

double TextReader::number(std::string_view what) {
  const std::string_view found = word();
  if (found.empty()) fail(fmt::format("expected a number for {}, found the end of the line; add it", what));
  return to_number(found, what);
}

Point3 TextReader::point(std::string_view what) {
  double numbers[3] = {};
  constexpr const char* names[3] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    const std::string_view found = word();
    if (found.empty()) fail(fmt::format("this {} has {} of 3 numbers; expected x y z in one line", what, i));
    numbers[i] = to_number(found, names[i]);
  }
  return {numbers[0], numbers[1], numbers[2]};
}

std::int64_t TextReader::integer(std::string_view what, std::int64_t lowest, std::int64_t highest) {
  const std::string_view found = word();
  if (found.empty()) fail(fmt::format("expected {}, found the end of the line; export the file again", what));
  std::int64_t value = 0;
  if (!parse_integer(found, value) || value < lowest || value > highest) {
    fail(fmt::format("{} is {}, expected an integer from {} to {}", what, quote(found), lowest, highest));
  }
  return value;
}

std::size_t TextReader::end_of_line() const {
  std::size_t end = at_;
  while (end < text_.size() && !is_break(text_[end])) ++end;
  return after_break(end);
}

void TextReader::fail(const std::string& text) const { fail_line(file_, line_, text); }

}  // namespace sunder::io
