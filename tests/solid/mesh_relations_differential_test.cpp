// How solids of unit cells lie to each other, which their cells tell: as they are, moved by a part of a cell, and both
// under a map; with proofs. And how many cells trees of planes have, where a body is in its own socket.
#include <tests/support/mesh_proofs.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/mesh/mesh_relation.h>
#include <sunder/solid/object/convex_polyhedron.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using solid::ConvexPolyhedron;
using solid::Mesh;
using solid::MeshRelation;
using solid::MeshView;
using solid::Pose;

using Place = std::array<int, 3>;
using Cells = std::set<Place>;

// Two triangles for each side of a cell that no other one is beyond, cut along either diagonal, in any order.
Mesh mesh_of(const Cells& cells, const Point3& shift, Random& random) {
  std::map<Place, std::uint32_t> numbers;
  std::vector<Point3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto number = [&](const Place& p) {
    const auto [at, is_new] = numbers.try_emplace(p, static_cast<std::uint32_t>(points.size()));
    if (is_new) points.push_back({p[0] + shift.x, p[1] + shift.y, p[2] + shift.z});
    return at->second;
  };
  for (const Place& cell : cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int way : {0, 1}) {
        Place beyond = cell;
        beyond[axis] += way == 1 ? 1 : -1;
        if (cells.contains(beyond)) continue;
        std::array<std::uint32_t, 4> ring{};
        for (int k = 0; k < 4; ++k) {
          Place p = cell;
          p[axis] += way;
          p[(axis + 1) % 3] += k == 1 || k == 2;
          p[(axis + 2) % 3] += k >= 2;
          ring[static_cast<std::size_t>(way == 1 ? k : 3 - k)] = number(p);
        }
        std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random.below(4)), ring.end());
        triangles.push_back({ring[0], ring[1], ring[2]});
        triangles.push_back({ring[0], ring[2], ring[3]});
      }
    }
  }
  std::vector<std::uint32_t> begin{0}, corners;
  for (const auto& t : triangles) {
    corners.insert(corners.end(), t.begin(), t.end());
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return Mesh(MeshView{points, begin, corners});
}

Cells some_cells(Random& random, int size) {
  Cells cells;
  const bool is_shell = size == 3 && random.below(4) == 0;
  for (int i = 0; i < size * size * size; ++i) {
    const Place p{i % size, i / size % size, i / size / size};
    if (is_shell ? i != 13 : random.below(3) == 0) cells.insert(p);
  }
  if (cells.empty()) cells.insert({0, 0, 0});
  return cells;
}

// Cells of a grid that is moved by `shift`, whole numbers and parts: do the closed cells, or the open ones, of two grids
// meet? And all cells of the other grid that one meets.
bool meet(const Place& a, const Place& b, const Point3& shift, bool closed) {
  for (std::size_t c = 0; c < 3; ++c) {
    const double way = std::fabs(a[c] - (b[c] + shift[c]));
    if (closed ? way > 1 : way >= 1) return false;
  }
  return true;
}

// Does all of `inner`, moved by shift, lie in `outer`; closed: with all that touches it?
bool is_in(const Cells& inner, const Cells& outer, const Point3& shift, bool closed) {
  for (const Place& cell : inner) {
    for (int i = 0; i < 64; ++i) {
      Place near;
      const std::array<int, 3> step{i % 4 - 1, i / 4 % 4 - 1, i / 16 - 1};
      for (std::size_t c = 0; c < 3; ++c) near[c] = cell[c] + static_cast<int>(std::floor(shift[c])) + step[c];
      if (meet(near, cell, shift, closed) && !outer.contains(near)) return false;
    }
  }
  return true;
}

