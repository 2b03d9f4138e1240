#include <sunder/predicate/point/further_by.h>

#include <gtest/gtest.h>

namespace sunder {
namespace {

TEST(FurtherBy, ExactlySoFarIsEnough) {
  const Affine3 here, there{{2, 0, 0, 0, 2, 0, 0, 0, 2}, {1, 0, 0}};
  const Posed3 from{{0, 0, 0}, &here, false}, to{{1, 2, 0}, &there, false};  // at (3, 4, 0)
  const auto square = [](double x) { return ExactFraction{Dyadic(x) * Dyadic(x)}; };
  for (const double length : {1.0, 0x1p-900, 0x1p900}) {  // of the direction
    const WorldDirection along(Point3{3 * length, 4 * length, 0}), back(Point3{-3 * length, -4 * length, 0});
    EXPECT_TRUE(is_further_by(along, from, to, square(5)));
    EXPECT_FALSE(is_further_by(along, from, to, square(5 + 0x1p-50)));
    EXPECT_TRUE(is_further_by(along, from, to, square(5 - 0x1p-50)));
    EXPECT_FALSE(is_further_by(back, from, to, square(1)));
    EXPECT_TRUE(is_further_by(back, to, from, square(5)));
    EXPECT_TRUE(is_further_by(along, from, from, square(0)));
    EXPECT_FALSE(is_further_by(along, from, from, square(0x1p-1000)));
  }
}

}  // namespace
}  // namespace sunder
