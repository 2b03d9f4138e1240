#include <sunder/base/random.h>
#include <sunder/scene/clearance_follower.h>

#include <tests/support/round_pairs.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder::scene {
namespace {

using solid::ConvexPolyhedron;
using solid::Pose;
using Told = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, double, double, double>;

std::vector<Told> told(const std::vector<CloserParts>& list) {
  std::vector<Told> all;
  for (const CloserParts& p : list) {
    all.emplace_back(p.body_a, p.body_b, p.part_a, p.part_b, p.least, p.distance.low, p.distance.high);
  }
  return all;
}

void expect_same_points(const PartDistance& p, const PartDistance& q) {
  EXPECT_EQ(rounded_nearest(p.evidence), rounded_nearest(q.evidence));
}

enum class BodyKind : std::uint8_t { lattice, polyhedra, any };

// Bodies that jump now and then, and else move a little: cubes on a lattice of eighths, of which many are exactly so
// far apart as is asked; polyhedra; anything with a radius, too.
class Moving {
 public:
  Moving(BodyKind kind, Random& random) : kind_(kind), random_(random), bodies(3 + random.below(5)) {
    const ConvexPolyhedron cube(tests::cube_corners(0, 1));
    for (Body& body : bodies) {
      for (std::uint64_t i = 1 + random.below(2); i > 0; --i) body.parts.push_back({"", shape(), anywhere()});
    }
  }

  void go_on() {
    for (Body& body : bodies) {
      for (Part& part : body.parts) {
        if (random_.below(4) != 0) part.pose = random_.below(12) == 0 ? anywhere() : near(part.pose);
      }
    }
  }

 private:
  BodyKind kind_;
  Random& random_;

  solid::RoundBody shape() {
    if (kind_ == BodyKind::lattice) return ConvexPolyhedron(tests::cube_corners(0, 1));
    if (kind_ == BodyKind::polyhedra) return ConvexPolyhedron(tests::points_in_cube(1 + random_.below(60), random_));
    return tests::some_primitive(static_cast<tests::Primitive>(random_.below(tests::primitive_count)), random_);
  }
  Pose anywhere() {
    const auto u = [&] { return random_.uniform(-1, 1); };
    const auto n = [&] { return static_cast<double>(random_.between(-16, 16)) / 8; };
    if (kind_ == BodyKind::lattice) return tests::shift(n(), n(), n());
    return Pose::from_quaternion(u(), u(), u(), 1, {4 * u(), 4 * u(), 4 * u()});
  }
  Pose near(const Pose& pose) {
    const auto u = [&] { return 0.03 * random_.uniform(-1, 1); };
    const auto n = [&] { return static_cast<double>(random_.between(-1, 1)) / 8; };
    if (kind_ == BodyKind::lattice) return compose(tests::shift(n(), n(), n()), pose);
    return compose(Pose::from_quaternion(1, u(), u(), u(), {u(), u(), u()}), pose);
  }

