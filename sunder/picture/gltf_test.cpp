#include <sunder/picture/gltf.h>

#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh_formats.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace sunder::picture {
namespace {

using nlohmann::json;
using solid::ConvexPolyhedron;
using solid::Pose;
using solid::RoundBody;

Pose at(double x, double y, double z) { return Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {x, y, z}); }

const std::vector<Point3>& wedge() {
  static const std::vector<Point3> points{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 4}};
  return points;
}

struct Scene {
  std::vector<scene::Body> bodies;
  scene::Answer answer;

  explicit Scene(std::vector<scene::Body> of) : bodies(std::move(of)), answer(scene::meeting_pairs(bodies)) {}
  std::string text(GltfForm form) const {
    const ScenePanel panel{"as \"given\"", bodies, answer};
    return scene_gltf(std::span(&panel, 1), form);
  }
};

// What meets, what is apart, parts with names, and a reflection.
Scene some_scene() {
  const Pose reflected = Pose::from_matrix({-1, 0, 0, 0, 1, 0, 0, 0, 1}, {0.5, 0, 0});
  return Scene(
      {{"a", {{"0", ConvexPolyhedron(wedge()), at(0, 0, 0)}}},
       {"b", {{"left", ConvexPolyhedron(wedge()), reflected}, {"right", ConvexPolyhedron(wedge()), at(9, 0, 0)}}},
       {"c", {{"0", RoundBody::ball({0, 0, 0}, 1), at(0, 0, 20)}}}});
}

// The sum of the tetrahedra that the triangles make with the origin: above zero where they run outwards.
double volume_of(const io::Mesh& mesh) {
  double volume = 0;
  for (std::size_t f = 0; f < mesh.polygon_count(); ++f) {
    const auto corner = [&](std::size_t i) { return mesh.vertices[mesh.polygon_vertices[3 * f + i]]; };
    const Point3 a = corner(0), b = corner(1), c = corner(2);
    volume += (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x)) / 6;
  }
  return volume;
}

TEST(Gltf, ReadsBackAsTheSameBodies) {
  const Scene scene = some_scene();
  for (const GltfForm form : {GltfForm::json, GltfForm::binary}) {
    const io::Mesh mesh = io::parse_gltf(scene.text(form), "x.gltf");
    EXPECT_TRUE(mesh.left_out.empty());
    const std::vector<io::Mesh> parts = io::split_parts(mesh);
    ASSERT_EQ(parts.size(), 4u);
    const std::array<Pose, 3> poses{scene.bodies[0].parts[0].pose, scene.bodies[1].parts[0].pose,
                                    scene.bodies[1].parts[1].pose};
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(parts[k].polygon_count(), 4u);
      std::vector<std::array<double, 3>> found, expected;
      for (const Point3& p : parts[k].vertices) found.push_back({p.x, p.y, p.z});
      for (const Point3& p : wedge()) {
        const auto& [m, t] = poses[k].affine();
        expected.push_back({m[0] * p.x + t[0], p.z + t[2], -(p.y + t[1]) + 0.0});  // z is up, and becomes y
      }
      std::sort(found.begin(), found.end());
      std::sort(expected.begin(), expected.end());
      EXPECT_EQ(found, expected) << k;
      EXPECT_NEAR(volume_of(parts[k]), 8.0 / 6, 1e-12) << k;
    }
    for (const Point3& p : parts[3].vertices) EXPECT_NEAR(std::hypot(p.x, p.y - 20, p.z), 1, 1e-5);
  }
}

