// How the work of the hull grows: counted side tests.
#include <tests/support/growth.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <sunder/solid/hull/convex_hull.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

// A cone with its tip broken off: a second apex so near to the first that the ring is half done when it comes, and that
// sees a third of the facets then.
std::vector<Point3> blunt_cone(std::size_t n) {
  std::vector<Point3> points = solid_shapes::cone(n - 1);
  const double size = 64 / static_cast<double>(n), near = std::min(size * size, 0.125);
  points.push_back({near, 0, 1 - near / 2});
  return points;
}

// The same with as many points more inside, under the tip.
std::vector<Point3> filled_cone(std::size_t n, Random& random) {
  std::vector<Point3> points = blunt_cone(n / 2);
  const double size = 64 / static_cast<double>(n), near = std::min(size * size, 0.125);
  while (points.size() < n) {
    const Point2 p = on_circle(random.unit(), near * random.unit());
    points.push_back({p.x, p.y, 1 - near * random.unit()});
  }
  return points;
}

// Points (t, t^2, 0) whose t fall from 1 to 2^-range by equal factors, and two more: with t^2 and t^3 products vanish,
// and whatever is furthest from a chord leaves nearly all points on one side.
std::vector<Point3> geometric_parabola(std::size_t n, double range) {
  std::vector<Point3> points{{0.5, 0.6, 1}, {-1, 1, 0}};
  const double by = std::exp2(-range / static_cast<double>(n));
  for (double t = 1; points.size() < n; t *= by) points.push_back({t, t * t, 0});
  return points;
}

// k is 0: the answer is of size n.
TEST(SolidHullGrowth, OfTheShapes) {
  Growth growth(6.2);
  const int greatest_power = scaled_count(17, 12) >= 17 ? 17 : 12;
  for (int power = least_growth_power; power <= greatest_power; ++power) {
    const std::size_t n = std::size_t{1} << power;
    const auto add = [&](std::string_view name, const std::vector<Point3>& points) {
      const double size = static_cast<double>(points.size());
      growth.add(std::string(name), size, 0, solid::convex_hull(points).side_tests);
    };
    Random random(20261124);
    for (const SolidShape& shape : all_solid_shapes()) add(shape.name, shape.make(n, random));
    add("blunt cone", blunt_cone(n));
    add("filled cone", filled_cone(n, random));
    for (const double range : {100.0, 400.0}) {
      std::vector<Point3> parabola = geometric_parabola(n, range);
      add("geometric parabola", parabola);
      for (std::size_t k = n - 1; k > 0; --k) std::swap(parabola[k], parabola[random.below(k + 1)]);
      add("geometric parabola, in any order", parabola);
    }
  }
  growth.expect_no_growth();
}

// Scaled along one axis, points take as many side tests, or hardly more.
TEST(SolidHullGrowth, OneAxisIsScaled) {
  Random random(20261128);
  const std::size_t n = 1 << 12;
  const std::vector<Point3> sphere = solid_shapes::sphere(n, random);
  const auto least = static_cast<double>(solid::convex_hull(sphere).side_tests);
  for (const double by : {0x1p600, 0x1p-600}) {
    for (double Point3::* const axis : {&Point3::x, &Point3::y, &Point3::z}) {
      std::vector<Point3> scaled = sphere;
      for (Point3& p : scaled) p.*axis *= by;
      EXPECT_LE(static_cast<double>(solid::convex_hull(scaled).side_tests), 1.15 * least);
    }
  }
}

}  // namespace
}  // namespace sunder::tests
