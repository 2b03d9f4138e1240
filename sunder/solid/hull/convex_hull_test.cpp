// long because: each property of the contract has its examples, and each family of inputs its oracle
#include <sunder/solid/hull/convex_hull.h>

#include <sunder/base/error.h>
#include <sunder/base/random.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/hull/brute_force_hull_test.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder::solid {
namespace {

using tests::points_on_sphere, tests::shuffle;

using Points = std::vector<Point3>;
using Cycle = std::vector<std::uint32_t>;
using Integer3 = std::array<std::int64_t, 3>;
using BigInteger = boost::multiprecision::cpp_int;

// ---- Reading a hull ----

Cycle facet(const ConvexHull& hull, std::size_t f) {
  return {hull.facet_vertices.begin() + hull.facet_begin[f], hull.facet_vertices.begin() + hull.facet_begin[f + 1]};
}

Cycle neighbours(const ConvexHull& hull, std::size_t v) {
  return {hull.neighbours.begin() + hull.neighbour_begin[v], hull.neighbours.begin() + hull.neighbour_begin[v + 1]};
}

std::size_t facet_count(const ConvexHull& hull) { return hull.facet_begin.size() - 1; }

// How many facets have how many vertices.
std::map<std::size_t, int> facet_sizes(const ConvexHull& hull) {
  std::map<std::size_t, int> count;
  for (std::size_t f = 0; f < facet_count(hull); ++f) ++count[facet(hull, f).size()];
  return count;
}

using Coordinates = std::tuple<double, double, double>;

// The facets as cycles of coordinates, each starting at its lowest: independent of the order of the input.
std::set<std::vector<Coordinates>> facets_by_coordinates(const Points& points, const ConvexHull& hull) {
  std::set<std::vector<Coordinates>> result;
  for (std::size_t f = 0; f < facet_count(hull); ++f) {
    std::vector<Coordinates> cycle;
    for (const std::uint32_t v : facet(hull, f)) {
      const Point3& p = points[hull.vertices[v]];
      cycle.push_back({p.x, p.y, p.z});
    }
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    result.insert(cycle);
  }
  return result;
}

std::set<Coordinates> vertices_by_coordinates(const Points& points, const ConvexHull& hull) {
  std::set<Coordinates> result;
  for (const std::uint32_t i : hull.vertices) result.insert({points[i].x, points[i].y, points[i].z});
  return result;
}

// ---- Checks ----

void expect_same(const ConvexHull& a, const ConvexHull& b) {
  EXPECT_EQ(a.dimension, b.dimension);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.facet_begin, b.facet_begin);
  EXPECT_EQ(a.facet_vertices, b.facet_vertices);
  EXPECT_EQ(a.neighbour_begin, b.neighbour_begin);
  EXPECT_EQ(a.neighbours, b.neighbours);
}