std::string told_by_cells(const Cells& a, const Cells& b, const Point3& shift) {
  bool closed = false, open = false;
  for (const Place& p : a) {
    for (const Place& q : b) {
      closed |= meet(p, q, shift, true);
      open |= meet(p, q, shift, false);
    }
  }
  if (!closed) return "none";
  if (!open) return "touching";
  const Point3 back{-shift.x, -shift.y, -shift.z};
  const bool b_in_a = is_in(b, a, shift, false), a_in_b = is_in(a, b, back, false);
  if (a_in_b && b_in_a) return "equal";
  if (a_in_b) return is_in(a, b, back, true) ? "A inside B" : "A part of B";
  if (b_in_a) return is_in(b, a, shift, true) ? "B inside A" : "B part of A";
  return "overlapping";
}

// The same, of A and B exchanged.
std::string exchanged(std::string told) {
  for (char& c : told) c = c == 'A' ? 'B' : c == 'B' ? 'A' : c;
  return told;
}

Pose some_map(Random& random) {
  while (true) {
    std::array<double, 9> linear;
    for (double& x : linear)
      x = static_cast<double>(random.between(-2, 2)) + (random.below(4) == 0 ? random.unit() : 0);
    try {
      return Pose::from_matrix(linear, {random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)});
    } catch (const Error&) {  // singular
    }
  }
}

TEST(MeshRelationsDifferential, OfSolidsOfCells) {
  Random random(chosen_seed(4021));
  const int times = scaled_count(2400);
  std::map<std::string, int> counts;
  for (int i = 0; i < times; ++i) {
    Cells a = some_cells(random, 1 + i % 3), b = some_cells(random, 1 + i / 3 % 2);
    Point3 shift{static_cast<double>(random.between(-3, 3)), static_cast<double>(random.between(-3, 3)),
                 static_cast<double>(random.between(-3, 3))};
    const std::uint64_t kind = random.below(6);
    if (kind < 2) {  // the same cells, or some of them
      b.clear();
      for (const Place& cell : a) {
        if (kind == 0 || random.below(2) == 0) b.insert(cell);
      }
      if (b.empty()) b = a;
      shift = {};
    }
    if (kind == 2) {  // about one cell, with a margin
      a = {};
      for (int k = 0; k < 27; ++k) a.insert({k % 3, k / 3 % 3, k / 9});
      b = {{0, 0, 0}};
      shift = {1, 1, static_cast<double>(random.between(0, 1))};
    }
    if (kind % 2 == 1)
      shift[random.below(3)] += std::ldexp(random.below(2) == 0 ? 1.0 : -1.0, static_cast<int>(-random.between(1, 45)));
    const Mesh of_a = mesh_of(a, {}, random), of_b = mesh_of(b, shift, random);
    const Pose pose = i % 3 == 0 ? Pose() : some_map(random);
    const bool is_exchanged = i % 2 == 1;
    const std::string told = is_exchanged ? exchanged(told_by_cells(a, b, shift)) : told_by_cells(a, b, shift);
    const Mesh &first = is_exchanged ? of_b : of_a, &second = is_exchanged ? of_a : of_b;
    const solid::MeshAnswer answer = mesh_mesh(first, pose, second, pose);
    ASSERT_EQ(answer.meet(), told != "none") << i;
    const MeshRelation found = mesh_relation(first, pose, second, pose, answer);
    ASSERT_TRUE(found.is_known) << i;
    ASSERT_EQ(name_of(found.relation), told) << i;
    if (i % 4 < 2) proved_pair(first, pose, second, pose, answer, true);
    ++counts[told];
  }
  for (const auto& [told, count] : counts) std::printf("%s: %d\n", told.c_str(), count);
  EXPECT_EQ(counts.size(), 8u);
}

// A cube with a cavity that has the inside of the body.
Mesh socket_of(const Mesh& body) {
  std::vector<Point3> points(body.points().begin(), body.points().end());
  std::vector<std::uint32_t> begin{0}, corners;
  for (const Mesh::Triangle& t : body.triangles()) {
    corners.insert(corners.end(), {t[0], t[2], t[1]});
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  const auto first = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t k = 0; k < 8; ++k) points.push_back({k & 1 ? 2.0 : -2.0, k & 2 ? 2.0 : -2.0, k & 4 ? 2.0 : -2.0});
  constexpr std::array<std::array<std::uint32_t, 4>, 6> faces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& face : faces) {
    for (const std::uint32_t corner : face) corners.push_back(first + corner);
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return Mesh(MeshView{points, begin, corners});
}

