#include <sunder/base/random.h>
#include <sunder/polytope/represent/hierarchical_tree.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace sunder::polytope {
namespace {

using ExactDirection = std::vector<Dyadic>;

std::vector<double> numbers_on_sphere(Random& random, std::size_t d, std::size_t count) {
  std::vector<double> rows;
  while (rows.size() < d * count) {
    std::vector<double> p(d);
    double square = 0;
    for (double& x : p) {
      x = random.uniform(-1, 1);
      square += x * x;
    }
    if (square > 1 || square < 0.01) continue;
    for (const double x : p) rows.push_back(x / std::sqrt(square));
  }
  return rows;
}

// Small integers in a cube: many rows on its facets, many repeated.
std::vector<double> numbers_of_grid(Random& random, std::size_t d, std::size_t count) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < d * count; ++k) rows.push_back(static_cast<double>(random.between(-2, 2)));
  return rows;
}

Dyadic product(const Polytope& body, std::uint32_t k, const ExactDirection& direction) {
  Dyadic sum;
  for (std::size_t c = 0; c < direction.size(); ++c) sum = sum + Dyadic(body.row(k)[c]) * direction[c];
  return sum;
}

// Down to the leaves, each walk ends where a scan does; before that, at a row that is no further.
void expect_right(const HierarchicalTree& tree, Random& random, int count, bool small_integers) {
  TreeWalk walk(tree);
  const std::size_t d = tree.dimension();
  const Polytope& body = tree.body();
  for (int i = 0; i < count; ++i) {
    ExactDirection direction;
    for (std::size_t c = 0; c < d; ++c) {
      direction.emplace_back(small_integers ? static_cast<double>(random.between(-2, 2)) : random.uniform(-1, 1));
    }
    std::uint32_t looks = 0;
    Cost cost;
    const Dyadic expected = exactly_furthest_along(body.columns(), direction, looks).product;
    ExactFurthest found = walk.furthest(direction, cost);
    ASSERT_NE((found.product - expected).sign(), Sign::positive);
    if (i == 0) {
      while (walk.deepen()) continue;
    }
    found = walk.furthest(direction, cost);
    ASSERT_EQ((found.product - expected).sign(), Sign::zero) << i;
    ASSERT_EQ((product(body, found.index, direction) - expected).sign(), Sign::zero) << i;
    ASSERT_LE(walk.path().size(), tree.depth());
  }
}

TEST(HierarchicalTree, WalksEndWhereScansDo) {
  Random random(1);
  for (std::size_t d = 2; d <= 6; ++d) {
    const std::size_t count = d < 4 ? 1000 : d == 4 ? 300 : 60;
    const HierarchicalTree tree(Polytope::from_points(d, numbers_on_sphere(random, d, count)));
    SCOPED_TRACE(d);
    EXPECT_GE(tree.depth(), d < 4 ? 2u : d < 6 ? 1u : 0u);
    expect_right(tree, random, 200, false);
    expect_right(tree, random, 200, true);
    std::printf(
        "d %zu: %zu rows, depth %u, %zu nodes, %zu cones, %zu rows of nodes, largest leaf %u, %zu unverified, %zu "
        "samples, %zu KiB, estimated %zu KiB\n",
        d, count, tree.depth(), tree.node_count(), tree.cone_count(), tree.row_count(), tree.largest_leaf(),
        tree.unverified(), tree.samples(), tree.memory() >> 10, tree.estimate() >> 10);
  }
}

TEST(HierarchicalTree, GridsAndRepeatedRows) {
  Random random(2);
  for (std::size_t d = 2; d <= 5; ++d) {
    const std::uint32_t net = static_cast<std::uint32_t>(d) + 4;
    const HierarchicalTree tree(Polytope::from_points(d, numbers_of_grid(random, d, d < 4 ? 200 : 60)),
                                {.net = net, .leaf = 12, .levels = d < 4 ? 2u : 1u});
    EXPECT_GE(tree.depth(), 1u);
    SCOPED_TRACE(d);
    expect_right(tree, random, 200, true);
    expect_right(tree, random, 100, false);
  }
}

}  // namespace
}  // namespace sunder::polytope