// H3, H4 and H5 for dimension 3, without an oracle: facets turn left and are neither coplanar nor reflex to each other,
// they and the neighbours fit together, Euler's relation holds, and all is in order. Points at step `stride` are tested
// not to be outside of any facet.
void expect_body(const Points& points, const ConvexHull& hull, std::size_t stride) {
  ASSERT_EQ(hull.dimension, 3);
  const std::size_t vertex_count = hull.vertices.size();
  const auto at = [&](std::uint32_t v) -> const Point3& { return points[hull.vertices[v]]; };
  EXPECT_TRUE(std::is_sorted(hull.vertices.begin(), hull.vertices.end(), std::less_equal<>()));  // strictly
  ASSERT_EQ(hull.neighbour_begin.size(), vertex_count + 1);
  ASSERT_EQ(hull.neighbours.size() % 2, 0u);
  EXPECT_EQ(vertex_count + facet_count(hull), hull.neighbours.size() / 2 + 2) << "Euler's relation";
  ASSERT_EQ(hull.facet_vertices.size(), hull.neighbours.size());

  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::size_t, std::uint32_t>> left_of;  // facet, next
  Cycle last;
  for (std::size_t f = 0; f < facet_count(hull); ++f) {
    const Cycle cycle = facet(hull, f);
    ASSERT_GE(cycle.size(), 3u);
    EXPECT_EQ(cycle[0], *std::min_element(cycle.begin(), cycle.end())) << "H3";
    EXPECT_LT(last, cycle) << "H5";
    last = cycle;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const std::uint32_t a = cycle[i], b = cycle[(i + 1) % cycle.size()], c = cycle[(i + 2) % cycle.size()];
      EXPECT_TRUE(left_of.insert({{a, b}, {f, c}}).second);
      for (std::size_t p = 0; p < points.size(); p += stride) {
        EXPECT_NE(orient_3d(at(a), at(b), at(c), points[p]), Sign::positive)
            << "point " << p << " outside of facet " << f;
      }
    }
  }
  for (const auto& [edge, facet_and_next] : left_of) {
    const auto [a, b] = edge;
    const auto twin = left_of.find({b, a});
    ASSERT_NE(twin, left_of.end()) << "H3: an edge with one facet";
    // Also says that a, b, next turn strictly left: otherwise the plane is none, or the body is above it.
    EXPECT_EQ(orient_3d(at(a), at(b), at(facet_and_next.second), at(twin->second.second)), Sign::negative)
        << "H3: facets " << facet_and_next.first << " and " << twin->second.first << " are coplanar or reflex";
  }
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const Cycle around = neighbours(hull, v);
    ASSERT_GE(around.size(), 3u) << "H4";
    EXPECT_EQ(around[0], *std::min_element(around.begin(), around.end())) << "H4";
    for (std::size_t i = 0; i < around.size(); ++i) {
      // Counter-clockwise: the facet on the left of v w comes back to v from the next neighbour.
      const auto from_next = left_of.find({around[(i + 1) % around.size()], v});
      ASSERT_NE(from_next, left_of.end()) << "H4";
      EXPECT_EQ(from_next->second.second, around[i]) << "H4";
    }
  }
}

// ---- Making points ----