TEST(MeshRelationsDifferential, TreesInSocketsHaveCellsInProportion) {
  Random random(chosen_seed(4022));
  for (const std::size_t n : {20u, 100u, 500u}) {
    const Mesh body = solid::mesh_of(ConvexPolyhedron(solid_shapes::sphere(n, random))), socket = socket_of(body);
    const solid::MeshAnswer answer = mesh_mesh(body, {}, socket, {});
    const MeshRelation found = mesh_relation(body, {}, socket, {}, answer);
    ASSERT_EQ(found.relation, Relation::touching);
    const double cells = static_cast<double>(found.partition->cells.size()),
                 triangles = static_cast<double>(body.triangles().size());
    std::printf("%zu triangles: %.0f cells, %.2f a triangle\n", body.triangles().size(), cells, cells / triangles);
    EXPECT_LE(cells, 5 * triangles);
    if (n <= 100) {
      EXPECT_EQ(proved_pair(body, {}, socket, {}, answer, true), "touching");
    }
  }
}

// A square wave with so many teeth, and what is below it (or above), as thick as a tooth is wide.
Mesh comb_of(int teeth, bool is_above) {
  std::vector<std::array<int, 2>> profile;
  for (int k = 0; k < teeth; ++k) {
    for (const auto& [x, y] : {std::array{0, 0}, {0, 1}, {1, 1}, {1, 0}}) profile.push_back({2 * k + x, y});
  }
  profile.insert(profile.end(), {{2 * teeth, 0}, {2 * teeth, is_above ? 2 : -1}, {0, is_above ? 2 : -1}});
  if (!is_above) std::reverse(profile.begin(), profile.end());
  const auto n = static_cast<std::uint32_t>(profile.size());
  std::vector<Point3> points;
  std::vector<std::uint32_t> begin{0}, corners;
  const auto end_face = [&] { begin.push_back(static_cast<std::uint32_t>(corners.size())); };
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] : profile) points.push_back({static_cast<double>(x), static_cast<double>(y), z});
  }
  for (std::uint32_t k = 0; k < n; ++k) {
    corners.insert(corners.end(), {k, (k + 1) % n, n + (k + 1) % n, n + k});
    end_face();
  }
  for (std::uint32_t k = n; k-- > 0;) corners.push_back(k);
  end_face();
  for (std::uint32_t k = 0; k < n; ++k) corners.push_back(n + k);
  end_face();
  return Mesh(MeshView{points, begin, corners});
}

// The caps of a comb are fans of slivers, each as long as many teeth.
TEST(MeshRelationsDifferential, LooksAreNLogN) {
  const auto expect_few = [](const Mesh& a, const Mesh& b, double most) {
    const solid::Partitioned found = mesh_partition(a, {}, b, {}, {});
    ASSERT_TRUE(found.is_decided);
    EXPECT_FALSE(found.found.both);
    const auto n = static_cast<double>(a.triangles().size() + b.triangles().size()),
               looks = static_cast<double>(found.cost.probes + found.cost.iterations);
    std::printf("%.0f triangles: %zu planes, %.0f looks, %.2f n log2 n\n", n, found.partition.planes.size(), looks,
                looks / (n * std::log2(n)));
    EXPECT_LE(looks, most * n * std::log2(n));
  };
  for (const int teeth : {4, 20, 100, 400}) expect_few(comb_of(teeth, false), comb_of(teeth, true), 3);
  Random random(chosen_seed(4023));
  for (const std::size_t n : {20u, 100u, 500u}) {
    const Mesh body = solid::mesh_of(ConvexPolyhedron(solid_shapes::sphere(n, random)));
    expect_few(body, socket_of(body), 20);
  }
}

}  // namespace
}  // namespace sunder::tests
