#include <sunder/io/text/bytes.h>
#include <sunder/io/text/npy.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

namespace sunder::io {

namespace {

constexpr std::string_view magic = "\x93NUMPY";

// The header of an NPY file: a dictionary of Python with three keys.
class Header {
 public:
  Header(std::string_view text, std::string_view place) : text_(text), place_(place) {}

  // After `key`: the rest of the header.
  std::string_view after(std::string_view key) const {
    const std::size_t at = text_.find(fmt::format("'{}':", key));
    if (at == std::string_view::npos) fail(fmt::format("its header has no '{}'", key));
    return trimmed(text_.substr(at + key.size() + 3));
  }

  [[noreturn]] void fail(const std::string& what) const {
    fail_file(place_, what +
                          "; give an array of two dimensions, float64, float32 or whole numbers, as numpy.save() "
                          "writes it");
  }

 private:
  std::string_view text_, place_;
};

std::array<std::size_t, 2> shape_of(const Header& header) {
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

// The number as a double; nothing where near-by whole numbers would be rounded.
using Load = std::optional<double> (*)(const char*, ByteOrder);

template <class Number>
std::optional<double> load_exactly(const char* from, ByteOrder order) {
  const auto number = load<Number>(from, order);
  const auto value = static_cast<double>(number);
  if constexpr (sizeof(Number) == 8 && !std::is_floating_point_v<Number>) {
    constexpr Number most = Number{1} << 53;  // up to here every whole number is a double
    if (number > most || (std::is_signed_v<Number> && number < Number{0} - most)) return std::nullopt;
  }
  return value;
}

struct Kind {
  std::string_view name;
  std::size_t size;
  Load load;
};

constexpr std::array<Kind, 10> kinds{{{"f8", 8, load_exactly<double>},
                                      {"f4", 4, load_exactly<float>},
                                      {"i8", 8, load_exactly<std::int64_t>},
                                      {"i4", 4, load_exactly<std::int32_t>},
                                      {"i2", 2, load_exactly<std::int16_t>},
                                      {"i1", 1, load_exactly<std::int8_t>},
                                      {"u8", 8, load_exactly<std::uint64_t>},
                                      {"u4", 4, load_exactly<std::uint32_t>},
                                      {"u2", 2, load_exactly<std::uint16_t>},
                                      {"u1", 1, load_exactly<std::uint8_t>}}};

}  // namespace

bool is_npy(std::string_view bytes) { return bytes.starts_with(magic); }

NpyArray parse_npy(std::string_view bytes, std::string_view place) {
  const auto byte = [&](std::size_t at) {
    return at < bytes.size() ? std::size_t{static_cast<unsigned char>(bytes[at])} : 0;
  };
  if (!is_npy(bytes)) fail_file(place, "it does not begin as an NPY file does; write it with numpy.save()");
  const std::size_t version = byte(6), start = version == 1 ? 10 : 12;
  std::size_t length = byte(8) | byte(9) << 8;
  if (version >= 2) length |= byte(10) << 16 | byte(11) << 24;
  if (version < 1 || version > 3) fail_file(place, fmt::format("NPY version {} is not known; 1, 2, 3 are", version));
  if (bytes.size() < start || length > bytes.size() - start) fail_file(place, "the file is cut off; write it again");
  const Header header(bytes.substr(start, length), place);
  const std::string_view data = bytes.substr(start + length), described = header.after("descr");
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& one) {
    return described.size() > 4 && described[0] == '\'' && described.substr(2).starts_with(one.name) &&
           described[4] == '\'';
  });
  if (kind == kinds.end() || std::string_view("<>|").find(described[1]) == std::string_view::npos) {
    header.fail("its numbers are of kind " + quote(described.substr(0, std::min(described.find(','), std::size_t{8}))));
  }
  const ByteOrder order = described[1] == '>' ? ByteOrder::big_endian : ByteOrder::little_endian;
  const std::string_view fortran = header.after("fortran_order");
  const bool is_by_columns = fortran.starts_with("True");
  if (!is_by_columns && !fortran.starts_with("False")) header.fail("its order is not told");
  const auto [rows, columns] = shape_of(header);
  if (columns == 0 || rows == 0) header.fail("it is empty");
  if (columns > data.size() || rows > data.size() / columns / kind->size ||
      data.size() != rows * columns * kind->size) {
    fail_file(place, fmt::format("{} bytes of numbers, but the header says {} x {} of {}; write it again", data.size(),
                                 rows, columns, kind->size));
  }
  NpyArray array{rows, columns, {}};
  array.values.reserve(rows * columns);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t at = is_by_columns ? column * rows + row : row * columns + column;
      const std::optional<double> value = kind->load(data.data() + at * kind->size, order);
      if (!value || !std::isfinite(*value)) {
        throw Error(ErrorCode::bad_file,
                    fmt::format("column {} {}", column,
                                value ? "is not finite; give a finite number" : "is no double; give float64"),
                    fmt::format("{}: row {}", place, row));
      }
      array.values.push_back(*value);
    }
  }
  return array;
}

}  // namespace sunder::io
