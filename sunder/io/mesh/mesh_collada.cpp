#include <sunder/io/mesh/frame_internal.h>
#include <sunder/io/mesh/mesh_builder.h>
#include <sunder/io/mesh/mesh_formats.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/xml_internal.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace sunder::io {
namespace {

constexpr XmlKind collada{"COLLADA", "COLLADA", "COLLADA", "mesh"};
constexpr std::uint32_t most_nested_nodes = 64;  // nodes within nodes, instances included
constexpr std::size_t largest_offset = 1 << 16;  // of an input of a primitive

// What <geometry> holds, in its own coordinates.
struct Geometry {
  std::string name;
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> polygon_begin{0}, corners;
  std::vector<LeftOut> left_out;

  void leave_out(const char* kind, std::size_t count) {
    if (count > 0) left_out.push_back({kind, "", count});
  }
};

using Elements = std::unordered_map<std::string_view, const XMLElement*>;  // by id; null where the id stands twice

class ColladaParser {
 public:
  ColladaParser(std::string_view bytes, std::string_view place)
      : xml_(bytes, place, collada), builder_(place), place_(place), budget_(bytes.size(), place) {}

  Mesh parse() {
    const XMLElement& root = xml_.root();
    read_asset(root);
    XmlFile::each_child(root, [&](const XMLElement& child) { read_library(child); });
    if (const XMLElement* scene = scene_of(root)) {
      XmlFile::each_child(*scene, [&](const XMLElement& child) {
        if (XmlFile::is(child, "node")) add_node(child, scaled_by({unit_, unit_, unit_}), 0);
      });
    } else {
      for (const XMLElement* geometry : in_order_) add_geometry(*geometry, "", scaled_by({unit_, unit_, unit_}));
    }
    return builder_.finish(
        fmt::format("COLLADA ({}, {})", unit_ == 1 ? "metres" : fmt::format("1 unit is {} m", unit_), up_axis_));
  }

 private:
  void read_asset(const XMLElement& root) {
    const XMLElement* asset = root.FirstChildElement("asset");
    if (asset == nullptr) return;
    if (const XMLElement* unit = asset->FirstChildElement("unit")) {
      unit_ = xml_.number_or(*unit, "meter", 1);
      if (!(unit_ > 0)) xml_.fail(*unit, "the unit is not above 0 metres; correct its meter=\"...\"");
    }
    if (const XMLElement* up = asset->FirstChildElement("up_axis")) {
      up_axis_.clear();
      xml_.each_word(*up, [&](std::string_view word, std::size_t) { up_axis_ += word; });
      if (up_axis_ != "X_UP" && up_axis_ != "Y_UP" && up_axis_ != "Z_UP") {
        xml_.fail(*up, fmt::format("the up axis is {}; known are X_UP, Y_UP, Z_UP", quote(up_axis_)));
      }
    }
  }

  void read_library(const XMLElement& library) {
    if (XmlFile::is(library, "library_geometries")) {
      XmlFile::each_child(library, [&](const XMLElement& child) {
        if (!XmlFile::is(child, "geometry")) return;
        remember(child, geometries_);
        in_order_.push_back(&child);
      });
    } else if (XmlFile::is(library, "library_nodes")) {
      remember_nodes(library);
    } else if (XmlFile::is(library, "library_visual_scenes")) {
      XmlFile::each_child(library, [&](const XMLElement& child) {
        if (!XmlFile::is(child, "visual_scene")) return;
        remember(child, scenes_);
        scenes_in_order_.push_back(&child);
        remember_nodes(child);
      });
    }
  }

  // All nodes within, at any depth (the reader of XML limits it).
  void remember_nodes(const XMLElement& element) {
    XmlFile::each_child(element, [&](const XMLElement& child) {
      if (!XmlFile::is(child, "node")) return;
      remember(child, nodes_);
      remember_nodes(child);
    });
  }

  static void remember(const XMLElement& element, Elements& elements) {
    const char* id = element.Attribute("id");
    if (id == nullptr) return;
    const auto [known, is_new] = elements.emplace(id, &element);
    if (!is_new) known->second = nullptr;
  }

