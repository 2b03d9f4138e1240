#include <sunder/io/mesh/mesh_builder.h>
#include <sunder/io/mesh/mesh_formats.h>
#include <sunder/io/text/bytes.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/text_reader.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sunder::io {
namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t count_offset = 80;
constexpr std::size_t triangle_bytes = 50;
constexpr std::size_t normal_bytes = 12;

char lower(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

std::uint64_t binary_count(std::string_view bytes) {
  return load<std::uint32_t>(bytes.data() + count_offset, ByteOrder::little_endian);
}

class AsciiStlParser {
 public:
  AsciiStlParser(std::string_view bytes, std::string_view place) : reader_(bytes, place, {}), builder_(place) {}

  Mesh parse() {
    while (reader_.next_line()) {
      expect("solid");
      builder_.begin_part(reader_.rest_of_line());
      while (!same_word(next("facet"), "endsolid")) facet();
      reader_.rest_of_line();
    }
    builder_.join_equal_vertices();
    return builder_.finish("STL (ASCII)");
  }

 private:
  // The word just read stands in word_, and is 'facet' or an error.
  void facet() {
    check("facet");
    expect("normal");
    for (int i = 0; i < 3; ++i) normal_number();
    expect("outer");
    expect("loop");
    for (int i = 0; i < 3; ++i) {
      expect("vertex");
      builder_.add_vertex(reader_.point("vertex"));
      builder_.add_corner(builder_.vertex_count() - 1);
    }
    builder_.end_polygon();
    expect("endloop");
    expect("endfacet");
  }

  // Any number, also NaN and infinite: programs write these for flat triangles.
  void normal_number() {
    const std::string_view word = next("a number of the normal");
    if (!is_number(word)) {
      reader_.fail(fmt::format("expected a number of the normal, found {}; export the mesh again", quote(word)));
    }
  }

  std::string_view next(std::string_view expected) {
    word_ = reader_.word_of_any_line();
    if (word_.empty()) {
      reader_.fail(
          fmt::format("the file ends where {} is expected; it is truncated: export or copy it again", expected));
    }
    return word_;
  }

  void check(std::string_view expected) const {
    if (!same_word(word_, expected)) {
      reader_.fail(fmt::format("expected {}, found {}; export the mesh again", expected, quote(word_)));
    }
  }

  void expect(std::string_view keyword) {
    next(keyword);
    check(keyword);
  }

  TextReader reader_;
  MeshBuilder builder_;
  std::string_view word_;
};

Mesh parse_binary(std::string_view bytes, std::string_view place) {
  if (bytes.size() < header_bytes) {
    fail_byte(place, bytes.size(), "the file ends inside the header of 84 bytes; this is no STL, or export it again");
  }
  const std::uint64_t count = binary_count(bytes);
  if (count == 0) fail_byte(place, count_offset, "the header promises no triangles; export the mesh again");
  const std::uint64_t expected = header_bytes + count * triangle_bytes;
  if (bytes.size() != expected) {
    fail_byte(place, count_offset,
              fmt::format("the header promises {} triangles, which take {} bytes, but the file has "
                          "{}; this is no STL, or export or copy it again",
                          count, expected, bytes.size()));
  }

  MeshBuilder builder(place);
  builder.reserve_vertices(3 * static_cast<std::size_t>(count));
  for (std::size_t at = header_bytes; at < bytes.size(); at += triangle_bytes) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t from = at + normal_bytes * (1 + corner);
      double numbers[3] = {};
      for (std::size_t i = 0; i < 3; ++i) {
        numbers[i] = static_cast<double>(load<float>(bytes.data() + from + 4 * i, ByteOrder::little_endian));
        if (!std::isfinite(numbers[i])) {
          fail_byte(place, from + 4 * i,
                    fmt::format("{} of a vertex is {}; every number must be finite: repair the mesh", "xyz"[i],
                                std::isnan(numbers[i]) ? "NaN" : "infinite"));
        }
      }
      builder.add_vertex({numbers[0], numbers[1], numbers[2]});
      builder.add_corner(builder.vertex_count() - 1);
    }
    builder.end_polygon();
  }
  builder.join_equal_vertices();
  return builder.finish("STL (binary)");
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < header_bytes) return false;
  const std::uint64_t count = binary_count(bytes);
  return count > 0 && bytes.size() == header_bytes + count * triangle_bytes;
}

Mesh parse_stl(std::string_view bytes, std::string_view place) {
  // Text has no zero bytes; a binary file that was cut short has some in its header, in the count at the latest.
  TextReader reader(bytes, place, {});
  const bool solid = same_word(reader.word_of_any_line(), "solid");
  const bool zeros = bytes.substr(0, header_bytes).find('\0') != std::string_view::npos;
  const bool text = solid && !zeros && !is_binary_stl(bytes);
  return text ? AsciiStlParser(bytes, place).parse() : parse_binary(bytes, place);
}

}  // namespace sunder::io
