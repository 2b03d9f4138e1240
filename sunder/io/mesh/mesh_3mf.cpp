#include <sunder/io/mesh/frame_internal.h>
#include <sunder/io/mesh/mesh_builder.h>
#include <sunder/io/mesh/mesh_formats.h>
#include <sunder/io/text/foreign.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/xml_internal.h>
#include <sunder/io/text/zip_internal.h>
#include <sunder/number/dyadic.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <unordered_map>
#include <utility>

namespace sunder::io {
namespace {

constexpr XmlKind model_kind{"model", "3MF", "a 3MF model", "mesh"};
constexpr XmlKind relationships_kind{"Relationships", "list of relationships", "a list of relationships", "mesh"};
constexpr std::string_view start_part = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

// Namespaces.
constexpr std::string_view core_names = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view production_names = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
constexpr std::string_view set_names = "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07";
constexpr std::string_view material_names = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";

constexpr std::uint32_t most_nested_components = 64;

// Millimetres of a unit, as a fraction of whole numbers: an inch is 25.4 mm.
struct LengthUnit {
  std::string_view name, told;
  double mm, per;
};
constexpr std::array<LengthUnit, 6> length_units{{{"micron", "1 unit is 0.001 mm", 1, 1000},
                                                  {"millimeter", "millimetres", 1, 1},
                                                  {"centimeter", "1 unit is 10 mm", 10, 1},
                                                  {"inch", "1 unit is 25.4 mm", 127, 5},
                                                  {"foot", "1 unit is 304.8 mm", 1524, 5},
                                                  {"meter", "1 unit is 1000 mm", 1000, 1}}};

// What extensions say of shapes, for people.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> shapes_of_extensions{
    {{"beamlattice", "beam lattice"},
     {"slicestack", "slice stack"},
     {"displacementmesh", "displacement mesh"},
     {"booleanshape", "boolean shape"},
     {"levelset", "level set"},
     {"alternatives", "list of alternatives"}}};

// An affine map of row vectors, in exact numbers: p goes to p * turn + move.
struct ExactFrame {
  std::array<std::array<Dyadic, 3>, 3> turn{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::array<Dyadic, 3> move{0, 0, 0};
  bool is_identity = true;

  Dyadic image(const std::array<Dyadic, 3>& p, std::size_t column) const {
    Dyadic sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (turn[k][column].sign() != Sign::zero) sum = sum + p[k] * turn[k][column];
    }
    return sum;
  }
  Sign determinant() const {
    Dyadic sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
      sum = sum + turn[0][k] * (turn[1][next] * turn[2][last] - turn[1][last] * turn[2][next]);
    }
    return sum.sign();
  }
};

ExactFrame compose(const ExactFrame& outer, const ExactFrame& inner) {
  if (outer.is_identity) return inner;
  if (inner.is_identity) return outer;
  ExactFrame both;
  both.is_identity = false;
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) both.turn[row][column] = outer.image(inner.turn[row], column);
    both.move[column] = outer.image(inner.move, column) + outer.move[column];
  }
  return both;
}

// A model of the package: the root, or one that it names.
struct PackageModel {
  PackageModel(std::string_view bytes, std::string name) : place(std::move(name)), xml(bytes, place, model_kind) {}

  std::string place;  // "FILE: 3D/3dmodel.model", for messages
  XmlFile xml;
  bool is_root = false;
  std::unordered_map<std::string_view, std::string_view> names;  // of prefixes; "": that of the core
  std::unordered_map<std::uint32_t, const XMLElement*> objects;  // by id
};

// A <mesh>, with the vertices in use, and what it holds beside triangles.
struct TriangleMesh {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners;
  std::vector<std::string> left_out;  // kinds
};

class ThreeMfParser {
 public:
  ThreeMfParser(std::string_view bytes, std::string_view place)
      : archive_(bytes, place), builder_(place), place_(place), budget_(bytes.size(), place) {}

