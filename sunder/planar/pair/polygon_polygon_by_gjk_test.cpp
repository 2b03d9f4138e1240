#include <sunder/planar/pair/proposal_test.h>

namespace sunder::planar::proposal_test {

namespace {

constexpr Method by_gjk = polygon_polygon_by_gjk;

TEST(PolygonPolygonByGjk, AgreesWithTheScanOnGrids) { agrees_on_grids(by_gjk, 1, 1, 10500); }

TEST(PolygonPolygonByGjk, AgreesWithTheScanOnMoreGrids) { agrees_on_grids(by_gjk, 11, 1, 10500); }

TEST(PolygonPolygonByGjk, SeldomFinishes) { seldom_finishes(by_gjk, 2, 300, 0.01, 1e-17, 1500, 1); }

TEST(PolygonPolygonByGjk, SeldomFinishesWithSlivers) { seldom_finishes(by_gjk, 3, 300, 1e-8, 1e-17, 1500, 8); }

TEST(PolygonPolygonByGjk, SeldomFinishesWithManyVertices) { seldom_finishes(by_gjk, 4, 1e5, 0.01, 1e-17, 30, 0); }

TEST(PolygonPolygonByGjk, DoesNotDependOnScale) {
  for (const int exponent : {900, -900}) scales(by_gjk, 5, exponent, true);
  scales(by_gjk, 5, 1019, false);  // products with the pose overflow
  scales(by_gjk, 5, -1070, false);
}

TEST(PolygonPolygonByGjk, SurvivesAnything) { survives_anything(by_gjk, 6); }

TEST(PolygonPolygonByGjk, LeavesPointsAndSegmentsToTheExactSearch) {
  const ConvexPolygon point = ConvexPolygon::from_vertices({{1, 1}}),
                      segment = ConvexPolygon::from_vertices({{0, 0}, {2, 2}}),
                      square = ConvexPolygon::from_vertices({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  for (const ConvexPolygon* a : {&point, &segment}) {
    for (const ConvexPolygon* b : {&point, &segment, &square}) {
      const PairAnswer answer = by_gjk(*a, Pose(), *b, Pose());
      EXPECT_TRUE(answer.meet());
      EXPECT_NE(answer.decided_by, DecidedBy::finishing);
      EXPECT_FALSE(by_gjk(*a, Pose(), *b, Pose::from_matrix({1, 0, 0, 1}, {9, 9})).meet());
    }
  }
}

// Each round takes a support vertex of either polygon. (Found by trial: at most 21 rounds.)
TEST(PolygonPolygonByGjk, TakesFewRounds) {
  Random random(8);
  std::uint32_t most = 0;
  for (const std::uint32_t n : {8u, 128u, 2048u, 1u << 18}) {
    const ConvexPolygon a = on_ellipse(n, 1, true, random), b = on_ellipse(n, 0.1, false, random);
    for (const Regime regime : regimes) {
      for (int t = 0; t < (n < 1u << 14 ? 100 : 5); ++t) {
        const Pose pose_a = turned(1, random), pose_b = pose_in(regime, a, pose_a, b, 1e-16, random);
        const PairAnswer answer = by_gjk(a, pose_a, b, pose_b);
        if (answer.decided_by == DecidedBy::finishing) continue;
        most = std::max(most, answer.cost.iterations);
        const double logs = std::log2(a.size()) + std::log2(b.size());
        ASSERT_LE(static_cast<double>(answer.cost.probes), 2 + (logs + 6) * answer.cost.iterations);
      }
    }
  }
  EXPECT_LE(most, 30u);
  EXPECT_GE(most, 10u);
}

}  // namespace
}  // namespace sunder::planar::proposal_test
