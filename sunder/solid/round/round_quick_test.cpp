// That the closed forms and the short search decide: the general search would hide it if they did not.
#include <sunder/solid/round/round_clearance.h>
#include <sunder/solid/round/round_quick.h>

#include <sunder/base/random.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>
#include <tests/support/exact.h>
#include <tests/support/round_pairs.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace sunder::solid {
namespace {

constexpr std::array names{"ball", "capsule", "box", "rounded box", "cylinder", "cone", "ellipsoid", "turned box"};

RoundBody some(std::size_t kind, Random& random) {
  const auto size = [&] { return random.log_uniform(0.3, 1); };
  const double x = size(), y = size(), z = size();
  std::vector<Point3> corners = tests::cube_corners(-1, 1), turned;
  for (Point3& c : corners) {
    c = {c.x * x + 0.25, c.y * y, c.z * z};
    turned.push_back({0.6 * c.x - 0.8 * c.y, 0.8 * c.x + 0.6 * c.y, c.z});
  }
  switch (kind) {
    case 0: return RoundBody::ball({0.25, 0, 0}, x);
    case 1: return RoundBody::capsule({0.25, 0, -y}, {0, 0.25, y}, x);
    case 2: return RoundBody::rounded(ConvexPolyhedron(corners), 0);
    case 3: return RoundBody::rounded(ConvexPolyhedron(corners), 0.25);
    case 4: return RoundBody::cylinder({0.25, 0, -y}, {0, 0.25, y}, x);
    case 5: return RoundBody::cone({0.25, 0, -y}, {0, 0.25, y}, x);
    case 7: return RoundBody::rounded(ConvexPolyhedron(turned), 0);
    default: return RoundBody::ellipsoid({0.25, 0, 0}, {x, y, z});
  }
}
Pose some_pose(double far, Random& random) {
  std::array<double, 7> n{};
  for (double& x : n) x = random.uniform(-1, 1);
  return Pose::from_quaternion(n[0], n[1], n[2], n[3], {far * n[4], far * n[5], far * n[6]});
}

struct Tally {
  int quick = 0, wrong = 0, meet = 0, all = 0;
};
void see(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b, bool meet, Tally& tally) {
  RoundAnswer answer;
  Point3 way{};
  const PlacedRound of_a(a, pose_a), of_b(b, pose_b);
  ++tally.all;
  tally.meet += meet ? 1 : 0;
  if (!decide_quickly(a, of_a.pose, b, of_b.pose, answer, way)) return;
  ++tally.quick;
  if (answer.meet() != meet || answer.undecided()) ++tally.wrong;
}

TEST(RoundQuick, EachPairOfKindsIsDecided) {
  Random random(20261205);
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = 0; j < names.size(); ++j) {
      const auto is_box = [](std::size_t kind) { return kind == 2 || kind == 3 || kind == 7; };
      if (is_box(i) && is_box(j)) continue;
      Tally far, near;
      const int count = tests::scaled_count(25, 10);
      for (int k = 0; k < count; ++k) {
        const RoundBody a = some(i, random), b = some(j, random);
        const Pose pose_a = some_pose(0.9, random), pose_b = some_pose(0.9, random);
        see(a, pose_a, b, pose_b, round_round(a, pose_a, b, pose_b).meet(), far);
        // Moved to where they no longer meet, and by 1e-9 to either side.
        const Point3 u = tests::on_sphere(random), out{8 * u.x, 8 * u.y, 8 * u.z};
        const Pose middle = some_pose(0.1, random);
        if (!round_round(a, middle, b, middle).meet()) continue;
        const double t = tests::last_meeting(a, middle, b, middle, out);
        for (const double by : {-1e-9, 1e-9}) see(a, middle, b, tests::moved(middle, out, t + by / 8), by < 0, near);
      }
      SCOPED_TRACE(std::string(names[i]) + ", " + names[j]);
      EXPECT_EQ(far.wrong + near.wrong, 0);
      EXPECT_GE(far.quick, 0.9 * far.all);
      EXPECT_GT(far.meet, count / 20);
      EXPECT_GE(near.quick, 0.85 * near.all);
      EXPECT_GT(near.all, count * 6 / 5);
    }
  }
}

