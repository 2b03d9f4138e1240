#include <sunder/io/csv.h>
#include <sunder/io/file.h>
#include <sunder/io/joint_table.h>
#include <sunder/io/text.h>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace sunder::io {

namespace {

constexpr std::string_view npy_magic = "\x93NUMPY";

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

// The header of an NPY file: a dictionary of Python with three keys.
class NpyHeader {
 public:
  NpyHeader(std::string_view text, std::string_view place) : text_(text), place_(place) {}

  // After `key`: the rest of the header.
  std::string_view after(std::string_view key) const {
    const std::size_t at = text_.find(fmt::format("'{}':", key));
    if (at == std::string_view::npos) fail(fmt::format("its header has no '{}'", key));
    return trimmed(text_.substr(at + key.size() + 3));
  }

  [[noreturn]] void fail(const std::string& what) const {
    fail_file(place_, what + "; give an array of two dimensions, float64 or float32, as numpy.save() writes it");
  }

 private:
  std::string_view text_, place_;
};

std::array<std::size_t, 2> shape_of(const NpyHeader& header) {
  std::string_view text = header.after("shape");
  text = text.substr(0, text.find(')'));
  std::vector<std::size_t> sizes;
  if (!text.starts_with('(')) header.fail("its shape is not a tuple");
  text.remove_prefix(1);
  while (!trimmed(text).empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    std::int64_t size = 0;
    if (!parse_integer(trimmed(text.substr(0, comma)), size) || size < 0) header.fail("its shape is not of numbers");
    sizes.push_back(static_cast<std::size_t>(size));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  if (sizes.size() != 2) header.fail(fmt::format("it has {}", count_of(sizes.size(), "dimension")));
  return {sizes[0], sizes[1]};
}

template <class Float, class Bits>
double little_endian(const char* bytes) {
  Bits bits = 0;
  for (std::size_t k = 0; k < sizeof(Bits); ++k) {
    bits |= static_cast<Bits>(static_cast<Bits>(static_cast<unsigned char>(bytes[k])) << (8 * k));
  }
  return static_cast<double>(std::bit_cast<Float>(bits));
}

JointTable of_npy(std::string_view bytes, std::string_view place) {
  const auto byte = [&](std::size_t at) {
    return at < bytes.size() ? std::size_t{static_cast<unsigned char>(bytes[at])} : 0;
  };
  const std::size_t version = byte(6), start = version == 1 ? 10 : 12;
  std::size_t length = byte(8) | byte(9) << 8;
  if (version >= 2) length |= byte(10) << 16 | byte(11) << 24;
  if (version < 1 || version > 3) fail_file(place, fmt::format("NPY version {} is not known; 1, 2, 3 are", version));
  if (bytes.size() < start || length > bytes.size() - start) fail_file(place, "the file is cut off; write it again");
  const NpyHeader header(bytes.substr(start, length), place);
  const std::string_view data = bytes.substr(start + length), kind = header.after("descr");
  const bool is_double = kind.starts_with("'<f8'");
  if (!is_double && !kind.starts_with("'<f4'")) header.fail("its numbers are of kind " + quote(kind.substr(0, 6)));
  if (!header.after("fortran_order").starts_with("False")) header.fail("it is in Fortran order");
  const auto [rows, columns] = shape_of(header);
  const std::size_t size = is_double ? 8 : 4;
  if (columns == 0 || rows == 0) header.fail("it is empty");
  if (columns > data.size() || rows > data.size() / columns / size || data.size() != rows * columns * size) {
    fail_file(place, fmt::format("{} bytes of numbers, but the header says {} x {} of {}; write it again", data.size(),
                                 rows, columns, size));
  }
  JointTable table;
  table.file = place;
  table.columns = columns;
  table.values.reserve(rows * columns);
  for (std::size_t k = 0; k < rows * columns; ++k) {
    const char* at = data.data() + k * size;
    const double value = is_double ? little_endian<double, std::uint64_t>(at) : little_endian<float, std::uint32_t>(at);
    if (!std::isfinite(value)) {
      throw Error(ErrorCode::bad_file, fmt::format("column {} is not finite; give a finite number", k % columns),
                  table.place(k / columns));
    }
    table.values.push_back(value);
  }
  return table;
}

}  // namespace

std::string JointTable::place(std::size_t row) const {
  return lines.empty() ? fmt::format("{}: row {}", file, row) : fmt::format("{}:{}", file, lines[row]);
}

JointTable parse_joint_table(std::string_view bytes, std::string_view place) {
  JointTable table = bytes.starts_with(npy_magic) ? of_npy(bytes, place) : of_csv(bytes, place);
  if (table.rows() == 0) fail_file(place, "there is no placement; give a line of values, after that of the names");
  return table;
}

JointTable read_joint_table(const std::string& file, InputFiles* inputs) {
  return parse_joint_table(read_file(file, inputs), one_line(file));
}

}  // namespace sunder::io
