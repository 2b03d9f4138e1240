// Every method of polytope_polytope against polytope_polytope_by_scan, with the evidence of each checked exactly; in
// two dimensions and three against the plane and space, too.
#include <tests/support/polytope_pairs.h>
#include <tests/support/scale.h>

#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/polytope/pair/hyperplanes.h>
#include <sunder/polytope/pair/polytope_polytope.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using polytope::ExactEvidence;
using polytope::Polytope;
using polytope::PolytopeAnswer;

struct Tally {
  int cases = 0, meets = 0, filter = 0, evidence = 0, finishing = 0, deep = 0, tree_hits = 0, parted = 0, by_shells = 0;
};

bool holds(const PolytopePair& c, const PolytopeAnswer& answer) {
  const ExactEvidence exact = exact_evidence(c.a, c.pose_a, c.b, c.pose_b, answer);
  return check(c.a, c.pose_a, c.b, c.pose_b, answer.verdict(), exact);
}

// By several hyperplanes; and where a multiplier, or what a plane holds, is another one, nothing is proved. Are they of
// shell-simplices?
bool expect_parted_by_hyperplanes(const PolytopePair& c, const polytope::HierarchicalTree& a,
                                  const polytope::HierarchicalTree& b, const PolytopeAnswer& answer) {
  using polytope::HyperplaneEvidence;
  const HyperplaneEvidence evidence = parting_hyperplanes(a, c.pose_a, b, c.pose_b, answer);
  const auto accepted = [&](const HyperplaneEvidence& said) { return check(c.a, c.pose_a, c.b, c.pose_b, said); };
  EXPECT_TRUE(accepted(evidence));
  for (const auto side : {&HyperplaneEvidence::a, &HyperplaneEvidence::b}) {
    const HyperplaneEvidence::Around& around = evidence.*side;
    const polytope::HierarchicalTree& tree = side == &HyperplaneEvidence::a ? a : b;
    EXPECT_LE(around.planes.size(), tree.dimension() * tree.depth() + 1);
    if (!around.planes.empty()) {
      HyperplaneEvidence mutant = evidence;
      Dyadic& most = (mutant.*side).planes.back().back();
      most = most - Dyadic(0x1p-1070);  // it is the greatest product
      EXPECT_FALSE(accepted(mutant));
    }
    if (around.multipliers.parts.empty()) continue;
    HyperplaneEvidence mutant = evidence;
    Dyadic& multiplier = (mutant.*side).multipliers.parts[0].numerator;
    multiplier = -multiplier;
    EXPECT_FALSE(accepted(mutant));
    const auto& d = evidence.direction;
    if (std::all_of(d.begin(), d.end(), [](const Dyadic& x) { return x.sign() == Sign::zero; })) continue;  // one alone
    (mutant.*side).multipliers.parts.clear();
    EXPECT_FALSE(accepted(mutant));
  }
  return evidence.a.are_shells && evidence.b.are_shells;
}

// The other verdict, and numbers that are a little different, prove nothing.
void expect_mutants_refused(const PolytopePair& c, const PolytopeAnswer& answer) {
  const Verdict verdict = answer.verdict();
  const auto accepted = [&](Verdict said, const ExactEvidence& evidence) {
    return check(c.a, c.pose_a, c.b, c.pose_b, said, evidence);
  };
  const ExactEvidence exact = exact_evidence(c.a, c.pose_a, c.b, c.pose_b, answer);
  EXPECT_FALSE(accepted(verdict == Verdict::meet ? Verdict::apart : Verdict::meet, exact));
  for (auto weights : {&ExactEvidence::of_a, &ExactEvidence::of_b}) {
    if ((exact.*weights).parts.empty()) continue;
    ExactEvidence mutant = exact;
    Dyadic& numerator = (mutant.*weights).parts[0].numerator;
    numerator = numerator + Dyadic(0x1p-40);
    if (verdict == Verdict::meet) {
      EXPECT_FALSE(accepted(verdict, mutant));
    }
    numerator = -numerator;
    EXPECT_FALSE(accepted(verdict, mutant));
    mutant = exact;
    (mutant.*weights).parts[0].index = 0xffffffffu;
    EXPECT_FALSE(accepted(verdict, mutant));
  }
  ExactEvidence mutant = exact;
  if (verdict == Verdict::meet) {
    mutant.numbers[0] = mutant.numbers[0] + Dyadic(0x1p-40);
  } else {
    bool is_zero = true;
    for (Dyadic& x : mutant.numbers) {
      is_zero = is_zero && x.sign() == Sign::zero;
      x = -x;
    }
    if (is_zero) return;  // half-spaces alone contradict
  }
  EXPECT_FALSE(accepted(verdict, mutant));
}

