// How the work of the common part of half-planes, and of convex polygons, grows.
#include <tests/support/growth.h>
#include <tests/support/shapes.h>

#include <sunder/base/random.h>
#include <sunder/planar/object/constraints.h>
#include <sunder/planar/region/convex_polygon_intersection.h>
#include <sunder/planar/region/half_plane_intersection.h>

#include <array>
#include <functional>
#include <numbers>
#include <vector>

namespace sunder::tests {
namespace {

using planar::Constraints;
using planar::ConvexPolygon;

// a x + b y <= c with (a, b) at this part of a turn.
Constraint at(double turn, double c) {
  const Point2 normal = on_circle(turn);
  return {normal.x, normal.y, c};
}

TEST(RegionsGrowth, OfHalfPlanes) {
  using Make = std::function<Constraint(std::size_t, double, Random&)>;  // of number i of n
  struct Family {
    const char* name;
    Make make;
  };
  const std::array families{
      Family{"tangents", [](std::size_t i, double n, Random&) { return at(number(i) / n, 1); }},
      Family{"through one point", [](std::size_t i, double n, Random&) { return at(number(i) / n, 0); }},
      Family{"empty", [](std::size_t i, double n, Random&) { return at(number(i) / n, -1); }},
      Family{"parallels", [](std::size_t i, double, Random&) { return Constraint{i % 2 ? 1. : -1., 0, number(i)}; }},
      Family{"of a parabola",
             [](std::size_t i, double, Random&) { return Constraint{2 * number(i), -1, number(i) * number(i)}; }},
      Family{"in few directions",
             [](std::size_t i, double, Random& random) { return at(number(i % 7) / 7, random.unit()); }},
      Family{"of sixteen, drawn in",
             [](std::size_t i, double n, Random&) {
               return at(number(i % 16) / 16 + 0.001 * number(i) / n, 2 - number(i) / n);
             }},
      Family{"anyhow", [](std::size_t, double, Random& random) { return at(random.unit(), 1 + random.unit()); }}};
  Growth growth(1.3);
  for (const Family& family : families) {
    for (const bool evidence : {false, true}) {
      for (int power = least_growth_power; power <= greatest_growth_power(); power += 2) {
        Random random(20261123);
        const std::size_t n = std::size_t{1} << power;
        std::vector<Constraint> given;
        for (std::size_t i = 0; i < n; ++i) given.push_back(family.make(i, number(n), random));
        growth.add(std::string(family.name) + (evidence ? ", evidence" : ""), number(n), 0,
                   half_plane_intersection(Constraints(given), {evidence}).cost.probes);
      }
    }
  }
  growth.expect_no_growth();
}

ConvexPolygon regular(std::uint32_t vertices, double turn, double radius, const Point2& center) {
  return regular_polygon(vertices, radius, 2 * std::numbers::pi * turn, center);
}

// N is the number of all vertices.
TEST(RegionsGrowth, OfConvexPolygons) {
  struct Family {
    const char* name;
    std::size_t vertices;                                        // of a polygon
    std::function<ConvexPolygon(double, double, Random&)> make;  // of number i of n
  };
  const Point2 origin{0, 0};
  const std::array families{
      Family{"turned", 4, [&](double i, double n, Random&) { return regular(4, i / n, 1, origin); }},
      Family{"nested", 4, [&](double i, double, Random&) { return regular(4, 0.1, 1 + i, origin); }},
      Family{"nested, large", 64, [&](double i, double, Random&) { return regular(64, 0.1, 1 + i, origin); }},
      Family{"on a ring", 16, [&](double i, double n, Random&) { return regular(16, 0, 1.5, on_circle(i / n)); }},
      Family{"on a ring, empty", 16,
             [&](double i, double n, Random&) { return regular(16, 0, 0.5, on_circle(i / n)); }},
      Family{"through one point", 8, [&](double i, double, Random&) { return regular(8, 0, 1 + i, {-1 - i, 0}); }},
      Family{"anyhow", 8, [&](double, double, Random& random) {
               return regular(8, random.unit(), 2 + random.unit(), {random.unit(), random.unit()});
             }}};
  Growth growth(1.3);
  for (const Family& family : families) {
    for (int power = least_growth_power; power <= greatest_growth_power(); power += 2) {
      Random random(20261123);
      const std::size_t n = (std::size_t{1} << power) / family.vertices;
      std::vector<ConvexPolygon> polygons;
      for (std::size_t i = 0; i < n; ++i) polygons.push_back(family.make(number(i), number(n), random));
      growth.add(family.name, std::ldexp(1, power), 0, convex_polygon_intersection(polygons).cost.probes);
    }
  }
  growth.expect_no_growth();
}

}  // namespace
}  // namespace sunder::tests
