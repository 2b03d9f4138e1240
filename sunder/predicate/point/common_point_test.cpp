// Common points of few vertices: against the linear system for the weights, solved in integers, on small grids where
// every degeneracy is common; and five points against their minors in integers.
#include <sunder/base/random.h>
#include <sunder/number/integer_internal.h>
#include <sunder/predicate/exact_image_test.h>
#include <sunder/predicate/point/common_point.h>

#include <tests/support/exact.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <numeric>
#include <vector>

namespace sunder {
namespace {

using tests::Exact;

using WholePoint = std::array<std::int64_t, 3>;

// Has sum l_i a_i = sum m_j b_j, sum l_i = 1, sum m_j = 1 one solution only, and is that positive? By elimination in
// integers: five equations, a column for each point, and the right side.
bool has_unique_positive_weights(const std::vector<WholePoint>& points, std::size_t count_a) {
  const std::size_t k = points.size();
  std::array<std::array<std::int64_t, 6>, 5> rows{};
  for (std::size_t c = 0; c < k; ++c) {
    for (std::size_t r = 0; r < 3; ++r) rows[r][c] = c < count_a ? points[c][r] : -points[c][r];
    rows[c < count_a ? 3 : 4][c] = 1;
  }
  rows[3][k] = rows[4][k] = 1;
  for (std::size_t c = 0; c < k; ++c) {
    std::size_t pivot = c;
    while (pivot < 5 && rows[pivot][c] == 0) ++pivot;
    if (pivot == 5) return false;  // many solutions, or none
    std::swap(rows[c], rows[pivot]);
    for (std::size_t r = 0; r < 5; ++r) {
      if (r == c || rows[r][c] == 0) continue;
      const std::int64_t p = rows[c][c], q = rows[r][c];
      std::int64_t common = 0;
      for (std::size_t i = 0; i <= k; ++i) {
        rows[r][i] = rows[r][i] * p - rows[c][i] * q;
        common = std::gcd(common, rows[r][i]);
      }
      if (common > 1) {
        for (std::int64_t& x : rows[r]) x /= common;
      }
    }
  }
  for (std::size_t r = 0; r < 5; ++r) {
    if (r >= k && rows[r][k] != 0) return false;  // no solution
    if (r < k && (rows[r][k] == 0 || (rows[r][k] > 0) != (rows[r][r] > 0))) return false;
  }
  return true;
}

// The weights are positive, and have the same sum and give the same point on both sides.
void expect_valid(const std::array<Dyadic, 5>& w, std::span<const Posed3> a, std::span<const Posed3> b) {
  std::array<Exact, 2> sums{0, 0};
  std::array<ExactVector, 2> points{ExactVector{0, 0, 0}, ExactVector{0, 0, 0}};
  const std::size_t k = a.size() + b.size();
  for (std::size_t i = 0; i < k; ++i) {
    const std::size_t side = i < a.size() ? 0 : 1;
    const ExactVector x = image(side == 0 ? a[i] : b[i - a.size()]);
    const Exact weight(w[i]);
    ASSERT_GT(weight.sign(), 0) << i;
    sums[side] = sums[side] + weight;
    for (std::size_t j = 0; j < 3; ++j) points[side][j] = points[side][j] + weight * x[j];
  }
  for (std::size_t i = k; i < 5; ++i) ASSERT_EQ(w[i].sign(), Sign::zero);
  ASSERT_EQ(sums[0], sums[1]);
  for (std::size_t j = 0; j < 3; ++j) ASSERT_EQ(points[0][j], points[1][j]);
}

// Small whole numbers, times powers of two that cancel between a body and its pose, and one for both bodies.
struct WholeBody {
  std::array<std::int64_t, 9> linear{1, 0, 0, 0, 1, 0, 0, 0, 1};
  WholePoint translation{0, 0, 0};
  Affine3 pose;
  double scale = 1;

