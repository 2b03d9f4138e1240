#include <sunder/predicate/point/shortest_way.h>

#include <sunder/base/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sunder {
namespace {

// A few points under a pose.
struct Placed {
  std::vector<Point3> points;
  Affine3 pose;

  std::vector<Posed3> posed() const {
    std::vector<Posed3> all;
    for (const Point3& p : points) all.push_back({p, &pose, false});
    return all;
  }
};

std::optional<ExactWay> way(const Placed& a, const Placed& b) { return exact_way(a.posed(), b.posed()); }
Guess guess(const Placed& a, const Placed& b) { return enclosed_way(a.posed(), b.posed()).weights; }

void expect_squared(const std::optional<ExactWay>& found, double numerator, double denominator) {
  ASSERT_TRUE(found);
  EXPECT_EQ(found->way.squared() * Dyadic(denominator), found->way.denominator * Dyadic(numerator));
}

TEST(ShortestWayTest, KnownWays) {
  const Placed origin{{{0, 0, 0}}, {}}, point{{{1, 2, 2}}, {}};
  expect_squared(way(origin, point), 9, 1);
  const Placed edge{{{3, -1, 0}, {3, 3, 0}}, {}};
  expect_squared(way(origin, edge), 9, 1);
  expect_squared(way(edge, origin), 9, 1);
  EXPECT_EQ(way(origin, edge)->weight[1] * Dyadic(4.0), way(origin, edge)->way.denominator * Dyadic(3.0));
  const Placed triangle{{{-1, -1, 2}, {3, -1, 2}, {-1, 3, 2}}, {}};
  expect_squared(way(origin, triangle), 4, 1);
  expect_squared(way(triangle, origin), 4, 1);
  EXPECT_EQ(way(triangle, origin)->way.way.z.sign(), Sign::negative);  // from A to B
  EXPECT_EQ(way(origin, triangle)->way.way.z.sign(), Sign::positive);
  const Placed other_edge{{{0, 1, 7}, {6, 1, 7}}, {}};
  expect_squared(way(edge, other_edge), 49, 1);
  expect_squared(way(other_edge, edge), 49, 1);
  for (const Placed* a : {&origin, &point, &edge, &other_edge}) {
    for (const Placed* b : {&origin, &point, &edge, &other_edge}) {
      if (way(*a, *b)) {
        EXPECT_NE(guess(*a, *b), Guess::negative);
      }
    }
  }
}

TEST(ShortestWayTest, NoneWhereTheFootIsOutsideOrNothingIsSpanned) {
  const Placed origin{{{0, 0, 0}}, {}};
  const Placed beside{{{3, 1, 0}, {3, 3, 0}}, {}};
  EXPECT_FALSE(way(origin, beside));
  EXPECT_EQ(guess(origin, beside), Guess::negative);
  EXPECT_FALSE(way(origin, {{{3, 1, 0}, {3, 1, 0}}, {}}));                        // no edge
  EXPECT_FALSE(way(origin, {{{1, 1, 1}, {2, 1, 1}, {4, 1, 1}}, {}}));             // no triangle
  EXPECT_FALSE(way({{{0, 0, 0}, {1, 0, 0}}, {}}, {{{0, 1, 0}, {1, 1, 0}}, {}}));  // parallel
  EXPECT_FALSE(way(origin, {{{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}}, {}}));         // they meet
  EXPECT_FALSE(way(origin, origin));
  // A foot at an end is allowed, but intervals are not sure of it.
  const Placed at_end{{{3, 0, 0}, {3, 3, 0}}, {}};
  expect_squared(way(origin, at_end), 9, 1);
  EXPECT_EQ(way(origin, at_end)->weight[2].sign(), Sign::zero);
  EXPECT_EQ(guess(origin, at_end), Guess::unsure);
}

TEST(ShortestWayTest, NumbersOfAllSizes) {
  for (const double s : {5e-324, 1e-300, 1e-160, 1e160, 1e307}) {
    const Placed origin{{{0, 0, 0}}, {}}, triangle{{{-s, -s, 2 * s}, {3 * s, -s, 2 * s}, {-s, 3 * s, 2 * s}}, {}};
    const std::optional<ExactWay> found = way(origin, triangle);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->way.squared(), Dyadic(2 * s) * Dyadic(2 * s) * found->way.denominator);
  }
}

