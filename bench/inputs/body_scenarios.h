// Pairs of placed convex bodies for the benchmarks, the same for every library that is compared.
//
// Bodies are random spheres: n random points on the unit sphere, so that all of them are vertices. A pool holds several
// bodies, and the queries rotate over many pairs of them, so that no library lives in the first-level cache alone.
// Nothing here uses the library under test: placements are found by a portal search of their own in plain doubles
// (walk along a ray from inside the Minkowski difference to the facet where it leaves), and the verdicts written down
// are known by construction.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace bench {

using Vec = std::array<double, 3>;

struct Body {
  std::vector<Vec> points;
};

// x_world = linear x_body + translation; the linear part is row by row.
struct Placement {
  std::array<double, 9> linear{1, 0, 0, 0, 1, 0, 0, 0, 1};
  Vec translation{};
};

enum class Expected : std::uint8_t { apart, meet, unknown };

struct Query {
  std::uint32_t a = 0, b = 0;  // positions in the pool
  Placement pose_a, pose_b;
  Expected expected = Expected::unknown;
  std::uint8_t family = 0;  // of touching and last_bit: a position in kFamilies
};

// Which features touch. In the last two B is the reflection of A in the point of contact.
inline constexpr std::array<std::string_view, 6> kFamilies{"vertex on vertex",     "vertex of B on facet",
                                                           "vertex of A on facet", "crossing edges",
                                                           "equal edges",          "equal facets"};

// The size of a body is its radius, 1.
enum class Regime : std::uint8_t {
  far,       // apart by 0.1 to 1 of the size
  near,      // half apart, half meeting; gap or depth log-uniform in 1e-6 to 1e-3 of the size
  deep,      // the centres within 0.3 of the size, or so: at most 0.15 of the way from the centre to touching
  touching,  // exactly touching, in six families
  last_bit,  // touching, then the translation of one body moved by one unit in the last place, out or in
};

std::string_view name_of(Regime);

struct Scenario {
  std::size_t n = 0;
  Regime regime = Regime::far;
  std::vector<Body> pool;
  std::vector<Query> queries;
};

// far, near, deep: general rotations (quaternions, rounded to a matrix) and translations within 10 sizes.
//
// touching, last_bit: coordinates are multiples of 2^-20, linear parts multiples of 2^-14 (one half signed
// permutations, one half rotations rounded to that grid), translations multiples of 2^-36, so that the contact is
// exact. Each is proved with 128-bit integers: a plane through the contact has A weakly on one side, B on the other.
// Of last_bit, one half is moved out (apart, proved), one half in (not known in general).
//
// The result depends on the arguments only.
Scenario make_scenario(std::size_t n, Regime regime, std::size_t bodies, std::size_t queries, std::uint64_t seed);

// The same in the regime near, of these bodies; the greatest of a body's coordinates is about 1.
Scenario make_near_scenario(std::vector<Body> pool, std::size_t queries, std::uint64_t seed);

// n random points on the unit sphere.
std::vector<Vec> sphere_points(std::size_t n, std::uint64_t seed);

}  // namespace bench
