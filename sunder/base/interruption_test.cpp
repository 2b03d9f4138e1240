#include <sunder/base/interruption.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

namespace sunder {
namespace {

TEST(Interruption, WithoutOneNothingHappens) { may_be_interrupted(4'000'000'000u); }

TEST(Interruption, IsCalledAtOnceAndThenOnceInSoMuchWork) {
  int calls = 0;
  const Interruptible interruptible([&] { ++calls; });
  may_be_interrupted(1);
  EXPECT_EQ(calls, 1);
  for (int k = 0; k < 99; ++k) may_be_interrupted(1000);
  EXPECT_EQ(calls, 1);
  may_be_interrupted(1000);
  EXPECT_EQ(calls, 2);
  may_be_interrupted(4'000'000'000u);  // is one call, too
  may_be_interrupted(99'999);
  EXPECT_EQ(calls, 3);
}

TEST(Interruption, WhatItThrowsComesOutAndTheLastOneCounts) {
  int outer = 0;
  const Interruptible of_outer([&] { ++outer; });
  {
    const Interruptible of_inner([] { throw std::runtime_error("stop"); });
    EXPECT_THROW(may_be_interrupted(1), std::runtime_error);
    EXPECT_THROW(may_be_interrupted(100'000), std::runtime_error);
    EXPECT_EQ(outer, 0);
  }
  may_be_interrupted(1);
  EXPECT_EQ(outer, 1);
}

TEST(Interruption, IsOfOneThread) {
  const Interruptible interruptible([] { throw std::runtime_error("stop"); });
  std::thread([] { may_be_interrupted(1); }).join();
}

}  // namespace
}  // namespace sunder
