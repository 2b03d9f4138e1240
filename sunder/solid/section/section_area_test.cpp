#include <sunder/base/random.h>
#include <sunder/solid/section/section_area.h>
#include <sunder/solid/section/section_claims.h>

#include <gtest/gtest.h>
#include <tests/support/scale.h>
#include <verifier/cpp/verify.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace sunder::solid {
namespace {

AreaBounds area_of(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane) {
  return section_area(polyhedron_plane_section(body, pose, plane), SectionPoints(body, pose, plane), plane.normal);
}

ConvexPolyhedron box(double x, double y, double z) {
  std::vector<Point3> corners;
  for (const double a : {0.0, x}) {
    for (const double b : {0.0, y}) {
      for (const double c : {0.0, z}) corners.push_back({a, b, c});
    }
  }
  return ConvexPolyhedron(corners);
}

void expect_about(const AreaBounds& area, double wanted) {
  EXPECT_LE(area.low, wanted);
  EXPECT_GE(area.high, wanted);
  EXPECT_LE(area.high - area.low, wanted * 0x1p-44);
}

TEST(SectionArea, OfBoxes) {
  expect_about(area_of(box(2, 3, 5), Pose(), Plane::at({0, 0, 1}, 1)), 6);
  expect_about(area_of(box(2, 3, 5), Pose(), Plane::at({0, 0, -0x1p+900}, 0)), 6);
  expect_about(area_of(box(2, 2, 2), Pose(), Plane::at({1, 1, 1}, 3)), 3 * std::sqrt(3));
  expect_about(area_of(box(0x1p-400, 0x1p-400, 1), Pose(), Plane::at({0, 0, 1}, 0.5)), 0x1p-800);
}

TEST(SectionArea, BeyondDoubles) {
  const AreaBounds least = area_of(box(0x1p-600, 0x1p-600, 1), Pose(), Plane::at({0, 0, 1}, 0.5));
  EXPECT_EQ(least.low, 0);
  EXPECT_LT(least.high, 0x1p-990);
  EXPECT_TRUE(std::isinf(area_of(box(0x1p+600, 0x1p+600, 1), Pose(), Plane::at({0, 0, 1}, 0.5)).high));
  EXPECT_EQ(area_of(box(1, 1, 1), Pose(), Plane::at({1, 1, 1}, 3)).high, 0);
}

// The checker finds them true, of bodies and planes in any places.
TEST(SectionArea, IsProved) {
  Random random(tests::chosen_seed(17));
  int measured = 0;
  for (int i = 0; i < tests::scaled_count(200); ++i) {
    const auto any = [&] { return random.uniform(-1, 1); };
    const double size = std::exp2(static_cast<double>(random.between(-40, 40)));
    std::vector<Point3> points;
    for (int k = 0; k < 12; ++k) points.push_back({any() * size, any() * size, any() * size});
    const ConvexPolyhedron body(points);
    const Pose pose = Pose::from_matrix({0, -1, 0, 1, 0, 0, 0, 0, 1}, {any(), any(), any()});
    const Plane plane = Plane::at({any(), any(), any()}, any() * size * 0.1);
    const PlaneSection section = polyhedron_plane_section(body, pose, plane);
    measured += section.kind == SectionKind::polygon ? 1 : 0;
    const std::string text = claims_text({}, [&](ClaimsWriter& file) {
      SectionClaims claims(file, "body", body, pose);
      claims.add(plane, section);
    });
    ASSERT_TRUE(sunder_verifier::verify_text(text, "section").accepted()) << text;
  }
  EXPECT_GT(measured, 0);
}

}  // namespace
}  // namespace sunder::solid
