#include <sunder/polytope/pair/polytope_point.h>

#include <sunder/base/random.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace sunder::polytope {
namespace {

TEST(PolytopePoint, ManyAtOnceAreAsEachAlone) {
  const int bodies = tests::scaled_count(20, 4);
  Random random(tests::chosen_seed(20261126));
  int inside = 0, known = 0, all = 0;
  for (int i = 0; i < bodies; ++i) {
    const std::size_t d = 2 + random.below(5);
    std::vector<double> numbers(d * (d + 1 + random.below(60)));
    for (double& x : numbers) x = static_cast<double>(random.between(-8, 8)) / 8;
    const Polytope hull = Polytope::from_points(d, numbers);
    std::vector<double> points(d * 60);
    for (double& x : points) x = static_cast<double>(random.between(-8, 8)) / 8;
    std::copy_n(numbers.begin(), d, points.begin());  // a point of it
    const std::vector<PolytopeAnswer> answers = polytope_points(hull, points);
    ASSERT_EQ(answers.size(), 60u);
    EXPECT_TRUE(answers[0].meet());
    const Pose pose(d);
    for (std::size_t k = 0; k < answers.size(); ++k) {
      const std::vector<double> point(&points[k * d], &points[k * d] + d);
      const Polytope one = Polytope::from_points(d, point);
      const PolytopeAnswer alone = polytope_point(hull, point);
      ASSERT_EQ(answers[k].meet(), polytope_polytope_by_scan(hull, pose, one, pose).meet());
      ASSERT_EQ(answers[k].meet(), alone.meet());
      for (const PolytopeAnswer& answer : {answers[k], alone}) {
        const ExactEvidence exact = exact_evidence(hull, pose, one, pose, answer);
        ASSERT_TRUE(check(hull, pose, one, pose, answer.verdict(), exact));
      }
      ++all;
      inside += answers[k].meet();
      known += answers[k].cost.iterations == 0 && answers[k].decided_by == DecidedBy::filter;
    }
  }
  EXPECT_GT(inside, all / 20);
  EXPECT_LT(inside, all * 19 / 20);
  EXPECT_GT(known, all / 4);
}

TEST(PolytopePoint, OfHalfSpaces) {
  const Polytope box = Polytope::from_half_spaces(3, {1, 0, 0, 1, -1, 0, 0, 1, 0, 1, 0, 1, 0, -1, 0, 1, 0, 0, 1, 1});
  EXPECT_TRUE(polytope_point(box, std::vector<double>{1, -1, -1e300}).meet());
  EXPECT_FALSE(polytope_point(box, std::vector<double>{0, 0, 1 + 0x1p-52}).meet());
}

TEST(PolytopePoint, RefusesWhatIsNoPoint) {
  const Polytope p = Polytope::from_points(2, {0, 0, 1, 1});
  EXPECT_THROW(static_cast<void>(polytope_point(p, std::vector<double>{1, 2, 3})), Error);
  EXPECT_THROW(polytope_points(p, std::vector<double>{1, 2, 3}), Error);
  EXPECT_THROW(polytope_points(p, std::vector<double>{1, std::numeric_limits<double>::quiet_NaN()}), Error);
  EXPECT_TRUE(polytope_points(p, {}).empty());
}

}  // namespace
}  // namespace sunder::polytope
