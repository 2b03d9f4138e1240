// The walk between two spaces where it went wrong once, and what it promises beside the verdict.
#include <sunder/base/random.h>
#include <sunder/solid/descent/polar_round.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

namespace sunder::solid {
namespace {

ConvexPolyhedron centred_box(const Point3& half) {
  std::vector<Point3> points;
  for (int k = 0; k < 8; ++k) {
    points.push_back({k & 1 ? half.x : -half.x, k & 2 ? half.y : -half.y, k & 4 ? half.z : -half.z});
  }
  return ConvexPolyhedron(points);
}

Pose turned(Random& random) {
  std::array<double, 4> q;
  for (double& x : q) x = random.uniform(-1, 1);
  return Pose::from_quaternion(q[0], q[1], q[2], q[3],
                               {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
}

// Of a point common to both, several weights vanish at once: which of them did is not for rounding to say.
TEST(PolyhedronPolyhedronByPolar, ABoxAndItselfNeedNoFinishing) {
  Random random(tests::chosen_seed(201));
  for (int i = 0; i < tests::scaled_count(1000); ++i) {
    const ConvexPolyhedron body = centred_box({random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)});
    const Pose pose = turned(random);
    const PairAnswer answer = polyhedron_polyhedron_by_polar(body, pose, body, pose);
    ASSERT_TRUE(answer.meet());
    ASSERT_NE(answer.decided_by, DecidedBy::finishing) << i;
  }
}

// This pair was seen never to end: of one, the hierarchy of the polar was made of a body with coordinates underflown.
TEST(PolyhedronPolyhedronByPolar, CoordinatesOfVeryDifferentSizes) {
  const ConvexPolyhedron a(std::vector<Point3>{{0, -0x1.d7280577fbc7cp+179, -0x1.10aba5f43d48p-181},
                                               {-0x1.26ba525c3a48p-2, -0x1.6c6cd49f1a7f4p+178, 0x1.a22114e82010cp-181},
                                               {-0x1.35cf01107e09p-184, -0x1.3ed736ce1736p-4, -0x1.eedd0d3d523a8p-2},
                                               {0, 0x1.7da6a5bc6819ep+179, 0},
                                               {0x1.a09ace2bf440cp-2, -0x1.e9608c58b9704p-182, -0x1.aefbaace97b06p-1},
                                               {0, -0x1.bec614bc647bcp+179, 0x1.c9a316f4debd8p+177}});
  const ConvexPolyhedron b(
      std::vector<Point3>{{-0x1.d8bdd68b5ebp+756, 0x1.c4c041811ff3p-3, 0},
                          {-0x1.2321f3fe11908p-762, -0x1.501402898f3eap-1, 0x1.9d87cec6f883p-761},
                          {0, 0, 0},
                          {-0x1.7e3e845adba6p-2, 0x1.f09619a1a74p-766, 0},
                          {0x1.6f5108c4d1f16p+758, 0, -0x1.46efc3838bp-768},
                          {-0x1.59a0c9b421a4cp+757, -0x1.a2639156fc54p+753, 0x1.35224648dc714p+757}});
  const bool meet = polyhedron_polyhedron_by_scan(a, Pose(), b, Pose()).meet();
  EXPECT_EQ(polyhedron_polyhedron_by_polar(a, Pose(), b, Pose()).meet(), meet);
  EXPECT_EQ(polyhedron_polyhedron_by_polar(b, Pose(), a, Pose()).meet(), meet);
}

// Beside a body that is much smaller, the polar is the larger one's, in whatever order they are given.
TEST(PolyhedronPolyhedronByPolar, BodiesOfVeryDifferentSizesNeedNoFinishing) {
  Random random(tests::chosen_seed(202));
  int meets = 0;
  const int count = tests::scaled_count(1000);
  for (int i = 0; i < count; ++i) {
    // The small one lies at a vertex of the large one, which is the world's origin.
    const double size = random.log_uniform(1e-18, 1e-3);
    std::vector<Point3> points = tests::points_on_sphere(20, random);
    const Point3 at = points[0];
    for (Point3& p : points) p = {p.x - at.x, p.y - at.y, p.z - at.z};
    const ConvexPolyhedron large(points), small(tests::points_on_sphere(20, random));
    Affine3 there = turned(random).affine();
    for (double& x : there.linear) x *= size;
    for (double& x : there.translation) x *= size;
    const Pose pose = Pose::from_matrix(there.linear, there.translation);
    const PairAnswer one = polyhedron_polyhedron_by_polar(large, Pose(), small, pose),
                     other = polyhedron_polyhedron_by_polar(small, pose, large, Pose());
    ASSERT_EQ(one.meet(), other.meet());
    ASSERT_NE(one.decided_by, DecidedBy::finishing) << i;
    ASSERT_NE(other.decided_by, DecidedBy::finishing) << i;
    meets += one.meet();
  }
  EXPECT_GT(meets, count / 10);
  EXPECT_LT(meets, count - count / 10);
}

// Four to 48 points of the lattice in two neighbouring planes of it, a x + b y + c z = 0 or 1 with a, b, c up to n:
// about as long as n^2, and as thin as 1 / n, along no axis.
ConvexPolyhedron lattice_plate(std::int64_t n, Random& random) {
  while (true) {
    const std::int64_t a = random.between(1, n), b = random.between(1, n), c = random.between(1, n);
    // s a + t b = 1, by Euclid's algorithm.
    std::int64_t s = 1, t = 0, next_s = 0, next_t = 1, r = a, next_r = b;
    while (next_r != 0) {
      const std::int64_t q = r / next_r;
      r = std::exchange(next_r, r - q * next_r);
      s = std::exchange(next_s, s - q * next_s);
      t = std::exchange(next_t, t - q * next_t);
    }
    if (r != 1) continue;
    std::vector<Point3> points;
    for (std::int64_t k = random.between(8, 48); k > 0; --k) {
      const Point2 at = tests::on_circle(random.unit(), static_cast<double>(n));
      const std::int64_t i = std::llround(at.x), j = std::llround(at.y), side = random.between(0, 1);
      points.push_back({static_cast<double>(i * b + side * s), static_cast<double>(j * c - i * a + side * t),
                        static_cast<double>(-j * b)});
    }
    const ConvexPolyhedron body(points);
    if (body.dimension() == 3) return body;
  }
}

// Thin as 2^-18, as 2^-45, and as 2^-60, which is more than double-doubles see two of at once.
TEST(PolyhedronPolyhedronByPolar, PlatesOfLattices) {
  Random random(tests::chosen_seed(204));
  const int count = tests::scaled_count(300);
  for (const int bits : {6, 15, 20}) {
    int finished = 0, finished_by_hierarchy = 0, meets = 0;
    for (int i = 0; i < count; ++i) {
      const std::int64_t n = std::int64_t{1} << bits;
      const ConvexPolyhedron a = lattice_plate(n, random), b = lattice_plate(n, random);
      const Point3 d = tests::on_sphere(random);
      const auto placed = [&](const Pose& turn, double distance) {
        std::array<double, 9> m = turn.affine().linear;
        for (double& x : m) x = std::ldexp(x, -2 * bits);
        return Pose::from_matrix(m, {d.x * distance, d.y * distance, d.z * distance});
      };
      const Pose turn = turned(random), other = random.below(2) == 0 ? turn : turned(random), here = placed(turn, 0);
      double meeting = 0, parted = 8;
      for (int k = 0; k < 54; ++k) {
        const double middle = (meeting + parted) / 2;
        (polyhedron_polyhedron(a, here, b, placed(other, middle)).meet() ? meeting : parted) = middle;
      }
      const double gap = random.log_uniform(0x1p-53, 0.1) * (random.below(2) == 0 ? 1 : -1);
      const Pose there = placed(other, meeting + gap);
      const PairAnswer answer = polyhedron_polyhedron_by_polar(a, here, b, there),
                       by_hierarchy = polyhedron_polyhedron_by_hierarchy(a, here, b, there);
      ASSERT_EQ(answer.meet(), by_hierarchy.meet()) << bits << ' ' << i;
      finished += answer.decided_by == DecidedBy::finishing;
      finished_by_hierarchy += by_hierarchy.decided_by == DecidedBy::finishing;
      meets += answer.meet();
    }
    std::printf("thin as 2^-%d: of %d, %d meet; finished %d, by hierarchy %d\n", 3 * bits, count, meets, finished,
                finished_by_hierarchy);
    if (count < 100) continue;  // too few for the rates below
    EXPECT_GT(meets, count / 5) << bits;
    EXPECT_LT(meets, count - count / 5) << bits;
    EXPECT_LE(finished, bits < 15 ? count / 100 : bits < 20 ? count / 15 : count / 4) << bits;
    EXPECT_LE(finished_by_hierarchy, count / 100) << bits;
  }
}

// A plane and a point are kept while they hold: far apart or deep inside, what is known at the top tells all, mostly.
// (Were each vertex beyond the last one a round, there would be 2.6 of them on average.)
TEST(PolyhedronPolyhedronByPolar, FarApartAndDeepInsideThereAreHardlyAnyRounds) {
  Random random(tests::chosen_seed(203));
  const int count = tests::scaled_count(200, 20);
  for (const double distance : {0.0, 20.0}) {
    std::size_t rounds = 0;
    for (int i = 0; i < count; ++i) {
      const ConvexPolyhedron a(tests::points_on_sphere(500, random)), b(tests::points_on_sphere(500, random));
      const Point3 d = tests::on_sphere(random);
      const Pose there =
          Pose::from_matrix(turned(random).affine().linear, {d.x * distance, d.y * distance, d.z * distance});
      const PolarRun run = polyhedron_polyhedron_polar_run(a, Pose(), b, there);
      ASSERT_FALSE(run.rounds.empty());
      ASSERT_EQ(run.rounds.back().is_apart, distance > 0);
      rounds += run.rounds.size() - 1;
    }
    EXPECT_LE(rounds, static_cast<std::size_t>(count) / 2) << distance;
  }
}

}  // namespace
}  // namespace sunder::solid
