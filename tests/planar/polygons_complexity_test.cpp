// How the probes of the set questions about polygons grow. Shamos & Hoey 1976, Theorems 6 and 7.
//
// convex_polygons_any_by_sweep, N polygons of k vertices: at most
//   N (log2 N + 2) (2 log2 k + 7)   for the places of those that enter, each by halvings of two chains, and
//   3 N (14 log2 k + 26)            for tests of neighbours, two when a polygon enters and one when it leaves.
// polygons_any_by_sweep, n edges, nothing allowed: at most n (log2 n + 2) comparisons for places, and 3 n tests.
// By grid, and by boxes, on local data that does not meet: linear. By boxes where that is not so: 65 n more than by
// sweep (the grid does not pay there).
#include <sunder/base/random.h>
#include <sunder/planar/polygons/convex_polygons_any.h>
#include <sunder/planar/polygons/polygons_any.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace sunder::tests {
namespace {

using planar::ConvexPolygon;
using planar::Polygon;
using Ring = std::vector<Point2>;

// k points of an ellipse around c, with the half axes a and b, the first of them along (1, slope).
Ring ellipse(const Point2& c, double a, double b, double slope, std::size_t k) {
  Ring ring;
  const double length = std::sqrt(1 + slope * slope), x = 1 / length, y = slope / length;
  for (std::size_t v = 0; v < k; ++v) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(v) + 0.5) / static_cast<double>(k);
    const double along = a * std::cos(angle), across = b * std::sin(angle);
    ring.push_back({c.x + along * x - across * y, c.y + along * y + across * x});
  }
  return ring;
}

// Slivers above one another, whose boxes all meet; or ellipses of a jittered lattice.
std::vector<Ring> slivers(std::size_t n, std::size_t k, Random& random) {
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < n; ++i) {
    const double shift = random.unit();
    rings.push_back(ellipse({shift, static_cast<double>(i) + shift}, 40 * static_cast<double>(n), 0.2, 1, k));
  }
  return rings;
}
std::vector<Ring> lattice(std::size_t n, std::size_t k, Random& random) {
  std::vector<Ring> rings;
  const std::size_t side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 c{static_cast<double>(i % side) + 0.1 * random.unit(), static_cast<double>(i / side)};
    rings.push_back(ellipse(c, 0.4, 0.1 + 0.3 * random.unit(), random.uniform(-2, 2), k));
  }
  return rings;
}

// A comb whose teeth, of this length, point along (1, 1); or one whose teeth point downwards, between those.
Ring comb(std::size_t teeth, double length, bool from_above) {
  Ring ring;
  const auto add = [&](double along, double across) {
    const double u = from_above ? length + 1 - along : along, v = from_above ? across + 1 : across;
    ring.push_back({u - v, u + v});
  };
  for (std::size_t i = 0; i < teeth; ++i) {
    const double at = 2 * static_cast<double>(i);
    for (const auto& [along, across] : {Point2{0, at}, {length, at}, {length, at + 0.5}, {0, at + 0.5}})
      add(along, across);
  }
  add(-1, 2 * static_cast<double>(teeth));
  add(-1, 0);
  return ring;
}

TEST(PolygonsComplexity, ConvexPolygonsBySweep) {
  std::printf("%-8s %6s %5s %10s %8s\n", "family", "N", "k", "probes", "of most");
  for (const bool local : {true, false}) {
    for (const std::size_t k : {3u, 16u, 256u}) {
      for (std::size_t n = 4; n * k <= 700000; n *= 4) {
        Random random(20261126);
        std::vector<ConvexPolygon> polygons;
        for (const Ring& ring : local ? lattice(n, k, random) : slivers(n, k, random)) {
          polygons.push_back(ConvexPolygon::hull_of(ring));
        }
        const planar::ConvexPolygonsAnswer answer = planar::convex_polygons_any_by_sweep(polygons);
        ASSERT_FALSE(answer.meet());
        const double count = static_cast<double>(n), log_k = std::log2(static_cast<double>(k));
        const double most = count * (std::log2(count) + 2) * (2 * log_k + 7) + 3 * count * (14 * log_k + 26);
        const double probes = static_cast<double>(answer.cost.probes);
        std::printf("%-8s %6zu %5zu %10.0f %8.3f\n", local ? "lattice" : "slivers", n, k, probes, probes / most);
        EXPECT_LE(probes, most);
        if (!local) continue;
        const planar::ConvexPolygonsAnswer grid = planar::convex_polygons_any_by_grid(polygons);
        EXPECT_FALSE(grid.meet());
        EXPECT_LE(static_cast<double>(grid.cost.probes), 4 * count * (14 * log_k + 26));
      }
    }
  }
}

TEST(PolygonsComplexity, PolygonsBySweep) {
  std::printf("%-8s %7s %10s %8s\n", "family", "n", "probes", "of most");
  for (const bool local : {true, false}) {
    for (std::size_t count = 2; count <= 40000; count *= 4) {
      Random random(20261127);
      std::vector<Polygon> polygons;
      for (const Ring& ring : local ? lattice(count, 16, random) : slivers(count, 16, random)) {
        polygons.emplace_back(std::vector<Ring>{ring});
      }
      const double n = 16 * static_cast<double>(count), most = n * (std::log2(n) + 2) + 3 * n;
      const planar::PolygonsAnswer answer = planar::polygons_any_by_sweep(polygons);
      ASSERT_FALSE(answer.meet());
      const double probes = static_cast<double>(answer.cost.probes);
      std::printf("%-8s %7.0f %10.0f %8.3f\n", local ? "lattice" : "slivers", n, probes, probes / most);
      EXPECT_LE(probes, most);
      const planar::PolygonsAnswer boxes = planar::polygons_any_by_boxes(polygons);
      EXPECT_FALSE(boxes.meet());
      EXPECT_LE(static_cast<double>(boxes.cost.probes), local ? 4 * n : 65 * n + most);
      if (!local) continue;
      const planar::PolygonsAnswer grid = planar::polygons_any_by_grid(polygons);
      EXPECT_FALSE(grid.meet());
      EXPECT_LE(static_cast<double>(grid.cost.probes), 4 * n);
    }
  }
}

// Of two polygons, too: all runs of edges of the one are near all of the other.
TEST(PolygonsComplexity, OfTwoCombs) {
  std::printf("%-8s %7s %10s %8s\n", "family", "n", "probes", "of most");
  for (std::size_t teeth = 8; teeth <= 32768; teeth *= 8) {
    const double length = 4 * static_cast<double>(teeth);
    const std::vector<Polygon> polygons{Polygon(std::vector<Ring>{comb(teeth, length, false)}),
                                        Polygon(std::vector<Ring>{comb(teeth, length, true)})};
    const planar::PolygonsAnswer answer = planar::polygons_any_by_boxes(polygons);
    EXPECT_FALSE(answer.meet());
    const double n = 2 * static_cast<double>(polygons[0].size()), most = 65 * n + n * (std::log2(n) + 2) + 3 * n;
    const double probes = static_cast<double>(answer.cost.probes);
    std::printf("%-8s %7.0f %10.0f %8.3f\n", "combs", n, probes, probes / most);
    EXPECT_LE(probes, most);
  }
}

}  // namespace
}  // namespace sunder::tests
