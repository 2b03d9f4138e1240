#include <sunder/base/random.h>
#include <sunder/scene/mesh_convexity.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace sunder::scene {
namespace {

using solid::ConvexPolyhedron;
using Kind = MeshDefect::Kind;

struct Mesh {
  std::vector<Point3> vertices;
  std::vector<std::vector<std::uint32_t>> faces;
};

MeshDefect defect_of(const Mesh& mesh) {
  std::vector<std::uint32_t> begin{0}, corners;
  for (const auto& face : mesh.faces) {
    corners.insert(corners.end(), face.begin(), face.end());
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return find_mesh_defect({mesh.vertices, begin, corners}, ConvexPolyhedron(mesh.vertices));
}

Kind kind_of(const Mesh& mesh) { return defect_of(mesh).kind; }

// Faces outwards: x = 0, x = 1, y = 0, y = 1, z = 0, z = 1.
Mesh cube() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
          {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
}

Mesh triangulated(const Mesh& mesh) {
  Mesh out{mesh.vertices, {}};
  for (const auto& face : mesh.faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) out.faces.push_back({face[0], face[i], face[i + 1]});
  }
  return out;
}

Mesh inside_out(Mesh mesh) {
  for (auto& face : mesh.faces) std::reverse(face.begin(), face.end());
  return mesh;
}

// Every triangle in four, by the middles of its edges (exact for small integers).
Mesh refined(const Mesh& mesh) {
  Mesh out{mesh.vertices, {}};
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
  EXPECT_EQ(kind_of(cube()), Kind::none);
  EXPECT_EQ(kind_of(triangulated(cube())), Kind::none);
  EXPECT_EQ(kind_of(inside_out(cube())), Kind::none);
  EXPECT_EQ(kind_of(refined(refined(triangulated(cube())))), Kind::none);  // with vertices within facets and edges

  Mesh soup = triangulated(cube());  // a vertex for each corner, as in an STL that was not joined
  Mesh apart;
  for (auto& face : soup.faces) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t v : face) {
      corners.push_back(static_cast<std::uint32_t>(apart.vertices.size()));
      apart.vertices.push_back(soup.vertices[v]);
    }
    apart.faces.push_back(corners);
  }
  EXPECT_EQ(kind_of(apart), Kind::none);

  Mesh turned = cube();  // one face the wrong way round: it still bounds the cube
  std::reverse(turned.faces[3].begin(), turned.faces[3].end());
  EXPECT_EQ(kind_of(turned), Kind::none);

  Mesh repeated = cube();  // corners repeated, and faces without area
  repeated.faces[0] = {0, 0, 4, 6, 6, 2, 2};
  repeated.faces.push_back({0, 1, 0});
  repeated.faces.push_back({7, 7, 7});
  EXPECT_EQ(kind_of(repeated), Kind::none);
}

TEST(MeshConvexity, FacesThatAreNotConvex) {
  Mesh mesh = cube();  // the face z = 1 as an L and a square
  mesh.vertices.insert(mesh.vertices.end(), {{0.5, 0, 1}, {0.5, 0.5, 1}, {1, 0.5, 1}});
  mesh.faces[5] = {4, 8, 9, 10, 7, 6};
  mesh.faces.push_back({8, 5, 10, 9});
  mesh.faces[1] = {1, 3, 7, 10, 5};
  mesh.faces[2] = {0, 1, 5, 8, 4};
  EXPECT_EQ(kind_of(mesh), Kind::none);
  mesh.faces.pop_back();
  EXPECT_EQ(kind_of(mesh), Kind::open_edge);
}

TEST(MeshConvexity, OpenAndDoubled) {
  Mesh mesh = cube();
  mesh.faces.erase(mesh.faces.begin() + 5);
  const MeshDefect open = defect_of(mesh);
  EXPECT_EQ(open.kind, Kind::open_edge);
  EXPECT_EQ(mesh.vertices[open.edge[0]].z, 1);
  EXPECT_EQ(mesh.vertices[open.edge[1]].z, 1);

  Mesh twice = cube();
  const Mesh once = cube();
  twice.faces.insert(twice.faces.end(), once.faces.begin(), once.faces.end());
  EXPECT_EQ(kind_of(twice), Kind::doubled);
  twice.faces.insert(twice.faces.end(), once.faces.begin(), once.faces.end());
  EXPECT_EQ(kind_of(twice), Kind::none);  // covered three times
}

