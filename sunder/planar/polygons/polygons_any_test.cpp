// Known cases of polygons_contact and polygons_any, and larger sets on which the methods agree with one another.
// (Small nasty sets against the scan: tests/planar/polygons_differential_test.cpp.)
#include <sunder/base/random.h>
#include <sunder/planar/polygons/polygon_edges.h>
#include <sunder/planar/polygons/polygons_all.h>
#include <sunder/planar/polygons/polygons_any.h>
#include <sunder/planar/polygons/ring_tests.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sunder::planar {
namespace {

using tests::box_ring;

using Ring = std::vector<Point2>;
using Rings = std::vector<Ring>;

PolygonsContact contact_in(const PolygonsAnswer& answer) { return answer.found.value_or(PolygonsContact()); }

// As all methods say. Relation::none: they do not meet.
PolygonsContact contact(const Rings& a, const Rings& b) {
  const std::vector<Polygon> set{Polygon(a), Polygon(b)};
  const PolygonsContact found = contact_in(polygons_contact(set[0], set[1]));
  EXPECT_EQ(found.contact, contact_in(polygons_contact_by_scan(set[0], set[1])).contact);
  EXPECT_EQ(found.contact, contact_in(polygons_contact(set[1], set[0])).contact);
  for (const Allowed allowed : {Allowed::nothing, Allowed::shared_endpoint, Allowed::touch}) {
    for (auto* method :
         {polygons_any, polygons_any_by_boxes, polygons_any_by_grid, polygons_any_by_sweep, polygons_any_by_scan}) {
      const PolygonsAnswer answer = method(set, {allowed, {}, nullptr});
      EXPECT_EQ(answer.meet(), counts(found, allowed));
      if (answer.meet()) {
        EXPECT_EQ(answer.found->contact, found.contact);
      }
      const std::array<std::uint32_t, 2> one_group{4, 4};
      EXPECT_FALSE(method(set, {allowed, one_group, nullptr}).meet());
    }
  }
  return found;
}

TEST(PolygonsContact, KnownCases) {
  const Ring unit = box_ring(0, 0, 4, 4);
  EXPECT_EQ(contact({unit}, {box_ring(5, 0, 9, 4)}).contact, Relation::none);
  const PolygonsContact at_corner = contact({unit}, {box_ring(4, 4, 9, 9)});
  EXPECT_EQ(at_corner.contact, Relation::touching);
  EXPECT_EQ(at_corner.kind, ContactKind::shared_endpoint);
  const PolygonsContact along = contact({unit}, {box_ring(4, 1, 9, 3)});
  EXPECT_EQ(along.contact, Relation::touching);
  EXPECT_EQ(along.kind, ContactKind::overlap);
  EXPECT_EQ(contact({unit}, {{{4, 2}, {6, 1}, {6, 3}}}).kind, ContactKind::touch);
  EXPECT_EQ(contact({unit}, {box_ring(3, 3, 9, 9)}).contact, Relation::overlapping);
  EXPECT_EQ(contact({unit}, {unit}).contact, Relation::overlapping);
  // Corners at corners only, and yet across: no two edges cross.
  EXPECT_EQ(contact({unit}, {{{0, 0}, {4, 4}, {4, 6}, {-1, 0}}}).contact, Relation::overlapping);
  // Inside, with nothing in common: a vertex shows it.
  const PolygonsContact inside = contact({box_ring(1, 1, 2, 2)}, {unit});
  EXPECT_EQ(inside.contact, Relation::overlapping);
  EXPECT_EQ(inside.kind, ContactKind::none);
  EXPECT_TRUE(inside.i_inside);
}

TEST(PolygonsContact, HolesAndIslands) {
  const Rings frame{box_ring(0, 0, 20, 20), box_ring(5, 5, 15, 15)};
  EXPECT_EQ(contact(frame, {box_ring(6, 6, 9, 9)}).contact, Relation::none);        // in the hole
  EXPECT_EQ(contact(frame, {box_ring(5, 5, 15, 15)}).contact, Relation::touching);  // fills it
  EXPECT_EQ(contact(frame, {box_ring(5, 5, 15, 16)}).contact, Relation::overlapping);
  EXPECT_EQ(contact(frame, {box_ring(1, 1, 2, 2)}).contact, Relation::overlapping);
  EXPECT_EQ(contact(frame, {box_ring(-9, -9, 29, 29)}).contact, Relation::overlapping);
  EXPECT_EQ(contact(frame, {box_ring(-9, -9, 29, 29), box_ring(-1, -1, 21, 21)}).contact, Relation::none);  // around it
  const Rings with_island{box_ring(0, 0, 20, 20), box_ring(5, 5, 15, 15), box_ring(8, 8, 12, 12)};
  EXPECT_EQ(contact(with_island, {box_ring(9, 9, 10, 10)}).contact, Relation::overlapping);
  EXPECT_EQ(contact(with_island, {box_ring(5, 5, 15, 15), box_ring(8, 8, 12, 12)}).contact, Relation::touching);
  // One part inside, one far away.
  EXPECT_EQ(contact({box_ring(30, 0, 31, 1), box_ring(1, 1, 2, 2)}, {box_ring(0, 0, 9, 9)}).contact,
            Relation::overlapping);
  // A hole that touches the lower side from inside, above one whose upper side passes there.
  EXPECT_EQ(contact({box_ring(0, 0, 8, 8), {{4, 0}, {6, 4}, {2, 4}}}, {box_ring(-1, -3, 9, 0)}).contact,
            Relation::touching);
  // Of two parts each, one of which they have in common.
  EXPECT_EQ(contact({box_ring(0, 0, 1, 1), box_ring(4, 0, 5, 1)}, {box_ring(4, 0, 5, 1), box_ring(8, 0, 9, 1)}).contact,
            Relation::overlapping);
}

// Edges cross in a vertex of both, where the hole of each holds what the other fills: around that point they have
// nothing in common.
TEST(PolygonsContact, NotchesWhereEdgesCross) {
  // They overlap elsewhere (cases/outcomes/polygons_notched.wkt): that is shown.
  const Rings a{{{1, 1}, {1, 7}, {5, 7}, {5, 1}}, {{1, 5}, {3, 5}, {2, 4}}};
  const Rings b{{{-1, 5}, {5, 5}, {5, 1}, {-1, 1}}, {{1, 5}, {2, 4}, {1, 3}}};
  const PolygonsContact elsewhere = contact(a, b);
  EXPECT_EQ(elsewhere.contact, Relation::overlapping);
  EXPECT_NE(elsewhere.kind, ContactKind::crossing);
  // The holes reach the other side, too, so that the insides are not connected: they only touch.
  const Rings c{{{-4, 0}, {4, 0}, {-2, 6}}, {{0, 0}, {1, 2}, {0, 4}, {-1, 2}}};
  const Rings d{{{0, -4}, {8, -4}, {8, 8}, {0, 8}}, {{0, 0}, {5, -1}, {5, 5}, {0, 4}, {0.5, 2}}};
  const PolygonsContact touching = contact(c, d);
  EXPECT_EQ(touching.contact, Relation::touching);
  EXPECT_EQ(touching.kind, ContactKind::crossing);
  EXPECT_EQ(polygons_count(std::vector{Polygon(c), Polygon(d)}).count.touching, 1u);
  // One of the holes is too small.
  EXPECT_EQ(contact(c, {d[0], {{0, 0}, {5, -1}, {5, 5}, {2, 4}, {0.5, 2}}}).contact, Relation::overlapping);
}

// The question for tracts: borders in common are allowed; the sliver is found.
TEST(PolygonsAny, TractsMayTouchAndNotOverlap) {
  std::vector<Polygon> tracts;
  for (double x = 0; x < 5; ++x) {
    for (double y = 0; y < 5; ++y) tracts.emplace_back(Rings{box_ring(x, y, x + 1, y + 1)});
  }
  for (auto* method : {polygons_any_by_boxes, polygons_any_by_grid, polygons_any_by_sweep, polygons_any_by_scan}) {
    EXPECT_FALSE(method(tracts, {Allowed::touch, {}, nullptr}).meet());
    EXPECT_TRUE(method(tracts, {Allowed::shared_endpoint, {}, nullptr}).meet());
  }
  EXPECT_EQ(polygons_count(tracts).count.touching, 72u);
  EXPECT_EQ(polygons_count(tracts, {Allowed::shared_endpoint, {}, nullptr}).count.touching, 40u);
  tracts[12] = Polygon(Rings{box_ring(2, 2, std::nextafter(3.0, 4.0), 3)});
  for (auto* method : {polygons_any_by_boxes, polygons_any_by_grid, polygons_any_by_sweep, polygons_any_by_scan}) {
    const PolygonsAnswer answer = method(tracts, {Allowed::touch, {}, nullptr});
    EXPECT_EQ(answer.found->contact, Relation::overlapping);
    EXPECT_EQ(answer.found->i, 12u);
    EXPECT_EQ(answer.found->j, 17u);
  }
  EXPECT_EQ(polygons_count(tracts).count.overlapping, 1u);
}

TEST(RingTests, DirectionAndInside) {
  const Polygon frame(Rings{box_ring(0, 0, 9, 9), {{2, 2}, {2, 4}, {4, 4}, {4, 2}}, {{5, 5}, {6, 5}, {6, 6}}});
  EXPECT_TRUE(is_counter_clockwise(frame, 0));
  EXPECT_FALSE(is_counter_clockwise(frame, 1));
  EXPECT_EQ(where_in_ring(frame, 0, {2, 2}), Sign::positive);
  EXPECT_EQ(where_in_ring(frame, 0, {0, 4}), Sign::zero);
  EXPECT_EQ(where_in_ring(frame, 0, {9, 9}), Sign::zero);
  EXPECT_EQ(where_in_ring(frame, 0, {10, 4}), Sign::negative);
  EXPECT_EQ(where_in_ring(frame, 0, {-1, 9}), Sign::negative);
  EXPECT_TRUE(begins_inside_ring(frame, 0, {0, 0}, {1, 1}));
  EXPECT_FALSE(begins_inside_ring(frame, 0, {0, 0}, {-1, 1}));
  EXPECT_TRUE(begins_inside_ring(frame, 0, {9, 4}, {8, 9}));
  PolygonEdges edges({&frame});
  EXPECT_TRUE(edges.inside_is_above(0));   // the lower side
  EXPECT_FALSE(edges.inside_is_above(2));  // the upper one
  EXPECT_TRUE(edges.inside_is_above(4));   // the left side of the hole: to its left
  EXPECT_TRUE(edges.inside_is_above(5));   // its upper side
  EXPECT_FALSE(edges.inside_is_above(7));  // its lower side
  EXPECT_FALSE(edges.inside_is_above(8));  // the lower side of the other hole
}

// A star of n tips around c.
Ring star(Random& random, const Point2& c, std::size_t n, double radius) {
  Ring ring;
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
    const double r = radius * (0.4 + 0.6 * random.unit());
    ring.push_back({c.x + r * std::cos(angle), c.y + r * std::sin(angle)});
  }
  return ring;
}

