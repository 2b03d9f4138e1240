#include <sunder/polytope/pair/hyperplanes.h>

#include <sunder/base/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

namespace sunder::polytope {
namespace {

Polytope ball(Random& random, std::size_t d, std::size_t count) {
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
  return Polytope::from_points(d, std::move(rows));
}

Pose moved(std::size_t d, double by) {
  std::vector<double> linear(d * d), translation(d);
  for (std::size_t c = 0; c < d; ++c) linear[c * d + c] = 1;
  translation[0] = by;
  return Pose::from_matrix(d, linear, translation);
}

TEST(Hyperplanes, AreOfShellSimplicesFromAGapOnAndAsManyAsTheTreesAreDeep) {
  Random random(6301);
  for (const std::size_t d : {2u, 3u, 4u}) {
    for (const std::size_t n : {100u, 1000u}) {
      if (d == 4 && n == 1000) continue;
      const HierarchicalTree a(ball(random, d, n)), b(ball(random, d, n));
      int by_shells = 0, apart = 0;
      for (int k = 0; k <= 20; ++k) {
        const Pose here(d), there = moved(d, 1.9 + 0.05 * k);
        const PolytopeAnswer answer = polytope_polytope_by_columns(a, here, b, there);
        if (answer.meet()) continue;
        ++apart;
        const HyperplaneEvidence evidence = parting_hyperplanes(a, here, b, there, answer);
        EXPECT_TRUE(check(a.body(), here, b.body(), there, evidence));
        const bool are_shells = evidence.a.are_shells && evidence.b.are_shells;
        by_shells += are_shells;
        for (const auto& [tree, around] : {std::pair(&a, &evidence.a), std::pair(&b, &evidence.b)}) {
          EXPECT_LE(around->planes.size(), d * tree->depth() + !are_shells);            // Y1
          EXPECT_LE(around->planes.size(), static_cast<double>(d) * std::log2(n) + 1);  // H3
          EXPECT_GE(around->planes.size(), d);
        }
        EXPECT_LE(evidence.a.multipliers.parts.size() + evidence.b.multipliers.parts.size(), d + 1);  // Y2
      }
      std::printf("d %zu, n %zu: %d apart, %d by shell-simplices alone; depth %u\n", d, n, apart, by_shells, a.depth());
      EXPECT_GT(by_shells, apart / 4);
    }
  }
}

}  // namespace
}  // namespace sunder::polytope
