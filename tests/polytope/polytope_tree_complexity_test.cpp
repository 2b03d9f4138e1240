// What pairs by hierarchical trees cost, counted: each look at a cone, an apex or a row of a leaf, and of the scan each
// row at each pivot. And what trees take: verified nets, their depth, and how their size grows.
#include <sunder/base/random.h>
#include <sunder/polytope/pair/polytope_polytope.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using polytope::HierarchicalTree;
using polytope::Polytope;
using polytope::PolytopeAnswer;
using polytope::Pose;

// Points of the unit sphere, or half-spaces that touch it.
Polytope round_body(Random& random, std::size_t d, std::size_t count, bool of_points) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < count;) {
    std::vector<double> p(d);
    double square = 0;
    for (double& x : p) {
      x = random.uniform(-1, 1);
      square += x * x;
    }
    if (square > 1 || square < 0.01) continue;
    ++k;
    for (double& x : p) x /= std::sqrt(square);
    rows.insert(rows.end(), p.begin(), p.end());
    if (!of_points) rows.push_back(1);
  }
  return of_points ? Polytope::from_points(d, std::move(rows)) : Polytope::from_half_spaces(d, std::move(rows));
}

struct Work {
  double mean = 0, scan = 0, front_door = 0;
  std::uint64_t most = 0;
  int meets = 0, scanned = 0, by_filter = 0;
  std::uint32_t depth = 0;
  std::size_t memory = 0, unverified = 0;
};

// Pairs from far into one another to apart.
Work work_of(std::size_t d, std::size_t count, int pairs, bool half_spaces, bool with_scan) {
  Random random(20150616 + d);
  Work work;
  const Pose here(d);
  for (int k = 0; k < pairs; ++k) {
    const HierarchicalTree a(round_body(random, d, count, true));
    const double shift = 0.7 + 1.8 * k / (pairs - 1);
    std::vector<double> linear(d * d), translation(d);
    for (std::size_t c = 0; c < d; ++c) linear[c * d + c] = 1;
    translation[0] = shift;
    const Pose there = Pose::from_matrix(d, linear, translation);
    const HierarchicalTree b(round_body(random, d, count, !half_spaces));
    const PolytopeAnswer answer = polytope_polytope_by_columns(a, here, b, there);
    const PolytopeAnswer other = polytope_polytope(a.body(), here, b.body(), there);
    EXPECT_EQ(answer.meet(), other.meet());
    work.front_door += static_cast<double>(other.cost.probes) / pairs;
    if (with_scan) {
      const PolytopeAnswer scan = polytope_polytope_by_scan(a.body(), here, b.body(), there);
      EXPECT_EQ(answer.meet(), scan.meet());
      work.scan += static_cast<double>(scan.cost.probes) / pairs;
    }
    work.meets += answer.meet();
    work.scanned += answer.decided_by == DecidedBy::finishing;
    work.by_filter += answer.decided_by == DecidedBy::filter;
    work.mean += static_cast<double>(answer.cost.probes) / pairs;
    work.most = std::max(work.most, answer.cost.probes);
    work.depth = std::max({work.depth, a.depth(), b.depth()});
    work.memory = std::max({work.memory, a.memory(), b.memory()});
    work.unverified += a.unverified() + b.unverified();
  }
  std::printf(
      "d %zu, %5zu %s: %6.0f looks in the mean, %5.0f at most; the front door %.0f, the scan %.0f; %d of %d meet; "
      "depth %u, %zu KiB, %zu cones "
      "unverified\n",
      d, count, half_spaces ? "points and half-spaces" : "points", work.mean, static_cast<double>(work.most),
      work.front_door, work.scan, work.meets, pairs, work.depth, work.memory >> 10, work.unverified);
  EXPECT_GT(work.meets, 0);
  EXPECT_LT(work.meets, pairs);
  EXPECT_EQ(work.scanned, 0);
  if (!half_spaces) {
    EXPECT_GE(work.by_filter, pairs * 3 / 4);  // of walks in floating point alone
  }
  return work;
}

TEST(PolytopeTreeComplexity, InThePlaneAndInSpaceAHundredTimesTheRowsAreThreeTimesTheLooks) {
  for (const std::size_t d : {2u, 3u}) {
    const Work few = work_of(d, 100, 12, false, false), many = work_of(d, 10000, 4, false, false);
    EXPECT_LE(many.mean, 3 * few.mean);
    EXPECT_LE(many.most, 3 * few.most);
    EXPECT_GE(few.depth, 2u);
    EXPECT_GT(many.depth, few.depth);
    EXPECT_LE(many.memory, std::size_t{1} << 30);
    EXPECT_EQ(few.unverified + many.unverified, 0u);
  }
}

TEST(PolytopeTreeComplexity, SoItIsWithHalfSpaces) {
  const Work few = work_of(2, 100, 12, true, false), many = work_of(2, 3000, 4, true, false);
  EXPECT_EQ(few.unverified + many.unverified, 0u);
  EXPECT_LE(many.mean, 3 * few.mean);
}

// The scan looks at each row at each pivot. The front door looks at samples of rows first: in four dimensions trees
// save half of its looks, and of 60 rows in five dimensions a walk looks at half, and so do all.
TEST(PolytopeTreeComplexity, InFourAndFiveDimensionsAFifthOfTheScan) {
  const Work four = work_of(4, 300, 6, false, true);
  EXPECT_LE(5 * four.mean, four.scan);
  EXPECT_LE(2 * four.mean, four.front_door);
  EXPECT_GE(four.depth, 1u);
  EXPECT_EQ(four.unverified, 0u);
  const Work five = work_of(5, 60, 8, false, true);
  EXPECT_LE(5 * five.mean, five.scan);
  EXPECT_LE(five.mean, five.front_door);
  EXPECT_GE(five.depth, 1u);
  EXPECT_EQ(five.unverified, 0u);
}

// Rows of all nodes, which lists take, by c n^e: the paper has e = floor(d / 2) + delta.
TEST(PolytopeTreeComplexity, SizesGrowNoFasterThanThePaperSays) {
  struct Sizes {
    std::size_t d;
    std::vector<std::size_t> counts;
    double most;         // of the exponent
    std::uint32_t leaf;  // small, so that there are levels
  };
  for (const auto& [d, counts, most, leaf] :
       {Sizes{2, {100, 1000, 10000}, 1.25, 8}, Sizes{3, {100, 1000, 10000}, 1.5, 16},
        Sizes{4, {100, 300, 900}, 2.5, 48}}) {
    Random random(20150617 + d);
    std::vector<double> x, y;
    for (const std::size_t n : counts) {
      const HierarchicalTree tree(round_body(random, d, n, true), {.leaf = leaf});
      x.push_back(std::log(static_cast<double>(n)));
      y.push_back(std::log(static_cast<double>(tree.row_count())));
      EXPECT_LE(tree.depth(), std::log2(static_cast<double>(n)));
    }
    const double exponent = (y.back() - y.front()) / (x.back() - x.front());
    std::printf("d %zu: rows of nodes grow as n^%.2f; the paper: %zu + delta\n", d, exponent, d / 2);
    EXPECT_LE(exponent, most);
    EXPECT_GE(exponent, 1);
  }
}

}  // namespace
}  // namespace sunder::tests
