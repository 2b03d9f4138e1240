// Kernels of all kinds, all methods against the oracle, and how the number of signs grows.
#include <sunder/base/error.h>
#include <sunder/planar/region/kernel.h>
#include <tests/support/scale.h>
#include <tests/support/simple_polygons.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace sunder::planar {
namespace {

using tests::SimplePolygons;

constexpr RegionOptions with_cones{true};

Polygon polygon_of(const std::vector<Point2>& ring) { return Polygon(std::vector<std::vector<Point2>>{ring}); }

// K1, K2.
Region kernel_by_all(const Polygon& polygon) {
  const PolygonSides sides(polygon);
  const Region scan = kernel_by_scan(sides, with_cones);
  EXPECT_TRUE(check(sides, scan));
  for (const auto method :
       {kernel, kernel_by_half_plane_intersection, kernel_by_lee_preparata, half_plane_intersection<PolygonSides>}) {
    const Region region = method(sides, with_cones);
    EXPECT_EQ(name_of(region.kind), name_of(scan.kind));
    if (!scan.empty()) {
      EXPECT_EQ(region.sides, scan.sides) << name_of(scan.kind);
    }
    EXPECT_TRUE(check(sides, region));
    EXPECT_TRUE(method(sides, {}).cones.empty());
  }
  return scan;
}

void expect_kernel(const std::vector<Point2>& ring, RegionKind kind, const std::vector<std::uint32_t>& sides) {
  const Region region = kernel_by_all(polygon_of(ring));
  EXPECT_EQ(name_of(region.kind), name_of(kind));
  EXPECT_EQ(region.sides, sides);
}

TEST(KernelTest, Examples) {
  expect_kernel({{0, 0}, {1, 0}, {0, 1}}, RegionKind::bounded, {1, 2, 0});
  expect_kernel({{0, 0}, {0, 1}, {1, 0}}, RegionKind::bounded, {1, 0, 2});
  expect_kernel({{0, 0}, {1, 0}, {2, 0}, {0, 1}}, RegionKind::bounded, {2, 3, 0});
  // An L: the square at its bend.
  expect_kernel({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, RegionKind::bounded, {3, 2, 5, 0});
  // A battlement: nothing sees into both of its outer parts.
  const Region u = kernel_by_all(polygon_of({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}));
  EXPECT_TRUE(u.empty());
  EXPECT_EQ(u.sides.size(), 2u);
  // A pinwheel whose blades have an edge each on one of the axes: its kernel is the origin.
  const Region point =
      kernel_by_all(polygon_of({{0, 0.5}, {-2, 1}, {-0.5, 0}, {-1, -2}, {0, -0.5}, {2, -1}, {0.5, 0}, {1, 2}}));
  EXPECT_EQ(point.kind, RegionKind::bounded);
}

TEST(KernelTest, WhatHasNoKernelIsRefused) {
  const auto place = [](const std::vector<std::vector<Point2>>& rings) {
    const Polygon polygon(rings);
    try {
      const PolygonSides sides(polygon);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_shape);
      return error.place();
    }
    return std::string("none");
  };
  EXPECT_EQ(place({{{0, 0}, {1, 0}, {0, 1}}}), "none");
  EXPECT_EQ(place({{{0, 0}, {9, 0}, {0, 9}}, {{1, 1}, {2, 1}, {1, 2}}}), "");
  EXPECT_EQ(place({{{0, 0}, {1, 0}, {1, 0}, {0, 1}}}), "vertex 1");
  EXPECT_EQ(place({{{1, 1}, {2, 2}, {0, 0}, {3, 3}}}), "vertex 2");
}

TEST(KernelTest, MethodsAgreeWithTheScan) {
  const int count = tests::scaled_count(4000);
  SimplePolygons polygons(tests::chosen_seed(20261204));
  std::map<RegionKind, int> kinds;
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    const Polygon polygon = polygons.next();
    SCOPED_TRACE(std::to_string(i) + " " + std::string(name_of(polygons.family())));
    const Region region = kernel_by_all(polygon);
    ++kinds[region.kind];
    const bool is_flat = region.kind == RegionKind::point || region.kind == RegionKind::segment;
    if (region.empty()) continue;  // it may be flat in between
    EXPECT_EQ(kernel_by_lee_preparata(PolygonSides(polygon)).cost.iterations, is_flat ? 1u : 0u);
  }
  if (count < 4000) return;
  for (const auto& [kind, times] : kinds) std::printf("%-10s %6d\n", std::string(name_of(kind)).c_str(), times);
  for (const RegionKind kind : {RegionKind::empty, RegionKind::bounded}) EXPECT_GT(kinds[kind], count / 10);
  for (const RegionKind kind : {RegionKind::point, RegionKind::segment}) EXPECT_GT(kinds[kind], count / 1000);
}

