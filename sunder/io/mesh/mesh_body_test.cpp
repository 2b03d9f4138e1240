#include <sunder/base/error.h>
#include <sunder/base/random.h>
#include <sunder/io/mesh/mesh_body.h>

#include <tests/support/places.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace sunder::io {
namespace {

namespace fs = std::filesystem;

using tests::cases;

// The tetrahedron of the origin and the unit vectors, with other vertices.
Mesh tetrahedron_and(const std::vector<Point3>& others) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  Mesh mesh = parse_mesh(text, "t.obj", MeshFormat::obj);
  mesh.vertices.insert(mesh.vertices.end(), others.begin(), others.end());
  mesh.left_out.push_back({std::string(unused_vertex), "", others.size()});
  return mesh;
}

TEST(MeshBody, UnusedVerticesInTheHullChangeNothing) {
  Mesh mesh = read_mesh(cases / "mesh" / "unused-inside.obj");
  EXPECT_EQ(drop_inner_vertices(mesh), 1u);
  EXPECT_TRUE(mesh.left_out.empty());
  mesh = read_mesh(cases / "mesh" / "unused-outside.obj");
  EXPECT_EQ(drop_inner_vertices(mesh), 0u);
  ASSERT_EQ(mesh.left_out.size(), 1u);
  EXPECT_EQ(mesh.left_out[0].count, 1u);

  LeftOutList none(false);
  const MeshBody body = read_body(cases / "mesh" / "unused-inside.obj", true, none);
  EXPECT_EQ(body.mesh_vertices, 4u);
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(body.inner_vertices, 1u);
  EXPECT_EQ(inner_vertices_text(1), "1 unused vertex lies in the hull of the others, and changes nothing");
  EXPECT_EQ(read_bodies(cases / "mesh" / "unused-inside.obj", true, none)[0].inner_vertices, 1u);
  EXPECT_EQ(read_hull(cases / "mesh" / "unused-inside.obj", none).body.inner_vertices, 1u);
  EXPECT_EQ(read_body(cases / "mesh" / "cube.obj", true, none).inner_vertices, 0u);
  EXPECT_THROW((void)read_body(cases / "mesh" / "unused-outside.obj", true, none), Error);
}

// On the surface is in the hull; a last bit beyond is not.
TEST(MeshBody, TellsTheLastBitOfUnusedVertices) {
  const double third = 1.0 / 3, up = std::nextafter(third, 1);
  Mesh mesh = tetrahedron_and({{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0.25, 0.25}, {0, 0.25, 0.25}});
  EXPECT_EQ(drop_inner_vertices(mesh), 4u);
  EXPECT_TRUE(mesh.left_out.empty());
  mesh = tetrahedron_and({{0.5, 0.25, std::nextafter(0.25, 1)}, {0, 0, -0x1p-1074}, {0.25, 0.25, 0.5}});
  EXPECT_EQ(drop_inner_vertices(mesh), 1u);
  ASSERT_EQ(mesh.left_out.size(), 1u);
  EXPECT_EQ(mesh.left_out[0].count, 2u);
  mesh = tetrahedron_and({{third, third, third}, {up, up, up}});  // a third is less than one
  EXPECT_EQ(drop_inner_vertices(mesh), 1u);
}

// By three signs and a sum of numbers that have no error.
TEST(MeshBody, UnusedVerticesAreThoseOfTheTetrahedron) {
  Random random(tests::chosen_seed(20271101));
  std::uint64_t in = 0, out = 0;
  for (int round = 0; round < tests::scaled_count(200, 40); ++round) {
    std::vector<Point3> points(1 + random.below(9));
    std::uint64_t inner = 0;
    for (Point3& p : points) {
      for (std::size_t k = 0; k < 3; ++k) p[k] = static_cast<double>(random.between(-1, 8)) / 8;
      inner += p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x + p.y + p.z <= 1;
    }
    Mesh mesh = tetrahedron_and(points);
    ASSERT_EQ(drop_inner_vertices(mesh), inner);
    ASSERT_EQ(mesh.left_out.empty(), inner == points.size());
    in += inner;
    out += points.size() - inner;
  }
  EXPECT_GT(in, out / 20);
  EXPECT_GT(out, 0u);
}

