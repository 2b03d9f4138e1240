// Directions of certificates against the same formulas in fractions.
#include <sunder/base/random.h>
#include <sunder/certificate/direction.h>
#include <sunder/certificate/fractions_test.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace sunder {
namespace {

Exact3 exact_direction(const WorldDirection& d) {
  const Vector3<Dyadic> v = d.exact();
  return {exact(v.x), exact(v.y), exact(v.z)};
}

Exact3 difference(const Exact3& a, const Exact3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Exact3 cross_product(const Exact3& a, const Exact3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool is_zero(const Exact3& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

// The same ray: parallel, and not against each other; or both zero.
bool same_ray(const Exact3& a, const Exact3& b) {
  if (is_zero(a) || is_zero(b)) return is_zero(a) && is_zero(b);
  return is_zero(cross_product(a, b)) && a[0] * b[0] + a[1] * b[1] + a[2] * b[2] > 0;
}

class DirectionTest : public testing::Test {
 protected:
  // Coordinates of very different sizes, some of them zero, or small integers so that directions degenerate.
  double some_number() {
    switch (random_.below(4)) {
      case 0: return static_cast<double>(random_.between(-1, 1));
      case 1: return std::ldexp(random_.uniform(-1, 1), static_cast<int>(random_.between(-300, 300)));
      default: return random_.uniform(-1, 1);
    }
  }
  Affine3 some_pose() {
    Affine3 pose;
    for (double& x : pose.linear) x = some_number();
    for (double& x : pose.translation) x = some_number();
    return pose;
  }
  std::vector<Point3> some_points() {
    std::vector<Point3> points(6);
    for (Point3& p : points) p = {some_number(), some_number(), some_number()};
    return points;
  }
  Random random_{tests::chosen_seed(41)};
};

TEST_F(DirectionTest, IsThatOfTheFeaturesItNames) {
  int degenerate = 0, proper = 0;
  for (int i = 0; i < 300; ++i) {
    const auto points_a = some_points(), points_b = some_points();
    const Affine3 pose_a = some_pose(), pose_b = some_pose();
    const bool tame = false;
    const PlacedVertices a{points_a, pose_a, tame}, b{points_b, pose_b, tame};
    Direction d;
    for (std::uint32_t& k : d.index) k = static_cast<std::uint32_t>(random_.below(6));
    const auto p = [&](std::size_t k) { return image(pose_a, points_a[d.index[k]]); };
    const auto q = [&](std::size_t k) { return image(pose_b, points_b[d.index[k]]); };
    const auto expect = [&](Direction::Kind kind, const Exact3& forward) {
      d.kind = kind;
      d.reversed = false;
      EXPECT_TRUE(same_ray(exact_direction(world_direction(d, a, b)), forward))
          << i << " kind " << static_cast<int>(kind);
      d.reversed = true;
      EXPECT_TRUE(same_ray(exact_direction(world_direction(d, a, b)), difference({}, forward)))
          << i << " kind " << static_cast<int>(kind);
      ++(is_zero(forward) ? degenerate : proper);
    };
    expect(Direction::Kind::normal_of_a, cross_product(difference(p(1), p(0)), difference(p(2), p(0))));
    expect(Direction::Kind::normal_of_b, cross_product(difference(q(1), q(0)), difference(q(2), q(0))));
    expect(Direction::Kind::edge_cross_edge, cross_product(difference(p(1), p(0)), difference(q(3), q(2))));
    expect(Direction::Kind::difference, difference(q(1), p(0)));
  }
  EXPECT_GT(degenerate, 100);
  EXPECT_GT(proper, 500);
}

TEST_F(DirectionTest, GivenNumbersAreTakenAsTheyAre) {
  const std::vector<Point3> points{{}};
  const Affine3 pose;
  const PlacedVertices a{points, pose, true};
  Direction d;
  d.given = {5e-324, -std::numeric_limits<double>::max(), 0.1};
  for (const bool reversed : {false, true}) {  // which means nothing here
    d.reversed = reversed;
    const WorldDirection w = world_direction(d, a, a);
    EXPECT_TRUE(w.is_doubles());
    EXPECT_EQ(w.doubles(), d.given);
  }
  d.kind = Direction::Kind::exact;
  d.numbers = std::make_shared<const std::array<Dyadic, 3>>(
      std::array<Dyadic, 3>{Dyadic(3.0).scaled(-5000), 0.0, Dyadic(-1.0).scaled(4000)});
  for (const bool reversed : {false, true}) {
    d.reversed = reversed;
    const WorldDirection w = world_direction(d, a, a);
    EXPECT_FALSE(w.is_doubles());
    EXPECT_TRUE(same_ray(exact_direction(w), {times_power(3, -5000), 0, times_power(-1, 4000)}));
  }
}

TEST_F(DirectionTest, PlacedVerticesGiveWhatTheyHold) {
  const std::vector<Point3> points{{1, 2, 3}, {4, 5, 6}};
  const Affine3 pose{{1, 0, 0, 0, 2, 0, 0, 0, 3}, {7, 8, 9}};
  const PlacedVertices a{points, pose, true};
  EXPECT_EQ(a[1].point, points[1]);
  EXPECT_EQ(a[1].pose, &pose);
  EXPECT_TRUE(a[1].tame);
}

}  // namespace
}  // namespace sunder
