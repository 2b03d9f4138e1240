#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh_check_test.h>
#include <sunder/io/mesh/mesh_write.h>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

namespace sunder::io {
namespace {

constexpr MeshFormat all_formats[] = {MeshFormat::obj, MeshFormat::stl, MeshFormat::ply, MeshFormat::off};

std::string text_of(const Mesh& mesh, MeshFormat format) {
  return to_text(format, mesh.vertices, mesh.polygon_begin, mesh.polygon_vertices);
}

// Any finite double but -0, all exponents alike.
double any_double(std::mt19937_64& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) return value + 0.0;
  }
}

Mesh random_mesh(std::mt19937_64& random, std::size_t vertices, std::size_t polygons, std::size_t longest) {
  Mesh mesh;
  for (std::size_t i = 0; i < vertices; ++i) {
    mesh.vertices.push_back({any_double(random), any_double(random), any_double(random)});
  }
  for (std::size_t p = 0; p < polygons; ++p) {
    const std::size_t corners = 3 + random() % (longest - 2);
    for (std::size_t i = 0; i < corners; ++i) {
      mesh.polygon_vertices.push_back(static_cast<std::uint32_t>(random() % vertices));
    }
    mesh.polygon_begin.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
  }
  return mesh;
}

TEST(MeshWrite, ReadsBackTheSame) {
  std::mt19937_64 random(20240517);
  for (int round = 0; round < 300; ++round) {
    const Mesh mesh = random_mesh(random, 1 + random() % 30, random() % 20, round % 10 == 0 ? 400 : 6);
    for (const MeshFormat format : {MeshFormat::obj, MeshFormat::ply, MeshFormat::off}) {
      const std::string text = text_of(mesh, format);
      EXPECT_EQ(mesh_format(text, ""), format);
      const Mesh back = parse_mesh(text, "text", format);
      EXPECT_EQ(back.vertices, mesh.vertices);
      EXPECT_EQ(back.polygon_begin, mesh.polygon_begin);
      EXPECT_EQ(back.polygon_vertices, mesh.polygon_vertices);
      EXPECT_EQ(text_of(back, format), text);
    }
  }
}

TEST(MeshWrite, StlReadsBackTheSameTriangles) {
  std::mt19937_64 random(20240518);
  for (int round = 0; round < 300; ++round) {
    const Mesh mesh = random_mesh(random, 1 + random() % 30, 1 + random() % 20, 7);
    const std::string text = text_of(mesh, MeshFormat::stl);
    const Mesh back = parse_mesh(text, "text", MeshFormat::stl);
    EXPECT_EQ(mesh_fault(back), "");
    std::uint32_t triangle = 0;
    for (std::uint32_t p = 0; p < mesh.polygon_count(); ++p) {
      const std::uint32_t* cycle = mesh.polygon_vertices.data() + mesh.polygon_begin[p];
      for (std::uint32_t i = 1; i + 1 < mesh.polygon_begin[p + 1] - mesh.polygon_begin[p]; ++i, ++triangle) {
        const std::uint32_t* read = back.polygon_vertices.data() + 3 * triangle;
        EXPECT_EQ(back.vertices[read[0]], mesh.vertices[cycle[0]]);
        EXPECT_EQ(back.vertices[read[1]], mesh.vertices[cycle[i]]);
        EXPECT_EQ(back.vertices[read[2]], mesh.vertices[cycle[i + 1]]);
      }
    }
    EXPECT_EQ(back.polygon_count(), triangle);
  }
}

TEST(MeshWrite, WritesWhatOneExpects) {
  const std::vector<Point3> points = {{0, 0, 0}, {2, 0, 0}, {0, 0.1, 0}};
  const std::vector<std::uint32_t> begin = {0, 3}, corners = {0, 1, 2};
  EXPECT_EQ(to_obj(points, begin, corners), "v 0 0 0\nv 2 0 0\nv 0 0.1 0\nf 1 2 3\n");
  EXPECT_EQ(to_off(points, begin, corners), "OFF\n3 1 0\n0 0 0\n2 0 0\n0 0.1 0\n3 0 1 2\n");
  EXPECT_EQ(to_ply(points, begin, corners),
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n2 0 0\n0 0.1 0\n3 0 1 2\n");
  EXPECT_EQ(to_stl(points, begin, corners),
            "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 0.1 0\nendloop\nendfacet\n"
            "endsolid\n");
}

TEST(MeshWrite, WritesPointSetsButNotAsStl) {
  const std::vector<Point3> points = {{1, 2, 3}};
  const std::vector<std::uint32_t> begin = {0}, none;
  for (const MeshFormat format : all_formats) {
    if (format == MeshFormat::stl) {
      EXPECT_THROW(to_text(format, points, begin, none), Error);
      continue;
    }
    EXPECT_EQ(parse_mesh(to_text(format, points, begin, none), "text", format).vertices, points);
    EXPECT_EQ(to_text(format, points, none, none), to_text(format, points, begin, none)) << "no polygon_begin at all";
  }
}

}  // namespace
}  // namespace sunder::io
