#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/represent/half_edges.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/section/polyhedron_plane_section.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sunder::solid {
namespace {

using tests::cube_corners;

TEST(PolyhedronPlaneSectionTest, CubeInTheMiddle) {
  const ConvexPolyhedron cube(cube_corners(0, 1));
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
  EXPECT_EQ(area, 2);  // counter-clockwise
}

TEST(PolyhedronPlaneSectionTest, EachKind) {
  const ConvexPolyhedron cube(cube_corners(0, 1));
  const auto section = [&](const Plane& plane) { return polyhedron_plane_section(cube, Pose(), plane); };
  EXPECT_EQ(section(Plane::at({1, 1, 1}, 3)).kind, SectionKind::point);
  EXPECT_EQ(section(Plane::at({1, 1, 0}, 2)).kind, SectionKind::segment);
  EXPECT_EQ(section(Plane::at({0, 0, -1}, -1)).corners.size(), 4u);
  EXPECT_EQ(section(Plane::at({1, 1, 1}, 1.5)).corners.size(), 6u);
  const PlaneSection above = section(Plane::at({1, 0, 0}, -1)), below = section(Plane::at({1, 0, 0}, 2));
  EXPECT_EQ(above.kind, SectionKind::nothing);
  EXPECT_EQ(above.side, Sign::positive);
  EXPECT_EQ(below.side, Sign::negative);
  EXPECT_EQ(cube.vertices()[below.nearest].x, 1);
  EXPECT_EQ(name_of(SectionKind::segment), "segment");
}

// The next double above the facet is beyond it.
TEST(PolyhedronPlaneSectionTest, TheLastBit) {
  const ConvexPolyhedron cube(cube_corners(0, 1));
  EXPECT_EQ(polyhedron_plane_section(cube, Pose(), Plane::at({0, 0, 1}, std::nextafter(1, 2))).side, Sign::negative);
  const PlaneSection inside = polyhedron_plane_section(cube, Pose(), Plane::at({0, 0, 1}, std::nextafter(1, 0)));
  ASSERT_EQ(inside.corners.size(), 4u);
  EXPECT_TRUE(std::ranges::none_of(inside.corners, &SectionCorner::is_vertex));
}

TEST(PolyhedronPlaneSectionTest, AStackIsTheSectionsOneByOne) {
  Random random(5);
  const ConvexPolyhedron body(tests::solid_shapes::sphere(500, random));
  const Plane plane = Plane::through({0.1, 0, 0}, {1, 2, 3});
  std::vector<double> offsets;
  for (int k = -50; k <= 50; ++k) offsets.push_back(k / 8.0);
  std::size_t next = 0;
  polyhedron_plane_sections(body, Pose(), plane, offsets, [&](std::size_t k, const PlaneSection& section) {
    ASSERT_EQ(k, next++);
    Plane at = plane;
    at.offset = offsets[k];
    const PlaneSection alone = polyhedron_plane_section_by_scan(body, Pose(), at);
    EXPECT_EQ(section.corners, alone.corners);
    EXPECT_EQ(section.side, alone.side);
  });
  EXPECT_EQ(next, offsets.size());
  const std::vector<double> bad{0, std::nan("")};
  EXPECT_THROW(polyhedron_plane_sections(body, Pose(), plane, bad, [](std::size_t, const PlaneSection&) {}), Error);
}

TEST(PolyhedronPlaneSectionTest, HalfEdgesOfEveryFamily) {
  Random random(6);
  for (const tests::SolidShape& shape : tests::all_solid_shapes()) {
    const ConvexPolyhedron body(shape.make(200, random));
    if (body.dimension() < 2) continue;
    const HalfEdges& edges = represent::of<HalfEdges>(body);
    for (std::uint32_t e = 0; e < edges.twin.size(); ++e) {
      ASSERT_EQ(edges.twin[edges.twin[e]], e) << shape.name;
      ASSERT_EQ(edges.tip(e), edges.origin[edges.along(e, 1)]);
      ASSERT_EQ(edges.turned(e, 0), e);
    }
    for (std::uint32_t v = 0; v < body.vertices().size(); ++v) {
      std::vector<std::uint32_t> tips;
      for (std::uint32_t k = 0; k < edges.degree(v); ++k) tips.push_back(edges.tip(edges.out[edges.begin[v] + k]));
      std::rotate(tips.begin(), std::min_element(tips.begin(), tips.end()), tips.end());
      std::vector<std::uint32_t> expected(body.neighbours(v).begin(), body.neighbours(v).end());
      std::rotate(expected.begin(), std::min_element(expected.begin(), expected.end()), expected.end());
      ASSERT_EQ(tips, expected) << shape.name;  // counter-clockwise, too
    }
  }
}

// Probes are at most 60 log2 n + 8 k: no family, whatever its degrees and facets, makes a cliff.
TEST(PolyhedronPlaneSectionTest, ProbesGrowAsTheLogarithmAndTheCorners) {
  Random random(7);
  const int greatest = tests::scaled_count(15, 12);
  for (const tests::SolidShape& shape : tests::all_solid_shapes()) {
    double ratio = 0;
    for (int power = 5; power <= greatest; ++power) {
      const ConvexPolyhedron body(shape.make(std::size_t{1} << power, random));
      const auto vertex = [&] { return body.vertices()[random.below(body.vertices().size())]; };
      for (int i = 0; i < 40; ++i) {
        Point3 normal = tests::in_cube(random), p = vertex();
        const Point3 q = vertex();
        if (i % 4 == 1) p = {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
        if (i % 4 == 2) normal = i % 8 == 2 ? Point3{0, 0, 1} : Point3{1, 0, 0};
        if (i % 4 == 3) normal = {p.y - q.y, q.x - p.x, 0};  // through both, where they are as high
        if (normal == Point3{}) normal.x = 1;
        const PlaneSection section = polyhedron_plane_section(body, Pose(), Plane::through(p, normal));
        const double allowed = 60 * std::log2(static_cast<double>(body.vertices().size()) + 2) +
                               8 * static_cast<double>(section.corners.size());
        ratio = std::max(ratio, static_cast<double>(section.cost.probes) / allowed);
        ASSERT_LE(static_cast<double>(section.cost.probes), allowed)
            << shape.name << " n " << body.vertices().size() << " k " << section.corners.size() << " way " << i % 4;
      }
    }
    std::printf("%-14s at most %.2f of what is allowed\n", std::string(shape.name).c_str(), ratio);
  }
}

}  // namespace
}  // namespace sunder::solid
