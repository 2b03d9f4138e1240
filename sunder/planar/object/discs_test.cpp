#include <sunder/base/error.h>
#include <sunder/planar/object/discs.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace sunder::planar {
namespace {

TEST(DiscsTest, KeepsWhatIsGiven) {
  const std::vector<Disc> given{{{1, 2}, 3}, {{-1e308, 5e-324}, 1.7e308}, {{0, 0}, 0}, {{0, 0}, -0.0}};
  const Discs circles(given);
  ASSERT_EQ(circles.size(), 4u);
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(circles[i], given[i]);
  EXPECT_EQ(Discs({}).size(), 0u);
}

TEST(DiscsTest, BadNumbersAreRefused) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Disc& bad : {Disc{{0, 0}, -1}, Disc{{0, 0}, -5e-324}, Disc{{0, 0}, infinity}, Disc{{0, 0}, nan},
                          Disc{{infinity, 0}, 1}, Disc{{0, nan}, 1}, Disc{{0, -infinity}, 1}}) {
    try {
      Discs(std::vector<Disc>{{{0, 0}, 1}, bad});
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