Points to_points(const std::vector<Integer3>& integers) {
  Points points;
  for (const Integer3& p : integers) {
    points.push_back({static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
  }
  return points;
}

std::vector<Integer3> grid(std::int64_t k) {
  std::vector<Integer3> result;
  for (std::int64_t x = 0; x <= k; ++x) {
    for (std::int64_t y = 0; y <= k; ++y) {
      for (std::int64_t z = 0; z <= k; ++z) result.push_back({x, y, z});
    }
  }
  return result;
}

// The corners of a regular k-gon, below and above.
Points prism(int k) {
  Points points;
  for (int i = 0; i < k; ++i) {
    const double angle = 2 * std::numbers::pi * i / k;
    points.push_back({std::cos(angle), std::sin(angle), -1});
    points.push_back({std::cos(angle), std::sin(angle), 1});
  }
  return points;
}

// Any finite doubles as integers, multiplied by one power of two.
std::vector<std::array<BigInteger, 3>> to_integers(const Points& points) {
  const auto lowest_bit = [](double x) { return x == 0 ? 1024 : std::max(std::ilogb(x) - 52, -1074); };
  int shift = 1024;
  for (const Point3& p : points) shift = std::min({shift, lowest_bit(p.x), lowest_bit(p.y), lowest_bit(p.z)});
  const auto to_integer = [&](double x) {
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(x, -lowest_bit(x)));
    return mantissa == 0 ? BigInteger(0) : BigInteger(mantissa) << (lowest_bit(x) - shift);
  };
  std::vector<std::array<BigInteger, 3>> result;
  for (const Point3& p : points) result.push_back({to_integer(p.x), to_integer(p.y), to_integer(p.z)});
  return result;
}

ConvexHull brute_force(const std::vector<Integer3>& integers) { return BruteForceHull<std::int64_t>(integers).hull(); }

ConvexHull brute_force(const Points& points) { return BruteForceHull<BigInteger>(to_integers(points)).hull(); }

// ---- The numbered promises, each on an example worked out by hand ----

// A cube with the middles of its edges and facets and its centre, each point twice.
struct CubeWithMiddles : testing::Test {
  CubeWithMiddles() {
    for (int copy = 0; copy < 2; ++copy) {
      for (const Point3& p : to_points(grid(2))) points.push_back(p);
    }
    hull = convex_hull(points);
  }
  Points points;
  ConvexHull hull;
};

TEST_F(CubeWithMiddles, H1_VerticesAreTheExtremePointsFirstOfEqualOnes) {
  EXPECT_EQ(hull.vertices, (Cycle{0, 2, 6, 8, 18, 20, 24, 26}));
}

TEST_F(CubeWithMiddles, H2_Dimension) { EXPECT_EQ(hull.dimension, 3); }

TEST_F(CubeWithMiddles, H3_H5_FacetsAreMaximalCounterClockwiseAndInOrder) {
  ASSERT_EQ(facet_count(hull), 6u);
  // Vertex numbers are the bits x y z.
  EXPECT_EQ(facet(hull, 0), (Cycle{0, 1, 3, 2}));
  EXPECT_EQ(facet(hull, 1), (Cycle{0, 2, 6, 4}));
  EXPECT_EQ(facet(hull, 2), (Cycle{0, 4, 5, 1}));
  EXPECT_EQ(facet(hull, 3), (Cycle{1, 5, 7, 3}));
  EXPECT_EQ(facet(hull, 4), (Cycle{2, 3, 7, 6}));
  EXPECT_EQ(facet(hull, 5), (Cycle{4, 6, 7, 5}));
}

TEST_F(CubeWithMiddles, H4_NeighboursAreCounterClockwiseFromTheLowest) {
  EXPECT_EQ(neighbours(hull, 0), (Cycle{1, 2, 4}));  // seen from (-1, -1, -1): z, y, x
  EXPECT_EQ(neighbours(hull, 7), (Cycle{3, 5, 6}));
  EXPECT_EQ(neighbours(hull, 3), (Cycle{1, 7, 2}));
}

TEST(ConvexHull, H5_TheOrderOfFacetsDoesNotDependOnTheirSize) {
  // A pyramid over a square; the apex is the vertex in the middle of the numbers.
  const Points points{{0, 0, 0}, {1, 0, 0}, {0.5, 0.5, 1}, {0, 1, 0}, {1, 1, 0}};
  const ConvexHull hull = convex_hull(points);
  ASSERT_EQ(facet_count(hull), 5u);
  EXPECT_EQ(facet(hull, 0), (Cycle{0, 1, 2}));
  EXPECT_EQ(facet(hull, 1), (Cycle{0, 2, 3}));
  EXPECT_EQ(facet(hull, 2), (Cycle{0, 3, 4, 1}));
  EXPECT_EQ(facet(hull, 3), (Cycle{1, 4, 2}));
  EXPECT_EQ(facet(hull, 4), (Cycle{2, 4, 3}));
  EXPECT_EQ(neighbours(hull, 2), (Cycle{0, 1, 4, 3}));
}

// ---- Errors ----

void expect_error(const Points& points, ErrorCode code, const std::string& place) {
  try {
    convex_hull(points);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    EXPECT_EQ(error.place(), place);
  }
}

TEST(ConvexHull, RefusesNoPoints) { expect_error({}, ErrorCode::bad_shape, ""); }

TEST(ConvexHull, NamesTheFirstPointThatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  expect_error({{nan, 0, 0}}, ErrorCode::bad_value, "point 0");
  expect_error({{0, 0, 0}, {1, 0, 0}, {0, nan, 0}, {nan, 0, 0}}, ErrorCode::bad_value, "point 2");
  expect_error({{0, 0, 0}, {0, 0, -infinity}}, ErrorCode::bad_value, "point 1");
  expect_error({{0, 0, 0}, {infinity, 0, 0}}, ErrorCode::bad_value, "point 1");
}

// ---- Every dimension ----

TEST(ConvexHull, OnePoint) {
  for (const Points& points : {Points{{1, 2, 3}}, Points(5000, {1, 2, 3}), Points{{0, -0.0, 0}, {-0.0, 0, 0}}}) {
    const ConvexHull hull = convex_hull(points);
    expect_same(hull, {0, {0}, {0}, {}, {0, 0}, {}});
  }
}

TEST(ConvexHull, Segment) {
  Random random(20);
  for (const Integer3& direction : {Integer3{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {3, -5, 7}}) {
    Points points;
    for (int i = 0; i < 3000; ++i) {
      const std::int64_t t = i == 40 ? 1000 : i == 30 ? -1000 : random.between(-999, 999);
      points.push_back(to_points({{5 + t * direction[0], 6 + t * direction[1], 7 + t * direction[2]}})[0]);
    }
    points.push_back(points[30]);
    const ConvexHull hull = convex_hull(points);
    expect_same(hull, {1, {30, 40}, {0}, {}, {0, 1, 2}, {1, 0}});
  }
}

TEST(ConvexHull, FlatPolygon) {
  // A square with a point in each edge and in the middle, and everything again, in planes along and across the axes.
  using Embedding = Point3 (*)(double, double);
  const Embedding embeddings[] = {[](double x, double y) { return Point3{x, y, 5}; },
                                  [](double x, double y) { return Point3{x, 5, y}; },
                                  [](double x, double y) { return Point3{5, x, y}; },
                                  [](double x, double y) { return Point3{x, y, 3 * x - 7 * y}; },
                                  [](double x, double y) { return Point3{x, x, y}; }};
  for (const Embedding embed : embeddings) {
    Points points;
    for (int copy = 0; copy < 2; ++copy) {
      for (const double x : {1, 0, 2}) {
        for (const double y : {1, 0, 2}) points.push_back(embed(x, y));
      }
    }
    const ConvexHull hull = convex_hull(points);
    EXPECT_EQ(hull.dimension, 2);
    EXPECT_EQ(hull.vertices, (Cycle{4, 5, 7, 8}));  // (0, 0), (0, 2), (2, 0), (2, 2)
    ASSERT_EQ(facet_count(hull), 2u);
    EXPECT_EQ(facet(hull, 0), (Cycle{0, 1, 3, 2}));
    EXPECT_EQ(facet(hull, 1), (Cycle{0, 2, 3, 1}));
    EXPECT_EQ(neighbours(hull, 0), (Cycle{1, 2}));
    EXPECT_EQ(neighbours(hull, 3), (Cycle{1, 2}));
  }
}

TEST(ConvexHull, FlatPolygonWithManyPoints) {
  // The lattice points of a parabola's cap are all extreme; those of the disk around them are not.
  Points points;
  const std::int64_t n = 2000;
  for (std::int64_t i = -n; i <= n; ++i) points.push_back(to_points({{i, i * i, 3 * i - 7 * i * i}})[0]);
  const std::size_t extreme = points.size();
  Random random(21);
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t x = random.between(-n, n), y = random.between(x * x, n * n);
    points.push_back(to_points({{x, y, 3 * x - 7 * y}})[0]);
  }
  const ConvexHull hull = convex_hull(points);
  EXPECT_EQ(hull.dimension, 2);
  EXPECT_EQ(hull.vertices.size(), extreme);
  EXPECT_EQ(hull.vertices.back(), extreme - 1);
}

// ---- Against brute force ----

TEST(ConvexHull, GridsAgainstBruteForce) {
  Random random(30);
  for (const std::int64_t k : {1, 2, 3}) {
    std::vector<Integer3> integers = grid(k);
    for (int i = 0; i < (k < 3 ? 4 : tests::scaled_count(4)); ++i) {
      SCOPED_TRACE("k = " + std::to_string(k) + ", order " + std::to_string(i));
      const ConvexHull hull = convex_hull(to_points(integers));
      EXPECT_EQ(hull.vertices.size(), 8u);
      EXPECT_EQ(facet_sizes(hull), (std::map<std::size_t, int>{{4, 6}}));
      expect_same(hull, brute_force(integers));
      shuffle(integers, random);
    }
  }
}

TEST(ConvexHull, PartsOfGridsAgainstBruteForce) {
  Random random(31);
  std::array<int, 4> of_dimension{};
  int repeated = 0, large_facet = 0, inside_edge_or_facet = 0;
  const int runs = tests::scaled_count(6000, 600);
  for (int run = 0; run < runs; ++run) {
    SCOPED_TRACE("seed 31, run " + std::to_string(run));
    const std::vector<Integer3> nodes = grid(random.between(1, 3));
    // An integer affine map: the same degeneracies in other directions, lower dimensions where it is singular.
    std::array<Integer3, 3> map;
    for (Integer3& row : map) row = {random.between(-3, 3), random.between(-3, 3), random.between(-3, 3)};
    std::vector<Integer3> integers;
    const std::uint64_t count = 1 + random.below(14);
    while (integers.size() < count) {
      const Integer3& p = nodes[random.below(nodes.size())];
      Integer3 q;
      for (std::size_t i = 0; i < 3; ++i) q[i] = map[i][0] * p[0] + map[i][1] * p[1] + map[i][2] * p[2];
      integers.push_back(q);
    }
    const ConvexHull expected = brute_force(integers);
    const ConvexHull hull = convex_hull(to_points(integers));
    expect_same(hull, expected);
    if (HasFailure()) break;

    const std::size_t distinct = std::set<Integer3>(integers.begin(), integers.end()).size();
    ++of_dimension[static_cast<std::size_t>(hull.dimension)];
    repeated += distinct < integers.size();
    inside_edge_or_facet += hull.dimension == 3 && distinct > hull.vertices.size();
    large_facet += hull.dimension == 3 && facet_sizes(hull).rbegin()->first > 3;
  }
  // What was tested.
  EXPECT_GT(of_dimension[0], runs / 50);
  EXPECT_GT(of_dimension[1], runs / 20);
  EXPECT_GT(of_dimension[2], runs / 10);
  EXPECT_GT(of_dimension[3], runs / 3);
  EXPECT_GT(repeated, runs / 4);
  EXPECT_GT(inside_edge_or_facet, runs / 10);
  EXPECT_GT(large_facet, runs / 5);
}

TEST(ConvexHull, CosphericalIntegersAgainstBruteForce) {
  // All integer points on spheres about the origin: many coplanar ones, of which a triangulation could go wrong.
  for (const std::int64_t square : {14, 17, 26, 41}) {
    if (square > 17 && tests::is_scaled_down()) continue;
    std::vector<Integer3> integers;
    for (Integer3 p : grid(14)) {
      for (std::int64_t& x : p) x -= 7;
      if (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] == square) integers.push_back(p);
    }
    ASSERT_GE(integers.size(), 30u);
    const ConvexHull hull = convex_hull(to_points(integers));
    EXPECT_EQ(hull.vertices.size(), integers.size());
    EXPECT_GT(facet_sizes(hull).rbegin()->first, 3u) << square;
    expect_same(hull, brute_force(integers));
  }
}

