// Which triangles of a mesh cross: down its tree, by the scan, and by all points that two triangles can have in common, in
// whole numbers; with proofs.
#include <tests/support/mesh_soups.h>
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/certificate/claims.h>
#include <sunder/solid/mesh/mesh_crossings.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::tests::crossings {
namespace {

using solid::CrossingTriangles;
using solid::Mesh;
using solid::MeshCrossings;

// (x, y, z) / w, with w > 0. All numbers here are small.
struct Place {
  std::int64_t x, y, z, w = 1;

  friend bool operator==(const Place& p, const Place& q) {
    return p.x * q.w == q.x * p.w && p.y * q.w == q.y * p.w && p.z * q.w == q.z * p.w;
  }
};
struct Way {
  std::int64_t x, y, z;
  bool is_zero() const { return x == 0 && y == 0 && z == 0; }
};
using Corners = std::array<Place, 3>;  // of w = 1

Way way(const Place& from, const Place& to) {  // times to.w; from.w is 1
  return {to.x - from.x * to.w, to.y - from.y * to.w, to.z - from.z * to.w};
}
Way across(const Way& u, const Way& v) { return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x}; }
std::int64_t times(const Way& u, const Way& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }

Way normal(const Corners& t) { return across(way(t[0], t[1]), way(t[0], t[2])); }

bool holds(const Corners& t, const Place& p) {
  const Way n = normal(t);
  if (times(n, way(t[0], p)) != 0) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Place &a = t[k], &b = t[(k + 1) % 3];
    if (times(n, across(way(a, b), way(a, p))) < 0) return false;
  }
  return true;
}

bool is_on_segment(const Place& a, const Place& b, const Place& p) {
  const Way u = way(a, b), v = way(a, p);
  return across(u, v).is_zero() && times(u, v) >= 0 && times(u, v) <= times(u, u) * p.w;
}

// The corners of what they have in common, some perhaps more than once.
std::vector<Place> common_corners(const Corners& t, const Corners& u) {
  std::vector<Place> found;
  for (const auto& [one, other] : {std::pair(&t, &u), std::pair(&u, &t)}) {
    const Way n = normal(*other);
    for (std::size_t k = 0; k < 3; ++k) {
      const Place &p = (*one)[k], &q = (*one)[(k + 1) % 3];
      if (holds(*other, p)) found.push_back(p);
      const std::int64_t of_p = times(n, way((*other)[0], p)), of_q = times(n, way((*other)[0], q));
      if ((of_p < 0) == (of_q < 0) || of_p == 0 || of_q == 0) continue;
      const std::int64_t a = std::abs(of_q), b = std::abs(of_p);
      const Place through{p.x * a + q.x * b, p.y * a + q.y * b, p.z * a + q.z * b, a + b};
      if (holds(*other, through)) found.push_back(through);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Place &p = t[i], &q = u[j];
      const Way d = way(p, t[(i + 1) % 3]), e = way(q, u[(j + 1) % 3]), r = way(p, q), m = across(d, e);
      if (m.is_zero() || times(r, m) != 0) continue;
      const std::int64_t mm = times(m, m), s = times(across(r, e), m), v = times(across(r, d), m);
      if (s < 0 || s > mm || v < 0 || v > mm) continue;
      found.push_back({p.x * mm + d.x * s, p.y * mm + d.y * s, p.z * mm + d.z * s, mm});
    }
  }
  return found;
}

enum class Kind { proper, t_junction, crossing };

Kind kind_of(const Corners& t, const Corners& u) {
  const std::vector<Place> common = common_corners(t, u);
  const auto is_of_both = [&](const Place& p) {
    return std::find(t.begin(), t.end(), p) != t.end() && std::find(u.begin(), u.end(), p) != u.end();
  };
  if (std::all_of(t.begin(), t.end(), is_of_both)) return Kind::crossing;
  if (std::all_of(common.begin(), common.end(), is_of_both)) return Kind::proper;
  const bool is_point = std::all_of(common.begin(), common.end(), [&](const Place& p) { return p == common[0]; });
  const auto is_corner = [&](const Corners& of) { return std::find(of.begin(), of.end(), common[0]) != of.end(); };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const bool are_all = std::all_of(common.begin(), common.end(), [&](const Place& p) {
        return is_on_segment(t[i], t[(i + 1) % 3], p) && is_on_segment(u[j], u[(j + 1) % 3], p);
      });
      if (are_all && (!is_point || is_corner(t) || is_corner(u))) return Kind::t_junction;
    }
  }
  return Kind::crossing;
}