TEST(PolytopePairDifferential, MethodsAgreeWithTheScan) {
  const int count = scaled_count(20000, 500);
  const std::uint64_t seed = chosen_seed(20261126);
  SCOPED_TRACE("seed " + std::to_string(seed));
  PolytopePairs pairs(seed);
  std::map<PolytopeFamily, Tally> tallies;
  std::map<std::size_t, int> of_dimension;
  for (int i = 0; i < count; ++i) {
    const PolytopePair c = pairs.next();
    SCOPED_TRACE(std::to_string(i) + " " + std::string(name_of(c.family)));
    const PolytopeAnswer scan = polytope_polytope_by_scan(c.a, c.pose_a, c.b, c.pose_b);
    const PolytopeAnswer gjk = polytope_polytope_by_gjk(c.a, c.pose_a, c.b, c.pose_b);
    const PolytopeAnswer front = polytope_polytope(c.a, c.pose_a, c.b, c.pose_b);
    ASSERT_EQ(scan.meet(), gjk.meet());
    ASSERT_EQ(scan.meet(), front.meet());
    ASSERT_TRUE(holds(c, scan));
    ASSERT_TRUE(holds(c, gjk));
    if (scan.meet()) {  // d + 2 points in total
      const ExactEvidence exact = exact_evidence(c.a, c.pose_a, c.b, c.pose_b, gjk);
      ASSERT_LE(exact.of_a.parts.size() + exact.of_b.parts.size(), c.a.dimension() + 2);
    }
    Tally& tally = tallies[c.family];
    const polytope::HierarchicalTree tree_a = small_tree(c.a), tree_b = small_tree(c.b);
    const PolytopeAnswer tree = polytope_polytope_by_columns(tree_a, c.pose_a, tree_b, c.pose_b);
    ASSERT_EQ(scan.meet(), tree.meet());
    ASSERT_TRUE(holds(c, tree));
    if (i % 64 == 0) expect_mutants_refused(c, tree);
    if (!tree.meet() && i % 4 == 0) {
      ++tally.parted;
      tally.by_shells += expect_parted_by_hyperplanes(c, tree_a, tree_b, tree);
    }
    tally.deep += tree_a.depth() + tree_b.depth() > 0;
    tally.tree_hits += tree.decided_by != DecidedBy::finishing;
    if (i % 16 == 0) expect_mutants_refused(c, i % 32 == 0 ? gjk : scan);
    ++tally.cases;
    ++of_dimension[c.a.dimension()];
    tally.meets += scan.meet();
    tally.filter += gjk.decided_by == DecidedBy::filter;
    tally.evidence += gjk.decided_by == DecidedBy::evidence;
    tally.finishing += gjk.decided_by == DecidedBy::finishing;
  }
  for (const auto& [family, tally] : tallies) {
    std::printf("%-18s %6d cases %6d meet; decided by filter %6d evidence %6d finishing %6d\n",
                std::string(name_of(family)).c_str(), tally.cases, tally.meets, tally.filter, tally.evidence,
                tally.finishing);
    std::printf("%-18s of these %6d with a tree of some depth; %6d by trees without a node looked at whole\n", "",
                tally.deep, tally.tree_hits);
    std::printf("%-18s parted by several hyperplanes %6d, by those of shell-simplices alone %6d\n", "", tally.parted,
                tally.by_shells);
    EXPECT_GT(tally.deep, tally.cases / 10) << name_of(family);
    EXPECT_GT(tally.tree_hits, tally.cases * 9 / 10) << name_of(family);
    EXPECT_GT(tally.meets, tally.cases / 20) << name_of(family);
    EXPECT_GT(tally.cases - tally.meets, tally.cases / 20 * (family != PolytopeFamily::touching)) << name_of(family);
  }
  EXPECT_EQ(of_dimension.size(), 5u);
  EXPECT_GT(tallies[PolytopeFamily::random].filter, tallies[PolytopeFamily::random].cases * 9 / 10);
  EXPECT_GT(tallies[PolytopeFamily::touching].evidence, tallies[PolytopeFamily::touching].cases / 2);
  EXPECT_GT(tallies[PolytopeFamily::last_bit].finishing, tallies[PolytopeFamily::last_bit].cases / 20);
}

