// One descent down two trees of faces (Theorem 6.3) against the scan, on pairs of 2 to 5 dimensions, plain and nasty;
// with the evidence of each answer checked exactly.
#include <tests/support/polytope_pairs.h>
#include <tests/support/scale.h>

#include <sunder/polytope/pair/hyperplanes.h>
#include <sunder/polytope/tree/polytope_polytope_by_tree.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <string>

namespace sunder::tests {
namespace {

using polytope::FaceTrees;
using polytope::PolytopeAnswer;

struct Descents {
  int cases = 0, meets = 0, full = 0, deep = 0, finished = 0, asked = 0, planes = 0;
};

TEST(PolytopeDescentDifferential, AgreesWithTheScan) {
  const int count = scaled_count(20000, 500);
  const std::uint64_t seed = chosen_seed(20261201);
  SCOPED_TRACE("seed " + std::to_string(seed));
  PolytopePairs pairs(seed);
  std::map<PolytopeFamily, Descents> tallies;
  for (int i = 0; i < count; ++i) {
    const std::size_t d = 2 + static_cast<std::size_t>(i / 9 % 4);
    const PolytopePair c = pairs.next(d);
    SCOPED_TRACE(std::to_string(i) + " " + std::string(name_of(c.family)));
    // Nets of few faces, and leaves of few.
    const auto trees_of = [&](const polytope::Polytope& body) {
      const polytope::FaceTreeOptions small{.net = 2, .leaf = 2, .share = 0.99, .levels = d < 4 ? 3u : 1u};
      const auto rows = static_cast<std::uint32_t>(d);
      return FaceTrees(body, polytope::FaceTreesOf::both, small,
                       {.net = rows + 2, .leaf = 3, .share = 0.99, .levels = rows < 5 ? 2u : 1u, .samples = 4});
    };
    const FaceTrees a = trees_of(c.a), b = trees_of(c.b);
    const PolytopeAnswer scan = polytope_polytope_by_scan(c.a, c.pose_a, c.b, c.pose_b);
    const PolytopeAnswer answer = polytope_polytope_by_tree(a, c.pose_a, b, c.pose_b);
    ASSERT_EQ(scan.meet(), answer.meet());
    ASSERT_TRUE(
        check(c.a, c.pose_a, c.b, c.pose_b, answer.verdict(), exact_evidence(c.a, c.pose_a, c.b, c.pose_b, answer)));
    Descents& tally = tallies[c.family];
    ++tally.cases;
    tally.meets += answer.meet();
    if (!answer.meet() && i % 8 == 0) {
      ASSERT_TRUE(
          check(c.a, c.pose_a, c.b, c.pose_b, parting_hyperplanes(a.walks(), c.pose_a, b.walks(), c.pose_b, answer)));
    }
    if (!a.is_full() && !b.is_full()) continue;
    ++tally.full;
    const FaceTrees &of_faces = b.is_full() ? a : b, &of_polar = b.is_full() ? b : a;
    const std::uint32_t levels = of_faces.faces()->depth() + of_polar.polar()->depth() + 2;
    ASSERT_LE(answer.cost.iterations, levels);
    tally.deep += levels > 2;
    if (!answer.meet() && i % 4 == 0) {  // the remark's certificate
      const auto planes = hyperplanes_by_tree(a, c.pose_a, b, c.pose_b);
      ++tally.asked;
      if (planes) {
        ++tally.planes;
        const auto &around_polar = b.is_full() ? planes->b : planes->a,
                   &around_faces = b.is_full() ? planes->a : planes->b;
        ASSERT_TRUE(check(c.a, c.pose_a, c.b, c.pose_b, *planes));
        ASSERT_LE(around_polar.planes.size(), answer.cost.iterations);
        ASSERT_EQ(around_faces.planes.size(), 1u);
        ASSERT_LE(around_polar.multipliers.parts.size(), d + 1);
      }
    }
    tally.finished += answer.decided_by != DecidedBy::evidence;
  }
  int full = 0, finished = 0, deep = 0, asked = 0, planes = 0, meets = 0;
  for (const auto& [family, tally] : tallies) {
    std::printf(
        "%-10s %5d cases, %5d meet; %5d with a polar, %5d with trees of some depth; finished %d; planes of rounds "
        "part %d of %d\n",
        std::string(name_of(family)).c_str(), tally.cases, tally.meets, tally.full, tally.deep, tally.finished,
        tally.planes, tally.asked);
    meets += tally.meets;
    if (family == PolytopeFamily::scales) continue;  // what doubles do not hold
    full += tally.full;
    deep += tally.deep;
    finished += tally.finished;
    if (family == PolytopeFamily::last_bit) continue;  // which offsets of doubles do not hold
    asked += tally.asked;
    planes += tally.planes;
  }
  EXPECT_GT(meets, count / 5);
  EXPECT_LT(meets, count * 4 / 5);
  EXPECT_GT(full, count / 2);
  EXPECT_GT(deep, full / 3);
  EXPECT_LE(finished, full / 100);
  EXPECT_GE(planes, asked - asked / 100 - 1);  // where a face were lost, they would not part
}

}  // namespace
}  // namespace sunder::tests
