#include <sunder/base/random.h>
#include <sunder/certificate/check.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_warm.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_pairs.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace sunder::solid {
namespace {

void expect_right(const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b,
                  const PairAnswer& answer, bool meet, const std::string& what) {
  ASSERT_EQ(answer.meet(), meet) << what;
  ASSERT_EQ(
      check_absolutely(answer.evidence, {a.vertices(), pose_a.affine(), false}, {b.vertices(), pose_b.affine(), false}),
      CheckResult::accepted)
      << what;
}

// A turn by so much about some axis, and a shift, after the pose.
Pose moved_a_little(const Pose& pose, double by, double size, Random& random) {
  const auto u = [&] { return by * random.uniform(-1, 1); };
  const Pose turn = Pose::from_quaternion(1, u(), u(), u(), {size * u(), size * u(), size * u()});
  return compose(turn, pose);
}

// What is left by one pair serves the next, whatever it is; then twice at the same place; then moved a little.
TEST(PolyhedronPolyhedronWarm, IsRightWhateverTheLastAnswerWas) {
  tests::SolidPairs pairs(tests::chosen_seed(61));
  WarmStart last;
  int meet = 0, apart = 0, kept = 0, rounds = tests::scaled_count(3000, 200);
  for (int round = 0; round < rounds; ++round) {
    const tests::PairCase c = pairs.next();
    const std::string what = std::to_string(round) + " " + std::string(tests::name_of(c.family));
    const auto ask = [&](const Pose& pose_b) {
      const bool expected = polyhedron_polyhedron(c.a, c.pose_a, c.b, pose_b).meet();
      const PairAnswer answer = polyhedron_polyhedron_warm(c.a, c.pose_a, c.b, pose_b, last);
      expect_right(c.a, c.pose_a, c.b, pose_b, answer, expected, what);
      (expected ? meet : apart) += 1;
      return answer;
    };
    ASSERT_NO_FATAL_FAILURE((void)ask(c.pose_b));
    const PairAnswer again = ask(c.pose_b);
    if (last.kind != WarmStart::Kind::none && again.cost.iterations == 0) ++kept;
    if (c.family == tests::Family::tiny_or_huge || tests::is_stretched(c.family)) continue;
    ASSERT_NO_FATAL_FAILURE((void)ask(moved_a_little(c.pose_b, 1e-3, 1, pairs.random())));
  }
  EXPECT_GT(meet, rounds / 2);
  EXPECT_GT(apart, rounds / 2);
  EXPECT_GT(kept, rounds * 3 / 4);
}

TEST(PolyhedronPolyhedronWarm, NonsenseIsOfNoUse) {
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  using enum WarmStart::Kind;
  const auto parting = [&](std::uint8_t count, const Point3& direction, std::uint32_t extreme_a) {
    return WarmStart{apart, 0, 0, count, {}, {{{direction, extreme_a, 0}}}};
  };
  const std::array<WarmStart, 8> all{{{meet, 200, 200, 0, {}, {}},
                                      {meet, 3, 2, 0, {0, 1, 99, 0, 1}, {}},
                                      {meet, 0, 5, 0, {}, {}},
                                      {meet, 5, 1, 0, {}, {}},
                                      parting(1, {1, 0, 0}, 8),
                                      parting(1, {infinity, 0, 0}, 0),
                                      parting(1, {0, 0, std::nan("")}, 0),
                                      parting(200, {0, 0, 0}, 0)}};
  for (const double x : {0.5, 1.0, 1.5}) {
    for (WarmStart last : all) {
      const PairAnswer answer = polyhedron_polyhedron_warm(cube, Pose(), cube, tests::shift(x, 0, 0), last);
      expect_right(cube, Pose(), cube, tests::shift(x, 0, 0), answer, x <= 1, std::to_string(x));
    }
  }
}

// Bodies of 100 vertices that pass each other slowly: what is looked at, of the cold and of the warm question.
TEST(PolyhedronPolyhedronWarm, HardlySearchesWhereBodiesMoveSlowly) {
  Random random(tests::chosen_seed(62));
  Cost cold, warm;
  int meet = 0, kept = 0, asked = 0;
  for (int round = 0; round < tests::scaled_count(100, 10); ++round) {
    const ConvexPolyhedron a(tests::points_on_sphere(100, random)), b(tests::points_on_sphere(100, random));
    const Point3 way = tests::on_sphere(random), beside = tests::on_sphere(random);
    WarmStart last;
    for (int step = 0; step < 100; ++step) {
      const double t = 0.02 * (step - 50), angle = 0.01 * step;
      const Pose pose_b =
          Pose::from_quaternion(1, angle * beside.x, angle * beside.y, angle * beside.z,
                                {2.2 * beside.x + t * way.x, 2.2 * beside.y + t * way.y, 2.2 * beside.z + t * way.z});
      const PairAnswer there = polyhedron_polyhedron(a, Pose(), b, pose_b);
      const PairAnswer answer = polyhedron_polyhedron_warm(a, Pose(), b, pose_b, last);
      expect_right(a, Pose(), b, pose_b, answer, there.meet(), std::to_string(round));
      cold.probes += there.cost.probes, cold.iterations += there.cost.iterations;
      warm.probes += answer.cost.probes, warm.iterations += answer.cost.iterations;
      meet += answer.meet();
      kept += answer.cost.iterations == 0;
      ++asked;
    }
  }
  EXPECT_GT(meet, asked / 20);
  EXPECT_GT(asked - meet, asked / 20);
  EXPECT_GT(kept, asked * 8 / 10);
  EXPECT_LT(warm.probes, cold.probes);
  EXPECT_LT(warm.iterations * 5, cold.iterations);
}

}  // namespace
}  // namespace sunder::solid
