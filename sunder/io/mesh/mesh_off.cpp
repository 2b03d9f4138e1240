#include <sunder/io/mesh/mesh_builder.h>
#include <sunder/io/mesh/mesh_formats.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/text_reader.h>

#include <fmt/format.h>

#include <algorithm>

namespace sunder::io {
namespace {

struct OffHeader {
  bool valid = false;
  bool extras = false;      // numbers may follow x y z
  bool dimensions = false;  // not three-dimensional
};

bool take(std::string_view& word, std::string_view prefix) {
  if (!word.starts_with(prefix)) return false;
  word.remove_prefix(prefix.size());
  return true;
}

OffHeader off_header(std::string_view word) {
  OffHeader header;
  const bool texture = take(word, "ST"), colour = take(word, "C"), normal = take(word, "N");
  const bool four = take(word, "4"), any = take(word, "n");
  header.extras = texture || colour || normal;
  header.dimensions = four || any;
  header.valid = word == "OFF";
  return header;
}

class OffParser {
 public:
  OffParser(std::string_view bytes, std::string_view place)
      : reader_(bytes, place, {.comments = true, .continued = false}), builder_(place), size_(bytes.size()) {}

  Mesh parse() {
    read_header();
    // A line of a vertex has at least 6 bytes: room for no more than the file can hold.
    builder_.reserve_vertices(std::min(static_cast<std::size_t>(vertices_), size_ / 6 + 1));
    for (std::int64_t i = 0; i < vertices_; ++i) {
      next_row("vertices", i, vertices_);
      read_vertex(i);
    }
    for (std::int64_t i = 0; i < faces_; ++i) {
      next_row("faces", i, faces_);
      read_face();
    }
    if (reader_.next_line()) {
      reader_.fail(
          fmt::format("{} follows after the {} vertices and {} faces of the counts; correct the counts or export "
                      "the mesh again",
                      quote(reader_.rest_of_line()), vertices_, faces_));
    }
    return builder_.finish("OFF");
  }

 private:
  void read_header() {
    const std::string_view word = reader_.word_of_any_line();
    const OffHeader header = off_header(word);
    if (!header.valid) reader_.fail(fmt::format("expected 'OFF', found {}; this is no OFF file", quote(word)));
    if (header.dimensions) reader_.fail(fmt::format("'{}' has points that are not of space; export it as OFF", word));
    extras_ = header.extras;

    std::string_view first = reader_.word();
    if (first == "BINARY") reader_.fail("binary OFF is not read; export the mesh as text");
    if (first.empty() && !reader_.next_line()) reader_.fail("the file ends before the counts; export or copy it again");
    vertices_ = count(first.empty() ? reader_.word() : first, "vertices");
    faces_ = count(reader_.word(), "faces");
    if (const std::string_view edges = reader_.word(); !edges.empty()) count(edges, "edges");
    if (!reader_.word().empty()) reader_.fail("expected 3 counts (vertices, faces, edges); export the mesh again");
    if (vertices_ == 0) reader_.fail("the counts promise no vertices; export the mesh again");
  }

  std::int64_t count(std::string_view word, std::string_view what) const {
    if (word.empty()) reader_.fail(fmt::format("the count of {} is missing; export the mesh again", what));
    std::int64_t value = 0;
    if (!parse_integer(word, value) || value < 0) {
      reader_.fail(
          fmt::format("the count of {} is {}, expected an integer from 0; export the mesh again", what, quote(word)));
    }
    return value;
  }

  void next_row(std::string_view what, std::int64_t done, std::int64_t promised) {
    if (reader_.next_line()) return;
    reader_.fail(fmt::format("the file ends after {} of {} {}; correct the counts, or export or copy it again", done,
                             promised, what));
  }

  void read_vertex(std::int64_t number) {
    builder_.add_vertex(reader_.point("vertex"));
    if (!extras_ && !reader_.word().empty()) {
      reader_.fail(
          fmt::format("vertex {} of {} has more than 3 numbers; correct the counts, or announce normals or "
                      "colours as NOFF and COFF do",
                      number + 1, vertices_));
    }
  }

  void read_face() {
    const std::int64_t corners = reader_.integer("the number of corners", 0, std::int64_t{1} << 32);
    if (corners < fewest_corners) {
      reader_.fail(fmt::format(
          "this face has {} corners, expected at least 3; correct the counts or export the mesh again", corners));
    }
    for (std::int64_t i = 0; i < corners; ++i) {
      const std::string_view word = reader_.word();
      if (word.empty()) {
        reader_.fail(fmt::format("this face has {} of {} corners; expected all in one line", i, corners));
      }
      std::int64_t index = 0;
      if (!parse_integer(word, index) || index < 0 || index >= vertices_) {
        reader_.fail(fmt::format("this face names vertex {}, but there are {}, numbered from 0; export the mesh again",
                                 quote(word), vertices_));
      }
      builder_.add_corner(static_cast<std::uint32_t>(index));
    }
    builder_.end_polygon();
  }

  TextReader reader_;
  MeshBuilder builder_;
  std::size_t size_;
  std::int64_t vertices_ = 0, faces_ = 0;
  bool extras_ = false;
};

}  // namespace

bool is_off_header(std::string_view word) { return off_header(word).valid; }

Mesh parse_off(std::string_view bytes, std::string_view place) { return OffParser(bytes, place).parse(); }

}  // namespace sunder::io
