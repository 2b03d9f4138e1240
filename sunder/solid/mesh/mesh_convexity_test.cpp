#include <sunder/base/random.h>
#include <sunder/solid/mesh/face_mesh_test.h>
#include <sunder/solid/mesh/mesh_convexity.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace sunder::solid {
namespace {

using DefectKind = MeshDefect::Kind;

MeshDefect defect_of(const FaceMesh& mesh) { return asked_of(mesh, find_mesh_defect); }

DefectKind kind_of(const FaceMesh& mesh) { return defect_of(mesh).kind; }

// Faces outwards: x = 0, x = 1, y = 0, y = 1, z = 0, z = 1.
FaceMesh cube_mesh() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
          {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
}

FaceMesh triangulated(const FaceMesh& mesh) {
  FaceMesh out{mesh.vertices, {}};
  for (const auto& face : mesh.faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) out.faces.push_back({face[0], face[i], face[i + 1]});
  }
  return out;
}

FaceMesh inside_out(FaceMesh mesh) {
  for (auto& face : mesh.faces) std::reverse(face.begin(), face.end());
  return mesh;
}

// Every triangle in four, by the middles of its edges (exact for small integers).
FaceMesh refined(const FaceMesh& mesh) {
  FaceMesh out{mesh.vertices, {}};
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const Point3 &p = mesh.vertices[a], &q = mesh.vertices[b];
    const Point3 m{(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
    const auto found = std::find(out.vertices.begin(), out.vertices.end(), m);
    if (found == out.vertices.end()) out.vertices.push_back(m);
    return static_cast<std::uint32_t>(std::find(out.vertices.begin(), out.vertices.end(), m) - out.vertices.begin());
  };
  for (const auto& f : mesh.faces) {
    const std::uint32_t a = middle(f[0], f[1]), b = middle(f[1], f[2]), c = middle(f[2], f[0]);
    out.faces.insert(out.faces.end(), {{f[0], a, c}, {f[1], b, a}, {f[2], c, b}, {a, b, c}});
  }
  return out;
}

TEST(MeshConvexity, CubesInManyForms) {
  EXPECT_EQ(kind_of(cube_mesh()), DefectKind::none);
  EXPECT_EQ(kind_of(triangulated(cube_mesh())), DefectKind::none);
  EXPECT_EQ(kind_of(inside_out(cube_mesh())), DefectKind::none);
  EXPECT_EQ(kind_of(refined(refined(triangulated(cube_mesh())))),
            DefectKind::none);  // with vertices within facets and edges

  FaceMesh soup = triangulated(cube_mesh());  // a vertex for each corner, as in an STL that was not joined
  FaceMesh apart;
  for (auto& face : soup.faces) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t v : face) {
      corners.push_back(static_cast<std::uint32_t>(apart.vertices.size()));
      apart.vertices.push_back(soup.vertices[v]);
    }
    apart.faces.push_back(corners);
  }
  EXPECT_EQ(kind_of(apart), DefectKind::none);

  FaceMesh turned = cube_mesh();  // one face the wrong way round: it still bounds the cube
  std::reverse(turned.faces[3].begin(), turned.faces[3].end());
  EXPECT_EQ(kind_of(turned), DefectKind::none);

  FaceMesh repeated = cube_mesh();  // corners repeated, and faces without area
  repeated.faces[0] = {0, 0, 4, 6, 6, 2, 2};
  repeated.faces.push_back({0, 1, 0});
  repeated.faces.push_back({7, 7, 7});
  EXPECT_EQ(kind_of(repeated), DefectKind::none);
}

TEST(MeshConvexity, FacesThatAreNotConvex) {
  FaceMesh mesh = cube_mesh();  // the face z = 1 as an L and a square
  mesh.vertices.insert(mesh.vertices.end(), {{0.5, 0, 1}, {0.5, 0.5, 1}, {1, 0.5, 1}});
  mesh.faces[5] = {4, 8, 9, 10, 7, 6};
  mesh.faces.push_back({8, 5, 10, 9});
  mesh.faces[1] = {1, 3, 7, 10, 5};
  mesh.faces[2] = {0, 1, 5, 8, 4};
  EXPECT_EQ(kind_of(mesh), DefectKind::none);
  mesh.faces.pop_back();
  EXPECT_EQ(kind_of(mesh), DefectKind::open_edge);
}

