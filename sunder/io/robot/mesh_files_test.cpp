#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh.h>
#include <sunder/io/mesh/mesh_parse_test.h>
#include <sunder/io/robot/urdf.h>
#include <sunder/io/text/file.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace sunder::io {
namespace {

namespace fs = std::filesystem;

using tests::cases;

// The rows of a table, without comments.
std::vector<std::vector<std::string>> table(const fs::path& path) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(read_file(path));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::vector<std::string>& row = rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, '\t');) row.push_back(field);
  }
  return rows;
}

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  names.erase("EXPECTED.tsv");
  names.erase("README.md");
  return names;
}

std::vector<Point3> sorted(std::vector<Point3> points) {
  std::sort(points.begin(), points.end(),
            [](const Point3& a, const Point3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
  return points;
}

// The corners of a polygon as points, for comparison of meshes that number their vertices differently.
std::vector<Point3> corners(const Mesh& mesh, std::uint32_t p) {
  std::vector<Point3> points;
  for (std::uint32_t i = mesh.polygon_begin[p]; i < mesh.polygon_begin[p + 1]; ++i) {
    points.push_back(mesh.vertices[mesh.polygon_vertices[i]]);
  }
  return points;
}

TEST(Mesh, ReadsEveryCase) {
  const auto rows = table(cases / "mesh" / "EXPECTED.tsv");
  ASSERT_GE(rows.size(), 30u);
  std::set<std::string> seen;
  for (const auto& row : rows) {
    ASSERT_EQ(row.size(), 6u);
    SCOPED_TRACE(row[0]);
    seen.insert(row[0]);
    const Mesh mesh = read_mesh(cases / "mesh" / row[0]);
    EXPECT_EQ(mesh_fault(mesh), "");
    EXPECT_EQ(std::to_string(mesh.vertices.size()), row[1]);
    EXPECT_EQ(std::to_string(mesh.polygon_count()), row[2]);
    EXPECT_EQ(std::to_string(mesh.parts.size()), row[3]);
    EXPECT_EQ(mesh.name, row[4]);
    EXPECT_EQ(mesh.format, row[5]);
  }
  std::set<std::string> found = files_in(cases / "mesh");
  std::erase_if(found, [](const std::string& name) { return name.ends_with(".urdf") || name.ends_with(".bin"); });
  EXPECT_EQ(seen, found) << "EXPECTED.tsv and the folder differ";
}

TEST(Mesh, SameShapeInEveryFormat) {
  for (const std::string shape : {"tetrahedron", "cube"}) {
    const Mesh first = read_mesh(cases / "mesh" / (shape + ".off"));
    int compared = 0;
    for (const std::string& name : files_in(cases / "mesh")) {
      if (!name.starts_with(shape)) continue;
      SCOPED_TRACE(name);
      const Mesh mesh = read_mesh(cases / "mesh" / name);
      EXPECT_EQ(sorted(mesh.vertices), sorted(first.vertices));
      if (mesh.polygon_count() == first.polygon_count()) {
        for (std::uint32_t p = 0; p < mesh.polygon_count(); ++p) EXPECT_EQ(corners(mesh, p), corners(first, p));
      }
      ++compared;
    }
    EXPECT_EQ(compared, 12);
  }
}

TEST(Mesh, RefusesEveryBrokenFile) {
  const auto rows = table(cases / "broken" / "EXPECTED.tsv");
  ASSERT_GE(rows.size(), 180u);
  std::set<std::string> seen;
  for (const auto& row : rows) {
    ASSERT_EQ(row.size(), 2u);
    const auto& [name, fragment] = std::tie(row[0], row[1]);
    SCOPED_TRACE(name);
    EXPECT_TRUE(seen.insert(name).second) << "twice in the table";
    const fs::path path = cases / "broken" / name;
    try {
      if (path.extension() == ".urdf") {
        read_urdf(path);
      } else {
        read_mesh(path);
      }
      ADD_FAILURE() << "was read";
    } catch (const Error& error) {
      const std::string text = error.what();
      EXPECT_EQ(error.code(), ErrorCode::bad_file);
      EXPECT_TRUE(text.starts_with(path.string() + ":")) << text;
      EXPECT_NE(text.find(fragment), std::string::npos) << "expected: " << fragment << "\nmessage: " << text;
      EXPECT_TRUE(std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20; })) << text;
      EXPECT_LT(text.size(), path.string().size() + 300) << text;
    }
  }
  EXPECT_EQ(seen, files_in(cases / "broken")) << "EXPECTED.tsv and the folder differ";
}