// Where a rim and an apex are in each other and nothing bends along one way: few of these are left to the slow search.
TEST(RoundQuick, ConesNearContact) {
  Random random(20261207);
  for (const std::size_t other : {std::size_t{4}, std::size_t{5}}) {
    Tally near;
    while (near.all < tests::scaled_count(1000)) {
      const RoundBody a = some(5, random), b = some(other, random);
      const Pose pose_a = some_pose(0.1, random), pose_b = some_pose(0.1, random);
      if (!round_round(a, pose_a, b, pose_b).meet()) continue;
      const Point3 u = tests::on_sphere(random), out{8 * u.x, 8 * u.y, 8 * u.z};
      const double t = tests::last_meeting(a, pose_a, b, pose_b, out), by = near.all % 2 == 0 ? 1e-12 : -1e-12;
      see(a, pose_a, b, tests::moved(pose_b, out, t + by / 8), by < 0, near);
    }
    SCOPED_TRACE(names[other]);
    EXPECT_EQ(near.wrong, 0);
    EXPECT_LE(near.all - near.quick, 1);
  }
}

// What searches read instead of the core is of its vertices, and only where these are all of it.
TEST(RoundQuick, BoxesAlongTheAxesAreTheirCorners) {
  Random random(20261127);
  for (int k = 0; k < 100; ++k) {
    const Point3 low{random.uniform(-2, 1), random.uniform(-2, 1), random.uniform(-2, 1)};
    const Point3 side{random.log_uniform(0.1, 4), random.log_uniform(0.1, 4), random.log_uniform(0.1, 4)};
    std::vector<Point3> corners = tests::cube_corners(0, 1);
    for (Point3& c : corners) c = {c.x * side.x + low.x, c.y * side.y + low.y, c.z * side.z + low.z};
    const RoundBody body = RoundBody::rounded(ConvexPolyhedron(corners), 0.25);
    ASSERT_NE(body.box(), nullptr);
    const AxisBox* box = body.axis_box();
    ASSERT_NE(box, nullptr);
    for (std::size_t place = 0; place < 8; ++place) {
      const Point3 corner{box->range[place & 1].x, box->range[place >> 1 & 1].y, box->range[place >> 2].z};
      EXPECT_EQ(body.core().vertices()[box->corners[place]], corner);
    }
    EXPECT_EQ(box->range, body.core().box());
    EXPECT_DOUBLE_EQ(box->over_side[0] * (box->range[1].x - low.x), 1);
    EXPECT_DOUBLE_EQ(box->over_side[1] * (box->range[1].y - low.y), 1);
    EXPECT_DOUBLE_EQ(box->over_side[2] * (box->range[1].z - low.z), 1);
    // A corner that is off by a last bit: a box for proposals, but not one of six doubles.
    Point3& c = corners[random.below(8)];
    c.y = std::nextafter(c.y, c.y > low.y ? low.y : 10);
    const RoundBody other = RoundBody::rounded(ConvexPolyhedron(corners), 0.25);
    EXPECT_EQ(other.axis_box(), nullptr);
  }
  const RoundBody turned = some(7, random);
  EXPECT_NE(turned.box(), nullptr);
  EXPECT_EQ(turned.axis_box(), nullptr);
  EXPECT_EQ(RoundBody::ball({}, 1).axis_box(), nullptr);
}

