#include <sunder/io/mesh/space_objects.h>
#include <sunder/io/robot/robot_motion.h>
#include <sunder/io/robot/scene_file.h>
#include <sunder/io/robot/urdf.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/json_internal.h>
#include <sunder/io/text/json_shapes_internal.h>
#include <sunder/io/text/text.h>

#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace sunder::io {

namespace {

using nlohmann::json;
using solid::Pose;
using solid::RoundBody;

struct Unit {
  std::string_view name;
  double in_tenths_of_mm;
};
constexpr std::array<Unit, 5> units{{{"m", 10000}, {"cm", 100}, {"mm", 10}, {"in", 254}, {"ft", 3048}}};
constexpr std::array<std::string_view, 9> shapes{"mesh",    "points",   "box",  "rounded",  "ball",
                                                 "capsule", "cylinder", "cone", "ellipsoid"};

// What is wrong, without the place, which is another one in the file.
std::string said(const Error& error) {
  const std::string text = error.what();
  return error.place().empty() ? text : text.substr(error.place().size() + 2);
}

class SceneParser : JsonShapes {
 public:
  explicit SceneParser(std::string_view file) : JsonShapes(file), file_(file) {}

  SceneFile parse(std::string_view text) {
    const json top = parse_json(text, file_);
    const Keys keys{"unit", "bodies", "allowed"};
    if (!top.is_object() || !top.contains("bodies")) {
      fail_file(file_, "is no scene; give {\"bodies\": [{\"name\": .., \"parts\": [..]}]}");
    }
    require_keys(top, "the scene", keys);
    if (const auto unit = top.find("unit"); unit != top.end()) scene_.unit = unit_of(*unit, "unit").name;
    const json& bodies = top["bodies"];
    require_list(bodies, "bodies");
    for (const json& body : bodies) read_body(body, fmt::format("bodies[{}]", scene_.bodies.size()));
    if (const auto allowed = top.find("allowed"); allowed != top.end()) read_allowed(*allowed);
    return std::move(scene_);
  }

 private:
  // A list that is not empty.
  void require_list(const json& value, const std::string& where) const {
    if (!value.is_array()) fail(where, "is no list");
    if (value.empty()) fail(where, "is empty; give one or more");
  }

  std::string name_of(const json& value, const std::string& where) const {
    if (!value.is_string()) fail(where, "is no text; give a name in quotes");
    std::string name = one_line(value.get_ref<const std::string&>());
    if (name.empty()) fail(where, "is empty; give a name");
    return name;
  }

  const Unit& unit_of(const json& value, const std::string& where) const {
    const std::string name = name_of(value, where);
    const auto found = std::find_if(units.begin(), units.end(), [&](const Unit& unit) { return unit.name == name; });
    if (found == units.end()) fail(where, fmt::format("{} is no unit; give m, cm, mm, in or ft", quote(name)));
    return *found;
  }

  void read_body(const json& value, const std::string& where) {
    const Keys keys{"name", "pose", "parts"};
    SceneFile::Body body{name_of(member(value, where, "name", keys), where + ".name"), {}};
    const auto [first, is_new] = numbers_.emplace(body.name, static_cast<std::uint32_t>(scene_.bodies.size()));
    if (!is_new) {
      fail(where + ".name",
           fmt::format("{} is the name of bodies[{}], too; rename one", quote(body.name), first->second));
    }
    const Pose pose = pose_in(value, where);
    const json& parts = member(value, where, "parts", keys);
    require_list(parts, where + ".parts");
    std::set<std::string> names;
    for (const json& part : parts) {
      const std::string at = fmt::format("{}.parts[{}]", where, body.parts.size());
      body.parts.push_back(part_of(part, pose, at));
      const std::string& name = body.parts.back().name;
      if (!name.empty() && !names.insert(name).second) {
        fail(at + ".name", fmt::format("two parts of the body are named {}; rename one", quote(name)));
      }
    }
    scene_.bodies.push_back(std::move(body));
  }

  Pose pose_in(const json& value, const std::string& where) const {
    const auto found = value.find("pose");
    return found == value.end() ? Pose() : pose_of(*found, where + ".pose");
  }

