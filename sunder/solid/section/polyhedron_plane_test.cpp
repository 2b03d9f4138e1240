#include <sunder/solid/section/polyhedron_plane.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

namespace sunder::solid {
namespace {

ConvexPolyhedron unit_cube() {
  std::vector<Point3> corners;
  for (const double x : {0.0, 1.0}) {
    for (const double y : {0.0, 1.0}) {
      for (const double z : {0.0, 1.0}) corners.push_back({x, y, z});
    }
  }
  return ConvexPolyhedron(corners);
}

TEST(PolyhedronPlane, SidesOfACube) {
  const ConvexPolyhedron body = unit_cube();
  const auto ask = [&](const Plane& plane) { return polyhedron_plane(body, Pose(), plane); };
  const PolyhedronPlane above = ask(Plane::at({0, 0, 1}, -0x1p-1074));
  EXPECT_EQ(side_of(above), Sign::positive);
  EXPECT_EQ(body.vertices()[std::get<BesidePlane>(above.evidence).nearest].z, 0);
  EXPECT_EQ(side_of(ask(Plane::through({5, 5, std::nextafter(1, 2)}, {0, 0, 3}))), Sign::negative);
  EXPECT_TRUE(ask(Plane::at({0, 0, 1}, 0)).meet());
  EXPECT_TRUE(ask(Plane::at({1, 1, 1}, 3)).meet());
  EXPECT_TRUE(ask(Plane::at({1, 1, 1}, 1.5)).meet());
  EXPECT_EQ(side_of(ask(Plane::at({1, 1, 1}, std::nextafter(3, 4)))), Sign::negative);
  EXPECT_EQ(ask(Plane::at({1e300, 1e300, 1e300}, 3e300)).meet(), 1e300 + 1e300 + 1e300 >= 3e300);
}

TEST(PolyhedronPlane, Contacts) {
  const ConvexPolyhedron body = unit_cube();
  const auto contact = [&](const Plane& plane) { return polyhedron_plane_contact(body, Pose(), plane); };
  EXPECT_EQ(contact(Plane::at({0, 0, 1}, -1)), Relation::none);
  EXPECT_EQ(contact(Plane::at({0, 0, 1}, 0)), Relation::touching);
  EXPECT_EQ(contact(Plane::at({1, 1, 0}, 2)), Relation::touching);
  EXPECT_EQ(contact(Plane::at({1, 1, 0}, 1)), Relation::overlapping);
  const ConvexPolyhedron flat(std::array{Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{0, 1, 0}});
  EXPECT_EQ(polyhedron_plane_contact(flat, Pose(), Plane::at({0, 0, 1}, 0)), Relation::overlapping);
  EXPECT_EQ(polyhedron_plane_contact(flat, Pose(), Plane::at({1, 0, 0}, 0)), Relation::touching);
}

TEST(Plane, Refused) {
  EXPECT_THROW(Plane::at({0, -0.0, 0}, 1), Error);
  EXPECT_THROW(Plane::at({1, 0, 0}, std::nan("")), Error);
  EXPECT_THROW(Plane::through({std::numeric_limits<double>::infinity(), 0, 0}, {1, 0, 0}), Error);
}

}  // namespace
}  // namespace sunder::solid
