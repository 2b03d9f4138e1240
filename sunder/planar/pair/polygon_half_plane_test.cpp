// A half-plane and a polygon: the search against the scan and against the line, and what it costs.
#include <sunder/planar/pair/cut_test.h>
#include <sunder/planar/pair/polygon_half_plane.h>
#include <sunder/planar/pair/polygon_line.h>

#include <algorithm>

namespace sunder::planar {
namespace {

PolygonHalfPlane meets_half_plane(const ConvexPolygon& polygon, const Pose& pose, const HalfPlane& h,
                                  bool with_scan = true) {
  const PolygonHalfPlane found = polygon_half_plane(polygon, pose, h);
  // The line meets the polygon iff this half-plane and the other one do.
  const PolygonHalfPlane other = polygon_half_plane(polygon, pose, HalfPlane::left_of(h.b, h.a));
  const PolygonCut line = polygon_line(polygon, pose, Line::through(h.a, h.b));
  EXPECT_TRUE(found.meet || other.meet);
  EXPECT_EQ(found.meet && other.meet, line.meet());
  EXPECT_EQ(found.touching || other.touching,
            line.meet() && kind_of(line) != CutKind::across && !(first_of(line).place == Place::edge));
  if (const auto* beside = std::get_if<BesideLine>(&line.evidence)) {
    EXPECT_EQ(beside->nearest, found.meet ? other.witness : found.witness);
  }
  if (!with_scan) return found;
  const PolygonHalfPlane scanned = polygon_half_plane_by_scan(polygon, pose, h);
  EXPECT_EQ(found.meet, scanned.meet);
  EXPECT_EQ(found.touching, scanned.touching);
  EXPECT_EQ(found.witness, scanned.witness);
  return found;
}

TEST(PolygonHalfPlaneTest, ByHand) {
  const ConvexPolygon square = ConvexPolygon::from_vertices({{0, 0}, {3, 0}, {3, 3}, {0, 3}});
  const auto at = [&](double y) { return meets_half_plane(square, Pose(), HalfPlane::left_of({0, y}, {1, y})); };
  EXPECT_TRUE(at(2).meet);
  EXPECT_FALSE(at(2).touching);
  EXPECT_EQ(at(2).witness, 2u);
  EXPECT_TRUE(at(3).meet);
  EXPECT_TRUE(at(3).touching);
  EXPECT_FALSE(at(std::nextafter(3, 4)).meet);
  EXPECT_TRUE(
      meets_half_plane(ConvexPolygon::from_vertices({{1, 1}}), Pose(), HalfPlane::left_of({0, 0}, {3, 3})).touching);
}

TEST(PolygonHalfPlaneTest, AgreesWithScanOnNastyCases) {
  Random random(tests::chosen_seed(20261215));
  int meets = 0, touches = 0;
  const int count = tests::scaled_count(40000, 1000);
  for (int i = 0; i < count; ++i) {
    const NastyCase c = nasty_case(random);
    const auto [a, b] = nasty_points(c, random);
    const PolygonHalfPlane answer = meets_half_plane(c.polygon, c.pose, HalfPlane::left_of(a, b));
    if (HasFailure()) FAIL() << "instance " << i;
    meets += answer.meet ? 1 : 0;
    touches += answer.touching ? 1 : 0;
  }
  EXPECT_GT(meets, count / 4);
  EXPECT_LT(meets, count - count / 50);
  EXPECT_GT(touches, count / 20);
}

TEST(PolygonHalfPlaneTest, LargePolygonsAndComplexity) {
  Random random(tests::chosen_seed(20261216));
  for (std::uint32_t e = 3; e <= 20; ++e) {
    const std::uint32_t n = 1u << e;
    double worst = 0;
    for (const ConvexPolygon& p : {regular_polygon(n), parabola(n), parabola(n, n / 2)}) {
      for (int i = 0; i < 100; ++i) {
        const auto j = static_cast<std::uint32_t>(random.below(n)), k = static_cast<std::uint32_t>(random.below(n - 1));
        const std::uint32_t to = i % 2 == 0 ? (j + 1) % n : k + (k >= j ? 1 : 0);
        const PolygonHalfPlane answer =
            meets_half_plane(p, Pose(), HalfPlane::left_of(p[to], p[j]), n < 300000 && i < 4);
        if (i % 2 == 0) {
          EXPECT_TRUE(answer.touching);
        }
        worst = std::max(worst, static_cast<double>(answer.cost.probes));
      }
    }
    EXPECT_LE(worst, 1.1 * e + 2) << n;
  }
}

}  // namespace
}  // namespace sunder::planar