// Boxes with the same axes, of which sides, edges or corners face each other, near contact and far from the origin:
// weights of evidence have lost some bits there.
TEST(RoundQuick, BoxesWithTheSameAxesFarAway) {
  Random random(20261126);
  const auto radius = [&] { return std::round(random.log_uniform(1e-6, 1) * 0x1p24) * 0x1p-24; };  // sums are exact
  int quick = 0, meet = 0, all = 0;
  for (int k = 0; k < tests::scaled_count(20000); ++k) {
    std::array<std::array<double, 3>, 2> half{};
    std::array<std::vector<Point3>, 2> corners;
    for (std::size_t i = 0; i < 2; ++i) {
      for (double& x : half[i]) x = random.log_uniform(0.05, 1);
      for (Point3& c : corners[i] = tests::cube_corners(-1, 1)) {
        c = {c.x * half[i][0], c.y * half[i][1], c.z * half[i][2]};
      }
    }
    const double of_a = radius(), of_b = k % 2 == 0 ? 0 : radius(), far = random.log_uniform(1, 0x1p20);
    const double gap = random.log_uniform(0x1p-50, 0x1p-8) * far * (k % 3 == 0 ? -1 : 1);
    if (std::fabs(gap) > 1) continue;
    std::array<double, 3> way{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double p = half[0][i], q = half[1][i];
      way[i] = std::array{p - q, q - p, p + q, -p - q, 0.0}[random.below(5)];
    }
    const std::size_t across = random.below(3);
    way[across] = half[0][across] + half[1][across] + of_a + of_b + gap;
    const Pose pose_a = tests::moved(some_pose(0, random), tests::on_sphere(random), far);
    const auto& m = pose_a.affine().linear;
    const Point3 turned{m[0] * way[0] + m[1] * way[1] + m[2] * way[2], m[3] * way[0] + m[4] * way[1] + m[5] * way[2],
                        m[6] * way[0] + m[7] * way[1] + m[8] * way[2]};
    const Pose pose_b = tests::moved(pose_a, turned, 1);
    const ConvexPolyhedron core_a(corners[0]), core_b(corners[1]);
    const PolyhedronDistance distance = polyhedron_polyhedron_distance(core_a, pose_a, core_b, pose_b);
    if (distance.meet()) continue;
    const bool is_meet = compare_distance(distance, of_a + of_b) != Sign::positive;
    Tally tally;
    see(RoundBody::rounded(core_a, of_a), pose_a, RoundBody::rounded(core_b, of_b), pose_b, is_meet, tally);
    ASSERT_EQ(tally.wrong, 0) << k;
    ++all;
    meet += tally.meet;
    quick += tally.quick;
  }
  EXPECT_GT(meet, all / 5);
  EXPECT_GT(quick, all / 2);
}

// Entries of a pose beyond the range of formulas: what is asked is asked exactly.
TEST(RoundQuick, PosesAtTheEndsOfTheRangeOfDoubles) {
  const double s = 0x1p-1000, m = 0x1.8p1023, c = m * s;
  std::vector<Point3> p{{2.5 * s, 1.5 * s, 1.5 * s}};
  for (int k = 0; k < 8; ++k) p.push_back({(k & 1 ? 2 : 1) * s, (k & 2 ? 2 : 1) * s, (k & 4 ? 2 : 1) * s});
  const Pose pose = Pose::from_matrix({m, 0, 0, m, m, 0, 0, 0, m}, {0, 0, 0});
  const RoundBody a{ConvexPolyhedron(p)}, b = RoundBody::ball({1.25 * c, 2.65 * c, 1.5 * c}, 0.25 * c);
  EXPECT_TRUE(round_round(a, pose, b, Pose()).meet());
}

