// Each kind of defect by itself: where it is, and under which rule. The scan is asked too.
#include <sunder/base/error.h>
#include <sunder/planar/polygons/polygon_valid.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace sunder::planar {
namespace {

using tests::box_ring;

using Kind = PolygonDefectKind;
using Ring = std::vector<Point2>;
using Parts = std::vector<PolygonRings>;

const Ring large_square{{0, 0}, {8, 0}, {8, 8}, {0, 8}};

bool are_same(const PolygonDefect& c, const PolygonDefect& d) {
  return c.kind == d.kind && c.a == d.a && c.b == d.b && c.place.a == d.place.a && c.place.b == d.place.b;
}

// Visited one by one they are the same, in the same order, until the visitor has enough.
void expect_visited(const Parts& parts, PolygonRule rule, const std::vector<PolygonDefect>& defects) {
  for (const std::size_t enough : {defects.size() + 1, defects.size() / 2 + 1}) {
    std::size_t next = 0;
    const CountAnswer<> all = visit_polygon_defects(parts, {rule}, [&](const PolygonDefect& d) {
      EXPECT_LT(next, std::min(enough, defects.size()));
      EXPECT_TRUE(next < defects.size() && are_same(d, defects[next])) << next;
      return ++next < enough;
    });
    EXPECT_EQ(next, std::min(enough, defects.size()));
    EXPECT_EQ(all.count, defects.size());
  }
}

std::vector<Kind> kinds(const Parts& parts, PolygonRule rule = PolygonRule::valid) {
  std::vector<Kind> all, of_scan;
  const std::vector<PolygonDefect> defects = polygon_defects(parts, {rule}).found;
  expect_visited(parts, rule, defects);
  for (const PolygonDefect& d : defects) all.push_back(d.kind);
  for (const PolygonDefect& d : polygon_defects_by_scan(parts, {rule}).found) of_scan.push_back(d.kind);
  EXPECT_EQ(all, of_scan);
  return all;
}
std::vector<Kind> kinds(const PolygonRings& rings, PolygonRule rule = PolygonRule::valid) {
  return kinds(Parts{rings}, rule);
}
using DefectKinds = std::vector<Kind>;

TEST(PolygonValidTest, ValidOnes) {
  EXPECT_EQ(kinds({large_square}), DefectKinds{});
  EXPECT_EQ(kinds({large_square, box_ring(1, 1, 2, 2), box_ring(3, 3, 4, 4)}), DefectKinds{});
  EXPECT_EQ(kinds(Parts{}), DefectKinds{});
  EXPECT_EQ(kinds(Parts{{}, {large_square}}), DefectKinds{});  // an empty part
  // Vertices that are repeated, also where the ring is closed.
  const PolygonRings repeated{{{0, 0}, {0, 0}, {8, 0}, {8, 8}, {8, 8}, {8, 8}, {0, 0}, {0, 0}}};
  EXPECT_EQ(kinds(repeated), DefectKinds{});
  EXPECT_EQ(kinds(repeated, PolygonRule::simple), DefectKinds(4, Kind::repeated_vertex));
  // A hole touches its shell, in a vertex and on an edge; another one that hole, in one point each.
  const PolygonRings touching{
      large_square, {{0, 0}, {2, 1}, {1, 2}}, {{8, 4}, {4, 4}, {6, 3}}, {{2, 1}, {3, 1}, {3, 2}}};
  EXPECT_EQ(kinds(touching), DefectKinds{});
  EXPECT_EQ(kinds(touching, PolygonRule::simple), DefectKinds(3, Kind::rings_touch));
}

TEST(PolygonValidTest, RingsByThemselves) {
  EXPECT_EQ(kinds(PolygonRings{{{0, 0}, {1, 1}, {1, 1}, {0, 0}}}), DefectKinds{Kind::too_few_points});
  EXPECT_EQ(kinds({large_square, {}}), DefectKinds{Kind::too_few_points});
  EXPECT_EQ(kinds({large_square, {{1, 1}}}), DefectKinds{Kind::too_few_points});
  EXPECT_EQ(kinds(PolygonRings{{{0, 0}, {8, 8}, {8, 0}, {0, 8}}}), DefectKinds{Kind::crossing});
  EXPECT_EQ(kinds(PolygonRings{{{0, 0}, {8, 0}, {9, 0}, {8, 0}, {8, 8}}}), (DefectKinds{Kind::overlap}));  // a spike
  // Crosses itself in a vertex; only comes back to it; comes to an edge.
  EXPECT_EQ(kinds(PolygonRings{{{0, 0}, {4, 4}, {8, 8}, {8, 0}, {4, 4}, {0, 8}}}), DefectKinds{Kind::crossing});
  EXPECT_EQ(kinds(PolygonRings{{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 4}, {3, 5}, {3, 3}, {0, 4}}}),
            DefectKinds{Kind::self_touch});
  EXPECT_EQ(kinds(PolygonRings{{{0, 0}, {4, 0}, {2, 2}, {6, 2}, {4, 0}, {8, 0}, {8, 8}, {0, 8}}}),
            DefectKinds{Kind::self_touch});
  EXPECT_EQ(kinds(PolygonRings{{{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}}}),
            (DefectKinds{Kind::self_touch, Kind::disconnected}));
}