Mesh some_mesh(Random& random, int size, std::uint64_t triangles, bool on_a_plane) {
  Soup soup;
  const std::uint64_t points = 3 + random.below(3 * triangles);
  for (std::uint64_t k = 0; k < points; ++k) {
    const auto whole = [&] { return static_cast<double>(random.between(0, size)); };
    soup.points.push_back({whole(), whole(), on_a_plane ? 0 : whole()});
  }
  for (std::uint64_t k = 0; k < triangles; ++k) {
    const auto corner = [&] { return static_cast<std::uint32_t>(random.below(points)); };
    soup.add_face({corner(), corner(), corner()});
  }
  return soup.mesh();
}

template <class State>  // state(claims, index of the mesh)
void expect_accepted(const Mesh& mesh, sunder_verifier::Limit limit, const State& state) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_origin({});
  solid::MeshClaims claims(file);
  const std::uint32_t index = claims.add_mesh("mesh", mesh);
  claims.end_table();
  state(claims, index);
  file.end();
  const auto result = sunder_verifier::verify_text(text, "certificate", limit);
  ASSERT_TRUE(result.accepted()) << result.failed_form << result.error << text.substr(0, 3000);
}

void expect_proved(const Mesh& mesh, const std::vector<CrossingTriangles>& pairs) {
  expect_accepted(mesh, sunder_verifier::Limit::none, [&](solid::MeshClaims& claims, std::uint32_t index) {
    for (const CrossingTriangles& pair : pairs) claims.add_crossing(index, mesh, pair);
  });
}

void expect_none_proved(const Mesh& mesh, const solid::MeshSelfCover& cover) {
  expect_accepted(mesh, sunder_verifier::Limit::by_size,
                  [&](solid::MeshClaims& claims, std::uint32_t index) { claims.add_no_crossings(index, cover); });
}

TEST(MeshCrossingsDifferential, AsAllCommonPointsSay) {
  Random random(chosen_seed(4031));
  const int times_asked = scaled_count(6000);
  std::array<std::uint64_t, 3> seen{};
  int proved = 0;
  for (int i = 0; i < times_asked; ++i) {
    const Mesh mesh = some_mesh(random, 1 + i % 5, 2 + random.below(9), i % 7 == 0);
    std::vector<CrossingTriangles> expected;
    std::uint64_t t_junctions = 0, without_area = 0;
    const auto corners_of = [&](std::uint32_t t) {
      Corners corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3& p = mesh.points()[mesh.triangles()[t][k]];
        corners[k] = {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y), static_cast<std::int64_t>(p.z)};
      }
      return corners;
    };
    const auto size = static_cast<std::uint32_t>(mesh.triangles().size());
    for (std::uint32_t t = 0; t < size; ++t) {
      if (normal(corners_of(t)).is_zero()) {
        ++without_area;
        continue;
      }
      for (std::uint32_t u = t + 1; u < size; ++u) {
        if (normal(corners_of(u)).is_zero()) continue;
        const Kind kind = kind_of(corners_of(t), corners_of(u));
        ++seen[static_cast<std::size_t>(kind)];
        if (kind == Kind::crossing) expected.push_back({t, u});
        t_junctions += kind == Kind::t_junction;
      }
    }
    const MeshCrossings found = mesh_crossings(mesh), scan = mesh_crossings_by_scan(mesh);
    ASSERT_EQ(found.pairs, expected) << i;
    ASSERT_EQ(scan.pairs, expected) << i;
    ASSERT_EQ(found.t_junctions, t_junctions) << i;
    ASSERT_EQ(scan.t_junctions, t_junctions) << i;
    ASSERT_EQ(found.without_area, without_area) << i;
    const MeshCrossings first = mesh_crossings(mesh, 1);
    ASSERT_EQ(first.pairs.size(), std::min<std::size_t>(1, expected.size())) << i;
    ASSERT_EQ(first.are_all, expected.size() <= 1) << i;
    if (i % 10 == 0 && !expected.empty()) {
      ASSERT_NO_FATAL_FAILURE(expect_proved(mesh, expected)) << i;
    }
    const auto cover = expected.empty() && t_junctions == 0 ? mesh_self_cover(mesh) : std::nullopt;
    if (cover) {
      ASSERT_NO_FATAL_FAILURE(expect_none_proved(mesh, *cover)) << i;
      ++proved;
    }
    ASSERT_EQ(cover.has_value(), expected.empty() && t_junctions + without_area == 0) << i;
  }
  EXPECT_GE(proved, times_asked / 100);
  for (const std::uint64_t count : seen) EXPECT_GE(count, static_cast<std::uint64_t>(times_asked / 10));
}

