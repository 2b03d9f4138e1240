// The orientation predicates against integer arithmetic: the sign of each stage that is sure, and which stage decides.
#include <sunder/base/random.h>
#include <sunder/predicate/exact_image_test.h>
#include <sunder/predicate/filter/sharp_stage.h>
#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/point/orient.h>

#include <tests/support/exact.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace sunder {
namespace {

using tests::in_cube, tests::on_grid;

using tests::Exact;

// det(a - c, b - c) of the coordinates i, j; det(b - d, a - d, c - d): other forms than those of the library.
Sign true_turn(const ExactVector& a, const ExactVector& b, const ExactVector& c, std::size_t i, std::size_t j) {
  return sign_of((a[i] - c[i]) * (b[j] - c[j]) - (a[j] - c[j]) * (b[i] - c[i]));
}
Sign true_side(const ExactVector& a, const ExactVector& b, const ExactVector& c, const ExactVector& d) {
  std::array<std::array<Exact, 3>, 3> r{b, a, c};
  for (auto& row : r) {
    for (std::size_t i = 0; i < 3; ++i) row[i] = row[i] - d[i];
  }
  return sign_of(r[0][0] * (r[1][1] * r[2][2] - r[2][1] * r[1][2]) - r[1][0] * (r[0][1] * r[2][2] - r[2][1] * r[0][2]) +
                 r[2][0] * (r[0][1] * r[1][2] - r[1][1] * r[0][2]));
}

// What the stages said over many instances.
struct OrientRecord {
  int count = 0, zero = 0, rounded = 0, interval = 0, exact = 0;

  // is_sharp: does a stage in double-doubles come before exact numbers?
  template <bool is_sharp = false, class Formula, class Predicate, class... Points>
  void check(const Formula& formula, const Predicate& predicate, Sign expected, const Points&... points) {
    ++count;
    if (expected == Sign::zero) ++zero;
    const bool tame = (is_tame(points) && ...);
    const Guess first = tame ? sign(formula(lift<RoundedStage>(points)...)) : Guess::unsure;
    const Guess second = sign(formula(lift<IntervalStage>(points)...));
    if (is_sure(first)) {
      ASSERT_EQ(to_sign(first), expected) << "rounded";
    }
    if (is_sure(second)) {
      ASSERT_EQ(to_sign(second), expected) << "interval";
    }
    Guess third = Guess::unsure;
    if constexpr (is_sharp) third = sign(formula(lift<SharpImageStage>(points)...));
    if (is_sure(third)) {
      ASSERT_EQ(to_sign(third), expected) << "sharp";
    }
    ASSERT_EQ(formula(lift<ExactStage>(points)...).sign(), expected) << "exact";
    StageTally tally;
    ASSERT_EQ(predicate(points..., &tally), expected);
    ASSERT_EQ(tally.rounded, is_sure(first) ? 1u : 0u);
    ASSERT_EQ(tally.interval, !is_sure(first) && (is_sure(second) || is_sure(third)) ? 1u : 0u);
    ASSERT_EQ(tally.rounded + tally.interval + tally.exact, 1u);
    rounded += static_cast<int>(tally.rounded);
    interval += static_cast<int>(tally.interval);
    exact += static_cast<int>(tally.exact);
  }

