#include <sunder/io/mesh/mesh_builder.h>
#include <sunder/io/mesh/mesh_formats.h>
#include <sunder/io/text/bytes.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/text_reader.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace sunder::io {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct TypeName {
  std::string_view old_name, new_name;
  Type type;
  std::size_t bytes;
};
constexpr TypeName type_names[] = {
    {"char", "int8", Type::int8, 1},        {"uchar", "uint8", Type::uint8, 1},
    {"short", "int16", Type::int16, 2},     {"ushort", "uint16", Type::uint16, 2},
    {"int", "int32", Type::int32, 4},       {"uint", "uint32", Type::uint32, 4},
    {"float", "float32", Type::float32, 4}, {"double", "float64", Type::float64, 8},
};

std::size_t bytes_of(Type type) { return type_names[static_cast<std::size_t>(type)].bytes; }

bool is_integer(Type type) { return type < Type::float32; }

// What becomes of a property.
enum class Use { none, x, y, z, corners };

struct Property {
  Use use = Use::none;
  std::optional<Type> count;  // of a list
  Type type = Type::int8;
};

struct Element {
  std::string_view name;
  std::int64_t rows = 0;
  std::vector<Property> properties;
};

struct Header {
  std::string_view format;
  std::vector<Element> elements;
  std::size_t body = 0;  // where it begins
};

class HeaderParser {
 public:
  explicit HeaderParser(TextReader& reader) : reader_(reader) {}

  Header parse() {
    if (const std::string_view word = reader_.word_of_any_line(); word != "ply") {
      reader_.fail(fmt::format("expected 'ply', found {}; this is no PLY file", quote(word)));
    }
    for (;;) {
      if (!reader_.next_line()) reader_.fail("the file ends inside the header; export or copy it again");
      const std::string_view keyword = reader_.word();
      if (keyword == "end_header") break;
      statement(keyword);
    }
    if (header_.format.empty()) reader_.fail("the header names no format; expected 'format ascii 1.0' or such");
    check_vertex_element();
    header_.body = reader_.end_of_line();
    return std::move(header_);
  }

 private:
  void statement(std::string_view keyword) {
    if (keyword == "comment" || keyword == "obj_info") return;
    if (keyword == "format") return format();
    if (keyword == "element") return element();
    if (keyword == "property") return property();
    reader_.fail(fmt::format("{} is no line of a PLY header; export the mesh again", quote(keyword)));
  }

  void format() {
    const std::string_view name = reader_.word(), version = reader_.word();
    if (name != "ascii" && name != "binary_little_endian" && name != "binary_big_endian") {
      reader_.fail(
          fmt::format("unknown format {}; known are ascii, binary_little_endian, binary_big_endian", quote(name)));
    }
    if (version != "1.0") reader_.fail(fmt::format("unknown version {} of PLY; known is 1.0", quote(version)));
    if (!header_.format.empty()) reader_.fail("the format is named twice; export the mesh again");
    header_.format = name;
  }

  void element() {
    Element next;
    next.name = reader_.word();
    const std::string_view rows = reader_.word();
    if (!parse_integer(rows, next.rows) || next.rows < 0) {
      reader_.fail(
          fmt::format("the count of the element {} is {}, expected an integer from 0", quote(next.name), quote(rows)));
    }
    const auto same = [&](const Element& other) { return other.name == next.name; };
    if (std::any_of(header_.elements.begin(), header_.elements.end(), same)) {
      reader_.fail(fmt::format("the element {} comes twice; export the mesh again", quote(next.name)));
    }
    header_.elements.push_back(std::move(next));
  }

  Type type() {
    const std::string_view word = reader_.word();
    for (const TypeName& known : type_names) {
      if (word == known.old_name || word == known.new_name) return known.type;
    }
    reader_.fail(
        fmt::format("unknown type {}; known are char, uchar, short, ushort, int, uint, float, double", quote(word)));
  }

  void property() {
    if (header_.elements.empty()) reader_.fail("a property stands before the first element; export the mesh again");
    Element& owner = header_.elements.back();
    // "list" or a type: look at a copy of the reader first.
    Property next;
    TextReader ahead = reader_;
    if (ahead.word() == "list") {
      reader_ = ahead;
      next.count = type();
      if (!is_integer(*next.count)) reader_.fail("the length of a list must be of an integer type; export it again");
    }
    next.type = type();
    const std::string_view name = reader_.word();
    if (name.empty()) reader_.fail("this property has no name; export the mesh again");
    next.use = use(owner, name);
    if (next.use != Use::none) check(owner, next, name);
    owner.properties.push_back(next);
  }

  static Use use(const Element& owner, std::string_view name) {
    if (owner.name == "vertex") {
      if (name == "x") return Use::x;
      if (name == "y") return Use::y;
      if (name == "z") return Use::z;
    }
    if (owner.name == "face" && (name == "vertex_indices" || name == "vertex_index")) return Use::corners;
    return Use::none;
  }

