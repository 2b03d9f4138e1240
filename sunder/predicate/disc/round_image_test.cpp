#include <sunder/base/random.h>
#include <sunder/predicate/disc/round_image.h>
#include <sunder/predicate/disc/round_shape.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace sunder {
namespace {

constexpr RoundKind round_kinds[] = {RoundKind::hull, RoundKind::cylinder, RoundKind::cone, RoundKind::ellipsoid};

// A body of a random kind in a random place.
struct Body {
  RoundKind kind;
  Affine3 pose;
  std::array<Point3, 2> points{};
  std::uint32_t ends = 1;
  double radius;

  explicit Body(Random& random, RoundKind of) : kind(of), radius(random.log_uniform(0.1, 1)) {
    const auto part = [&] { return random.uniform(-1, 1); };
    double w = part(), x = part(), y = part(), z = part();
    const double n = std::sqrt(w * w + x * x + y * y + z * z);
    w /= n, x /= n, y /= n, z /= n;
    pose.linear = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                   2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                   2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    pose.translation = {part(), part(), part()};
    if (kind == RoundKind::ellipsoid) {
      const std::array<double, 3> axes{random.log_uniform(0.1, 1), random.log_uniform(0.1, 1),
                                       random.log_uniform(0.1, 1)};
      for (std::size_t k = 0; k < 9; ++k) pose.linear[k] *= axes[k % 3];
    } else {
      points = {Point3{part(), part(), part()}, Point3{part(), part(), part()}};
    }
    ends = kind == RoundKind::cylinder || kind == RoundKind::cone ? 2 : 1;
  }
  RoundShape shape() const { return {kind, points, &pose, radius}; }
  RoundImage image() const {
    RoundImage made;
    double linear = 0, coordinate = 0, translation = 0;
    for (const double m : pose.linear) linear = std::max(linear, std::fabs(m));
    for (const double t : pose.translation) translation = std::max(translation, std::fabs(t));
    for (const Point3& p : points) coordinate = std::max({coordinate, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    set_image(made, kind, pose, points.data(), ends, radius, std::max(linear * coordinate, translation), linear);
    return made;
  }
};

Guess as_guess(Sign sign) {
  return sign == Sign::zero ? Guess::zero : sign == Sign::positive ? Guess::positive : Guess::negative;
}

struct GuessCount {
  int sure = 0, unsure = 0;
  void see(Guess guess, Sign exact) {
    ++(is_sure(guess) ? sure : unsure);
    if (is_sure(guess)) {
      EXPECT_EQ(guess, as_guess(exact));
    }
  }
};

// Of pairs at random, and of those that are moved to where the sign changes, then by some last bits.
TEST(RoundImage, NoSureGapIsWrong) {
  Random random(20261201);
  for (const RoundKind kind_a : round_kinds) {
    for (const RoundKind kind_b : round_kinds) {
      GuessCount far, near;
      for (int i = 0; i < tests::scaled_count(60, 12); ++i) {
        const Body a(random, kind_a);
        Body b(random, kind_b);
        Point3 d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        ASSERT_TRUE(make_tame(d));
        const Vector3<double> v{d.x, d.y, d.z};
        const auto see = [&](GuessCount& count) {
          count.see(gap_guess(v, a.image(), b.image()), gap_sign(WorldDirection(d), a.shape(), b.shape()));
        };
        see(far);
        for (int step = 0; step < 3; ++step) {  // by what doubles make of the gap
          const double gap = -reach_along(b.image(), {-d.x, -d.y, -d.z}) - reach_along(a.image(), v);
          for (std::size_t k = 0; k < 3; ++k) b.pose.translation[k] -= gap / dot(v, v) * d[k];
        }
        for (int bits = -20; bits <= 20; ++bits) {
          const double from = b.pose.translation[0];
          b.pose.translation[0] += bits * 0x1p-53;
          see(near);
          b.pose.translation[0] = from;
        }
      }
      EXPECT_EQ(far.unsure, 0);
      EXPECT_GT(near.unsure, near.sure);  // it is as near as that
    }
  }
}

// Six doubles of a box instead of its corners: to the last bit.
TEST(RoundImage, BoxesReachAsFarAsTheirCorners) {
  Random random(20261203);
  for (int i = 0; i < 1000; ++i) {
    const Body body(random, RoundKind::hull);
    const auto part = [&] { return random.uniform(-1, 1); };
    const std::array<Point3, 2> range{Point3{part() - 1, part() - 1, part() - 1},
                                      Point3{part() + 1, part() + 1, part() + 1}};
    std::array<double, 24> corners{};
    for (std::size_t k = 0; k < 8; ++k) {
      corners[k] = range[k & 1].x;
      corners[8 + k] = range[k >> 1 & 1].y;
      corners[16 + k] = range[k >> 2].z;
    }
    RoundImage of_range, of_corners;
    set_image(of_range, body.pose, range.data(), body.radius, 3, 1);
    set_image(of_corners, body.pose, corners.data(), 8, body.radius, 3, 1);
    const Vector3<double> d{part(), part(), part()};
    EXPECT_EQ(reach_along(of_range, d), reach_along(of_corners, d));
    EXPECT_EQ(of_range.is_tame, of_corners.is_tame);
    EXPECT_EQ(of_range.size, of_corners.size);
  }
}

TEST(RoundImage, NoSureSideIsWrong) {
  Random random(20261202);
  for (const RoundKind kind : {RoundKind::cylinder, RoundKind::cone, RoundKind::ellipsoid}) {
    GuessCount far, near;
    int held = 0;
    for (int i = 0; i < 200; ++i) {
      const Body body(random, kind);
      const RoundImage image = body.image();
      const Affine3 in_place{};
      const auto see = [&](GuessCount& count, const Point3& x) {
        const Sign exact = side_of(body.shape(), {1, {Posed3{x, &in_place, false}}, {1}});
        count.see(side_guess(image, {x.x, x.y, x.z}), exact);
        return exact;
      };
      // From the middle outwards, until it is no longer in the body.
      const double by = kind == RoundKind::ellipsoid ? 0
                        : kind == RoundKind::cone    ? 0.25 * image.length
                                                     : 0.5 * image.length;
      const Vector3<double> axis = by > 0 ? image.axis : Vector3<double>{0, 0, 0};
      const Point3 middle{image.from.x + by * axis.x, image.from.y + by * axis.y, image.from.z + by * axis.z};
      const Point3 way{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)};
      const auto at = [&](double t) {
        return Point3{middle.x + t * way.x, middle.y + t * way.y, middle.z + t * way.z};
      };
      held += see(far, middle) == Sign::positive ? 1 : 0;
      see(far, at(random.uniform(0, 1)));
      double low = 0, high = 64;
      while (high - low > 0x1p-51) {
        const double t = 0.5 * (low + high);
        if (t == low || t == high) break;
        (see(near, at(t)) == Sign::positive ? low : high) = t;
      }
    }
    EXPECT_EQ(held, 200);
    EXPECT_LE(far.unsure, 1);
    EXPECT_GT(near.unsure, 200);
  }
}

TEST(RoundImage, NoSureNearnessIsWrong) {
  Random random(20261203);
  GuessCount near;
  int parted = 0;
  for (int i = 0; i < 2000; ++i) {
    const Body a(random, RoundKind::hull), b(random, RoundKind::hull);
    const RoundImage of_a = a.image(), of_b = b.image();
    const WeightedPoint p{1, {Posed3{a.points[0], &a.pose, false}}, {1}},
        q{1, {Posed3{b.points[0], &b.pose, false}}, {1}};
    const Vector3<double> way = of_b.from - of_a.from;
    const double reach = std::sqrt(dot(way, way)) + random.uniform(-16, 16) * 0x1p-50;
    near.see(nearness_guess(of_a.from, of_b.from, reach, of_a.size + of_b.size), nearness(p, reach, q, 0));
    near.see(nearness_guess(of_a.from, of_b.from, 2 * reach, of_a.size + of_b.size), nearness(p, 2 * reach, q, 0));
    // Further apart: the way between them is a direction that parts what is around them.
    const double less = reach * (1 - random.log_uniform(0x1p-45, 0x1p-40));
    if (nearness_guess(of_a.from, of_b.from, less, of_a.size + of_b.size) != Guess::negative) continue;
    ++parted;
    Point3 d{way.x, way.y, way.z};
    ASSERT_TRUE(make_tame(d));
    RoundShape around_a = a.shape(), around_b = b.shape();
    around_a.radius = less;
    around_b.radius = 0;
    EXPECT_EQ(gap_sign(WorldDirection(d), around_a, around_b), Sign::positive);
  }
  EXPECT_GE(near.sure, 2000);
  EXPECT_GT(parted, 500);
  EXPECT_GT(near.unsure, 1000);
}

// Sizes at which doubles overflow or vanish: nothing is told.
TEST(RoundImage, ExtremeSizes) {
  Random random(20261204);
  for (const double scale : {0x1p-400, 0x1p400}) {
    for (const RoundKind kind : round_kinds) {
      Body body(random, kind);
      body.radius *= scale;
      for (double& t : body.pose.translation) t *= scale;
      for (Point3& p : body.points) p = {p.x * scale, p.y * scale, p.z * scale};
      if (kind == RoundKind::ellipsoid) {
        for (double& m : body.pose.linear) m *= scale;
      }
      EXPECT_FALSE(body.image().is_tame);
      EXPECT_EQ(gap_guess({1, 0, 0}, body.image(), body.image()), Guess::unsure);
      if (kind != RoundKind::hull) {
        EXPECT_EQ(side_guess(body.image(), {0, 0, 0}), Guess::unsure);
      }
    }
  }
}

}  // namespace
}  // namespace sunder
