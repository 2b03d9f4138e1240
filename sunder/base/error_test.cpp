#include <sunder/base/error.h>

#include <gtest/gtest.h>

namespace sunder {
namespace {

TEST(ErrorTest, CodeTextAndPlace) {
  const Error error(ErrorCode::bad_file, "is truncated; write it again", "a.stl:7");
  EXPECT_EQ(error.code(), ErrorCode::bad_file);
  EXPECT_EQ(error.place(), "a.stl:7");
  EXPECT_EQ(error.text(), "is truncated; write it again");
  EXPECT_STREQ(error.what(), "a.stl:7: is truncated; write it again");
}

TEST(ErrorTest, WithoutPlace) {
  const Error error(ErrorCode::bad_call, "unknown method; see --help");
  EXPECT_EQ(error.code(), ErrorCode::bad_call);
  EXPECT_EQ(error.place(), "");
  EXPECT_EQ(error.text(), error.what());
  EXPECT_STREQ(error.what(), "unknown method; see --help");
}

TEST(ErrorTest, EachCodeHasAName) {
  EXPECT_EQ(name_of(ErrorCode::bad_value), "bad-value");
  EXPECT_EQ(name_of(ErrorCode::bad_shape), "bad-shape");
  EXPECT_EQ(name_of(ErrorCode::bad_pose), "bad-pose");
  EXPECT_EQ(name_of(ErrorCode::bad_file), "bad-file");
  EXPECT_EQ(name_of(ErrorCode::bad_call), "bad-call");
}

TEST(ErrorTest, IsCaughtAsARuntimeErrorAndSurvivesCopies) {
  try {
    const Error error(ErrorCode::bad_pose, "is singular", "pose");
    throw Error(error);
  } catch (const std::runtime_error& caught) {
    EXPECT_STREQ(caught.what(), "pose: is singular");
    const auto* error = dynamic_cast<const Error*>(&caught);
    ASSERT_NE(error, nullptr);
    EXPECT_EQ(error->code(), ErrorCode::bad_pose);
    EXPECT_EQ(error->place(), "pose");
  }
}

}  // namespace
}  // namespace sunder
