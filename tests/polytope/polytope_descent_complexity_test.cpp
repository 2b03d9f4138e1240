// What one descent down two trees of faces costs (Theorem 6.3), counted: each look at a point, a facet or a cone. And
// what these trees take: their levels, how their lists grow.
#include <sunder/base/random.h>
#include <sunder/polytope/tree/polytope_polytope_by_tree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace sunder::tests {
namespace {

using polytope::FaceTrees;
using polytope::FaceTreesOf;
using polytope::Polytope;
using polytope::PolytopeAnswer;
using polytope::Pose;

Polytope points_of_sphere(Random& random, std::size_t d, std::size_t count) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < count;) {
    std::vector<double> p(d);
    double square = 0;
    for (double& x : p) {
      x = random.uniform(-1, 1);
      square += x * x;
    }
    if (square > 1 || square < 0.01) continue;
    ++k;
    for (const double x : p) rows.push_back(x / std::sqrt(square));
  }
  return Polytope::from_points(d, std::move(rows));
}

struct DescentWork {
  double looks = 0, rounds = 0;
  std::uint32_t depth_of_faces = 0, depth_of_polar = 0;
  int finished = 0, meets = 0;
};

// Two bodies, from far in one another to apart, turned differently in each pair.
DescentWork descents(std::size_t d, std::size_t count, int pairs) {
  Random random(20261202 + d);
  const FaceTrees a(points_of_sphere(random, d, count), FaceTreesOf::faces),
      b(points_of_sphere(random, d, count), FaceTreesOf::polar);
  DescentWork work{.depth_of_faces = a.faces()->depth(), .depth_of_polar = b.polar()->depth()};
  const Pose here(d);
  for (int k = 0; k < pairs; ++k) {
    std::vector<double> linear(d * d), translation(d);
    for (std::size_t c = 2; c < d; ++c) linear[c * d + c] = 1;
    const double angle = random.uniform(0, 6.28), distance = 0.7 + 1.8 * k / (pairs - 1);
    linear[0] = linear[d + 1] = std::cos(angle);
    linear[d] = std::sin(angle);
    linear[1] = -linear[d];
    translation[0] = distance * 0.8;
    translation[d - 1] = distance * 0.6;
    const Pose there = Pose::from_matrix(d, linear, translation);
    const PolytopeAnswer answer = polytope_polytope_by_tree(a, here, b, there);
    EXPECT_EQ(answer.meet(), polytope_polytope(a.body(), here, b.body(), there).meet());
    EXPECT_LE(answer.cost.iterations, work.depth_of_faces + work.depth_of_polar + 2);
    work.looks += static_cast<double>(answer.cost.probes) / pairs;
    work.rounds += static_cast<double>(answer.cost.iterations) / pairs;
    work.finished += answer.decided_by != DecidedBy::evidence;
    work.meets += answer.meet();
    if (answer.meet()) continue;
    // Where a round let a face go that reaches beyond its plane, they would not part.
    const auto planes = hyperplanes_by_tree(a, here, b, there);
    EXPECT_TRUE(planes && check(a.body(), here, b.body(), there, *planes));
    if (planes) {
      EXPECT_LE(planes->b.planes.size(), answer.cost.iterations);
    }
  }
  std::printf(
      "d %zu, %5zu points: %6.0f looks, %.1f rounds; %d of %d meet, %d finished; depths %u and %u; lists of the "
      "roots %.1f and %.1f times the faces; %.1f and %.1f MiB; %zu and %zu leaves for want of a net\n",
      d, count, work.looks, work.rounds, work.meets, pairs, work.finished, work.depth_of_faces, work.depth_of_polar,
      static_cast<double>(a.faces()->root_list()) / static_cast<double>(a.faces()->face_count()),
      static_cast<double>(b.polar()->root_list()) / static_cast<double>(b.polar()->face_count()),
      static_cast<double>(a.memory()) / 0x1p20, static_cast<double>(b.memory()) / 0x1p20, a.faces()->unverified(),
      b.polar()->unverified());
  EXPECT_GT(work.meets, 0);
  EXPECT_LT(work.meets, pairs);
  EXPECT_LE(work.finished, pairs / 100);
  EXPECT_LE(std::max(a.memory(), b.memory()), std::size_t{1} << 30);
  return work;
}

TEST(PolytopeDescentComplexity, InThePlaneAndInSpaceAHundredTimesThePointsAreThreeTimesTheLooks) {
  for (const std::size_t d : {2u, 3u}) {
    const DescentWork few = descents(d, 100, 200), many = descents(d, 10000, 200);
    EXPECT_LE(many.looks, 3 * few.looks);
    EXPECT_GT(many.depth_of_faces, few.depth_of_faces);
    EXPECT_GT(many.depth_of_polar, few.depth_of_polar);
  }
}

TEST(PolytopeDescentComplexity, InFourAndFiveDimensions) {
  const DescentWork four = descents(4, 300, 100), five = descents(5, 60, 100);
  EXPECT_GE(four.depth_of_faces, 1u);
  EXPECT_GE(five.depth_of_faces, 1u);
}

}  // namespace
}  // namespace sunder::tests
