#include <sunder/number/exact_vector.h>
#include <sunder/solid/exact/exact_gjk.h>

#include <gtest/gtest.h>

#include <vector>

namespace sunder::solid {
namespace {

// The hull of a few points against the origin: each step takes the point that is least far along the way.
struct Points {
  std::vector<Point3> points;
  int steps = 0;

  static Vector3<Dyadic> exact(const Point3& p) { return {p.x, p.y, p.z}; }

  std::array<std::uint32_t, 2> extreme(const ExactNearest& nearest) {
    ++steps;
    std::uint32_t least = nearest.of_b();
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const Vector3<Dyadic> further = exact(points[i]) - exact(points[least]);
      if (dot(nearest.closest.way.way, further).sign() == Sign::negative) least = i;
    }
    return {0, least};
  }
  void join(ExactNearest& nearest, const std::array<std::uint32_t, 2>& next) const {
    nearest.b.add(next[1], exact(points[next[1]]));
  }
};

struct FoundNearest {
  bool apart;
  ExactNearest nearest = ExactNearest::to_origin();
};

FoundNearest found(Points points) {
  FoundNearest result;
  points.join(result.nearest, {0, 0});
  std::uint32_t ways = 0;
  result.apart = exact_gjk(points, result.nearest, ways);
  EXPECT_LE(points.steps, 8);
  EXPECT_GT(ways, 0u);
  return result;
}

std::vector<Point3> cube_at(double x, double y, double z) {
  std::vector<Point3> points;
  for (int k = 0; k < 8; ++k) {
    points.push_back({x + (k & 1 ? 1 : -1), y + (k & 2 ? 1 : -1), z + (k & 4 ? 1 : -1)});
  }
  return points;
}

TEST(ExactGjk, FindsTheNearestPointOfACube) {
  const auto expect_square = [](const std::vector<Point3>& points, double square) {
    const FoundNearest f = found({points});
    ASSERT_TRUE(f.apart);
    const ShortestWay<Dyadic>& way = f.nearest.closest.way;
    EXPECT_EQ(way.squared(), Dyadic(square) * way.denominator);
    EXPECT_EQ(way.reach.sign(), Sign::positive);  // from the origin to the cube
    EXPECT_EQ(f.nearest.b.count, f.nearest.closest.features.count_b);
  };
  expect_square(cube_at(4, 3, 2), 9 + 4 + 1);                                                  // a vertex
  expect_square(cube_at(-4, 3, 0.5), 9 + 4);                                                   // an edge
  for (const double side : {1.125, -1.125}) expect_square(cube_at(0.25, -0.5, side), 0x1p-6);  // a facet
}

TEST(ExactGjk, SaysThatTheHullHoldsTheOrigin) {
  const FoundNearest facet = found({cube_at(0.25, -0.5, 1)});
  EXPECT_FALSE(facet.apart);
  EXPECT_TRUE(is_zero(facet.nearest.closest.way.way) || facet.nearest.closest.way.reach.sign() == Sign::zero);
  EXPECT_FALSE(found({cube_at(0.25, -0.5, 0.125)}).apart);                       // its inside
  EXPECT_FALSE(found({{{-1, -1, -1}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}}}).apart);  // of a tetrahedron
}

}  // namespace
}  // namespace sunder::solid