  Mesh parse() {
    PackageModel& root = model_of(name_of_root());
    root.is_root = true;
    const char* unit = root.xml.root().Attribute("unit");
    unit_ = unit_of(root, unit == nullptr ? "millimeter" : unit);
    const XMLElement* build = root.xml.root().FirstChildElement("build");
    if (build == nullptr) root.xml.fail(root.xml.root(), "<model> has no <build>; export the mesh again");
    std::size_t items = 0;
    XmlFile::each_child(*build, [&](const XMLElement& item) {
      if (!XmlFile::is(item, "item")) return leave_out(root, item);
      ++items;
      add_instance(root, item, "", ExactFrame{}, 0);
    });
    if (items == 0) root.xml.fail(*build, "<build> has no <item>, so the file has no object; export the mesh again");
    if (has_materials_) builder_.remark("materials, colours and textures are not read; no shape depends on them");
    if (rounded_ > 0) {
      builder_.remark(
          fmt::format("{} of {} coordinates {}, by its transforms or its unit", rounded_,
                      3 * std::uint64_t{builder_.vertex_count()},
                      rounded_ == 1 ? "is rounded, to the nearest double" : "are rounded, to the nearest doubles"));
    }
    return builder_.finish(fmt::format("3MF ({})", unit_->told));
  }

 private:
  // --- The package -----------------------------------------------------------------------------------------------

  std::string name_of_root() {
    const std::string place = fmt::format("{}: _rels/.rels", place_);
    const auto text = archive_.read("_rels/.rels");
    if (!text) fail_file(place_, "is a ZIP archive without _rels/.rels, so it is no 3MF; export the mesh again");
    const XmlFile list(*text, place, relationships_kind);
    const XMLElement* found = nullptr;
    XmlFile::each_child(list.root(), [&](const XMLElement& child) {
      const char* type = child.Attribute("Type");
      if (type == nullptr || type != start_part) return;
      if (found != nullptr) list.fail(child, "names a second 3D model; export the mesh again");
      found = &child;
    });
    if (found == nullptr) fail_file(place, "names no 3D model, so the file is no 3MF; export the mesh again");
    return list.attribute(*found, "Target");
  }

  // The model of this name, read once. A name begins with "/" where it is absolute; all are, as far as is known.
  PackageModel& model_of(std::string_view name) {
    if (name.starts_with('/')) name.remove_prefix(1);
    const auto known = models_.find(std::string(name));
    if (known != models_.end()) return *known->second;
    const auto text = archive_.read(name);
    if (!text)
      fail_file(place_, fmt::format("names the model {}, which is not in it; export the mesh again", quote(name)));
    budget_.add_bytes(text->size());
    auto model = std::make_unique<PackageModel>(*text, fmt::format("{}: {}", place_, shorten(name)));
    read_names(*model);
    read_resources(*model);
    return *models_.emplace(std::string(name), std::move(model)).first->second;
  }

  static void read_names(PackageModel& model) {
    const XMLElement& root = model.xml.root();
    for (const tinyxml2::XMLAttribute* a = root.FirstAttribute(); a != nullptr; a = a->Next()) {
      const std::string_view name = a->Name();
      if (name == "xmlns") model.names.emplace("", a->Value());
      if (name.starts_with("xmlns:")) model.names.emplace(name.substr(6), a->Value());
    }
    if (names_of(model, "") != core_names) {
      model.xml.fail(root, fmt::format("<model> is not of 3MF's core of 2015/02, but of {}; export the mesh again",
                                       quote(names_of(model, ""))));
    }
    const char* required = root.Attribute("requiredextensions");
    for (const std::string_view prefix : xml_words(required == nullptr ? "" : required)) {
      const std::string_view names = names_of(model, prefix);
      if (names == production_names || names == set_names || names == material_names) continue;
      constexpr std::string_view folder = "3dmanufacturing/";  // the name alone: "beamlattice/2017/02"
      const std::size_t at = names.find(folder);
      model.xml.fail(
          root, fmt::format("needs the extension {} ({}), which is not read; export the mesh without it", quote(prefix),
                            shorten(names.substr(at == std::string_view::npos ? 0 : at + folder.size()))));
    }
  }

  static std::string_view names_of(const PackageModel& model, std::string_view prefix) {
    const auto found = model.names.find(prefix);
    return found == model.names.end() ? std::string_view() : found->second;
  }

  // The namespace of an element: of its prefix, or what it says itself.
  static std::string_view names_of(const PackageModel& model, const XMLElement& element) {
    const std::string_view name = element.Name();
    const std::size_t colon = name.find(':');
    if (colon != std::string_view::npos) return names_of(model, name.substr(0, colon));
    const char* own = element.Attribute("xmlns");
    return own == nullptr ? core_names : own;
  }

