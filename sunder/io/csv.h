// Lines and fields of CSV text. For readers.
#pragma once

#include <sunder/io/text.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace sunder::io {

// Calls of_line(line, number) with each line that is not blank, without blanks around it, and its number, from 1. A
// line ends with LF, CR LF or CR. progress, if any, is called now and then with the part that is done, 0 to 1.
template <class OfLine>
void for_each_line(std::string_view text, const std::function<void(double)>& progress, const OfLine& of_line) {
  std::uint32_t number = 0;
  const double all = static_cast<double>(text.size());
  while (!text.empty()) {
    if (progress && number % 65536 == 0) progress(1 - static_cast<double>(text.size()) / all);
    ++number;
    const std::size_t end = text.find_first_of("\r\n");
    const std::string_view line = trimmed(text.substr(0, end));
    if (!line.empty()) of_line(line, number);
    const bool two = end != std::string_view::npos && text.substr(end, 2) == "\r\n";
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + (two ? 2 : 1));
  }
}

// The fields of a line, without blanks and without a pair of quotes around each. `fields` keeps its memory. False where
// a field has a quote within, which then is the last one: fields hold no separators and no quotes.
bool split_fields(std::string_view line, char separator, std::vector<std::string_view>& fields);

// Is this a line of names? None of the first `count` fields is a number, and the first begins as names do.
bool are_names(const std::vector<std::string_view>& fields, std::size_t count);

}  // namespace sunder::io