TEST(PolygonValidTest, TheShellTouchesItself) {
  const PolygonRule rule = PolygonRule::self_touch;
  const Ring pocket{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 4}, {3, 5}, {3, 3}, {0, 4}};
  EXPECT_EQ(kinds({pocket}, rule), DefectKinds{});
  EXPECT_EQ(kinds({pocket, {{1, 4}, {2, 4}, {2, 4.25}}}, rule), DefectKinds{Kind::hole_outside});
  EXPECT_EQ(kinds({pocket, {{3, 3}, {5, 3}, {5, 4}}}, rule), DefectKinds{});
  EXPECT_EQ(kinds({pocket, {{3, 3}, {5, 3}, {3, 5}}}, rule), DefectKinds{Kind::overlap});
  EXPECT_EQ(kinds({pocket, {{3, 3}, {5, 4}, {3, 5}, {4, 4}}}, rule), DefectKinds{Kind::disconnected});
  // Two triangles that have a corner in common.
  EXPECT_EQ(kinds(PolygonRings{{{0, 0}, {4, 4}, {8, 0}, {8, 8}, {4, 4}, {0, 8}}}, rule),
            DefectKinds{Kind::disconnected});
  // A hole of two triangles; a hole with an island that hangs on it.
  EXPECT_EQ(kinds({large_square, {{1, 1}, {4, 4}, {7, 7}, {7, 1}, {4, 4}, {1, 7}}}, rule), DefectKinds{Kind::crossing});
  EXPECT_EQ(kinds({large_square, {{1, 1}, {4, 4}, {7, 1}, {7, 7}, {4, 4}, {1, 7}}}, rule), DefectKinds{});
  EXPECT_EQ(kinds({large_square, {{1, 1}, {7, 1}, {7, 7}, {1, 7}, {1, 4}, {3, 5}, {3, 3}, {1, 4}}}, rule),
            DefectKinds{Kind::disconnected});
}

// Where a ring is cut depends on the order of its visits.
TEST(PolygonValidTest, RingsThatTouchThemselvesTwice) {
  const PolygonRule rule = PolygonRule::self_touch;
  // A frame that is closed in (0, 4), and pinched in (8, 4): these come in turn along the ring.
  EXPECT_EQ(
      kinds(PolygonRings{{{0, 4}, {0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 4}, {2, 6}, {6, 6}, {8, 4}, {6, 2}, {2, 2}}},
            rule),
      DefectKinds{Kind::disconnected});
  // A pocket, and an island in it that hangs on its shore.
  EXPECT_EQ(kinds(
                PolygonRings{
                    {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 4}, {6, 6}, {6, 4}, {4, 5}, {4, 3}, {6, 4}, {6, 2}, {0, 4}}},
                rule),
            DefectKinds{Kind::disconnected});
  const Ring pinched{{0, 4}, {0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 4}, {2, 6}, {6, 6}, {8, 4}, {6, 2}, {4, 0}, {2, 2}};
  EXPECT_EQ(polygon_defects(Parts{{pinched}}, {rule}).found.size(), 2u);  // and once more
  // Comes twice to one edge, which goes to the left; two pieces of the interior are cut off.
  const Ring twice{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {1, 4}, {2, 8}, {3, 4}, {5, 8}, {5, 2}, {1, 2}};
  const PolygonDefects answer = polygon_defects(Parts{{twice}}, {rule});
  ASSERT_EQ(answer.found.size(), 2u);
  for (const PolygonDefect& d : answer.found) {
    EXPECT_EQ(d.kind, Kind::disconnected);
    EXPECT_EQ(d.place.a.y, 8);
  }
}

