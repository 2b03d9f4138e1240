// Counted probes of the methods for two convex polygons: a constant times log2 n + log2 m, from 2^3 to 2^20 vertices.
#include <tests/support/planar_pairs.h>

#include <sunder/planar/pair/polygon_polygon.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace sunder::tests {
namespace {

using planar::ConvexPolygon;
using planar::Pose;

// Probes are at most factor (log2 n + log2 m) + constant.
struct Bounded {
  const char* name;
  PairAnswer (*method)(const ConvexPolygon&, const Pose&, const ConvexPolygon&, const Pose&);
  double factor, constant;
};
constexpr std::array bounded_methods{Bounded{"front door", planar::polygon_polygon, 7, 24},
                                     Bounded{"difference", planar::polygon_polygon_by_difference, 4, 8},
                                     Bounded{"halving", planar::polygon_polygon_by_halving, 20, 20},
                                     Bounded{"triangles", planar::polygon_polygon_by_triangles, 3, 20}};

ConvexPolygon polygon_on_ellipse(std::uint32_t n, double wide, double high) {
  std::vector<Point2> points;
  const ConvexPolygon round = regular_polygon(n, 1, 0.123);
  for (const Point2& p : round.vertices()) points.push_back({p.x * wide, p.y * high});
  return ConvexPolygon::hull_of(points);
}

TEST(PlanarPairComplexity, ProbesGrowAsTheSumOfLogarithms) {
  std::printf("%8s %8s", "n", "m");
  for (const Bounded& b : bounded_methods) std::printf("  %12s: mean, most", b.name);
  std::printf("\n");
  std::vector<ConvexPolygon> small;
  for (const std::uint32_t m : {1u, 2u, 3u, 8u}) small.push_back(regular_polygon(m, 1, 0.3));
  for (std::uint32_t n = 8; n <= 1u << 20; n *= 2) {
    const ConvexPolygon a = regular_polygon(n), alike = polygon_on_ellipse(n, 1.5, 0.7);
    std::vector<const ConvexPolygon*> others{&alike};
    for (const ConvexPolygon& s : small) others.push_back(&s);
    for (const ConvexPolygon* b : others) {
      const double logs = std::log2(a.size()) + std::log2(b->size());
      std::array<double, bounded_methods.size()> sum{}, most{};
      int count = 0, meet = 0;
      Random random(71);
      for (int k = 0; k < 60; ++k) {
        // Apart, near, overlapping, contained: as the distance has it; a reflection now and then.
        const double far = k % 3 == 0 ? random.uniform(0, 0.5) : random.uniform(0.5, 3), towards = random.uniform(0, 7);
        const double turn = random.uniform(0, 7), c = std::cos(turn), s = std::sin(turn), sign = k % 4 == 0 ? -1 : 1;
        const Pose there =
            Pose::from_matrix({c, -sign * s, s, sign * c}, {far * std::cos(towards), far * std::sin(towards)});
        ++count;
        for (std::size_t i = 0; i < bounded_methods.size(); ++i) {
          const PairAnswer answer = bounded_methods[i].method(a, Pose(), *b, there);
          const auto probes = static_cast<double>(answer.cost.probes);
          sum[i] += probes;
          most[i] = std::max(most[i], probes);
          meet += i == 0 && answer.meet() ? 1 : 0;
          ASSERT_LE(probes, bounded_methods[i].factor * logs + bounded_methods[i].constant)
              << bounded_methods[i].name << " n " << a.size() << " m " << b->size() << " k " << k;
        }
      }
      EXPECT_GT(meet, count / 10);
      EXPECT_LT(meet, count - count / 10);
      std::printf("%8u %8u", a.size(), b->size());
      for (std::size_t i = 0; i < bounded_methods.size(); ++i) std::printf("  %18.1f %5.0f", sum[i] / count, most[i]);
      std::printf("\n");
    }
  }
}

}  // namespace
}  // namespace sunder::tests
