// The extreme vertices: all methods against each other, and what they cost.
#include <sunder/planar/pair/extreme_vertex.h>
#include <sunder/planar/pair/one_polygon_test.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sunder::planar {
namespace {

// What the methods cost, at most.
struct Worst {
  double fibonacci = 0, bisection = 0, both = 0;
};

template <class Sequence>
Extremes compare_methods(const Sequence& p, const typename Sequence::Vertex& from, const typename Sequence::Vertex& to,
                         bool with_scan, Worst& worst) {
  Cost of_fibonacci, of_bisection, of_both, unused;
  StageTally tally;
  const Extremes f = extreme_vertices_by_fibonacci(p, from, to, of_fibonacci, tally);
  const Extremes b = extreme_vertices_by_bisection(p, from, to, of_both, tally);
  EXPECT_EQ(f.left, b.left);
  EXPECT_EQ(f.right, b.right);
  EXPECT_EQ(extreme_vertex_by_bisection(p, from, to, of_bisection, tally), b.left);
  if (with_scan) {
    const Extremes s = extreme_vertices_by_scan(p, from, to, unused, tally);
    EXPECT_EQ(s.left, f.left);
    EXPECT_EQ(s.right, f.right);
  }
  // Turned round, the sides are exchanged; of two vertices it is now the other one.
  const Extremes r = extreme_vertices_by_bisection(p, to, from, unused, tally);
  EXPECT_EQ(cross_2d(from, to, p[r.left], p[f.right]), Sign::zero);
  EXPECT_EQ(cross_2d(from, to, p[r.right], p[f.left]), Sign::zero);
  worst.fibonacci = std::max(worst.fibonacci, static_cast<double>(of_fibonacci.probes));
  worst.bisection = std::max(worst.bisection, static_cast<double>(of_bisection.probes));
  worst.both = std::max(worst.both, static_cast<double>(of_both.probes));
  return f;
}

TEST(ExtremeVertexTest, ByHand) {
  const ConvexPolygon square = ConvexPolygon::from_vertices({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  Worst worst;
  const auto extremes = [&](const ConvexPolygon& p, const Point2& to) {
    const Extremes e = compare_methods(PlainPolygon(p), Point2{0, 0}, to, true, worst);
    return std::array{e.left, e.right};
  };
  EXPECT_EQ(extremes(square, {1, 1}), (std::array{3u, 1u}));
  EXPECT_EQ(extremes(square, {1, 0}), (std::array{2u, 1u}));  // of two, the one further along
  EXPECT_EQ(extremes(square, {-1, 0}), (std::array{0u, 3u}));
  EXPECT_EQ(extremes(square, {0, 1}), (std::array{3u, 2u}));
  EXPECT_EQ(extremes(square, {0, -1}), (std::array{1u, 0u}));
  const ConvexPolygon segment = ConvexPolygon::from_vertices({{3, 0}, {0, 0}});
  EXPECT_EQ(extremes(segment, {1, 0}), (std::array{0u, 0u}));
  EXPECT_EQ(extremes(segment, {-1, 0}), (std::array{1u, 1u}));
  EXPECT_EQ(extremes(segment, {0, 1}), (std::array{1u, 0u}));
  EXPECT_EQ(extremes(ConvexPolygon::from_vertices({{7, 7}}), {0, 1}), (std::array{0u, 0u}));
}

TEST(ExtremeVertexTest, MethodsAgreeOnNastyCases) {
  Random random(tests::chosen_seed(20261202));
  Worst worst;
  int ties = 0, segments = 0, points = 0, reflected = 0;
  const int count = tests::scaled_count(40000, 1000);
  for (int i = 0; i < count; ++i) {
    const NastyCase c = nasty_case(random);
    Point2 from{}, to{};
    while (from == to) {
      from = nasty_point(c, random);
      to = nasty_point(c, random);
    }
    if (c.pose.is_identity()) {
      const PlainPolygon p(c.polygon);
      const Extremes e = compare_methods(p, from, to, true, worst);
      const std::uint32_t next = position(p, e.left + 1);
      ties += next != e.left && cross_2d(from, to, p[e.left], p[next]) == Sign::zero ? 1 : 0;
    } else {
      const Affine2 world;
      compare_methods(PosedPolygon(c.polygon, c.pose), {from, &world, false}, {to, &world, false}, true, worst);
    }
    if (HasFailure()) FAIL() << "instance " << i;
    segments += c.polygon.size() == 2 ? 1 : 0;
    points += c.polygon.size() == 1 ? 1 : 0;
    reflected += c.pose.reflects() ? 1 : 0;
  }
  EXPECT_GT(ties, count / 20);
  EXPECT_GT(segments, count / 50);
  EXPECT_GT(points, count / 50);
  EXPECT_GT(reflected, count / 8);
}

TEST(ExtremeVertexTest, MethodsAgreeOnWildNumbers) {
  Random random(tests::chosen_seed(20261223));
  Worst worst;
  for (int i = 0; i < tests::scaled_count(4000, 1000); ++i) {
    const NastyCase c = wild_case(random);
    const Point2 from = wild_point(c, random), to = wild_point(c, random);
    if (from == to) continue;
    const Affine2 world;
    compare_methods(PlainPolygon(c.polygon), from, to, true, worst);
    compare_methods(PosedPolygon(c.polygon, c.pose), {from, &world, false}, {to, &world, false}, true, worst);
    if (HasFailure()) FAIL() << "instance " << i;
  }
}

TEST(ExtremeVertexTest, MethodsAgreeOnLargePolygons) {
  Random random(tests::chosen_seed(20261203));
  Worst worst;
  for (const std::uint32_t n : {1000u, 65536u, 262144u}) {
    for (const double radius : {1.0, 0x1p900, 0x1p-900}) {
      if (n > 65536 && (radius != 1 || tests::is_scaled_down())) continue;  // slow: beyond the range of filters
      const ConvexPolygon p = regular_polygon(n, radius);
      const PlainPolygon plain(p);
      const Pose mirrored = Pose::from_matrix({0, 1, 1, 0}, {0, radius});
      const PosedPolygon posed(p, mirrored);
      const Affine2 world;
      for (int i = 0; i < 6; ++i) {
        // Parallel to an edge, or any way.
        const auto k = static_cast<std::uint32_t>(random.below(n - 1));
        const Point2 from = p[k], to = i % 2 == 0 ? p[k + 1] : Point2{radius * random.unit(), radius * random.unit()};
        compare_methods(plain, from, to, i < 2 && (n < 2000 || radius == 1), worst);
        compare_methods(posed, Posed2{from, &world, false}, Posed2{to, &world, false},
                        i < 2 && (n < 2000 || radius == 1), worst);
      }
    }
  }
}

// 2.89 log2 n + 7 evaluations for both vertices by Fibonacci search, 1.1 log2 n + 1 looks at edges for one and
// 2 log2 n + 1 for both by bisection.
TEST(ExtremeVertexTest, Complexity) {
  Random random(tests::chosen_seed(20261204));
  double most = 0;
  for (std::uint32_t e = 3; e <= 20; ++e) {
    const std::uint32_t n = 1u << e;
    Worst worst;
    const auto ask = [&](const ConvexPolygon& p) {
      const PlainPolygon plain(p);
      for (int i = 0; i < 200; ++i) {
        const auto j = static_cast<std::uint32_t>(random.below(n)), k = static_cast<std::uint32_t>(random.below(n));
        const Point2 &a = p[j], &b = i % 4 == 0 ? p[(j + 1) % n] : p[k];
        if (j != k) compare_methods(plain, a, b, false, worst);
        const double angle = random.uniform(0, 7);
        compare_methods(plain, {0, 0}, {std::cos(angle), std::sin(angle)}, false, worst);
      }
    };
    ask(regular_polygon(n));
    for (const std::uint32_t begin : {0u, n / 3, n / 2, n - 1}) ask(parabola(n, begin));
    EXPECT_LE(worst.fibonacci, 2.89 * e + 7) << n;
    EXPECT_GE(worst.fibonacci, 2.5 * e) << n;  // hard cases were among them
    EXPECT_LE(worst.bisection, 1.1 * e + 1) << n;
    EXPECT_LE(worst.both, 2.0 * e + 1) << n;
    most = std::max(most, worst.fibonacci - 2.8808 * e);
    std::printf("2^%u: fibonacci %.0f (%.2f log2 n), bisection %.0f, both %.0f\n", e, worst.fibonacci,
                worst.fibonacci / e, worst.bisection, worst.both);
  }
  std::printf("fibonacci: 2.8808 log2 n + %.2f\n", most);
}

}  // namespace
}  // namespace sunder::planar
