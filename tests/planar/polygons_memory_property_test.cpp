// How much memory it takes to count pairs of polygons that meet, where there are too many to be kept: the greatest
// number of live bytes, counted where they are allocated.
#include <tests/support/live_bytes.h>
#include <tests/support/shapes.h>

#include <sunder/planar/polygons/polygons_all.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <vector>

namespace sunder::tests {
namespace {

using planar::Polygon;
using planar::PolygonsCountAnswer;

// Triangles around one point, each `width` slices wide.
std::vector<Polygon> pie(std::uint32_t slices, std::uint32_t width) {
  std::vector<Polygon> polygons;
  const double n = slices;
  for (std::uint32_t k = 0; k < slices; ++k) {
    const Point2 from = on_circle(k / n, 100), to = on_circle((k + width) % slices / n, 100);
    polygons.emplace_back(std::vector<std::vector<Point2>>{{{0, 0}, from, to}});
  }
  return polygons;
}

PolygonsCountAnswer counted(const std::vector<Polygon>& polygons, const SetOptions& options = {}) {
  const std::int64_t before = live;
  most = live;
  const PolygonsCountAnswer answer = polygons_count(polygons, options);
  std::printf("%zu polygons: %.1f MB\n", polygons.size(), static_cast<double>(most - before) / 1e6);
  if (!SUNDER_UNDER_THREAD_SANITIZER) {
    EXPECT_GT(most - before, 1'000'000);  // else nothing was counted
  }
  EXPECT_LT(most - before, 48'000'000) << "of " << polygons.size();
  return answer;
}

TEST(PolygonsMemory, CountingKeepsNoPairs) {
  for (const std::uint32_t n : {1000u, 4000u}) {
    const PolygonsCountAnswer slices = counted(pie(n, 1));
    EXPECT_EQ(slices.count.touching, std::uint64_t{n} * (n - 1) / 2);
    EXPECT_EQ(slices.count.overlapping, 0u);
    const PolygonsCountAnswer wide = counted(pie(n, 3));  // each overlaps two after it, and two before
    EXPECT_EQ(wide.count.overlapping, std::uint64_t{n} * 2);
    EXPECT_EQ(wide.count.touching, std::uint64_t{n} * (n - 1) / 2 - std::uint64_t{n} * 2);
    std::vector<std::uint32_t> groups;
    for (std::uint32_t i = 0; i < n; ++i) groups.push_back(i % 4);
    const PolygonsCountAnswer across = counted(pie(n, 3), {Allowed::nothing, groups, nullptr});
    EXPECT_EQ(across.count.overlapping, std::uint64_t{n} * 2);
    EXPECT_EQ(across.count.touching, std::uint64_t{n} * n * 3 / 8 - std::uint64_t{n} * 2);
  }
}

}  // namespace
}  // namespace sunder::tests
