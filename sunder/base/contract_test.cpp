#include <sunder/base/contract.h>

#include <gtest/gtest.h>

namespace sunder {
namespace {

TEST(ContractTest, ABrokenOneNamesFileLineAndRequirement) {
  EXPECT_DEATH(requirement_broken("a.h", 7, "n > 0"), "^a.h:7: requires n > 0\n$");
}

TEST(ContractTest, WhatIsRequiredIsCheckedInDebugBuildsOnly) {
  int looks = 0;
  const auto look = [&looks](bool result) {
    ++looks;
    return result;
  };
  SUNDER_REQUIRE(look(true));
#ifdef SUNDER_CONTRACTS
  EXPECT_EQ(looks, 1);
  EXPECT_DEATH(SUNDER_REQUIRE(look(false)), "contract_test.cpp:[0-9]+: requires look\\(false\\)");
#else
  EXPECT_EQ(looks, 0);
#endif
}

}  // namespace
}  // namespace sunder