  template <class P, class Q, class R, class S>
  void check_side(const P& a, const Q& b, const R& c, const S& d) {
    constexpr bool is_some_posed = std::is_same_v<P, Posed3> || std::is_same_v<R, Posed3>;
    check<is_some_posed>(
        orient_3d_formula, [](const auto&... p) { return orient_3d(p...); },
        true_side(image(a), image(b), image(c), image(d)), a, b, c, d);
  }
  template <class P>
  void check_turn(int axis, const P& a, const P& b, const P& c) {
    const auto predicate = [axis](const auto&... p) { return orient_2d_along(axis, p...); };
    const std::size_t i = static_cast<std::size_t>(axis + 1) % 3, j = static_cast<std::size_t>(axis + 2) % 3;
    const Sign expected = true_turn(image(a), image(b), image(c), i, j);
    if (axis == 0) check(orient_2d_formula<0>, predicate, expected, a, b, c);
    if (axis == 1) check(orient_2d_formula<1>, predicate, expected, a, b, c);
    if (axis == 2) check(orient_2d_formula<2>, predicate, expected, a, b, c);
  }
};

double nasty(Random& random) {
  constexpr std::array special{0.0,   1.0,     tests::least,   2 * tests::least, 0x1p-1022,   1e-300,  0x1p-332,
                               1e300, 0x1p511, tests::largest, 0x1p1023,         1 + 0x1p-52, 0x1p280, 0x1p-280};
  const double sign = random.below(2) ? 1 : -1;
  switch (random.below(3)) {
    case 0: return sign * special[random.below(special.size())];
    case 1: return sign * std::ldexp(1 + random.unit(), static_cast<int>(random.between(-1080, 1023)));
    default: return sign * static_cast<double>(random.below(5));
  }
}

Point3 operator*(double s, const Point3& p) { return {s * p.x, s * p.y, s * p.z}; }

enum Kind { generic, grid, near_tie, near_tie_by_units, extreme, kinds };

// Four points. Near ties: the last lies in the plane of the others, or on the line of two of them, but for rounding and
// an offset that is log-uniform or a few units in the last place.
std::array<Point3, 4> four_points(Random& random, Kind kind) {
  if (kind == extreme) {
    std::array<Point3, 4> p;
    for (Point3& q : p) {
      q = random.below(3) ? Point3{nasty(random), nasty(random), nasty(random)} : p[0];
      if (random.below(2)) q.z = p[0].z;
    }
    return p;
  }
  std::array<Point3, 4> p{in_cube(random), in_cube(random), in_cube(random), in_cube(random)};
  if (kind == grid) {
    const std::int64_t side = random.between(1, 6);
    for (Point3& q : p) q = on_grid(random, side);
  }
  if (kind == near_tie || kind == near_tie_by_units) {
    const auto& [a, b, c, d] = p;
    const double s = random.uniform(-1, 2), t = random.below(2) ? 0 : random.uniform(-1, 2);
    const double offset = kind == near_tie ? random.log_uniform(0x1p-70, 1) * (random.below(2) ? 1 : -1) : 0;
    p[3] = {a.x + s * (b.x - a.x) + t * (c.x - a.x) + offset, a.y + s * (b.y - a.y) + t * (c.y - a.y),
            a.z + s * (b.z - a.z) + t * (c.z - a.z)};
    if (kind == near_tie_by_units) p[3].z = tests::moved_by_bits(p[3].z, random.between(-3, 3));
    std::swap(p[3], p[random.below(4)]);
  }
  return p;
}

// Mostly well within the range of doubles; also where products underflow or overflow, at the ends of the tame range.
double any_scale(Random& random) {
  switch (random.below(6)) {
    case 0: return 1;
    case 1: return power_of_two(random.between(-1022, -200));
    case 2: return power_of_two(random.between(200, 1018));
    case 3: return power_of_two(random.between(-420, -260));
    case 4: return power_of_two(random.between(260, 350));
    default: return power_of_two(random.between(-100, 100));
  }
}

Affine3 any_pose(Random& random) {
  Affine3 pose;
  const bool whole = random.below(2) == 0;
  for (double& m : pose.linear) m = whole ? static_cast<double>(random.between(-3, 3)) : random.uniform(-1, 1);
  if (random.below(4) == 0) {  // a turn about an axis, perhaps reflected
    const double angle = random.uniform(-4, 4), flip = random.below(2) ? 1 : -1;
    pose.linear = {std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, flip};
  }
  const double far = random.below(3) ? power_of_two(random.between(-10, 60)) : 0;
  for (double& t : pose.translation) t = far * random.uniform(-1, 1);
  return pose;
}

TEST(OrientTest, KnownSigns) {
  const Point3 o, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(orient_2d(Point2{0, 0}, {1, 0}, Point2{0, 1}), Sign::positive);
  EXPECT_EQ(orient_2d(Point2{0, 0}, {0, 1}, Point2{1, 0}), Sign::negative);
  EXPECT_EQ(orient_2d(Point2{0, 0}, {1, 1}, Point2{3, 3}), Sign::zero);
  EXPECT_EQ(orient_3d(o, x, y, z), Sign::positive);  // o, x, y counter-clockwise as seen from z
  EXPECT_EQ(orient_3d(o, y, x, z), Sign::negative);
  EXPECT_EQ(orient_3d(o, x, y, Point3{3, -4, 0}), Sign::zero);
  EXPECT_EQ(orient_2d_along(0, o, y, z), Sign::positive);
  EXPECT_EQ(orient_2d_along(1, o, z, x), Sign::positive);
  EXPECT_EQ(orient_2d_along(2, o, x, y), Sign::positive);
  EXPECT_EQ(orient_2d_along(0, x, y, z), Sign::positive);
  EXPECT_EQ(orient_2d_along(2, o, x, z), Sign::zero);
  const Affine3 pose{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {5, 6, 7}};
  const Affine3 identity;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(compare_coordinate(axis, posed(o, identity), posed(o, pose)), Sign::positive);
    EXPECT_EQ(compare_coordinate(axis, posed(o, pose), posed(x, identity)), Sign::negative);
    EXPECT_EQ(compare_coordinate(axis, posed(Point3{5, 6, 7}, identity), posed(o, pose)), Sign::zero);
    EXPECT_EQ(compare_coordinate(axis, posed(o, identity),
                                 posed(axis == 0   ? x
                                       : axis == 1 ? y
                                                   : z,
                                       identity)),
              Sign::positive);
  }
}