TEST(ConvexHull, AnySizesAgainstBruteForce) {
  // Few points with coordinates of one size, or of any sizes, from the least to the greatest double; some made coplanar
  // or collinear by repeating coordinates.
  Random random(33);
  std::array<int, 4> of_dimension{};
  int large_facet = 0;
  const int runs = tests::scaled_count(200, 50);
  for (int run = 0; run < runs; ++run) {
    SCOPED_TRACE("seed 33, run " + std::to_string(run));
    const bool mixed = run % 2 == 0;
    const int common = static_cast<int>(random.between(-1073, 1020));
    std::vector<double> pool;  // few values, so that they repeat
    for (int i = 0; i < 6; ++i) {
      const int exponent = mixed ? static_cast<int>(random.between(-1073, 1020)) : common;
      pool.push_back(std::ldexp(random.uniform(-8, 8), exponent));
    }
    const auto value = [&] {
      return random.below(3) == 0 ? std::ldexp(random.uniform(-8, 8), common) : pool[random.below(pool.size())];
    };
    Points points;
    const std::uint64_t count = 4 + random.below(7);
    for (std::uint64_t i = 0; i < count; ++i) points.push_back({value(), value(), value()});
    if (random.below(8) == 0) {
      for (Point3& p : points) p.y = p.x;
    }
    const ConvexHull hull = convex_hull(points);
    expect_same(hull, brute_force(points));
    if (HasFailure()) break;
    ++of_dimension[static_cast<std::size_t>(hull.dimension)];
    large_facet += hull.dimension == 3 && facet_sizes(hull).rbegin()->first > 3;
  }
  EXPECT_GT(of_dimension[2], runs / 30);
  EXPECT_GT(of_dimension[3], runs / 2);
  EXPECT_GT(large_facet, 0);
}

