// The halving of two chains against the exact search and the scan: its parts on grids, the whole near contact, and the
// growth of its probes. That its evidence always holds is tested as well: nothing is left to finish.
//
// How the probes grow: at most 20 (log2 n + log2 m) + 20, found by trial (below 10 (log2 n + log2 m) + 30 where n = m,
// below 16 (log2 n + log2 m) + 20 where one of them is small; on average, over the cases here, half of that). By the
// argument, 8 (log2 n + log2 m) before a chain is short and 25 log2 of the other polygon's size then.
#include <sunder/base/random.h>
#include <sunder/certificate/check.h>
#include <sunder/planar/pair/halving.h>
#include <sunder/planar/pair/minkowski_difference_search.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <tests/support/planar_pairs.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace sunder::planar {

namespace {

using halving::LineCrossing;
using halving::View;
using tests::PlanarFamily;
using tests::scaled_count;

constexpr double probes_per_bit = 20, probes_beyond = 20;

ConvexPolygon mapped(const ConvexPolygon& polygon, auto map) {
  std::vector<Point2> points;
  for (const Point2& p : polygon.vertices()) points.push_back(map(p));
  return ConvexPolygon::hull_of(points);
}

ConvexPolygon shifted(const ConvexPolygon& polygon, double x, double y) {
  return mapped(polygon, [&](const Point2& p) { return Point2{p.x + x, p.y + y}; });
}

// The same with another vertex 0, the point that the search begins with.
ConvexPolygon renumbered(const ConvexPolygon& polygon, Random& random) {
  std::vector<Point2> vertices(polygon.vertices().begin(), polygon.vertices().end());
  std::rotate(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(random.below(vertices.size())),
              vertices.end());
  return ConvexPolygon::from_vertices(std::move(vertices));
}

// Of points within an ellipse in a lattice: many parallel edges.
ConvexPolygon lattice_polygon(Random& random, int most_points, int most_width = 14) {
  const auto width = random.between(2, most_width), height = random.between(2, most_width);
  while (true) {
    std::vector<Point2> points;
    for (int k = 0; k < most_points; ++k) {
      const auto x = static_cast<double>(random.between(-width, width)),
                 y = static_cast<double>(random.between(-height, height));
      const double u = x / static_cast<double>(width), v = y / static_cast<double>(height);
      if (u * u + v * v <= 1.05) points.push_back({x, y});
    }
    if (points.empty()) continue;
    ConvexPolygon polygon = ConvexPolygon::hull_of(points);
    if (polygon.size() >= 3) return renumbered(polygon, random);
  }
}

ConvexPolygon ellipse(Random& random, int n) {
  const double thin = std::exp2(random.uniform(-6, 0)), turn = random.uniform(0, 7);
  std::vector<Point2> points;
  for (int k = 0; k < n; ++k) {
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    const double x = std::cos(angle), y = thin * std::sin(angle);
    points.push_back({x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn)});
  }
  return renumbered(ConvexPolygon::hull_of(points), random);
}

struct Tally {
  int cases = 0, meet = 0, rounds = 0, finishing = 0;
  double probes = 0;
};

bool accepted(const PairAnswer& answer, const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b,
              const Pose& pose_b) {
  const auto table = [](const ConvexPolygon& p) {
    std::vector<Point3> vertices;
    for (const Point2& v : p.vertices()) vertices.push_back({v.x, v.y, 0});
    return vertices;
  };
  const auto of_a = table(a), of_b = table(b);
  const Affine3 in_a = in_space(pose_a.affine()), in_b = in_space(pose_b.affine());
  return check_absolutely(answer.evidence, {of_a, in_a, false}, {of_b, in_b, false}) == CheckResult::accepted;
}

// Everything that is claimed for one answer, whichever object comes first.
void compare(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b, const Pose& pose_b, Tally& tally) {
  const bool small = a.size() + b.size() < 24;
  const bool meet = small ? polygon_polygon_by_scan(a, pose_a, b, pose_b).meet()
                          : polygon_polygon_by_difference(a, pose_a, b, pose_b).meet();
  const PairAnswer answer = polygon_polygon_by_halving(a, pose_a, b, pose_b);
  const PairAnswer swapped = polygon_polygon_by_halving(b, pose_b, a, pose_a);
  EXPECT_EQ(answer.meet(), meet);
  EXPECT_EQ(swapped.meet(), meet);
  EXPECT_TRUE(accepted(answer, a, pose_a, b, pose_b));
  EXPECT_TRUE(accepted(swapped, b, pose_b, a, pose_a));
  const double bits = std::log2(a.size()) + std::log2(b.size());
  for (const PairAnswer& each : {answer, swapped}) {
    EXPECT_NE(each.decided_by, DecidedBy::finishing);
    EXPECT_LE(static_cast<double>(each.cost.probes), probes_per_bit * bits + probes_beyond);
    EXPECT_LE(each.cost.iterations, bits + 1);
    ++tally.cases;
    tally.meet += each.meet();
    tally.rounds += each.cost.iterations > 0;
    tally.finishing += each.decided_by == DecidedBy::finishing;
    tally.probes += static_cast<double>(each.cost.probes) / bits;
  }
}