TEST(PolygonValidTest, WhereHolesLie) {
  EXPECT_EQ(kinds({large_square, box_ring(9, 0, 10, 1)}), DefectKinds{Kind::hole_outside});
  EXPECT_EQ(kinds({large_square, box_ring(8, 8, 9, 9)}), DefectKinds{Kind::hole_outside});    // it touches the shell
  EXPECT_EQ(kinds({large_square, box_ring(-1, -1, 9, 9)}), DefectKinds{Kind::hole_outside});  // it holds the shell
  // It holds the shell and another hole, which is not nested therefore; that goes from side to side.
  EXPECT_EQ(kinds({large_square, box_ring(1, 1, 2, 2), box_ring(-1, -1, 9, 9)}), DefectKinds{Kind::hole_outside});
  EXPECT_EQ(kinds({large_square, {{0, 4}, {4, 3}, {8, 4}, {4, 5}}, box_ring(-1, -1, 9, 9)}),
            (DefectKinds{Kind::hole_outside, Kind::disconnected}));
  EXPECT_EQ(kinds({large_square, box_ring(1, 1, 7, 7), box_ring(2, 2, 3, 3)}), DefectKinds{Kind::nested_holes});
  EXPECT_EQ(kinds({large_square, box_ring(3, 3, 4, 4), box_ring(2, 2, 5, 5), box_ring(1, 1, 7, 7)}),
            DefectKinds(2, Kind::nested_holes));
  EXPECT_EQ(kinds({large_square, box_ring(1, 1, 7, 7), {{1, 1}, {3, 2}, {2, 3}}}), DefectKinds{Kind::nested_holes});
  EXPECT_EQ(kinds({large_square, box_ring(1, 1, 7, 7), box_ring(1, 1, 7, 7)}), DefectKinds(4, Kind::overlap));
  EXPECT_EQ(kinds({large_square, box_ring(8, 1, 9, 2)}), DefectKinds{Kind::overlap});
  EXPECT_EQ(kinds({large_square, box_ring(7, 1, 9, 2)}), DefectKinds(2, Kind::crossing));
}

TEST(PolygonValidTest, TheInterior) {
  // A hole from side to side; a ring of three holes that touch; three that meet in one point, which is no cycle.
  EXPECT_EQ(kinds({large_square, {{0, 4}, {4, 3}, {8, 4}, {4, 5}}}), DefectKinds{Kind::disconnected});
  EXPECT_EQ(kinds({large_square, {{1, 1}, {4, 1}, {4, 2}}, {{4, 2}, {4, 5}, {3, 5}}, {{3, 5}, {1, 1}, {2, 4}}}),
            DefectKinds{Kind::disconnected});
  EXPECT_EQ(kinds({large_square, {{4, 4}, {2, 4}, {2, 5}}, {{4, 4}, {6, 4}, {6, 5}}, {{4, 4}, {4, 2}, {5, 2}}}),
            DefectKinds{});
}

TEST(PolygonValidTest, Parts) {
  EXPECT_EQ(kinds(Parts{{large_square}, {box_ring(8, 8, 9, 9)}}), DefectKinds{});
  EXPECT_EQ(kinds(Parts{{large_square}, {box_ring(8, 4, 9, 9)}}), DefectKinds{Kind::overlap});
  EXPECT_EQ(kinds(Parts{{large_square}, {box_ring(1, 1, 2, 2)}}), DefectKinds{Kind::nested_parts});
  EXPECT_EQ(kinds(Parts{{box_ring(1, 1, 2, 2)}, {large_square}}), DefectKinds{Kind::nested_parts});
  EXPECT_EQ(kinds(Parts{{large_square, box_ring(1, 1, 5, 5)}, {{{1, 1}, {5, 3}, {3, 5}}}}), DefectKinds{});
  EXPECT_EQ(kinds(Parts{{large_square, box_ring(1, 1, 7, 7)},
                        {box_ring(2, 2, 6, 6), box_ring(3, 3, 5, 5)},
                        {box_ring(4, 4, 4.5, 4.5)}}),
            DefectKinds{});
  EXPECT_EQ(kinds(Parts{{large_square}, {box_ring(4, 4, 9, 9)}}), DefectKinds(2, Kind::crossing));
}

