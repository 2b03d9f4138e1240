#include <sunder/io/mesh/frame_internal.h>
#include <sunder/io/mesh/mesh_builder.h>
#include <sunder/io/mesh/mesh_formats.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace sunder::io {
namespace {

constexpr std::uint32_t most_nested_groups = 100;  // nodes within nodes

constexpr std::array<std::string_view, 4> groups{"Group", "Transform", "Anchor", "Collision"};

// Geometry and groups that are not read, and how they are told.
constexpr std::array<std::pair<std::string_view, const char*>, 13> told{{{"Box", "box"},
                                                                         {"Cone", "cone"},
                                                                         {"Cylinder", "cylinder"},
                                                                         {"Sphere", "sphere"},
                                                                         {"Extrusion", "extrusion"},
                                                                         {"ElevationGrid", "elevation grid"},
                                                                         {"IndexedLineSet", "set of lines"},
                                                                         {"PointSet", "set of points"},
                                                                         {"Text", "text"},
                                                                         {"Inline", "inline file"},
                                                                         {"Switch", "switch"},
                                                                         {"LOD", "level of detail"},
                                                                         {"Billboard", "billboard"}}};

// Nodes without a shape.
constexpr auto nodes_without_shape = std::to_array<std::string_view>({"Appearance",
                                                                      "AudioClip",
                                                                      "Background",
                                                                      "Color",
                                                                      "ColorInterpolator",
                                                                      "CoordinateInterpolator",
                                                                      "CylinderSensor",
                                                                      "DirectionalLight",
                                                                      "Fog",
                                                                      "FontStyle",
                                                                      "ImageTexture",
                                                                      "Material",
                                                                      "MovieTexture",
                                                                      "NavigationInfo",
                                                                      "Normal",
                                                                      "NormalInterpolator",
                                                                      "OrientationInterpolator",
                                                                      "PixelTexture",
                                                                      "PlaneSensor",
                                                                      "PointLight",
                                                                      "PositionInterpolator",
                                                                      "ProximitySensor",
                                                                      "ScalarInterpolator",
                                                                      "Script",
                                                                      "Sound",
                                                                      "SphereSensor",
                                                                      "SpotLight",
                                                                      "TextureCoordinate",
                                                                      "TextureTransform",
                                                                      "TimeSensor",
                                                                      "TouchSensor",
                                                                      "Viewpoint",
                                                                      "VisibilitySensor",
                                                                      "WorldInfo"});

template <class Words>
bool is_one_of(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

struct VrmlToken {
  enum class Kind { end, open, close, open_list, close_list, text, word };
  Kind kind = Kind::end;
  std::string_view word;  // a name or a number
  std::size_t line = 1;
};

class VrmlLexer {
 public:
  VrmlLexer(std::string_view text, std::string_view place) : text_(text), place_(place) {}

  const VrmlToken& peek() {
    if (!ahead_) ahead_ = read();
    return *ahead_;
  }

  VrmlToken next() {
    const VrmlToken token = peek();
    ahead_.reset();
    return token;
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ','; }
  static bool ends_word(char c) {
    return is_blank(c) || c == '{' || c == '}' || c == '[' || c == ']' || c == '"' || c == '#';
  }

  void skip_blanks() {
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '#') at_ = std::min(text_.find('\n', at_), text_.size());
      if (at_ == text_.size() || !is_blank(text_[at_])) return;
      if (text_[at_] == '\n') ++line_;
    }
  }

  VrmlToken read() {
    using Kind = VrmlToken::Kind;
    skip_blanks();
    if (at_ == text_.size()) return {Kind::end, {}, line_};
    switch (text_[at_]) {
      case '{': return {Kind::open, text_.substr(at_++, 1), line_};
      case '}': return {Kind::close, text_.substr(at_++, 1), line_};
      case '[': return {Kind::open_list, text_.substr(at_++, 1), line_};
      case ']': return {Kind::close_list, text_.substr(at_++, 1), line_};
      case '"': return read_text();
      default: break;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && !ends_word(text_[at_])) ++at_;
    return {Kind::word, text_.substr(begin, at_ - begin), line_};
  }

  VrmlToken read_text() {
    const std::size_t begin = at_, line = line_;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '"') return {VrmlToken::Kind::text, text_.substr(begin, ++at_ - begin), line};
      if (text_[at_] == '\\') ++at_;
      if (at_ < text_.size() && text_[at_] == '\n') ++line_;
    }
    fail_line(place_, line, "a text in quotes does not end; export the mesh again");
  }

  std::string_view text_, place_;
  std::size_t at_ = 0, line_ = 1;
  std::optional<VrmlToken> ahead_;
};