// Side, top and rim, by 2^-30 to both sides of contact; in lengths from the least to the greatest that are quick.
TEST(RoundQuick, ABallBesideAboveAndAtTheRimOfACylinder) {
  const double little = 0x1p-30;
  struct Place {
    double x, z, radius;
  };
  const std::array<Place, 4> places{{{3, 0.5, 1}, {0.25, 2, 1}, {2 + 0.375, 1 + 0.5, 0.625}, {0, -1.5, 0.5}}};
  for (const double unit : {0x1p-98, 0x1p-40, 1.0, 0x1p40, 0x1p56}) {
    const RoundBody cylinder = RoundBody::cylinder({0, 0, -unit}, {0, 0, unit}, 2 * unit);
    for (const Place& at : places) {
      for (const bool is_meet : {true, false}) {
        const double radius = unit * (at.radius + (is_meet ? little : -little));
        const RoundBody ball = RoundBody::ball({unit * at.x, 0, unit * at.z}, radius);
        for (const bool is_a : {true, false}) {
          const Pose pose = Pose::from_quaternion(1, 2, 3, 4, {unit, -3 * unit, 2 * unit});
          const RoundAnswer answer =
              is_a ? round_round(ball, pose, cylinder, pose) : round_round(cylinder, pose, ball, pose);
          EXPECT_EQ(answer.meet(), is_meet) << unit << " " << at.x << " " << at.z << " " << is_a;
          EXPECT_FALSE(answer.undecided());
          EXPECT_EQ(answer.cost.proposals, 1);
        }
      }
    }
  }
}

// Centre on the axis to the last bit; flat and long cylinders with a ball that is deep in them.
TEST(RoundQuick, ABallOnTheAxisOrDeepInACylinder) {
  struct Case {
    RoundBody cylinder, ball;
    bool meet;
  };
  const std::array<Case, 6> cases{{
      {RoundBody::cylinder({0, 0, -1}, {0, 0, 1}, 2), RoundBody::ball({0, 0, 1.5}, 0.375), false},
      {RoundBody::cylinder({0, 0, -1}, {0, 0, 1}, 2), RoundBody::ball({0, 0, 1.5}, 0.625), true},
      {RoundBody::cylinder({0, 0, 0}, {0, 0, 1}, 64), RoundBody::ball({3, 0, 0.5}, 32), true},
      {RoundBody::cylinder({0, 0, 0}, {0, 0, 1}, 64), RoundBody::ball({65, 0, 0.5}, 32), true},
      {RoundBody::cylinder({0, 0, 0}, {0, 0, 64}, 1), RoundBody::ball({0, 0, 2}, 32), true},
      {RoundBody::cylinder({0, 0, 0}, {0, 0, 64}, 1), RoundBody::ball({2, 0, 60}, 32), true},
  }};
  for (const Case& of : cases) {
    for (const bool is_a : {true, false}) {
      RoundAnswer answer;
      Point3 way{};
      const RoundBody &a = is_a ? of.ball : of.cylinder, &b = is_a ? of.cylinder : of.ball;
      EXPECT_TRUE(decide_quickly(a, Pose(), b, Pose(), answer, way));
      EXPECT_EQ(answer.meet(), of.meet);
      EXPECT_EQ(answer.cost.proposals, 1);
      if (!of.meet) continue;
      // Of the ball its centre, of the cylinder the common point.
      const PointInDoubles& found = std::get<PointInDoubles>(answer.evidence);
      EXPECT_EQ((is_a ? found.of_a : found.of_b).count(), 1U);
      EXPECT_EQ((is_a ? found.of_b : found.of_a).count(), 0U);
    }
  }
}

