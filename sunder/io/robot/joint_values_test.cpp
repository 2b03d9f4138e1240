#include <sunder/io/robot/joint_values.h>

#include <sunder/io/text/file.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace sunder::io {
namespace {

using ValuesByName = std::map<std::string, double>;
using NamePair = std::array<std::string, 2>;

class JointValuesFile : public testing::Test {
 protected:
  const std::string file = (std::filesystem::path(testing::TempDir()) / "sunder_open.txt").string();
  void write(std::string_view text) const { write_file_atomically(file, std::string(text)); }
  void TearDown() override { std::filesystem::remove(file); }
};

TEST(JointValues, OfText) {
  const JointValues plain = parse_joint_values("elbow=0.5, wrist = -1", "--joints");
  EXPECT_EQ(plain.name, "");
  EXPECT_EQ(plain.values, (ValuesByName{{"elbow", 0.5}, {"wrist", -1}}));
  EXPECT_EQ(parse_joint_values("up:elbow=1", "--joints").name, "up");
  EXPECT_THROW(parse_joint_values("elbow", "--joints"), Error);
  EXPECT_THROW(parse_joint_values("elbow=x", "--joints"), Error);
  EXPECT_THROW(parse_joint_values("elbow=1,elbow=2", "--joints"), Error);
}

TEST_F(JointValuesFile, OneJointALine) {
  write("# the hand is open\nelbow 0.5\n\nwrist=-1  # a comment\n");
  const JointValues joints = read_joint_values(file);
  EXPECT_EQ(joints.name, "sunder_open");
  EXPECT_EQ(joints.values, (ValuesByName{{"elbow", 0.5}, {"wrist", -1}}));
}

TEST_F(JointValuesFile, TwoNamesALine) {
  write("hand cup\narm , base  # joined\n");
  const auto pairs = read_name_pairs(file);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].second, (NamePair{"hand", "cup"}));
  EXPECT_EQ(pairs[1].second, (NamePair{"arm", "base"}));
  EXPECT_TRUE(pairs[1].first.ends_with(":2"));
  write("alone\n");
  EXPECT_THROW(read_name_pairs(file), Error);
}

}  // namespace
}  // namespace sunder::io