// How far along x must b be shifted to leave a, to the last bit? Up to `high`, where it has left it.
std::pair<double, double> last_contact(const ConvexPolygon& a, const ConvexPolygon& b, double x, double y) {
  double low = 0, high = 8;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    const Pose pose = Pose::from_matrix({1, 0, 0, 1}, {middle * x, middle * y});
    (polygon_polygon_by_difference(a, Pose(), b, pose).meet() ? low : high) = middle;
  }
  return {low, high};
}

TEST(PolygonPolygonByHalving, ByHand) {
  const ConvexPolygon square = ConvexPolygon::from_vertices({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const ConvexPolygon diamond = ConvexPolygon::from_vertices({{6, 2}, {8, 0}, {10, 2}, {8, 4}});
  const auto meet = [&](double x, double y) {
    Tally tally;
    const Pose pose = Pose::from_matrix({1, 0, 0, 1}, {x, y});
    compare(square, Pose(), diamond, pose, tally);
    return tally.meet > 0;
  };
  EXPECT_FALSE(meet(0, 0));
  EXPECT_TRUE(meet(-2, 0));  // a corner on an edge
  EXPECT_TRUE(meet(-2, 2));  // a corner on a corner
  EXPECT_FALSE(meet(-1, 3));
  EXPECT_TRUE(meet(-3, 3));   // edges that cross
  EXPECT_TRUE(meet(-6, -2));  // vertex 0 on vertex 0
  EXPECT_TRUE(meet(-6, 0));
  EXPECT_FALSE(meet(std::nextafter(-2, 0), 0));
}

// Two edges on one line, the polygons on either side of it, beginning at every vertex.
TEST(PolygonPolygonByHalving, EdgesOfOneLine) {
  std::vector<Point2> below, above;
  for (int k = -6; k <= 6; ++k) {
    if (k == 0) continue;
    below.push_back({static_cast<double>(-k), 1.0 - k * k});  // its edge from (1, 0) to (-1, 0) is on top
    above.push_back({static_cast<double>(k), k * k - 1.0});
  }
  Tally tally;
  for (std::size_t i = 0; i < below.size(); ++i) {
    std::rotate(below.begin(), below.begin() + 1, below.end());
    const ConvexPolygon a = ConvexPolygon::from_vertices(below);
    for (std::size_t j = 0; j < above.size(); ++j) {
      std::rotate(above.begin(), above.begin() + 1, above.end());
      const ConvexPolygon b = ConvexPolygon::from_vertices(above);
      for (const double x : {-3.0, -2.25, -2.0, -1.0, 0.0, 1.0, 2.0, 2.25, 3.0}) {
        Tally one;
        compare(a, Pose(), b, Pose::from_matrix({1, 0, 0, 1}, {x, 0}), one);
        EXPECT_EQ(one.meet > 0, std::fabs(x) <= 2);
        tally.rounds += one.rounds;
      }
    }
  }
  EXPECT_GT(tally.rounds, 100);
}

// What a point sees, against all edges.
TEST(PolygonPolygonByHalving, ViewFromEveryPointOfAGrid) {
  Random random(tests::chosen_seed(101));
  int inside = 0, outside = 0;
  const int count = scaled_count(60);
  for (int i = 0; i < count; ++i) {
    const ConvexPolygon polygon = lattice_polygon(random, 3 + i % 12);
    const PlainPolygon p(polygon);
    for (int at = 0; at < 64; ++at) {
      const Point2 point{static_cast<double>(2 * (at % 8) - 8), static_cast<double>(2 * (at / 8) - 8)};
      Cost cost;
      StageTally tally;
      const View view = halving::view_from(point, p, cost, tally);
      const auto side = [&](std::uint32_t from, std::uint32_t to) {
        return cross_2d(vertex_at(p, from), vertex_at(p, to), vertex_at(p, from), point);
      };
      bool is_inside = true;
      for (std::uint32_t k = 0; k < p.size(); ++k) is_inside = is_inside && side(k, k + 1) != Sign::negative;
      ASSERT_EQ(view.inside, is_inside);
      ++(is_inside ? inside : outside);
      if (is_inside) {
        ASSERT_NE(side(0, view.wedge), Sign::negative);
        ASSERT_NE(side(view.wedge + 1, 0), Sign::negative);
        continue;
      }
      for (std::uint32_t k = 0; k < p.size(); ++k) {
        ASSERT_NE(cross_2d(point, p[view.right], point, p[k]), Sign::negative);
        ASSERT_NE(cross_2d(point, p[view.left], point, p[k]), Sign::positive);
      }
    }
  }
  if (count < 60) return;  // too few for the rates below
  EXPECT_GT(inside, 10 * count);
  EXPECT_GT(outside, 20 * count);
}

// Where a line crosses a polygon, against the meaning of each answer.
TEST(PolygonPolygonByHalving, CrossLineOfAGrid) {
  Random random(tests::chosen_seed(102));
  std::map<LineCrossing::Place, int> seen;
  const int count = scaled_count(20000);
  for (int i = 0; i < count; ++i) {
    const ConvexPolygon polygon = lattice_polygon(random, 3 + i % 12);
    const PlainPolygon q(polygon);
    const auto number = [&] { return static_cast<double>(random.between(-12, 12)); };
    const Point2 tail{number(), number()}, head{number(), number()};
    if (tail == head) continue;
    Cost cost;
    StageTally tally;
    const LineCrossing c = halving::cross_line(tail, head, q, cost, tally);
    ++seen[c.place];
    const ConvexPolygon segment = ConvexPolygon::hull_of(std::array{tail, head});
    ASSERT_EQ(c.place == LineCrossing::Place::within, polygon_polygon_by_difference(segment, {}, polygon, {}).meet());
    const auto beyond = [&](std::uint32_t edge, const Point2& point) {
      return cross_2d(q[edge], vertex_at(q, edge + 1), q[edge], point) == Sign::negative;
    };
    const auto side = [&](std::uint32_t k) { return cross_2d(tail, head, tail, vertex_at(q, k)); };
    switch (c.place) {
      case LineCrossing::Place::right:
        for (std::uint32_t k = 0; k < q.size(); ++k) {
          ASSERT_EQ(side(k), Sign::negative);
          ASSERT_NE(cross_2d(tail, head, q[c.edge], q[k]), Sign::positive);
        }
        break;
      case LineCrossing::Place::left:
        for (std::uint32_t k = 0; k < q.size(); ++k) ASSERT_EQ(side(k), Sign::positive);
        break;
      case LineCrossing::Place::ahead:
        ASSERT_TRUE(beyond(c.edge, head) && side(c.edge) != Sign::negative && side(c.edge + 1) != Sign::positive);
        break;
      case LineCrossing::Place::behind:
        ASSERT_TRUE(beyond(c.edge, tail) && side(c.edge) != Sign::positive && side(c.edge + 1) != Sign::negative);
        break;
      case LineCrossing::Place::within: break;
    }
  }
  for (const auto& [place, times] : seen) EXPECT_GT(times, count / 40) << static_cast<int>(place);
  EXPECT_EQ(seen.size(), 5u);
}

// Small polygons of a grid under integer poses, reflecting ones too: every degeneracy.
TEST(PolygonPolygonByHalving, SmallGrids) {
  tests::PlanarPairs pairs(tests::chosen_seed(103));
  Tally tally;
  const int count = scaled_count(10000);
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    const tests::PlanarCase c = pairs.next(i % 20 == 0 ? PlanarFamily::degenerate : PlanarFamily::grid);
    compare(c.a, c.pose_a, c.b, c.pose_b, tally);
  }
  EXPECT_GT(tally.meet, tally.cases / 8);
}

// Larger ones, in contact or a step of the lattice away from it.
TEST(PolygonPolygonByHalving, LatticePolygonsNearContact) {
  Random random(tests::chosen_seed(104));
  Tally tally;
  const int count = scaled_count(500);
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    const ConvexPolygon a = lattice_polygon(random, 300, 40), b = lattice_polygon(random, 300, 40);
    const double turn = random.uniform(0, 7);
    const auto at = [&](int steps) {
      return std::array{std::round(steps * std::cos(turn)), std::round(steps * std::sin(turn))};
    };
    int low = 0, high = 128;
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      const Pose pose = Pose::from_matrix({1, 0, 0, 1}, at(middle));
      (polygon_polygon_by_difference(a, Pose(), b, pose).meet() ? low : high) = middle;
    }
    for (const int steps : {low - 1, low, low + 1}) {
      const auto [x, y] = at(steps);
      const double scale = std::array{1.0, 0x1p900, 0x1p-900}[static_cast<std::size_t>(i % 3)];
      const auto scaled = [&](const ConvexPolygon& p) {
        return mapped(p, [&](const Point2& v) { return Point2{v.x * scale, v.y * scale}; });
      };
      compare(renumbered(scaled(a), random), Pose(), renumbered(scaled(shifted(b, x, y)), random), Pose(), tally);
      const Pose reflection = Pose::from_matrix({0, 1, 1, 0}, {0, 0});
      if (i % 3 == 0) compare(a, reflection, shifted(b, x, y), reflection, tally);
    }
  }
  EXPECT_GT(tally.meet, tally.cases / 2);
  EXPECT_LT(tally.meet, tally.cases * 3 / 4);
  EXPECT_GT(tally.rounds, tally.cases / 20);
}

