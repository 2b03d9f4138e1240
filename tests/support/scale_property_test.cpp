// What tests read of the environment: nonsense is an error, never a test of one case.
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace sunder::tests {
namespace {

TEST(Scale, NumbersAboveZero) {
  EXPECT_EQ(scale_of(nullptr), 1);
  EXPECT_EQ(scale_of("0.05"), 0.05);
  EXPECT_EQ(scale_of("25"), 25);
}

TEST(Scale, NonsenseIsAnError) {
  for (const char* text : {"", "x", "1x", "0", "-1", "nan", "inf", "1e999", " 1", "1,5"}) {
    EXPECT_THROW(scale_of(text), std::invalid_argument) << text;
  }
}

TEST(Seed, MovesEachTestsOwn) {
  EXPECT_EQ(seed_moved_by(nullptr, 7), 7U);
  EXPECT_EQ(seed_moved_by("0", 7), 7U);
  EXPECT_NE(seed_moved_by("1", 7), seed_moved_by("2", 7));
  EXPECT_NE(seed_moved_by("1", 7), seed_moved_by("1", 8));
}

TEST(Seed, NonsenseIsAnError) {
  for (const char* text : {"", "x", "1x", "-1", "1.5", "99999999999999999999999"}) {
    EXPECT_THROW(seed_moved_by(text, 7), std::invalid_argument) << text;
  }
}

TEST(Scale, CountsAreNeverZero) {
  EXPECT_GE(scaled_count(1), 1);
  EXPECT_GE(scaled_count(5000, 1000), 1000);
  EXPECT_GE(scaled_count(50, 1000), 50);
}

}  // namespace
}  // namespace sunder::tests
