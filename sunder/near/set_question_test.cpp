#include <sunder/base/error.h>
#include <sunder/near/set_question.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sunder {
namespace {

TEST(SetQuestion, AGroupForEachOrNone) {
  const std::vector<std::uint32_t> three{0, 0, 1};
  check_groups({}, 5);
  check_groups(three, 3);
  for (const std::size_t members : {0u, 2u, 4u}) {
    try {
      check_groups(three, members);
      ADD_FAILURE() << members;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_call);
      EXPECT_NE(std::string(error.what()).find("3 groups of"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace sunder
