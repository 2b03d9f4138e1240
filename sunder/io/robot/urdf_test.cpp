#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh.h>
#include <sunder/io/mesh/space_objects.h>
#include <sunder/io/robot/packages.h>
#include <sunder/io/robot/robot_motion.h>
#include <sunder/io/robot/urdf.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace sunder::io {
namespace {

namespace fs = std::filesystem;

using tests::cases;

template <class Action>
std::string urdf_error(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::size_t link_number(const Robot& robot, const std::string& name) {
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (robot.links[i].name == name) return i;
  }
  throw std::runtime_error("no link " + name);
}

// The values of all joints, where some are given by name.
std::vector<double> joint_values(const Robot& robot, const std::map<std::string, double>& given) {
  std::vector<std::string> joints;
  std::vector<double> values;
  for (const auto& [name, value] : given) {
    joints.push_back(name);
    values.push_back(value);
  }
  return RobotMotion(robot, joints).joint_values(values);
}

// Where the pose puts the point, near enough for a test.
Point3 at(const solid::Pose& pose, const Point3& p) {
  const auto& m = pose.affine().linear;
  const auto& t = pose.affine().translation;
  return {m[0] * p.x + m[1] * p.y + m[2] * p.z + t[0], m[3] * p.x + m[4] * p.y + m[5] * p.z + t[1],
          m[6] * p.x + m[7] * p.y + m[8] * p.z + t[2]};
}

void expect_near(const Point3& a, const Point3& b) {
  constexpr double margin = 1e-12;
  EXPECT_NEAR(a.x, b.x, margin);
  EXPECT_NEAR(a.y, b.y, margin);
  EXPECT_NEAR(a.z, b.z, margin);
}

TEST(Urdf, ReadsAnArm) {
  const Robot robot = read_urdf(cases / "mesh" / "arm.urdf");
  EXPECT_EQ(robot.name, "arm");
  EXPECT_EQ(robot.folder, cases / "mesh");
  ASSERT_EQ(robot.links.size(), 5u);
  EXPECT_EQ(robot.links[robot.root].name, "base");
  ASSERT_EQ(robot.links[0].shapes.size(), 1u);
  EXPECT_EQ(robot.links[0].shapes[0].name, "foot");
  EXPECT_EQ(robot.links[0].shapes[0].mesh, "");
  EXPECT_EQ(robot.links[0].shapes[0].size, (std::array<double, 3>{2, 2, 1}));
  EXPECT_EQ(robot.links[1].shapes[0].scale, (std::array<double, 3>{1, 1, -2}));
  EXPECT_EQ(robot.links[1].shapes[0].origin.rpy, (std::array<double, 3>{0, 0, 1.5}));
  ASSERT_EQ(robot.left_out.size(), 1u);
  EXPECT_EQ(robot.left_out[0].kind, "ellipsoid");
  EXPECT_EQ(robot.left_out[0].of, "base");
  EXPECT_EQ(robot.left_out[0].count, 1u);

  ASSERT_EQ(robot.joints.size(), 4u);
  std::string order;
  for (const Joint& joint : robot.joints) order += joint.name + " ";
  EXPECT_EQ(order, "shoulder elbow slide grip ") << "from the root outwards";
  EXPECT_EQ(robot.joints[0].type, JointType::continuous);
  EXPECT_EQ(robot.joints[0].axis, (std::array<double, 3>{0, 0, 1}));
  EXPECT_TRUE(std::isinf(robot.joints[0].upper));
  EXPECT_EQ(robot.joints[1].lower, -3);
  EXPECT_DOUBLE_EQ(robot.joints[2].axis[1], 0.6);
  EXPECT_DOUBLE_EQ(robot.joints[2].axis[2], 0.8);
  ASSERT_TRUE(robot.joints[3].mimic.has_value());
  EXPECT_EQ(robot.joints[robot.joints[3].mimic->joint].name, "slide");
  EXPECT_EQ(robot.joints[3].mimic->multiplier, -2);
  EXPECT_EQ(robot.joints[3].mimic->offset, 0.5);
}

TEST(Urdf, NormalisesAnyAxis) {
  const auto axis = [](const std::string& xyz) {
    const std::string text =
        "<robot><link name='a'/><link name='b'/><joint name='j' type='continuous'><parent link='a'/>"
        "<child link='b'/><axis xyz='" +
        xyz + "'/></joint></robot>";
    return parse_urdf(text, "test").joints[0].axis;
  };
  EXPECT_EQ(axis("0 -1e308 0"), (std::array<double, 3>{0, -1, 0}));
  EXPECT_EQ(axis("5e-324 0 0"), (std::array<double, 3>{1, 0, 0}));
  EXPECT_NEAR(axis("1e308 1e308 -1e308")[2], -1 / std::sqrt(3.0), 1e-15);
}

TEST(Urdf, BoxHasItsCorners) {
  const auto corners = box_corners({2, 4, 0});
  EXPECT_EQ(corners[0], (Point3{-1, -2, 0}));
  EXPECT_EQ(corners[1], (Point3{1, -2, 0}));
  EXPECT_EQ(corners[6], (Point3{-1, 2, 0}));
  EXPECT_FALSE(std::signbit(corners[0].z));
}

TEST(UrdfKinematics, DefaultsAreZeroOrTheNearestLimit) {
  const Robot robot = read_urdf(cases / "mesh" / "arm.urdf");
  EXPECT_EQ(joint_values(robot, {}), (std::vector<double>{0, -1, 0.5, -0.5}));
  EXPECT_EQ(joint_values(robot, {{"slide", 1.5}, {"elbow", -3}, {"shoulder", 100}}),
            (std::vector<double>{100, -3, 1.5, -2.5}));
}

std::string robot_of_several(const std::string& type, const std::string& inner = "") {
  return R"(<robot name="r"><link name="a"/><link name="b"/><joint name="j" type=")" + type +
         R"("><origin xyz="1 2 3" rpy="0.1 0.2 0.3"/><parent link="a"/><child link="b"/>)" + inner + "</joint></robot>";
}

