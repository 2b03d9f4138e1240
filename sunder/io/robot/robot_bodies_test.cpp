#include <sunder/io/robot/robot_bodies.h>
#include <sunder/io/robot/robot_motion.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace sunder::io {
namespace {

namespace fs = std::filesystem;
using Pairs = std::vector<std::array<std::uint32_t, 2>>;

std::string box_link(const std::string& name) {
  return "<link name='" + name + "'><collision><geometry><box size='1 2 3'/></geometry></collision></link>";
}
std::string joint(const std::string& parent, const std::string& child) {
  return "<joint name='" + parent + child + "' type='fixed'><parent link='" + parent + "'/><child link='" + child +
         "'/><origin xyz='10 0 0'/></joint>";
}

fs::path write(const std::string& name, const std::string& text) {
  const fs::path path = fs::path(testing::TempDir()) / name;
  std::ofstream(path) << text;
  return path;
}

TEST(RobotBodies, LinksJoinedThroughLinksWithoutShapesAreAdjacent) {
  // a - x - b and x - y - c, where x and y have no shapes; d hangs on c.
  const Robot robot = parse_urdf("<robot name='r'>" + box_link("a") + "<link name='x'/><link name='y'/>" +
                                     box_link("b") + box_link("c") + box_link("d") + joint("a", "x") + joint("x", "b") +
                                     joint("x", "y") + joint("y", "c") + joint("c", "d") + "</robot>",
                                 "r.urdf");
  LeftOutList left_out(false);
  const RobotBodies bodies = read_robot_bodies(robot, "r.urdf", true, left_out);
  ASSERT_EQ(bodies.bodies.size(), 4u);  // a, b, c, d
  EXPECT_TRUE(bodies.meshes.empty());
  EXPECT_EQ(adjacent_bodies(robot, bodies), (Pairs{{0, 1}, {0, 2}, {1, 2}, {2, 3}}));

  const auto poses = link_poses(robot, {});
  const LinkBody& d = bodies.bodies[3];
  const scene::Body placed = placed_body("d", d.parts, poses[d.link]);
  ASSERT_EQ(placed.parts.size(), 1u);
  EXPECT_EQ(placed.parts[0].name, "0");
  const auto& [matrix, moved] = placed.parts[0].pose.affine();
  EXPECT_EQ(moved[0], 40.0);  // a, x, y, c, d
}

TEST(RobotBodies, ShapesWithARadiusAreWhatTheyAre) {
  const auto shape = [](const std::string& element) {
    return "<collision><geometry>" + element + "</geometry></collision>";
  };
  const Robot robot = parse_urdf(
      "<robot name='r'><link name='a'>" + shape("<sphere radius='2'/>") + shape("<cylinder radius='1' length='3'/>") +
          shape("<capsule radius='0.5' length='4'/>") + shape("<box size='1 2 3'/>") + "</link></robot>",
      "r.urdf");
  EXPECT_TRUE(robot.left_out.empty());
  LeftOutList left_out(false);
  const RobotBodies bodies = read_robot_bodies(robot, "r.urdf", true, left_out);
  ASSERT_EQ(bodies.bodies.size(), 1u);
  const std::vector<BodyPart>& parts = bodies.bodies[0].parts;
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_EQ(parts[0].shape().kind(), RoundKind::hull);
  EXPECT_EQ(parts[0].shape().points().size(), 1u);
  EXPECT_EQ(parts[0].shape().radius(), 2);
  EXPECT_EQ(parts[1].shape().kind(), RoundKind::cylinder);
  EXPECT_EQ(parts[1].shape().points()[0], (Point3{0, 0, -1.5}));
  EXPECT_EQ(parts[1].shape().points()[1], (Point3{0, 0, 1.5}));
  EXPECT_EQ(parts[1].shape().radius(), 1);
  EXPECT_EQ(parts[2].shape().kind(), RoundKind::hull);
  EXPECT_EQ(parts[2].shape().points().size(), 2u);
  EXPECT_EQ(parts[2].shape().points()[0].z, -parts[2].shape().points()[1].z);
  EXPECT_EQ(parts[2].shape().radius(), 0.5);
  EXPECT_TRUE(parts[3].shape().is_polyhedron());
  for (const char* const bad : {"<sphere/>", "<sphere radius='-1'/>", "<sphere radius='x'/>", "<cylinder radius='1'/>",
                                "<cylinder radius='1' length='0'/>", "<cylinder radius='1' length='-1'/>",
                                "<capsule radius='1' length='-1'/>", "<capsule length='1'/>"}) {
    EXPECT_THROW(static_cast<void>(parse_urdf("<robot name='r'><link name='a'>" + shape(bad) + "</link></robot>", "r")),
                 Error)
        << bad;
  }
}

TEST(RobotBodies, AMeshThatIsMissingIsLeftOutWithConsentOnly) {
  const fs::path file = write("gap.urdf",
                              "<robot name='r'><link name='a'><collision><geometry><mesh filename='no_such.obj'/>"
                              "</geometry></collision></link></robot>");
  const Robot robot = read_urdf(file);
  LeftOutList strict(false), lenient(true);
  EXPECT_THROW(static_cast<void>(read_robot_bodies(robot, file, false, strict)), Error);
  EXPECT_TRUE(read_robot_bodies(robot, file, false, lenient).bodies.empty());
  EXPECT_EQ(lenient.text(), "1 mesh of a");
}

TEST(RobotBodies, VisualsAreToldWhereOtherLinksHaveCollisionShapes) {
  const std::string visual = "<link name='v'><visual><geometry><box size='1 1 1'/></geometry></visual></link>";
  const std::string round =
      "<link name='a'><collision><geometry><ellipsoid radii='1 1 1'/></geometry></collision></link>";
  const Robot some = parse_urdf("<robot>" + box_link("a") + visual + joint("a", "v") + "</robot>", "r.urdf");
  LeftOutList strict(false);
  const RobotBodies bodies = read_robot_bodies(some, "r.urdf", true, strict);
  EXPECT_TRUE(strict.empty());
  ASSERT_EQ(bodies.told.size(), 1u);
  EXPECT_EQ(bodies.told[0].of, "v");

  const Robot none = parse_urdf("<robot>" + visual + "</robot>", "r.urdf");
  EXPECT_THROW(static_cast<void>(read_robot_bodies(none, "r.urdf", true, strict)), Error);
  const Robot balls = parse_urdf("<robot>" + round + visual + joint("a", "v") + "</robot>", "r.urdf");
  LeftOutList lenient(true);
  EXPECT_EQ(read_robot_bodies(balls, "r.urdf", true, lenient).told.size(), 1u);
  EXPECT_EQ(lenient.text(), "1 ellipsoid of a");
}

TEST(RobotBodies, AMeshOfSeveralLinksIsReadOnce) {
  const fs::path mesh =
      write("tetrahedron.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  const std::string shape = "<collision><geometry><mesh filename='tetrahedron.obj'/></geometry></collision>";
  const fs::path file = write("twice.urdf", "<robot name='r'><link name='a'>" + shape + "</link><link name='b'>" +
                                                shape + "</link>" + joint("a", "b") + "</robot>");
  LeftOutList left_out(false);
  InputFiles inputs;
  const RobotBodies bodies = read_robot_bodies(read_urdf(file), file, true, left_out, &inputs);
  ASSERT_EQ(bodies.bodies.size(), 2u);
  EXPECT_EQ(bodies.meshes, std::vector<fs::path>{mesh});
  EXPECT_EQ(inputs.size(), 1u);
  EXPECT_EQ(bodies.bodies[1].parts[0].body.shape, BodyShape::convex);
}

TEST(MeshBody, WhatIsNotConvexHasAHullAndAReason) {
  // A tetrahedron with a dent: the face opposite to vertex 1 is three faces around a point within.
  const fs::path file = write("dent.obj",
                              "v 9 9 9\nv 0 0 0\nv 8 0 0\nv 0 8 0\nv 0 0 8\nv 1 1 1\n"
                              "f 2 4 3\nf 2 3 5\nf 2 5 4\nf 3 4 6\nf 4 5 6\nf 5 3 6\n");
  LeftOutList left_out(true);
  const MeshBody body = read_body(file, false, left_out);
  EXPECT_EQ(body.shape, BodyShape::hull);
  EXPECT_NE(body.why_hull.find("reflex edge"), std::string::npos) << body.why_hull;
  EXPECT_NE(body.why_hull.find("vertex 5 (1, 1, 1)"), std::string::npos) << body.why_hull;  // as the file numbers them
  EXPECT_EQ(body.mesh_vertices, 5u);
  EXPECT_EQ(body.hull.vertices().size(), 4u);
  ASSERT_TRUE(body.departure);
  EXPECT_THROW(static_cast<void>(read_body(file, true, left_out)), Error);
  const auto [of_points, mesh] = read_hull(file, left_out);
  EXPECT_EQ(mesh.vertices.size(), 5u);
  EXPECT_EQ(of_points.hull.vertices().size(), 4u);
}

}  // namespace
}  // namespace sunder::io