  Pose pose_of(const json& value, const std::string& where) const {
    require_keys(value, where, {"matrix", "translation", "quaternion"});
    if (value.empty()) fail(where, "is empty; give \"matrix\", or \"translation\" and \"quaternion\"");
    const bool has_matrix = value.contains("matrix");
    if (has_matrix && value.size() > 1) fail(where, "has a matrix and more; leave one out");
    try {
      if (has_matrix) return matrix_of(value["matrix"], where + ".matrix");
      std::array<double, 3> t{0, 0, 0};
      std::array<double, 4> q{1, 0, 0, 0};
      if (value.contains("translation")) {
        t = numbers<3>(value["translation"], where + ".translation", "[x, y, z]");
        if (value.size() == 1) return Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, t);
      }
      q = numbers<4>(value["quaternion"], where + ".quaternion", "[w, x, y, z]");
      return Pose::from_quaternion(q[0], q[1], q[2], q[3], t);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::bad_file) throw;
      fail(where, said(error));
    }
  }

  Pose matrix_of(const json& value, const std::string& where) const {
    if (!value.is_array() || (value.size() != 3 && value.size() != 4)) fail(where, "is no list of 3 or 4 rows");
    std::array<double, 16> rows{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    for (std::size_t i = 0; i < value.size(); ++i) {
      const auto row = numbers<4>(value[i], fmt::format("{}[{}]", where, i), "[a, b, c, d]");
      std::copy(row.begin(), row.end(), rows.begin() + static_cast<std::ptrdiff_t>(4 * i));
    }
    return Pose::from_matrix4(rows);
  }

  SceneFile::Part part_of(const json& value, const Pose& body, const std::string& where) const {
    const Keys keys{"name", "pose",    "mesh",     "points", "box",      "rounded",
                    "ball", "capsule", "cylinder", "cone",   "ellipsoid"};
    require_keys(value, where, keys);
    SceneFile::Part part;
    if (const auto name = value.find("name"); name != value.end()) part.name = name_of(*name, where + ".name");
    std::vector<std::string_view> found;
    for (const std::string_view shape : shapes) {
      if (value.contains(shape)) found.push_back(shape);
    }
    if (found.size() != 1) {
      fail(where, found.empty() ? fmt::format("has no shape; give one of {}", fmt::join(shapes, ", "))
                                : fmt::format("has {} shapes, {}; give each a part of its own", found.size(),
                                              fmt::join(found, " and ")));
    }
    part.format = found[0];
    read_shape(value[part.format], where + "." + part.format, part);
    place(body, pose_in(value, where), where, part);
    return part;
  }

  void place(const Pose& body, const Pose& inner, const std::string& where, SceneFile::Part& part) const {
    try {
      part.pose = composed(body, inner);
      if (part.mesh && part.mesh->scale != std::array<double, 3>{1, 1, 1}) {
        const auto& [x, y, z] = part.mesh->scale;
        part.pose = compose(part.pose, Pose::from_matrix({x, 0, 0, 0, y, 0, 0, 0, z}, {0, 0, 0}));
      }
      if (part.shape) require_rigid(*part.shape, part.pose);
    } catch (const Error& error) {
      fail(where + ".pose", said(error));
    }
  }

  void read_shape(const json& value, const std::string& where, SceneFile::Part& part) const {
    try {
      if (part.format == "mesh") {
        part.mesh = mesh_of(value, where);
      } else if (part.format == "points") {
        part.shape = RoundBody(hull_of(value, where));
        part.is_convex_by_kind = false;
      } else if (part.format == "box") {
        part.shape = RoundBody(solid::ConvexPolyhedron(box_corners(box_size(value, where))));
      } else if (part.format == "rounded") {
        const Keys keys{"points", "radius"};
        const solid::ConvexPolyhedron hull = hull_of(member(value, where, "points", keys), where + ".points");
        part.shape = RoundBody::rounded(hull, number(member(value, where, "radius", keys), where + ".radius"));
      } else {
        part.shape = round_body(part.format, value, where);
      }
    } catch (const Error& error) {
      if (error.code() == ErrorCode::bad_file) throw;
      fail(where, said(error));
    }
  }

  solid::ConvexPolyhedron hull_of(const json& value, const std::string& where) const {
    require_list(value, where);
    return solid::ConvexPolyhedron(points(value, where));
  }

  SceneFile::Mesh mesh_of(const json& value, const std::string& where) const {
    if (value.is_string()) return {path_of(value, where), {1, 1, 1}, scene_.unit};
    const Keys keys{"file", "scale", "unit"};
    SceneFile::Mesh mesh{path_of(member(value, where, "file", keys), where + ".file"), {1, 1, 1}, {}};
    if (const auto scale = value.find("scale"); scale != value.end()) {
      const std::string at = where + ".scale";
      if (scale->is_number()) {
        mesh.scale.fill(number(*scale, at));
      } else {
        mesh.scale = numbers<3>(*scale, at, "[x, y, z]");
      }
      if (std::count(mesh.scale.begin(), mesh.scale.end(), 0) > 0) {
        fail(at, "is zero, and would leave nothing of the mesh; give a number that is not 0");
      }
    }
    if (mesh.scale == std::array<double, 3>{1, 1, 1}) mesh.unit = scene_.unit;
    if (const auto unit = value.find("unit"); unit != value.end()) {
      const Unit& of_mesh = unit_of(*unit, where + ".unit");
      mesh.unit = of_mesh.name;
      if (scene_.unit.empty()) fail(where + ".unit", "the scene has none that it could be put into; give its \"unit\"");
      const auto of_scene =
          std::find_if(units.begin(), units.end(), [&](const Unit& u) { return u.name == scene_.unit; });
      for (double& factor : mesh.scale) factor *= of_mesh.in_tenths_of_mm / of_scene->in_tenths_of_mm;
    }
    return mesh;
  }

  std::string path_of(const json& value, const std::string& where) const {
    if (!value.is_string()) fail(where, "is no text; give the name of a file in quotes");
    const std::string& path = value.get_ref<const std::string&>();
    if (path.empty() || path.find('\0') != std::string::npos) fail(where, "is no name of a file");
    return path;
  }

  void read_allowed(const json& value) {
    if (!value.is_array()) fail("allowed", "is no list of pairs of names");
    std::set<std::array<std::uint32_t, 2>> pairs;
    for (std::size_t i = 0; i < value.size(); ++i) {
      const std::string where = fmt::format("allowed[{}]", i);
      if (!value[i].is_array() || value[i].size() != 2) fail(where, "is no pair of names, [\"a\", \"b\"]");
      const std::uint32_t a = body_of(value[i][0], where + "[0]"), b = body_of(value[i][1], where + "[1]");
      if (a == b) fail(where, "names one body twice; parts of a body are never compared");
      pairs.insert({std::min(a, b), std::max(a, b)});
    }
    scene_.allowed.assign(pairs.begin(), pairs.end());
  }

  std::uint32_t body_of(const json& value, const std::string& where) const {
    const std::string name = name_of(value, where);
    const auto found = numbers_.find(name);
    if (found != numbers_.end()) return found->second;
    constexpr std::size_t most = 10;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(most, scene_.bodies.size()); ++i) names.push_back(scene_.bodies[i].name);
    fail(where, fmt::format("no body is named {}; bodies are {}{}", quote(name), fmt::join(names, ", "),
                            scene_.bodies.size() > most ? ", .." : ""));
  }

  std::string_view file_;
  SceneFile scene_;
  std::map<std::string, std::uint32_t> numbers_;  // of bodies, by name
};

}  // namespace