TEST(PolygonPolygonByHalving, Families) {
  tests::PlanarPairs pairs(tests::chosen_seed(105));
  std::map<PlanarFamily, Tally> tallies;
  const int count = scaled_count(2000);
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    const tests::PlanarCase c = pairs.next();
    if (c.family != PlanarFamily::grid) compare(c.a, c.pose_a, c.b, c.pose_b, tallies[c.family]);
  }
  if (count < 2000) return;
  for (const auto& [family, tally] : tallies) EXPECT_GT(tally.meet, tally.cases / 8) << name_of(family);
}

// Ellipses: apart, near contact down to the last bits on either side of it, overlapping little, contained.
TEST(PolygonPolygonByHalving, GeneralPositionAndNearContact) {
  Random random(tests::chosen_seed(106));
  std::map<std::string, Tally> tallies;
  const int count = scaled_count(300);
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    const auto size = [&] { return static_cast<int>(random.log_uniform(4, 400)); };
    const ConvexPolygon a = ellipse(random, size()), b = ellipse(random, size());
    const double turn = random.uniform(0, 7), x = std::cos(turn), y = std::sin(turn);
    const auto [low, high] = last_contact(a, b, x, y);
    const auto place = [&](const std::string& regime, double along) {
      compare(a, Pose(), renumbered(shifted(b, along * x, along * y), random), Pose(), tallies[regime]);
      compare(a, Pose(), b, Pose::from_matrix({1, 0, 0, 1}, {along * x, along * y}), tallies[regime + ", posed"]);
    };
    place("last bit in", low);
    place("last bit out", high);
    place("near, meeting", low - std::exp2(random.uniform(-50, -5)));
    place("near, apart", low + std::exp2(random.uniform(-50, -5)));
    place("shallow", low - std::exp2(random.uniform(-8, -3)));
    place("apart", low + random.uniform(0.1, 2));
    const double less = std::exp2(random.uniform(-8, -1));
    compare(a, Pose(), mapped(b, [&](const Point2& p) { return Point2{p.x * less, p.y * less}; }), Pose(),
            tallies["contained"]);
  }
  for (const auto& [regime, tally] : tallies) EXPECT_EQ(tally.finishing, 0) << regime;
  EXPECT_EQ(tallies["apart"].meet, 0);
  if (count < 300) return;
  EXPECT_GT(tallies["shallow"].rounds, tallies["shallow"].cases / 4);
  EXPECT_GT(tallies["near, apart"].rounds, tallies["near, apart"].cases / 4);
}