TEST(PolygonValidTest, SeveralOfOnePolygonInTheirPlaces) {
  const PolygonRings rings{large_square,                                // with a spike
                           box_ring(1, 1, 2, 2),                        //
                           {{4, 4}, {6, 6}, {6, 4}, {4, 6}, {4, 4}},    // an hourglass
                           {{9, 1}, {9, 1}, {10, 1}, {10, 2}, {9, 1}},  // outside
                           {{7, 7}, {7.5, 7}, {7, 7}, {7, 7}}};
  const PolygonDefects answer = polygon_defects(Parts{rings});
  ASSERT_EQ(answer.found.size(), 3u);
  EXPECT_EQ(answer.found[0].kind, Kind::too_few_points);
  EXPECT_EQ(answer.found[0].a, (RingPlace{0, 4, 0}));
  EXPECT_EQ(answer.found[1].kind, Kind::crossing);
  EXPECT_EQ(answer.found[1].a, (RingPlace{0, 2, 0}));
  EXPECT_EQ(answer.found[1].b, (RingPlace{0, 2, 2}));
  EXPECT_EQ(answer.found[1].place, (Segment{{5, 5}, {5, 5}}));
  EXPECT_EQ(answer.found[2].kind, Kind::hole_outside);
  EXPECT_EQ(answer.found[2].a, (RingPlace{0, 3, 1}));  // the last of equal vertices
  EXPECT_EQ(polygon_defects(Parts{rings}, {PolygonRule::valid, 2}).found.size(), 2u);
  // As an object the same.
  const PolygonRings two{large_square, box_ring(9, 1, 10, 2)};
  EXPECT_EQ(polygon_defects(Polygon(two)).found[0].kind, Kind::hole_outside);
}