struct Node {
  enum class Kind { nothing, group, shape, faces, points, other };
  Kind kind = Kind::nothing;
  std::string_view type, name;  // name: of DEF
  std::size_t line = 1;
  std::uint32_t depth = 1;              // of the tree below it, itself included
  NodeFrame frame{};                    // of a group
  std::vector<std::uint32_t> children;  // of a group; of a shape its geometry; of faces their points; as nodes
  std::vector<Point3> points{};
  std::vector<std::uint32_t> polygon_begin{0}, corners{};  // of faces
  std::uint32_t largest = 0;                               // of `corners`
  std::size_t line_of_largest = 0;
};

class VrmlParser {
 public:
  VrmlParser(std::string_view bytes, std::string_view place)
      : lexer_(bytes, place), builder_(place), place_(place), budget_(bytes.size(), place) {}

  Mesh parse() {
    std::vector<std::uint32_t> tops;
    while (lexer_.peek().kind != VrmlToken::Kind::end) {
      const VrmlToken token = lexer_.next();
      if (token.word == "ROUTE") {  // ROUTE node.event TO node.event
        for (int i = 0; i < 3; ++i) lexer_.next();
        continue;
      }
      if (const auto node = statement(token, 0)) tops.push_back(*node);
    }
    for (const std::uint32_t top : tops) add(top, NodeFrame{}, "");
    return builder_.finish("VRML 2");
  }

 private:
  using Kind = VrmlToken::Kind;

  [[noreturn]] void fail(const VrmlToken& token, const std::string& text) const { fail_line(place_, token.line, text); }

  static std::string shown(const VrmlToken& token) {
    return token.kind == Kind::end ? "the end of the file" : quote(token.word);
  }

  void expect(Kind kind, std::string_view what) {
    const VrmlToken token = lexer_.next();
    if (token.kind != kind)
      fail(token, fmt::format("expected {}, found {}; export the mesh again", what, shown(token)));
  }

  // DEF NAME TYPE {...}, TYPE {...}, USE NAME, NULL; its first word is read. Nothing for NULL.
  std::optional<std::uint32_t> statement(const VrmlToken& first, std::uint32_t depth) {
    if (first.kind != Kind::word)
      fail(first, fmt::format("expected a node, found {}; export the mesh again", shown(first)));
    if (first.word == "NULL") return std::nullopt;
    if (first.word == "PROTO" || first.word == "EXTERNPROTO") {
      fail(first, fmt::format("{} is not read; export the mesh without prototypes", first.word));
    }
    if (first.word == "USE") {
      const VrmlToken name = lexer_.next();
      const auto found = known_.find(name.word);
      if (name.kind != Kind::word || found == known_.end()) {
        fail(name, fmt::format("USE names {}, which no DEF before it has; export the mesh again", shown(name)));
      }
      return found->second;
    }
    if (first.word != "DEF") return node(first, {}, depth);
    const VrmlToken name = lexer_.next();
    if (name.kind != Kind::word) fail(name, fmt::format("DEF has no name but {}; export the mesh again", shown(name)));
    const std::uint32_t number = node(lexer_.next(), name.word, depth);
    known_[name.word] = number;
    return number;
  }

  std::uint32_t node(const VrmlToken& type, std::string_view name, std::uint32_t depth) {
    if (type.kind != Kind::word)
      fail(type, fmt::format("expected a node, found {}; export the mesh again", shown(type)));
    if (depth > most_nested_groups) {
      fail(type, fmt::format("nodes are nested more than {} deep; export the mesh again", most_nested_groups));
    }
    expect(Kind::open, fmt::format("'{{' after {}", shown(type)));
    Node made;
    made.type = type.word;
    made.name = name;
    made.line = type.line;
    const auto other = std::find_if(told.begin(), told.end(), [&](const auto& t) { return t.first == type.word; });
    if (is_one_of(groups, type.word)) {
      made.kind = Node::Kind::group;
      read_group(made, depth);
    } else if (type.word == "Shape") {
      made.kind = Node::Kind::shape;
      fields([&](const VrmlToken& field) { return field.word == "geometry" && read_child(made, depth); });
    } else if (type.word == "IndexedFaceSet") {
      made.kind = Node::Kind::faces;
      fields([&](const VrmlToken& field) {
        if (field.word == "coord") return read_child(made, depth);
        if (field.word == "coordIndex") return read_corners(made);
        return false;
      });
    } else if (type.word == "Coordinate") {
      made.kind = Node::Kind::points;
      fields([&](const VrmlToken& field) { return field.word == "point" && read_points(made); });
    } else if (other != told.end()) {
      made.kind = Node::Kind::other;
      skip_to_end_of_node();
    } else if (is_one_of(nodes_without_shape, type.word)) {
      skip_to_end_of_node();
    } else {
      fail(type, fmt::format("{} is no node of VRML 2; export the mesh again", quote(type.word)));
    }
    for (const std::uint32_t child : made.children) made.depth = std::max(made.depth, nodes_[child].depth + 1);
    if (made.depth > most_nested_groups) {
      fail(type, fmt::format("nodes are nested more than {} deep; export the mesh again", most_nested_groups));
    }
    nodes_.push_back(std::move(made));
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }

  // Fields up to the closing brace. read(field): reads its value, or returns false, and it is skipped.
  template <class Read>
  void fields(Read read) {
    for (;;) {
      const VrmlToken field = lexer_.next();
      if (field.kind == Kind::close) return;
      if (field.kind != Kind::word) {
        fail(field, fmt::format("expected a field or '}}', found {}; export the mesh again", shown(field)));
      }
      if (!read(field)) skip_value();
    }
  }

  // One value of any kind: numbers, a text, a list, a node, TRUE, FALSE, NULL.
  void skip_value() {
    const VrmlToken& first = lexer_.peek();
    if (first.kind == Kind::text) {
      lexer_.next();
    } else if (first.kind == Kind::open_list) {
      lexer_.next();
      skip_balanced();
    } else if (first.kind == Kind::word) {
      if (!is_name(first.word)) {
        while (lexer_.peek().kind == Kind::word && !is_name(lexer_.peek().word)) lexer_.next();
        return;
      }
      const VrmlToken word = lexer_.next();
      if (word.word == "USE") lexer_.next();
      if (word.word == "DEF") {
        lexer_.next();
        lexer_.next();
      }
      if (lexer_.peek().kind == Kind::open) {
        lexer_.next();
        skip_balanced();
      }
    }
  }

  static bool is_name(std::string_view word) {
    const char c = word.front();
    return !(c == '-' || c == '+' || c == '.' || ('0' <= c && c <= '9'));
  }

  // To the end of the list or node that is open; those within are balanced, too.
  void skip_balanced() {
    for (std::size_t open = 1; open > 0;) {
      const VrmlToken token = lexer_.next();
      if (token.kind == Kind::end) fail(token, "the file ends within a node; it is truncated: export or copy it again");
      if (token.kind == Kind::open || token.kind == Kind::open_list) ++open;
      if (token.kind == Kind::close || token.kind == Kind::close_list) --open;
    }
  }

  void skip_to_end_of_node() { skip_balanced(); }

  bool read_child(Node& parent, std::uint32_t depth) {
    if (const auto child = statement(lexer_.next(), depth + 1)) parent.children.push_back(*child);
    return true;
  }

  bool read_children(Node& parent, std::uint32_t depth) {
    if (lexer_.peek().kind != Kind::open_list) return read_child(parent, depth);
    lexer_.next();
    while (lexer_.peek().kind != Kind::close_list) read_child(parent, depth);
    lexer_.next();
    return true;
  }

  double number() {
    const VrmlToken token = lexer_.next();
    double value = 0;
    if (token.kind != Kind::word) {
      fail(token, fmt::format("expected a number, found {}; export the mesh again", shown(token)));
    }
    if (const char* problem = parse_number(token.word, value)) {
      fail(token, fmt::format("{} {}", quote(token.word), problem));
    }
    return value;
  }

  std::array<double, 3> triple() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

  // Transform: p goes to translation + center + turn * (scale along its own axes) * (p - center).
  void read_group(Node& group, std::uint32_t depth) {
    std::array<double, 3> translation{}, center{}, scale{1, 1, 1};
    NodeFrame turn, scale_turn, scale_turn_back;
    const bool moves = group.type == "Transform";
    fields([&](const VrmlToken& field) {
      if (field.word == "children") return read_children(group, depth);
      if (!moves) return false;
      if (field.word == "translation") {
        translation = triple();
      } else if (field.word == "center") {
        center = triple();
      } else if (field.word == "scale") {
        scale = triple();
        if (scale[0] == 0 || scale[1] == 0 || scale[2] == 0) {
          fail(field, "a scale of 0 makes the mesh flat; give 3 numbers that are not 0");
        }
      } else if (field.word == "rotation") {
        turn = read_turn(field).first;
      } else if (field.word == "scaleOrientation") {
        std::tie(scale_turn, scale_turn_back) = read_turn(field);
      } else {
        return false;
      }
      return true;
    });
    if (!moves) return;
    const NodeFrame outer = compose(compose(moved_by(translation), moved_by(center)), turn);
    const NodeFrame middle = compose(compose(scale_turn, scaled_by(scale)), scale_turn_back);
    group.frame = compose(compose(outer, middle), moved_by({-center[0], -center[1], -center[2]}));
  }

  // A turn, and back.
  std::pair<NodeFrame, NodeFrame> read_turn(const VrmlToken& field) {
    const std::array<double, 3> axis = triple();
    const double angle = number();
    if (angle == 0) return {};
    if (axis[0] == 0 && axis[1] == 0 && axis[2] == 0) {
      fail(field, fmt::format("the axis of {} is 0 0 0; give a direction", field.word));
    }
    return {turned_by_radians(axis, angle), turned_by_radians(axis, -angle)};
  }