// A joint of several numbers is a chain of joints of one.
TEST(UrdfKinematics, PlacesPlanarAndFloatingJoints) {
  const Robot planar = parse_urdf(robot_of_several("planar"), "r.urdf");
  EXPECT_EQ(movable_joints(planar), (std::vector<std::string>{"j/x", "j/y", "j/yaw"}));
  const Robot floating = parse_urdf(robot_of_several("floating"), "r.urdf");
  EXPECT_EQ(movable_joints(floating), (std::vector<std::string>{"j/x", "j/y", "j/z", "j/yaw", "j/pitch", "j/roll"}));
  const auto same = [](const Robot& robot, const std::map<std::string, double>& values, const UrdfOrigin& moved) {
    const solid::Pose expected = compose(origin_pose({{1, 2, 3}, {0.1, 0.2, 0.3}}), origin_pose(moved));
    const solid::Pose found = link_poses(robot, values)[link_number(robot, "b")];
    for (const Point3& p : {Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}}) {
      expect_near(at(found, p), at(expected, p));
    }
  };
  same(planar, {}, {});
  same(planar, {{"j/x", 4}, {"j/y", -5}, {"j/yaw", 0.75}}, {{4, -5, 0}, {0, 0, 0.75}});
  same(floating, {}, {});
  same(floating, {{"j/x", 4}, {"j/y", -5}, {"j/z", 6}, {"j/roll", 0.5}, {"j/pitch", -0.25}, {"j/yaw", 0.75}},
       {{4, -5, 6}, {0.5, -0.25, 0.75}});
  EXPECT_TRUE(beyond_limits(planar, {{"j/x", 1e9}}).empty());
}

TEST(Urdf, RefusesPlanarAndFloatingJointsThatAreNotClear) {
  const auto error = [](const std::string& type, const std::string& inner) {
    return urdf_error([&] { (void)parse_urdf(robot_of_several(type, inner), "r.urdf"); });
  };
  EXPECT_EQ(error("planar", "<axis xyz='0 0 2'/>"), "no error");
  EXPECT_EQ(error("planar", "<axis xyz='1 0 0'/>"),
            "r.urdf:1: programs differ about a planar joint whose axis is not 0 0 1; give that axis, and turn its "
            "<origin>");
  EXPECT_EQ(error("floating", "<axis xyz='1 0 0'/>"), "no error") << "it has none";
  EXPECT_EQ(error("floating", "<mimic joint='j'/>"),
            "r.urdf:1: a joint that takes several numbers follows no other; leave out its <mimic>");
  EXPECT_EQ(error("planar",
                  "</joint><link name='j/x'/><joint name='k' type='fixed'><parent link='b'/>"
                  "<child link='j/x'/>"),
            "r.urdf:1: the link 'j/x' comes twice; rename one");
  EXPECT_EQ(error("screw", ""),
            "r.urdf:1: the type of the joint is 'screw'; known are fixed, revolute, continuous, prismatic, planar, "
            "floating");
}

