#include <sunder/polytope/hull/double_description_internal.h>
#include <sunder/polytope/hull/pulling.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace sunder::polytope {
namespace {

// The cone over a cross-polytope of d dimensions: +-x1 .. +-xd <= w.
std::vector<Dyadic> cross(std::size_t d, double scale) {
  std::vector<Dyadic> rows;
  for (std::size_t k = 0; k < std::size_t{1} << d; ++k) {
    for (std::size_t c = 0; c < d; ++c) rows.emplace_back((k >> c & 1) == 0 ? scale : -scale);
    rows.emplace_back(scale);
  }
  return rows;
}

TEST(DoubleDescription, RaysOfACrossPolytopeAndTheirNeighbours) {
  for (std::size_t d = 2; d <= 6; ++d) {
    for (const IntegerKind kind : {IntegerKind::words, IntegerKind::any}) {
      const auto cone = double_description(d + 1, cross(d, 0.1), kind);
      ASSERT_TRUE(cone);
      ASSERT_EQ(cone->rays.size(), 2 * d);
      for (std::size_t k = 0; k < 2 * d; ++k) {
        EXPECT_EQ(size_of(cone->on[k]), std::size_t{1} << (d - 1));
        EXPECT_EQ(cone->next[k].size(), 2 * d - 2);  // all but the opposite one
        EXPECT_EQ(cone->rays[k][d], 1);
        Integer sum = 0;
        for (std::size_t c = 0; c < d; ++c) sum += abs(cone->rays[k][c]);
        EXPECT_EQ(sum, 1);
      }
    }
  }
}

TEST(DoubleDescription, LinesAndTheOrigin) {
  const auto half_space = double_description(2, std::vector<Dyadic>{1.0, 0.0}, IntegerKind::words);
  ASSERT_TRUE(half_space);
  EXPECT_TRUE(half_space->has_lines);
  const auto ray = double_description(2, std::vector<Dyadic>{1.0, 0.0, 0.0, 1.0, 0.0, -1.0}, IntegerKind::words);
  ASSERT_TRUE(ray);
  EXPECT_EQ(ray->rays, (std::vector<std::vector<Integer>>{{1, 0}}));
  const auto origin = double_description(2, std::vector<Dyadic>{1.0, 0.0, 0.0, 1.0, -1.0, -1.0}, IntegerKind::words);
  ASSERT_TRUE(origin);
  EXPECT_FALSE(origin->has_lines);
  EXPECT_TRUE(origin->rays.empty());
}

TEST(DoubleDescription, LongIntegersAreForTheOtherKind) {
  const std::vector<Dyadic> rows{1.0, 0x1p70, 1.0, -1.0};
  EXPECT_FALSE(double_description(2, rows, IntegerKind::words));
  const auto cone = double_description(2, rows, IntegerKind::any);
  ASSERT_TRUE(cone);
  EXPECT_EQ(cone->rays.size(), 2u);
}

// A square's two halves, a prism's sides: what neighbours have in common is cut in one way.
TEST(Pulling, SimplicesOfACube) {
  std::vector<Bits> facets;
  std::vector<std::vector<std::uint32_t>> next(6);
  for (std::uint32_t f = 0; f < 6; ++f) {
    facets.push_back(no_bits(8));
    for (std::size_t v = 0; v < 8; ++v) {
      if ((v >> (f / 2) & 1) == f % 2) add(facets[f], v);
    }
    for (std::uint32_t other = 0; other < 6; ++other) {
      if (other / 2 != f / 2) next[f].push_back(other);
    }
  }
  std::vector<std::vector<std::uint32_t>> simplices;
  ASSERT_TRUE(pulled_simplices(3, facets, next, 12, simplices));
  std::vector<std::vector<std::uint32_t>> edges;  // of the triangles: each twice
  for (const auto& of_facet : simplices) {
    EXPECT_EQ(of_facet.size(), 6u);
    for (std::size_t k = 0; k < of_facet.size(); k += 3) {
      for (std::size_t i = 0; i < 3; ++i) {
        edges.push_back({of_facet[k + i], of_facet[k + (i + 1) % 3]});
        std::sort(edges.back().begin(), edges.back().end());
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  ASSERT_EQ(edges.size(), 36u);
  for (std::size_t k = 0; k < edges.size(); k += 2) EXPECT_EQ(edges[k], edges[k + 1]);
  EXPECT_EQ(std::unique(edges.begin(), edges.end()) - edges.begin(), 18);
  std::vector<std::vector<std::uint32_t>> too_many;
  EXPECT_FALSE(pulled_simplices(3, facets, next, 11, too_many));
}

}  // namespace
}  // namespace sunder::polytope
