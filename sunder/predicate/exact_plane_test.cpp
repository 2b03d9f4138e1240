#include <sunder/predicate/exact_plane.h>

#include <sunder/base/random.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace sunder {
namespace {

using Whole = std::int64_t;
using Row = std::array<Whole, 4>;  // of a plane n, d; of a point x, w

double number(Whole n) { return static_cast<double>(n); }
ExactPlane plane_of(const Row& row) {
  return {{Dyadic(number(row[0])), Dyadic(number(row[1])), Dyadic(number(row[2]))}, Dyadic(number(row[3]))};
}
ExactPoint3 point_of(const Row& row) {
  return {Dyadic(number(row[0])), Dyadic(number(row[1])), Dyadic(number(row[2])), Dyadic(number(row[3]))};
}
Row some_row(Random& random, Whole most) {
  Row row;
  for (Whole& n : row) n = random.between(static_cast<int>(-most), static_cast<int>(most));
  return row;
}

TEST(ExactPlane, SidesOfPointsAreThoseOfWholeNumbers) {
  Random random(5101);
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    const Whole most = i % 3 == 0 ? 3 : i % 3 == 1 ? 100 : 1'000'000;
    const Row plane = some_row(random, most);
    Row point = some_row(random, most);
    if (point[3] == 0) continue;
    const Whole height = plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] - plane[3] * point[3];
    const Whole sign = (height > 0) - (height < 0);
    const Sign found = plane_of(plane).side_of(EnclosedPoint(point_of(point)));
    EXPECT_EQ(static_cast<int>(found), static_cast<int>(point[3] > 0 ? sign : -sign)) << i;
    zeros += height == 0;
  }
  EXPECT_GT(zeros, 200);
}

TEST(ExactPlane, FarNumbersAndThinGapsAreExact) {
  const ExactPlane at_one = ExactPlane::across_axis(2, 1);
  const double after = std::nextafter(1.0, 2.0);
  EXPECT_EQ(at_one.side_of(EnclosedPoint(exactly(Point3{5, 6, after}))), Sign::positive);
  EXPECT_EQ(at_one.side_of(EnclosedPoint(exactly(Point3{5, 6, 1}))), Sign::zero);
  const EnclosedPoint third(ExactPoint3{1.0, 1.0, 1.0, 3.0}),
      less(ExactPoint3{1.0, 1.0, std::nextafter(1.0, 0.0), 3.0});
  const ExactPlane diagonal({Dyadic(1e300), Dyadic(), Dyadic(-1e300)}, Dyadic());
  EXPECT_EQ(diagonal.side_of(third), Sign::zero);
  EXPECT_EQ(diagonal.side_of(less), Sign::positive);
  const ExactPlane tiny({Dyadic(1e-300), Dyadic(1e-300), Dyadic()}, Dyadic(0x1p-1074));
  EXPECT_EQ(tiny.side_of(EnclosedPoint(exactly(Point3{1e300, -1e300, 0}))), Sign::negative);
}

TEST(ExactPlane, CrossingsAreOnThePlaneAndBetween) {
  Random random(5102);
  int crossings = 0;
  for (int i = 0; i < 3000; ++i) {
    const ExactPlane plane = plane_of(some_row(random, 50)), other = plane_of(some_row(random, 50));
    Row from = some_row(random, 50), to = some_row(random, 50);
    from[3] = random.between(1, 9);
    to[3] = random.between(1, 9);
    const EnclosedPoint p(point_of(from)), q(point_of(to));
    const Sign side_p = plane.side_of(p), side_q = plane.side_of(q);
    if (side_p == Sign::zero || side_q == Sign::zero || side_p == side_q) continue;
    const EnclosedPoint at = crossing_of(plane, p.exact, q.exact);
    EXPECT_EQ(plane.side_of(at), Sign::zero);
    // Whatever has both ends on one side has the crossing there, too.
    if (other.side_of(p) == other.side_of(q)) {
      EXPECT_EQ(other.side_of(at), other.side_of(p));
    }
    ++crossings;
  }
  EXPECT_GT(crossings, 1000);
}

TEST(ExactPlane, CommonPointsAreOnAllThree) {
  Random random(5103);
  int found = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::array<ExactPlane, 3> planes{plane_of(some_row(random, 9)), plane_of(some_row(random, 9)),
                                           plane_of(some_row(random, 9))};
    if (dot(planes[0].normal, cross(planes[1].normal, planes[2].normal)).sign() == Sign::zero) continue;
    const EnclosedPoint at = common_point(planes[0], planes[1], planes[2]);
    EXPECT_EQ(at.exact.denominator.sign(), Sign::positive);
    for (const ExactPlane& plane : planes) EXPECT_EQ(plane.side_of(at), Sign::zero);
    ++found;
  }
  EXPECT_GT(found, 2000);
}

TEST(ExactPlane, ThroughThreePoints) {
  const auto at = [](double x, double y, double z) { return Vector3<Dyadic>{Dyadic(x), Dyadic(y), Dyadic(z)}; };
  const ExactPlane plane = ExactPlane::through(at(0, 0, 1), at(1, 0, 1), at(0, 1, 1));
  EXPECT_EQ(plane.side_of(EnclosedPoint(exactly(Point3{0, 0, 2}))), Sign::positive);
  EXPECT_FALSE(plane.has_no_normal());
  EXPECT_TRUE(ExactPlane::through(at(0, 0, 0), at(1, 2, 3), at(2, 4, 6)).has_no_normal());
}

}  // namespace
}  // namespace sunder