// A band of 2 n vertices that winds outwards.
Ring spiral(double turn, std::size_t n) {
  Ring ring;
  for (std::size_t k = 0; k < 2 * n; ++k) {
    const std::size_t at = k < n ? k : 2 * n - 1 - k;
    const double angle = 0.1 * static_cast<double>(at), r = 1 + angle / (2 * std::numbers::pi) + (k < n ? 0 : 0.02);
    ring.push_back({r * std::cos(angle + turn), r * std::sin(angle + turn)});
  }
  return ring;
}

// Each is in the boxes of all others.
TEST(PolygonsAny, BoxesWithinBoxes) {
  std::vector<Polygon> spirals, slivers;
  for (int k = 0; k < 10; ++k) spirals.emplace_back(Rings{spiral(0.2 * std::numbers::pi * k, 1000)});
  for (int k = 0; k < 400; ++k) {
    const double y = 3.0 * k;
    slivers.emplace_back(Rings{{{-1e4, y - 1e4}, {1e4, y + 1e4}, {0, y + 1}}});
  }
  for (std::vector<Polygon>* set : {&spirals, &slivers}) {
    EXPECT_FALSE(polygons_any_by_boxes(*set).meet());
    EXPECT_TRUE(polygons_all_by_boxes(*set).found.empty());
    const Point2 first = set->back().vertices()[0], second = set->back().vertices()[1];
    set->emplace_back(Rings{{first, second, {first.x, second.y}}});
    const PolygonsAnswer answer = polygons_any_by_boxes(*set);
    EXPECT_TRUE(answer.meet());
    EXPECT_EQ(answer.found->j + 1, set->size());
    EXPECT_EQ(polygons_all_by_boxes(*set).found.size(), polygons_all_by_sweep(*set).found.size());
  }
}

