#include <sunder/io/csv.h>
#include <sunder/io/file.h>
#include <sunder/io/joint_table.h>
#include <sunder/io/npy.h>
#include <sunder/io/text.h>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::io {

namespace {

// Rows as they mostly are, read at once: numbers, separators and line feeds, with blanks before numbers at most. False
// where there is anything else, wrong or only unusual; then nothing is added that counts.
bool add_plain_rows(std::string_view rows, char separator, std::uint32_t line, JointTable& table) {
  const char* at = rows.data();
  const char* const end = at + rows.size();
  for (; at != end; ++line) {
    if (*at == '\n') {
      ++at;
      continue;
    }
    for (std::size_t k = 0; k < table.columns; ++k) {
      while (at != end && (*at == ' ' || *at == '\t')) ++at;
      double value = 0;
      const auto result = fast_float::from_chars(at, end, value);
      if (result.ec == std::errc::invalid_argument || !std::isfinite(value)) return false;
      table.values.push_back(value);
      at = result.ptr;
      if (k + 1 == table.columns) break;
      if (at == end || *at++ != separator) return false;
    }
    table.lines.push_back(line);
    if (at != end && *at == '\r') ++at;
    if (at != end && *at++ != '\n') return false;
  }
  return true;
}

JointTable of_csv(std::string_view text, std::string_view place) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // a byte order mark
  JointTable table;
  table.file = place;
  CsvReader reader(text, place);
  while (reader.next()) {
    const CsvReader::Fields& fields = reader.fields();
    if (reader.is_first()) {
      for (const std::string_view name : fields) {
        double number = 0;
        if (name.empty()) reader.fail("a column has no name; name the joints in the first line");
        if (parse_number(name, number) == nullptr) {
          reader.fail(quote(name) + " is a number; name the joints in the first line");
        }
        if (std::find(table.joints.begin(), table.joints.end(), name) != table.joints.end()) {
          reader.fail("joint " + quote(name) + " comes twice; keep one of the columns");
        }
        table.joints.emplace_back(name);
      }
      table.columns = fields.size();
      const std::size_t first = text.find_first_of("\r\n");
      const std::string_view names = text.substr(0, first);
      if (reader.line() == 1 && first != std::string_view::npos && names.find('"') == std::string_view::npos) {
        const std::size_t rows = first + (text.substr(first).starts_with("\r\n") ? 2 : 1);
        const char separator = names.find(';') == std::string_view::npos ? ',' : ';';
        if (add_plain_rows(text.substr(rows), separator, 2, table)) return table;
        table.values.clear();
        table.lines.clear();
      }
      continue;
    }
    if (fields.size() != table.columns) {
      reader.fail(fmt::format("{}, but {}; give each joint a value", count_of(fields.size(), "field"),
                              count_of(table.columns, "column")));
    }
    for (std::size_t k = 0; k < fields.size(); ++k) {
      double value = 0;
      if (const char* problem = parse_number(fields[k], value)) {
        reader.fail("joint " + quote(table.joints[k]) + ": " + quote(fields[k]) + " " + problem);
      }
      table.values.push_back(value);
    }
    table.lines.push_back(reader.line());
  }
  return table;
}

JointTable of_npy(std::string_view bytes, std::string_view place) {
  NpyArray array = parse_npy(bytes, place);
  JointTable table;
  table.file = place;
  table.columns = array.columns;
  table.values = std::move(array.values);
  return table;
}

}  // namespace

std::string JointTable::place(std::size_t row) const {
  return lines.empty() ? fmt::format("{}: row {}", file, row) : fmt::format("{}:{}", file, lines[row]);
}

JointTable parse_joint_table(std::string_view bytes, std::string_view place) {
  JointTable table = is_npy(bytes) ? of_npy(bytes, place) : of_csv(bytes, place);
  if (table.rows() == 0) fail_file(place, "there is no placement; give a line of values, after that of the names");
  return table;
}

JointTable read_joint_table(const std::string& file, InputFiles* inputs) {
  return parse_joint_table(read_file(file, inputs), one_line(file));
}

}  // namespace sunder::io
