#include <sunder/base/random.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/pair/kept_partings.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>
#include <sunder/solid/pair/polyhedron_polyhedron_warm.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_pairs.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

namespace sunder::solid {
namespace {

// Takes what the search found as a parting; true where it was kept.
bool keep(const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b,
          std::span<KeptParting> kept) {
  WarmStart last;
  if (polyhedron_polyhedron_warm(a, pose_a, b, pose_b, last).meet() || last.partings_count == 0) return false;
  const auto& [direction, extreme_a, extreme_b] = last.partings[0];
  return keep_parting(a, direction, extreme_a, extreme_b, kept);
}

bool part(const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b,
          std::span<KeptParting> kept, double least = 0) {
  RigidlyPlaced at_a(a), at_b(b);
  at_a.place(pose_a);
  at_b.place(pose_b);
  return part_again(at_a, at_b, kept, least);
}

// Of all families: what parted them serves around where it did, and never parts what meets.
TEST(KeptPartings, NeverPartWhatMeets) {
  tests::SolidPairs pairs(tests::chosen_seed(83));
  Random& random = pairs.random();
  int kept_count = 0, parted = 0, meeting = 0, asked = 0;
  for (int round = 0; round < tests::scaled_count(2000, 200); ++round) {
    const tests::PairCase c = pairs.next();
    if (tests::is_stretched(c.family)) continue;
    std::array<KeptParting, 3> kept{};
    for (int step = 0; step < 8; ++step) {
      const double by = random.log_uniform(1e-16, 1);
      const auto u = [&] { return by * random.uniform(-1, 1); };
      const bool is_tiny = c.family == tests::Family::tiny_or_huge;
      const Pose pose_b =
          step == 0 || is_tiny ? c.pose_b : compose(Pose::from_quaternion(1, u(), u(), u(), {u(), u(), u()}), c.pose_b);
      const bool meet = polyhedron_polyhedron(c.a, c.pose_a, c.b, pose_b).meet();
      const bool is_parted = part(c.a, c.pose_a, c.b, pose_b, kept);
      ASSERT_FALSE(is_parted && meet) << round << " " << tests::name_of(c.family);
      ++asked;
      meeting += meet;
      parted += is_parted;
      if (!is_parted) kept_count += keep(c.a, c.pose_a, c.b, pose_b, kept);
    }
  }
  EXPECT_GT(meeting, asked / 5);
  EXPECT_GT(kept_count, asked / 20);
  EXPECT_GT(parted, asked / 10);
}

// Two cubes along an axis: down to some roundings it is sure, and not where they touch.
TEST(KeptPartings, AreSureDownToRounding) {
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  std::array<KeptParting, 2> kept{};
  EXPECT_FALSE(part(cube, Pose(), cube, tests::shift(3, 0, 0), kept));
  ASSERT_TRUE(keep(cube, Pose(), cube, tests::shift(3, 0, 0), kept));
  EXPECT_TRUE(part(cube, Pose(), cube, tests::shift(1 + 0x1p-30, 0, 0), kept));
  for (const double x : {1 + 0x1p-52, 1.0, 1 - 0x1p-53, 0.5}) {
    EXPECT_FALSE(part(cube, Pose(), cube, tests::shift(x, 0, 0), kept)) << x;
  }
}

// Of all families: what is surely further apart than a distance is, exactly; at distances of all sizes, and at what is
// just above or below what is between them.
TEST(KeptPartings, NeverPartWhatIsCloser) {
  tests::SolidPairs pairs(tests::chosen_seed(85));
  Random& random = pairs.random();
  int parted = 0, closer = 0, by_a_part = 0, asked = 0;
  for (int round = 0; round < tests::scaled_count(1000, 200); ++round) {
    const tests::PairCase c = pairs.next();
    if (tests::is_stretched(c.family)) continue;
    std::array<KeptParting, 3> kept{};
    for (int step = 0; step < 6; ++step) {
      const double by = random.log_uniform(1e-16, 0.1);
      const auto u = [&] { return by * random.uniform(-1, 1); };
      const bool is_tiny = c.family == tests::Family::tiny_or_huge;
      const Pose pose_b =
          step == 0 || is_tiny ? c.pose_b : compose(Pose::from_quaternion(1, u(), u(), u(), {u(), u(), u()}), c.pose_b);
      const PolyhedronDistance distance = polyhedron_polyhedron_distance(c.a, c.pose_a, c.b, pose_b);
      if (distance.meet()) continue;
      const double about = distance_of(distance).low;
      RigidlyPlaced at_a(c.a);
      at_a.place(c.pose_a);
      const ExactWay way = closest_of(distance)->way();
      const Vector3<Interval> along = WorldDirection(way.way.way).enclosure();
      (void)keep_parting_of_world(at_a, {along.x.low, along.y.low, along.z.low}, kept);
      for (const double part_of : {1e-9, 0.5, 1 - 1e-10, 1 - 0x1p-50, 1.0, 1 + 0x1p-52, 1 + 0x1p-45, 2.0}) {
        const double least = about * part_of;
        if (!(least <= 1e300)) continue;
        const bool is_closer = compare_distance(distance, least) == Sign::negative;
        const bool is_parted = part(c.a, c.pose_a, c.b, pose_b, kept, least);
        ASSERT_FALSE(is_parted && is_closer) << round << " " << tests::name_of(c.family) << " " << part_of;
        ++asked;
        closer += is_closer;
        parted += is_parted;
        by_a_part += is_parted && part_of > 0.9;
      }
    }
  }
  EXPECT_GT(closer, asked / 8);
  EXPECT_GT(parted, asked / 8);
  EXPECT_GT(by_a_part, asked / 50);
}

// A gap of 2 against distances: sure down to some roundings, along directions that are not of length one, too.
TEST(KeptPartings, AreSureOfDistancesDownToRounding) {
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  for (const Point3& way : {Point3{1, 0, 0}, Point3{5, 0, 0}}) {
    std::array<KeptParting, 1> kept{};
    RigidlyPlaced at(cube);
    at.place(Pose());
    ASSERT_TRUE(keep_parting_of_world(at, way, kept));
    for (const double least : {0x1p-1070, 1.0, 2 - 0x1p-36}) {
      EXPECT_TRUE(part(cube, Pose(), cube, tests::shift(3, 0, 0), kept, least)) << least;
    }
    for (const double least : {2 - 0x1p-52, 2.0, 2 + 0x1p-51, 1e308, HUGE_VAL}) {
      EXPECT_FALSE(part(cube, Pose(), cube, tests::shift(3, 0, 0), kept, least)) << least;
    }
  }
  // Along (1, 1, 0) the gap is 2 in length, 2 sqrt(2) as the product tells.
  std::array<KeptParting, 1> kept{};
  RigidlyPlaced at(cube);
  at.place(Pose());
  ASSERT_TRUE(keep_parting_of_world(at, {1, 1, 0}, kept));
  const double root = std::sqrt(2.0);
  EXPECT_TRUE(part(cube, Pose(), cube, tests::shift(1 + root, 1 + root, 0), kept, 2 - 0x1p-36));
  EXPECT_FALSE(part(cube, Pose(), cube, tests::shift(1 + root, 1 + root, 0), kept, 2 + 0x1p-36));
  EXPECT_FALSE(keep_parting_of_world(at, {0, 0, 0}, kept));
  EXPECT_FALSE(keep_parting_of_world(at, {HUGE_VAL, 0, 0}, kept));
}

// The direction turns with the first body; where that does not move rigidly nothing is sure.
TEST(KeptPartings, TurnWithTheFirstBody) {
  Random random(tests::chosen_seed(84));
  const ConvexPolyhedron a(tests::points_on_sphere(100, random)), b(tests::points_on_sphere(60, random));
  const Pose pose_b = tests::shift(2.5, 0.3, 0.1);
  std::array<KeptParting, 2> kept{};
  ASSERT_TRUE(keep(a, Pose(), b, pose_b, kept));
  const auto u = [&] { return random.uniform(-1, 1); };
  for (int round = 0; round < 100; ++round) {
    const Pose together = Pose::from_quaternion(u(), u(), u(), u(), {u(), u(), u()});
    EXPECT_TRUE(part(a, together, b, compose(together, pose_b), kept));
    const Pose grown = compose(Pose::from_matrix({3, 0, 0, 0, 3, 0, 0, 0, 3}, {0, 0, 0}), together);
    EXPECT_FALSE(part(a, grown, b, compose(together, pose_b), kept));
    const Pose sheared = compose(together, Pose::from_matrix({1, u(), 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}));
    EXPECT_FALSE(part(a, sheared, b, compose(together, pose_b), kept) &&
                 polyhedron_polyhedron(a, sheared, b, compose(together, pose_b)).meet());
  }
}

// Nearly a rotation is one but for what it departs by: the first cube has grown over the gap.
TEST(KeptPartings, TakeWhatIsNoRotationForIt) {
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  std::array<KeptParting, 2> kept{};
  ASSERT_TRUE(keep_parting(cube, {1, 0, 0}, 7, 0, kept));
  const double by = 1 + 0x1p-21;
  const Pose grown = Pose::from_matrix({by, 0, 0, 0, by, 0, 0, 0, by}, {0, 0, 0});
  EXPECT_FALSE(part(cube, grown, cube, tests::shift(1 + 0x1p-22, 0, 0), kept));
  EXPECT_FALSE(part(cube, grown, cube, tests::shift(by, 0, 0), kept));
  EXPECT_TRUE(part(cube, grown, cube, tests::shift(1 + 0x1p-16, 0, 0), kept));
}

// Any vertex does to begin with: where it is not surely the extreme one, all are looked at.
TEST(KeptPartings, ReachAsFarAsTheBody) {
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  std::array<KeptParting, 1> kept{};
  for (std::uint32_t v = 0; v < 8; ++v) {
    ASSERT_TRUE(keep_parting(cube, {1, 0.5, 0}, v, 0, kept));
    EXPECT_EQ(kept[0].reach, 1.5);
  }
}

// What held becomes the first, and the oldest is forgotten.
TEST(KeptPartings, TheLastThatHeldIsTheFirst) {
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  std::array<KeptParting, 2> kept{};
  ASSERT_TRUE(keep_parting(cube, {1, 0, 0}, 7, 0, kept));
  ASSERT_TRUE(keep_parting(cube, {0, 1, 0}, 7, 0, kept));
  EXPECT_EQ(kept[0].direction.y, 1);
  EXPECT_TRUE(part(cube, Pose(), cube, tests::shift(2, 0, 0), kept));
  EXPECT_EQ(kept[0].direction.x, 1);
  EXPECT_EQ(kept[1].direction.y, 1);
  ASSERT_TRUE(keep_parting(cube, {0, 0, 1}, 7, 0, kept));
  EXPECT_EQ(kept[1].direction.x, 1);
  EXPECT_EQ(kept[0].reach, 1);
  EXPECT_FALSE(part(cube, Pose(), cube, tests::shift(0, 2, 0), kept));
}

}  // namespace
}  // namespace sunder::solid
