#include <sunder/base/random.h>
#include <sunder/io/robot/robot_motion.h>

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace sunder::io {
namespace {

constexpr const char* robot_text = R"(<robot name="r">
  <link name="base"/><link name="arm"/><link name="hand"/><link name="left"/><link name="right"/><link name="tip"/>
  <joint name="turn" type="continuous"><parent link="base"/><child link="arm"/>
    <origin xyz="0.1 0.2 0.3" rpy="0.4 0.5 0.6"/><axis xyz="1 2 3"/></joint>
  <joint name="bend" type="revolute"><parent link="arm"/><child link="hand"/>
    <origin xyz="1 0 0" rpy="0 1.5 0"/><axis xyz="0 0 1"/><limit lower="0.5" upper="2"/></joint>
  <joint name="follower" type="prismatic"><parent link="hand"/><child link="right"/>
    <axis xyz="0 -1 0"/><limit lower="0" upper="1"/><mimic joint="follows" multiplier="-2" offset="0.5"/></joint>
  <joint name="follows" type="prismatic"><parent link="hand"/><child link="left"/>
    <axis xyz="0 1 0"/><limit lower="0" upper="1"/><mimic joint="slide" multiplier="3" offset="0.25"/></joint>
  <joint name="slide" type="prismatic"><parent link="hand"/><child link="tip"/>
    <axis xyz="0 1 1"/><limit lower="-1" upper="1"/></joint>
</robot>)";

TEST(RobotMotion, IsLinkPosesBitByBit) {
  const Robot robot = parse_urdf(robot_text, "r.urdf");
  const std::vector<std::string> all = movable_joints(robot);
  ASSERT_EQ(all.size(), 3u);  // turn, bend, slide
  Random random(5);
  for (const bool is_all : {true, false}) {
    const std::vector<std::string> joints =
        is_all ? std::vector<std::string>{"slide", "turn", "bend"} : std::vector<std::string>{"turn"};
    const RobotMotion motion(robot, joints);
    std::vector<Affine3> links(robot.links.size());
    for (int round = 0; round < 100; ++round) {
      std::vector<double> values{random.uniform(-1, 1), random.uniform(-4, 4), random.uniform(0.5, 2)};
      if (!is_all) values.resize(1);
      std::map<std::string, double> named;
      for (std::size_t k = 0; k < joints.size(); ++k) {
        named[joints[k]] = values[k];
        EXPECT_EQ(motion.joint_of(k).name, joints[k]);
      }
      motion.place(values, links);
      const std::vector<solid::Pose> expected = link_poses(robot, named);
      ASSERT_EQ(links.size(), expected.size());
      for (std::size_t k = 0; k < links.size(); ++k) ASSERT_EQ(links[k], expected[k].affine());
    }
  }
}

TEST(RobotMotion, NamesTheJointThatIsWrong) {
  const Robot robot = parse_urdf(robot_text, "r.urdf");
  const auto error_of = [&](const std::string& joint, double value) {
    const std::vector<std::string> joints{joint};
    try {
      std::vector<Affine3> links(robot.links.size());
      RobotMotion(robot, joints).place(std::vector<double>{value}, links);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(error_of("slide", 0), "none");
  EXPECT_TRUE(error_of("none", 0).starts_with("joint 'none': the robot has no joint of this name"));
  EXPECT_TRUE(error_of("follows", 0).starts_with("joint 'follows': follows joint 'slide'"));
  EXPECT_TRUE(error_of("slide", 1e308).starts_with("joint 'follows': its value overflows"));
}

TEST(RobotMotion, NamesTheJointWhereAPoseOverflows) {
  const Robot robot = parse_urdf(R"(<robot name="r"><link name="base"/><link name="one"/><link name="two"/>
    <joint name="first" type="prismatic"><parent link="base"/><child link="one"/><axis xyz="1 0 0"/>
      <limit lower="0" upper="1"/></joint>
    <joint name="second" type="prismatic"><parent link="one"/><child link="two"/><axis xyz="1 0 0"/>
      <limit lower="0" upper="1"/></joint></robot>)",
                                 "r.urdf");
  const RobotMotion motion(robot, std::vector<std::string>{"first", "second"});
  std::vector<Affine3> links(robot.links.size());
  motion.place(std::vector<double>{1e308, -1e308}, links);
  EXPECT_EQ(links[2].translation[0], 0);
  try {
    motion.place(std::vector<double>{1e308, 1e308}, links);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_pose);
    EXPECT_EQ(error.what(), std::string("joint 'second': its pose overflows; give smaller numbers"));
  }
}

}  // namespace
}  // namespace sunder::io
