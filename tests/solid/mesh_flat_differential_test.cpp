// Meshes as they are, and lines, rays, segments and planes: down the tree against each triangle; what a line has in common with
// a mesh against points on it; and each proof by its checker.
#include <tests/support/mesh_proofs.h>
#include <tests/support/mesh_soups.h>
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/certificate/claims.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/mesh/mesh_flat_claims.h>
#include <sunder/solid/mesh/mesh_line.h>
#include <sunder/solid/mesh/mesh_plane.h>
#include <sunder/solid/mesh/mesh_point.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace sunder::tests {
namespace {

using solid::LineInMesh;
using solid::LineLike;
using solid::LinePart;
using solid::Mesh;
using solid::MeshLine;
using solid::MeshPlane;
using solid::Pose;

// Writes and checks what `state` states, and returns its verdict.
template <class AddBody, class State>
std::string proved_flat(const Mesh& mesh, const Pose& pose, const AddBody& add_body, const State& state) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_origin({});
  const solid::StatedMesh stated = solid::add_table(file, {"A", mesh, pose});
  PairClaims pairs(file);
  const std::uint32_t body = add_body(pairs);
  state(pairs, stated, body);
  pairs.end();
  return proved_verdicts(text);
}

std::string proved_plane(const Mesh& mesh, const Pose& pose, const solid::Plane& plane, const MeshPlane& found) {
  const auto in_file = solid::body_of(plane);
  if (!in_file.has_value()) return "the plane has no points";
  return proved_flat(
      mesh, pose, [&](PairClaims& pairs) { return pairs.add_body("plane", in_file->points, in_file->ways); },
      [&](PairClaims& pairs, const solid::StatedMesh& stated, std::uint32_t body) {
        add_claims(pairs, stated, body, plane, *in_file, found);
      });
}

LineLike some_line(Random& random, int i) {
  const auto whole = [&] { return static_cast<double>(random.between(-5, 5)); };
  const Point3 a{whole(), whole(), whole()};
  Point3 b{whole(), whole(), whole()};
  if (i % 3 == 1) b = {a.x + random.uniform(-1, 1), a.y + random.uniform(-1, 1), a.z + random.uniform(-1, 1)};
  if (a == b) b.x += 1;
  if (i % 4 == 0) return solid::Segment::between(a, b);
  if (i % 4 == 1) return solid::Ray::from(a, b);
  return solid::Line::through(a, b);
}

bool are_equal(const LineInMesh& p, const LineInMesh& q) {
  if (p.hits.size() != q.hits.size() || p.parts.size() != q.parts.size()) return false;
  for (std::size_t k = 0; k < p.hits.size(); ++k) {
    if (p.hits[k].triangle != q.hits[k].triangle || p.hits[k].first != q.hits[k].first ||
        p.hits[k].last != q.hits[k].last) {
      return false;
    }
  }
  for (std::size_t k = 0; k < p.parts.size(); ++k) {
    if (p.parts[k].first != q.parts[k].first || p.parts[k].last != q.parts[k].last) return false;
  }
  return true;
}

// Is the point at t of a line with whole coordinates in the mesh, by a ray from there, or a part? t is a 64th.
bool is_in_parts(const MeshLine& found, double t) {
  const auto* in_mesh = std::get_if<LineInMesh>(&found.evidence);
  if (in_mesh == nullptr) return false;
  const ExactFraction at{Dyadic(t)};
  return std::any_of(in_mesh->parts.begin(), in_mesh->parts.end(),
                     [&](const LinePart& part) { return part.first <= at && at <= part.last; });
}