// Any beginning of a file is a mesh or an error of one line, never a crash; and mostly an error.
TEST(Mesh, SurvivesTruncationAnywhere) {
  int refused = 0, all = 0;
  for (const std::string& name : files_in(cases / "mesh")) {
    if (name.ends_with(".urdf") || name.ends_with(".bin")) continue;
    const std::string bytes = read_file(cases / "mesh" / name);
    const MeshFormat format = mesh_format(bytes, name);
    for (std::size_t size = 0; size < bytes.size(); ++size, ++all) {
      try {
        EXPECT_EQ(mesh_fault(parse_mesh(std::string_view(bytes).substr(0, size), name, format)), "");
      } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, all / 2);
}

TEST(MeshFormats, AreFoundByContentFirst) {
  const auto bytes_of = [](const char* name) { return read_file(cases / "mesh" / name); };
  EXPECT_EQ(mesh_format(bytes_of("cube.off"), "x.obj"), MeshFormat::off);
  EXPECT_EQ(mesh_format(bytes_of("cube.ply"), "x.stl"), MeshFormat::ply);
  EXPECT_EQ(mesh_format(bytes_of("cube.stl"), "x.ply"), MeshFormat::stl);
  EXPECT_EQ(mesh_format(bytes_of("cube_binary.stl"), "x"), MeshFormat::stl);
  EXPECT_EQ(mesh_format(bytes_of("tetrahedron_binary.stl"), "x.off"), MeshFormat::stl);
  EXPECT_EQ(mesh_format(bytes_of("cube.obj"), "x"), MeshFormat::obj);
  EXPECT_EQ(mesh_format(bytes_of("cube.dae"), "x.obj"), MeshFormat::collada);
  EXPECT_EQ(mesh_format(bytes_of("cube.gltf"), "x"), MeshFormat::gltf);
  EXPECT_EQ(mesh_format(bytes_of("cube.glb"), "x.stl"), MeshFormat::gltf);
  EXPECT_EQ(mesh_format(bytes_of("cube.wrl"), "x.ply"), MeshFormat::vrml);
  EXPECT_EQ(mesh_format("l 1 2\n", "x.OBJ"), MeshFormat::obj);
  EXPECT_EQ(mesh_format("\xef\xbb\xbfOFF\n", ""), MeshFormat::off);
  EXPECT_EQ(mesh_format_of_name("a/b.c/hull.PlY"), MeshFormat::ply);
  EXPECT_THROW(mesh_format_of_name("hull.txt"), Error);
  EXPECT_THROW(mesh_format_of_name("obj"), Error);
  EXPECT_THROW(mesh_format_of_name("hull.dae"), Error) << "only read";
}

TEST(MeshObj, KeepsFullPrecisionAndDropsTheSignOfZero) {
  const Mesh mesh = checked_mesh("v 0.1 -0 1e-320\nv -0.0 1.7976931348623157e308 +3\n", MeshFormat::obj);
  EXPECT_EQ(mesh.vertices[0], (Point3{0.1, 0, 1e-320}));
  EXPECT_EQ(mesh.vertices[1], (Point3{0, std::numeric_limits<double>::max(), 3}));
  EXPECT_FALSE(std::signbit(mesh.vertices[0].y));
  EXPECT_FALSE(std::signbit(mesh.vertices[1].x));
}

TEST(MeshObj, AllowsCornersThatComeLater) {
  const Mesh mesh = checked_mesh("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0", MeshFormat::obj);
  EXPECT_EQ(mesh.polygon_vertices, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(mesh_error("v 0 0 0\nf 1 2 9\nf 1 2 3\nf 1 2 9\nv 0 0 0\n", MeshFormat::obj),
            "test:2: this face names vertex 9, but there are 2 in all; export the mesh again");
}

TEST(MeshObj, CountsBackwardsFromWhereItIs) {
  const Mesh mesh =
      checked_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1/2 -2//-7 -4/1/1\n", MeshFormat::obj);
  EXPECT_EQ(mesh.polygon_vertices, (std::vector<std::uint32_t>{0, 1, 2, 3, 2, 0}));
}

TEST(MeshObj, GroupsArePartsWhereAskedFor) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng left all\nf 1 2 3\ng right all\nf 1 2 4\nf 1 3 4\n";
  EXPECT_EQ(checked_mesh(text, MeshFormat::obj).parts.size(), 1u);
  const Mesh mesh = parse_mesh(text, "test", MeshFormat::obj, PartsOf::objects_and_groups);
  ASSERT_EQ(mesh.parts.size(), 2u);
  EXPECT_EQ(mesh.parts[0].name, "left");
  EXPECT_EQ(mesh.parts[1].name, "right");
  EXPECT_EQ(mesh.parts[1].first, 1u);
}

TEST(MeshObj, DoesNotContinueComments) {
  const Mesh mesh = checked_mesh("# C:\\folder\\\nv 0 0 0 # end \\\nv 1 1 1\n", MeshFormat::obj);
  EXPECT_EQ(mesh.vertices.size(), 2u);
}

TEST(MeshStl, JoinsEqualVerticesInTheirOrder) {
  const Mesh mesh = checked_mesh(
      "solid\nfacet normal nan -nan(ind) inf outer loop vertex 3 0 0 vertex 0 -0 0 vertex 1 0 0 endloop endfacet\n"
      "facet normal 0 0 1e999\nouter loop\nvertex -0 0 0\nvertex 3 0 0\nvertex 2 0 0\nendloop\nendfacet\nendsolid",
      MeshFormat::stl);
  EXPECT_EQ(mesh.vertices, (std::vector<Point3>{{3, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(mesh.polygon_vertices, (std::vector<std::uint32_t>{0, 1, 2, 1, 0, 3}));
}

TEST(MeshStl, KeepsDegenerateTriangles) {
  const Mesh mesh = checked_mesh(
      "solid\nfacet normal 0 0 0 outer loop vertex 1 2 3 vertex 1 2 3 vertex 1 2 3 endloop endfacet endsolid",
      MeshFormat::stl);
  EXPECT_EQ(mesh.vertices.size(), 1u);
  EXPECT_EQ(mesh.polygon_vertices, (std::vector<std::uint32_t>{0, 0, 0}));
}

TEST(MeshOff, ReadsHeadersOfEveryKind) {
  EXPECT_EQ(checked_mesh("OFF 1 0\n1 2 3", MeshFormat::off).vertices.size(), 1u);
  EXPECT_EQ(checked_mesh("# c\n\n  OFF # c\n# c\n1 0 0 # c\n\n1 2 3\n", MeshFormat::off).vertices.size(), 1u);
  EXPECT_EQ(checked_mesh("STCNOFF\n1 0 0\n1 2 3 0 0 1 255 255 255 0.5 0.5\n", MeshFormat::off).vertices.size(), 1u);
  EXPECT_NE(mesh_error("nOFF\n3\n1 0 0\n1 2 3\n", MeshFormat::off).find("not of space"), std::string::npos);
  EXPECT_NE(mesh_error("OFFSET\n", MeshFormat::off).find("expected 'OFF'"), std::string::npos);
}

TEST(MeshPly, ReadsIntegerCoordinatesOfEveryType) {
  const std::string header =
      "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty char x\nproperty ushort y\n"
      "property uint32 z\nend_header\n";
  const Mesh mesh = checked_mesh(header + std::string("\xff\xff\xfe\xff\xff\xff\xfd", 7), MeshFormat::ply);
  EXPECT_EQ(mesh.vertices[0], (Point3{-1, 65534, 4294967293}));
}

TEST(MeshPly, AllowsFacesBeforeVerticesAndElementsWithoutProperties) {
  const Mesh mesh = checked_mesh(
      "ply\rformat ascii 1.0\relement face 1\rproperty list int int vertex_indices\r"
      "element nothing 4000000000000000000\relement vertex 3\rproperty float z\rproperty float y\r"
      "property float x\rend_header\r3 0 1 2\r1 2 3\r4 5 6\r7 8 9\r",
      MeshFormat::ply);
  EXPECT_EQ(mesh.vertices[0], (Point3{3, 2, 1}));
  EXPECT_EQ(mesh.polygon_vertices, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Mesh, LyingHeadersReserveNothing) {
  const std::string counts = "9000000000000000000";
  EXPECT_NE(mesh_error("OFF\n" + counts + " 0 0\n0 0 0\n", MeshFormat::off).find("ends after 1 of"), std::string::npos);
  EXPECT_NE(mesh_error("ply\nformat ascii 1.0\nelement vertex " + counts +
                           "\nproperty int x\nproperty int y\n"
                           "property int z\nend_header\n0 0 0\n",
                       MeshFormat::ply)
                .find("ends after 1 of"),
            std::string::npos);
  EXPECT_NE(mesh_error("OFF\n1 1 0\n0 0 0\n4294967296 0 0 0\n", MeshFormat::off).find("has 3 of 4294967296 corners"),
            std::string::npos);
}

TEST(Mesh, UsedVerticesAreThoseOfPolygons) {
  const Mesh parts = read_mesh(cases / "mesh" / "two_parts.obj");
  EXPECT_EQ(used_vertices(parts), (std::vector<std::uint32_t>{1, 2, 3, 4, 5}));
  EXPECT_EQ(used_vertices(read_mesh(cases / "mesh" / "points.obj")).size(), 3u);
}

TEST(Mesh, SplitsParts) {
  const std::vector<Mesh> parts = split_parts(read_mesh(cases / "mesh" / "two_parts.obj"));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(mesh_fault(parts[0]) + mesh_fault(parts[1]), "");
  EXPECT_EQ(parts[0].name, "near");
  EXPECT_EQ(parts[0].vertices, read_mesh(cases / "mesh" / "tetrahedron.obj").vertices);
  EXPECT_EQ(parts[1].name, "shared");
  EXPECT_EQ(parts[1].vertices, (std::vector<Point3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}}));
  EXPECT_EQ(parts[1].polygon_vertices, (std::vector<std::uint32_t>{0, 2, 3, 3, 1, 0}));

  const std::vector<Mesh> solids = split_parts(read_mesh(cases / "mesh" / "two_solids.stl"));
  ASSERT_EQ(solids.size(), 2u);
  EXPECT_EQ(solids[1].name, "second one");
  EXPECT_EQ(solids[1].vertices.size(), 4u);
  EXPECT_EQ(solids[1].polygon_count(), 4u);

  const std::vector<Mesh> points =
      split_parts(checked_mesh("v 0 0 0\no a\no b\nv 1 1 1\nv 2 2 2\no c\n", MeshFormat::obj));
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].name, "");
  EXPECT_EQ(points[1].name, "b");
  EXPECT_EQ(points[1].vertices.size(), 2u);
}

TEST(Mesh, ReadsTheLinksOfThePanda) {
  int meshes = 0;
  for (const auto& entry : fs::directory_iterator(cases / "panda" / "meshes" / "collision")) {
    const Mesh mesh = read_mesh(entry.path());
    EXPECT_EQ(mesh_fault(mesh), "");
    EXPECT_EQ(mesh.format, "STL (binary)");
    EXPECT_EQ(mesh.vertices.size(), mesh.polygon_count() / 2 + 2) << "Euler: a closed surface without handles";
    ++meshes;
  }
  EXPECT_EQ(meshes, 10);
}

TEST(Mesh, FormatsAreToldByContent) {
  EXPECT_EQ(mesh_format_of_content("ply\nformat ascii 1.0\n"), MeshFormat::ply);
  EXPECT_EQ(mesh_format_of_content("OFF\n0 0 0\n"), MeshFormat::off);
  EXPECT_EQ(mesh_format_of_content("solid cube\n"), MeshFormat::stl);
  EXPECT_EQ(mesh_format_of_content("# a cube\nv 0 0 0\n"), MeshFormat::obj);
  for (const char* other :
       {"", "0,0,1,1\n", "POLYGON ((0 0, 1 0, 0 1, 0 0))\n", "{\"type\": \"Feature\"}", "<robot/>"}) {
    EXPECT_EQ(mesh_format_of_content(other), std::nullopt) << other;
  }
}

}  // namespace
}  // namespace sunder::io
