#include <sunder/certificate/common_point.h>

#include <gtest/gtest.h>

namespace sunder {
namespace {

const Affine3 in_place, lifted{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 1}};

TEST(WeightsTest, OfOneIndexAddUp) {
  Weights weights{{{4, 1.0}}, 8.0};
  weights.add(7, 2.0);
  weights.add(4, 5.0);
  ASSERT_EQ(weights.parts.size(), 2u);
  EXPECT_EQ(weights.parts[0].numerator, Dyadic(6.0));
  EXPECT_EQ(weights.parts[1].index, 7u);
  const Vector3<Dyadic> sum =
      numerators_of(weights, [](std::uint32_t k) { return Vector3<Dyadic>{static_cast<double>(k), 1.0, 0.0}; });
  EXPECT_EQ(sum.x, Dyadic(38.0));
  EXPECT_EQ(sum.y, Dyadic(8.0));
}

TEST(CommonPointOf, SegmentAndTriangle) {
  // A segment goes through a triangle, which is lifted, a quarter of its way.
  const auto segment = [](std::uint32_t v) { return Posed3{{1, 1, v == 3 ? 0.0 : 4.0}, &in_place, false}; };
  const auto triangle = [](std::uint32_t v) {
    return Posed3{{v == 1 ? 4.0 : 0.0, v == 2 ? 4.0 : 0.0, 0}, &lifted, false};
  };
  struct By {
    Posed3 (*at)(std::uint32_t);
    Posed3 operator[](std::uint32_t v) const { return at(v); }
  };
  const CommonVertices evidence{2, 3, {3, 5, 0, 1, 2}};
  const CommonPoint point = common_point(evidence, By{segment}, By{triangle});
  EXPECT_EQ(nearest(point.at), (Point3{1, 1, 1}));
  ASSERT_EQ(point.of_a.parts.size(), 2u);
  ASSERT_EQ(point.of_b.parts.size(), 3u);
  EXPECT_EQ(point.of_a.parts[1].index, 5u);
  EXPECT_EQ(nearest_ratio(point.of_a.parts[0].numerator, point.of_a.denominator), 0.75);
  EXPECT_EQ(nearest_ratio(point.of_b.parts[0].numerator, point.of_b.denominator), 0.5);
  EXPECT_EQ(nearest_ratio(point.of_b.parts[2].numerator, point.of_b.denominator), 0.25);
}

TEST(CommonPointOf, WayBetweenPoints) {
  const PointOf p{{1.0, 2.0, 3.0, 2.0}, {}}, q{{3.0, 2.0, 3.0, 4.0}, {}};
  const std::array<Dyadic, 3> way = way_between(p, q);  // times 8
  EXPECT_EQ(way[0], Dyadic(2.0));
  EXPECT_EQ(way[1], Dyadic(-4.0));
  EXPECT_EQ(way[2], Dyadic(-6.0));
}

}  // namespace
}  // namespace sunder