TEST(PolygonPolygonByHalving, Complexity) {
  Random random(tests::chosen_seed(107));
  std::map<std::uint32_t, Tally> tallies;
  const auto polygon_of = [&](int log2_n) { return tests::regular_polygon(std::uint32_t{1} << log2_n); };
  const ConvexPolygon octagon = polygon_of(3);
  for (int log2_n = 3; log2_n <= 18; log2_n += 3) {
    const ConvexPolygon polygon = polygon_of(log2_n);
    for (const ConvexPolygon* other : {&polygon, &octagon}) {
      for (int i = 0; i < 40; ++i) {
        const double turn = random.uniform(0, 7), x = std::cos(turn), y = std::sin(turn);
        const auto [low, high] = last_contact(polygon, *other, x, y);
        const double little = std::exp2(random.uniform(-40, -1));
        for (const double along : {low, high, low - little, low + little}) {
          const Pose pose_a = Pose::from_angle(0, {-along * x, -along * y}), pose_b;
          const PairAnswer answer = polygon_polygon_by_halving(polygon, pose_a, *other, pose_b);
          const PairAnswer swapped = polygon_polygon_by_halving(*other, pose_b, polygon, pose_a);
          const double bits = std::log2(polygon.size()) + std::log2(other->size());
          for (const PairAnswer& each : {answer, swapped}) {
            ASSERT_EQ(each.meet(), polygon_polygon_by_difference(polygon, pose_a, *other, pose_b).meet());
            ASSERT_NE(each.decided_by, DecidedBy::finishing);
            ASSERT_LE(static_cast<double>(each.cost.probes), probes_per_bit * bits + probes_beyond);
            ASSERT_LE(each.cost.iterations, bits + 1);
            Tally& tally = tallies[polygon.size()];
            ++tally.cases;
            tally.probes += static_cast<double>(each.cost.probes) / bits;
          }
        }
      }
    }
  }
  for (const auto& [n, tally] : tallies) EXPECT_LT(tally.probes, 10 * tally.cases) << n;
}

}  // namespace
}  // namespace sunder::planar