TEST(ConvexHull, NearlyFlatAndNeedleLikeAgainstBruteForce) {
  Random random(34);
  int bodies = 0;
  const int runs = tests::scaled_count(300, 60);
  for (int run = 0; run < runs; ++run) {
    SCOPED_TRACE("seed 34, run " + std::to_string(run));
    // Near a plane or a line in general position, as near as rounding goes, and at log-uniform distances.
    const double height = run % 3 == 0 ? 0 : random.log_uniform(0x1p-1074, 1), width = run % 5 == 0 ? 0 : 1;
    Points points;
    const std::uint64_t count = 4 + random.below(8);
    for (std::uint64_t i = 0; i < count; ++i) {
      const double s = random.unit(), t = width * random.unit(), h = height * random.unit();
      points.push_back({0.1 + 0.3 * s - 0.7 * t + h, 0.7 * s + 0.11 * t, 0.4 - 0.9 * s + 0.3 * t - h});
    }
    const ConvexHull hull = convex_hull(points);
    expect_same(hull, brute_force(points));
    if (HasFailure()) break;
    bodies += hull.dimension == 3;
  }
  EXPECT_GT(bodies, runs * 9 / 10);
}

// ---- Symmetry ----

TEST(ConvexHull, PermutationReflectionAndScaling) {
  Random random(40);
  for (int run = 0; run < 40; ++run) {
    SCOPED_TRACE("seed 40, run " + std::to_string(run));
    std::vector<Integer3> integers;
    for (int i = 0; i < 300; ++i)
      integers.push_back({random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)});
    const Points points = to_points(integers);
    const ConvexHull hull = convex_hull(points);
    ASSERT_GT(facet_sizes(hull).rbegin()->first, 3u);

    Points permuted = points;
    shuffle(permuted, random);
    const ConvexHull permuted_hull = convex_hull(permuted);
    EXPECT_EQ(vertices_by_coordinates(permuted, permuted_hull), vertices_by_coordinates(points, hull));
    EXPECT_EQ(facets_by_coordinates(permuted, permuted_hull), facets_by_coordinates(points, hull));

    // Reflected: the same cycles the other way round.
    Points reflected = points;
    for (Point3& p : reflected) p.x = -p.x;
    const ConvexHull reflected_hull = convex_hull(reflected);
    EXPECT_EQ(reflected_hull.vertices, hull.vertices);
    std::set<Cycle> reversed;
    for (std::size_t f = 0; f < facet_count(hull); ++f) {
      Cycle cycle = facet(hull, f);
      std::reverse(cycle.begin() + 1, cycle.end());
      reversed.insert(cycle);
    }
    std::set<Cycle> cycles;
    for (std::size_t f = 0; f < facet_count(reflected_hull); ++f) cycles.insert(facet(reflected_hull, f));
    EXPECT_EQ(cycles, reversed);

    // Scaled by powers of two, down to subnormal numbers and up to the greatest.
    for (const int exponent : {-1074, -1000, -300, -1, 1, 300, 1020}) {
      Points scaled = points;
      for (Point3& p : scaled) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
      expect_same(convex_hull(scaled), hull);
    }
  }
}

