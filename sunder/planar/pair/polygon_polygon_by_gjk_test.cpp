#include <sunder/planar/pair/proposal_test.h>

namespace sunder::planar {

namespace {

using namespace proposal_test;

constexpr Method method = polygon_polygon_by_gjk;

TEST(PolygonPolygonByGjk, AgreesWithTheScanOnGrids) { agrees_on_grids(method, 1, 1, 10500); }

TEST(PolygonPolygonByGjk, AgreesWithTheScanOnMoreGrids) { agrees_on_grids(method, 11, 1, 10500); }

TEST(PolygonPolygonByGjk, SeldomFinishes) { seldom_finishes(method, 2, 300, 0.01, 1e-17, 1500, 1); }

TEST(PolygonPolygonByGjk, SeldomFinishesWithSlivers) { seldom_finishes(method, 3, 300, 1e-8, 1e-17, 1500, 8); }

TEST(PolygonPolygonByGjk, SeldomFinishesWithManyVertices) { seldom_finishes(method, 4, 1e5, 0.01, 1e-17, 30, 0); }

TEST(PolygonPolygonByGjk, DoesNotDependOnScale) {
  for (const int exponent : {900, -900}) scales(method, 5, exponent, true);
  scales(method, 5, 1019, false);  // products with the pose overflow
  scales(method, 5, -1070, false);
}

TEST(PolygonPolygonByGjk, SurvivesAnything) { survives_anything(method, 6); }

TEST(PolygonPolygonByGjk, LeavesPointsAndSegmentsToTheExactSearch) {
  const ConvexPolygon point = ConvexPolygon::from_vertices({{1, 1}}),
                      segment = ConvexPolygon::from_vertices({{0, 0}, {2, 2}}),
                      square = ConvexPolygon::from_vertices({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  for (const ConvexPolygon* a : {&point, &segment}) {
    for (const ConvexPolygon* b : {&point, &segment, &square}) {
      const PairAnswer answer = method(*a, Pose(), *b, Pose());
      EXPECT_TRUE(answer.meet());
      EXPECT_NE(answer.decided_by, DecidedBy::finishing);
      EXPECT_FALSE(method(*a, Pose(), *b, Pose::from_matrix({1, 0, 0, 1}, {9, 9})).meet());
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
        const PairAnswer answer = method(a, pose_a, b, pose_b);
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
}  // namespace sunder::planar
