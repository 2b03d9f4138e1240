// How solids of named solid_families lie to each other: plugs in sockets, links of chains, screws in nuts, boxes in cavities, walls
// side by side, equal ones cut otherwise, inverted ones, ones that cross themselves, with needles, of any size; against what is
// on both sides of all parts of their surfaces (tests/support/mesh_two_cells.h).
#include <tests/support/mesh_proofs.h>
#include <tests/support/mesh_soups.h>
#include <tests/support/mesh_two_cells.h>
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/solid/mesh/mesh_relation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sunder::tests {
namespace {

using solid::Mesh;
using solid::MeshRelation;
using solid::Pose;

// A ring of four bars around a hole: outside [-2, 2], the hole [-1, 1], from z = 0 to 1; or around another hole.
void add_frame(Soup& soup, double hole, double z0 = 0, double z1 = 1) {
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for (const double z : {z0, z1}) {
    for (const double size : {2.0, hole}) {
      for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
        soup.points.push_back({x * size, y * size, z});
      }
    }
  }
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    soup.add_face({first + a, first + b, first + c, first + d});
  };
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t n = (k + 1) % 4;
    face(k, n, 8 + n, 8 + k);
    face(4 + n, 4 + k, 12 + k, 12 + n);
    face(n, k, 4 + k, 4 + n);
    face(8 + k, 8 + n, 12 + n, 12 + k);
  }
}

void add_box(Soup& soup, const Point3& low, const Point3& high, bool outwards = true) {
  soup.add_box(low, {high.x - low.x, high.y - low.y, high.z - low.z}, outwards, false);
}

// A prism over a polygon of `sides` corners that turns as it goes up, in steps: a coarse screw. Its sides are not flat.
void add_screw(Soup& soup, int sides, int steps, double turn, bool outwards) {
  const auto first = static_cast<std::uint32_t>(soup.points.size()), n = static_cast<std::uint32_t>(sides);
  for (int s = 0; s <= steps; ++s) {
    for (int k = 0; k < sides; ++k) {
      const double angle = 2 * 3.14159265358979 * k / sides + turn * s, radius = k % 2 == 0 ? 1.5 : 1;
      soup.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 2.0 * s / steps - 1});
    }
  }
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    outwards ? soup.add_face({first + a, first + b, first + c}) : soup.add_face({first + a, first + c, first + b});
  };
  for (std::uint32_t s = 0; s < static_cast<std::uint32_t>(steps); ++s) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = s * n + k, b = s * n + (k + 1) % n;
      face(a, b, b + n);
      face(a, b + n, a + n);
    }
  }
  const std::uint32_t top = static_cast<std::uint32_t>(steps) * n;
  for (std::uint32_t k = 1; k + 1 < n; ++k) {
    face(0, k + 1, k);
    face(top, top + k, top + k + 1);
  }
}

// A box whose sides are cut from their middles.
void add_cut_box(Soup& soup, const Point3& low, const Point3& high) {
  Soup whole;
  add_box(whole, low, high);
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), whole.points.begin(), whole.points.end());
  for (std::size_t f = 0; f + 1 < whole.begin.size(); ++f) {
    const std::vector<std::uint32_t> ring(whole.corners.begin() + whole.begin[f],
                                          whole.corners.begin() + whole.begin[f + 1]);
    Point3 middle;
    for (const std::uint32_t k : ring) {
      for (std::size_t c = 0; c < 3; ++c) middle[c] += whole.points[k][c] / 4;
    }
    const auto at = static_cast<std::uint32_t>(soup.points.size());
    soup.points.push_back(middle);
    for (std::size_t k = 0; k < 4; ++k) soup.add_face({first + ring[k], first + ring[(k + 1) % 4], at});
  }
}

// 0, a last bit, or a power of two, to either side.
double gap(Random& random) {
  const std::uint64_t kind = random.below(4);
  if (kind == 0) return 0;
  const double size = kind == 1 ? 0x1p-52 : std::ldexp(1.0, -static_cast<int>(random.between(1, 40)));
  return random.below(2) == 0 ? size : -size;
}

struct SolidPair {
  Soup a, b;
};

constexpr std::array solid_families{
    "plug in a socket",     "links of a chain", "screw in a nut",  "box in a cavity", "walls",
    "equal, cut otherwise", "inverted",         "crossing itself", "with a needle"};