TEST(ConvexHull, OfEqualPointsTheLowestIndexCounts) {
  Random random(41);
  const Points distinct = points_on_sphere(50, random);
  Points points;
  for (int i = 0; i < 4000; ++i) points.push_back(distinct[random.below(distinct.size())]);
  std::set<std::uint32_t> first;
  for (const Point3& p : distinct) {
    first.insert(static_cast<std::uint32_t>(std::find(points.begin(), points.end(), p) - points.begin()));
  }
  EXPECT_EQ(convex_hull(points).vertices, Cycle(first.begin(), first.end()));
}

// ---- Many points, of kinds that are hard on some hull algorithm ----

TEST(ConvexHull, ManyOnASphere) {
  Random random(50);
  const Points points = points_on_sphere(20000, random);
  const ConvexHull hull = convex_hull(points);
  EXPECT_EQ(hull.vertices.size(), points.size());
  expect_body(points, hull, 4999);
}

TEST(ConvexHull, ManyInABall) {
  Random random(51);
  Points points = points_on_sphere(3000, random);
  for (Point3& p : points) {
    const double radius = std::cbrt(random.unit());
    p = {p.x * radius, p.y * radius, p.z * radius};
  }
  const ConvexHull hull = convex_hull(points);
  EXPECT_GT(hull.vertices.size(), 100u);
  EXPECT_LT(hull.vertices.size(), 1000u);
  expect_body(points, hull, 1);
}

