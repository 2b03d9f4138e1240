// A segment and a polygon: the clipping against exact fractions, and whether they meet against polygon_polygon.
#include <sunder/planar/pair/cut_test.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_segment.h>

#include <algorithm>
#include <cmath>

namespace sunder::planar {
namespace {

OwnEnd other_own(OwnEnd own) { return own == OwnEnd::none ? OwnEnd::none : own == OwnEnd::a ? OwnEnd::b : OwnEnd::a; }
CutEnd with_other_own(const CutEnd& end) { return {end.place, end.feature, other_own(end.own)}; }

// With a and b exchanged.
PolygonCut turned_round(PolygonCut cut) {
  if (auto* beyond = std::get_if<BeyondEnd>(&cut.evidence)) beyond->own = other_own(beyond->own);
  if (auto* point = std::get_if<CutPoint>(&cut.evidence)) point->at = with_other_own(point->at);
  if (auto* across = std::get_if<CutAcross>(&cut.evidence)) {
    *across = {with_other_own(across->last), with_other_own(across->first)};
  }
  if (auto* along = std::get_if<CutAlong>(&cut.evidence)) {
    *along = {with_other_own(along->last), with_other_own(along->first), along->edge};
  }
  return cut;
}

PolygonCut cut_by_segment(const ConvexPolygon& polygon, const Pose& pose, const Segment& s, bool with_scan = true) {
  const PolygonCut found = polygon_segment(polygon, pose, s);
  const std::array<Point2, 2> ends{s.a, s.b};
  EXPECT_EQ(found.meet(), intersect(polygon, pose, ConvexPolygon::hull_of(ends), Pose()).meet());
  if (!with_scan) return found;
  expect_same(found, polygon_segment_by_scan(polygon, pose, s));
  expect_true(polygon, pose, s.a, s.b, found);
  // Turned round, the ends are exchanged.
  if (s.a != s.b) {
    expect_same(found, turned_round(polygon_segment(polygon, pose, {s.b, s.a})));
  }
  return found;
}

TEST(PolygonSegmentTest, ByHand) {
  const ConvexPolygon square = ConvexPolygon::from_vertices({{0, 0}, {3, 0}, {3, 3}, {0, 3}});
  const auto cut = [&](const Point2& a, const Point2& b) { return cut_by_segment(square, Pose(), {a, b}); };
  PolygonCut c = cut({-1, 1}, {9, 1});
  EXPECT_EQ(kind_of(c), CutKind::across);
  EXPECT_EQ(first_of(c), (CutEnd{Place::edge, 3}));
  EXPECT_EQ(last_of(c), (CutEnd{Place::edge, 1}));
  c = cut({1, 1}, {2, 1});
  EXPECT_EQ(kind_of(c), CutKind::across);
  EXPECT_EQ(first_of(c), (CutEnd{Place::inside, 0, OwnEnd::a}));
  EXPECT_EQ(last_of(c), (CutEnd{Place::inside, 0, OwnEnd::b}));
  c = cut({1, 1}, {3, 1});
  EXPECT_EQ(last_of(c), (CutEnd{Place::edge, 1, OwnEnd::b}));
  c = cut({3, 1}, {4, 1});
  EXPECT_EQ(kind_of(c), CutKind::point);
  EXPECT_EQ(last_of(c), (CutEnd{Place::edge, 1, OwnEnd::a}));
  c = cut({1, 0}, {5, 0});
  EXPECT_EQ(kind_of(c), CutKind::along);
  EXPECT_EQ(std::get<CutAlong>(c.evidence).edge, 0u);
  EXPECT_EQ(first_of(c), (CutEnd{Place::edge, 0, OwnEnd::a}));
  EXPECT_EQ(last_of(c), (CutEnd{Place::vertex, 1}));
  EXPECT_EQ(exact_end(square, Pose(), {1, 0}, {5, 0}, first_of(c)).along_edge.nearest(), 1.0 / 3);
  EXPECT_EQ(exact_end(square, Pose(), {1, 0}, {5, 0}, last_of(c)).along_line.nearest(), 0.5);
  c = cut({3, 0}, {5, 0});
  EXPECT_EQ(kind_of(c), CutKind::point);
  EXPECT_EQ(last_of(c), (CutEnd{Place::vertex, 1, OwnEnd::a}));
  EXPECT_TRUE(cut({4, 0}, {5, 0}).evidence == PolygonCut::Evidence(BeyondEnd{OwnEnd::a}));
  EXPECT_TRUE(cut({5, 0}, {4, 0}).evidence == PolygonCut::Evidence(BeyondEnd{OwnEnd::b}));
  EXPECT_TRUE(cut({4, 0}, {4, 5}).evidence == PolygonCut::Evidence(BesideLine{1}));
  c = cut({-1, 1}, {1, -1});
  EXPECT_EQ(kind_of(c), CutKind::point);
  EXPECT_EQ(first_of(c), (CutEnd{Place::vertex, 0}));
  EXPECT_EQ(kind_of(cut({-2, 2}, {-1, 1})), CutKind::nothing);
  // Of length zero.
  EXPECT_EQ(first_of(cut({1, 1}, {1, 1})), (CutEnd{Place::inside, 0, OwnEnd::a}));
  EXPECT_EQ(last_of(cut({1, 0}, {1, 0})), (CutEnd{Place::edge, 0, OwnEnd::a}));
  EXPECT_TRUE(cut({-1, 0}, {-1, 0}).evidence == PolygonCut::Evidence(BeyondEnd{OwnEnd::a}));
}

TEST(PolygonSegmentTest, OfSegmentsAndPoints) {
  const ConvexPolygon segment = ConvexPolygon::from_vertices({{0, 0}, {4, 2}});
  PolygonCut c = cut_by_segment(segment, Pose(), {{2, 1}, {8, 4}});
  EXPECT_EQ(kind_of(c), CutKind::along);
  EXPECT_EQ(first_of(c), (CutEnd{Place::edge, 0, OwnEnd::a}));
  c = cut_by_segment(segment, Pose(), {{2, 1}, {2, 4}});
  EXPECT_EQ(kind_of(c), CutKind::point);
  EXPECT_EQ(first_of(c), (CutEnd{Place::edge, 0, OwnEnd::a}));
  EXPECT_EQ(kind_of(cut_by_segment(segment, Pose(), {{2, 2}, {2, 4}})), CutKind::nothing);
  EXPECT_EQ(kind_of(cut_by_segment(segment, Pose(), {{6, 3}, {8, 4}})), CutKind::nothing);
  const ConvexPolygon point = ConvexPolygon::from_vertices({{1, 1}});
  EXPECT_EQ(first_of(cut_by_segment(point, Pose(), {{0, 0}, {1, 1}})), (CutEnd{Place::vertex, 0, OwnEnd::b}));
  EXPECT_EQ(kind_of(cut_by_segment(point, Pose(), {{0, 0}, {0.5, 0.5}})), CutKind::nothing);
}

TEST(PolygonSegmentTest, AgreesWithScanOnNastyCases) {
  Random random(tests::chosen_seed(20261211));
  CutCounts counts;
  int short_ones = 0;
  const int count = tests::scaled_count(40000, 1000);
  for (int i = 0; i < count; ++i) {
    const NastyCase c = nasty_case(random);
    const Point2 a = nasty_point(c, random), b = nasty_point(c, random);
    counts.add(c, cut_by_segment(c.polygon, c.pose, {a, b}));
    short_ones += a == b ? 1 : 0;
    if (HasFailure()) FAIL() << "instance " << i;
  }
  counts.expect_all(count, true);
  EXPECT_GT(short_ones, count / 30);
}

TEST(PolygonSegmentTest, AgreesWithScanOnWildNumbers) {
  Random random(tests::chosen_seed(20261222));
  CutCounts counts;
  for (int i = 0; i < tests::scaled_count(4000, 1000); ++i) {
    const NastyCase c = wild_case(random);
    counts.add(c, cut_by_segment(c.polygon, c.pose, {wild_point(c, random), wild_point(c, random)}));
    if (HasFailure()) FAIL() << "instance " << i;
  }
  for (const int k : counts.kinds) EXPECT_GT(k, 10);
}

TEST(PolygonSegmentTest, LargePolygonsAndComplexity) {
  Random random(tests::chosen_seed(20261212));
  for (const std::uint32_t e : {3u, 6u, 9u, 12u, 15u, 18u, 20u}) {
    const std::uint32_t n = 1u << e;
    double worst = 0;
    for (const double radius : {1.0, 0x1p900, 0x1p-900}) {
      if (n > 4096 && radius != 1) continue;  // slow: beyond the range of filters
      const ConvexPolygon p = regular_polygon(n, radius);
      for (int i = 0; i < 100; ++i) {
        const auto near = [&] {
          const Point2 v = p[static_cast<std::uint32_t>(random.below(n))];
          const double stretch = random.below(3) == 0 ? 1 : 1 + random.uniform(-1, 1) * random.log_uniform(1e-17, 1);
          return Point2{v.x * stretch, v.y * stretch};
        };
        const PolygonCut c = cut_by_segment(p, Pose(), {near(), near()}, i < (n < 3000 ? 10 : n < 300000 ? 2 : 0));
        worst = std::max(worst, static_cast<double>(c.cost.probes));
      }
    }
    EXPECT_LE(worst, 3.0 * e + 5) << n;
  }
}

}  // namespace
}  // namespace sunder::planar
