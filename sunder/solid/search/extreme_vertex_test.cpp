// The exact walk against all vertices in integers, from every start, to both ends.
#include <sunder/base/random.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace sunder::solid {
namespace {

using Whole = boost::multiprecision::cpp_int;

// x in units of 2^-1074.
Whole whole(double x) {
  int e = 0;
  const Whole m = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &e), 53));
  e += 1074 - 53;
  return e < 0 ? Whole(m >> static_cast<unsigned>(-e)) : Whole(m << static_cast<unsigned>(e));  // no bit is lost
}

// Direction . image of each vertex, exactly, up to a factor. The translation does not matter for one body.
std::vector<Whole> heights(const ConvexPolyhedron& body, const Pose& pose, const Point3& d) {
  const auto& m = pose.affine().linear;
  std::array<Whole, 3> pulled;
  for (std::size_t j = 0; j < 3; ++j) {
    pulled[j] = whole(m[j]) * whole(d.x) + whole(m[3 + j]) * whole(d.y) + whole(m[6 + j]) * whole(d.z);
  }
  std::vector<Whole> out;
  for (const Point3& p : body.vertices()) {
    out.push_back(pulled[0] * whole(p.x) + pulled[1] * whole(p.y) + pulled[2] * whole(p.z));
  }
  return out;
}

class ExtremeVertexTest : public testing::Test {
 protected:
  Point3 some_point(double scale, bool whole_numbers) {
    const auto coordinate = [&] {
      return whole_numbers ? static_cast<double>(random_.between(-2, 2)) * scale : random_.uniform(-1, 1) * scale;
    };
    return {coordinate(), coordinate(), coordinate()};
  }

  Pose some_pose(bool whole_numbers) {
    while (true) {
      Affine3 pose;
      for (double& x : pose.linear)
        x = whole_numbers ? static_cast<double>(random_.between(-2, 2)) : random_.uniform(-1, 1);
      try {
        return Pose::from_matrix(pose.linear, {1, -2, 0.1});
      } catch (const std::exception&) {  // singular
      }
    }
  }

  // Walks from every vertex to both ends. Returns how many vertices tie for the greatest.
  int expect_extremes(const ConvexPolyhedron& body, const Pose& pose, const Point3& d, bool exact_numbers) {
    const std::vector<Whole> height = heights(body, pose, d);
    const auto [low, high] = std::minmax_element(height.begin(), height.end());
    const Placed placed(body, pose);
    const WorldDirection direction = exact_numbers ? WorldDirection(Vector3<Dyadic>{d.x, d.y, d.z}) : WorldDirection(d);
    const std::uint32_t n = static_cast<std::uint32_t>(height.size());
    for (std::uint32_t start = 0; start < n; ++start) {
      Along along(direction, placed.pose, placed.tame);
      const std::uint32_t top = extreme_vertex_from(placed, along, End::greatest, start, cost_, tally_);
      const std::uint32_t bottom = extreme_vertex_from(placed, along, End::least, start, cost_, tally_);
      EXPECT_EQ(height.at(top), *high);
      EXPECT_EQ(height.at(bottom), *low);
      // Where it is extreme already it stays: a certificate names the vertex that was proposed.
      EXPECT_TRUE(top == start || height[start] != *high);
      EXPECT_TRUE(bottom == start || height[start] != *low);
      ++walks_;
      steps_ += top != start;
    }
    return static_cast<int>(std::count(height.begin(), height.end(), *high));
  }

  Random random_{tests::chosen_seed(71)};
  Cost cost_;
  StageTally tally_;
  int walks_ = 0, steps_ = 0;
};

TEST_F(ExtremeVertexTest, IsExtremeExactly) {
  std::array<int, 4> dimensions{};
  int ties = 0, asked = 0;
  for (int i = 0; i < 300; ++i) {
    const bool whole_numbers = i % 2;
    const int n = static_cast<int>(random_.between(1, i % 20 == 0 ? 200 : 12));
    std::vector<Point3> points;
    for (int k = 0; k < n; ++k) points.push_back(some_point(1, whole_numbers));
    const ConvexPolyhedron body(points);
    ++dimensions[static_cast<std::size_t>(body.dimension())];
    const Pose pose = some_pose(whole_numbers);
    for (int k = 0; k < 4; ++k) {
      Point3 d = some_point(1, whole_numbers);
      if (k == 3) d = {std::ldexp(d.x, -70), d.y, 0};  // not tame
      ties += expect_extremes(body, pose, d, k == 2) > 1;
      ++asked;
    }
  }
  for (const int count : dimensions) EXPECT_GT(count, 5);
  EXPECT_GT(ties, asked / 20);
  EXPECT_GT(steps_, walks_ / 2);
  EXPECT_GT(tally_.rounded, 1000u);
  EXPECT_GT(tally_.interval, 1000u);
  EXPECT_GT(tally_.exact, 100u);
}