  bool read_points(Node& node) {
    const bool list = lexer_.peek().kind == Kind::open_list;
    if (list) lexer_.next();
    while (list ? lexer_.peek().kind != Kind::close_list : node.points.empty()) {
      const auto [x, y, z] = triple();
      node.points.push_back({x, y, z});
    }
    if (list) lexer_.next();
    return true;
  }

  bool read_corners(Node& node) {
    const bool list = lexer_.peek().kind == Kind::open_list;
    if (list) lexer_.next();
    VrmlToken token;
    const auto end_polygon = [&] {
      const std::size_t count = node.corners.size() - node.polygon_begin.back();
      if (count == 0) return;
      if (count < fewest_corners) {
        fail(token, fmt::format("this face has {} corners, expected at least 3; export the mesh again", count));
      }
      node.polygon_begin.push_back(static_cast<std::uint32_t>(node.corners.size()));
    };
    while (!list || lexer_.peek().kind != Kind::close_list) {
      token = lexer_.next();
      std::int64_t index = 0;
      if (token.kind != Kind::word || !parse_integer(token.word, index) || index < -1 ||
          index > MeshBuilder::largest_vertex) {
        fail(token,
             fmt::format("expected the number of a vertex or -1, found {}; export the mesh again", shown(token)));
      }
      if (index == -1) {
        end_polygon();
      } else {
        const auto corner = static_cast<std::uint32_t>(index);
        if (corner > node.largest || node.line_of_largest == 0) node.line_of_largest = token.line;
        node.largest = std::max(node.largest, corner);
        node.corners.push_back(corner);
      }
      if (!list) break;
    }
    end_polygon();
    if (list) lexer_.next();
    return true;
  }

  // The part has the name nearest above its faces.
  void add(std::uint32_t number, const NodeFrame& frame, std::string_view name) {
    const Node& node = nodes_[number];
    budget_.spend(1);
    if (!node.name.empty()) name = node.name;
    switch (node.kind) {
      case Node::Kind::nothing:
      case Node::Kind::points: return;
      case Node::Kind::group: {
        const NodeFrame inner = compose(frame, node.frame);
        for (const std::uint32_t child : node.children) add(child, inner, name);
        return;
      }
      case Node::Kind::shape:
        for (const std::uint32_t child : node.children) add(child, frame, name);
        return;
      case Node::Kind::faces: return add_faces(node, frame, name);
      case Node::Kind::other:
        builder_.leave_out(
            std::find_if(told.begin(), told.end(), [&](const auto& t) { return t.first == node.type; })->second, 1);
        return;
    }
  }

  void add_faces(const Node& faces, const NodeFrame& frame, std::string_view name) {
    const Node* const coordinates = faces.children.empty() ? nullptr : &nodes_[faces.children.back()];
    const std::size_t count = coordinates == nullptr ? 0 : coordinates->points.size();
    if (!faces.corners.empty() && faces.largest >= count) {
      fail_line(place_, faces.line_of_largest,
                fmt::format("this face names vertex {}, but there are {} (counted from 0); export the mesh again",
                            faces.largest, count));
    }
    if (coordinates == nullptr) return;
    builder_.begin_part(name);
    budget_.spend(count + faces.corners.size());
    // Points are a store that several sets of faces may share; those that none names are no part of the mesh.
    std::vector<bool> in_use(count);
    for (const std::uint32_t corner : faces.corners) in_use[corner] = true;
    std::vector<std::uint32_t> vertex(count);
    for (std::size_t i = 0; i < count; ++i) {
      if (!in_use[i]) continue;
      const Point3 placed = frame(coordinates->points[i]);
      if (!std::isfinite(placed.x) || !std::isfinite(placed.y) || !std::isfinite(placed.z)) {
        fail_line(place_, coordinates->line, "its nodes move a vertex beyond the doubles; export the mesh again");
      }
      vertex[i] = builder_.vertex_count();
      builder_.add_vertex(placed);
    }
    for (std::size_t p = 0; p + 1 < faces.polygon_begin.size(); ++p) {
      for (std::uint32_t c = faces.polygon_begin[p]; c < faces.polygon_begin[p + 1]; ++c) {
        builder_.add_corner(vertex[faces.corners[c]]);
      }
      builder_.end_polygon();
    }
  }

  VrmlLexer lexer_;
  MeshBuilder builder_;
  std::string_view place_;
  InstanceBudget budget_;
  std::vector<Node> nodes_;
  std::unordered_map<std::string_view, std::uint32_t> known_;
};

}  // namespace

Mesh parse_vrml(std::string_view bytes, std::string_view place) { return VrmlParser(bytes, place).parse(); }

}  // namespace sunder::io