bool is_scene_file(std::string_view file) { return ending_of(file) == ".json"; }

SceneFile parse_scene_file(std::string_view text, std::string_view place) { return SceneParser(place).parse(text); }

SceneFile read_scene_file(const std::filesystem::path& path, InputFiles* inputs) {
  return parse_scene_file(read_file(path, inputs), path.string());
}

std::vector<std::vector<BodyPart>> read_scene_parts(const SceneFile& scene, const std::filesystem::path& file,
                                                    bool require_convex, LeftOutList& left_out, InputFiles* inputs,
                                                    std::vector<std::filesystem::path>* meshes, PartsOf parts) {
  const std::string shown = one_line(file.string());
  std::map<std::filesystem::path, std::vector<MeshBody>> known;
  std::vector<std::vector<BodyPart>> result;
  for (const SceneFile::Body& body : scene.bodies) {
    std::vector<BodyPart>& out = result.emplace_back();
    std::uint32_t number = 0;
    for (const SceneFile::Part& part : body.parts) {
      const std::string name = part.name.empty() ? std::to_string(number) : part.name;
      ++number;
      if (part.mesh) {
        const std::filesystem::path path = file.parent_path() / part.mesh->file;
        auto found = known.find(path);
        if (found == known.end()) {
          require_regular(path);
          if (meshes != nullptr) meshes->push_back(path);
          found = known.emplace(path, read_bodies(path, require_convex, left_out, inputs, parts)).first;
        }
        for (const MeshBody& object : found->second) {
          out.push_back(
              {found->second.size() == 1 ? name : name + "." + object.name, object, part.pose, {}, part.mesh->unit});
        }
        continue;
      }
      const solid::ConvexPolyhedron& core = part.shape->core();
      MeshBody of{shown,       name,
                  part.format, static_cast<std::uint32_t>(core.vertices().size()),
                  0,           part.is_convex_by_kind ? BodyShape::convex : BodyShape::points,
                  "",          {},
                  core};
      if (part.format == "box") of.mesh_polygons = core.facet_count();
      out.push_back({name, std::move(of), part.pose, {}, scene.unit});
      if (reach_beyond_core(*part.shape) > 0) out.back().round = part.shape;
    }
  }
  return result;
}

}  // namespace sunder::io