// Of coordinates whose differences are doubles, small integers in any unit, ties are told without exact numbers.
TEST(OrientTest, SmallIntegersInThePlane) {
  Random random(tests::chosen_seed(9));
  const int n = tests::scaled_count(20000, 1000);
  int ties = 0;
  for (int i = 0; i < n; ++i) {
    const std::int64_t side = std::int64_t{1} << random.between(1, 50);
    const double unit = power_of_two(random.between(-200, 200));
    const auto whole = [&](std::int64_t most) { return static_cast<double>(random.between(-most, most)); };
    const Point2 a{whole(side), whole(side)}, step{whole(8), whole(8)};
    const double s = whole(side / 16), t = whole(side / 16), off = i % 2 == 0 ? 0 : whole(1);
    const auto at = [&](double k, double beside) {
      return Point2{unit * (a.x + k * step.x + beside), unit * (a.y + k * step.y)};
    };
    const Point2 p = at(0, 0), q = at(s, 0), r = at(t, off);
    const auto image_of = [](const Point2& point) { return image(Point3{point.x, point.y, 0}); };
    const Sign expected = true_turn(image_of(p), image_of(q), image_of(r), 0, 1);
    StageTally tally;
    ASSERT_EQ(orient_2d(p, q, r, &tally), expected) << i;
    ASSERT_EQ(tally.rounded, 1u) << i;
    ASSERT_EQ(tally.interval + tally.exact, 0u) << i;
    ties += expected == Sign::zero && p != q && q != r && p != r;
  }
  EXPECT_GT(ties, n / 8);
}

// Where differences are rounded, or products leave the range, the further stages decide.
TEST(OrientTest, FurtherStagesInThePlane) {
  const auto decided = [](const Point2& a, const Point2& b, const Point2& c) {
    StageTally tally;
    const Sign sign = orient_2d(a, b, c, &tally);
    return std::pair{sign, tally.rounded == 0};
  };
  EXPECT_EQ(decided({0x1p-60, 0}, {1, 1}, {3, 3}), (std::pair{Sign::negative, true}));
  EXPECT_EQ(decided({0, 0}, {0x1p-300, 0x1p-300}, {3 * 0x1p-300, 3 * 0x1p-300}), (std::pair{Sign::zero, true}));
  EXPECT_EQ(decided({0, 0}, {0x1p600, 0x1p600}, {0x1p601, 0x1p601}), (std::pair{Sign::zero, true}));
  EXPECT_EQ(decided({-tests::largest, -tests::largest}, {tests::largest, tests::largest}, {0, 0}),
            (std::pair{Sign::zero, true}));
}

