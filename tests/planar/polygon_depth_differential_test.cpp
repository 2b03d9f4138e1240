// polygon_polygon_depth of all families of pairs: against the scan of all edges and vertices in exact numbers, by
// certificates, and against itself under symmetries.
#include <tests/support/planar_pairs.h>
#include <tests/support/scale.h>

#include <sunder/certificate/pair_claims.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_depth.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::tests {
namespace {

using planar::ConvexPolygon;
using planar::PolygonDepth;
using planar::PolygonDepthAnswer;

std::vector<Point3> in_space(const ConvexPolygon& polygon) {
  std::vector<Point3> vertices;
  for (const Point2& p : polygon.vertices()) vertices.push_back({p.x, p.y, 0});
  return vertices;
}

// A file that states `said`'s bounds of the depth.
std::string depth_claims(const PlanarCase& c, const PolygonDepth& said) {
  std::string text;
  ClaimsWriter file([&text](std::string_view part) { text += part; });
  PairClaims pairs(file, PairClaims::Space::planar);
  const std::vector<Point3> vertices_a = in_space(c.a), vertices_b = in_space(c.b);
  const auto add = [&](const std::vector<Point3>& vertices, const planar::Pose& pose) {
    return pairs.add_placed("p", pairs.add_body("p", vertices), planar::in_space(pose.affine()));
  };
  const std::uint32_t a = add(vertices_a, c.pose_a), b = add(vertices_b, c.pose_b);
  pairs.add_pair(a, b, planar::polygon_polygon(c.a, c.pose_a, c.b, c.pose_b).evidence);
  planar::add_depth(file, a, b, c.a, c.pose_a, c.b, c.pose_b, said);
  pairs.end();
  return text;
}

TEST(PolygonDepthDifferentialTest, AgreesWithTheScanAndIsProved) {
  const int count = scaled_count(3000);
  PlanarPairs pairs(chosen_seed(41));
  int meet = 0, zero = 0, of_a = 0, of_b = 0, refused = 0;
  for (int i = 0; i < count; ++i) {
    const PlanarCase c = pairs.next(i % 3 == 0 ? PlanarFamily::grid : static_cast<PlanarFamily>(i % 9));
    if (c.a.size() + c.b.size() > 60) continue;
    const PolygonDepthAnswer answer = polygon_polygon_depth(c.a, c.pose_a, c.b, c.pose_b),
                             scan = polygon_polygon_depth_by_scan(c.a, c.pose_a, c.b, c.pose_b),
                             swapped = polygon_polygon_depth(c.b, c.pose_b, c.a, c.pose_a);
    ASSERT_EQ(answer.meet(), scan.meet()) << i;
    ASSERT_EQ(answer.meet(), swapped.meet()) << i;
    if (!answer.meet()) continue;
    ++meet;
    const auto& depth = std::get<PolygonDepth>(answer.evidence);
    ASSERT_EQ(depth.squared, std::get<PolygonDepth>(scan.evidence).squared) << i << " " << name_of(c.family);
    ASSERT_EQ(depth.squared, std::get<PolygonDepth>(swapped.evidence).squared) << i;
    of_a += depth.edge_of_a;
    of_b += depth.edge_of_b;
    zero += depth.depth.high == 0;
    const auto verdict = [&](const PolygonDepth& said) {
      const sunder_verifier::FileResult result = sunder_verifier::verify_text(depth_claims(c, said), "test");
      EXPECT_TRUE(result.readable && result.failed_form.empty()) << result.error << result.failed_form;
      return result.accepted();
    };
    if (!std::isfinite(depth.depth.high)) continue;
    ASSERT_TRUE(verdict(depth)) << i << " " << name_of(c.family);
    // More than the depth at least, less than the depth at most: untrue, and refused.
    PolygonDepth more = depth, less = depth;
    more.depth.low = std::nextafter(depth.depth.high, HUGE_VAL);
    if (depth.depth.low > 0 && std::isfinite(more.depth.low)) {
      ASSERT_FALSE(verdict(more)) << i;
      less.depth.high = std::nextafter(depth.depth.low, 0);
      ASSERT_FALSE(verdict(less)) << i;
      ++refused;
    }
  }
  if (count < 2000) return;
  EXPECT_GT(meet, count / 4);
  EXPECT_GT(of_a, meet / 10);
  EXPECT_GT(of_b, meet / 10);
  EXPECT_GT(zero, meet / 50);
  EXPECT_GT(refused, meet / 4);
}

}  // namespace
}  // namespace sunder::tests
