// The nearest face against trying all faces, on simplices as a search meets them.
#include <sunder/base/random.h>
#include <sunder/solid/search/closest_simplex.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace sunder::solid {
namespace {

using Long3 = std::array<long double, 3>;

long double wide(double x) { return static_cast<long double>(x); }
Long3 long3(const Point3& p) { return {wide(p.x), wide(p.y), wide(p.z)}; }
Long3 minus(const Long3& a, const Long3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Long3 cross(const Long3& a, const Long3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
long double dot(const Long3& a, const Long3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
long double length(const Long3& a) { return std::sqrt(dot(a, a)); }

// The point nearest to the origin in the flat of some points, by barycentric coordinates; weights empty when one is not
// positive (another face is nearer) or the points are not independent.
struct Nearest {
  std::vector<long double> weights;
  Long3 point{};
};

Nearest nearest_in_flat(const std::vector<Long3>& p) {
  const std::size_t k = p.size() - 1;
  // Gram's system  sum_j (e_i . e_j) w_j = -e_i . p_0  by Gauss's elimination.
  std::array<std::array<long double, 4>, 3> m{};
  for (std::size_t i = 0; i < k; ++i) {
    const Long3 e = minus(p[i + 1], p[0]);
    for (std::size_t j = 0; j < k; ++j) m[i][j] = dot(e, minus(p[j + 1], p[0]));
    m[i][k] = -dot(e, p[0]);
  }
  for (std::size_t c = 0; c < k; ++c) {
    std::size_t r = c;
    for (std::size_t i = c; i < k; ++i) r = std::fabs(m[i][c]) > std::fabs(m[r][c]) ? i : r;
    std::swap(m[r], m[c]);
    if (std::fabs(m[c][c]) < 1e-15L) return {};
    for (std::size_t i = 0; i < k; ++i) {
      if (i == c) continue;
      const long double f = m[i][c] / m[c][c];
      for (std::size_t j = 0; j <= k; ++j) m[i][j] -= f * m[c][j];
    }
  }
  Nearest n;
  n.weights.assign(p.size(), 0);
  n.weights[0] = 1;
  n.point = p[0];
  for (std::size_t i = 0; i < k; ++i) {
    const long double w = m[i][k] / m[i][i];
    n.weights[i + 1] = w;
    n.weights[0] -= w;
    const Long3 e = minus(p[i + 1], p[0]);
    for (std::size_t c = 0; c < 3; ++c) n.point[c] += w * e[c];
  }
  for (const long double w : n.weights) {
    if (w <= 0) return {};
  }
  return n;
}

// The least distance over all faces; `margin` is how far the case is from another face being the answer.
struct Answer {
  std::set<std::uint32_t> corners;
  Long3 point{};
  long double margin = 1;
};

Answer over_all_faces(const DifferenceSimplex& s) {
  Answer best;
  long double distance = 1e30L;
  for (unsigned subset = 1; subset < 1u << s.count; ++subset) {
    std::vector<Long3> points;
    std::set<std::uint32_t> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!(subset >> i & 1)) continue;
      points.push_back(long3(s.vertex[i].at));
      corners.insert(s.vertex[i].a);
    }
    const Nearest n = nearest_in_flat(points);
    if (n.weights.empty() || length(n.point) >= distance) continue;
    distance = length(n.point);
    best = {corners, n.point, *std::min_element(n.weights.begin(), n.weights.end())};
  }
  return best;
}

DifferenceVertex vertex(const Point3& at, std::uint32_t number) {
  DifferenceVertex v;
  v.at = at;
  v.a = number;
  v.b = 100 + number;
  return v;
}

class ClosestSimplexTest : public testing::Test {
 protected:
  double coordinate() { return random_.uniform(-1, 1); }

  // Runs the search over a cloud of points, each step against all faces.
  void search(const std::vector<Point3>& cloud) {
    DifferenceSimplex s;
    Point3 towards{1, 0, 0};
    for (int step = 0; step < 30; ++step) {
      std::uint32_t furthest = 0;
      const auto along = [&](std::uint32_t i) {
        return towards.x * cloud[i].x + towards.y * cloud[i].y + towards.z * cloud[i].z;
      };
      for (std::uint32_t i = 1; i < cloud.size(); ++i) furthest = along(i) > along(furthest) ? i : furthest;
      for (int i = 0; i < s.count; ++i) {
        if (s.vertex[static_cast<std::size_t>(i)].a == furthest) return;
      }
      s.vertex[static_cast<std::size_t>(s.count++)] = vertex(cloud[furthest], furthest);
      const Answer expected = over_all_faces(s);
      const DifferenceSimplex before = s;
      double distance2 = -1;
      const bool outside = reduce_to_closest_face(s, towards, distance2);
      if (expected.margin < 1e-6L || length(expected.point) < 1e-6L) {  // in doubles either face will do
        if (length(expected.point) < 1e-6L && before.count < 4) return;
        if (before.count < 4) continue;
      }
      if (before.count == 4 && (expected.corners.size() == 4 || length(expected.point) < 1e-6L)) {
        if (expected.corners.size() == 4 && expected.margin > 1e-6L) {
          ASSERT_FALSE(outside);
          ++inside_;
          expect_weights(before);
        }
        return;
      }
      if (expected.margin < 1e-6L) return;
      ASSERT_TRUE(outside);
      ++outside_[static_cast<std::size_t>(before.count - 1)][expected.corners.size() - 1];
      std::set<std::uint32_t> corners;
      for (int i = 0; i < s.count; ++i) {
        const DifferenceVertex& v = s.vertex[static_cast<std::size_t>(i)];
        corners.insert(v.a);
        ASSERT_EQ(v.b, 100 + v.a);  // moved as a whole
        ASSERT_EQ(v.at, cloud[v.a]);
      }
      ASSERT_EQ(corners, expected.corners);
      ASSERT_EQ(corners.size(), static_cast<std::size_t>(s.count));
      // The direction is that from the nearest point to the origin.
      const Long3 d = long3(towards);
      ASSERT_GT(length(d), 0);
      ASSERT_LT(length(cross(d, expected.point)), 1e-6L * length(d) * length(expected.point));
      ASSERT_LT(dot(d, expected.point), 0);
      ASSERT_NEAR(distance2, static_cast<double>(dot(expected.point, expected.point)), 1e-9 * distance2);
    }
  }

  void expect_weights(const DifferenceSimplex& s) {
    const std::array<double, 4> w = weights_of_origin(s);
    Long3 sum{};
    long double total = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_GT(w[i], 0);
      total += wide(w[i]);
      for (std::size_t k = 0; k < 3; ++k) sum[k] += wide(w[i]) * long3(s.vertex[i].at)[k];
    }
    EXPECT_LT(length(sum), 1e-14L + 1e-9L * total);
  }

  Random random_{tests::chosen_seed(73)};
  int inside_ = 0;
  std::array<std::array<int, 4>, 4> outside_{};  // by corners before and after
};

TEST_F(ClosestSimplexTest, IsTheNearestOfAllFaces) {
  for (int i = 0; i < 4000; ++i) {
    std::vector<Point3> cloud;
    const int n = static_cast<int>(random_.between(1, 20));
    const Point3 centre{coordinate(), coordinate(), coordinate()};
    for (int k = 0; k < n; ++k)
      cloud.push_back({centre.x + coordinate(), centre.y + coordinate(), centre.z + coordinate()});
    ASSERT_NO_FATAL_FAILURE(search(cloud)) << i;
  }
  EXPECT_GT(inside_, 500);
  for (std::size_t before = 1; before < 4; ++before) {
    for (std::size_t after = 0; after <= std::min<std::size_t>(before, 2); ++after) {
      // Back to an older corner or to the newest alone is rare, but happens.
      EXPECT_GT(outside_[before][after], after == 0 ? 0 : 50) << before + 1 << " to " << after + 1;
    }
  }
}

TEST_F(ClosestSimplexTest, ASingleVertex) {
  DifferenceSimplex s;
  s.count = 1;
  s.vertex[0] = vertex({1, -2, 3}, 7);
  Point3 towards;
  double distance2 = 0;
  ASSERT_TRUE(reduce_to_closest_face(s, towards, distance2));
  EXPECT_EQ(distance2, 14);
  EXPECT_EQ(s.count, 1);
  EXPECT_EQ(s.vertex[0].a, 7u);
  EXPECT_EQ(towards, (Point3{-1, 2, -3}));
}

TEST_F(ClosestSimplexTest, OfASegmentTheEndOrTheMiddle) {
  const auto reduced = [](const Point3& older, const Point3& newest, Point3& towards) {
    DifferenceSimplex s;
    s.count = 2;
    s.vertex[0] = vertex(older, 0);
    s.vertex[1] = vertex(newest, 1);
    double distance2 = 0;
    EXPECT_TRUE(reduce_to_closest_face(s, towards, distance2));
    EXPECT_EQ(distance2, towards.x * towards.x + towards.y * towards.y);
    return s;
  };
  Point3 towards;
  EXPECT_EQ(reduced({4, 0, 0}, {1, 0, 0}, towards).vertex[0].a, 1u);
  EXPECT_EQ(towards, (Point3{-1, 0, 0}));
  EXPECT_EQ(reduced({1, 0, 0}, {4, 0, 0}, towards).vertex[0].a, 0u);
  EXPECT_EQ(towards, (Point3{-1, 0, 0}));
  EXPECT_EQ(reduced({-1, 2, 0}, {1, 2, 0}, towards).count, 2);
  EXPECT_EQ(towards, (Point3{0, -2, 0}));
}

// In twice the precision: distances from the origin that doubles lose.
TEST_F(ClosestSimplexTest, InDoubleDoubles) {
  for (int i = 0; i < 4000; ++i) {
    // A triangle nearly through the origin, then a corner on the origin's side of it.
    const double height = std::ldexp(random_.uniform(0.5, 1) * (random_.below(2) ? 1 : -1), -70);
    const std::array<Point3, 4> corners{
        Point3{2, -1, 1}, {-1, 2, 1}, {-1, -1, 1}, {0.25, 0.125, height > 0 ? 0.0 : 2.0}};
    DifferenceSimplexOf<DoubleDouble> s;
    Vector3<DoubleDouble> towards;
    for (std::size_t k = 0; k < 4; ++k) {
      DifferenceVertexOf<DoubleDouble>& v = s.vertex[static_cast<std::size_t>(s.count++)];
      v.a = static_cast<std::uint32_t>(k);
      v.at = {corners[k].x, corners[k].y, DoubleDouble(corners[k].z) - DoubleDouble(1, -height)};
      DoubleDouble distance2;
      ASSERT_EQ(reduce_to_closest_face(s, towards, distance2), k < 3);
      if (k != 2) continue;
      ASSERT_EQ(s.count, 3);
      ASSERT_NEAR(nearest(distance2), height * height, 1e-9 * height * height);
      ASSERT_EQ(towards.z.high > 0, height < 0);
      ASSERT_LT(std::fabs(towards.x.high) + std::fabs(towards.y.high), 1e-9 * std::fabs(towards.z.high));
    }
    ASSERT_EQ(s.count, 4);
    const std::array<DoubleDouble, 4> w = weights_of_origin(s);
    const DoubleDouble total = w[0] + w[1] + w[2] + w[3];
    ASSERT_NEAR(nearest(w[3] / total), std::fabs(height), 1e-9 * std::fabs(height));
    ASSERT_EQ(weights_of_nearest(s), w);
  }
}

// Nothing is promised of degenerate simplices but an answer: a face of the simplex, and no vertex made up.
TEST_F(ClosestSimplexTest, DegenerateSimplicesAreReduced) {
  for (int i = 0; i < 20000; ++i) {
    DifferenceSimplex s;
    s.count = static_cast<int>(random_.between(1, 4));
    const double scale = std::ldexp(1.0, static_cast<int>(random_.between(-1, 1)) * 1000);
    std::set<std::uint32_t> numbers;
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(s.count); ++k) {
      const auto whole = [&] { return static_cast<double>(random_.between(-1, 1)) * scale; };
      s.vertex[k] = vertex({whole(), whole(), whole()}, k);
      numbers.insert(k);
    }
    const int before = s.count;
    Point3 towards;
    double distance2 = 0;
    if (!reduce_to_closest_face(s, towards, distance2)) {
      ASSERT_EQ(before, 4);
      continue;
    }
    ASSERT_GE(s.count, 1);
    ASSERT_LE(s.count, std::min(before, 3));
    std::set<std::uint32_t> left;
    for (int k = 0; k < s.count; ++k) left.insert(s.vertex[static_cast<std::size_t>(k)].a);
    ASSERT_EQ(left.size(), static_cast<std::size_t>(s.count));
    ASSERT_TRUE(std::includes(numbers.begin(), numbers.end(), left.begin(), left.end()));
  }
}

}  // namespace
}  // namespace sunder::solid
