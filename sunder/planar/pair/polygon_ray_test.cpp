// A ray and a polygon: the clipping against exact fractions, and against a line and a segment.
#include <sunder/planar/pair/cut_test.h>
#include <sunder/planar/pair/polygon_line.h>
#include <sunder/planar/pair/polygon_ray.h>
#include <sunder/planar/pair/polygon_segment.h>

#include <algorithm>

namespace sunder::planar {
namespace {

PolygonCut cut_by_ray(const ConvexPolygon& polygon, const Pose& pose, const Ray& ray, bool with_scan = true) {
  const PolygonCut found = polygon_ray(polygon, pose, ray);
  // Both rays of a line together, and the segment within, meet what the line meets.
  const PolygonCut line = polygon_line(polygon, pose, Line::through(ray.a, ray.b)),
                   back = polygon_ray(polygon, pose, Ray::from(ray.b, ray.a)),
                   between = polygon_segment(polygon, pose, {ray.a, ray.b});
  EXPECT_EQ(line.meet(), found.meet() || back.meet());
  if (line.meet()) {
    EXPECT_EQ(between.meet(), found.meet() && back.meet());
  }
  if (!with_scan) return found;
  expect_same(found, polygon_ray_by_scan(polygon, pose, ray));
  expect_true(polygon, pose, ray.a, ray.b, found);
  return found;
}

TEST(PolygonRayTest, ByHand) {
  const ConvexPolygon square = ConvexPolygon::from_vertices({{0, 0}, {3, 0}, {3, 3}, {0, 3}});
  const auto cut = [&](const Point2& a, const Point2& b) { return cut_by_ray(square, Pose(), Ray::from(a, b)); };
  PolygonCut c = cut({1, 1}, {2, 1});
  EXPECT_EQ(kind_of(c), CutKind::across);
  EXPECT_EQ(first_of(c), (CutEnd{Place::inside, 0, OwnEnd::a}));
  EXPECT_EQ(last_of(c), (CutEnd{Place::edge, 1}));
  EXPECT_EQ(exact_end(square, Pose(), {1, 1}, {2, 1}, last_of(c)).along_line.nearest(), 2);
  c = cut({-2, 1}, {-1, 1});  // the polygon is beyond the second point
  EXPECT_EQ(first_of(c), (CutEnd{Place::edge, 3}));
  EXPECT_EQ(kind_of(cut({-1, 1}, {-2, 1})), CutKind::nothing);
  c = cut({0, 0}, {-1, 0});
  EXPECT_EQ(kind_of(c), CutKind::point);
  EXPECT_EQ(first_of(c), (CutEnd{Place::vertex, 0, OwnEnd::a}));
  c = cut({1, 3}, {2, 3});
  EXPECT_EQ(kind_of(c), CutKind::along);
  EXPECT_EQ(std::get<CutAlong>(c.evidence).edge, 2u);
  EXPECT_EQ(first_of(c), (CutEnd{Place::edge, 2, OwnEnd::a}));
  EXPECT_EQ(last_of(c), (CutEnd{Place::vertex, 2}));
}

TEST(PolygonRayTest, AgreesWithScanOnNastyCases) {
  Random random(tests::chosen_seed(20261213));
  CutCounts counts;
  const int count = tests::scaled_count(40000, 1000);
  for (int i = 0; i < count; ++i) {
    const NastyCase c = nasty_case(random);
    const auto [a, b] = nasty_points(c, random);
    counts.add(c, cut_by_ray(c.polygon, c.pose, Ray::from(a, b)));
    if (HasFailure()) FAIL() << "instance " << i;
  }
  counts.expect_all(count, true);
}

TEST(PolygonRayTest, LargePolygonsAndComplexity) {
  Random random(tests::chosen_seed(20261214));
  for (const std::uint32_t e : {3u, 6u, 9u, 12u, 15u, 18u, 20u}) {
    const std::uint32_t n = 1u << e;
    const ConvexPolygon p = regular_polygon(n);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
      const auto near = [&] {
        const Point2 v = p[static_cast<std::uint32_t>(random.below(n))];
        const double stretch = random.below(3) == 0 ? 1 : 1 + random.uniform(-1, 1) * random.log_uniform(1e-17, 1);
        return Point2{v.x * stretch, v.y * stretch};
      };
      const Point2 a = near(), b = near();
      if (a == b) continue;
      const PolygonCut c = cut_by_ray(p, Pose(), Ray::from(a, b), i < (n < 3000 ? 40 : n < 300000 ? 3 : 0));
      worst = std::max(worst, static_cast<double>(c.cost.probes));
    }
    EXPECT_LE(worst, 3.0 * e + 5) << n;
  }
}

}  // namespace
}  // namespace sunder::planar
