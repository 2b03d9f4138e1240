// The extreme vertex down bounded hierarchies, against all vertices, ties included; and B5 and the probes of the walk,
// whose constants are measured.
#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <sunder/base/random.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/bounded_hierarchy.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace sunder::tests {
namespace {

using namespace solid;

// At most 1.5 times the greatest that was measured at n = 1,000.
constexpr double most_levels = 3;     // times log2 n
constexpr double most_vertices = 20;  // of all levels together, times n
constexpr double most_probes = 7.5;   // times log2 n
constexpr double most_degree = 48;    // of a level but P_1

bool is_extreme(const ConvexPolyhedron& body, const Point3& d, std::uint32_t v) {
  const WorldDirection direction(d);
  const Affine3 identity;
  Along along(direction, identity, false);
  return std::all_of(body.vertices().begin(), body.vertices().end(),
                     [&](const Point3& p) { return along.compare(body.vertices()[v], p) != Sign::positive; });
}

struct Asked {
  std::uint32_t vertex = 0;
  std::uint64_t probes = 0;
  StageTally tally;
};

Asked extreme(const ConvexPolyhedron& body, const Point3& d, End end = End::greatest) {
  const Pose pose;
  const Placed placed(body, pose);
  const WorldDirection direction(d);
  Along along(direction, placed.pose, placed.tame);
  Asked asked;
  Cost cost;
  asked.vertex = extreme_vertex_by_bounded(placed, along, end, cost, asked.tally);
  asked.probes = cost.probes;
  return asked;
}

// Directions that tie: axes, and small whole numbers, which are normals of grids; and nearly these.
Point3 some_direction(Random& random, int i) {
  if (i % 3 == 0) return on_sphere(random);
  const auto part = [&] { return static_cast<double>(random.below(5)) - 2; };
  if (i % 3 == 1) return {part(), part(), part()};
  const Point3 d{part(), part(), part()};
  return {d.x + std::ldexp(1.0, -50) * part(), d.y, d.z + std::ldexp(1.0, -52) * part()};
}

TEST(SolidBoundedComplexity, TheWalkEndsAtAnExtremeVertex) {
  Random random(chosen_seed(137));
  StageTally tally;
  for (const SolidShape& shape : all_solid_shapes()) {
    SCOPED_TRACE(shape.name);
    for (const std::size_t n : {8u, 20u, 100u, 1000u}) {
      const ConvexPolyhedron body(shape.make(n, random));
      if (body.dimension() < 2) continue;
      const int times = scaled_count(n < 1000 ? 150 : 60);
      for (int i = 0; i < times; ++i) {
        const Point3 d = some_direction(random, i);
        const Asked asked = extreme(body, d);
        tally.rounded += asked.tally.rounded;
        tally.exact += asked.tally.exact;
        ASSERT_TRUE(is_extreme(body, d, asked.vertex)) << n << ' ' << d.x << ' ' << d.y << ' ' << d.z;
        ASSERT_TRUE(is_extreme(body, {-d.x, -d.y, -d.z}, extreme(body, d, End::least).vertex)) << n;
      }
    }
  }
  EXPECT_GT(tally.rounded, tally.exact);
}

// What a question costs of each hierarchy, the greatest, in probes over log2 n.
struct Cures {
  double by_bounded = 0, by_sectors = 0;
};
Cures greatest_probes(const ConvexPolyhedron& body, Random& random) {
  const double log_n = std::log2(std::max<double>(static_cast<double>(body.vertices().size()), 8));
  const Pose pose;
  const Placed placed(body, pose);
  Cures greatest;
  for (int i = 0; i < 200; ++i) {
    // Towards a vertex, too.
    const Point3& v = body.vertices()[random.below(body.vertices().size())];
    const Point3 d = i % 4 == 3 ? v : some_direction(random, i);
    greatest.by_bounded = std::max(greatest.by_bounded, static_cast<double>(extreme(body, d).probes) / log_n);
    const WorldDirection direction(d);
    Along along(direction, placed.pose, placed.tame);
    Cost cost;
    StageTally tally;
    extreme_vertex_of_ranks(placed, along, End::greatest, Hierarchy::none, cost, tally);
    greatest.by_sectors = std::max(greatest.by_sectors, static_cast<double>(cost.probes) / log_n);
  }
  return greatest;
}

template <class Make>
double microseconds(const Make& make) {
  const auto begin = std::chrono::steady_clock::now();
  make();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
}

// B5, B3 beyond what is proved, and the probes of the walk; of both cures of high degrees
// (docs/design/bounded-hierarchy.md has the table).
TEST(SolidBoundedComplexity, CountsAndProbesGrowAsThePaperSays) {
  Random random(chosen_seed(131));
  for (const std::size_t n : {100u, 1000u, 16384u, 131072u}) {
    if (n > 1000 && scaled_count(1000) < (n < 20000 ? 500 : 5000)) continue;
    double probes = 0, levels = 0, all_vertices = 0, all_degree = 0;
    for (const SolidShape& shape : all_solid_shapes()) {
      SCOPED_TRACE(shape.name);
      const ConvexPolyhedron body(shape.make(n, random));
      if (body.dimension() < 2) continue;
      const Cures cures = greatest_probes(body, random);
      probes = std::max(probes, cures.by_bounded);
      if (body.dimension() < 3 || body.vertices().size() < 64) continue;
      const double size = static_cast<double>(body.vertices().size());
      BoundedHierarchy h;
      Hierarchy plain;
      const double time = microseconds([&] { h = BoundedHierarchy::make(body); }) / size;
      const double time_of_plain = microseconds([&] { plain = Hierarchy::make(body); }) / size;
      double vertices = 0, degree = 0;  // of all levels; the greatest of those below P_1
      for (std::size_t i = 0; i < h.levels.size(); ++i) {
        vertices += h.levels[i].size / size;
        if (i + 1 < h.levels.size()) degree = std::max<double>(degree, h.levels[i].greatest_degree);
      }
      std::printf(
          "| %-13.*s | %6.0f | %3zu, %3zu | %4.1f, %4.1f | %4.0f, %4.0f | %5.2f, %5.2f | %5.2f | %4.2f | %3.0f |\n",
          static_cast<int>(shape.name.size()), shape.name.data(), size, h.levels.size(), plain.level_end.size(),
          cures.by_bounded, cures.by_sectors, static_cast<double>(h.memory()) / size,
          static_cast<double>(plain.memory()) / size, time, time_of_plain, vertices,
          static_cast<double>(h.copies.size()) / size, degree);
      levels = std::max(levels, static_cast<double>(h.levels.size()) / std::log2(size));
      all_vertices = std::max(all_vertices, vertices);
      all_degree = std::max(all_degree, degree);
    }
    std::printf("n = %zu: at most %.2f log2 n levels, %.2f n vertices, degree %.0f, %.2f log2 n probes\n", n, levels,
                all_vertices, all_degree, probes);
    EXPECT_LE(levels, most_levels) << n;
    EXPECT_LE(all_vertices, most_vertices) << n;
    EXPECT_LE(all_degree, most_degree) << n;
    EXPECT_LE(probes, most_probes) << n;
  }
}

}  // namespace
}  // namespace sunder::tests
