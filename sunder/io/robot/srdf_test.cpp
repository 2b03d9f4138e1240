#include <sunder/base/error.h>
#include <sunder/io/robot/srdf.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace sunder::io {
namespace {

namespace fs = std::filesystem;

using tests::cases;
using Names = std::vector<std::string>;

std::string srdf_error(const std::string& inner) {
  try {
    parse_srdf("<robot name=\"r\">\n" + inner + "\n</robot>", "test");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    return error.what();
  }
  return "no error";
}

class States : public testing::Test {
 protected:
  JointValues of(const std::string& text) {
    remarks_.clear();
    return state_values(srdf_, robot_, text, "--state", remarks_);
  }
  std::string error(const std::string& text) {
    try {
      of(text);
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::bad_call);
      return e.what();
    }
    return "no error";
  }

  const Srdf srdf_ = read_srdf(cases / "scene" / "arm.srdf");
  const Robot robot_ = read_urdf(cases / "mesh" / "arm.urdf");
  std::vector<std::string> remarks_;
};

TEST_F(States, AreReadWithTheirPairsAndGroups) {
  EXPECT_EQ(srdf_.name, "arm");
  ASSERT_EQ(srdf_.disabled.size(), 4u);
  EXPECT_EQ(srdf_.disabled[0].links[0], "base");
  EXPECT_EQ(srdf_.disabled[0].links[1], "upper");
  EXPECT_EQ(srdf_.disabled[0].reason, "Adjacent");
  ASSERT_EQ(srdf_.groups.size(), 3u);
  EXPECT_EQ(srdf_.groups[0].name, "whole");
  EXPECT_EQ(srdf_.groups[0].chains, (std::vector<std::array<std::string, 2>>{{"base", "tool"}}));
  EXPECT_EQ(srdf_.groups[1].joints, std::vector<std::string>{"slide"});
  EXPECT_EQ(srdf_.states.size(), 4u);
  EXPECT_EQ(reasons_text(srdf_.disabled), "4 pairs: 2 Never, 1 Adjacent, 1 without a reason");
}

TEST_F(States, GiveValuesToJoints) {
  const JointValues up = of("up");
  EXPECT_EQ(up.name, "up");
  EXPECT_EQ(up.values, (std::map<std::string, double>{{"shoulder", 1}, {"elbow", -1.5}}));
  ASSERT_EQ(remarks_.size(), 1u);
  EXPECT_NE(remarks_[0].find("of state whole/up"), std::string::npos);
  EXPECT_TRUE(remarks_[0].ends_with(": floor")) << remarks_[0];
  EXPECT_EQ(of("hand/open").values, (std::map<std::string, double>{{"slide", 1.5}}));
  EXPECT_TRUE(remarks_.empty());
  EXPECT_EQ(of("closed").values, (std::map<std::string, double>{{"slide", 0.5}})) << "grip follows slide";
  ASSERT_EQ(remarks_.size(), 1u);
  EXPECT_TRUE(remarks_[0].ends_with(": grip")) << remarks_[0];
  EXPECT_EQ(of("up, hand/open").values,
            (std::map<std::string, double>{{"shoulder", 1}, {"elbow", -1.5}, {"slide", 1.5}}));
}

TEST_F(States, ThatAreNotThereOrNotClearAreRefused) {
  EXPECT_NE(error("down").find("there is no state 'down'; states are whole/up, whole/open, hand/open, hand/closed"),
            std::string::npos);
  EXPECT_NE(error("open").find("several groups have a state 'open'; write whole/open or hand/open"), std::string::npos);
  EXPECT_NE(error("hand/open,closed").find("give joint 'slide' different values"), std::string::npos);
  EXPECT_NE(error("whole/open").find("the state 'open' moves no joint of the robot"), std::string::npos);
}

TEST(Srdf, RefusesBrokenFiles) {
  EXPECT_EQ(srdf_error("<disable_collisions link1=\"a\"/>"),
            "test:2: <disable_collisions> has no link2=\"...\"; add it");
  EXPECT_EQ(srdf_error("<disable_collisions link1=\"a\" link2=\"a\"/>"), "test:2: both links are 'a'; name two");
  EXPECT_EQ(srdf_error("<disable_collisions link1=\"a\" link2=\"\"/>"),
            "test:2: link2=\"\" of <disable_collisions> is empty; name one");
  EXPECT_EQ(srdf_error("<group_state group=\"g\"/>"), "test:2: <group_state> has no name=\"...\"; add it");
  EXPECT_EQ(srdf_error("<group_state name=\"s\"/>"), "no error") << "a group is not needed";
  EXPECT_NE(
      srdf_error("<group_state name=\"s\" group=\"g\"><joint name=\"j\" value=\"nan\"/></group_state>").find("is NaN"),
      std::string::npos);
  EXPECT_NE(srdf_error("<group_state name=\"s\" group=\"g\"/>\n<group_state name=\"s\" group=\"g\"/>")
                .find(":3: the state 's' of group 'g' comes twice"),
            std::string::npos);
  EXPECT_NE(
      srdf_error("<group_state name=\"s\" group=\"g\"><joint name=\"j\" value=\"1\"/><joint name=\"j\" value=\"1\"/>"
                 "</group_state>")
          .find("the joint 'j' comes twice"),
      std::string::npos);
  EXPECT_NE(srdf_error("<link name=\"a\"><collision/></link>").find("this is a URDF"), std::string::npos);
  EXPECT_NE(srdf_error("<group>").find("not well-formed XML"), std::string::npos);
}

