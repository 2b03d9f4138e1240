// Holders of a mesh's points, against the scan of all facets, and each against determinants in whole numbers.
#include <sunder/solid/mesh/mesh_holders.h>

#include <sunder/base/random.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

namespace sunder::solid {
namespace {

using Whole = std::array<std::int64_t, 3>;

Whole whole(const Point3& p) {
  return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y), static_cast<std::int64_t>(p.z)};
}

std::int64_t determinant(const Whole& o, const Whole& p, const Whole& q, const Whole& r) {
  Whole a{}, b{}, c{};
  for (std::size_t k = 0; k < 3; ++k) {
    a[k] = p[k] - o[k];
    b[k] = q[k] - o[k];
    c[k] = r[k] - o[k];
  }
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// A flat holder gets a fourth corner beside its plane. The point must then be in the facet across from that corner.
void expect_held(const Mesh& mesh, const ConvexPolyhedron& body, const MeshHolders& found, const Point3& beside) {
  ASSERT_EQ(found.held.size(), mesh.points().size());
  for (std::size_t k = 0; k < found.held.size(); ++k) {
    const std::vector<std::uint32_t>& holder = found.holders[found.held[k]];
    const Whole p = whole(mesh.points()[k]);
    std::vector<Whole> corners;
    for (const std::uint32_t v : holder) corners.push_back(whole(body.vertices()[v]));
    if (corners.size() == 1) {
      EXPECT_TRUE(corners[0] == p);
      continue;
    }
    const bool is_flat = corners.size() == 3;
    if (is_flat) corners.push_back(whole(beside));
    ASSERT_EQ(corners.size(), 4u);
    const std::int64_t all = determinant(corners[0], corners[1], corners[2], corners[3]);
    ASSERT_TRUE(all != 0);
    for (std::size_t c = 0; c < 4; ++c) {
      std::vector<Whole> with = corners;
      with[c] = p;
      const std::int64_t part = determinant(with[0], with[1], with[2], with[3]);
      EXPECT_TRUE(all > 0 ? part >= 0 : part <= 0);
      EXPECT_TRUE(!is_flat || c < 3 || part == 0);
    }
  }
}

// Triangles of points anywhere, with whole coordinates up to a number; flat: in the plane x + y = z.
Mesh soup(Random& random, int most, bool is_flat) {
  std::vector<Point3> points;
  const auto n = 3 + 3 * random.below(20);
  for (std::uint64_t k = 0; k < n; ++k) {
    const auto at = [&] { return static_cast<double>(random.between(-most, most)); };
    const double x = at(), y = at(), z = at();
    points.push_back({x, y, is_flat ? x + y : z});
  }
  std::vector<std::uint32_t> begin{0}, corners;
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    corners.push_back(k);
    if (k % 3 == 2) begin.push_back(k + 1);
  }
  return Mesh(MeshView{points, begin, corners});
}

TEST(MeshHolders, AreAsByTheScan) {
  Random random(4301);
  int inner = 0;
  for (int i = 0; i < 300; ++i) {
    const bool is_flat = i % 3 == 0;
    const Mesh mesh = soup(random, i % 2 == 0 ? 3 : 1000, is_flat);  // of 3: many on facets and edges
    const ConvexPolyhedron body(mesh.points());
    if (body.dimension() < 2) continue;
    const auto found = mesh_holders(mesh, body), scanned = mesh_holders_by_scan(mesh, body);
    ASSERT_TRUE(found && scanned) << i;
    ASSERT_NO_FATAL_FAILURE(expect_held(mesh, body, *found, {0, 0, 1e6}));
    ASSERT_NO_FATAL_FAILURE(expect_held(mesh, body, *scanned, {0, 0, 1e6}));
    for (const auto& holder : found->holders) inner += holder.size() > 1;
  }
  EXPECT_GT(inner, 1000);
}

TEST(MeshHolders, ThereAreNoneWhereAPointIsOutside) {
  Random random(4302);
  for (int i = 0; i < 100; ++i) {
    const Mesh mesh = soup(random, 1000, i % 3 == 0);
    std::vector<Point3> points(mesh.points().begin(), mesh.points().end());
    const ConvexPolyhedron whole(points);
    std::erase(points, whole.vertices()[random.below(whole.vertices().size())]);
    const ConvexPolyhedron body(points);
    EXPECT_FALSE(mesh_holders(mesh, body));
    EXPECT_FALSE(mesh_holders_by_scan(mesh, body));
  }
}

TEST(MeshHolders, ASegmentHoldsItsEnds) {
  const std::vector<Point3> points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  const std::vector<std::uint32_t> begin{0, 3}, ends{0, 2, 2}, all{0, 1, 2};
  const ConvexPolyhedron body(points);
  const auto found = mesh_holders(Mesh(MeshView{points, begin, ends}), body);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->holders.size(), 2u);
  EXPECT_FALSE(mesh_holders(Mesh(MeshView{points, begin, all}), body));
}

}  // namespace
}  // namespace sunder::solid
