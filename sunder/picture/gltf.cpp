#include <sunder/base/json.h>
#include <sunder/certificate/rounded_evidence.h>
#include <sunder/picture/gltf.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::picture {

namespace {

// Numbers of glTF 2.0.
constexpr int of_floats = 5126, of_indices = 5125;
constexpr int vertex_target = 34962, index_target = 34963;
constexpr int as_points = 0, as_lines = 1, as_triangles = 4;

enum Material : std::uint8_t { apart, meets, undecided };

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) {
      three = three << 8u | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[three >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

// Little-endian, whatever the machine is.
void add_word(std::uint32_t word, std::string& bytes) {
  for (unsigned k = 0; k < 4; ++k) bytes += static_cast<char>(word >> 8 * k & 0xffu);
}

float single(double x, const std::string& body) {
  const auto result = static_cast<float>(x);
  if (!std::isfinite(result)) {
    throw Error(ErrorCode::bad_value, "a coordinate is beyond single precision, which glTF has; leave out --gltf",
                body);
  }
  return result;
}

class Model {
 public:
  explicit Model(std::span<const ScenePanel> panels) {
    json_["asset"] = {{"version", "2.0"}, {"generator", "sunder"}};
    json_["scene"] = 0;
    for (const char* list : {"accessors", "meshes", "nodes", "scenes"}) json_[list] = Json::array();
    const auto material = [](const char* name, double red, double green, double blue) {
      return Json{{"name", name},
                  {"doubleSided", true},
                  {"pbrMetallicRoughness",
                   {{"baseColorFactor", {red, green, blue, 1.0}}, {"metallicFactor", 0}, {"roughnessFactor", 0.8}}}};
    };
    json_["materials"] = {material("apart", 0.45, 0.55, 0.7), material("meets", 0.76, 0.1, 0.06),
                          material("undecided", 0.9, 0.6, 0.1)};
    for (const ScenePanel& panel : panels) add(panel);
    std::string said = "for the eye alone: positions are rounded to single precision";
    if (some_round_) said += "; balls, cylinders and the like are polyhedra inside of them";
    json_["asset"]["extras"] = {{"said", said}};
  }

  std::string text(GltfForm form) {
    if (positions_.empty()) {  // empty lists are none of glTF
      for (const char* const list : {"meshes", "accessors"}) json_.erase(list);
      return form == GltfForm::binary ? binary("") : json_.compact() + "\n";
    }
    std::string bytes = positions_;
    for (const std::uint32_t i : indices_) add_word(i, bytes);
    const std::size_t middle = positions_.size();
    json_["bufferViews"] = {
        {{"buffer", 0}, {"byteOffset", 0}, {"byteLength", middle}, {"target", vertex_target}},
        {{"buffer", 0}, {"byteOffset", middle}, {"byteLength", bytes.size() - middle}, {"target", index_target}}};
    json_["buffers"] = {{{"byteLength", bytes.size()}}};
    if (form == GltfForm::binary) return binary(bytes);
    json_["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(bytes);
    return json_.compact() + "\n";
  }

 private:
  std::string binary(const std::string& bytes) const {
    std::string text = json_.compact();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string file = "glTF";
    add_word(2, file);
    const std::size_t rest = bytes.empty() ? 0 : 8 + bytes.size();
    add_word(static_cast<std::uint32_t>(12 + 8 + text.size() + rest), file);
    add_word(static_cast<std::uint32_t>(text.size()), file);
    file += "JSON" + text;
    if (bytes.empty()) return file;
    add_word(static_cast<std::uint32_t>(bytes.size()), file);
    return file + std::string("BIN\0", 4) + bytes;
  }

  std::size_t node(Json node, Json* parent) {
    const std::size_t number = json_["nodes"].size();
    json_["nodes"].push_back(std::move(node));
    if (parent != nullptr) parent->push_back(number);
    return number;
  }

  void add(const ScenePanel& panel) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> meeting, unknown;  // parts
    for (const scene::PartPair& pair : panel.answer.pairs) {
      if (!pair.counts && !pair.undecided()) continue;
      auto& parts = pair.counts ? meeting : unknown;
      parts.insert({pair.body_a, pair.part_a});
      parts.insert({pair.body_b, pair.part_b});
    }
    Json all = Json::array();
    for (std::uint32_t b = 0; b < panel.bodies.size(); ++b) {
      const scene::Body& body = panel.bodies[b];
      Json inner = Json::array();
      std::size_t mesh = 0;
      for (std::uint32_t p = 0; p < body.parts.size(); ++p) {
        const std::pair part{b, p};
        mesh = add_mesh(body.parts[p], body.name,
                        meeting.contains(part)   ? meets
                        : unknown.contains(part) ? undecided
                                                 : apart);
        if (body.parts.size() > 1) node({{"name", part_name(body, p)}, {"mesh", mesh}}, &inner);
      }
      Json of_body{{"name", body.name}};
      if (!inner.empty()) of_body["children"] = inner;
      if (body.parts.size() == 1) of_body["mesh"] = mesh;
      node(std::move(of_body), &all);
    }
    for (const scene::PartPair& pair : panel.answer.pairs) {
      if (!pair.counts) continue;
      const scene::Body &a = panel.bodies[pair.body_a], &b = panel.bodies[pair.body_b];
      const Point3 at = rounded_common_point(pair, a.parts[pair.part_a], b.parts[pair.part_b]);
      node({{"name", panel.told(pair)},
            {"translation", {single(at.x, a.name), single(at.y, a.name), single(at.z, a.name)}}},
           &all);
    }
    // x stays, z becomes y, y becomes -z: column by column.
    Json top{{"name", panel.title}, {"matrix", {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1}}};
    if (!all.empty()) top["children"] = all;
    if (!panel.notes.empty()) top["extras"] = {{"notes", panel.notes}};
    const std::size_t number = node(std::move(top), nullptr);
    json_["scenes"].push_back({{"name", panel.title}, {"nodes", {number}}});
  }

  // Returns its number.
  std::size_t add_mesh(const scene::Part& part, const std::string& body, Material material) {
    const auto [shape, is_all] = part.mesh != nullptr ? solid::DrawnBody{part.shape.core()} : drawn_as(part.shape);
    some_round_ = some_round_ || !is_all;
    const std::span<const Point3> corners = part.mesh != nullptr ? part.mesh->points() : shape.vertices();
    const PlacedVertices placed{corners, part.pose.affine(), false};
    std::array<float, 3> low, high;
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    const std::size_t first = positions_.size(), first_index = indices_.size();
    for (std::uint32_t v = 0; v < corners.size(); ++v) {
      const Vector3<double> p = rounded_image(placed[v]);
      const std::array at{single(p.x, body), single(p.y, body), single(p.z, body)};
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], at[k]);
        high[k] = std::max(high[k], at[k]);
        add_word(std::bit_cast<std::uint32_t>(at[k]), positions_);
      }
    }
    const int mode = part.mesh != nullptr ? add_triangles(*part.mesh, part.pose) : add_indices(shape, part.pose);
    Json& accessors = json_["accessors"];
    Json attributes{{"POSITION", accessors.size()}};
    Json primitive{{"attributes", attributes},
                   {"indices", accessors.size() + 1},
                   {"mode", mode},
                   {"material", static_cast<int>(material)}};
    accessors.push_back({{"bufferView", 0},
                         {"byteOffset", first},
                         {"componentType", of_floats},
                         {"count", corners.size()},
                         {"type", "VEC3"},
                         {"min", low},
                         {"max", high}});
    accessors.push_back({{"bufferView", 1},
                         {"byteOffset", first_index * sizeof(std::uint32_t)},
                         {"componentType", of_indices},
                         {"count", indices_.size() - first_index},
                         {"type", "SCALAR"}});
    json_["meshes"].push_back({{"name", part.name}, {"primitives", Json::array({primitive})}});
    return json_["meshes"].size() - 1;
  }

  // Triangles that run counter-clockwise seen from outside, also where the pose reflects; or a segment, or a point.
  int add_indices(const solid::ConvexPolyhedron& shape, const solid::Pose& pose) {
    if (shape.dimension() < 2) {
      for (std::uint32_t v = 0; v < shape.vertices().size(); ++v) indices_.push_back(v);
      return shape.dimension() == 1 ? as_lines : as_points;
    }
    const bool is_mirrored = is_mirror(pose);
    const std::uint32_t facets = shape.dimension() == 2 ? 1 : shape.facet_count();  // both sides are shown
    for (std::uint32_t f = 0; f < facets; ++f) {
      const auto facet = shape.facet(f);
      for (std::size_t i = 2; i < facet.size(); ++i) {
        const std::uint32_t b = facet[i - 1], c = facet[i];
        for (const std::uint32_t v : {facet[0], is_mirrored ? c : b, is_mirrored ? b : c}) indices_.push_back(v);
      }
    }
    return as_triangles;
  }

  // As they are.
  int add_triangles(const solid::Mesh& mesh, const solid::Pose& pose) {
    const bool is_mirrored = is_mirror(pose);
    for (const auto& [a, b, c] : mesh.triangles()) {
      for (const std::uint32_t v : {a, is_mirrored ? c : b, is_mirrored ? b : c}) indices_.push_back(v);
    }
    return as_triangles;
  }

  static bool is_mirror(const solid::Pose& pose) {
    const auto& m = pose.affine().linear;
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
               m[2] * (m[3] * m[7] - m[4] * m[6]) <
           0;
  }

  Json json_;
  std::string positions_;
  std::vector<std::uint32_t> indices_;
  bool some_round_ = false;
};

}  // namespace

std::string scene_gltf(std::span<const ScenePanel> panels, GltfForm form) { return Model(panels).text(form); }

}  // namespace sunder::picture