// A planar joint is a chain of joints, of which the last one has the child.
TEST(Groups, HaveTheChildrenOfPlanarAndFloatingJoints) {
  for (const std::string type : {"planar", "floating"}) {
    const Robot robot = parse_urdf("<robot><link name='a'/><link name='b'/><joint name='j' type='" + type +
                                       "'><parent link='a'/><child link='b'/></joint></robot>",
                                   "r.urdf");
    const Srdf srdf = parse_srdf("<robot><group name='g'><joint name='j'/></group></robot>", "test");
    Names remarks;
    const auto links = group_links(srdf, robot, std::array<std::string, 1>{"g"}, "--group", remarks);
    ASSERT_EQ(links.size(), 1u) << type;
    EXPECT_EQ(robot.links[links[0]].name, "b");
    EXPECT_TRUE(remarks.empty());
  }
}

// Links by name, joint, chain and subgroup; of what is not there, what is said.
TEST(Groups, HaveLinks) {
  const Robot robot = read_urdf(cases / "mesh" / "arm.urdf");
  const auto links = [&](const std::string& groups, const std::string& name,
                         std::vector<std::string>* remarks = nullptr) {
    std::vector<std::string> said, result;
    for (const std::uint32_t link :
         group_links(parse_srdf("<robot>" + groups + "</robot>", "test"), robot, std::array{name}, "--group", said)) {
      result.push_back(robot.links[link].name);
    }
    if (remarks != nullptr) *remarks = said;
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto error = [&](const std::string& groups, const std::string& name) -> std::string {
    try {
      links(groups, name);
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::bad_call);
      EXPECT_EQ(e.place(), "--group");
      return e.what();
    }
    return "no error";
  };
  EXPECT_EQ(links("<group name='g'><link name='base'/><link name='lower'/></group>", "g"), (Names{"base", "lower"}));
  const auto slide =
      std::find_if(robot.joints.begin(), robot.joints.end(), [](const Joint& j) { return j.name == "slide"; });
  ASSERT_NE(slide, robot.joints.end());
  EXPECT_EQ(links("<group name='g'><joint name='slide'/></group>", "g"), Names{robot.links[slide->child].name});
  const std::string chain = "<group name='arm'><chain base_link='base' tip_link='lower'/></group>";
  EXPECT_EQ(links(chain, "arm"), (Names{"base", "lower", "upper"}));
  EXPECT_EQ(links(chain + "<group name='g'><group name='arm'/><link name='tool'/></group>", "g"),
            (Names{"base", "lower", "tool", "upper"}));
  Names remarks;
  EXPECT_EQ(links("<group name='g'><link name='gone'/><link name='base'/></group>", "g", &remarks), Names{"base"});
  EXPECT_EQ(remarks, Names{"of group g these are not in the robot: gone"});
  EXPECT_NE(error(chain, "arms").find("there is no group 'arms'; groups are arm"), std::string::npos);
  EXPECT_NE(error("<group name='g'><group name='h'/></group>", "g").find("no group 'h', which 'g' has"),
            std::string::npos);
  EXPECT_NE(error("<group name='g'><group name='h'/></group><group name='h'><group name='g'/></group>", "g")
                .find("is within itself"),
            std::string::npos);
  EXPECT_NE(error("<group name='g'><link name='gone'/></group>", "g").find("has no link of the robot"),
            std::string::npos);
  EXPECT_NE(error("<group name='g'><chain base_link='lower' tip_link='base'/></group>", "g").find("does not hang on"),
            std::string::npos);
  EXPECT_NE(srdf_error("<group name='g'/><group name='g'/>").find("the group 'g' comes twice"), std::string::npos);
  EXPECT_NE(srdf_error("<group name='g'><chain base_link='a'/></group>").find("tip_link"), std::string::npos);
}

}  // namespace
}  // namespace sunder::io