// A folder of its own for each test, removed at the end.
class MeshFolder : public testing::Test {
 protected:
  MeshFolder() {
    std::string name = (fs::temp_directory_path() / "sunder-mesh-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = fs::canonical(name);
    fs::create_directory(folder_ / "mesh");
    fs::create_directory(folder_ / "other");
  }
  ~MeshFolder() override { fs::remove_all(folder_); }

  static std::string error_of(const fs::path& mesh) {
    try {
      (void)read_mesh(mesh);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(MeshFolder, BuffersAreRegularFilesInTheFolder) {
  const fs::path from = cases / "mesh", mesh = folder_ / "mesh" / "two_nodes.gltf", name = "two_nodes_of.bin";
  fs::copy(from / "two_nodes.gltf", mesh);
  const fs::path buffer = folder_ / "mesh" / name;
  // A pipe that nobody writes to: no call waits for it.
  ASSERT_EQ(mkfifo(buffer.c_str(), 0600), 0);
  EXPECT_NE(error_of(mesh).find("is a pipe or a device"), std::string::npos);
  fs::remove(buffer);
  // A link out of the folder, and one within it.
  fs::copy(from / name, folder_ / "other" / name);
  fs::create_symlink(folder_ / "other" / name, buffer);
  EXPECT_NE(error_of(mesh).find("symbolic link to a file outside the folder of the mesh; copy the file there"),
            std::string::npos);
  fs::remove(buffer);
  fs::create_directory(folder_ / "mesh" / "within");
  fs::copy(from / name, folder_ / "mesh" / "within" / name);
  fs::create_symlink(folder_ / "mesh" / "within" / name, buffer);
  EXPECT_EQ(error_of(mesh), "");
  // A mesh that is a link itself, with its buffer beside it, as packages are installed.
  fs::copy(from / "two_nodes.gltf", folder_ / "other" / "two_nodes.gltf");
  fs::create_directory(folder_ / "installed");
  for (const fs::path& file : {fs::path("two_nodes.gltf"), name}) {
    fs::create_symlink(folder_ / "other" / file, folder_ / "installed" / file);
  }
  EXPECT_EQ(error_of(folder_ / "installed" / "two_nodes.gltf"), "");
  fs::remove(folder_ / "installed" / name);
  EXPECT_NE(error_of(folder_ / "installed" / "two_nodes.gltf").find("no such file"), std::string::npos);
}

// Each names the format, and the way out.
TEST(MeshFormats, TellsWhatRobotsAndScenesAre) {
  const auto error = [](const std::string& text, const std::string& name) {
    try {
      (void)mesh_format(text, name);
    } catch (const Error& refused) {
      return std::string(refused.what());
    }
    return std::string();
  };
  const struct {
    std::string text, name, what, way;
  } known[] = {
      {"<?xml version=\"1.0\"?><sdf version=\"1.9\"></sdf>", "m.sdf", "SDF", "convert it to URDF"},
      {"<mujoco><worldbody/></mujoco>", "m.xml", "MJCF", "convert it to URDF"},
      {"<robot xmlns:xacro=\"x\"/>", "m.xacro", "xacro", "run xacro m.xacro > robot.urdf"},
      {"#usda 1.0\n", "m.usd", "USD", "export its meshes as OBJ"},
      {"PXR-USDC\x00", "m.usdc", "USD", "export its meshes as OBJ"},
      {"<robot><disable_collisions link1=\"a\" link2=\"b\"/></robot>", "m.srdf", "an SRDF", "--srdf m.srdf"},
      {"<robot name=\"r\"><link name=\"a\"/></robot>", "m.xml", "a robot (URDF)", "ending .urdf"},
      {"<X3D></X3D>", "m.x3d", "X3D", "VRML 2"},
      {"{\"bodies\": []}", "s.txt", "a scene of several bodies", "ask sunder scene"},
  };
  for (const auto& [text, name, what, way] : known) {
    const std::string told = error(text, name);
    EXPECT_TRUE(told.starts_with(name + ": this is " + what)) << told;
    EXPECT_NE(told.find(way), std::string::npos) << told;
  }
}

}  // namespace
}  // namespace sunder::io