  void check(const Element& owner, const Property& next, std::string_view name) const {
    const auto same = [&](const Property& other) { return other.use == next.use; };
    if (std::any_of(owner.properties.begin(), owner.properties.end(), same)) {
      reader_.fail(fmt::format("the property '{}' comes twice; export the mesh again", name));
    }
    if (next.use == Use::corners && !(next.count && is_integer(next.type))) {
      reader_.fail(fmt::format("'{}' must be a list of integers; export the mesh again", name));
    }
    if (next.use != Use::corners && next.count) {
      reader_.fail(fmt::format("'{}' of a vertex must be one number, not a list; export the mesh again", name));
    }
  }

  void check_vertex_element() const {
    for (const Element& element : header_.elements) {
      if (element.name != "vertex") continue;
      for (const Use use : {Use::x, Use::y, Use::z}) {
        const auto same = [&](const Property& property) { return property.use == use; };
        if (std::none_of(element.properties.begin(), element.properties.end(), same)) {
          reader_.fail(fmt::format("the element 'vertex' has no property '{}'; export the mesh again",
                                   "xyz"[static_cast<int>(use) - static_cast<int>(Use::x)]));
        }
      }
      if (element.rows == 0) reader_.fail("the header promises no vertices; export the mesh again");
      check_face_element();
      return;
    }
    reader_.fail("the header has no element 'vertex'; export the mesh again");
  }

  void check_face_element() const {
    for (const Element& element : header_.elements) {
      const auto is_corners = [](const Property& property) { return property.use == Use::corners; };
      if (element.name == "face" && element.rows > 0 &&
          std::none_of(element.properties.begin(), element.properties.end(), is_corners)) {
        reader_.fail("the element 'face' has no list 'vertex_indices'; export the mesh again");
      }
    }
  }

  TextReader& reader_;
  Header header_;
};

// The rows as text, one per line. AsciiBody and BinaryBody have the same members, for BodyParser.
class AsciiBody {
 public:
  AsciiBody(TextReader& reader, const Header&) : reader_(reader) {}

  // As many rows as there can be, to reserve memory for them; may throw when the body is too short.
  std::size_t check_rows(const Element& element, std::size_t file_bytes) const {
    return std::min(static_cast<std::size_t>(element.rows), file_bytes / (2 * element.properties.size()) + 1);
  }

  void begin_row(const Element& element, std::int64_t row) {
    if (reader_.next_line()) return;
    reader_.fail(
        fmt::format("the file ends after {} of {} rows of the element {}; correct the count, or export or copy "
                    "it again",
                    row, element.rows, quote(element.name)));
  }

  void end_row() {
    if (const std::string_view word = reader_.word(); !word.empty()) {
      reader_.fail(fmt::format("{} follows after the last property of this row; export the mesh again", quote(word)));
    }
  }

  double number(Type, std::string_view what) { return reader_.number(what); }

  std::int64_t integer(Type, std::string_view what) {
    std::int64_t value = 0;
    const std::string_view found = word(what);
    if (!parse_integer(found, value)) {
      reader_.fail(fmt::format("{} is {}, expected an integer; export the mesh again", what, quote(found)));
    }
    return value;
  }

  void check_list(Type, std::int64_t) const {}

  void skip(Type, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) word("a property");
  }

  void end() {
    if (reader_.next_line()) {
      reader_.fail(
          fmt::format("{} follows after the rows that the header promises; correct the counts or export the mesh "
                      "again",
                      quote(reader_.rest_of_line())));
    }
  }

  [[noreturn]] void fail(const std::string& text) const { reader_.fail(text); }

 private:
  std::string_view word(std::string_view what) {
    const std::string_view found = reader_.word();
    if (found.empty()) {
      reader_.fail(fmt::format("expected {}, found the end of the line; expected one row per line", what));
    }
    return found;
  }

  TextReader& reader_;
};

class BinaryBody {
 public:
  BinaryBody(std::string_view bytes, std::string_view place, const Header& header)
      : bytes_(bytes),
        place_(place),
        at_(header.body),
        value_at_(header.body),
        order_(header.format == "binary_big_endian" ? ByteOrder::big_endian : ByteOrder::little_endian) {}

  std::size_t check_rows(const Element& element, std::size_t) {
    std::size_t row_bytes = 0;
    for (const Property& property : element.properties) row_bytes += bytes_of(property.count.value_or(property.type));
    const auto rows = static_cast<std::uint64_t>(element.rows);
    if (rows > left() / row_bytes) {
      value_at_ = at_;
      fail(fmt::format(
          "the header promises {} rows of the element {}, at least {} bytes each, but {} bytes follow; export "
          "or copy it again",
          rows, quote(element.name), row_bytes, left()));
    }
    return static_cast<std::size_t>(rows);
  }

  void begin_row(const Element&, std::int64_t) {}
  void end_row() {}

  double number(Type type, std::string_view what) {
    const double value = type == Type::float32   ? static_cast<double>(take<float>())
                         : type == Type::float64 ? take<double>()
                                                 : static_cast<double>(integer(type, what));
    if (!std::isfinite(value)) {
      fail(fmt::format("{} is {}; every number must be finite: repair the mesh", what,
                       std::isnan(value) ? "NaN" : "infinite"));
    }
    return value;
  }

