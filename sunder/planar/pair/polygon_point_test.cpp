// A point and a polygon: the search against the scan, the evidence against the check, and what it costs.
#include <sunder/certificate/check.h>
#include <sunder/planar/pair/one_polygon_test.h>
#include <sunder/planar/pair/polygon_point.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <vector>

namespace sunder::planar {
namespace {

CheckResult check(const PolygonPoint& answer, const ConvexPolygon& polygon, const Pose& pose, const Point2& point) {
  std::vector<Point3> a;
  for (const Point2& v : polygon.vertices()) a.push_back({v.x, v.y, 0});
  const std::array<Point3, 1> b{Point3{point.x, point.y, 0}};
  const Affine3 placed = in_space(pose.affine()), world;
  return check_absolutely(pair_certificate(answer), {a, placed, false}, {b, world, false});
}

using Evidence = Tangents::Evidence;

// The number of its vertex or edge; of other places none.
std::optional<std::uint32_t> feature_of(const PolygonPoint& answer) {
  if (const auto* at = std::get_if<AtVertex>(&answer.evidence)) return at->vertex;
  if (const auto* in = std::get_if<InEdge>(&answer.evidence)) return in->edge;
  return std::nullopt;
}

// Asks both ways, and for the tangents.
PolygonPoint place_of_point(const ConvexPolygon& polygon, const Pose& pose, const Point2& point,
                            bool with_scan = true) {
  const PolygonPoint found = polygon_point(polygon, pose, point);
  EXPECT_EQ(found.meet(), place_of(found) != Place::outside);
  const Tangents t = tangents(polygon, pose, point);
  EXPECT_EQ(t.meet(), found.meet());
  EXPECT_TRUE(!t.meet() || t.evidence == Evidence(NoTangents{place_of(found)}));
  if (!with_scan) return found;
  const bool with_check = polygon.size() < 2000;  // it is slow
  if (with_check) {
    EXPECT_EQ(check(found, polygon, pose, point), CheckResult::accepted);
  }
  const PolygonPoint scanned = polygon_point_by_scan(polygon, pose, point);
  EXPECT_EQ(place_of(found), place_of(scanned)) << name_of(place_of(found)) << ' ' << name_of(place_of(scanned));
  EXPECT_EQ(feature_of(found), feature_of(scanned));
  if (with_check) {
    EXPECT_EQ(check(scanned, polygon, pose, point), CheckResult::accepted);
  }
  const Tangents s = tangents_by_scan(polygon, pose, point);
  EXPECT_TRUE(t.evidence == s.evidence);
  return found;
}

TEST(PolygonPointTest, ByHand) {
  const ConvexPolygon square = ConvexPolygon::from_vertices({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  const std::optional<std::uint32_t> none;
  const auto at = [&](const Point2& p) {
    const PolygonPoint answer = place_of_point(square, Pose(), p);
    return std::pair(place_of(answer), feature_of(answer));
  };
  EXPECT_EQ(at({0, 0}), std::pair(Place::vertex, std::optional(0u)));
  EXPECT_EQ(at({2, 2}), std::pair(Place::vertex, std::optional(2u)));
  EXPECT_EQ(at({0, 1}), std::pair(Place::edge, std::optional(3u)));
  EXPECT_EQ(at({1, 0}), std::pair(Place::edge, std::optional(0u)));
  EXPECT_EQ(at({1, 1}), std::pair(Place::inside, none));
  EXPECT_EQ(at({1, std::nextafter(0, -1)}).first, Place::outside);
  EXPECT_EQ(at({std::nextafter(2, 3), 0}).first, Place::outside);
  // The numbers of features are the polygon's own, also where the pose turns their order round.
  const Pose mirrored = Pose::from_matrix({-1, 0, 0, 1}, {0, 0});
  EXPECT_EQ(feature_of(place_of_point(square, mirrored, {-2, 1})), 1u);
  EXPECT_EQ(feature_of(place_of_point(square, mirrored, {-2, 2})), 2u);
  // From (1, -3), the corners below; from (4, 0), in line with two of them, the nearer one.
  Tangents t = tangents(square, {1, -3});
  EXPECT_TRUE(t.evidence == Evidence(TangentVertices{0, 1}));
  t = tangents(square, {4, 0});
  EXPECT_TRUE(t.evidence == Evidence(TangentVertices{1, 2}));
  t = tangents(square, {1, 1});
  EXPECT_TRUE(t.evidence == Evidence(NoTangents{Place::inside}));
}

TEST(PolygonPointTest, OfSegmentsAndPoints) {
  const ConvexPolygon segment = ConvexPolygon::from_vertices({{0, 0}, {4, 2}});
  EXPECT_EQ(place_of(place_of_point(segment, Pose(), {2, 1})), Place::edge);
  EXPECT_EQ(feature_of(place_of_point(segment, Pose(), {4, 2})), 1u);
  EXPECT_EQ(place_of(place_of_point(segment, Pose(), {6, 3})), Place::outside);
  EXPECT_EQ(place_of(place_of_point(segment, Pose(), {-2, -1})), Place::outside);
  EXPECT_EQ(place_of(place_of_point(segment, Pose(), {2, 0})), Place::outside);
  EXPECT_EQ(place_of(place_of_point(segment, Pose(), {2, 3})), Place::outside);
  const ConvexPolygon point = ConvexPolygon::from_vertices({{0, 0}});
  EXPECT_EQ(place_of(place_of_point(point, Pose(), {0, -0.0})), Place::vertex);
  EXPECT_EQ(place_of(place_of_point(point, Pose(), {5e-324, 0})), Place::outside);
}

TEST(PolygonPointTest, AgreesWithScanOnNastyCases) {
  Random random(tests::chosen_seed(20261205));
  std::map<Place, int> counts;
  int reflected_edges = 0, degenerate = 0;
  const int count = tests::scaled_count(40000, 1000);
  for (int i = 0; i < count; ++i) {
    const NastyCase c = nasty_case(random);
    const PolygonPoint answer = place_of_point(c.polygon, c.pose, nasty_point(c, random));
    if (HasFailure()) FAIL() << "instance " << i;
    ++counts[place_of(answer)];
    reflected_edges += c.pose.reflects() && place_of(answer) == Place::edge ? 1 : 0;
    degenerate += c.polygon.size() < 3 ? 1 : 0;
  }
  for (const auto& [place, times] : counts) EXPECT_GT(times, count / 12) << name_of(place);
  EXPECT_EQ(counts.size(), 4u);
  EXPECT_GT(reflected_edges, count / 100);
  EXPECT_GT(degenerate, count / 20);
}

TEST(PolygonPointTest, AgreesWithScanOnWildNumbers) {
  Random random(tests::chosen_seed(20261220));
  std::map<Place, int> counts;
  for (int i = 0; i < tests::scaled_count(4000, 1000); ++i) {
    const NastyCase c = wild_case(random);
    ++counts[place_of(place_of_point(c.polygon, c.pose, wild_point(c, random)))];
    if (HasFailure()) FAIL() << "instance " << i;
  }
  for (const auto& [place, times] : counts) EXPECT_GT(times, 10) << name_of(place);
}

TEST(PolygonPointTest, AgreesWithScanOnLargePolygons) {
  Random random(tests::chosen_seed(20261206));
  const Pose mirrored = Pose::from_matrix({0, 1, 1, 0}, {0, 0});
  for (const std::uint32_t n : {1000u, 262144u}) {
    for (const double radius : {1.0, 0x1p900, 0x1p-900}) {
      if (n > 65536 && (radius != 1 || tests::is_scaled_down())) continue;  // slow: beyond the range of filters
      const ConvexPolygon p = regular_polygon(n, radius);
      for (int i = 0; i < (n < 2000 ? 50 : 5); ++i) {
        const Point2 v = p[static_cast<std::uint32_t>(random.below(n))];
        const double stretch = random.below(2) == 0 ? 1 : 1 + random.uniform(-1, 1) * random.log_uniform(1e-17, 1);
        // Beyond the range of filters, a scan of many vertices takes long.
        const PolygonPoint answer = place_of_point(p, random.below(2) == 0 ? Pose() : mirrored,
                                                   {v.x * stretch, v.y * stretch}, n < 2000 || radius == 1);
        if (stretch == 1 && answer.decided_by == DecidedBy::filter) {
          EXPECT_NE(place_of(answer), Place::inside);
        }
      }
    }
  }
}

TEST(PolygonPointTest, Complexity) {
  Random random(tests::chosen_seed(20261207));
  for (std::uint32_t e = 3; e <= 20; ++e) {
    const std::uint32_t n = 1u << e;
    double of_point = 0, of_tangents = 0;
    const auto ask_often = [&](const ConvexPolygon& p, double size) {
      for (int i = 0; i < 200; ++i) {
        Point2 x = p[static_cast<std::uint32_t>(random.below(n))];
        if (i % 3 > 0) x = {x.x + size * random.uniform(-1, 1), x.y + size * random.uniform(-1, 1)};
        of_point = std::max(of_point, static_cast<double>(polygon_point(p, x).cost.probes));
        of_tangents = std::max(of_tangents, static_cast<double>(tangents(p, x).cost.probes));
      }
    };
    ask_often(regular_polygon(n), 1);
    for (const std::uint32_t begin : {0u, n / 3, n - 1}) ask_often(parabola(n, begin), n);
    EXPECT_LE(of_point, e + 4.0) << n;
    EXPECT_LE(of_tangents, 4.0 * e + 6) << n;
    std::printf("2^%u: point %.0f, tangents %.0f\n", e, of_point, of_tangents);
  }
}

}  // namespace
}  // namespace sunder::planar