  // Is it this element of the core?
  static bool is_core(const PackageModel& model, const XMLElement& element, std::string_view name) {
    return XmlFile::is(element, name) && names_of(model, element) == core_names;
  }

  void read_resources(PackageModel& model) {
    const XMLElement* resources = model.xml.root().FirstChildElement("resources");
    if (resources == nullptr) model.xml.fail(model.xml.root(), "<model> has no <resources>; export the mesh again");
    XmlFile::each_child(model.xml.root(), [&](const XMLElement& child) {
      if (names_of(model, child) != core_names) leave_out(model, child);
    });
    XmlFile::each_child(*resources, [&](const XMLElement& child) {
      if (!is_core(model, child, "object")) return leave_out(model, child);
      const std::uint32_t id = whole(model, child, "id");
      if (!model.objects.emplace(id, &child).second) {
        model.xml.fail(child, fmt::format("the id {} stands twice; export the mesh again", id));
      }
    });
  }

  // What an element says that is not read: of materials and sets of triangles no shape depends.
  void leave_out(const PackageModel& model, const XMLElement& element) {
    const std::string kind = kind_of(model, element);
    if (!kind.empty()) builder_.leave_out(kind, 1);
  }

  std::string kind_of(const PackageModel& model, const XMLElement& element) {
    const std::string_view names = names_of(model, element);
    const std::string_view name = element.Name();
    if (names == set_names) return "";
    if (names == core_names && (name == "metadatagroup" || name == "metadata")) return "";
    if (names == material_names || (names == core_names && name == "basematerials")) {
      has_materials_ = true;
      return "";
    }
    const std::string_view local = name.substr(name.find(':') + 1);
    const auto known = std::find_if(shapes_of_extensions.begin(), shapes_of_extensions.end(),
                                    [&](const auto& shape) { return shape.first == local; });
    return known == shapes_of_extensions.end() ? shorten(name) : std::string(known->second);
  }

  // --- Objects and where they are --------------------------------------------------------------------------------

  static const LengthUnit* unit_of(const PackageModel& model, std::string_view name) {
    const auto found = std::find_if(length_units.begin(), length_units.end(),
                                    [&](const LengthUnit& unit) { return unit.name == name; });
    if (found == length_units.end()) {
      model.xml.fail(model.xml.root(), fmt::format("the unit is {}; known are micron, millimeter, centimeter, inch, "
                                                   "foot, meter",
                                                   quote(name)));
    }
    return &*found;
  }

  // The object that an <item> or a <component> names, moved by its transform and then by `outer`.
  void add_instance(PackageModel& model, const XMLElement& element, std::string_view name, const ExactFrame& outer,
                    std::uint32_t depth) {
    budget_.spend(1);
    XmlFile::each_child(element, [&](const XMLElement& child) { leave_out(model, child); });
    PackageModel& target = model_of_path(model, element);
    const std::uint32_t id = whole(model, element, "objectid");
    const auto object = target.objects.find(id);
    if (object == target.objects.end()) {
      model.xml.fail(element, fmt::format("{} names the object {}, which is not there; export the mesh again",
                                          XmlFile::tag(element), id));
    }
    add_object(target, *object->second, name, compose(outer, frame_of(model, element)), depth);
  }