 public:
  std::vector<Body> bodies;
};

// K1, of thousands of placements; and that most of what is far enough apart is not asked about anew.
void compare_with_cold(BodyKind kind, int count, std::uint64_t seed) {
  Random random(tests::chosen_seed(seed));
  std::uint64_t closer = 0, exactly = 0, near = 0, cold = 0, placements = 0;
  for (int round = 0; round < tests::scaled_count(count, 12); ++round) {
    Moving moving(kind, random);
    const auto some_body = [&] { return static_cast<std::uint32_t>(random.below(moving.bodies.size())); };
    ClearanceQuestion question;
    const auto margin = [&] {
      return kind == BodyKind::lattice ? 0.125 * static_cast<double>(1 + random.below(8))
                                       : random.log_uniform(1e-3, 1.5);
    };
    question.least = margin();
    for (std::uint64_t i = random.below(3); i > 0; --i) {
      question.margins.push_back({some_body(), some_body(), random.below(4) == 0 ? 0 : margin()});
    }
    if (random.below(2) == 0) question.allowed.push_back({some_body(), some_body()});
    const ClearanceFollower start(moving.bodies, question);
    ClearanceFollower follower = start;
    for (int step = 0; step < 64; ++step, ++placements) {
      const std::uint64_t before = follower.looks();
      const ClearanceAnswer warm = follower.ask(moving.bodies), expected = closer_pairs(moving.bodies, question);
      ASSERT_EQ(told(warm.closer), told(expected.closer)) << seed << " " << round << " " << step;
      ASSERT_EQ(told(warm.undecided), told(expected.undecided)) << seed << " " << round << " " << step;
      for (std::size_t k = 0; k < warm.closer.size(); ++k) expect_same_points(warm.closer[k], expected.closer[k]);
      ASSERT_EQ(warm.pairs, expected.pairs);
      ASSERT_EQ(warm.allowed, expected.allowed);
      ASSERT_EQ(warm.pairs, warm.allowed + warm.by_boxes + warm.by_method);
      ASSERT_GE(warm.by_method, expected.by_method);
      closer += warm.closer.size();
      near += warm.by_method - warm.closer.size() - warm.undecided.size();
      cold += follower.looks() - before - warm.closer.size() - warm.undecided.size();
      if (kind == BodyKind::lattice && question.margins.empty()) {
        // Exactly so far apart is far enough: the least more, and they are closer.
        ClearanceQuestion more = question;
        more.least += 0x1p-40;
        const ClearanceAnswer those = closer_pairs(moving.bodies, more);
        exactly += those.closer.size() - expected.closer.size();
      }
      moving.go_on();
    }
  }
  EXPECT_GT(closer, placements / 8);
  EXPECT_GT(near, placements / 8);
  // On a lattice many are exactly so far apart, and ellipsoids are always asked about anew.
  EXPECT_LT(cold, kind == BodyKind::polyhedra ? near - near / 4 : near - near / 20);
  if (kind == BodyKind::lattice) {
    EXPECT_GT(exactly, placements / 80);
  }
}

TEST(ClearanceFollower, IsColdOnALattice) { compare_with_cold(BodyKind::lattice, 40, 181); }
TEST(ClearanceFollower, IsColdOfPolyhedra) { compare_with_cold(BodyKind::polyhedra, 40, 182); }
TEST(ClearanceFollower, IsColdOfAnything) { compare_with_cold(BodyKind::any, 25, 183); }

// What parted them by more does not hide the last bit. Turned by 45 degrees, as far as doubles go, boxes do not tell.
TEST(ClearanceFollower, TellsTheLastBit) {
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  const Pose turned = Pose::from_quaternion(1, 0, 0, 0.4142135623730951, {});
  for (const solid::RoundBody& other : {solid::RoundBody(cube), solid::RoundBody::ball({0.5, 0.5, 0.5}, 0.5)}) {
    std::vector<Body> bodies{{"a", {{"", cube, turned}}}, {"b", {{"", other, Pose()}}}};
    const ClearanceQuestion question{0.25, {}, {}};
    ClearanceFollower follower(bodies, question);
    int closer = 0;
    for (int bit = 8; bit >= -8; --bit) {
      bodies[1].parts[0].pose = compose(turned, tests::shift(1.25 + bit * 0x1p-52, 0, 0));
      const ClearanceAnswer warm = follower.ask(bodies), expected = closer_pairs(bodies, question);
      EXPECT_EQ(told(warm.closer), told(expected.closer)) << bit;
      closer += static_cast<int>(expected.closer.size());
    }
    EXPECT_GT(closer, 4);
    EXPECT_LT(closer, 13);
    EXPECT_EQ(follower.looks(), 17u);  // in none of them it is sure
    bodies[1].parts[0].pose = compose(turned, tests::shift(1.25 + 0x1p-20, 0, 0));
    EXPECT_TRUE(follower.ask(bodies).closer.empty());
    EXPECT_EQ(follower.looks(), 17u);  // here it is
  }
}

// An ellipsoid is not within a radius of its core, which is its centre. Turned, boxes do not tell.
TEST(ClearanceFollower, EllipsoidsAreLongerThanTheirCores) {
  const Pose turned = Pose::from_quaternion(1, 0, 0, 0.4142135623730951, {});
  std::vector<Body> bodies{{"a", {{"", solid::RoundBody::ellipsoid({0, 0, 0}, {3, 0.2, 0.2}), turned}}},
                           {"b", {{"", ConvexPolyhedron(tests::cube_corners(0, 1)), Pose()}}}};
  const ClearanceQuestion question{0.25, {}, {}};
  ClearanceFollower follower(bodies, question);
  for (const double x : {3.5, 3.3, 3.2, 3.1, 2.9, 3.4}) {
    bodies[1].parts[0].pose = compose(turned, tests::shift(x, -0.5, -0.5));
    const ClearanceAnswer warm = follower.ask(bodies);
    EXPECT_EQ(warm.by_method, 1u);
    EXPECT_EQ(warm.closer.size(), x < 3.25 ? 1u : 0u) << x;
  }
}

// A part that cannot be placed is told each time, and then nothing is left of where it was to be.
TEST(ClearanceFollower, ThrowsAsOftenAsItIsAsked) {
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  const solid::RoundBody far_off = solid::RoundBody::ellipsoid({1e308, 0, 0}, {1, 1, 1});
  const Pose beyond = tests::shift(1.5e308, 0, 0);
  std::vector<Body> bodies{{"a", {{"", far_off, tests::shift(-1e308, 0, 0)}}},
                           {"b", {{"", cube, tests::shift(9, 0, 0)}}}};
  const ClearanceQuestion question{0.25, {}, {}};
  ClearanceFollower follower(bodies, question);
  const Pose here = bodies[0].parts[0].pose;
  for (int round = 0; round < 2; ++round) {
    bodies[0].parts[0].pose = here;
    EXPECT_EQ(told(follower.ask(bodies).closer), told(closer_pairs(bodies, question).closer));
    bodies[0].parts[0].pose = beyond;
    for (int time = 0; time < 2; ++time) {
      EXPECT_THROW((void)closer_pairs(bodies, question), Error);
      EXPECT_THROW((void)follower.ask(bodies), Error) << round << " " << time;
    }
  }
}

}  // namespace
}  // namespace sunder::scene
