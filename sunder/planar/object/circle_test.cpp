#include <sunder/base/error.h>
#include <sunder/planar/object/circle.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace sunder::planar {
namespace {

TEST(CirclesTest, KeepsWhatIsGiven) {
  const std::vector<Circle> given{{{1, 2}, 3}, {{-1e308, 5e-324}, 1.7e308}, {{0, 0}, 0}, {{0, 0}, -0.0}};
  const Circles circles(given);
  ASSERT_EQ(circles.size(), 4u);
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(circles[i], given[i]);
  EXPECT_EQ(Circles({}).size(), 0u);
}

TEST(CirclesTest, BadNumbersAreRefused) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Circle& bad : {Circle{{0, 0}, -1}, Circle{{0, 0}, -5e-324}, Circle{{0, 0}, infinity}, Circle{{0, 0}, nan},
                            Circle{{infinity, 0}, 1}, Circle{{0, nan}, 1}, Circle{{0, -infinity}, 1}}) {
    try {
      Circles(std::vector<Circle>{{{0, 0}, 1}, bad});
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_value);
      EXPECT_EQ(error.place(), "circle 1");
      EXPECT_EQ(std::string(error.what()).find("circle 1: "), 0u);
      EXPECT_EQ(std::string(error.what()).find("negative") != std::string::npos, bad.radius < 0);
    }
  }
}

}  // namespace
}  // namespace sunder::planar
