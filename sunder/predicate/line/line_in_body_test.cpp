#include <sunder/predicate/line/line_in_body.h>

#include <gtest/gtest.h>

#include <array>

namespace sunder {
namespace {

const Affine3 mirror{{-2, 0, 0, 0, 1, 0, 0, 0, 1}, {1, 0, 0}};  // x -> 1 - 2 x

TEST(LineInBody, WhereItMeetsPlanes) {
  // In the body's frame from (0.5, 0, 0) through (0, 1, 0).
  const LineInBody line({0, 0, 0}, {1, 1, 0}, mirror);
  const ExactPoint3 p = line.at_plane({0, 2, 0}, {1, 2, 0}, {0, 2, 1});
  EXPECT_EQ(nearest(p), (Point3{-0.5, 2, 0}));
  EXPECT_EQ(p.denominator.sign(), Sign::positive);
  EXPECT_EQ(line.facing({0, 2, 0}, {0, 2, 1}, {1, 2, 0}), Sign::positive);  // normal along y
  EXPECT_EQ(line.facing({0, 2, 0}, {1, 2, 0}, {0, 2, 1}), Sign::negative);
  EXPECT_EQ(line.facing({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), Sign::zero);
  EXPECT_EQ(nearest(line.at({Dyadic(3.0), Dyadic(2.0)})), (Point3{-0.25, 1.5, 0}));
  EXPECT_EQ(nearest(LineInBody::between(line.at({Dyadic(0.0)}), line.at({Dyadic(1.0)}))), (Point3{0.25, 0.5, 0}));
  const ExactPoint3 afar = line.from_afar();
  EXPECT_EQ(afar.denominator.sign(), Sign::zero);
  EXPECT_EQ(afar.x.sign(), Sign::positive);
  EXPECT_EQ(afar.y.sign(), Sign::negative);
}

TEST(LineInBody, SidesAndTurns) {
  const LineInBody line({0, 0, 5}, {0, 0, 4}, Affine3{});
  const ExactPoint3 at_two = line.at({Dyadic(3.0)});
  const Point3 u{0, 0, 1}, v{1, 0, 1}, w{0, 1, 1};
  EXPECT_EQ(side_of_plane(u, v, w, at_two), Sign::positive);
  EXPECT_EQ(side_of_plane(u, v, w, line.at({Dyadic(4.0)})), Sign::zero);
  EXPECT_EQ(side_of_plane(u, v, w, line.at({Dyadic(5.0)})), Sign::negative);
  const std::array<Point3, 4> base{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  const WayFromMiddle up(base, at_two), down(base, line.at({Dyadic(7.0)})), from_above(base, line.from_afar());
  EXPECT_EQ(up.turn({1, 0, 0}, {0, 1, 0}), Sign::positive);
  EXPECT_EQ(from_above.turn({1, 0, 0}, {0, 1, 0}), Sign::positive);
  EXPECT_EQ(down.turn({1, 0, 0}, {0, 1, 0}), Sign::negative);
  EXPECT_EQ(up.turn({1, 0, 0}, {1, 0, 3}), Sign::zero);
}

}  // namespace
}  // namespace sunder
