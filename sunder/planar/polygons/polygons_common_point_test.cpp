// Known cases of common_point of two polygons. (Small nasty sets: tests/planar/polygons_differential_test.cpp.)
#include <sunder/planar/polygons/polygons_common_point.h>
#include <sunder/planar/polygons/ring_tests.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sunder::planar {
namespace {

using tests::box_ring;

using Ring = std::vector<Point2>;
using Rings = std::vector<Ring>;

// Strictly between, exactly.
bool is_inside(const Ring& box, const ExactPoint2& p) {
  const auto between = [&](double low, const Dyadic& x, double high) {
    return (x - Dyadic(low) * p.denominator).sign() == Sign::positive &&
           (x - Dyadic(high) * p.denominator).sign() == Sign::negative;
  };
  return between(box[0].x, p.x, box[2].x) && between(box[0].y, p.y, box[2].y);
}

void expect_inside_both(const Ring& a, const Ring& b) {
  const std::vector<Polygon> both{Polygon(Rings{a}), Polygon(Rings{b})};
  for (auto* method : {polygons_any_by_grid, polygons_any_by_sweep}) {
    for (const Allowed allowed : {Allowed::nothing, Allowed::touch}) {
      const PolygonsContact found = method(both, {allowed, {}, nullptr}).found.value();
      ASSERT_EQ(found.contact, Relation::overlapping);
      const ExactPoint2 p = common_point(both[0], both[1], found);
      EXPECT_TRUE(is_inside(a, p) && is_inside(b, p));
    }
  }
}

TEST(PolygonsCommonPoint, IsInsideOfBothWhereTheyOverlap) {
  expect_inside_both(box_ring(0, 0, 4, 4), box_ring(3, 3, 9, 9));                           // across
  expect_inside_both(box_ring(0, 0, 4, 4), box_ring(1, 1, 2, 2));                           // one in the other
  expect_inside_both(box_ring(0, 0, 4, 4), box_ring(0, 0, 4, 4));                           // alike
  expect_inside_both(box_ring(0, 0, 4, 4), box_ring(0, 1, 4, 3));                           // borders on borders
  expect_inside_both(box_ring(0, 0, 4, 4), box_ring(std::nextafter(4, 3), 0, 8, 4));        // by one bit
  expect_inside_both(box_ring(0, 0, 0x1p-1074, 0x1p-1074), box_ring(-1, -1, 1, 0x1p1000));  // of any scale
}

// Not where edges cross in a vertex of both, with nothing in common around it.
TEST(PolygonsCommonPoint, IsNotSoughtWhereHolesHoldAllOfIt) {
  const std::vector<Polygon> both{Polygon(Rings{{{1, 1}, {1, 7}, {5, 7}, {5, 1}}, {{1, 5}, {3, 5}, {2, 4}}}),
                                  Polygon(Rings{{{-1, 5}, {5, 5}, {5, 1}, {-1, 1}}, {{1, 5}, {2, 4}, {1, 3}}})};
  for (auto* method : {polygons_any_by_boxes, polygons_any_by_grid, polygons_any_by_sweep}) {
    for (const Allowed allowed : {Allowed::nothing, Allowed::shared_endpoint, Allowed::touch}) {
      const PolygonsContact found = method(both, {allowed, {}, nullptr}).found.value();
      const Point2 p = nearest(common_point(both[0], both[1], found));  // exactly it
      for (const Polygon& polygon : both) {
        EXPECT_EQ(where_in_ring(polygon, 0, p), Sign::positive);
        EXPECT_EQ(where_in_ring(polygon, 1, p), Sign::negative);
      }
    }
  }
}

TEST(PolygonsCommonPoint, OfBordersInCommonIsTheMiddle) {
  const Polygon a(Rings{box_ring(0, 0, 4, 4)}), b(Rings{box_ring(4, 1, 6, 2)});
  const PolygonsContact found = polygons_contact(a, b).found.value();
  ASSERT_EQ(found.kind, ContactKind::overlap);
  const ExactPoint2 p = common_point(a, b, found);
  EXPECT_EQ(nearest_ratio(p.x, p.denominator), 4);
  EXPECT_EQ(nearest_ratio(p.y, p.denominator), 1.5);
}

}  // namespace
}  // namespace sunder::planar