  std::int64_t integer(Type type, std::string_view) {
    switch (type) {
      case Type::int8: return take<std::int8_t>();
      case Type::uint8: return take<std::uint8_t>();
      case Type::int16: return take<std::int16_t>();
      case Type::uint16: return take<std::uint16_t>();
      case Type::int32: return take<std::int32_t>();
      case Type::uint32: return take<std::uint32_t>();
      case Type::float32:
      case Type::float64: break;
    }
    fail("expected an integer; export the mesh again");
  }

  void check_list(Type type, std::int64_t count) {
    if (static_cast<std::uint64_t>(count) <= left() / bytes_of(type)) return;
    fail(fmt::format("a list promises {} entries of {} bytes, but {} bytes follow; export or copy it again", count,
                     bytes_of(type), left()));
  }

  void skip(Type type, std::int64_t count) {
    check_list(type, count);
    at_ += static_cast<std::size_t>(count) * bytes_of(type);
  }

  void end() {
    if (left() == 0) return;
    value_at_ = at_;
    fail(fmt::format(
        "{} bytes follow after the rows that the header promises; correct the counts or export the mesh again",
        left()));
  }

  [[noreturn]] void fail(const std::string& text) const { fail_byte(place_, value_at_, text); }

 private:
  std::uint64_t left() const { return bytes_.size() - at_; }

  template <class Number>
  Number take() {
    value_at_ = at_;
    if (left() < sizeof(Number)) fail("the file ends inside a row; export or copy it again");
    at_ += sizeof(Number);
    return load<Number>(bytes_.data() + value_at_, order_);
  }

  std::string_view bytes_, place_;
  std::size_t at_, value_at_;  // the next value, and the last one read
  ByteOrder order_;
};

template <class Body>
class BodyParser {
 public:
  BodyParser(const Header& header, Body body, MeshBuilder& builder) : header_(header), body_(body), builder_(builder) {
    for (const Element& element : header.elements) {
      if (element.name == "vertex") vertices_ = element.rows;
    }
  }

  void parse(std::size_t file_bytes) {
    for (const Element& element : header_.elements) {
      if (!is_read(element.name)) builder_.leave_out(shorten(element.name), static_cast<std::uint64_t>(element.rows));
      if (element.properties.empty()) continue;
      const std::size_t rows = body_.check_rows(element, file_bytes);
      if (element.name == "vertex") builder_.reserve_vertices(rows);
      for (std::int64_t i = 0; i < element.rows; ++i) {
        body_.begin_row(element, i);
        row(element);
        body_.end_row();
      }
    }
    body_.end();
  }

 private:
  // Read, or about no shape.
  static bool is_read(std::string_view name) {
    return name == "vertex" || name == "face" || name == "camera" || name == "material" || name == "texture" ||
           name.starts_with("multi_texture");
  }

  void row(const Element& element) {
    Point3 point;
    for (const Property& property : element.properties) {
      switch (property.use) {
        case Use::none: skip(property); break;
        case Use::x: point.x = body_.number(property.type, "x"); break;
        case Use::y: point.y = body_.number(property.type, "y"); break;
        case Use::z: point.z = body_.number(property.type, "z"); break;
        case Use::corners: corners(property); break;
      }
    }
    if (element.name == "vertex") builder_.add_vertex(point);
  }

  std::int64_t list_length(const Property& property) {
    const std::int64_t length = body_.integer(*property.count, "the length of a list");
    if (length < 0) body_.fail(fmt::format("a list has {} entries, expected 0 or more; export the mesh again", length));
    body_.check_list(property.type, length);
    return length;
  }

  void skip(const Property& property) { body_.skip(property.type, property.count ? list_length(property) : 1); }

  void corners(const Property& property) {
    const std::int64_t length = list_length(property);
    if (length < fewest_corners) {
      body_.fail(fmt::format(
          "this face has {} corners, expected at least 3; correct the counts or export the mesh again", length));
    }
    for (std::int64_t i = 0; i < length; ++i) {
      const std::int64_t index = body_.integer(property.type, "a corner of a face");
      if (index < 0 || index >= vertices_) {
        body_.fail(fmt::format("this face names vertex {}, but there are {}, numbered from 0; export the mesh again",
                               index, vertices_));
      }
      builder_.add_corner(static_cast<std::uint32_t>(index));
    }
    builder_.end_polygon();
  }

  const Header& header_;
  Body body_;
  MeshBuilder& builder_;
  std::int64_t vertices_ = 0;
};

}  // namespace

Mesh parse_ply(std::string_view bytes, std::string_view place) {
  TextReader reader(bytes, place, {});
  const Header header = HeaderParser(reader).parse();
  MeshBuilder builder(place);
  if (header.format == "ascii") {
    BodyParser(header, AsciiBody(reader, header), builder).parse(bytes.size());
  } else {
    BodyParser(header, BinaryBody(bytes, place, header), builder).parse(bytes.size());
  }
  return builder.finish(fmt::format("PLY ({})", header.format));
}

}  // namespace sunder::io
