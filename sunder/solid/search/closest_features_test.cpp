#include <sunder/base/random.h>
#include <sunder/solid/search/closest_features.h>

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <vector>

namespace sunder::solid {
namespace {

struct TwoSets {
  std::vector<Point3> a, b;
};

template <class T>
VertexSet<T> vertex_set(const std::vector<Point3>& points) {
  VertexSet<T> set;
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    set.add(10 * k + 1, {T(points[k].x), T(points[k].y), T(points[k].z)});
  }
  return set;
}

template <class T>
FeatureVertices closest(const TwoSets& points) {
  return closest_features(vertex_set<T>(points.a), vertex_set<T>(points.b));
}

// Those that are named.
std::array<std::vector<Posed3>, 2> named(const TwoSets& points, const FeatureVertices& f) {
  static const Affine3 identity;
  std::array<std::vector<Posed3>, 2> of;
  for (std::size_t k = 0; k < f.count_a; ++k) of[0].push_back({points.a[f.of_a(k) / 10], &identity, false});
  for (std::size_t k = 0; k < f.count_b; ++k) of[1].push_back({points.b[f.of_b(k) / 10], &identity, false});
  return of;
}

std::optional<ExactWay> way_of(const TwoSets& points, const FeatureVertices& f) {
  const auto [a, b] = named(points, f);
  return exact_way(a, b);
}

TEST(ClosestFeaturesTest, Known) {
  const std::vector<Point3> square{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}}, edge{{1, -9, 3}, {1, 9, 3}};
  const FeatureVertices corner = closest<Dyadic>({square, {{-3, -4, 0}}});
  EXPECT_EQ(corner.count_a, 1);
  EXPECT_EQ(corner.vertices[0], 1u);
  const FeatureVertices side = closest<Dyadic>({square, {{1, 5, 0}, {1, 7, 9}}});
  EXPECT_EQ(side.count_a, 2);
  EXPECT_EQ(side.vertices[0], 21u);
  EXPECT_EQ(side.vertices[1], 31u);
  EXPECT_EQ(side.count_b, 1);
  // An edge above the square, in any numbers.
  const TwoSets across{square, edge};
  for (const FeatureVertices& f : {closest<Dyadic>(across), closest<double>(across), closest<DoubleDouble>(across)}) {
    ASSERT_TRUE(way_of(across, f));
    EXPECT_EQ(way_of(across, f)->way.squared(), Dyadic(9.0) * way_of(across, f)->way.denominator);
  }
}

// Exactly: no vertex is beyond the way, so it is the shortest. In floating point: as near, but for the last digits.
TEST(ClosestFeaturesTest, NothingIsNearer) {
  Random random(12);
  constexpr int apart = 3000;
  int same = 0;
  std::array<std::array<int, 4>, 4> counts{};
  for (int i = 0; i < apart; ++i) {
    const bool is_grid = i % 3 == 0;
    TwoSets points;
    const auto fill = [&](std::vector<Point3>& set, double shift) {
      for (std::uint64_t n = 1 + random.below(4); n > 0; --n) {
        const auto coordinate = [&] {
          return is_grid ? static_cast<double>(random.between(-2, 2)) : random.uniform(-1, 1);
        };
        set.push_back({coordinate() + shift, coordinate(), coordinate()});
      }
    };
    fill(points.a, 0);
    fill(points.b, is_grid ? static_cast<double>(random.between(5, 7)) : random.uniform(2.001, 3));
    const FeatureVertices f = closest<Dyadic>(points);
    const std::optional<ExactWay> found = way_of(points, f);
    ASSERT_TRUE(found) << i;  // they are apart along x
    const auto further = [&](const Point3& from, const Point3& to) {
      return dot(found->way.way, coordinates<Dyadic>(to) - coordinates<Dyadic>(from)).sign();
    };
    for (const Point3& p : points.a) ASSERT_NE(further(points.a[f.of_a(0) / 10], p), Sign::positive) << i;
    for (const Point3& p : points.b) ASSERT_NE(further(points.b[f.of_b(0) / 10], p), Sign::negative) << i;
    ++counts[f.count_a][f.count_b];
    for (std::size_t k = 0; k < std::size_t{f.count_a} + f.count_b; ++k) {
      ASSERT_EQ(found->weight[k].sign(), Sign::positive) << i;
    }
    for (const FeatureVertices& g : {closest<double>(points), closest<DoubleDouble>(points)}) {
      const std::optional<ExactWay> other = way_of(points, g);
      if (!other) continue;  // a weight that only rounding made positive
      const double square = nearest_ratio(found->way.squared(), found->way.denominator);
      EXPECT_NEAR(nearest_ratio(other->way.squared(), other->way.denominator), square, 1e-12 * square) << i;
      ++same;
    }
  }
  EXPECT_GT(same, 2 * apart - apart / 20);
  for (std::size_t p = 1; p < 4; ++p) {
    for (std::size_t q = 1; p + q <= 4; ++q) EXPECT_GT(counts[p][q], apart / 100) << p << " " << q;
  }
}

}  // namespace
}  // namespace sunder::solid