  // What url="#id" of the element names.
  const XMLElement& target(const XMLElement& element, const char* attribute, const Elements& elements) const {
    const std::string_view url = xml_.attribute(element, attribute);
    if (!url.starts_with('#')) {
      xml_.fail(element, fmt::format("{} names {}, which is in another file; store all in one", XmlFile::tag(element),
                                     quote(url)));
    }
    const auto found = elements.find(url.substr(1));
    if (found == elements.end()) {
      xml_.fail(element, fmt::format("{} names {}, which is not in the file; export the mesh again",
                                     XmlFile::tag(element), quote(url)));
    }
    if (found->second == nullptr) {
      xml_.fail(element, fmt::format("{} names {}, an id that stands twice; export the mesh again",
                                     XmlFile::tag(element), quote(url)));
    }
    return *found->second;
  }

  // The scene that is shown; none where the file has none, and its geometries stand for themselves.
  const XMLElement* scene_of(const XMLElement& root) const {
    const XMLElement* scene = root.FirstChildElement("scene");
    const XMLElement* instance = scene ? scene->FirstChildElement("instance_visual_scene") : nullptr;
    if (instance != nullptr) return &target(*instance, "url", scenes_);
    if (scenes_in_order_.size() > 1) {
      xml_.fail(root, "has several scenes, and does not say which is meant; add <scene>");
    }
    return scenes_in_order_.empty() ? nullptr : scenes_in_order_.front();
  }

  void add_node(const XMLElement& node, NodeFrame frame, std::uint32_t depth) {
    if (depth > most_nested_nodes) {
      xml_.fail(node, fmt::format("nodes are nested more than {} deep, or in a circle; export the mesh again",
                                  most_nested_nodes));
    }
    budget_.spend(1);
    XmlFile::each_child(node, [&](const XMLElement& child) {
      if (XmlFile::is(child, "node")) {
        add_node(child, frame, depth + 1);
      } else if (XmlFile::is(child, "instance_node")) {
        add_node(target(child, "url", nodes_), frame, depth + 1);
      } else if (XmlFile::is(child, "instance_geometry")) {
        const char* name = node.Attribute("name");
        if (name == nullptr) name = node.Attribute("id");
        add_geometry(target(child, "url", geometries_), name == nullptr ? "" : name, frame);
      } else if (XmlFile::is(child, "instance_controller")) {
        builder_.leave_out("skinned mesh", 1);
      } else {
        transform(child, frame);
      }
    });
  }