// A roof over a polygon of many corners: the hierarchy is asked about the ends of its ridge, which have so many
// neighbours, and they tie, upwards with each other and along the normals of the sides with corners.
TEST_F(ExtremeVertexTest, ManyNeighboursAndTies) {
  const auto corner = [](double i) { return Point3{i, 2500 - i * i, 0}; };
  std::vector<Point3> points{{-10, 0, 100}, {10, 0, 100}, {-50, 0, 0}, {50, 0, 0}};
  for (double i = -49; i < 50; ++i) {
    points.push_back(corner(i));
    points.push_back({i, -corner(i).y, 0});
  }
  const ConvexPolyhedron body(points);
  EXPECT_EQ(expect_extremes(body, Pose(), {0, 0, 1}, true), 2);
  for (const double i : {-40.0, -5.0, 7.0, 30.0}) {
    const double end = i < 0 ? -10 : 10;
    const Point3 outwards{100 * (2 * i + 1), 100, 2500 - i * i + (2 * i + 1) * (i - end)};
    EXPECT_EQ(expect_extremes(body, Pose(), outwards, true), 3) << i;
  }
}

// A row of neighbours whose heights differ by the last bits only: no plateau stops the walk.
TEST_F(ExtremeVertexTest, WalksOverNearTies) {
  std::vector<Point3> points;
  for (int i = 0; i < 64; ++i) {
    const double t = i / 64.0;  // on a parabola, exactly
    points.push_back({t, t * t, 0});
    points.push_back({t, t * t, 1});
  }
  const ConvexPolyhedron body(points);
  for (const double tilt : {0x1p-52, 0x1p-60, 0x1p-200, 0.0}) {
    for (const double up : {1.0, -1.0}) {
      expect_extremes(body, Pose(), {tilt, 0x1p-50 * tilt, up}, false);
      expect_extremes(body, Pose(), {1, tilt, up * tilt}, false);
      expect_extremes(body, Pose(), {tilt, up, tilt}, false);
    }
  }
}

TEST_F(ExtremeVertexTest, TheEndsOfTheRangeOfDoubles) {
  for (const double size : {5e-324, 1e-310, 1e-160, 1e160, std::numeric_limits<double>::max() / 2}) {
    for (const bool whole_numbers : {true, false}) {
      std::vector<Point3> points;
      for (int k = 0; k < 40; ++k) points.push_back(some_point(size, whole_numbers));
      const ConvexPolyhedron body(points);
      const Pose pose = some_pose(whole_numbers);
      EXPECT_EQ(Placed(body, pose).tame, false) << size;
      for (const double length : {5e-324, 1.0, 1e308}) {
        expect_extremes(body, pose, some_point(length, false), false);
        expect_extremes(body, pose, some_point(length / 2, true), true);
      }
    }
  }
}

TEST_F(ExtremeVertexTest, FiltersDecideInGeneral) {
  std::vector<Point3> points;
  while (points.size() < 400) {
    const Point3 p = some_point(1, false);
    const double r = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    if (r > 0.1) points.push_back({p.x / r, p.y / r, p.z / r});
  }
  const ConvexPolyhedron body(points);
  const int count = tests::scaled_count(50, 10);
  for (int i = 0; i < count; ++i) expect_extremes(body, some_pose(false), some_point(1, false), false);
  EXPECT_EQ(tally_.exact, 0u);
  EXPECT_EQ(tally_.interval, 0u);
  EXPECT_GT(tally_.rounded, 20u * static_cast<unsigned>(count));
}

TEST_F(ExtremeVertexTest, PlacedKnowsWhenItIsTame) {
  const ConvexPolyhedron body(std::vector<Point3>{{1, 2, 3}, {0, 0, 0}, {5, 1, 1}});
  EXPECT_TRUE(Placed(body, Pose()).tame);
  EXPECT_FALSE(Placed(body, Pose::from_matrix({1e-200, 0, 0, 0, 1e-200, 0, 0, 0, 1e-200}, {})).tame);
  const Pose pose = Pose::from_matrix({1, 2, 0, 0, 1, 0, 0, 0, 1}, {4, 5, 6});
  const Placed placed(body, pose);
  EXPECT_EQ(placed[1].point, body.vertices()[1]);
  EXPECT_EQ(placed[1].pose, &pose.affine());
  EXPECT_EQ(placed[1].tame, placed.tame);
}

}  // namespace
}  // namespace sunder::solid
