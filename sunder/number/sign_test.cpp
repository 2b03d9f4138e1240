#include <sunder/number/sign.h>

#include <tests/support/doubles.h>

#include <gtest/gtest.h>

#include <type_traits>

namespace sunder {
namespace {

using tests::largest, tests::least;

// A sign does not turn into anything else by itself, nor a guess into a sign.
static_assert(!std::is_convertible_v<Sign, bool> && !std::is_convertible_v<Sign, int>);
static_assert(!std::is_convertible_v<Guess, bool> && !std::is_convertible_v<Guess, int>);
static_assert(!std::is_convertible_v<Guess, Sign> && !std::is_convertible_v<Sign, Guess>);

constexpr Sign all_signs[] = {Sign::negative, Sign::zero, Sign::positive};

TEST(SignTest, IsSure) {
  EXPECT_TRUE(is_sure(Guess::negative));
  EXPECT_TRUE(is_sure(Guess::zero));
  EXPECT_TRUE(is_sure(Guess::positive));
  EXPECT_FALSE(is_sure(Guess::unsure));
}

TEST(SignTest, GuessToSign) {
  EXPECT_EQ(to_sign(Guess::negative), Sign::negative);
  EXPECT_EQ(to_sign(Guess::zero), Sign::zero);
  EXPECT_EQ(to_sign(Guess::positive), Sign::positive);
}

TEST(SignTest, NegationAndProduct) {
  EXPECT_EQ(-Sign::negative, Sign::positive);
  EXPECT_EQ(-Sign::zero, Sign::zero);
  EXPECT_EQ(-Sign::positive, Sign::negative);
  for (const Sign a : all_signs) {
    for (const Sign b : all_signs) {
      EXPECT_EQ(static_cast<int>(a * b), static_cast<int>(a) * static_cast<int>(b));
    }
  }
}

TEST(SignTest, SignOfDouble) {
  EXPECT_EQ(sign_of(0.0), Sign::zero);
  EXPECT_EQ(sign_of(-0.0), Sign::zero);
  EXPECT_EQ(sign_of(least), Sign::positive);
  EXPECT_EQ(sign_of(-least), Sign::negative);
  EXPECT_EQ(sign_of(largest), Sign::positive);
  EXPECT_EQ(sign_of(-largest), Sign::negative);
}

}  // namespace
}  // namespace sunder