TEST(PolytopePairDifferential, HalfSpacesAgreeWithTheScan) {
  const int count = scaled_count(2000, 200);
  const std::uint64_t seed = chosen_seed(20261127);
  SCOPED_TRACE("seed " + std::to_string(seed));
  PolytopePairs pairs(seed);
  int meets = 0, mixed = 0, mixed_meets = 0, alone = 0, deep = 0, tree_hits = 0;
  for (int i = 0; i < count; ++i) {
    const PolytopePair c = pairs.next_of_half_spaces();
    SCOPED_TRACE(std::to_string(i) + " " + std::string(name_of(c.family)));
    const PolytopeAnswer scan = polytope_polytope_by_scan(c.a, c.pose_a, c.b, c.pose_b);
    const PolytopeAnswer front = polytope_polytope(c.a, c.pose_a, c.b, c.pose_b);
    ASSERT_EQ(scan.meet(), front.meet());
    ASSERT_TRUE(holds(c, scan));
    ASSERT_TRUE(holds(c, front));
    const ExactEvidence exact = exact_evidence(c.a, c.pose_a, c.b, c.pose_b, front);
    if (!scan.meet() && !c.a.is_of_points() && !c.b.is_of_points()) {
      ASSERT_LE(exact.of_a.parts.size() + exact.of_b.parts.size(), c.a.dimension() + 1);
      alone += exact.of_a.parts.empty() || exact.of_b.parts.empty();
    }
    const polytope::HierarchicalTree tree_a = small_tree(c.a), tree_b = small_tree(c.b);
    const PolytopeAnswer tree = polytope_polytope_by_columns(tree_a, c.pose_a, tree_b, c.pose_b);
    ASSERT_EQ(scan.meet(), tree.meet());
    ASSERT_TRUE(holds(c, tree));
    if (!tree.meet()) expect_parted_by_hyperplanes(c, tree_a, tree_b, tree);
    deep += tree_a.depth() + tree_b.depth() > 0;
    tree_hits += tree.decided_by != DecidedBy::finishing;
    if (i % 4 == 0) expect_mutants_refused(c, i % 8 == 0 ? front : tree);
    const bool is_mixed = c.a.is_of_points() || c.b.is_of_points();
    meets += scan.meet();
    mixed += is_mixed;
    mixed_meets += is_mixed && scan.meet();
  }
  std::printf("%d pairs, %d meet; %d with points, %d of these meet; %d where one body is empty\n", count, meets, mixed,
              mixed_meets, alone);
  std::printf("%d with a tree of some depth; %d without a node looked at whole\n", deep, tree_hits);
  EXPECT_GT(deep, count / 4);
  EXPECT_GT(tree_hits, count * 9 / 10);
  EXPECT_GT(meets - mixed_meets, count / 20);
  EXPECT_GT(count - meets - (mixed - mixed_meets), count / 20);
  EXPECT_GT(mixed_meets, mixed / 10);
  EXPECT_LT(mixed_meets, mixed * 9 / 10);
  EXPECT_GT(alone, 0);
}

TEST(PolytopePairDifferential, AgreesWithThePlane) {
  const int count = scaled_count(4000, 200);
  PolytopePairs pairs(chosen_seed(20261128));
  int meets = 0;
  for (int i = 0; i < count; ++i) {
    const PolytopePair c = pairs.next(2);
    const auto polygon = [](const Polytope& body) {
      std::vector<Point2> points;
      for (std::uint32_t k = 0; k < body.size(); ++k) points.push_back({body.row(k)[0], body.row(k)[1]});
      return planar::ConvexPolygon::hull_of(points);
    };
    const auto pose = [](const polytope::Pose& p) {
      return planar::Pose::from_matrix({p.linear(0, 0), p.linear(0, 1), p.linear(1, 0), p.linear(1, 1)},
                                       {p.translation()[0], p.translation()[1]});
    };
    const bool expected = polygon_polygon_by_scan(polygon(c.a), pose(c.pose_a), polygon(c.b), pose(c.pose_b)).meet();
    ASSERT_EQ(expected, polytope_polytope(c.a, c.pose_a, c.b, c.pose_b).meet()) << i << " " << name_of(c.family);
    const polytope::HierarchicalTree a = small_tree(c.a), b = small_tree(c.b);
    ASSERT_EQ(expected, polytope_polytope_by_columns(a, c.pose_a, b, c.pose_b).meet()) << i << " " << name_of(c.family);
    meets += expected;
  }
  EXPECT_GT(meets, count / 5);
  EXPECT_LT(meets, count * 4 / 5);
}

TEST(PolytopePairDifferential, AgreesWithSpace) {
  const int count = scaled_count(4000, 200);
  PolytopePairs pairs(chosen_seed(20261129));
  int meets = 0;
  for (int i = 0; i < count; ++i) {
    const PolytopePair c = pairs.next(3);
    const auto body = [](const Polytope& given) {
      std::vector<Point3> points;
      for (std::uint32_t k = 0; k < given.size(); ++k) {
        points.push_back({given.row(k)[0], given.row(k)[1], given.row(k)[2]});
      }
      return solid::ConvexPolyhedron(points);
    };
    const auto pose = [](const polytope::Pose& p) {
      std::array<double, 9> linear;
      for (std::size_t k = 0; k < 9; ++k) linear[k] = p.linear()[k];
      return solid::Pose::from_matrix(linear, {p.translation()[0], p.translation()[1], p.translation()[2]});
    };
    const bool expected = polyhedron_polyhedron_by_scan(body(c.a), pose(c.pose_a), body(c.b), pose(c.pose_b)).meet();
    ASSERT_EQ(expected, polytope_polytope(c.a, c.pose_a, c.b, c.pose_b).meet()) << i << " " << name_of(c.family);
    const polytope::HierarchicalTree a = small_tree(c.a), b = small_tree(c.b);
    ASSERT_EQ(expected, polytope_polytope_by_columns(a, c.pose_a, b, c.pose_b).meet()) << i << " " << name_of(c.family);
    meets += expected;
  }
  EXPECT_GT(meets, count / 5);
  EXPECT_LT(meets, count * 4 / 5);
}

}  // namespace
}  // namespace sunder::tests
