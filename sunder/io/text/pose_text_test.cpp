// Poses and lists of numbers as people write them.
#include <sunder/io/text/pose_text.h>

#include <gtest/gtest.h>

namespace sunder::io {
namespace {

std::string pose_refusal(const std::string& text) {
  try {
    static_cast<void>(parse_pose(text, "--pose"));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(PoseText, NumbersStandBetweenCommasOrBlanks) {
  EXPECT_EQ(parse_numbers("1, 2 3\t-4e1", "--x"), (std::vector<double>{1, 2, 3, -40}));
  EXPECT_THROW(static_cast<void>(parse_numbers("1,,2", "--x")), Error);
  EXPECT_THROW(static_cast<void>(parse_numbers("", "--x")), Error);
}

TEST(PoseText, AllFormsSayTheSame) {
  const auto moved = [](const std::string& text) { return parse_pose(text, "--pose").affine(); };
  const auto expected = moved("4,5,6");
  EXPECT_EQ(moved("1,0,0,0,4,5,6"), expected);
  EXPECT_EQ(moved("1 0 0 4 0 1 0 5 0 0 1 6"), expected);
  EXPECT_EQ(moved("1 0 0 4 0 1 0 5 0 0 1 6 0 0 0 1"), expected);
}

TEST(PoseText, WhatIsNoPoseIsNamed) {
  EXPECT_NE(pose_refusal("1,2").find("a pose of 2 numbers; give tx,ty,tz"), std::string::npos) << pose_refusal("1,2");
  EXPECT_NE(pose_refusal("1,2,x").find("'x'"), std::string::npos) << pose_refusal("1,2,x");
  EXPECT_NE(pose_refusal("0,0,0,0,1,2,3"), "");  // no rotation
}

}  // namespace
}  // namespace sunder::io