SolidPair some_solids(std::size_t family, Random& random) {
  SolidPair pair;
  const double g = gap(random), s = static_cast<double>(random.between(-2, 2)) / 2;
  switch (family) {
    case 0:
      add_frame(pair.a, 1);
      add_box(pair.b, {-1 + std::min(s, 0.0), -1, random.below(2) == 0 ? 0.0 : 0.25}, {1 + g, 1, 0.75});
      break;
    case 1:
      add_frame(pair.a, 1);
      add_frame(pair.b, 1, -0.5, 0.5);
      for (Point3& p : pair.b.points) p = {p.x + 2 + s / 2 + g, p.z, p.y + 0.5};
      break;
    case 2: {
      const int steps = static_cast<int>(random.between(1, 2));
      add_screw(pair.a, 4, steps, 0.25, true);
      add_screw(pair.b, 4, steps, 0.25, false);  // the same, as a cavity
      add_box(pair.b, {-2, -2, -2}, {2, 2, random.below(2) == 0 ? 2.0 : 1.0});
      for (Point3& p : pair.a.points) p.z += random.below(3) == 0 ? 0.0 : g;
      break;
    }
    case 3: {
      add_box(pair.a, {-2, -2, -2}, {2, 2, 2});
      add_box(pair.a, {-1, -1, -1}, {1, 1, 1}, false);
      const double size = random.below(2) == 0 ? 1.0 : 0.5;
      add_box(pair.b, {-size, -size, -size}, {size + g, size, size});
      if (random.below(3) == 0) add_box(pair.b, {3, 3, 3}, {4, 4, 4});
      break;
    }
    case 4:
      add_cut_box(pair.a, {0, 0, 0}, {1, 2, 2});
      add_cut_box(pair.b, {1 + g, s, s / 2}, {2, 3, 1});
      break;
    case 5:
      add_box(pair.a, {0, 0, 0}, {1, 2, 3});
      add_cut_box(pair.b, {0, 0, 0}, {1, 2, random.below(2) == 0 ? 3.0 : 3 + g});
      break;
    case 6:
      add_box(pair.a, {0, 0, 0}, {2, 2, 2}, false);
      add_box(pair.b, {1 + g, s, 0}, {2, 2, 2}, random.below(2) == 0);
      break;
    case 7:
      add_box(pair.a, {0, 0, 0}, {2, 2, 2});
      add_box(pair.a, {1, 1, 1}, {3, 3, 3}, random.below(2) == 0);
      add_box(pair.b, {1 + g, 1, 1 + s}, {2, 2, 2.5});
      break;
    default: {
      add_box(pair.a, {0, 0, 0}, {2, 2, 2});
      const auto needle = static_cast<std::uint32_t>(pair.a.points.size());
      pair.a.points.push_back({4, 1, 1});
      pair.a.add_face({0, needle, 0});
      add_box(pair.b, {2 + g, 0, s}, {3, 2, 2});
      break;
    }
  }
  if (random.below(2) == 0) std::swap(pair.a, pair.b);
  return pair;
}

// An invertible map of small whole numbers; two_cells maps likewise.
struct Map {
  std::array<double, 9> linear{1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::array<double, 3> shift{};

  static Map some(Random& random) {
    Map map;
    if (random.below(3) == 0) return map;
    const auto& m = map.linear;
    do {
      for (double& x : map.linear) x = static_cast<double>(random.between(-2, 2));
    } while (m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
                 m[2] * (m[3] * m[7] - m[4] * m[6]) ==
             0);
    for (double& x : map.shift) x = random.uniform(-3, 3);
    return map;
  }
  Pose pose(int exponent) const {
    std::array<double, 9> m = linear;
    std::array<double, 3> t = shift;
    for (double& x : m) x = std::ldexp(x, exponent);
    for (double& x : t) x = std::ldexp(x, exponent);
    return Pose::from_matrix(m, t);
  }
};

two_cells::Solid solid_of(const Mesh& mesh, const Map& map) {
  two_cells::Solid solid;
  const auto at = [&](std::uint32_t v) {
    two_cells::Vector p;
    for (std::size_t r = 0; r < 3; ++r) {
      p[r] = two_cells::Number(map.shift[r]);
      for (std::size_t c = 0; c < 3; ++c) {
        p[r] += two_cells::Number(map.linear[3 * r + c]) * two_cells::Number(mesh.points()[v][c]);
      }
    }
    return p;
  };
  for (const Mesh::Triangle& t : mesh.triangles()) {
    const two_cells::Triangle triangle{at(t[0]), at(t[1]), at(t[2])};
    if (!two_cells::is_zero(two_cells::normal_of(triangle))) solid.add(triangle);
  }
  return solid;
}

TEST(MeshFamiliesDifferential, RelationsAreAsBothSidesOfSurfacesTell) {
  Random random(chosen_seed(4051));
  const int times = scaled_count(54);
  std::map<std::string, std::map<std::string, int>> counts;
  for (int i = 0; i < times; ++i) {
    const std::size_t family = static_cast<std::size_t>(i) % solid_families.size();
    const SolidPair pair = some_solids(family, random);
    const Mesh a = pair.a.mesh(), b = pair.b.mesh();
    ASSERT_TRUE(a.is_closed() && b.is_closed() && a.is_by_winding() && b.is_by_winding()) << solid_families[family];
    const Map map = Map::some(random);
    const Insides there = two_cells::look(solid_of(a, map), solid_of(b, map));
    for (const int exponent : {0, i % 4 == 1 ? 990 : -990}) {
      const Pose pose = map.pose(exponent);
      const solid::MeshAnswer answer = mesh_mesh(a, pose, b, pose);
      const MeshRelation found = mesh_relation(a, pose, b, pose, answer);
      ASSERT_TRUE(found.is_known) << solid_families[family] << i;
      const bool are_apart = std::holds_alternative<solid::PointWithin>(answer.evidence);  // the surfaces
      const Relation expected = !answer.meet()                     ? Relation::none
                                : !there.both                      ? Relation::touching
                                : !there.a_alone && !there.b_alone ? Relation::equal
                                : !there.a_alone && are_apart      ? Relation::a_inside_b
                                : !there.b_alone && are_apart      ? Relation::b_inside_a
                                : !there.a_alone                   ? Relation::a_part_of_b
                                : !there.b_alone                   ? Relation::b_part_of_a
                                                                   : Relation::overlapping;
      ASSERT_TRUE(answer.meet() || !there.both) << solid_families[family] << i;
      ASSERT_EQ(name_of(found.relation), name_of(expected)) << solid_families[family] << " " << i << " " << exponent;
      if (i % 2 == 0 && exponent == 0) proved_pair(a, pose, b, pose, answer, true);
      ++counts[solid_families[family]][std::string(name_of(found.relation))];
    }
  }
  for (const auto& [name, of] : counts) {
    std::printf("%-22s", name.c_str());
    for (const auto& [told, n] : of) std::printf(" %s %d", told.c_str(), n);
    std::printf("\n");
  }
}

}  // namespace
}  // namespace sunder::tests