  void transform(const XMLElement& element, NodeFrame& frame) const {
    if (XmlFile::is(element, "matrix")) {
      const auto m = numbers<16>(element);
      if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1) {
        xml_.fail(element, "the last row of <matrix> is not 0 0 0 1, so it is no affine map; export the mesh again");
      }
      NodeFrame inner;
      inner.turn = {m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]};
      inner.move = {m[3], m[7], m[11]};
      frame = compose(frame, inner);
    } else if (XmlFile::is(element, "translate")) {
      frame = compose(frame, moved_by(numbers<3>(element)));
    } else if (XmlFile::is(element, "scale")) {
      const auto factors = numbers<3>(element);
      if (factors[0] == 0 || factors[1] == 0 || factors[2] == 0) {
        xml_.fail(element, "a scale of 0 makes the mesh flat; give 3 numbers that are not 0");
      }
      frame = compose(frame, scaled_by(factors));
    } else if (XmlFile::is(element, "rotate")) {
      const auto [x, y, z, degrees] = numbers<4>(element);
      if (degrees == 0) return;
      if (x == 0 && y == 0 && z == 0) xml_.fail(element, "the axis of <rotate> is 0 0 0; give a direction");
      frame = compose(frame, turned_by_degrees({x, y, z}, degrees));
    } else if (XmlFile::is(element, "lookat") || XmlFile::is(element, "skew")) {
      xml_.fail(element, fmt::format("{} is not read; export the mesh with <matrix>", XmlFile::tag(element)));
    }
  }

  double number(std::string_view word, std::size_t line, std::string_view what) const {
    double value = 0;
    if (const char* problem = parse_number(word, value)) {
      fail_line(place_, line, fmt::format("{}: {} {}", what, quote(word), problem));
    }
    return value;
  }

  std::uint32_t whole(std::string_view word, std::size_t line, std::string_view what) const {
    std::int64_t value = 0;
    if (!parse_integer(word, value) || value < 0 || value > MeshBuilder::largest_vertex) {
      fail_line(place_, line,
                fmt::format("{}: {} is no number from 0 to 2^31; export the mesh again", what, quote(word)));
    }
    return static_cast<std::uint32_t>(value);
  }

  template <std::size_t n>
  std::array<double, n> numbers(const XMLElement& element) const {
    std::array<double, n> values{};
    std::size_t count = 0;
    xml_.each_word(element, [&](std::string_view word, std::size_t line) {
      const double value = number(word, line, XmlFile::tag(element));
      if (count < n) values[count] = value;
      ++count;
    });
    if (count != n) xml_.fail(element, fmt::format("{} has {} numbers, expected {}", XmlFile::tag(element), count, n));
    return values;
  }

  std::size_t count_of_attribute(const XMLElement& element, const char* name, std::size_t otherwise) const {
    const char* text = element.Attribute(name);
    if (text == nullptr) return otherwise;
    return whole(trimmed(text), static_cast<std::size_t>(std::max(element.GetLineNum(), 1)),
                 fmt::format("{} of {}", name, XmlFile::tag(element)));
  }

  void add_geometry(const XMLElement& element, std::string_view name, const NodeFrame& frame) {
    auto known = read_.find(&element);
    if (known == read_.end()) known = read_.emplace(&element, read_geometry(element)).first;
    const Geometry& geometry = known->second;
    budget_.spend(geometry.vertices.size() + geometry.corners.size() + geometry.left_out.size());
    builder_.begin_part(name.empty() ? std::string_view(geometry.name) : name);
    const std::uint32_t first = builder_.vertex_count();
    for (const Point3& vertex : geometry.vertices) {
      const Point3 placed = frame(vertex);
      if (!std::isfinite(placed.x) || !std::isfinite(placed.y) || !std::isfinite(placed.z)) {
        xml_.fail(element, "its nodes move a vertex beyond the doubles; export the mesh again");
      }
      builder_.add_vertex(placed);
    }
    for (std::size_t p = 0; p + 1 < geometry.polygon_begin.size(); ++p) {
      for (std::uint32_t c = geometry.polygon_begin[p]; c < geometry.polygon_begin[p + 1]; ++c) {
        builder_.add_corner(first + geometry.corners[c]);
      }
      builder_.end_polygon();
    }
    for (const LeftOut& item : geometry.left_out) builder_.leave_out(item.kind, item.count);
  }

  Geometry read_geometry(const XMLElement& element) const {
    Geometry geometry;
    const char* name = element.Attribute("name");
    if (name == nullptr) name = element.Attribute("id");
    if (name != nullptr) geometry.name = name;
    const XMLElement* mesh = element.FirstChildElement("mesh");
    if (mesh == nullptr) {
      const XMLElement* other = element.FirstChildElement();
      while (other != nullptr && (XmlFile::is(*other, "asset") || XmlFile::is(*other, "extra"))) {
        other = other->NextSiblingElement();
      }
      geometry.left_out.push_back({other == nullptr ? "geometry" : shorten(other->Name()), "", 1});
      return geometry;
    }
    const XMLElement* vertices = mesh->FirstChildElement("vertices");
    if (vertices == nullptr) xml_.fail(*mesh, "<mesh> has no <vertices>; export the mesh again");
    read_vertices(*mesh, *vertices, geometry);
    const char* id = vertices->Attribute("id");
    XmlFile::each_child(*mesh, [&](const XMLElement& child) {
      if (is_primitive(child)) read_primitive(child, id == nullptr ? "" : id, geometry);
    });
    keep_used_vertices(geometry);
    return geometry;
  }

  // A source is a store of numbers; what no polygon names is no part of the mesh.
  static void keep_used_vertices(Geometry& geometry) {
    std::vector<bool> in_use(geometry.vertices.size());
    for (const std::uint32_t corner : geometry.corners) in_use[corner] = true;
    std::vector<std::uint32_t> number(geometry.vertices.size());
    std::uint32_t count = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (!in_use[v]) continue;
      geometry.vertices[count] = geometry.vertices[v];
      number[v] = count++;
    }
    geometry.vertices.resize(count);
    for (std::uint32_t& corner : geometry.corners) corner = number[corner];
  }

  static bool is_primitive(const XMLElement& element) {
    constexpr std::array<std::string_view, 7> known{"triangles", "polylist", "polygons",  "trifans",
                                                    "tristrips", "lines",    "linestrips"};
    return std::find(known.begin(), known.end(), element.Name()) != known.end();
  }

  // The source that is the vertices' POSITION.
  void read_vertices(const XMLElement& mesh, const XMLElement& vertices, Geometry& geometry) const {
    Elements sources;
    XmlFile::each_child(mesh, [&](const XMLElement& child) {
      if (XmlFile::is(child, "source")) remember(child, sources);
    });
    const XMLElement* position = nullptr;
    XmlFile::each_child(vertices, [&](const XMLElement& input) {
      const char* semantic = XmlFile::is(input, "input") ? input.Attribute("semantic") : nullptr;
      if (semantic != nullptr && std::string_view(semantic) == "POSITION") position = &input;
    });
    if (position == nullptr) xml_.fail(vertices, "<vertices> has no input POSITION; export the mesh again");
    const XMLElement& source = target(*position, "source", sources);

    const XMLElement* array = source.FirstChildElement("float_array");
    const XMLElement* technique = source.FirstChildElement("technique_common");
    const XMLElement* accessor = technique ? technique->FirstChildElement("accessor") : nullptr;
    if (array == nullptr || accessor == nullptr) {
      xml_.fail(source, "<source> of the positions has no <float_array> with an <accessor>; export the mesh again");
    }
    std::vector<double> values;
    xml_.each_word(
        *array, [&](std::string_view word, std::size_t line) { values.push_back(number(word, line, "a coordinate")); });
    if (values.size() != count_of_attribute(*array, "count", values.size())) {
      xml_.fail(*array, fmt::format("<float_array> promises {} numbers, but has {}; export the mesh again",
                                    array->Attribute("count"), values.size()));
    }
    const std::size_t count = count_of_attribute(*accessor, "count", 0);
    const std::size_t stride = count_of_attribute(*accessor, "stride", 1);
    const std::size_t offset = count_of_attribute(*accessor, "offset", 0);
    const std::array<std::size_t, 3> axes = axes_of(*accessor);
    const std::size_t last = *std::max_element(axes.begin(), axes.end());
    if (last >= stride || (count > 0 && (offset > values.size() || stride > values.size() - offset ||
                                         count - 1 > (values.size() - offset - stride) / stride))) {
      xml_.fail(*accessor, fmt::format("{} points of {} numbers are promised, but there are {} numbers; export the "
                                       "mesh again",
                                       count, stride, values.size()));
    }
    geometry.vertices.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double* point = values.data() + offset + i * stride;
      geometry.vertices.push_back({point[axes[0]], point[axes[1]], point[axes[2]]});
    }
  }

  // Which numbers of a point are X, Y, Z: by their names, else the first three.
  std::array<std::size_t, 3> axes_of(const XMLElement& accessor) const {
    std::map<std::string_view, std::size_t> place;
    std::size_t count = 0;
    XmlFile::each_child(accessor, [&](const XMLElement& param) {
      const char* name = param.Attribute("name");
      if (name != nullptr) place.emplace(name, count);
      ++count;
    });
    const auto x = place.find("X"), y = place.find("Y"), z = place.find("Z");
    if (x != place.end() && y != place.end() && z != place.end()) return {x->second, y->second, z->second};
    return {0, 1, 2};
  }

  // The numbers of the vertices of <p>, or of any element like it.
  std::vector<std::uint32_t> indices(const XMLElement& p, std::size_t stride, std::size_t at,
                                     const Geometry& geometry) const {
    std::vector<std::uint32_t> corners;
    std::size_t count = 0;
    xml_.each_word(p, [&](std::string_view word, std::size_t line) {
      const std::uint32_t index = whole(word, line, "an index");
      if (count++ % stride != at) return;
      if (index >= geometry.vertices.size()) {
        fail_line(place_, line,
                  fmt::format("this face names vertex {}, but there are {} (counted from 0); export the "
                              "mesh again",
                              index, geometry.vertices.size()));
      }
      corners.push_back(index);
    });
    if (count % stride != 0) {
      xml_.fail(p, fmt::format("{} has {} indices, which is no multiple of {}; export the mesh again", XmlFile::tag(p),
                               count, stride));
    }
    return corners;
  }

  void add_polygon(const XMLElement& element, const std::uint32_t* corners, std::size_t count,
                   Geometry& geometry) const {
    if (count < fewest_corners) {
      xml_.fail(element, fmt::format("a face has {} corners, expected at least 3; export the mesh again", count));
    }
    geometry.corners.insert(geometry.corners.end(), corners, corners + count);
    geometry.polygon_begin.push_back(static_cast<std::uint32_t>(geometry.corners.size()));
  }

  void read_primitive(const XMLElement& element, std::string_view vertices, Geometry& geometry) const {
    std::size_t stride = 1, at = 0;
    bool found = false;
    XmlFile::each_child(element, [&](const XMLElement& input) {
      if (!XmlFile::is(input, "input")) return;
      const std::size_t offset = count_of_attribute(input, "offset", 0);
      if (offset > largest_offset) xml_.fail(input, "the offset of this input is too large; export the mesh again");
      stride = std::max(stride, offset + 1);
      if (std::string_view(xml_.attribute(input, "semantic")) != "VERTEX") return;
      const std::string_view source = xml_.attribute(input, "source");
      if (source.substr(source.starts_with('#') ? 1 : 0) != vertices) {
        xml_.fail(input,
                  fmt::format("the vertices {} are not those of this mesh; export the mesh again", quote(source)));
      }
      at = offset;
      found = true;
    });
    const std::size_t promised = count_of_attribute(element, "count", 0);
    if (!found) {
      if (promised == 0) return;
      xml_.fail(element, fmt::format("{} has no input VERTEX; export the mesh again", XmlFile::tag(element)));
    }
    const std::string_view kind = element.Name();
    if (kind == "polylist") return read_polylist(element, stride, at, promised, geometry);
    XmlFile::each_child(element, [&](const XMLElement& p) {
      if (XmlFile::is(p, "ph")) geometry.leave_out("polygon with holes", 1);
      if (!XmlFile::is(p, "p")) return;
      const std::vector<std::uint32_t> corners = indices(p, stride, at, geometry);
      const std::size_t count = corners.size();
      if (kind == "lines") return geometry.leave_out("line", count / 2);
      if (kind == "linestrips") return geometry.leave_out("line", count > 0 ? count - 1 : 0);
      if (kind == "polygons") return add_polygon(p, corners.data(), count, geometry);
      if (kind == "triangles" && count % 3 != 0) {
        xml_.fail(p, fmt::format("triangles have {} corners, which is no multiple of 3; export the mesh again", count));
      }
      for (std::size_t i = 2; i < count; i += kind == "triangles" ? 3u : 1u) {
        std::array<std::uint32_t, 3> triangle{corners[i - 2], corners[i - 1], corners[i]};
        if (kind == "trifans") triangle[0] = corners[0];
        if (kind == "tristrips" && i % 2 == 1) std::swap(triangle[0], triangle[1]);
        add_polygon(p, triangle.data(), 3, geometry);
      }
      if (kind == "triangles" && count / 3 != promised) {
        xml_.fail(element, fmt::format("<triangles> promises {} triangles, but has {}; export the mesh again", promised,
                                       count / 3));
      }
    });
  }

  void read_polylist(const XMLElement& element, std::size_t stride, std::size_t at, std::size_t promised,
                     Geometry& geometry) const {
    const XMLElement *vcount = element.FirstChildElement("vcount"), *p = element.FirstChildElement("p");
    if (vcount == nullptr || p == nullptr) {
      if (promised == 0) return;
      xml_.fail(element, "<polylist> has no <vcount> or no <p>; export the mesh again");
    }
    const std::vector<std::uint32_t> corners = indices(*p, stride, at, geometry);
    std::size_t begin = 0, polygons = 0;
    xml_.each_word(*vcount, [&](std::string_view word, std::size_t line) {
      const std::size_t count = whole(word, line, "the number of corners");
      if (count > corners.size() - begin) {
        fail_line(place_, line, "<vcount> asks for more corners than <p> has; export the mesh again");
      }
      add_polygon(*vcount, corners.data() + begin, count, geometry);
      begin += count;
      ++polygons;
    });
    if (begin != corners.size() || polygons != promised) {
      xml_.fail(element, fmt::format("<polylist> promises {} faces; <vcount> has {} of {} corners, <p> has {}; export "
                                     "the mesh again",
                                     promised, polygons, begin, corners.size()));
    }
  }

  XmlFile xml_;
  MeshBuilder builder_;
  std::string_view place_;
  InstanceBudget budget_;
  double unit_ = 1;
  std::string up_axis_ = "Y_UP";
  Elements geometries_, nodes_, scenes_;
  std::vector<const XMLElement*> in_order_, scenes_in_order_;
  std::map<const XMLElement*, Geometry> read_;
};

}  // namespace

Mesh parse_collada(std::string_view bytes, std::string_view place) { return ColladaParser(bytes, place).parse(); }

}  // namespace sunder::io