// Not simple: the common part of the half-planes all the same.
TEST(KernelTest, WhatIsNotSimpleDoesNoHarm) {
  const int count = tests::scaled_count(3000);
  SimplePolygons polygons(tests::chosen_seed(20261205));
  int tried = 0;
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    if (i % 64 == 0) polygons.next();  // the family changes
    const Polygon polygon = polygons.candidate();
    try {
      const PolygonSides sides(polygon);
    } catch (const Error&) {
      continue;
    }
    ++tried;
    static_cast<void>(kernel_by_all(polygon));
  }
  if (count >= 3000) {
    EXPECT_GT(tried, count / 4);
  }
}

// Large polygons of some shapes.
Polygon large(int family, std::uint32_t n, Random& random) {
  std::vector<Point2> ring;
  for (std::uint32_t k = 0; k < n; ++k) {
    const double at = k, size = n, t = 6.283185307179586 * at / size;
    if (family == 0) {  // a star
      const double r = random.uniform(1, 2);
      ring.push_back({r * std::cos(t), r * std::sin(t)});
    } else if (family == 1) {  // a comb
      ring.push_back({at, k == 0 || k + 1 == n ? -size : k % 2 == 0 ? 0.0 : 1.0});
    } else if (family == 2) {  // a spiral of twenty turns
      const double there = 2 * k < n ? at : size - 1 - at, turn = 40 * 6.283185307179586 * there / size;
      const double r = (2 * k < n ? 1 : 0.98) * (1 + 0.05 * turn);
      ring.push_back({r * std::cos(turn), r * std::sin(turn)});
    } else {  // a circle with dents
      const double r = k % 3 == 0 ? 1 - 0.01 / (size * size) : 1;
      ring.push_back({r * std::cos(t), r * std::sin(t)});
    }
  }
  return polygon_of(ring);
}

// Complexity: a constant number of signs for each vertex (Lee & Preparata), of any shape.
TEST(KernelTest, SignsGrowAsN) {
  std::printf("%-8s %8s %10s %10s\n", "family", "N", "lee/N", "front/N");
  for (int power = 4; power <= 17; ++power) {
    for (int family = 0; family < 4; ++family) {
      Random random(20261211);
      const Polygon polygon = large(family, 1u << power, random);
      const PolygonSides sides(polygon);
      const Region lee = kernel_by_lee_preparata(sides, with_cones), front = kernel(sides, with_cones);
      EXPECT_EQ(name_of(lee.kind), name_of(front.kind)) << family << " " << power;
      if (!front.empty()) {
        EXPECT_EQ(lee.sides, front.sides) << family << " " << power;
      }
      EXPECT_EQ(lee.cost.iterations, 0u) << family << " " << power;
      EXPECT_TRUE(check(sides, lee));
      const double n = sides.size();
      if (power % 4 == 1) {
        std::printf("%-8d %8.0f %10.2f %10.2f\n", family, n, static_cast<double>(lee.cost.probes) / n,
                    static_cast<double>(front.cost.probes) / n);
      }
      EXPECT_LT(static_cast<double>(lee.cost.probes), 16 * n) << family << " " << n;
    }
  }
}

}  // namespace
}  // namespace sunder::planar