// Beside and above a cylinder along an axis they meet where a sum of doubles is not negative. Either may be so large
// that its roundings are more than what doubles tell of the other.
TEST(RoundQuick, ABallWithinRoundingsOfACylinder) {
  Random random(tests::chosen_seed(20261130));
  std::array<int, 2> seen{};
  const int count = tests::scaled_count(3000, 300);
  for (int i = 0; i < count; ++i) {
    const int large = i / 4 % 3;  // 1: the ball, 2: the cylinder, then beside the ball, which is about the origin
    const bool is_beside = large == 2 || i % 2 == 0;
    const double half = random.uniform(1, 2), around = random.uniform(1, 2) * (large == 2 ? 0x1p40 : 1),
                 radius = random.uniform(0.1, 3) * (large == 1 ? 0x1p40 : 1), reached = is_beside ? around : half;
    double far = reached + radius;
    for (std::uint64_t k = random.below(3); k > 0; --k) far = std::nextafter(far, i % 4 < 2 ? HUGE_VAL : 0.0);
    const double axis = large == 2 ? -far : 0;
    const Point3 centre = !is_beside ? Point3{0.5, 0, far} : Point3{far + axis, 0, random.uniform(-1, 1)};
    const RoundBody cylinder = RoundBody::cylinder({axis, 0, -half}, {axis, 0, half}, around),
                    ball = RoundBody::ball(centre, radius);
    const bool meet = tests::Exact(far) <= tests::Exact(reached) + tests::Exact(radius);
    ++seen[meet ? 1 : 0];
    EXPECT_EQ(round_round(cylinder, Pose(), ball, Pose()).meet(), meet) << i;
    EXPECT_EQ(round_round(ball, Pose(), cylinder, Pose()).meet(), meet) << i;
  }
  EXPECT_GT(seen[0], count / 5);
  EXPECT_GT(seen[1], count / 5);
}

TEST(ClearanceVerdictTest, ToTheLastBit) {
  const RoundBody a = RoundBody::ball({0, 0, 0}, 1), b = RoundBody::ball({3, 4, 0}, 2);
  const auto closer = [](const RoundBody& p, const RoundBody& q, double least) {
    return clearance_verdict(PlacedRound(p, Pose()), PlacedRound(q, Pose()), least) == Verdict::meet;
  };
  EXPECT_FALSE(closer(a, b, std::nextafter(2, 0)));
  EXPECT_FALSE(closer(a, b, 2));
  EXPECT_TRUE(closer(a, b, std::nextafter(2, 3)));
  EXPECT_TRUE(closer(a, RoundBody::ball({1, 0, 0}, 1), 1e-300));
  // The sum of a radius and the distance is no double, and rounds up: exactly so far apart all the same.
  EXPECT_FALSE(closer(a, RoundBody::ball({3 + 0x1p-50, 0, 0}, 1 + 0x1p-52), 1 + 3 * 0x1p-52));
  EXPECT_TRUE(closer(a, RoundBody::ball({3, 0, 0}, 2), 1e-300));  // touching
}

TEST(ClearanceVerdictTest, AgreesWithTheExactDistance) {
  Random random(20261206);
  int yes = 0;
  for (int k = 0; k < 300; ++k) {
    std::vector<Point3> p, q;
    for (int i = 0; i < 40; ++i) {
      p.push_back(tests::on_sphere(random));
      q.push_back(tests::on_sphere(random));
    }
    const ConvexPolyhedron core_a(p), core_b(q);
    const Pose pose_a = some_pose(1, random), pose_b = some_pose(2, random);
    const double of_a = k % 3 == 0 ? 0.25 : 0, of_b = k % 2 == 0 ? 0.125 : 0;
    const PolyhedronDistance distance = polyhedron_polyhedron_distance(core_a, pose_a, core_b, pose_b);
    const double about = distance_of(distance).low - of_a - of_b;
    const double least = about > 0 && k % 4 != 0 ? about * random.uniform(0.9, 1.1) : 0.5;
    const bool is_closer = compare_distance(distance, least + of_a + of_b) == Sign::negative;
    const RoundBody a = RoundBody::rounded(core_a, of_a), b = RoundBody::rounded(core_b, of_b);
    const Verdict found = clearance_verdict(PlacedRound(a, pose_a), PlacedRound(b, pose_b), least);
    EXPECT_EQ(found, is_closer ? Verdict::meet : Verdict::apart) << k;
    yes += is_closer ? 1 : 0;
  }
  EXPECT_GT(yes, 60);
  EXPECT_LT(yes, 240);
}

}  // namespace
}  // namespace sunder::solid
