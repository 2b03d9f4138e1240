#include <sunder/planar/pair/proposal_test.h>

namespace sunder::planar::proposal_test {

namespace {

constexpr Method by_triangles = polygon_polygon_by_triangles;

TEST(PolygonPolygonByTriangles, AgreesWithTheScanOnGrids) { agrees_on_grids(by_triangles, 1, 1, 10500); }

TEST(PolygonPolygonByTriangles, AgreesWithTheScanOnMoreGrids) { agrees_on_grids(by_triangles, 11, 1, 10500); }

TEST(PolygonPolygonByTriangles, SeldomFinishes) { seldom_finishes(by_triangles, 2, 300, 0.01, 1e-17, 1500, 1); }

TEST(PolygonPolygonByTriangles, SeldomFinishesWithSlivers) {
  seldom_finishes(by_triangles, 3, 300, 1e-8, 1e-17, 1500, 8);
}

TEST(PolygonPolygonByTriangles, SeldomFinishesWithManyVertices) {
  seldom_finishes(by_triangles, 4, 1e5, 0.01, 1e-17, 30, 0);
}

TEST(PolygonPolygonByTriangles, DoesNotDependOnScale) {
  for (const int exponent : {900, -900}) scales(by_triangles, 5, exponent, true);
  scales(by_triangles, 5, 1019, false);  // products with the pose overflow
  scales(by_triangles, 5, -1070, false);
}

TEST(PolygonPolygonByTriangles, SurvivesAnything) { survives_anything(by_triangles, 6); }

TEST(PolygonPolygonByTriangles, LeavesPointsAndSegmentsToTheExactSearch) {
  const ConvexPolygon point = ConvexPolygon::from_vertices({{1, 1}}),
                      segment = ConvexPolygon::from_vertices({{0, 0}, {2, 2}}),
                      square = ConvexPolygon::from_vertices({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  for (const ConvexPolygon* a : {&point, &segment}) {
    for (const ConvexPolygon* b : {&point, &segment, &square}) {
      const PairAnswer answer = by_triangles(*a, Pose(), *b, Pose());
      EXPECT_TRUE(answer.meet());
      EXPECT_NE(answer.decided_by, DecidedBy::finishing);
      EXPECT_FALSE(by_triangles(*a, Pose(), *b, Pose::from_matrix({1, 0, 0, 1}, {9, 9})).meet());
    }
  }
}

// How the number of probes grows. A round that drops vertices takes three at most, one that drops edges takes one;
// there are as many rounds as halvings, and at most two searches for an extreme vertex of b at the end. (Found by
// trial: at most 14 more than 3 (log2 n + log2 m), and, where the exact search finishes, 6 (log2 n + log2 m).)
constexpr double most_probes = 3, most_with_finishing = 6;  // over log2 n + log2 m
constexpr double more_probes = 20;

TEST(PolygonPolygonByTriangles, TakesLogarithmicallyManyProbes) {
  Random random(8);
  for (std::uint32_t n = 1u << 3; n <= (tests::is_scaled_down() ? 1u << 13 : 1u << 18); n *= 2) {
    SCOPED_TRACE(n);
    const ConvexPolygon a = on_ellipse(n, 1, true, random);
    ASSERT_EQ(a.size(), n);
    for (const ConvexPolygon& b :
         {on_ellipse(8, 1, true, random), on_ellipse(n, random.log_uniform(0.01, 1), false, random)}) {
      const double logs = std::log2(a.size()) + std::log2(b.size());
      double most = 0;
      for (const Regime regime : regimes) {
        for (int t = 0; t < (n < 1u << 14 ? 40 : 4); ++t) {
          const Pose pose_a = turned(1, random), pose_b = pose_in(regime, a, pose_a, b, 1e-16, random);
          for (const PairAnswer& answer : {by_triangles(a, pose_a, b, pose_b), by_triangles(b, pose_b, a, pose_a)}) {
            const bool finished = answer.decided_by == DecidedBy::finishing;
            const double probes = static_cast<double>(answer.cost.probes);
            ASSERT_LE(probes, (finished ? most_with_finishing : most_probes) * logs + more_probes);
            most = std::max(most, probes);
          }
        }
      }
      EXPECT_GE(most, logs);
    }
  }
}

}  // namespace
}  // namespace sunder::planar::proposal_test