// A proof that it does not is of so many directions a triangle.
TEST(MeshCrossingsDifferential, ThatThereAreNoneIsProved) {
  Random random(chosen_seed(4033));
  for (const std::size_t n : {100u, 1000u}) {
    const Mesh one = bumpy(n, random);
    const auto cover = mesh_self_cover(one);
    ASSERT_TRUE(cover);
    ASSERT_NO_FATAL_FAILURE(expect_none_proved(one, *cover));
    const auto triangles = static_cast<double>(one.triangles().size());
    std::printf("n %6zu: %.1f directions and %.1f numbers a triangle\n", n,
                static_cast<double>(cover->directions.size()) / triangles,
                static_cast<double>(cover->cuts.size()) / triangles);
    EXPECT_LE(static_cast<double>(cover->directions.size()) / triangles, 12);
  }
}

// Coordinates of any digits, where floating point mostly knows the sides of corners: down the tree it is asked first, by
// the scan never.
TEST(MeshCrossingsDifferential, FloatingPointSaysAsSignsDo) {
  Random random(chosen_seed(4034));
  std::uint64_t crossings = 0, pairs = 0;
  for (int i = 0; i < scaled_count(1000); ++i) {
    Soup soup;
    const std::uint64_t points = 5 + random.below(20), triangles = 5 + random.below(20);
    for (std::uint64_t k = 0; k < points; ++k) {
      soup.points.push_back({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
    }
    for (std::uint64_t k = 0; k < triangles; ++k) {
      const auto corner = [&] { return static_cast<std::uint32_t>(random.below(points)); };
      soup.add_face({corner(), corner(), corner()});
    }
    const Mesh mesh = soup.mesh();
    const MeshCrossings found = mesh_crossings(mesh), scan = mesh_crossings_by_scan(mesh);
    ASSERT_EQ(found.pairs, scan.pairs) << i;
    ASSERT_EQ(found.t_junctions, scan.t_junctions) << i;
    crossings += found.pairs.size();
    pairs += triangles * (triangles - 1) / 2;
  }
  EXPECT_GE(crossings, pairs / 20);
  EXPECT_LE(crossings, pairs * 9 / 10);
}

// A sphere with bumps does not cross itself; two of them do where they meet, as one mesh. The looks are linear.
TEST(MeshCrossingsDifferential, LooksGrowLinearly) {
  Random random(chosen_seed(4032));
  for (const std::size_t n : {1000u, 10000u, 100000u}) {
    const Mesh one = bumpy(n, random);
    const MeshCrossings found = mesh_crossings(one);
    EXPECT_TRUE(found.pairs.empty());
    EXPECT_EQ(found.t_junctions + found.without_area, 0u);
    const double looks = static_cast<double>(found.cost.probes) / static_cast<double>(one.triangles().size());
    std::printf("n %6zu: %.1f looks a triangle, %u signs in exact numbers\n", n, looks,
                static_cast<unsigned>(found.cost.exact));
    EXPECT_LE(looks, 24);
  }
}

}  // namespace
}  // namespace sunder::tests::crossings
