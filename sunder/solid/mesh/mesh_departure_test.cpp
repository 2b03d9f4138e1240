// By known depths and volumes, and against a brute force in another form.
#include <sunder/base/random.h>
#include <sunder/solid/mesh/face_mesh_test.h>
#include <sunder/solid/mesh/mesh_departure.h>

#include <gtest/gtest.h>
#include <tests/support/scale.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace sunder::solid {
namespace {

MeshDeparture departure_of(const FaceMesh& mesh) { return asked_of(mesh, mesh_departure); }

// A prism over a polygon of the plane, counter-clockwise, from z = 0 to z = height; its caps are not cut up.
FaceMesh prism(const std::vector<Point2>& base, double height) {
  FaceMesh mesh;
  const auto n = static_cast<std::uint32_t>(base.size());
  for (const double z : {0.0, height}) {
    for (const Point2& p : base) mesh.vertices.push_back({p.x, p.y, z});
  }
  std::vector<std::uint32_t> bottom, top;
  for (std::uint32_t i = 0; i < n; ++i) {
    bottom.push_back(n - 1 - i);
    top.push_back(n + i);
    const std::uint32_t next = (i + 1) % n;
    mesh.faces.push_back({i, next, n + next, n + i});
  }
  mesh.faces.push_back(bottom);
  mesh.faces.push_back(top);
  return mesh;
}

FaceMesh torus(double major, double minor, std::uint32_t around, std::uint32_t across) {
  FaceMesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double a = 2 * M_PI * i / around, b = 2 * M_PI * j / across, r = major + minor * std::cos(b);
      mesh.vertices.push_back({r * std::cos(a), r * std::sin(a), minor * std::sin(b)});
      const auto at = [&](std::uint32_t k, std::uint32_t l) { return (k % around) * across + l % across; };
      mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

TEST(MeshDeparture, AnEdgeInANotch) {
  // An L: the reflex edge is deepest where it is farthest from both the cut off corner and the ends. The ends are
  // farther than the plane x + y = 3 is, sqrt(1/2), from the middle on.
  const MeshDeparture l = departure_of(prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 4));
  EXPECT_NEAR(l.depth, std::sqrt(0.5), 1e-6);
  EXPECT_FALSE(l.at_least);
  ASSERT_TRUE(l.volume.has_value());
  EXPECT_DOUBLE_EQ(l.volume->hull, 14);
  EXPECT_DOUBLE_EQ(l.volume->missing, 2);
  // A short one: the ends are nearer.
  EXPECT_NEAR(departure_of(prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1)).depth, 0.5, 1e-6);
}

TEST(MeshDeparture, ABentLastBitAndATorusDiffer) {
  // The corner (1, 1, 1) of a cube, one unit in the last place higher; the top is cut along the other diagonal.
  const double up = std::nextafter(1.0, 2.0);
  FaceMesh bent{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, up}, {0, 1, 1}},
                {{0, 3, 2, 1}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 7}, {5, 6, 7}}};
  const MeshDeparture last_bit = departure_of(bent);
  EXPECT_NEAR(last_bit.depth, 0x1p-53, 0x1p-60);
  ASSERT_TRUE(last_bit.volume.has_value());
  EXPECT_NEAR(last_bit.volume->missing, 0x1p-52 / 6, 0x1p-60);

  const MeshDeparture ring = departure_of(torus(2, 0.5, 64, 32));
  EXPECT_NEAR(ring.depth, 0.5, 1e-3);  // of the innermost points, below the flat top
  ASSERT_TRUE(ring.volume.has_value());
  EXPECT_NEAR(ring.volume->missing / ring.volume->hull, 0.452, 0.01);
}

TEST(MeshDeparture, OpenOrInconsistentMeshesHaveNoVolume) {
  FaceMesh open = prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
  open.faces.pop_back();
  EXPECT_EQ(departure_of(open).depth, 0);
  EXPECT_FALSE(departure_of(open).volume.has_value());
  FaceMesh turned = prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
  std::reverse(turned.faces[0].begin(), turned.faces[0].end());
  EXPECT_FALSE(departure_of(turned).volume.has_value());
  FaceMesh twice = prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
  const auto once = twice.faces;
  twice.faces.insert(twice.faces.end(), once.begin(), once.end());
  EXPECT_FALSE(departure_of(twice).volume.has_value());
  // A corner in the middle, joined to all others, is as deep as can be.
  FaceMesh inner = prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
  inner.vertices.push_back({0.5, 0.5, 0.5});
  for (std::uint32_t i = 0; i < 4; ++i) inner.faces.push_back({i, (i + 1) % 4, 8});
  EXPECT_DOUBLE_EQ(departure_of(inner).depth, 0.5);
}

// Edges between random points and, often, points on the hull: the depth at many places of each edge, by planes through
// all triples of points that have all others on one side.
TEST(MeshDeparture, AsBruteForce) {
  const int count = tests::scaled_count(200);
  Random random(tests::chosen_seed(20261123));
  int deep = 0;
  for (int round = 0; round < count; ++round) {
    FaceMesh mesh;
    for (int i = 0; i < 9; ++i) {
      const auto entry = [&] {
        return random.below(3) == 0 ? std::round(random.uniform(-1, 1)) : random.uniform(-1, 1);
      };
      mesh.vertices.push_back({entry(), entry(), entry()});
    }
    for (std::uint32_t i = 0; i + 2 < 9; ++i) mesh.faces.push_back({i, i + 1, i + 2});
    const ConvexPolyhedron hull(mesh.vertices);
    if (hull.dimension() < 3) continue;
    const auto below = [&](const Point3& p) {
      double least = std::numeric_limits<double>::infinity();
      const auto& v = mesh.vertices;
      for (std::size_t i = 0; i < v.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          for (std::size_t k = 0; k < j; ++k) {
            const auto minus = [](const Point3& a, const Point3& b) { return Point3{a.x - b.x, a.y - b.y, a.z - b.z}; };
            const Point3 a = minus(v[j], v[i]), b = minus(v[k], v[i]);
            Point3 n{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
            const double size = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
            if (size < 1e-6) continue;
            const auto along = [&](const Point3& q) {
              const Point3 d = minus(q, v[i]);
              return (n.x * d.x + n.y * d.y + n.z * d.z) / size;
            };
            double low = 0, high = 0;
            for (const Point3& q : v) low = std::min(low, along(q)), high = std::max(high, along(q));
            if (low > -1e-12 || high < 1e-12) least = std::min(least, std::fabs(along(p)));
          }
        }
      }
      return least;
    };
    double depth = 0;
    for (const auto& face : mesh.faces) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Point3 &p = mesh.vertices[face[c]], &q = mesh.vertices[face[(c + 1) % 3]];
        constexpr int places = 8;
        for (int i = 0; i <= places; ++i) {
          const double t = static_cast<double>(i) / places;
          depth = std::max(depth, below({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)}));
        }
      }
    }
    const double found = departure_of(mesh).depth;
    EXPECT_GE(found, depth * (1 - 1e-5) - 1e-12) << round;
    // It is concave along an edge, so nowhere twice what it is at most at places in a row, the ends being two of them.
    EXPECT_LE(found, depth * 2 + 1e-12) << round;
    deep += found > 0.01 ? 1 : 0;
  }
  EXPECT_GT(deep, count / 2);
}

}  // namespace
}  // namespace sunder::solid