TEST(ConvexHull, Prisms) {
  for (const int k : {3, 4, 5, 6, 7, 30, 1000}) {
    SCOPED_TRACE(k);
    const Points points = prism(k);
    const ConvexHull hull = convex_hull(points);
    EXPECT_EQ(hull.vertices.size(), points.size());
    EXPECT_EQ(facet_count(hull), static_cast<std::size_t>(k) + 2);
    const std::map<std::size_t, int> expected =
        k == 4 ? std::map<std::size_t, int>{{4, 6}}
               : std::map<std::size_t, int>{{4, k}, {static_cast<std::size_t>(k), 2}};
    EXPECT_EQ(facet_sizes(hull), expected);
    expect_body(points, hull, 199);
  }
}

TEST(ConvexHull, LargeFacetsAreNotQuadratic) {
  // Hundreds of millions of triangles, if each new corner replaced all those of its facet.
  const ConvexHull hull = convex_hull(prism(20000));
  EXPECT_EQ(facet_count(hull), 20002u);
}

TEST(ConvexHull, ConeWithManyPointsOnItsRays) {
  // Integer rays from the apex, with points along each: all but the apex and the last of each ray are inside edges.
  Points points{{0, 0, 0}};
  std::size_t rays = 0;
  for (std::int64_t x = -65; x <= 65; ++x) {
    for (std::int64_t y = -65; y <= 65; ++y) {
      if (x * x + y * y != 65 * 65) continue;
      ++rays;
      for (std::int64_t t = 1; t <= 50; ++t) points.push_back(to_points({{t * x, t * y, t * 65}})[0]);
    }
  }
  ASSERT_EQ(rays, 36u);
  const ConvexHull hull = convex_hull(points);
  EXPECT_EQ(hull.vertices.size(), rays + 1);
  EXPECT_EQ(facet_sizes(hull), (std::map<std::size_t, int>{{3, 36}, {36, 1}}));
  EXPECT_EQ(neighbours(hull, 0).size(), rays);
  expect_body(points, hull, 1);
}

TEST(ConvexHull, CylinderAndCubeSurface) {
  Random random(52);
  Points cylinder, cube;
  for (int i = 0; i < 3000; ++i) {
    const double angle = random.uniform(0, 7);
    cylinder.push_back({std::cos(angle), std::sin(angle), random.below(3) == 0 ? 1 : random.unit()});
    double coordinates[] = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    coordinates[random.below(3)] = random.below(2) == 0 ? -1 : 1;
    cube.push_back({coordinates[0], coordinates[1], coordinates[2]});
  }
  const ConvexHull of_cylinder = convex_hull(cylinder);
  EXPECT_GT(facet_sizes(of_cylinder).rbegin()->first, 500u);
  expect_body(cylinder, of_cylinder, 61);
  const ConvexHull of_cube = convex_hull(cube);
  EXPECT_GT(facet_sizes(of_cube).rbegin()->first, 10u);
  expect_body(cube, of_cube, 1);
}

TEST(ConvexHull, MomentCurve) {
  Points points;
  for (int i = 0; i < 5000; ++i) {
    const double t = i / 5000.0;
    points.push_back({t, t * t, t * t * t});
  }
  const ConvexHull hull = convex_hull(points);
  EXPECT_GT(hull.vertices.size(), 4900u);
  expect_body(points, hull, 499);
}

TEST(ConvexHull, BigGrid) {
  const ConvexHull hull = convex_hull(to_points(grid(30)));
  EXPECT_EQ(hull.vertices.size(), 8u);
  EXPECT_EQ(facet_sizes(hull), (std::map<std::size_t, int>{{4, 6}}));
}

}  // namespace
}  // namespace sunder::solid
