// A line and a polygon: the searches against the scan, exact ends, and what it costs.
#include <sunder/planar/pair/cut_test.h>
#include <sunder/planar/pair/polygon_line.h>
#include <sunder/predicate/line/arrows.h>

#include <tests/support/scale.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder::planar {
namespace {

PolygonCut cut_by_line(const ConvexPolygon& polygon, const Pose& pose, const Line& line, bool with_scan = true) {
  const PolygonCut found = polygon_line(polygon, pose, line);
  expect_same(found, polygon_line_by_fibonacci(polygon, pose, line));
  if (!with_scan) return found;
  expect_same(found, polygon_line_by_scan(polygon, pose, line));
  expect_true(polygon, pose, line.a, line.b, found);
  if (!found.meet()) {  // all vertices are strictly on one side
    const Affine2 world;
    const auto side = [&](std::uint32_t v) {
      return cross_2d(Posed2{line.a, &world, false}, Posed2{line.b, &world, false}, Posed2{line.a, &world, false},
                      Posed2{polygon[v], &pose.affine(), false});
    };
    EXPECT_NE(side(0), Sign::zero);
    for (std::uint32_t v = 1; v < polygon.size(); ++v) EXPECT_EQ(side(v), side(0));
  }
  return found;
}

TEST(LineTest, FactoriesRefuse) {
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  EXPECT_THROW(Line::through({0, 0}, {-0.0, 0}), Error);
  EXPECT_THROW(Line::through({0, 0}, {nan, 0}), Error);
  EXPECT_THROW(Ray::from({0, infinity}, {1, 0}), Error);
  EXPECT_THROW(Ray::from({2, 1}, {2, 1}), Error);
  EXPECT_THROW(HalfPlane::left_of({1, 1}, {1, 1}), Error);
  EXPECT_EQ(Line::through({0, 0}, {5e-324, 0}), (Line{{0, 0}, {5e-324, 0}}));
  try {
    Ray::from({2, 1}, {2, 1});
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::bad_shape);
    EXPECT_STREQ(e.what(), "ray: its two points are equal; give two different ones");
  }
}

TEST(PolygonLineTest, ByHand) {
  const ConvexPolygon square = ConvexPolygon::from_vertices({{0, 0}, {3, 0}, {3, 3}, {0, 3}});
  const auto cut = [&](const Point2& a, const Point2& b) { return cut_by_line(square, Pose(), Line::through(a, b)); };
  PolygonCut c = cut({-1, 1}, {9, 1});
  EXPECT_EQ(kind_of(c), CutKind::across);
  EXPECT_EQ(first_of(c), (CutEnd{Place::edge, 3}));
  EXPECT_EQ(last_of(c), (CutEnd{Place::edge, 1}));
  EXPECT_EQ(exact_end(square, Pose(), {-1, 1}, {9, 1}, first_of(c)).along_line.nearest(), 0.1);
  EXPECT_EQ(exact_end(square, Pose(), {-1, 1}, {9, 1}, last_of(c)).along_edge.nearest(), 1.0 / 3);
  EXPECT_EQ(exact_end(square, Pose(), {-1, 1}, {9, 1}, last_of(c)).rounded(), (Point2{3, 1}));
  c = cut({0, 0}, {1, 1});
  EXPECT_EQ(kind_of(c), CutKind::across);
  EXPECT_EQ(first_of(c), (CutEnd{Place::vertex, 0}));
  EXPECT_EQ(last_of(c), (CutEnd{Place::vertex, 2}));
  c = cut({5, 0}, {4, 0});
  EXPECT_EQ(kind_of(c), CutKind::along);
  EXPECT_EQ(std::get<CutAlong>(c.evidence).edge, 0u);
  EXPECT_EQ(first_of(c), (CutEnd{Place::vertex, 1}));
  EXPECT_EQ(last_of(c), (CutEnd{Place::vertex, 0}));
  c = cut({-1, 1}, {1, -1});
  EXPECT_EQ(kind_of(c), CutKind::point);
  EXPECT_EQ(last_of(c), (CutEnd{Place::vertex, 0}));
  c = cut({-1, -1}, {9, -1});
  EXPECT_EQ(kind_of(c), CutKind::nothing);
  EXPECT_EQ(std::get<BesideLine>(c.evidence).nearest, 0u);  // of vertices 0 and 1
  c = cut({4, 1}, {4, 0});
  EXPECT_EQ(std::get<BesideLine>(c.evidence).nearest, 1u);
}