  // The other model of the package that the production extension names, if it names one.
  PackageModel& model_of_path(PackageModel& model, const XMLElement& element) {
    for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
      const std::string_view name = a->Name();
      const std::size_t colon = name.find(':');
      if (colon == std::string_view::npos || name.substr(colon + 1) != "path") continue;
      if (names_of(model, name.substr(0, colon)) != production_names) {
        model.xml.fail(element, fmt::format("{} has {}, which is of no extension that is read; export the mesh again",
                                            XmlFile::tag(element), quote(name)));
      }
      if (!model.is_root) {
        model.xml.fail(element, fmt::format("{} names another model, which only the root may; export the mesh again",
                                            XmlFile::tag(element)));
      }
      PackageModel& other = model_of(a->Value());
      const char* unit = other.xml.root().Attribute("unit");
      if (unit_of(other, unit == nullptr ? "millimeter" : unit) != unit_) {
        other.xml.fail(other.xml.root(), "its unit is not that of the root model; export the mesh in one unit");
      }
      return other;
    }
    return model;
  }

  static ExactFrame frame_of(const PackageModel& model, const XMLElement& element) {
    ExactFrame frame;
    const char* text = element.Attribute("transform");
    if (text == nullptr) return frame;
    const std::vector<std::string_view> words = xml_words(text);
    if (words.size() != 12) {
      model.xml.fail(element,
                     fmt::format("the transform has {} numbers, expected 12; export the mesh again", words.size()));
    }
    bool is_identity = true;
    for (std::size_t i = 0; i < 12; ++i) {
      const double value = model.xml.number(element, "transform", words[i]);
      is_identity = is_identity && value == (i < 9 && i % 4 == 0 ? 1 : 0);
      (i < 9 ? frame.turn[i / 3][i % 3] : frame.move[i - 9]) = value;
    }
    frame.is_identity = is_identity;
    if (frame.determinant() == Sign::zero) {
      model.xml.fail(element, "the transform makes the object flat; give one that does not");
    }
    return frame;
  }

  void add_object(PackageModel& model, const XMLElement& object, std::string_view outer_name, const ExactFrame& frame,
                  std::uint32_t depth) {
    if (depth > most_nested_components) {
      model.xml.fail(object, fmt::format("components are nested more than {} deep, or in a circle; export the mesh "
                                         "again",
                                         most_nested_components));
    }
    const char* own_name = object.Attribute("name");
    const std::string_view name = own_name == nullptr || *own_name == '\0' ? outer_name : own_name;
    bool is_empty = true;
    XmlFile::each_child(object, [&](const XMLElement& child) {
      if (is_core(model, child, "mesh")) {
        add_mesh(model, object, child, name, frame);
      } else if (is_core(model, child, "components")) {
        XmlFile::each_child(child, [&](const XMLElement& component) {
          if (!is_core(model, component, "component")) return leave_out(model, component);
          add_instance(model, component, name, frame, depth + 1);
        });
      } else {
        const std::string kind = kind_of(model, child);
        if (kind.empty()) return;
        builder_.leave_out(kind, 1);
      }
      is_empty = false;
    });
    if (is_empty) model.xml.fail(object, "<object> has neither <mesh> nor <components>; export the mesh again");
  }

  void add_mesh(const PackageModel& model, const XMLElement& object, const XMLElement& mesh, std::string_view name,
                const ExactFrame& frame) {
    const char* type = object.Attribute("type");
    const std::string_view kind = type == nullptr ? "model" : type;
    if (kind == "support" || kind == "solidsupport") return builder_.leave_out("support", 1);
    if (kind != "model" && kind != "surface") {
      model.xml.fail(object, fmt::format("an object of type {} is to be built; export the mesh again", quote(kind)));
    }
    auto known = read_.find(&mesh);
    if (known == read_.end()) known = read_.emplace(&mesh, read_mesh_of(model, mesh)).first;
    const TriangleMesh& triangles = known->second;
    budget_.spend(triangles.vertices.size() + triangles.corners.size() + triangles.left_out.size());
    for (const std::string& item : triangles.left_out) builder_.leave_out(item, 1);
    builder_.begin_part(name);
    const std::uint32_t first = builder_.vertex_count();
    for (const Point3& vertex : triangles.vertices) builder_.add_vertex(placed(model, object, vertex, frame));
    // A map that mirrors turns triangles over, and they are turned back: what was inside stays so.
    const std::size_t second = frame.determinant() == Sign::negative ? 2 : 1;
    for (std::size_t c = 0; c < triangles.corners.size(); c += 3) {
      builder_.add_corner(first + triangles.corners[c]);
      builder_.add_corner(first + triangles.corners[c + second]);
      builder_.add_corner(first + triangles.corners[c + 3 - second]);
      builder_.end_polygon();
    }
  }

  // In millimetres. Each coordinate is the double nearest to the image of what the file says.
  Point3 placed(const PackageModel& model, const XMLElement& object, const Point3& vertex, const ExactFrame& frame) {
    if (frame.is_identity && unit_->mm == 1 && unit_->per == 1) return vertex;
    const std::array<Dyadic, 3> exact{vertex.x, vertex.y, vertex.z};
    Point3 result;
    for (std::size_t k = 0; k < 3; ++k) {
      const Dyadic length = (frame.image(exact, k) + frame.move[k]) * unit_->mm;
      result[k] = unit_->per == 1 ? length.nearest() : nearest_ratio(length, unit_->per);
      if (!std::isfinite(result[k])) {
        model.xml.fail(object, "its transforms move a vertex beyond the doubles; export the mesh again");
      }
      rounded_ += !(Dyadic(result[k]) * unit_->per == length);
    }
    return result;
  }

  // --- Meshes ----------------------------------------------------------------------------------------------------

  TriangleMesh read_mesh_of(const PackageModel& model, const XMLElement& mesh) {
    TriangleMesh result;
    std::vector<Point3> vertices;
    const XMLElement* triangles = nullptr;
    XmlFile::each_child(mesh, [&](const XMLElement& child) {
      if (is_core(model, child, "vertices")) {
        XmlFile::each_child(child, [&](const XMLElement& vertex) {
          if (!is_core(model, vertex, "vertex")) return result.left_out.push_back(shorten(vertex.Name()));
          vertices.push_back({number(model, vertex, "x"), number(model, vertex, "y"), number(model, vertex, "z")});
        });
      } else if (is_core(model, child, "triangles")) {
        triangles = &child;
      } else if (std::string kind = kind_of(model, child); !kind.empty()) {
        result.left_out.push_back(std::move(kind));
      }
    });
    if (triangles != nullptr) read_triangles(model, *triangles, vertices, result);
    if (result.corners.empty()) model.xml.fail(mesh, "<mesh> has no <triangle>; export the mesh again");
    keep_vertices_in_use(std::move(vertices), result);
    return result;
  }

  void read_triangles(const PackageModel& model, const XMLElement& triangles, const std::vector<Point3>& vertices,
                      TriangleMesh& result) const {
    XmlFile::each_child(triangles, [&](const XMLElement& triangle) {
      if (!is_core(model, triangle, "triangle")) return result.left_out.push_back(shorten(triangle.Name()));
      for (const char* corner : {"v1", "v2", "v3"}) {
        const std::uint32_t v = whole(model, triangle, corner);
        if (v >= vertices.size()) {
          model.xml.fail(triangle, fmt::format("this triangle names vertex {}, but there are {} (counted from 0); "
                                               "export the mesh again",
                                               v, vertices.size()));
        }
        result.corners.push_back(v);
      }
    });
  }

  // <vertices> is a store: what no triangle names is no part of the mesh.
  static void keep_vertices_in_use(std::vector<Point3> vertices, TriangleMesh& mesh) {
    std::vector<std::uint32_t> number(vertices.size());
    for (const std::uint32_t corner : mesh.corners) number[corner] = 1;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (number[v] == 0) continue;
      number[v] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(vertices[v]);
    }
    for (std::uint32_t& corner : mesh.corners) corner = number[corner];
  }

  static std::string_view without_blanks(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    return text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
  }

  static double number(const PackageModel& model, const XMLElement& element, const char* name) {
    return model.xml.number(element, name, without_blanks(model.xml.attribute(element, name)));
  }

  static std::uint32_t whole(const PackageModel& model, const XMLElement& element, const char* name) {
    const std::string_view text = without_blanks(model.xml.attribute(element, name));
    std::int64_t value = 0;
    if (!parse_integer(text, value) || value < 0 || value > MeshBuilder::largest_vertex) {
      model.xml.fail(element, fmt::format("{} of {}: {} is no number from 0 to 2^31; export the mesh again", name,
                                          XmlFile::tag(element), quote(text)));
    }
    return static_cast<std::uint32_t>(value);
  }

  ZipArchive archive_;
  MeshBuilder builder_;
  std::string_view place_;
  InstanceBudget budget_;
  std::map<std::string, std::unique_ptr<PackageModel>> models_;  // by name
  std::map<const XMLElement*, TriangleMesh> read_;
  const LengthUnit* unit_ = nullptr;
  bool has_materials_ = false;
  std::uint64_t rounded_ = 0;
};

}  // namespace

bool is_3mf(std::string_view bytes) { return is_zip(bytes) && bytes.rfind(".model") != std::string_view::npos; }

Mesh parse_3mf(std::string_view bytes, std::string_view place) { return ThreeMfParser(bytes, place).parse(); }

}  // namespace sunder::io