// What intervals are sure of is so; the way is perpendicular to the edges, leads from the one end to the other, and is
// what it is said to be between the images.
TEST(ShortestWayTest, TheStagesAgree) {
  Random random(4);
  int sure = 0, negative = 0, all = 0;
  for (int i = 0; i < 4000; ++i) {
    const double size = std::ldexp(1.0, static_cast<int>(random.between(-20, 20)));
    const auto placed = [&](std::uint64_t n) {
      Placed some;
      for (std::uint64_t k = 0; k < n; ++k) {
        const auto coordinate = [&] {
          return i % 2 == 0 ? static_cast<double>(random.between(-3, 3)) : size * random.uniform(-1, 1);
        };
        some.points.push_back({coordinate(), coordinate(), coordinate()});
      }
      for (double& x : some.pose.linear)
        x = i % 2 == 0 ? static_cast<double>(random.between(-2, 2)) : random.uniform(-1, 1);
      for (double& x : some.pose.translation) x = static_cast<double>(random.between(-5, 5));
      return some;
    };
    const std::uint64_t of_a = 1 + random.below(3), of_b = 1 + random.below(4 - of_a);
    const Placed a = placed(of_a), b = placed(of_b);
    const auto posed_a = a.posed(), posed_b = b.posed();
    const std::optional<ExactWay> found = exact_way(posed_a, posed_b);
    const EnclosedWay enclosed = enclosed_way(posed_a, posed_b);
    ++all;
    if (enclosed.weights == Guess::negative) {
      ++negative;
      EXPECT_FALSE(found);
    }
    if (enclosed.weights == Guess::positive) {
      ++sure;
      ASSERT_TRUE(found) << i;
      const auto& w = found->way.way;
      for (const auto& [exact, interval] :
           {std::pair(&w.x, enclosed.way.x), {&w.y, enclosed.way.y}, {&w.z, enclosed.way.z}}) {
        EXPECT_NE((*exact - Dyadic(interval.low)).sign(), Sign::negative) << i;
        EXPECT_NE((*exact - Dyadic(interval.high)).sign(), Sign::positive) << i;
      }
    }
    if (!found) continue;
    const auto& [w, weight] = *found;
    // The ends, times the denominator.
    Vector3<Dyadic> p{}, q{};
    Dyadic sum_a, sum_b;
    for (std::size_t k = 0; k < of_a + of_b; ++k) {
      const bool is_a = k < of_a;
      const auto v = lift<ExactStage>(is_a ? posed_a[k] : posed_b[k - of_a]);
      Vector3<Dyadic>& end = is_a ? p : q;
      end = {end.x + weight[k] * v.x, end.y + weight[k] * v.y, end.z + weight[k] * v.z};
      Dyadic& sum = is_a ? sum_a : sum_b;
      sum = sum + weight[k];
    }
    EXPECT_EQ(sum_a, w.denominator);
    EXPECT_EQ(sum_b, w.denominator);
    const auto d = q - p;
    EXPECT_EQ(dot(d, d), w.squared() * w.denominator) << i;
    const auto parallel = cross(d, w.way);
    EXPECT_EQ(dot(parallel, parallel).sign(), Sign::zero);
    EXPECT_EQ(dot(d, w.way).sign(), Sign::positive);
    for (std::size_t k = 1; k < of_a; ++k) {
      EXPECT_EQ(dot(w.way, lift<ExactStage>(posed_a[k]) - lift<ExactStage>(posed_a[0])).sign(), Sign::zero);
    }
    for (std::size_t k = 1; k < of_b; ++k) {
      EXPECT_EQ(dot(w.way, lift<ExactStage>(posed_b[k]) - lift<ExactStage>(posed_b[0])).sign(), Sign::zero);
    }
  }
  EXPECT_GT(sure, all / 10);
  EXPECT_GT(negative, all / 10);
}

TEST(ShortestWayTest, ComparesAlongAnEnclosure) {
  const Affine3 pose{{2, 0, 0, 0, 1, 0, 0, 0, -1}, {5, 6, 7}};
  const EnclosedAlong along({{1, 1}, {0, 0}, {1, 1}}, pose);
  EXPECT_TRUE(along.surely_further({0, 0, 0}, {1, 9, 0}));
  EXPECT_TRUE(along.surely_less_far({0, 0, 0}, {0, 0, 1}));  // z is reflected
  EXPECT_FALSE(along.surely_further({0, 0, 0}, {1, 0, 2}));  // as far
  EXPECT_FALSE(along.surely_less_far({0, 0, 0}, {1, 0, 2}));
}

}  // namespace
}  // namespace sunder