TEST(MeshConvexity, BentFace) {
  Mesh mesh = cube();
  mesh.vertices[7].z = std::nextafter(1.0, 2.0);
  const MeshDefect defect = defect_of(mesh);
  ASSERT_EQ(defect.kind, Kind::bent_face);
  const auto& face = mesh.faces[defect.face];
  EXPECT_NE(std::find(face.begin(), face.end(), 7u), face.end());
  // Triangulated it is convex or not, by where the diagonals are: both happen.
  std::set<Kind> kinds;
  kinds.insert(kind_of(triangulated(mesh)));
  mesh.vertices[7].z = std::nextafter(1.0, 0.0);
  kinds.insert(kind_of(triangulated(mesh)));
  EXPECT_EQ(kinds, (std::set<Kind>{Kind::none, Kind::reflex_edge}));
}

TEST(MeshConvexity, ReflexEdgeIsNamed) {
  // An L, pulled up from z = 0 to z = 1: its inner edge is from (1, 1, 0) to (1, 1, 1).
  Mesh mesh;
  const std::vector<Point2> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (const double z : {0.0, 1.0}) {
    for (const Point2& p : outline) mesh.vertices.push_back({p.x, p.y, z});
  }
  mesh.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
  for (std::uint32_t i = 0; i < 6; ++i) mesh.faces.push_back({i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
  for (const Mesh& m : {mesh, inside_out(mesh)}) {
    const MeshDefect defect = defect_of(m);
    ASSERT_EQ(defect.kind, Kind::reflex_edge);
    EXPECT_EQ(defect.edge, (std::array<std::uint32_t, 2>{3, 9}));
  }
}

TEST(MeshConvexity, DentByOneStep) {
  // The middle of the face z = 1 pressed in, or pulled out, by the least possible.
  for (const double z : {std::nextafter(1.0, 0.0), 1.0, std::nextafter(1.0, 2.0)}) {
    Mesh mesh = cube();
    mesh.vertices.push_back({0.5, 0.5, z});
    mesh.faces[5] = {4, 5, 8};
    mesh.faces.insert(mesh.faces.end(), {{5, 7, 8}, {7, 6, 8}, {6, 4, 8}});
    const MeshDefect defect = defect_of(mesh);
    EXPECT_EQ(defect.kind, z < 1 ? Kind::reflex_edge : Kind::none) << z;
    if (z < 1) {
      EXPECT_EQ(defect.edge[1], 8u);
    }
  }
}

TEST(MeshConvexity, ShellsInside) {
  Mesh mesh = cube();
  const Mesh small = cube();
  for (const Point3& p : small.vertices) {
    mesh.vertices.push_back({0.25 + p.x / 2, 0.25 + p.y / 2, 0.25 + p.z / 2});
  }
  for (auto face : small.faces) {
    for (std::uint32_t& v : face) v += 8;
    mesh.faces.push_back(face);
  }
  const MeshDefect defect = defect_of(mesh);
  EXPECT_EQ(defect.kind, Kind::inner_face);
  EXPECT_GE(defect.face, 6u);
}

TEST(MeshConvexity, FlatAndThin) {
  Mesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0, 0}}, {{0, 4, 1, 2, 3}}};
  EXPECT_EQ(kind_of(square), Kind::none);
  square.faces = {{0, 4, 3}, {4, 1, 2}, {4, 2, 3}};
  EXPECT_EQ(kind_of(square), Kind::none);
  square.faces.pop_back();
  EXPECT_EQ(kind_of(square), Kind::open_edge);
  Mesh dented{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}}, {{0, 1, 2, 3}}};
  EXPECT_EQ(kind_of(dented), Kind::none);  // (1, 1, 0) is on the edge from (2, 2, 0) to (0, 0, 0)
  dented.vertices[3] = {1.25, 1, 0};
  EXPECT_EQ(kind_of(dented), Kind::open_edge);
  const Mesh line{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}};
  EXPECT_EQ(kind_of(line), Kind::thin);
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
    Mesh mesh{{hull.vertices().begin(), hull.vertices().end()}, {}};
    for (std::uint32_t f = 0; f < hull.facet_count(); ++f) {
      mesh.faces.emplace_back(hull.facet(f).begin(), hull.facet(f).end());
    }
    ASSERT_EQ(kind_of(mesh), Kind::none);
    ASSERT_EQ(kind_of(triangulated(mesh)), Kind::none);
    ++convex;

    Mesh fan = triangulated(mesh);  // a vertex in the middle of a facet's first triangle, pulled towards the inside
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
    ASSERT_EQ(defect.kind, Kind::reflex_edge);
    ASSERT_EQ(defect.edge[1], v);
    ++reflex;

    Mesh broken = mesh;  // a face of four corners or more, one of them moved
    for (const auto& face : mesh.faces) {
      if (face.size() < 4) continue;
      broken.vertices[face[1]].x += 1e-9;
      const Kind kind = kind_of(broken);
      bent += kind == Kind::bent_face;
      break;
    }
  }
  EXPECT_GT(convex, 200);
  EXPECT_GT(reflex, 200);
  EXPECT_GT(bent, 50);
}

}  // namespace
}  // namespace sunder::scene