TEST(PolygonValidTest, BadCoordinates) {
  try {
    static_cast<void>(polygon_defects(Parts{{large_square, {{1, 1}, {2, std::nan("")}, {2, 2}}}}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_value);
    EXPECT_EQ(error.place(), "part 0, ring 1, vertex 1");
  }
}

// At the ends of the doubles, where no filter decides.
TEST(PolygonValidTest, AnyDoubles) {
  const double most = std::numeric_limits<double>::max(), little = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(kinds({box_ring(-most, -most, most, most), box_ring(-little, -little, little, little)}), DefectKinds{});
  EXPECT_EQ(kinds({box_ring(-most, -most, most, most), {{0, -little}, {little, 0}, {0, most}}}), DefectKinds{});
  EXPECT_EQ(kinds({box_ring(-most, -most, most, most), {{0, -most}, {little, 0}, {0, most}}}),
            DefectKinds{Kind::disconnected});
}

// Many triangles in one point, also many holes on one edge: near-linear work.
TEST(PolygonValidTest, WorkGrowsAsNLogN) {
  for (std::size_t n = 256; n <= 65536; n *= 16) {
    Parts pie;
    Ring comb{{-1, -1}, {2.0 * static_cast<double>(n) + 1, -1}, {2.0 * static_cast<double>(n) + 1, 0}, {-1, 0}};
    PolygonRings shore{comb};
    for (std::size_t k = 0; k < n; ++k) {
      const double x = static_cast<double>(2 * k), y = static_cast<double>(n);
      pie.push_back({{{0, 0}, {y, x}, {y, x + 1}}});
      shore.push_back({{x, 0}, {x + 1, -0.5}, {x + 0.5, -0.75}});
    }
    const double edges = 3 * static_cast<double>(n), bound = 3 * edges * std::log2(edges);
    const PolygonDefects of_pie = polygon_defects(pie), of_shore = polygon_defects(Parts{shore});
    EXPECT_TRUE(of_pie.found.empty());
    EXPECT_TRUE(of_shore.found.empty());
    EXPECT_LT(static_cast<double>(of_pie.cost.probes), bound);
    EXPECT_LT(static_cast<double>(of_shore.cost.probes), bound);
  }
}

// Rings through two points, each two of which cross in both: one defect is found without listing all.
TEST(PolygonValidTest, OneOfVeryManyCrossingsInVertices) {
  for (const int n : {30, 20000}) {
    Parts parts;
    for (int k = 0; k < n; ++k) parts.push_back({{{0, 1}, {1.0 * k, 0}, {0, -1}, {1.0 * (n + k), 0}}});
    const PolygonDefects answer = polygon_defects(parts, {PolygonRule::valid, 1});
    ASSERT_EQ(answer.found.size(), 1u);
    EXPECT_EQ(answer.found[0].kind, Kind::crossing);
    if (n == 30) {
      EXPECT_EQ(polygon_defects(parts).found.size(), 30u * 29u);
    }
  }
}

// A shell that touches itself in one point many times, with petals side by side, or with holes made by them.
TEST(PolygonValidTest, TouchesItselfManyTimesInOnePoint) {
  for (const std::uint32_t petals : {50u, 1000u, 50000u}) {
    if (petals > 1000 && tests::is_scaled_down()) continue;
    Ring flower, corner{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    for (std::uint32_t k = 0; k < petals; ++k) {
      const double n = petals;
      for (const Point2& p : {Point2{0, 0}, tests::on_circle(k / n), tests::on_circle((k + 0.5) / n)})
        flower.push_back(p);
      const double at = (petals - k) / (4 * n + 8);  // within a quarter
      for (const Point2& p : {Point2{0, 0}, tests::on_circle(at), tests::on_circle(at - 0.1 / n)}) corner.push_back(p);
    }
    for (const Ring& ring : {flower, corner}) {
      const Parts parts{{ring}};
      const double n = static_cast<double>(ring.size());
      const PolygonDefects touches = polygon_defects(parts), holes = polygon_defects(parts, {PolygonRule::self_touch});
      EXPECT_LE(static_cast<double>(touches.cost.probes), 3 * n * std::log2(n));
      EXPECT_GE(touches.cost.probes, 4 * std::uint64_t{petals});
      const std::size_t parted = ring == flower ? petals - 1 : 0;
      EXPECT_EQ(holes.found.size(), parted);
      EXPECT_EQ(touches.found.size(), ring == flower ? 2 * parted : petals);
    }
  }
}

// Half of its edges cross the other half; further rings overlap it, cross in vertices, and lie where they may not.
Parts comb(int half) {
  Ring ring;
  for (int k = 0; k <= half; ++k) ring.push_back({1.0 * k, k % 2 == 0 ? 0.0 : 4.0 * half});
  for (int k = 0; k <= half; ++k) ring.push_back({k % 2 == 0 ? half + 1.0 : -1.0, 1.0 * half + k});
  for (const Point2& p : Ring{{half + 2.0, 2.0 * half}, {half + 2.0, -1}, {-1, -1}}) ring.push_back(p);
  return {{ring}};
}

TEST(PolygonValidTest, VisitedWhereMoreThanMayBeHeld) {
  if (tests::is_scaled_down()) GTEST_SKIP() << "PolygonContactsInOrder is tested with other limits";
  constexpr std::uint32_t half = 1100;  // 1.2 million crossings
  std::uint64_t count = 0;
  PolygonDefect last;
  const CountAnswer<> all = visit_polygon_defects(comb(half), {}, [&](const PolygonDefect& d) {
    const bool is_next = count == 0 || std::tie(last.a, last.b) < std::tie(d.a, d.b);
    EXPECT_TRUE(is_next && d.kind == Kind::crossing);
    last = d;
    return ++count > 0 && is_next;
  });
  EXPECT_EQ(count, std::uint64_t{half} * half);
  EXPECT_EQ(all.count, count);
}

TEST(PolygonValidTest, VisitedOfAllKinds) {
  Parts parts = comb(20);
  parts[0].push_back({{0, 0}, {1, 80}, {0, 80}});               // overlaps the first
  parts[0].push_back({{60, 0}, {60, 0}, {60, 0}});              // too short
  parts.push_back({{{100, 1}, {103, 0}, {100, -1}, {99, 0}}});  // these two cross in vertices
  parts.push_back({{{100, 1}, {104, 0}, {100, -1}, {98, 0}}});
  parts.push_back({large_square, box_ring(20, 20, 21, 21)});  // a hole outside
  const std::vector<Kind> all = kinds(parts);
  for (const Kind kind : {Kind::too_few_points, Kind::crossing, Kind::overlap}) {
    EXPECT_NE(std::find(all.begin(), all.end(), kind), all.end()) << name_of(kind);
  }
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
}

}  // namespace
}  // namespace sunder::planar