TEST(MeshFlatDifferential, Lines) {
  Random random(chosen_seed(4041));
  const int times = scaled_count(300, 100);
  int apart = 0, parts = 0, through = 0;
  for (int i = 0; i < times; ++i) {
    const Mesh mesh = some_soup(random).mesh();
    const Pose pose = i % 2 == 0 ? Pose() : soup_pose(random, i);
    const LineLike line = some_line(random, i);
    const MeshLine found = mesh_line(mesh, pose, line), all = mesh_line_by_scan(mesh, pose, line);
    ASSERT_EQ(found.meet(), all.meet()) << i;
    if (const auto* in_mesh = std::get_if<LineInMesh>(&found.evidence)) {
      ASSERT_TRUE(are_equal(*in_mesh, std::get<LineInMesh>(all.evidence))) << i;
      for (std::size_t k = 0; k < in_mesh->parts.size(); ++k) {
        const LinePart& part = in_mesh->parts[k];
        ASSERT_TRUE(part.first <= part.last && (k == 0 || in_mesh->parts[k - 1].last < part.first)) << i;
        through += part.is_through;
      }
      parts += static_cast<int>(in_mesh->parts.size());
    }
    apart += !found.meet();
    const auto [a, b] = std::visit([](const auto& of) { return std::pair(of.a, of.b); }, line);
    if (i % 3 != 1) {  // of whole coordinates, points at 64ths of the way are doubles
      for (int n = -128; n <= 192; n += 1 + static_cast<int>(random.below(9))) {
        const double t = n / 64.0;
        const bool is_of_line = std::holds_alternative<solid::Line>(line) ||
                                (t >= 0 && (t <= 1 || std::holds_alternative<solid::Ray>(line)));
        const Point3 p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
        const bool is_in = mesh_point(mesh, pose, p).place != solid::MeshPlace::outside;
        ASSERT_EQ(is_in_parts(found, t), is_in && is_of_line) << i << " " << t;
      }
    }
    if (std::holds_alternative<solid::Segment>(line)) continue;
    const auto add_body = [&](PairClaims& pairs) {
      static solid::LineBody body;
      body = body_of(line);
      return pairs.add_body("line", body.points, body.ways);
    };
    EXPECT_EQ(proved_flat(mesh, pose, add_body,
                          [&](PairClaims& pairs, const solid::StatedMesh& stated, std::uint32_t body) {
                            add_claims(pairs, stated, body, line, found);
                          }),
              found.meet() ? "meet" : "apart")
        << i;
  }
  EXPECT_GE(apart, times / 20);
  EXPECT_GE(parts, times / 10);
  EXPECT_GE(through, times / 60);
}

TEST(MeshFlatDifferential, Planes) {
  Random random(chosen_seed(4042));
  const int times = scaled_count(300, 100);
  std::array<int, 4> seen{};  // below, on both sides, above; across
  for (int i = 0; i < times; ++i) {
    Soup soup = some_soup(random);
    if (i % 4 == 0) soup.add_box({9, 9, 9}, {1, 1, 1}, true, false);  // a piece that may be beyond the plane
    const Mesh mesh = soup.mesh();
    const Pose pose = i % 2 == 0 ? Pose() : soup_pose(random, i);
    const auto whole = [&](int size) { return static_cast<double>(random.between(-size, size)); };
    Point3 normal{whole(1), whole(1), whole(1)};
    if (i % 3 == 1) normal = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (normal == Point3{}) normal.z = 1;
    const double far = i % 5 == 0 ? 8 : 3;
    const solid::Plane plane = solid::Plane::through({far * whole(1), far * whole(1), far * whole(1)}, normal);
    const MeshPlane found = mesh_plane(mesh, pose, plane);
    bool below = false, above = false, meets = false;
    for (const Mesh::Triangle& t : mesh.triangles()) {
      bool of_below = false, of_above = false;
      for (const std::uint32_t v : t) {
        const Vector3<Dyadic> at = coordinates<Dyadic>(Posed3{mesh.points()[v], &pose.affine(), false});
        const Sign side = height(plane, exact_point(at)).sign();
        of_below = of_below || side != Sign::positive;
        of_above = of_above || side != Sign::negative;
      }
      meets = meets || (of_below && of_above);
      below = below || of_below;
      above = above || of_above;
    }
    ASSERT_EQ(found.meet(), meets) << i;
    if (const auto* beside = std::get_if<solid::MeshBesidePlane>(&found.evidence)) {
      ASSERT_EQ(beside->all, below && above ? Sign::zero : above ? Sign::positive : Sign::negative) << i;
      ++seen[static_cast<std::size_t>(1 + static_cast<int>(beside->all))];
    } else {
      ++seen[3];
    }
    EXPECT_EQ(proved_plane(mesh, pose, plane, found), found.meet() ? "meet" : "apart") << i;
  }
  for (const int n : seen) EXPECT_GE(n, times / 100);
}

// A sheet has no triangle across the plane that it lies in.
TEST(MeshFlatDifferential, SheetInThePlane) {
  Soup sheet;
  sheet.points = {{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}};
  sheet.add_face({0, 1, 2, 3});
  const Mesh mesh = sheet.mesh();
  for (const double z : {1.0, 2.0, 3.0}) {
    const solid::Plane plane = solid::Plane::through({1, 1, z}, {0, 0, 1});
    const MeshPlane found = mesh_plane(mesh, Pose(), plane);
    EXPECT_EQ(found.meet(), z == 2.0) << z;
    EXPECT_EQ(proved_plane(mesh, Pose(), plane, found), z == 2.0 ? "meet" : "apart") << z;
  }
}

}  // namespace
}  // namespace sunder::tests
