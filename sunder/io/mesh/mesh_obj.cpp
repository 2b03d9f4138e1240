#include <sunder/io/mesh/mesh_builder.h>
#include <sunder/io/mesh/mesh_formats.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/text_reader.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sunder::io {
namespace {

// Statements that do not change which points the mesh is made of.
constexpr std::array<std::string_view, 16> shapeless = {
    "vt",     "vn",     "vp",    "g",   "s",        "mg",       "usemtl",     "mtllib",
    "usemap", "maplib", "bevel", "lod", "c_interp", "d_interp", "shadow_obj", "trace_obj"};

constexpr std::array<std::string_view, 20> free_form = {"cstype", "deg",  "bmat", "step", "curv",  "curv2", "surf",
                                                        "parm",   "trim", "hole", "scrv", "sp",    "end",   "con",
                                                        "bzp",    "bsp",  "cdp",  "cdc",  "ctech", "stech"};

template <class Words>
bool contains(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjParser {
 public:
  ObjParser(std::string_view bytes, std::string_view place, PartsOf parts)
      : reader_(bytes, place, {.comments = true, .continued = true}), builder_(place), place_(place), parts_(parts) {}

  Mesh parse() {
    while (reader_.next_line()) statement();
    if (largest_ahead_ > builder_.vertex_count()) {
      fail_line(place_, line_of_largest_, out_of_range(largest_ahead_));
    }
    // Without faces all vertices stand for the object, those of lines and points too.
    if (has_faces_) {
      builder_.leave_out("line", lines_);
      builder_.leave_out("point", points_);
    }
    return builder_.finish("OBJ");
  }

 private:
  void statement() {
    const std::string_view keyword = reader_.word();
    if (keyword == "v") {
      vertex();
    } else if (keyword == "f" || keyword == "fo") {
      face();
    } else if (keyword == "o") {
      builder_.begin_part(reader_.rest_of_line());
    } else if (keyword == "g" && parts_ == PartsOf::objects_and_groups) {
      builder_.begin_part(reader_.word());
    } else if (contains(free_form, keyword)) {
      reader_.fail(fmt::format("'{}' is about free-form curves and surfaces; export the mesh as polygons", keyword));
    } else if (keyword == "l") {
      ++lines_;
    } else if (keyword == "p") {
      while (!reader_.word().empty()) ++points_;
    } else if (!contains(shapeless, keyword)) {
      reader_.fail(fmt::format("{} is no statement of an OBJ file; export the mesh again", quote(keyword)));
    }
  }

  void vertex() {
    builder_.add_vertex(reader_.point("vertex"));
    int more = 0;
    for (std::string_view word = reader_.word(); !word.empty(); word = reader_.word(), ++more) {
      reader_.to_number(word, "the number after x y z");
    }
    if (more != 0 && more != 1 && more != 3 && more != 4) {
      reader_.fail(
          fmt::format("this vertex has {} numbers; expected x y z, with a weight or a colour at most", 3 + more));
    }
  }

  void face() {
    for (std::string_view word = reader_.word(); !word.empty(); word = reader_.word()) corner(word);
    if (builder_.corner_count() < fewest_corners) {
      reader_.fail(
          fmt::format("this face has {} corners, expected at least 3; export the mesh again", builder_.corner_count()));
    }
    builder_.end_polygon();
    has_faces_ = true;
  }

  void corner(std::string_view word) {
    std::array<std::string_view, 3> fields;
    std::size_t count = 0;
    for (std::string_view left = word;;) {
      const std::size_t slash = left.find('/');
      if (count == fields.size()) malformed(word);
      fields[count++] = left.substr(0, slash);
      if (slash == std::string_view::npos) break;
      left.remove_prefix(slash + 1);
    }
    std::int64_t index = 0, ignored = 0;
    if (!parse_integer(fields[0], index)) malformed(word);
    if (!fields[1].empty() && !parse_integer(fields[1], ignored)) malformed(word);
    if (!fields[2].empty() && !parse_integer(fields[2], ignored)) malformed(word);
    builder_.add_corner(vertex_number(index));
  }

  std::uint32_t vertex_number(std::int64_t index) {
    const std::int64_t count = builder_.vertex_count();
    if (index == 0) reader_.fail("this face names vertex 0, but vertices are numbered from 1; export the mesh again");
    if (index < -count || index > std::int64_t{MeshBuilder::largest_vertex} + 1) reader_.fail(out_of_range(index));
    if (index > count && index > largest_ahead_) {
      largest_ahead_ = index;
      line_of_largest_ = reader_.line();
    }
    return static_cast<std::uint32_t>(index < 0 ? count + index : index - 1);
  }

  std::string out_of_range(std::int64_t index) const {
    const std::string known = index < 0 ? "so far" : "in all";
    return fmt::format("this face names vertex {}, but there are {} {}; export the mesh again", index,
                       builder_.vertex_count(), known);
  }

  [[noreturn]] void malformed(std::string_view word) const {
    reader_.fail(fmt::format("the corner {} of this face is none of v, v/vt, v//vn, v/vt/vn; export the mesh again",
                             quote(word)));
  }

  TextReader reader_;
  MeshBuilder builder_;
  std::string_view place_;
  PartsOf parts_;
  std::int64_t largest_ahead_ = 0;  // the largest number of a vertex that was not there yet
  std::size_t line_of_largest_ = 0;
  bool has_faces_ = false;
  std::uint64_t lines_ = 0, points_ = 0;
};

}  // namespace

Mesh parse_obj(std::string_view bytes, std::string_view place, PartsOf parts) {
  return ObjParser(bytes, place, parts).parse();
}

}  // namespace sunder::io