TEST(MeshConvexity, OpenAndDoubled) {
  FaceMesh mesh = cube_mesh();
  mesh.faces.erase(mesh.faces.begin() + 5);
  const MeshDefect open = defect_of(mesh);
  EXPECT_EQ(open.kind, DefectKind::open_edge);
  EXPECT_EQ(mesh.vertices[open.edge[0]].z, 1);
  EXPECT_EQ(mesh.vertices[open.edge[1]].z, 1);

  FaceMesh twice = cube_mesh();
  const FaceMesh once = cube_mesh();
  twice.faces.insert(twice.faces.end(), once.faces.begin(), once.faces.end());
  EXPECT_EQ(kind_of(twice), DefectKind::doubled);
  twice.faces.insert(twice.faces.end(), once.faces.begin(), once.faces.end());
  EXPECT_EQ(kind_of(twice), DefectKind::none);  // covered three times
}

TEST(MeshConvexity, BentFace) {
  FaceMesh mesh = cube_mesh();
  mesh.vertices[7].z = std::nextafter(1.0, 2.0);
  const MeshDefect defect = defect_of(mesh);
  ASSERT_EQ(defect.kind, DefectKind::bent_face);
  const auto& face = mesh.faces[defect.face];
  EXPECT_NE(std::find(face.begin(), face.end(), 7u), face.end());
  // Triangulated it is convex or not, by where the diagonals are: both happen.
  std::set<DefectKind> kinds;
  kinds.insert(kind_of(triangulated(mesh)));
  mesh.vertices[7].z = std::nextafter(1.0, 0.0);
  kinds.insert(kind_of(triangulated(mesh)));
  EXPECT_EQ(kinds, (std::set<DefectKind>{DefectKind::none, DefectKind::reflex_edge}));
}

TEST(MeshConvexity, ReflexEdgeIsNamed) {
  // An L, pulled up from z = 0 to z = 1: its inner edge is from (1, 1, 0) to (1, 1, 1).
  FaceMesh mesh;
  const std::vector<Point2> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (const double z : {0.0, 1.0}) {
    for (const Point2& p : outline) mesh.vertices.push_back({p.x, p.y, z});
  }
  mesh.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
  for (std::uint32_t i = 0; i < 6; ++i) mesh.faces.push_back({i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
  for (const FaceMesh& m : {mesh, inside_out(mesh)}) {
    const MeshDefect defect = defect_of(m);
    ASSERT_EQ(defect.kind, DefectKind::reflex_edge);
    EXPECT_EQ(defect.edge, (std::array<std::uint32_t, 2>{3, 9}));
  }
}

TEST(MeshConvexity, DentByOneStep) {
  // The middle of the face z = 1 pressed in, or pulled out, by the least possible.
  for (const double z : {std::nextafter(1.0, 0.0), 1.0, std::nextafter(1.0, 2.0)}) {
    FaceMesh mesh = cube_mesh();
    mesh.vertices.push_back({0.5, 0.5, z});
    mesh.faces[5] = {4, 5, 8};
    mesh.faces.insert(mesh.faces.end(), {{5, 7, 8}, {7, 6, 8}, {6, 4, 8}});
    const MeshDefect defect = defect_of(mesh);
    EXPECT_EQ(defect.kind, z < 1 ? DefectKind::reflex_edge : DefectKind::none) << z;
    if (z < 1) {
      EXPECT_EQ(defect.edge[1], 8u);
    }
  }
}

TEST(MeshConvexity, ShellsInside) {
  FaceMesh mesh = cube_mesh();
  const FaceMesh small = cube_mesh();
  for (const Point3& p : small.vertices) {
    mesh.vertices.push_back({0.25 + p.x / 2, 0.25 + p.y / 2, 0.25 + p.z / 2});
  }
  for (auto face : small.faces) {
    for (std::uint32_t& v : face) v += 8;
    mesh.faces.push_back(face);
  }
  const MeshDefect defect = defect_of(mesh);
  EXPECT_EQ(defect.kind, DefectKind::inner_face);
  EXPECT_GE(defect.face, 6u);
}

TEST(MeshConvexity, FlatAndThin) {
  FaceMesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0, 0}}, {{0, 4, 1, 2, 3}}};
  EXPECT_EQ(kind_of(square), DefectKind::none);
  square.faces = {{0, 4, 3}, {4, 1, 2}, {4, 2, 3}};
  EXPECT_EQ(kind_of(square), DefectKind::none);
  square.faces.pop_back();
  EXPECT_EQ(kind_of(square), DefectKind::open_edge);
  FaceMesh dented{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}}, {{0, 1, 2, 3}}};
  EXPECT_EQ(kind_of(dented), DefectKind::none);  // (1, 1, 0) is on the edge from (2, 2, 0) to (0, 0, 0)
  dented.vertices[3] = {1.25, 1, 0};
  EXPECT_EQ(kind_of(dented), DefectKind::open_edge);
  const FaceMesh line{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}};
  EXPECT_EQ(kind_of(line), DefectKind::thin);
}