TEST(PolygonLineTest, OfSegmentsAndPoints) {
  const ConvexPolygon segment = ConvexPolygon::from_vertices({{0, 0}, {4, 2}});
  PolygonCut c = cut_by_line(segment, Pose(), Line::through({0, 2}, {4, 0}));
  EXPECT_EQ(kind_of(c), CutKind::point);
  EXPECT_EQ(first_of(c), (CutEnd{Place::edge, 0}));
  EXPECT_EQ(exact_end(segment, Pose(), {0, 2}, {4, 0}, first_of(c)).rounded(), (Point2{2, 1}));
  c = cut_by_line(segment, Pose(), Line::through({6, 3}, {-2, -1}));
  EXPECT_EQ(kind_of(c), CutKind::along);
  EXPECT_EQ(first_of(c).feature, 1u);
  EXPECT_EQ(first_of(cut_by_line(segment, Pose(), Line::through({4, 2}, {4, 3}))), (CutEnd{Place::vertex, 1}));
  EXPECT_EQ(std::get<BesideLine>(cut_by_line(segment, Pose(), Line::through({5, 2}, {5, 3})).evidence).nearest, 1u);
  const ConvexPolygon point = ConvexPolygon::from_vertices({{1, 1}});
  EXPECT_EQ(kind_of(cut_by_line(point, Pose(), Line::through({0, 0}, {4, 4}))), CutKind::point);
  EXPECT_EQ(kind_of(cut_by_line(point, Pose(), Line::through({0, 0}, {4, 5}))), CutKind::nothing);
}

TEST(PolygonLineTest, AgreesWithScanOnNastyCases) {
  Random random(tests::chosen_seed(20261208));
  CutCounts counts;
  const int count = tests::scaled_count(40000, 1000);
  for (int i = 0; i < count; ++i) {
    const NastyCase c = nasty_case(random);
    const auto [a, b] = nasty_points(c, random);
    counts.add(c, cut_by_line(c.polygon, c.pose, Line::through(a, b)));
    if (::testing::Test::HasFailure()) FAIL() << "instance " << i;
  }
  counts.expect_all(count, false);
}

TEST(PolygonLineTest, AgreesWithScanOnWildNumbers) {
  Random random(tests::chosen_seed(20261221));
  CutCounts counts;
  for (int i = 0; i < tests::scaled_count(4000, 1000); ++i) {
    const NastyCase c = wild_case(random);
    const Point2 a = wild_point(c, random), b = wild_point(c, random);
    if (a == b) continue;
    counts.add(c, cut_by_line(c.polygon, c.pose, Line::through(a, b)));
    if (::testing::Test::HasFailure()) FAIL() << "instance " << i;
  }
  for (const int k : counts.kinds) EXPECT_GT(k, 10);
}

TEST(PolygonLineTest, AgreesWithScanOnLargePolygons) {
  Random random(tests::chosen_seed(20261209));
  const Pose mirrored = Pose::from_matrix({0, 1, 1, 0}, {0, 0});
  for (const std::uint32_t n : {1000u, 262144u}) {
    for (const double radius : {1.0, 0x1p900, 0x1p-900}) {
      if (n > 65536 && (radius != 1 || tests::is_scaled_down())) continue;  // slow: beyond the range of filters
      const ConvexPolygon p = regular_polygon(n, radius);
      for (int i = 0; i < (n < 2000 ? 50 : 5); ++i) {
        const auto j = static_cast<std::uint32_t>(random.below(n)), k = static_cast<std::uint32_t>(random.below(n));
        const double stretch = 1 + random.uniform(-1, 1) * random.log_uniform(1e-17, 1);
        const Point2 a = p[j], b = i % 3 == 0 ? p[(j + 1) % n] : Point2{p[k].x * stretch, p[k].y * stretch};
        if (a != b)
          static_cast<void>(
              cut_by_line(p, i % 2 == 0 ? Pose() : mirrored, Line::through(a, b), n < 2000 || radius == 1));
      }
    }
  }
}

// 3 log2 n + 5 probes; by Fibonacci search 4.89 log2 n + 11.
TEST(PolygonLineTest, Complexity) {
  Random random(tests::chosen_seed(20261210));
  for (std::uint32_t e = 3; e <= 20; ++e) {
    const std::uint32_t n = 1u << e;
    double worst = 0, worst_by_fibonacci = 0;
    const auto ask_often = [&](const ConvexPolygon& p, double size) {
      for (int i = 0; i < 200; ++i) {
        const auto j = static_cast<std::uint32_t>(random.below(n)), k = static_cast<std::uint32_t>(random.below(n));
        const auto near = [&](const Point2& x) {
          return i % 3 == 0 ? x : Point2{x.x + size * random.uniform(-1, 1), x.y + size * random.uniform(-1, 1)};
        };
        const Point2 a = near(p[j]), b = near(p[i % 6 == 0 ? (j + 1) % n : k]);
        if (a == b) continue;
        const Line line = Line::through(a, b);
        worst = std::max(worst, static_cast<double>(polygon_line(p, line).cost.probes));
        worst_by_fibonacci =
            std::max(worst_by_fibonacci, static_cast<double>(polygon_line_by_fibonacci(p, Pose(), line).cost.probes));
      }
    };
    ask_often(regular_polygon(n), 1);
    for (const std::uint32_t begin : {0u, n / 3, n - 1}) ask_often(parabola(n, begin), n);
    EXPECT_LE(worst, 3.0 * e + 5) << n;
    EXPECT_GE(worst, 2.5 * e) << n;  // hard cases were among them
    EXPECT_LE(worst_by_fibonacci, 4.89 * e + 11) << n;
    std::printf("2^%u: %.0f, by fibonacci %.0f\n", e, worst, worst_by_fibonacci);
  }
}

}  // namespace
}  // namespace sunder::planar
