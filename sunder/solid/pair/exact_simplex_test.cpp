// The exact finishing on all pairs, not only on those where a search fails: against the scan, from no hint, from the
// right one and from wrong ones; and the kinds of contact against bodies shrunk a little.
#include <sunder/base/random.h>
#include <sunder/certificate/check.h>
#include <sunder/solid/exact/exact_simplex.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/search/placed_check_test.h>
#include <tests/support/solid_pairs.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <vector>

namespace sunder::solid {
namespace {

using tests::Family;
using tests::PairCase;
using tests::SolidPairs;

DifferenceSimplex hint_of(const std::vector<std::array<std::uint32_t, 2>>& vertices) {
  DifferenceSimplex hint;
  for (const auto& [v, w] : vertices) {
    hint.vertex[static_cast<std::size_t>(hint.count)].a = v;
    hint.vertex[static_cast<std::size_t>(hint.count)].b = w;
    ++hint.count;
  }
  return hint;
}

TEST(ExactSimplexTest, DecidesAllPairsLikeTheScan) {
  const int count = tests::scaled_count(2000, 100);
  SolidPairs pairs(tests::chosen_seed(79));
  std::map<Family, std::array<int, 2>> verdicts;
  for (int i = 0; i < count; ++i) {
    const PairCase c = pairs.next();
    const Placed a(c.a, c.pose_a), b(c.b, c.pose_b);
    const bool meet = polyhedron_polyhedron_by_scan(c.a, c.pose_a, c.b, c.pose_b).meet();
    ++verdicts[c.family][meet];
    const auto some_vertex = [&](const Placed& p) {
      return static_cast<std::uint32_t>(pairs.random().below(p.graph.vertices.size()));
    };
    std::vector<std::array<std::uint32_t, 2>> wrong;
    for (std::uint64_t k = pairs.random().below(4); k > 0; --k) wrong.push_back({some_vertex(a), some_vertex(b)});
    wrong.push_back({some_vertex(a), some_vertex(b)});
    if (i % 3 == 0) wrong.push_back(wrong[0]);
    if (wrong.size() > 4) wrong.pop_back();
    for (const DifferenceSimplex& hint : {DifferenceSimplex(), hint_of(wrong)}) {
      Cost cost;
      StageTally tally;
      const PairCertificate answer = decide_by_exact_simplex(a, b, hint, cost, tally);
      ASSERT_EQ(verdict_of(answer) == Verdict::meet, meet) << i << " " << name_of(c.family) << " hint " << hint.count;
      ASSERT_EQ(check_placed(answer, a, b), CheckResult::accepted)
          << i << " " << name_of(c.family) << " hint " << hint.count;
    }
  }
  if (count < 1000) return;  // a smaller run may miss a verdict
  for (const auto& [family, counts] : verdicts) {
    if (family == Family::touching || family == Family::shapes_touching || family == Family::contained) continue;
    EXPECT_GT(counts[0], count / 400) << name_of(family);
    EXPECT_GT(counts[1], count / 400) << name_of(family);
  }
}

// All ties at once: cubes of a grid, shared facets, edges, vertices, and a plane full of coplanar vertices.
TEST(ExactSimplexTest, EndsWhateverTheDegeneracy) {
  std::vector<Point3> prism;
  for (int i = 0; i < 16; ++i) {  // cospherical and coplanar: x^2 + y^2 = 65
    constexpr std::array<std::array<double, 2>, 4> q{{{1, 8}, {4, 7}, {7, 4}, {8, 1}}};
    const auto [x, y] = q[static_cast<std::size_t>(i % 4)];
    for (const double z : {-1.0, 1.0}) prism.push_back({i & 4 ? x : -x, i & 8 ? y : -y, z});
  }
  const ConvexPolyhedron body(prism);
  ASSERT_EQ(body.vertices().size(), 32u);
  for (const double dx : {0.0, 1.0, 15.0, 16.0, 17.0}) {
    for (const double dy : {0.0, 2.0, 16.0}) {
      for (const double dz : {0.0, 1.0, 2.0, 3.0}) {
        const Pose here, there = Pose::from_matrix(here.affine().linear, {dx, dy, dz});
        const Placed a(body, here), b(body, there);
        Cost cost;
        StageTally tally;
        const PairCertificate c = decide_by_exact_simplex(a, b, {}, cost, tally);
        EXPECT_EQ(verdict_of(c), polyhedron_polyhedron_by_scan(body, here, body, there).verdict());
        EXPECT_EQ(check_placed(c, a, b), CheckResult::accepted);
      }
    }
  }
}

// The unit of the integers divides all images, be they multiples of 2^-1074, zero, or as large as can be.
TEST(ExactSimplexTest, TheEndsOfTheRangeOfDoubles) {
  constexpr double least = 5e-324, largest = std::numeric_limits<double>::max();
  const std::vector<double> sizes{least, 3 * least, 1e-310, 1.0, 1e300, largest};
  int apart = 0, meet = 0;
  for (const double s : sizes) {
    for (const double t : sizes) {
      for (const double linear : {least, 1.0, largest}) {
        for (const double shift : {0.0, least, 1.0, largest}) {
          const ConvexPolyhedron p(std::vector<Point3>{{0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}, {s, s, least}});
          const ConvexPolyhedron q(std::vector<Point3>{{t, 0, -t}, {t, t, t}, {t, -t, 0}});
          const Pose here = Pose::from_matrix({linear, 0, 0, 0, linear, 0, 0, least, linear}, {0, 0, 0});
          const Pose there = Pose::from_matrix({1, 0, 0, 0, linear, 0, 0, 0, 1}, {shift, 0, -shift});
          const Placed a(p, here), b(q, there);
          Cost cost;
          StageTally tally;
          const PairCertificate c = decide_by_exact_simplex(a, b, {}, cost, tally);
          ASSERT_EQ(verdict_of(c), polyhedron_polyhedron_by_scan(p, here, q, there).verdict())
              << s << " " << t << " " << linear << " " << shift;
          ASSERT_EQ(check_placed(c, a, b), CheckResult::accepted);
          ++(verdict_of(c) == Verdict::meet ? meet : apart);
        }
      }
    }
  }
  EXPECT_GT(apart, 50);
  EXPECT_GT(meet, 50);
}

TEST(ExactSimplexTest, TwoPoints) {
  const ConvexPolyhedron origin(std::vector<Point3>{{0, 0, 0}}), other(std::vector<Point3>{{5e-324, 0, 0}});
  const Pose pose;
  Cost cost;
  StageTally tally;
  EXPECT_EQ(verdict_of(decide_by_exact_simplex(Placed(origin, pose), Placed(origin, pose), {}, cost, tally)),
            Verdict::meet);
  EXPECT_EQ(verdict_of(decide_by_exact_simplex(Placed(origin, pose), Placed(other, pose), {}, cost, tally)),
            Verdict::apart);
  EXPECT_TRUE(interiors_meet(origin, Placed(origin, pose), origin, Placed(origin, pose), tally));
  EXPECT_FALSE(interiors_meet(origin, Placed(origin, pose), other, Placed(other, pose), tally));
}

// Relative interiors meet iff the bodies still do when both shrink a little towards their centroids. On small integer
// coordinates 2^-24 is little enough, and all is exact: multiplied by the numbers of vertices, centroids are integers.
TEST(ExactSimplexTest, InteriorsMeetIffSlightlySmallerBodiesDo) {
  Random random(tests::chosen_seed(83));
  const int count = tests::scaled_count(4000, 400);
  std::map<std::array<int, 2>, std::array<int, 2>> seen;  // by dimensions
  for (int i = 0; i < count; ++i) {
    const std::int64_t side = random.below(2) ? 1 : random.between(2, 3);
    const auto some_points = [&](int n) {
      std::vector<Point3> points;
      const auto coordinate = [&] { return static_cast<double>(random.between(-side, side)); };
      for (int k = 0; k < n; ++k) points.push_back({coordinate(), coordinate(), coordinate()});
      return points;
    };
    const bool small = random.below(3) == 0;  // or segments would cross too rarely
    const ConvexPolyhedron a(some_points(static_cast<int>(small ? random.between(2, 3) : random.between(1, 6))));
    const ConvexPolyhedron b(some_points(static_cast<int>(small ? random.between(2, 3) : random.between(1, 6))));
    const Pose pose;
    const double n_a = static_cast<double>(a.vertices().size()), n_b = static_cast<double>(b.vertices().size());
    const auto smaller = [&](const ConvexPolyhedron& body, double n, double other) {
      Point3 sum;
      for (const Point3& p : body.vertices()) sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
      const auto coordinate = [&](double x, double c) { return (n * x + (c - n * x) * 0x1p-24) * other; };
      std::vector<Point3> points;
      for (const Point3& p : body.vertices()) {
        points.push_back({coordinate(p.x, sum.x), coordinate(p.y, sum.y), coordinate(p.z, sum.z)});
      }
      return ConvexPolyhedron(points);
    };
    const bool expected = polyhedron_polyhedron_by_scan(smaller(a, n_a, n_b), pose, smaller(b, n_b, n_a), pose).meet();
    StageTally tally;
    // Also for bodies that do not meet: then the answer is no.
    ASSERT_EQ(interiors_meet(a, Placed(a, pose), b, Placed(b, pose), tally), expected) << i;
    ASSERT_EQ(interiors_meet(b, Placed(b, pose), a, Placed(a, pose), tally), expected) << i;
    if (polyhedron_polyhedron_by_scan(a, pose, b, pose).meet()) {
      ASSERT_EQ(polyhedron_polyhedron_contact(a, pose, b, pose), expected ? Relation::overlapping : Relation::touching)
          << i;
      ++seen[{a.dimension(), b.dimension()}][expected];
    }
  }
  if (count < 1500) return;  // the rates of a smaller run say little
  for (const int p : {1, 2, 3}) {
    for (const int q : {1, 2, 3}) {
      EXPECT_GT(seen[(std::array<int, 2>{p, q})][0], 0) << p << q;
      EXPECT_GT(seen[(std::array<int, 2>{p, q})][1], 0) << p << q;
    }
  }
}

}  // namespace
}  // namespace sunder::solid
