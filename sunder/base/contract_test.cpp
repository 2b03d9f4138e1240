#include <sunder/base/contract.h>
#include <sunder/number/dyadic.h>
#include <sunder/planar/set/max_tree.h>

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
  EXPECT_DEATH(nearest_ratio(Dyadic(1.0), Dyadic(0.0)), "dyadic.cpp:[0-9]+: requires ");
  EXPECT_DEATH(planar::MaxTree(8).next(0, planar::MaxTree::nothing), "max_tree.h:[0-9]+: requires bound > nothing");
#else
  EXPECT_EQ(looks, 0);
#endif
}

}  // namespace
}  // namespace sunder