TEST(UrdfKinematics, RefusesWrongValues) {
  const Robot robot = read_urdf(cases / "panda" / "panda.urdf");
  const auto error = [&](const std::string& name, double value) {
    return urdf_error([&] { link_poses(robot, {{name, value}}); });
  };
  EXPECT_TRUE(
      error("elbow", 0)
          .starts_with(
              "joint 'elbow': the robot has no joint of this name; those that can be given a value are panda_joint1, "))
      << error("elbow", 0);
  EXPECT_NE(error("time", 0).find("times are not read; leave it out"), std::string::npos);
  EXPECT_TRUE(error("panda_joint2_deg", 0)
                  .ends_with("degrees are read in tables only; give radians (degrees times pi / 180) for "
                             "'panda_joint2'"));
  EXPECT_NE(error("panda_joint8", 0).find("is fixed"), std::string::npos);
  EXPECT_NE(error("panda_finger_joint2", 0).find("follows joint 'panda_finger_joint1'"), std::string::npos);
  EXPECT_NE(error("panda_joint1", std::numeric_limits<double>::quiet_NaN()).find("not finite"), std::string::npos);
  EXPECT_EQ(urdf_error([&] { joint_values(robot, {{"a\nb", 1}}); }).find('\n'), std::string::npos);
}

TEST(UrdfKinematics, TellsValuesBeyondTheLimits) {
  const Robot robot = read_urdf(cases / "panda" / "panda.urdf");
  EXPECT_EQ(beyond_limits(robot, {{"panda_joint4", 0}, {"panda_joint1", 2.8973}, {"none", 7}}),
            (std::vector<std::string>{"joint 'panda_joint4' is at 0, beyond its limits from -3.0718 to -0.0698"}))
      << "limits are included";
  EXPECT_EQ(beyond_limits(robot, {{"panda_joint1", std::nextafter(2.8973, 3)}}).size(), 1u);
  EXPECT_EQ(joint_values(robot, {{"panda_joint1", 9}})[0], 9) << "asked about all the same";
}

TEST(UrdfKinematics, MovesTheArm) {
  const Robot robot = read_urdf(cases / "mesh" / "arm.urdf");
  const double half_pi = std::acos(0.0);
  const auto poses = link_poses(robot, {{"shoulder", half_pi}, {"elbow", -half_pi}, {"slide", 1}});
  ASSERT_EQ(poses.size(), 5u);
  EXPECT_EQ(poses[0].affine(), Affine3{});
  const auto where = [&](const char* link, const Point3& p) { return at(poses[link_number(robot, link)], p); };
  expect_near(where("upper", {1, 0, 0}), {0, 1, 1});
  // The elbow turns about the upper arm's y, which points along the world's -x: z goes to the world's -y.
  expect_near(where("lower", {0, 0, 0}), {0, 0, 3});
  expect_near(where("lower", {0, 0, 1}), {0, -1, 3});
  expect_near(where("lower", {1, 0, 0}), {0, 0, 4});
  expect_near(where("tool", {0, 0, 0}), {-0.6, -0.8, 3});
  expect_near(where("finger", {0, 0, 0}), {-0.6, -0.8, 3 + (-2 * 1 + 0.5)});
}

TEST(UrdfKinematics, OriginTurnsAboutFixedAxesInTheirOrder) {
  const double half_pi = std::acos(0.0);
  // Roll takes z to -y; pitch leaves y alone; yaw takes y to -x: z ends at +x.
  expect_near(at(origin_pose({{1, 2, 3}, {half_pi, half_pi, half_pi}}), {0, 0, 1}), {1 + 1, 2, 3});
  expect_near(at(origin_pose({{0, 0, 0}, {0.3, 0, 0}}), {0, 1, 0}), {0, std::cos(0.3), std::sin(0.3)});
  expect_near(at(origin_pose({{0, 0, 0}, {0, 0.3, 0}}), {1, 0, 0}), {std::cos(0.3), 0, -std::sin(0.3)});
  EXPECT_EQ(origin_pose({}).affine(), Affine3{});
}

TEST(UrdfKinematics, ShapeIsScaledThenPlaced) {
  const Robot robot = read_urdf(cases / "mesh" / "arm.urdf");
  const solid::Pose pose = shape_pose(robot.links[1].shapes[0]);
  expect_near(at(pose, {1, 0, 1}), {std::cos(1.5), std::sin(1.5), 1 - 2});
  EXPECT_EQ(shape_pose(robot.links[2].shapes[0]).affine(), Affine3{});
}