// A frame of many edges, with many in its hole, on its rim, and outside.
TEST(PolygonsAny, ManyInAHole) {
  Random random(20261128);
  const Rings frame{star(random, {0, 0}, 20000, 300), star(random, {0, 0}, 20000, 100)};
  std::vector<Polygon> set{Polygon(frame)};
  for (int x = -13; x <= 13; ++x) {
    for (int y = -13; y <= 13; ++y) set.emplace_back(Rings{star(random, {2.0 * x, 2.0 * y}, 5, 0.9)});
  }
  const PolygonsAnswer in_hole = polygons_any_by_boxes(set);
  EXPECT_FALSE(in_hole.meet());
  EXPECT_LE(in_hole.cost.probes, 60u * 40000);
  set.emplace_back(Rings{star(random, {110, 0}, 5, 0.001)});
  const PolygonsAllAnswer all = polygons_all_by_boxes(set);
  ASSERT_EQ(all.found.size(), 1u);
  EXPECT_EQ(all.found[0].kind, ContactKind::none);
  EXPECT_LE(all.cost.probes, 60u * 40000);
}

TEST(PolygonsAny, MethodsAgreeOnLargerSets) {
  Random random(20261125);
  const int count_of_sets = tests::scaled_count(120, 40);
  int some = 0, none = 0, insides = 0;
  for (int k = 0; k < count_of_sets; ++k) {
    std::vector<Polygon> set;
    const std::size_t count = 2 + random.below(40);
    const double side = std::ceil(std::sqrt(static_cast<double>(count)));
    for (std::size_t i = 0; i < count; ++i) {
      const Point2 c{std::fmod(static_cast<double>(i), side), std::floor(static_cast<double>(i) / side)};
      const double radius = k % 3 == 0 ? 0.55 : 0.49;
      const std::size_t n = k % 4 == 0 ? 400 : 8 + random.below(20);  // of 400 many crowd in a cell
      Rings rings{star(random, c, n, radius)};
      if (random.below(3) == 0) rings.push_back(star(random, c, 12, 0.15));
      set.emplace_back(rings);
      if (random.below(k % 5 == 0 ? 20 : 1000) == 0) set.emplace_back(Rings{star(random, c, 5, 0.17)});
    }
    if (k % 7 == 0) set.emplace_back(Rings{star(random, {0, 0}, 9, 200)});  // around all
    const PolygonsAllAnswer all = polygons_all_by_grid(set);
    for (auto* method : {polygons_all_by_boxes, polygons_all_by_sweep}) {
      const PolygonsAllAnswer other = method(set, {});
      ASSERT_EQ(all.found.size(), other.found.size()) << k;
      for (std::size_t c = 0; c < all.found.size(); ++c) {
        ASSERT_EQ(all.found[c].i, other.found[c].i);
        ASSERT_EQ(all.found[c].j, other.found[c].j);
        ASSERT_EQ(all.found[c].contact, other.found[c].contact);
      }
    }
    for (const PolygonsContact& c : all.found) insides += c.kind == ContactKind::none;
    (all.found.empty() ? none : some)++;
    for (const Allowed allowed : {Allowed::nothing, Allowed::touch}) {
      for (auto* method : {polygons_any_by_boxes, polygons_any_by_grid, polygons_any_by_sweep}) {
        const PolygonsAnswer answer = method(set, {allowed, {}, nullptr});
        ASSERT_EQ(answer.meet(), !all.found.empty()) << k;
        const auto is_it = [&](const PolygonsContact& c) { return c.i == answer.found->i && c.j == answer.found->j; };
        ASSERT_TRUE(!answer.meet() || std::any_of(all.found.begin(), all.found.end(), is_it)) << k;
      }
    }
  }
  EXPECT_GT(some, count_of_sets / 4);
  EXPECT_GT(none, count_of_sets / 8);
  EXPECT_GT(insides, count_of_sets * 5 / 6);
}

}  // namespace
}  // namespace sunder::planar
