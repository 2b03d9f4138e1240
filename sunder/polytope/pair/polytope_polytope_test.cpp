#include <sunder/base/random.h>
#include <sunder/polytope/pair/polytope_polytope.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sunder::polytope {
namespace {

// The points +-1 along each axis, and the cube of all +-1.
Polytope cross_polytope(std::size_t d) {
  std::vector<double> rows(2 * d * d);
  for (std::size_t c = 0; c < d; ++c) {
    rows[2 * c * d + c] = 1;
    rows[(2 * c + 1) * d + c] = -1;
  }
  return Polytope::from_points(d, rows);
}
Polytope cube(std::size_t d) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < std::size_t{1} << d; ++k) {
    for (std::size_t c = 0; c < d; ++c) rows.push_back((k >> c) & 1 ? 1.0 : -1.0);
  }
  return Polytope::from_points(d, rows);
}
Polytope box(std::size_t d) {  // the cube, of half-spaces
  std::vector<double> rows;
  for (std::size_t c = 0; c < d; ++c) {
    for (const double side : {1.0, -1.0}) {
      std::vector<double> row(d + 1);
      row[c] = side;
      row[d] = 1;
      rows.insert(rows.end(), row.begin(), row.end());
    }
  }
  return Polytope::from_half_spaces(d, rows);
}
Pose shift(std::size_t d, const std::vector<double>& by) { return Pose::from_matrix(d, Pose(d).linear(), by); }

PolytopeAnswer checked(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b) {
  PolytopeAnswer answer = polytope_polytope(a, pose_a, b, pose_b);
  EXPECT_EQ(answer.meet(), polytope_polytope_by_scan(a, pose_a, b, pose_b).meet());
  EXPECT_TRUE(check(a, pose_a, b, pose_b, answer.verdict(), exact_evidence(a, pose_a, b, pose_b, answer)));
  return answer;
}

TEST(PolytopePolytope, TouchingIsMeetingAndALastBitIsNot) {
  for (std::size_t d = 2; d <= 6; ++d) {
    std::vector<double> far(d);
    far[d - 1] = 2;
    for (const Polytope& b : {cross_polytope(d), cube(d), box(d)}) {
      const PolytopeAnswer touching = checked(cross_polytope(d), Pose(d), b, shift(d, far));
      EXPECT_TRUE(touching.meet());
      EXPECT_NE(touching.decided_by, DecidedBy::filter);
      far[d - 1] = std::nextafter(2.0, 3.0);
      EXPECT_FALSE(checked(cross_polytope(d), Pose(d), b, shift(d, far)).meet());
      far[d - 1] = std::nextafter(2.0, 1.0);
      EXPECT_TRUE(checked(cross_polytope(d), Pose(d), b, shift(d, far)).meet());
      far[d - 1] = 2;
    }
  }
}

TEST(PolytopePolytope, FiltersDecideWhatIsPlain) {
  for (std::size_t d = 2; d <= 6; ++d) {
    std::vector<double> by(d);
    for (std::size_t c = 0; c < d; ++c) by[c] = 0.31 - 0.07 * static_cast<double>(c);
    const PolytopeAnswer meet = checked(cross_polytope(d), Pose(d), cube(d), shift(d, by));
    EXPECT_TRUE(meet.meet());
    EXPECT_EQ(meet.decided_by, DecidedBy::filter);
    EXPECT_EQ(meet.cost.exact, 0u);
    by[0] = 5;
    const PolytopeAnswer apart = checked(cross_polytope(d), Pose(d), cube(d), shift(d, by));
    EXPECT_FALSE(apart.meet());
    EXPECT_EQ(apart.decided_by, DecidedBy::filter);
    EXPECT_EQ(apart.cost.exact, 0u);
  }
}

// Of spheres of 1,000 points that meet, nearly meet, or are near: the evidence stands by itself, and after the sample
// some two to four looks at all points do.
TEST(PolytopePolytope, LargeBodiesTakeFewLooksAtAllPoints) {
  Random random(20261127);
  constexpr std::size_t count = 1000;
  for (const std::size_t d : {3u, 4u, 5u}) {
    std::size_t looks = 0, meets = 0, pairs = 0;
    for (const double distance : {1.2, 1.9, 1.95, 1.98, 2.1}) {
      const auto sphere = [&](double shift) {
        std::vector<double> rows;
        for (std::size_t k = 0; k < count; ++k) {
          std::vector<double> p(d);
          double square = 0;
          for (double& x : p) {
            x = random.uniform(-1, 1);
            square += x * x;
          }
          for (std::size_t c = 0; c < d; ++c) rows.push_back(p[c] / std::sqrt(square) + (c == 0 ? shift : 0));
        }
        return Polytope::from_points(d, rows);
      };
      const Polytope a = sphere(0), b = sphere(distance);
      const Pose here(d);
      const PolytopeAnswer answer = polytope_polytope(a, here, b, here);
      EXPECT_TRUE(check(a, here, b, here, answer.verdict(), exact_evidence(a, here, b, here, answer)));
      EXPECT_EQ(answer.decided_by, DecidedBy::filter);
      looks += answer.cost.probes;
      meets += answer.meet();
      ++pairs;
    }
    EXPECT_GT(meets, 0u);
    EXPECT_LT(meets, pairs);
    EXPECT_LT(looks, 4 * pairs * 2 * count);
  }
}

TEST(PolytopePolytope, EmptyBodiesMeetNothing) {
  const Polytope nothing = Polytope::from_half_spaces(3, {1, 0, 0, -1, -1, 0, 0, -1}),
                 all = Polytope::from_half_spaces(3, {});
  const Polytope none_by_itself = Polytope::from_half_spaces(3, {0, 0, 0, -1});
  for (const Polytope& empty : {nothing, none_by_itself}) {
    EXPECT_FALSE(checked(empty, Pose(3), all, Pose(3)).meet());
    EXPECT_FALSE(checked(cube(3), Pose(3), empty, Pose(3)).meet());
    EXPECT_FALSE(checked(empty, Pose(3), cube(3), Pose(3)).meet());
    EXPECT_FALSE(checked(empty, Pose(3), empty, Pose(3)).meet());
  }
  EXPECT_TRUE(checked(all, Pose(3), all, Pose(3)).meet());
  EXPECT_TRUE(checked(cube(3), Pose(3), all, Pose(3)).meet());
}

TEST(PolytopePolytope, EvidenceOfAnotherPairProvesNothing) {
  const Polytope a = cube(4), b = cross_polytope(4);
  const Pose here(4), there = shift(4, {3, 0, 0, 0}), elsewhere = shift(4, {0, 3, 0, 0});
  const PolytopeAnswer answer = polytope_polytope(a, here, b, there);
  const ExactEvidence evidence = exact_evidence(a, here, b, there, answer);
  EXPECT_TRUE(check(a, here, b, there, Verdict::apart, evidence));
  EXPECT_FALSE(check(a, here, b, elsewhere, Verdict::apart, evidence));
  EXPECT_FALSE(check(a, here, b, here, Verdict::apart, evidence));
  EXPECT_FALSE(check(b, there, a, here, Verdict::apart, evidence));
}

}  // namespace
}  // namespace sunder::polytope
