// The formats that are scenes: COLLADA, glTF, VRML; for 3MF see mesh_3mf_test.cpp. See mesh_body_test.cpp for what all formats have in common.
#include <sunder/base/error.h>
#include <sunder/io/mesh/frame_internal.h>
#include <sunder/io/mesh/mesh_formats.h>
#include <sunder/io/mesh/mesh_parse_test.h>
#include <sunder/io/text/file.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>

#include <cmath>

namespace sunder::io {
namespace {

namespace fs = std::filesystem;

const fs::path mesh_cases = fs::path(tests::cases_folder()) / "mesh";

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("no " + std::string(from));
  return text.replace(at, from.size(), to);
}

// A tetrahedron turned by a quarter about z, and one twice as large beside it; both at (10, 0, 0).
const std::vector<Point3> turned_tetrahedron{{10, 0, 0}, {10, 1, 0}, {9, 0, 0}, {10, 0, 1}};
const std::vector<Point3> large_tetrahedron{{10, 5, 0}, {12, 5, 0}, {10, 7, 0}, {10, 5, 2}};

void expect_two_nodes(const Mesh& mesh, double margin) {
  std::vector<Point3> expected = turned_tetrahedron;
  expected.insert(expected.end(), large_tetrahedron.begin(), large_tetrahedron.end());
  EXPECT_EQ(mesh.vertices.size(), expected.size());
  const std::vector<std::uint32_t> corners{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3, 4, 6, 5, 4, 5, 7, 4, 7, 6, 5, 6, 7};
  ASSERT_EQ(mesh.polygon_vertices.size(), corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point3 &found = mesh.vertices[mesh.polygon_vertices[i]], &right = expected[corners[i]];
    EXPECT_NEAR(found.x, right.x, margin);
    EXPECT_NEAR(found.y, right.y, margin);
    EXPECT_NEAR(found.z, right.z, margin);
  }
  ASSERT_EQ(mesh.parts.size(), 2u);
  EXPECT_EQ(mesh.parts[1].first, 4u);
}

TEST(MeshScenes, NodesMoveTheirMeshes) {
  expect_two_nodes(read_mesh(mesh_cases / "two_nodes.dae"), 1e-14);
  expect_two_nodes(read_mesh(mesh_cases / "two_nodes.wrl"), 1e-14);
  InputFiles inputs;
  const Mesh mesh = read_mesh(mesh_cases / "two_nodes.gltf", &inputs);
  EXPECT_EQ(inputs.size(), 2u) << "the buffer is an input, too";
  EXPECT_EQ(mesh.parts[0].name, "turned");
  EXPECT_EQ(mesh.parts[1].name, "large");
  expect_two_nodes(mesh, 1e-14);
}

TEST(MeshScenes, QuartersOfATurnAreExact) {
  for (const double angle : {90.0, -270.0, 450.0}) {
    EXPECT_EQ(turned_by_degrees({0, 0, 5}, angle)({0.1, 0.3, 7}), (Point3{-0.3, 0.1, 7})) << angle;
  }
  EXPECT_EQ(turned_by_degrees({-1e300, 0, 0}, 180)({0.1, 0.3, 7}), (Point3{0.1, -0.3, -7}));
  EXPECT_EQ(turned_by_degrees({0, 1, 0}, -720)({0.1, 0.3, 7}), (Point3{0.1, 0.3, 7}));
  const Point3 third = turned_by_degrees({1, 1, 1}, 120)({1, 2, 3});
  EXPECT_NEAR(third.x, 3, 1e-14);
  EXPECT_NEAR(third.y, 1, 1e-14);
  EXPECT_NEAR(third.z, 2, 1e-14);
  const Point3 by_quaternion = turned_by_quaternion({1e-200, 1e-200, 1e-200, 1e-200})({1, 2, 3});
  EXPECT_EQ(by_quaternion, (Point3{3, 1, 2}));
}

TEST(MeshScenes, TheFirstFrameIsTheInnermost) {
  const NodeFrame both = compose(moved_by({1, 0, 0}), scaled_by({2, 3, 4}));
  EXPECT_EQ(both({1, 1, 1}), (Point3{3, 3, 4}));
}

TEST(MeshCollada, KeepsDoubles) {
  const std::string text = read_file(mesh_cases / "tetrahedron.dae");
  const Mesh mesh = checked_mesh(replaced(text, ">0 0 0 1 ", ">0.1 1e-320 -0 1 "), MeshFormat::collada);
  EXPECT_EQ(mesh.vertices[0], (Point3{0.1, 1e-320, 0}));
  EXPECT_FALSE(std::signbit(mesh.vertices[0].z));
}

TEST(MeshCollada, ReadsEveryKindOfPrimitive) {
  const std::string text = read_file(mesh_cases / "tetrahedron.dae");
  const std::size_t begin = text.find("<polylist"), end = text.find("</polylist>") + 11;
  const auto with = [&](const std::string& primitive) {
    return checked_mesh(text.substr(0, begin) + primitive + text.substr(end), MeshFormat::collada);
  };
  const std::string input = R"(<input semantic="VERTEX" source="#vertices" offset="0"/>)";
  using Corners = std::vector<std::uint32_t>;
  EXPECT_EQ(with("<tristrips>" + input + "<p>0 1 2 3</p></tristrips>").polygon_vertices, (Corners{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(with("<trifans>" + input + "<p>0 1 2 3</p></trifans>").polygon_vertices, (Corners{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(with("<triangles count=\"1\">" + input + "<p>0 1 3</p></triangles>").polygon_vertices, (Corners{0, 1, 2}));
  const Mesh polygons = with("<polygons>" + input + "<p>0 1 2 3</p><p>3 2 1</p><ph><p>0 1 2</p></ph></polygons>" +
                             "<lines count=\"1\">" + input + "<p>0 1</p></lines>");
  EXPECT_EQ(polygons.polygon_begin, (Corners{0, 4, 7}));
  ASSERT_EQ(polygons.left_out.size(), 2u);
  EXPECT_EQ(polygons.left_out[0].kind, "polygon with holes");
  EXPECT_EQ(polygons.left_out[1].kind, "line");
}

TEST(MeshCollada, WithoutASceneEachGeometryStandsForItself) {
  const std::string text = read_file(mesh_cases / "tetrahedron.dae");
  const std::size_t begin = text.find("<library_visual_scenes>");
  EXPECT_EQ(checked_mesh(text.substr(0, begin) + "</COLLADA>", MeshFormat::collada).polygon_count(), 4u);
  const std::string two =
      replaced(text, "<visual_scene id=\"scene\">", "<visual_scene id=\"other\"/><visual_scene id=\"scene\">");
  EXPECT_EQ(checked_mesh(two, MeshFormat::collada).polygon_count(), 4u);
  const std::string unsaid = replaced(two, "<scene><instance_visual_scene url=\"#scene\"/></scene>", "");
  EXPECT_NE(mesh_error(unsaid, MeshFormat::collada).find("has several scenes"), std::string::npos);
}

TEST(MeshCollada, AxesHaveTheirNames) {
  const std::string text = read_file(mesh_cases / "tetrahedron.dae");
  const Mesh mesh =
      checked_mesh(replaced(replaced(text, "name=\"X\"", "name=\"Z\""), "<param name=\"Z\" type=\"float\"/>\n",
                            "<param name=\"X\" type=\"float\"/>\n"),
                   MeshFormat::collada);
  EXPECT_EQ(mesh.vertices[1], (Point3{0, 0, 1}));
  EXPECT_EQ(mesh.vertices[3], (Point3{1, 0, 0}));
}

TEST(MeshGltf, JoinsEqualPointsAndTellsLines) {
  const std::string text = read_file(mesh_cases / "cube.gltf");
  EXPECT_EQ(checked_mesh(text, MeshFormat::gltf).vertices.size(), 8u);
  const Mesh lines = checked_mesh(replaced(text, "\"indices\": 1", "\"mode\": 1"), MeshFormat::gltf);
  ASSERT_FALSE(lines.left_out.empty());
  EXPECT_EQ(lines.left_out[0].kind, "line");
  EXPECT_EQ(lines.left_out[0].count, 12u);
  EXPECT_EQ(checked_mesh(replaced(text, "\"indices\": 1", "\"mode\": 6"), MeshFormat::gltf).polygon_count(), 22u);
  EXPECT_EQ(checked_mesh(replaced(text, "\"indices\": 1", "\"mode\": 5"), MeshFormat::gltf).polygon_count(), 22u);
}

TEST(MeshGltf, OneFileAloneHasNoBuffersBeside) {
  EXPECT_NE(mesh_error(read_file(mesh_cases / "two_nodes.gltf"), MeshFormat::gltf).find("only this file is given"),
            std::string::npos);
}

TEST(MeshGltf, NamesOfBuffersStayWithinTheFolder) {
  const std::string text = read_file(mesh_cases / "two_nodes.gltf");
  for (const char* name :
       {"/etc/passwd", "../a.bin", "a/../../b.bin", "%2e%2e/a.bin", "%2Fetc/passwd", "file:a", "", "."}) {
    std::string asked = "nothing";
    try {
      parse_gltf(replaced(text, "two_nodes%5Fof.bin", name), "test", [&](const fs::path& path) {
        asked = path.string();
        return std::string(168, '\0');
      });
    } catch (const Error&) {
      asked = "refused";
    }
    EXPECT_EQ(asked, std::string(name) == "." ? "." : "refused") << name;
  }
}

TEST(MeshVrml, CommasAreBlanksAndFieldsMayComeInAnyOrder) {
  const Mesh mesh = checked_mesh(
      "#VRML V2.0 utf8\n,,Shape{geometry IndexedFaceSet{coordIndex[0,1,2,-1,,]creaseAngle 0.5 colorIndex []\n"
      "texCoord TextureCoordinate{point[0 0]} coord Coordinate{point[0 0 0 1,0,0 .5 1 0]}ccw FALSE}}",
      MeshFormat::vrml);
  EXPECT_EQ(mesh.vertices.back(), (Point3{0.5, 1, 0}));
  EXPECT_EQ(mesh.polygon_vertices, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(MeshVrml, TellsWhatIsNoPolygon) {
  const Mesh mesh = checked_mesh(
      "#VRML V2.0 utf8\nShape{geometry IndexedFaceSet{coord Coordinate{point[0 0 0 1 0 0 0 1 0]}coordIndex[0 1 2]}}\n"
      "DEF s Shape{geometry Sphere{radius 2}} Transform{children[USE s Inline{url \"a.wrl\"}]}",
      MeshFormat::vrml);
  ASSERT_EQ(mesh.left_out.size(), 2u);
  EXPECT_EQ(mesh.left_out[0].kind, "sphere");
  EXPECT_EQ(mesh.left_out[0].count, 2u);
  EXPECT_EQ(mesh.left_out[1].kind, "inline file");
}

TEST(MeshVrml, ScalesAlongTurnedAxesAboutACenter) {
  const Mesh mesh = checked_mesh(
      "#VRML V2.0 utf8\nTransform{center 1 0 0 scale 3 1 1 scaleOrientation 0 0 1 1.5707963267948966 children Shape{"
      "geometry IndexedFaceSet{coord Coordinate{point[1 0 0 2 0 0 1 1 0]}coordIndex[0 1 2]}}}",
      MeshFormat::vrml);
  EXPECT_NEAR(mesh.vertices[0].x, 1, 1e-15);
  EXPECT_NEAR(mesh.vertices[1].x, 2, 1e-15);
  EXPECT_NEAR(mesh.vertices[2].y, 3, 1e-15);
}

TEST(MeshVrml, PointsThatSeveralFacesShareAreCopiedWhereInUse) {
  const Mesh mesh = checked_mesh(
      "#VRML V2.0 utf8\nShape{geometry IndexedFaceSet{coord DEF c Coordinate{point[0 0 0 1 0 0 0 1 0 5 5 5]}"
      "coordIndex[0 1 2]}} Shape{geometry IndexedFaceSet{coord USE c coordIndex[3 1 2]}}",
      MeshFormat::vrml);
  EXPECT_EQ(mesh.vertices.size(), 6u);
  EXPECT_TRUE(mesh.left_out.empty());
  EXPECT_EQ(mesh.parts.size(), 2u);
}

}  // namespace
}  // namespace sunder::io
