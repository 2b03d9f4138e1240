#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <sunder/solid/pair/polyhedron_plane_section.h>

#include <gtest/gtest.h>

namespace sunder::solid {
namespace {

TEST(PolyhedronPlaneSectionTest, CubeInTheMiddle) {
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  const Plane plane = Plane::at({0, 0, 1}, 0.5);
  const PlaneSection section = polyhedron_plane_section(cube, Pose(), plane);
  ASSERT_EQ(section.kind, SectionKind::polygon);
  EXPECT_EQ(section.corners.size(), 4u);
  const SectionPoints points(cube, Pose(), plane);
  double area = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Point3 p = points.nearest(section.corners[k]), q = points.nearest(section.corners[(k + 1) % 4]);
    EXPECT_EQ(p.z, 0.5);
    area += p.x * q.y - p.y * q.x;
  }
  EXPECT_EQ(area, 2);
}

}  // namespace
}  // namespace sunder::solid