TEST(Gltf, NamesAndColours) {
  const json j = json::parse(some_scene().text(GltfForm::json));
  EXPECT_EQ(j["asset"]["version"], "2.0");
  EXPECT_NE(j["asset"]["extras"]["said"].get<std::string>().find("polyhedra inside of them"), std::string::npos);
  std::vector<std::string> names, materials;
  for (const json& node : j["nodes"]) names.push_back(node["name"]);
  EXPECT_EQ(names, (std::vector<std::string>{"a", "b/left", "b/right", "b", "c", "a and b/left meet", "as \"given\""}));
  for (const json& material : j["materials"]) materials.push_back(material["name"]);
  EXPECT_EQ(materials, (std::vector<std::string>{"apart", "meets", "undecided"}));
  std::vector<int> used;
  for (const json& mesh : j["meshes"]) used.push_back(mesh["primitives"][0]["material"]);
  EXPECT_EQ(used, (std::vector<int>{1, 1, 0, 0}));
  EXPECT_EQ(j["scenes"][0]["nodes"], json{6});
  // Every accessor lies in its view, and says its own bounds.
  for (const json& accessor : j["accessors"]) {
    const json& view = j["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t size = accessor["type"] == "VEC3" ? 12 : 4;
    EXPECT_LE(accessor["byteOffset"].get<std::size_t>() + size * accessor["count"].get<std::size_t>(),
              view["byteLength"].get<std::size_t>());
  }
  EXPECT_EQ(j["accessors"][0]["min"], json::parse("[0, 0, 0]"));
  EXPECT_EQ(j["accessors"][0]["max"], json::parse("[2, 1, 4]"));
}

TEST(Gltf, ThinBodiesAndNone) {
  const Scene thin(
      {{"point", {{"0", ConvexPolyhedron(std::vector<Point3>{{1, 2, 3}}), at(0, 0, 0)}}},
       {"segment", {{"0", ConvexPolyhedron(std::vector<Point3>{{0, 0, 0}, {0, 0, 1}}), at(5, 0, 0)}}},
       {"triangle", {{"0", ConvexPolyhedron(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), at(9, 0, 0)}}},
       {"nothing", {}}});
  const json j = json::parse(thin.text(GltfForm::json));
  std::vector<int> modes;
  for (const json& mesh : j["meshes"]) modes.push_back(mesh["primitives"][0]["mode"]);
  EXPECT_EQ(modes, (std::vector<int>{0, 1, 4}));
  EXPECT_EQ(j["accessors"][5]["count"], 3);
  EXPECT_FALSE(j["nodes"][3].contains("mesh"));
  const json none = json::parse(Scene({}).text(GltfForm::json));
  EXPECT_FALSE(none.contains("meshes"));
  EXPECT_EQ(none["scenes"].size(), 1u);
  const std::string binary = Scene({}).text(GltfForm::binary);
  EXPECT_TRUE(binary.starts_with("glTF"));
  EXPECT_EQ(static_cast<unsigned char>(binary[8]) + 256u * static_cast<unsigned char>(binary[9]), binary.size());
  const Scene far({{"far", {{"0", ConvexPolyhedron(std::vector<Point3>{{1e300, 0, 0}}), at(0, 0, 0)}}}});
  EXPECT_THROW((void)far.text(GltfForm::json), Error);
}

// A mesh is in the file as it is: its triangles, which run outwards also where the pose reflects.
TEST(Gltf, HasMeshesAsTheyAre) {
  const std::vector<Point3> points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0.5, 0.5, 0.5}};
  const std::vector<std::uint32_t> begin{0, 3, 6, 9, 12, 15, 18},
      corners{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 4, 2, 3, 4, 3, 1, 4};
  const auto mesh = std::make_shared<const solid::Mesh>(solid::MeshView{points, begin, corners});
  for (const double way : {1.0, -1.0}) {
    const Pose pose = Pose::from_matrix({way, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0});
    const Scene scene({{"dented", {{"0", ConvexPolyhedron(points), pose, mesh}}}});
    const std::vector<io::Mesh> parts = io::split_parts(io::parse_gltf(scene.text(GltfForm::binary), "x.glb"));
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].vertices.size(), 5u);
    EXPECT_EQ(parts[0].polygon_count(), 6u);
    EXPECT_NEAR(volume_of(parts[0]), 3 * 16 / 12.0, 1e-12);
  }
}

}  // namespace
}  // namespace sunder::picture