TEST(OrientTest, EachStageOfPoints) {
  Random random(tests::chosen_seed(1));
  const int n = tests::scaled_count(60000, 1000);
  std::array<OrientRecord, kinds> side_of, turn_of;
  int untame = 0;
  for (int i = 0; i < n; ++i) {
    const Kind kind = static_cast<Kind>(i % kinds);
    const double scale = kind == extreme ? 1 : any_scale(random);
    std::array<Point3, 4> p = four_points(random, kind);
    for (Point3& q : p) q = scale * q;
    if (!is_tame(p[0])) ++untame;
    side_of[kind].check_side(p[0], p[1], p[2], p[3]);
    turn_of[kind].check_turn(static_cast<int>(random.below(3)), p[1], p[2], p[3]);
    const Point2 a{p[0].x, p[0].y}, b{p[1].x, p[1].y}, c{p[3].x, p[3].y};
    ASSERT_EQ(orient_2d(a, b, c), true_turn(image(p[0]), image(p[1]), image(p[3]), 0, 1)) << i;
    if (HasFatalFailure()) FAIL() << "instance " << i << ", kind " << kind << ", scale " << scale;
  }
  EXPECT_GT(untame, n / 4);
  for (const auto* of : {&side_of, &turn_of}) {
    EXPECT_GT((*of)[generic].interval, n / kinds / 8);
    EXPECT_EQ((*of)[generic].zero, 0);
    EXPECT_GT((*of)[grid].zero, n / kinds / 200);
    EXPECT_GT((*of)[grid].exact, n / kinds / 200);
    EXPECT_GT((*of)[extreme].zero, n / kinds / 100);
  }
  EXPECT_GT(side_of[near_tie].exact, n / kinds / 10);
  EXPECT_GT(side_of[near_tie_by_units].exact, n / kinds / 3);
}

// Points of the world among posed ones, and of three points whether they are on one line.
TEST(OrientTest, PointsOfBothKinds) {
  Random random(tests::chosen_seed(5));
  const int n = tests::scaled_count(20000, 1000);
  OrientRecord sides;
  int collinear = 0;
  for (int i = 0; i < n; ++i) {
    const Kind kind = static_cast<Kind>(i % kinds);
    const std::array<Point3, 4> p = four_points(random, kind);
    const Affine3 pose = i % 2 == 0 ? Affine3{} : any_pose(random);
    const Posed3 c = posed(p[2], pose), d = posed(p[3], pose);
    sides.check_side(p[0], p[1], c, d);
    sides.check_side(posed(p[0], pose), posed(p[1], pose), c, p[3]);
    if (HasFatalFailure()) FAIL() << "instance " << i << ", kind " << kind;
    for (const Posed3& at : {d, Posed3{p[0], &pose, false}}) {
      const ExactVector a = image(p[0]), b = image(p[1]), q = image(at);
      std::uint32_t zeros = 0;
      while (zeros < 3 && true_turn(a, b, q, (zeros + 1) % 3, (zeros + 2) % 3) == Sign::zero) ++zeros;
      StageTally tally;
      ASSERT_EQ(are_collinear(p[0], p[1], at, &tally), zeros == 3) << i;
      ASSERT_EQ(tally.rounded + tally.interval + tally.exact, std::min(zeros + 1, 3u)) << i;
      if (i % 2 == 0) {
        ASSERT_EQ(are_collinear(p[0], p[1], at.point), zeros == 3) << i;
      }
      collinear += zeros == 3;
    }
  }
  EXPECT_GT(sides.rounded, n / 4);
  EXPECT_GT(sides.zero, n / 100);
  EXPECT_GT(collinear, n / 4);
}