TEST(UrdfKinematics, TurnsAboutCoordinateAxesStayExact) {
  const Robot robot = read_urdf(cases / "mesh" / "arm.urdf");
  for (const double angle : {0.1, 2.0, 3.0, -2.5, 1e6}) {
    const Affine3 turned = link_poses(robot, {{"shoulder", angle}})[1].affine();
    const double c = std::cos(angle), s = std::sin(angle);
    EXPECT_EQ(turned.linear, (std::array<double, 9>{c, -s, 0, s, c, 0, 0, 0, 1})) << angle;
  }
}

// Every mesh is found and read, and the arm's known posture comes out: Franka's published Denavit-Hartenberg table puts
// the flange of the straight arm at (0.088, 0, 0.333 + 0.316 + 0.384 - 0.107).
TEST(UrdfKinematics, PlacesThePanda) {
  const Robot robot = read_urdf(cases / "panda" / "panda.urdf");
  EXPECT_TRUE(robot.left_out.empty());
  EXPECT_EQ(robot.links.size(), 13u);
  EXPECT_EQ(robot.joints.size(), 12u);
  std::size_t meshes = 0, boxes = 0;
  for (const Link& link : robot.links) {
    for (const CollisionShape& shape : link.shapes) {
      if (shape.mesh.empty()) {
        ++boxes;
      } else {
        EXPECT_GE(read_mesh(resolve_mesh(shape.mesh, robot.folder)).vertices.size(), 18u);
        ++meshes;
      }
    }
  }
  EXPECT_EQ(meshes, 9u);
  EXPECT_EQ(boxes, 8u);

  const auto straight = link_poses(robot, {{"panda_joint4", -0.0698}});
  const auto bent = link_poses(
      robot,
      {{"panda_joint4", -1.5707963267948966}, {"panda_joint6", 1.5707963267948966}, {"panda_finger_joint1", 0.04}});
  EXPECT_EQ(straight[robot.root].affine(), Affine3{});
  const auto where = [&](const char* link) { return at(bent[link_number(robot, link)], {0, 0, 0}); };
  expect_near(where("panda_link1"), {0, 0, 0.333});
  expect_near(where("panda_link4"), {0.0825, 0, 0.333 + 0.316});
  // The forearm is level: 0.384 forward and 0.0825 up; the flange hangs down at 0.088 in front.
  expect_near(where("panda_link6"), {0.0825 + 0.384, 0, 0.649 + 0.0825});
  expect_near(where("panda_link8"), {0.4665 + 0.088, 0, 0.7315 - 0.107});
  const Point3 left = where("panda_leftfinger"), right = where("panda_rightfinger");
  EXPECT_NEAR(std::hypot(left.x - right.x, left.y - right.y, left.z - right.z), 0.08, 1e-12) << "the mimic moves too";
}

TEST(UrdfKinematics, FollowsChainsOfMimics) {
  std::string text = "<robot><link name='l0'/>";
  for (int i = 1; i <= 3; ++i) {
    const std::string n = std::to_string(i), above = std::to_string(i - 1), next = std::to_string(i + 1);
    text += "<link name='l" + n + "'/><joint name='j" + n + "' type='continuous'><parent link='l" + above +
            "'/><child link='l" + n + "'/>" +
            (i < 3 ? "<mimic joint='j" + next + "' multiplier='2' offset='1'/>" : "") + "</joint>";
  }
  EXPECT_EQ(joint_values(parse_urdf(text + "</robot>", "test"), {{"j3", 5}}), (std::vector<double>{23, 11, 5}));
}

TEST(UrdfKinematics, NamesTheJointThatOverflows) {
  const Robot robot = parse_urdf(
      "<robot><link name='a'/><link name='b'/><link name='c'/>"
      "<joint name='j' type='fixed'><parent link='a'/><child link='b'/>"
      "<origin xyz='1e308 0 0'/></joint>"
      "<joint name='k' type='fixed'><parent link='b'/><child link='c'/>"
      "<origin xyz='1e308 0 0'/></joint></robot>",
      "test");
  const std::string text = urdf_error([&] { link_poses(robot, {}); });
  EXPECT_TRUE(text.starts_with("joint 'k': ")) << text;
}

}  // namespace
}  // namespace sunder::io