// The hull's own facets, and those fanned, are convex; with one vertex pulled inside they are not.
TEST(MeshConvexity, RandomHulls) {
  Random random(7);
  int convex = 0, bent = 0, reflex = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<Point3> points(4 + random.below(40));
    const bool lattice = random.below(2) == 0;
    for (Point3& p : points) {
      p = tests::in_cube(random);
      if (lattice) p = {std::round(3 * p.x), std::round(3 * p.y), std::round(3 * p.z)};
    }
    const ConvexPolyhedron hull(points);
    if (hull.dimension() < 3) continue;
    FaceMesh mesh{{hull.vertices().begin(), hull.vertices().end()}, {}};
    for (std::uint32_t f = 0; f < hull.facet_count(); ++f) {
      mesh.faces.emplace_back(hull.facet(f).begin(), hull.facet(f).end());
    }
    ASSERT_EQ(kind_of(mesh), DefectKind::none);
    ASSERT_EQ(kind_of(triangulated(mesh)), DefectKind::none);
    ++convex;

    FaceMesh fan = triangulated(mesh);  // a vertex in the middle of a facet's first triangle, pulled towards the inside
    const auto first = fan.faces.front();
    Point3 inside;
    for (const Point3& p : mesh.vertices) inside = {inside.x + p.x, inside.y + p.y, inside.z + p.z};
    const double n = static_cast<double>(mesh.vertices.size());
    const auto mix = [&](double a, double b, double c, double i) { return (a + b + c) / 3 * 0.7 + i / n * 0.3; };
    const Point3 &a = fan.vertices[first[0]], &b = fan.vertices[first[1]], &c = fan.vertices[first[2]];
    const auto v = static_cast<std::uint32_t>(fan.vertices.size());
    fan.vertices.push_back({mix(a.x, b.x, c.x, inside.x), mix(a.y, b.y, c.y, inside.y), mix(a.z, b.z, c.z, inside.z)});
    fan.faces.front() = {first[0], first[1], v};
    fan.faces.push_back({first[1], first[2], v});
    fan.faces.push_back({first[2], first[0], v});
    const MeshDefect defect = defect_of(fan);
    ASSERT_EQ(defect.kind, DefectKind::reflex_edge);
    ASSERT_EQ(defect.edge[1], v);
    ++reflex;

    FaceMesh broken = mesh;  // a face of four corners or more, one of them moved
    for (const auto& face : mesh.faces) {
      if (face.size() < 4) continue;
      broken.vertices[face[1]].x += 1e-9;
      const DefectKind kind = kind_of(broken);
      bent += kind == DefectKind::bent_face;
      break;
    }
  }
  EXPECT_GT(convex, 200);
  EXPECT_GT(reflex, 200);
  EXPECT_GT(bent, 50);
}

}  // namespace
}  // namespace sunder::solid