TEST(OrientTest, EachStageOfPosedPoints) {
  Random random(tests::chosen_seed(2));
  const int n = tests::scaled_count(30000, 1000);
  std::array<OrientRecord, kinds> side_of, turn_of;
  OrientRecord along_axis;
  int untame = 0, reflected = 0, far = 0;
  for (int i = 0; i < n; ++i) {
    const Kind kind = static_cast<Kind>(i % kinds);
    // The body's scale, the inverse in the pose, and one for both.
    const double inner = kind == extreme || random.below(2) ? 1 : power_of_two(random.between(-500, 500));
    const double outer = random.below(2) ? 1 : power_of_two(random.between(-450, 330));
    Affine3 first = any_pose(random), second = any_pose(random);
    if (random.below(2)) second = first;
    if (determinant_sign(first) == Sign::negative) ++reflected;
    if (std::fabs(first.translation[0]) > 0x1p30) ++far;
    for (Affine3* pose : {&first, &second}) {
      for (double& m : pose->linear) m *= outer / inner;
      for (double& t : pose->translation) t *= outer;
    }
    std::array<Point3, 4> p = four_points(random, kind);
    for (Point3& q : p) q = inner * q;
    const Posed3 a = posed(p[0], first), b = posed(p[1], second), c = posed(p[2], first), d = posed(p[3], second);
    if (!a.tame) ++untame;
    side_of[kind].check_side(a, b, c, d);
    const int axis = static_cast<int>(random.below(3));
    turn_of[kind].check_turn(axis, b, c, d);
    const std::size_t k = static_cast<std::size_t>(axis);
    along_axis.check(
        [&](const auto& s, const auto& t) {
          return axis == 0   ? difference_formula<0>(s, t)
                 : axis == 1 ? difference_formula<1>(s, t)
                             : difference_formula<2>(s, t);
        },
        [axis](const auto&... q) { return compare_coordinate(axis, q...); }, sign_of(image(d)[k] - image(b)[k]), b, d);
    if (HasFatalFailure()) FAIL() << "instance " << i << ", kind " << kind << ", scales " << inner << " " << outer;
  }
  EXPECT_GT(untame, n / 8);
  EXPECT_GT(reflected, n / 5);
  EXPECT_GT(far, n / 10);
  for (const auto* of : {&side_of, &turn_of}) {
    EXPECT_GT((*of)[generic].rounded, n / kinds / 4);
    EXPECT_GT((*of)[generic].interval, n / kinds / 20);
    EXPECT_GT((*of)[grid].zero, n / kinds / 200);
    EXPECT_GT((*of)[near_tie_by_units].exact, n / kinds / 30);
  }
  EXPECT_GT(along_axis.zero, 0);
}

TEST(OrientTest, GenericPointsAreDecidedInFloatingPoint) {
  Random random(tests::chosen_seed(3));
  const int n = tests::scaled_count(50000, 1000);
  OrientRecord sides, turns, posed_sides;
  const Affine3 pose{{0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1}, {3, -20, 0.125}};
  for (int i = 0; i < n; ++i) {
    const double scale = power_of_two(random.between(-90, 90));
    std::array<Point3, 4> p = four_points(random, generic);
    for (Point3& q : p) q = scale * q;
    sides.check_side(p[0], p[1], p[2], p[3]);
    turns.check_turn(static_cast<int>(random.below(3)), p[1], p[2], p[3]);
    if (i % 4 == 0) {
      for (Point3& q : p) q = (1 / scale) * q;
      posed_sides.check_side(posed(p[0], pose), posed(p[1], pose), posed(p[2], pose), posed(p[3], pose));
    }
    if (HasFatalFailure()) FAIL() << "instance " << i;
  }
  for (const OrientRecord* r : {&sides, &turns, &posed_sides}) EXPECT_GE(r->rounded, r->count - r->count / 1000);
}

// The filters are as good as their bounds: a distance of 2^-47 is seen in floating point, one of 2^-51 is not
// (but for lucky rounding).
TEST(OrientTest, DistanceThatFloatingPointSees) {
  Random random(tests::chosen_seed(4));
  const int n = tests::scaled_count(3000, 1000);
  OrientRecord near, nearer;
  for (int i = 0; i < n; ++i) {
    const Point3 a{1, 0, 0}, b{0, 1, 0}, c{0, 0, 1};
    const double s = random.uniform(0.25, 0.5), t = random.uniform(0.125, 0.25);
    const Point3 on_plane{s, t, (1 - s) - t};
    near.check_side(a, b, c, Point3{on_plane.x, on_plane.y, on_plane.z + random.uniform(0x1p-47, 0x1p-46)});
    nearer.check_side(a, b, c, Point3{on_plane.x, on_plane.y, on_plane.z + random.uniform(0x1p-51, 0x1p-50)});
    if (HasFatalFailure()) FAIL() << "instance " << i;
  }
  EXPECT_EQ(near.rounded, near.count);
  EXPECT_LE(nearer.rounded, nearer.count / 100);
  EXPECT_EQ(nearer.zero, 0);
}

enum class DecidingStage { rounded, interval, exact };