  void make_pose(int inner, int outer) {
    scale = std::ldexp(1.0, inner);
    for (std::size_t i = 0; i < 9; ++i) pose.linear[i] = std::ldexp(static_cast<double>(linear[i]), outer - inner);
    for (std::size_t i = 0; i < 3; ++i) pose.translation[i] = std::ldexp(static_cast<double>(translation[i]), outer);
  }
  WholePoint image_of(const WholePoint& x) const {
    WholePoint y = translation;
    for (std::size_t i = 0; i < 9; ++i) y[i / 3] += linear[i] * x[i % 3];
    return y;
  }
  Posed3 place(const WholePoint& x) const {
    return posed(
        {scale * static_cast<double>(x[0]), scale * static_cast<double>(x[1]), scale * static_cast<double>(x[2])},
        pose);
  }
};

struct Counts {
  int asked = 0, met = 0;
};

// Compares the answer and its weights with the oracle's.
void check_weights(const WholeBody& first, const WholeBody& second, const std::vector<WholePoint>& x,
                   std::size_t count_a, Counts& counts) {
  std::vector<WholePoint> images;
  std::vector<Posed3> placed;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const WholeBody& body = i < count_a ? first : second;
    images.push_back(body.image_of(x[i]));
    placed.push_back(body.place(x[i]));
  }
  const std::span<const Posed3> a(placed.data(), count_a), b(placed.data() + count_a, x.size() - count_a);
  const bool expected = has_unique_positive_weights(images, count_a);
  StageTally tally;
  ASSERT_EQ(have_common_point(a, b, &tally), expected);
  ASSERT_GT(tally.rounded + tally.interval + tally.exact, 0u);
  ASSERT_EQ(have_common_point(b, a), expected);
  ++counts.asked;
  if (expected) {
    ++counts.met;
    expect_valid(common_point_weights(a, b), a, b);
  }
}

TEST(CommonPointTest, OracleOnKnownCases) {
  EXPECT_TRUE(has_unique_positive_weights({{1, 2, 3}, {1, 2, 3}}, 1));
  EXPECT_FALSE(has_unique_positive_weights({{1, 2, 3}, {1, 2, 4}}, 1));
  EXPECT_TRUE(has_unique_positive_weights({{1, 1, 1}, {0, 0, 0}, {3, 3, 3}}, 1));
  EXPECT_FALSE(has_unique_positive_weights({{0, 0, 0}, {0, 0, 0}, {3, 3, 3}}, 1));  // an end: a weight is zero
  EXPECT_FALSE(has_unique_positive_weights({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, 1));  // many weights
  EXPECT_TRUE(has_unique_positive_weights({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}, 2));
  EXPECT_FALSE(has_unique_positive_weights({{0, 0, 0}, {2, 2, 0}, {2, 0, 1}, {0, 2, 1}}, 2));
  EXPECT_TRUE(has_unique_positive_weights({{1, 1, -1}, {1, 1, 1}, {0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, 2));
  EXPECT_FALSE(has_unique_positive_weights({{2, 2, -1}, {2, 2, 1}, {0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, 2));
}

TEST(CommonPointTest, KnownCases) {
  const Affine3 identity, shifted{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 1}};
  const auto at = [&](double x, double y, double z) { return posed({x, y, z}, identity); };
  // A segment through a triangle.
  const std::array a{at(1, 1, -1), at(1, 1, 3)};
  const std::array b{at(0, 0, 0), at(4, 0, 0), at(0, 4, 0)};
  EXPECT_TRUE(have_common_point(a, b));
  const std::array<Dyadic, 5> w = common_point_weights(a, b);
  expect_valid(w, a, b);
  EXPECT_EQ(w[0], w[1] * Dyadic(3.0));
  EXPECT_EQ(w[2], w[3] * Dyadic(2.0));
  // The same triangle lifted past the end, and up to the end: a weight is zero there.
  std::array<Posed3, 3> lifted{};
  for (const double z : {2.0, 3.0}) {
    for (std::size_t i = 0; i < 3; ++i) lifted[i] = posed({b[i].point.x, b[i].point.y, z}, shifted);
    EXPECT_FALSE(have_common_point(a, lifted));
  }
  const std::array end{at(1, 1, 3)};
  for (Posed3& p : lifted) p.point.z = 2;
  EXPECT_TRUE(have_common_point(end, lifted));
  expect_valid(common_point_weights(end, lifted), end, lifted);
  // One point twice.
  EXPECT_TRUE(have_common_point(std::array{at(0, 0, 1)}, std::array{posed({0, 0, 0}, shifted)}));
  EXPECT_FALSE(have_common_point(std::array{at(0, 0, 1)}, std::array{posed({0, 0, 0x1p-60}, shifted)}));
}

// One body is tame; the other's image has a size but would be one point in floating point.
TEST(CommonPointTest, OneBodyUnderflows) {
  const Affine3 identity, tiny{{1e-200, 0, 0, 0, 1e-200, 0, 0, 0, 1e-200}, {}};
  const std::array a{posed({0, 0, 1}, identity), posed({0, 0, -1}, identity)};
  const double s = 1e-200;
  for (const double shift : {0.0, 2 * s}) {
    std::array b{posed({s + shift, 0, 0}, tiny), posed({-s + shift, s, 0}, tiny), posed({-s + shift, -s, 0}, tiny)};
    ASSERT_TRUE(a[0].tame);
    ASSERT_FALSE(b[0].tame);
    for (int turn = 0; turn < 3; ++turn) {
      EXPECT_EQ(have_common_point(a, b), shift == 0);
      EXPECT_EQ(have_common_point(b, a), shift == 0);
      std::rotate(b.begin(), b.begin() + 1, b.end());
    }
  }
}

// All placements of up to four points on the corners of a cube.
TEST(CommonPointTest, AllOfUpToFourCorners) {
  WholeBody first, second;
  for (std::size_t k = 2; k <= 4; ++k) {
    Counts counts;
    for (std::size_t code = 0; code < std::size_t{1} << (3 * k); ++code) {
      std::vector<WholePoint> x(k);
      for (std::size_t i = 0; i < 3 * k; ++i) x[i / 3][i % 3] = code >> i & 1;
      for (std::size_t count_a = 1; count_a < k; ++count_a) {
        check_weights(first, second, x, count_a, counts);
        if (HasFatalFailure()) FAIL() << k << " points, code " << code << ", " << count_a << " of A";
      }
    }
    EXPECT_EQ(counts.asked, static_cast<int>((k - 1) << (3 * k)));
    // Two equal points; none within an edge; two diagonals of a face or of the cube (4 orders, 2 ways round each).
    EXPECT_EQ(counts.met, k == 2 ? 8 : k == 3 ? 0 : 8 * 6 + 8 * 6);
  }
}

TEST(CommonPointTest, RandomPointsOfGrids) {
  Random random(tests::chosen_seed(1));
  const int n = tests::scaled_count(60000, 1000);
  std::map<std::pair<std::size_t, std::size_t>, Counts> counts;
  int untame = 0;
  for (int i = 0; i < n; ++i) {
    const std::size_t k = 2 + static_cast<std::size_t>(i) % 4, count_a = 1 + random.below(k - 1);
    const std::int64_t side = random.between(2, k == 5 ? 6 : 4);
    const bool flat = k < 5 && random.below(3) != 0;  // on a line or plane, where fewer than five points meet oftener
    WholeBody first, second;
    if (i % 3 != 0) {  // small changes of the axes, reflections and singular ones among them
      for (WholeBody* body : {&first, &second}) {
        for (std::int64_t& m : body->linear) m += random.below(4) ? 0 : random.between(-1, 1);
        for (std::int64_t& t : body->translation) t = random.between(-1, 1);
      }
    }
    if (flat) second = first;
    const bool scaled = i % 3 == 2;
    const int outer = scaled ? static_cast<int>(random.between(-500, 500)) : 0;
    for (WholeBody* body : {&first, &second})
      body->make_pose(scaled ? static_cast<int>(random.between(-500, 500)) : 0, outer);
    std::vector<WholePoint> x(k);
    const auto fill = [&](WholePoint& p, std::int64_t low, std::int64_t high) {
      for (std::int64_t& c : p) c = random.between(low, high);
    };
    WholePoint u{}, v{};
    fill(u, -1, 1);
    if (k == 4) fill(v, -1, 1);
    for (WholePoint& p : x) {
      fill(p, 0, side - 1);
      const std::int64_t s = p[0], t = p[1];
      for (std::size_t j = 0; flat && j < 3; ++j) p[j] = s * u[j] + t * v[j];
    }
    if (k == 5 && random.below(2)) x[random.below(2) * 4] = {side / 2, side / 2, side / 2};
    if (!first.place(x[0]).tame) ++untame;
    check_weights(first, second, x, count_a, counts[{count_a, k - count_a}]);
    if (HasFatalFailure()) FAIL() << "instance " << i << ": " << count_a << " and " << k - count_a << " points";
  }
  EXPECT_EQ(counts.size(), 10u);
  for (const auto& [sizes, c] : counts) {
    EXPECT_GT(c.asked, n / 40) << sizes.first << " " << sizes.second;
    EXPECT_GE(c.met, c.asked / 400) << sizes.first << " " << sizes.second;
    EXPECT_LT(c.met, c.asked / 2) << sizes.first << " " << sizes.second;
  }
  EXPECT_GT(untame, n / 20);
}

// det(1 x y z) of four points, by expansion.
int orientation(const std::array<ExactVector, 4>& p) {
  std::array<std::array<Exact, 3>, 3> r{p[1], p[2], p[3]};
  for (auto& row : r) {
    for (std::size_t i = 0; i < 3; ++i) row[i] = row[i] - p[0][i];
  }
  return (r[0][0] * (r[1][1] * r[2][2] - r[2][1] * r[1][2]) - r[1][0] * (r[0][1] * r[2][2] - r[2][1] * r[0][2]) +
          r[2][0] * (r[0][1] * r[1][2] - r[1][1] * r[0][2]))
      .sign();
}

struct Minors {
  bool separate = true;
  bool vanish = false;
};

Minors minors(std::span<const Posed3> points, std::size_t count_a) {
  Minors result;
  std::array<int, 5> c{};
  for (std::size_t i = 0; i < 5; ++i) {
    std::array<ExactVector, 4> rest{ExactVector{0, 0, 0}, ExactVector{0, 0, 0}, ExactVector{0, 0, 0},
                                    ExactVector{0, 0, 0}};
    for (std::size_t j = 0; j < 4; ++j) rest[j] = image(points[j < i ? j : j + 1]);
    c[i] = orientation(rest) * (i % 2 ? -1 : 1) * (i < count_a ? 1 : -1);
    if (c[i] == 0) result.vanish = true;
    if (c[i] == 0 || c[i] != c[0]) result.separate = false;
  }
  return result;
}

enum PointsKind { generic_points, near_tied_points, far_points, extreme_points, points_kinds };

TEST(CommonPointTest, FivePointsOfAnySize) {
  Random random(tests::chosen_seed(2));
  const int n = tests::scaled_count(20000, 1000);
  std::array<Counts, points_kinds> counts{};
  std::array<StageTally, points_kinds> tallies{};
  int vanishing = 0;
  const auto in_cube = [&] { return tests::in_cube(random); };
  for (int i = 0; i < n; ++i) {
    const PointsKind kind = static_cast<PointsKind>(i % points_kinds);
    std::size_t count_a = 1 + random.below(4);
    std::array<Affine3, 2> pose;
    for (double& m : pose[0].linear) m = random.uniform(-1, 1);
    if (kind == far_points) {
      const double size = random.log_uniform(1, 0x1p70);
      for (double& t : pose[0].translation) t = random.uniform(-size, size);
    }
    pose[1] = pose[0];
    std::array<Point3, 5> x{in_cube(), in_cube(), in_cube(), in_cube(), in_cube()};
    if (kind == near_tied_points) {
      // One point nearly on the plane, the line, or the place of three others; mostly between them, and then whether
      // the bodies meet hangs on that.
      const bool between = random.below(4) != 0;
      const double s = between ? random.unit() : random.uniform(-1, 1);
      const double t = random.below(4) == 0 ? 0 : between ? (1 - s) * random.unit() : random.uniform(-1, 1);
      const double offset = random.below(2) ? random.log_uniform(0x1p-70, 1) : 0, r = 1 - s - t;
      x[4] = {s * x[0].x + t * x[1].x + r * x[2].x + offset, s * x[0].y + t * x[1].y + r * x[2].y,
              s * x[0].z + t * x[1].z + r * x[2].z};
      if (between) count_a = 3 + random.below(2);
    } else {
      std::swap(x[4], x[random.below(5)]);
    }
    if (kind == extreme_points) {
      const int e = static_cast<int>(random.between(-1074, 1020));
      const auto one = [&] { return std::ldexp(static_cast<double>(random.between(-3, 3)), e); };
      for (Point3& p : x) p = {one(), one(), one()};
      pose = {};
      if (random.below(2)) pose[0].linear = {0, 1, 0, -1, 0, 0, 0, 0, 1};
      if (random.below(4) == 0) pose[1].translation = {1e300, -5e-324, 1};
    }
    std::array<Posed3, 5> p{};
    for (std::size_t j = 0; j < 5; ++j) p[j] = posed(x[j], pose[j < count_a ? 0 : 1]);
    const std::span<const Posed3> a(p.data(), count_a), b(p.data() + count_a, 5 - count_a);
    const Minors m = minors(p, count_a);
    StageTally tally;
    ASSERT_EQ(have_common_point(a, b, &tally), m.separate) << "instance " << i << ", kind " << kind;
    ASSERT_EQ(tally.rounded + tally.interval + tally.exact, 1u);
    ++counts[kind].asked;
    if (m.vanish) ++vanishing;
    if (m.separate) ++counts[kind].met;
    if (m.separate && i % 8 < 4) expect_valid(common_point_weights(a, b), a, b);
    if (HasFatalFailure()) FAIL() << "instance " << i << ", kind " << kind;
    tallies[kind].rounded += tally.rounded;
    tallies[kind].interval += tally.interval;
    tallies[kind].exact += tally.exact;
  }
  const auto each = static_cast<unsigned>(n / points_kinds);
  EXPECT_GE(tallies[generic_points].rounded, each - each / 1000 - 1);
  EXPECT_GT(tallies[near_tied_points].exact, each / 50);
  EXPECT_GT(tallies[near_tied_points].rounded, each / 4);
  EXPECT_GT(tallies[far_points].exact, each / 10);
  EXPECT_GT(tallies[extreme_points].interval, each / 20);
  EXPECT_GT(tallies[extreme_points].exact, each / 20);
  for (const Counts& c : counts) EXPECT_GT(c.met, c.asked / 100);
  EXPECT_GT(vanishing, n / 100);
}

}  // namespace
}  // namespace sunder