TEST(OrientTest, StageThatDecides) {
  const auto decided = [](const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    StageTally t;
    const Sign sign = orient_3d(a, b, c, d, &t);
    return std::pair{sign, t.rounded    ? DecidingStage::rounded
                           : t.interval ? DecidingStage::interval
                                        : DecidingStage::exact};
  };
  using enum Sign;
  // Coplanar: exact, but where every term is zero.
  EXPECT_EQ(decided({1, 2, 3}, {4, 5, 7}, {7, 8, 12}, {2, 9, 4}), (std::pair{negative, DecidingStage::rounded}));
  EXPECT_EQ(decided({0, 0, 6}, {6, 0, 0}, {0, 6, 0}, {2, 2, 2}), (std::pair{zero, DecidingStage::exact}));
  EXPECT_EQ(decided({0, 0, 5}, {6, 0, 5}, {0, 6, 5}, {2, 2, 5}), (std::pair{zero, DecidingStage::rounded}));
  EXPECT_EQ(decided({1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {2, 9, 4}), (std::pair{zero, DecidingStage::rounded}));
  // Not tame: intervals, also for a zero without rounding. Products that overflow or underflow: exact.
  for (const double s : {0x1p-290, 0x1p290}) {
    EXPECT_EQ(decided({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}), (std::pair{positive, DecidingStage::interval}));
    EXPECT_EQ(decided({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {s, s, 0}), (std::pair{zero, DecidingStage::interval}));
  }
  for (const double s : {1e-300, tests::least}) {
    EXPECT_EQ(decided({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}), (std::pair{positive, DecidingStage::exact}));
    EXPECT_EQ(decided({s, s, s}, {s, 0, 0}, {0, s, 0}, {0, 0, s}), (std::pair{negative, DecidingStage::exact}));
  }
  for (const double s : {1e300, tests::largest}) {
    EXPECT_EQ(decided({-s, s, s}, {s, -s, s}, {s, s, -s}, {s, s, s}), (std::pair{positive, DecidingStage::exact}));
    EXPECT_EQ(decided({-s, -s, -s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}).first, positive);
    EXPECT_EQ(decided({-s, s, 0}, {s, -s, 0}, {s, s, 0}, {-s, -s, 0}).first, zero);
  }
  EXPECT_EQ(decided({0, 0, 0}, {1e300, 0, 0}, {0, 1e-300, 0}, {0, 0, tests::least}).first, positive);
  EXPECT_EQ(decided({0, 0, tests::least}, {1e300, 0, 0}, {0, 1e300, 0}, {0, 0, 0}).first, negative);
}

// Images that are translations alone, down to where their products vanish.
TEST(OrientTest, ImagesThatAreTranslations) {
  Random random(tests::chosen_seed(8));
  const int n = tests::scaled_count(3000, 1000);
  OrientRecord sides;
  for (int i = 0; i < n; ++i) {
    const double scale = power_of_two(random.between(-1074, 1020));
    std::array<Affine3, 4> poses;
    for (Affine3& pose : poses) {
      const Point3 t = scale * on_grid(random, 3);
      pose.translation = {t.x, t.y, t.z};
    }
    const auto at = [&](std::size_t j) { return posed(Point3{}, poses[j]); };
    sides.check_side(at(0), at(1), at(2), at(3));
    if (HasFatalFailure()) FAIL() << "instance " << i << ", scale " << scale;
  }
  EXPECT_LT(sides.zero, n / 2);
  EXPECT_GT(sides.rounded, n / 20);
  EXPECT_GT(sides.interval, n / 20);
  EXPECT_GT(sides.exact, n / 20);
}

TEST(OrientTest, ExchangingPointsFlipsTheSign) {
  Random random(tests::chosen_seed(5));
  const int n = tests::scaled_count(4000, 1000);
  int zero = 0;
  for (int i = 0; i < n; ++i) {
    std::array<Point3, 4> p = four_points(random, static_cast<Kind>(i % kinds));
    const Sign s = orient_3d(p[0], p[1], p[2], p[3]);
    const Sign t = orient_2d_along(i % 3, p[0], p[1], p[2]);
    if (s == Sign::zero) ++zero;
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    do {
      int exchanges = 0;
      for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t k = 0; k < j; ++k) exchanges += order[k] > order[j] ? 1 : 0;
      }
      ASSERT_EQ(orient_3d(p[order[0]], p[order[1]], p[order[2]], p[order[3]]), exchanges % 2 ? -s : s) << i;
      if (order[3] == 3) {
        ASSERT_EQ(orient_2d_along(i % 3, p[order[0]], p[order[1]], p[order[2]]), exchanges % 2 ? -t : t) << i;
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
  EXPECT_GT(zero, n / 200);
  EXPECT_LT(zero, n / 2);
}

TEST(OrientTest, ScalingAndExactShiftsKeepTheSign) {
  Random random(tests::chosen_seed(6));
  const int n = tests::scaled_count(4000, 1000);
  int zero = 0;
  for (int i = 0; i < n; ++i) {
    std::array<Point3, 4> p;
    for (Point3& q : p) q = on_grid(random, 1 + i % 20);
    const Sign s = orient_3d(p[0], p[1], p[2], p[3]);
    if (s == Sign::zero) ++zero;
    const double scale = power_of_two(random.between(-1074, 1018));
    ASSERT_EQ(orient_3d(scale * p[0], scale * p[1], scale * p[2], scale * p[3]), s) << i << " " << scale;
    const Point3 by = on_grid(random, std::int64_t{1} << random.between(0, 52));
    for (Point3& q : p) q = {q.x + by.x, q.y + by.y, q.z + by.z};
    ASSERT_EQ(orient_3d(p[0], p[1], p[2], p[3]), s) << i;
  }
  EXPECT_GT(zero, n / 200);
  EXPECT_LT(zero, n / 2);
}

TEST(OrientTest, OnePoseMultipliesByItsDeterminant) {
  Random random(tests::chosen_seed(7));
  const int n = tests::scaled_count(4000, 1000);
  int negative = 0, singular = 0, far = 0;
  for (int i = 0; i < n; ++i) {
    Affine3 pose = any_pose(random);
    const bool is_far = i % 3 == 0;
    if (is_far) {
      for (double& t : pose.translation) t = power_of_two(random.between(100, 1023)) * random.uniform(-1, 1);
      ++far;
    }
    const Sign d = determinant_sign(pose);
    if (d == Sign::negative) ++negative;
    if (d == Sign::zero) ++singular;
    const std::array<Point3, 4> p = four_points(random, static_cast<Kind>(i % kinds));
    const auto at = [&](const Point3& q) { return posed(q, pose); };
    StageTally tally;
    ASSERT_EQ(orient_3d(at(p[0]), at(p[1]), at(p[2]), at(p[3]), &tally), d * orient_3d(p[0], p[1], p[2], p[3])) << i;
    if (is_far && tally.rounded == 1) {
      ASSERT_EQ(static_cast<int>(d) * static_cast<int>(orient_3d(p[0], p[1], p[2], p[3])), 0) << i;
    }
  }
  EXPECT_GT(negative, n / 5);
  EXPECT_GT(singular, n / 100);
  EXPECT_GT(far, n / 4);
}

// The four signs at once: where it says something, that is so; it speaks for generic points, and is silent where some
// three points are on one line.
TEST(OrientTest, SurelyCross) {
  Random random(tests::chosen_seed(9));
  const int n = tests::scaled_count(30000, 1000);
  std::array<int, 4> cross{}, apart{}, unsure{}, on_line{};
  for (int i = 0; i < n; ++i) {
    const std::size_t kind = static_cast<std::size_t>(i % 4);
    const double scale = power_of_two(random.between(-1070, 1020));
    const auto number = [&] {
      switch (kind) {
        case 0: return random.uniform(-1, 1);
        case 1: return nasty(random);
        case 2: return scale * static_cast<double>(random.between(-3, 3));
        default: return 0.5 + static_cast<double>(random.between(0, 4)) * 0x1p-53;
      }
    };
    std::array<Point2, 4> p;
    for (Point2& q : p) q = {number(), number()};
    if (kind == 0 && i % 8 == 4) {  // ends on the other one, but for rounding
      const double t = random.unit();
      p[3] = {p[0].x + t * (p[1].x - p[0].x), p[0].y + t * (p[1].y - p[0].y)};
    }
    const auto of = [&](std::size_t a, std::size_t b, std::size_t c) {
      const auto in_space = [](const Point2& q) { return image(Point3{q.x, q.y, 0}); };
      return true_turn(in_space(p[a]), in_space(p[b]), in_space(p[c]), 0, 1);
    };
    const Sign c = of(0, 1, 2), d = of(0, 1, 3), a = of(2, 3, 0), b = of(2, 3, 1);
    const bool none_zero = c != Sign::zero && d != Sign::zero && a != Sign::zero && b != Sign::zero;
    const bool crossing = none_zero && c != d && a != b;
    const Guess guess = surely_cross_2d(p[0], p[1], p[2], p[3]);
    ASSERT_NE(guess, Guess::zero);
    if (is_sure(guess)) {
      ASSERT_TRUE(none_zero) << i;
      ASSERT_EQ(guess == Guess::positive, crossing) << i;
    }
    ++(guess == Guess::positive ? cross : guess == Guess::negative ? apart : unsure)[kind];
    on_line[kind] += !none_zero;
  }
  EXPECT_GT(cross[0], n / 40);
  EXPECT_GT(apart[0], n / 20);
  EXPECT_LT(unsure[0], n / 8 + n / 100);  // those made to touch
  EXPECT_GT(unsure[0], n / 16);
  EXPECT_GT(unsure[1], n / 50);
  for (const std::size_t kind : {1u, 2u, 3u}) EXPECT_GT(cross[kind] + apart[kind], n / 100) << kind;
  EXPECT_GT(on_line[2], n / 20);
  EXPECT_GT(on_line[3], n / 20);
}

TEST(OrientTest, SurelyCrossAtTheEndsOfTheRange) {
  const auto plus = [](double s) { return surely_cross_2d({-s, 0}, {s, 0}, {0, -s}, {0, s}); };
  const auto side_by_side = [](double s) { return surely_cross_2d({-s, 0}, {s, 0}, {-s, s}, {s, s}); };
  for (const double s : {0x1p-500, 1.0, 0x1p500}) {
    EXPECT_EQ(plus(s), Guess::positive) << s;
    EXPECT_EQ(side_by_side(s), Guess::negative) << s;
  }
  // Products that vanish, differences and products that overflow.
  for (const double s : {tests::least, 0x1p-1022, 0x1p-540, 0x1p-531, 0x1p512, 0x1p1023, tests::largest}) {
    EXPECT_EQ(plus(s), Guess::unsure) << s;
    EXPECT_EQ(side_by_side(s), Guess::unsure) << s;
  }
  EXPECT_EQ(surely_cross_2d({0, 0}, {0, 0}, {1, 1}, {2, 0}), Guess::unsure);
  // A product that vanishes next to one that does not.
  EXPECT_EQ(surely_cross_2d({0, 0}, {1, tests::least}, {0.5, 0}, {0.5, 1}), Guess::unsure);
  EXPECT_EQ(surely_cross_2d({0, 0}, {1, tests::least}, {0.5, -1}, {0.5, 1}), Guess::positive);
}

TEST(OrientTest, Determinant) {
  EXPECT_EQ(determinant_sign(Affine3{}), Sign::positive);
  EXPECT_EQ(determinant_sign({{0, 1, 0, 1, 0, 0, 0, 0, 1}, {}}), Sign::negative);
  EXPECT_EQ(determinant_sign({{0, 1, 0, 0, 0, 1, 1, 0, 0}, {}}), Sign::positive);
  EXPECT_EQ(determinant_sign({{1, 2, 3, 4, 5, 6, 7, 8, 9}, {}}), Sign::zero);
  EXPECT_EQ(determinant_sign({{1, 2, 3, 4, 5, 6, 7, 8, 9 + 0x1p-49}, {}}), Sign::negative);
  EXPECT_EQ(determinant_sign({{tests::least, 0, 0, 0, tests::least, 0, 0, 0, -tests::least}, {}}), Sign::negative);
  EXPECT_EQ(determinant_sign({{1e300, 0, 0, 0, 1e300, 0, 0, 0, 1e300}, {}}), Sign::positive);
  EXPECT_EQ(determinant_sign({{1e300, 1e300, 0, 1e300, 1e300, 0, 0, 0, 1e300}, {}}), Sign::zero);
}

}  // namespace
}  // namespace sunder
