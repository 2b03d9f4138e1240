// Simple or not, and by which edges; against every pair.
#include <sunder/base/error.h>
#include <sunder/base/random.h>
#include <sunder/planar/polygons/polygon_simple.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace sunder::planar {
namespace {

using Ring = std::vector<Point2>;

// All methods, checked against each other.
PolygonSimpleAnswer ask(const std::vector<Ring>& rings) {
  const Polygon polygon(rings);
  const PolygonSimpleAnswer scan = polygon_simple_by_scan(polygon), sweep = polygon_simple_by_sweep(polygon);
  for (const PolygonSimpleAnswer& answer : {sweep, polygon_simple_by_grid(polygon), polygon_simple(polygon)}) {
    EXPECT_EQ(scan.meet(), answer.meet());
    if (!answer.meet()) continue;
    EXPECT_LT(answer.found->i, answer.found->j);
    EXPECT_LT(answer.found->j, polygon.size());
    EXPECT_EQ(counted_contact(polygon, answer.found->i, answer.found->j), answer.found->kind);
  }
  return sweep;
}

ContactKind kind_of(const PolygonSimpleAnswer& answer) {
  return answer.meet() ? answer.found->kind : ContactKind::none;
}

const Ring small_square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(PolygonSimpleTest, SimpleOnes) {
  EXPECT_FALSE(ask({small_square}).meet());
  EXPECT_FALSE(ask({{{0, 0}, {4, 0}, {0, 4}}}).meet());
  EXPECT_FALSE(ask({{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}}).meet());  // a vertex in the middle of a side
  EXPECT_FALSE(ask({small_square, {{1, 1}, {2, 1}, {1, 2}}}).meet());
  EXPECT_FALSE(ask({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}}).meet());  // closed, as in files
}

TEST(PolygonSimpleTest, OthersAndWhy) {
  const auto kind = [](const std::vector<Ring>& rings) { return kind_of(ask(rings)); };
  EXPECT_EQ(kind({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}), ContactKind::crossing);                         // an hourglass
  EXPECT_EQ(kind({{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}}), ContactKind::shared_endpoint);  // through (2, 2)
  EXPECT_EQ(kind({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}), ContactKind::touch);
  EXPECT_NE(kind({{{0, 0}, {4, 0}, {6, 0}, {4, 0}, {4, 4}}}), ContactKind::none);  // a spike: overlap, shared end
  EXPECT_EQ(kind({{{0, 0}, {1, 1}, {2, 2}}}), ContactKind::overlap);               // flat
  EXPECT_NE(kind({{{0, 0}, {4, 0}, {4, 0}, {4, 4}}}), ContactKind::none);          // a repeated vertex
  EXPECT_NE(kind({{{1, 1}, {1, 1}, {2, 1}, {1, 2}}}), ContactKind::none);
  EXPECT_EQ(kind({small_square, {{4, 2}, {2, 3}, {2, 1}}}), ContactKind::touch);  // a hole at the shore
  EXPECT_EQ(kind({small_square, {{4, 4}, {2, 3}, {3, 2}}}), ContactKind::shared_endpoint);
  EXPECT_EQ(kind({small_square, {{3, 1}, {5, 2}, {3, 2}}}), ContactKind::crossing);
  EXPECT_NE(kind({small_square, small_square}), ContactKind::none);
  // Repeated at the end, where a file closes the ring; and nothing but one point.
  EXPECT_EQ(kind({{{0, 0}, {1, 0}, {0, 1}, {0, 0}}}), ContactKind::none);
  EXPECT_NE(kind({{{0, 0}, {1, 0}, {0, 1}, {0, 0}, {0, 0}}}), ContactKind::none);
  EXPECT_NE(kind({{{1, 1}, {1, 1}, {1, 1}, {1, 1}}}), ContactKind::none);
  EXPECT_NE(kind({{{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}}}), ContactKind::none);
}

TEST(PolygonSimpleTest, RingsAreNumberedThrough) {
  const Polygon polygon(std::vector<Ring>{small_square, {{1, 1}, {2, 1}, {1, 2}, {1, 1}}});
  EXPECT_EQ(polygon.size(), 7u);
  EXPECT_EQ(polygon.ring_count(), 2u);
  EXPECT_EQ(polygon.ring_begin(1), 4u);
  EXPECT_EQ(polygon.ring_of(3), 0u);
  EXPECT_EQ(polygon.ring_of(4), 1u);
  EXPECT_EQ(polygon.next(3), 0u);
  EXPECT_EQ(polygon.next(6), 4u);
  EXPECT_EQ(polygon.previous(4), 6u);
  EXPECT_EQ(polygon.previous(0), 3u);
  EXPECT_EQ(polygon.edge(6), (Segment{{1, 2}, {1, 1}}));
}

TEST(PolygonSimpleTest, BadRingsAreRefused) {
  const auto code = [](const std::vector<Ring>& rings) {
    try {
      Polygon{rings};
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::bad_call;
  };
  EXPECT_EQ(code({}), ErrorCode::bad_shape);
  EXPECT_EQ(code({{{0, 0}, {1, 1}}}), ErrorCode::bad_shape);
  EXPECT_EQ(code({{{0, 0}, {1, 1}, {0, 0}}}), ErrorCode::bad_shape);
  EXPECT_EQ(code({small_square, {{0, 0}, {1, std::numeric_limits<double>::infinity()}, {0, 0}}}), ErrorCode::bad_value);
}

// Small grids, where every degeneracy is common; and stars, which are simple, with a vertex moved sometimes.
TEST(PolygonSimpleTest, AgainstEveryPair) {
  Random random(tests::chosen_seed(107));
  const int count = tests::scaled_count(20000);
  std::map<ContactKind, int> seen;
  for (int i = 0; i < count; ++i) {
    std::vector<Ring> rings(1 + random.below(i % 3 == 0 ? 2 : 1));
    for (Ring& ring : rings) {
      const std::int64_t n = random.between(3, 9);
      if (i % 2 == 0) {
        const std::int64_t side = random.between(2, 6);
        const auto whole = [&] { return static_cast<double>(random.between(0, side)); };
        for (std::int64_t k = 0; k < n; ++k) ring.push_back({whole(), whole()});
      } else {
        const Point2 centre{random.uniform(-2, 2), random.uniform(-2, 2)};
        for (std::int64_t k = 0; k < n; ++k) {
          const double t = 6.283185307179586 * static_cast<double>(k) / static_cast<double>(n),
                       r = random.uniform(0.2, 1);
          ring.push_back({centre.x + r * std::cos(t), centre.y + r * std::sin(t)});
        }
        if (random.below(2)) ring[0] = {random.uniform(-1, 1), random.uniform(-1, 1)};
      }
      if (ring.front() == ring.back() && ring.size() == 3) ring[0].x += 9;
    }
    ++seen[kind_of(ask(rings))];
    if (HasFailure()) FAIL() << i;
  }
  if (count < 2000) return;
  for (const ContactKind kind : {ContactKind::none, ContactKind::shared_endpoint, ContactKind::touch,
                                 ContactKind::crossing, ContactKind::overlap}) {
    EXPECT_GT(seen[kind], count / 100) << name_of(kind);
  }
}

// Every ring of three to seven vertices on a few places, three of them on one line: all ways in which vertices repeat
// and edges have no length. A ring is simple iff each vertex is new and it is no path to and fro; there are few such.
TEST(PolygonSimpleTest, EveryRingOnFewPlaces) {
  const std::array<Point2, 4> place{Point2{0, 0}, {1, 0}, {2, 0}, {0, 1}};
  int simple = 0, rings = 0;
  for (std::size_t length = 3; length <= 7; ++length) {
    for (std::size_t code = 0; code < std::size_t{1} << (2 * length); ++code) {
      Ring ring;
      for (std::size_t k = 0; k < length; ++k) ring.push_back(place[code >> (2 * k) & 3]);
      if (length == 3 && ring.front() == ring.back()) continue;
      ++rings;
      simple += !ask({ring}).meet();
      if (HasFailure()) FAIL() << length << " " << code;
    }
  }
  EXPECT_EQ(rings, 64 - 16 + 256 + 1024 + 4096 + 16384);
  // Triangles: three choices of two places on the line, times six orders; all four places: the line's must stand in
  // order, so eight. Each once more where the first vertex is repeated at the end.
  EXPECT_EQ(simple, 2 * (3 * 6 + 8));
}

TEST(PolygonSimpleTest, EveryPairOfTrianglesOnFewPlaces) {
  const std::array<Point2, 4> place{Point2{0, 0}, {1, 0}, {2, 0}, {0, 1}};
  for (std::size_t code = 0; code < 4096; ++code) {
    Ring ring;
    for (std::size_t k = 0; k < 6; ++k) ring.push_back(place[code >> (2 * k) & 3]);
    if (ring[0] == ring[2] || ring[3] == ring[5]) continue;
    EXPECT_TRUE(ask({{ring[0], ring[1], ring[2]}, {ring[3], ring[4], ring[5]}}).meet());  // of four places, six
    if (HasFailure()) FAIL() << code;
  }
}

// Where there is no grid, as its range overflows.
TEST(PolygonSimpleTest, AtTheEndsOfTheRange) {
  const double most = std::numeric_limits<double>::max(), little = std::numeric_limits<double>::denorm_min();
  for (const double x : {most, little}) {
    for (const double y : {most, little}) {
      EXPECT_FALSE(ask({{{-x, -y}, {x, -y}, {x, y}, {-x, y}}}).meet());
      EXPECT_EQ(ask({{{-x, -y}, {x, y}, {x, -y}, {-x, y}}}).found->kind, ContactKind::crossing);
      EXPECT_EQ(ask({{{-x, -y}, {x, -y}, {x, y}, {0, -y}, {-x, y}}}).found->kind, ContactKind::touch);
    }
  }
}

// A circle, with and without a bay where many edges crowd, and a fault somewhere.
TEST(PolygonSimpleTest, ManyEdges) {
  Random random(109);
  for (const std::size_t in_bay : {0u, 30u, 600u}) {
    if (in_bay == 0 && tests::is_scaled_down()) continue;
    Ring circle;
    for (int k = 0; k < 1500; ++k) {
      const double t = 6.283185307179586 * k / 1500;
      circle.push_back({std::cos(t), std::sin(t)});
    }
    for (std::size_t k = 0; k < in_bay; ++k) {
      circle.push_back({0.9 + 1e-6 * static_cast<double>(in_bay - k), k % 2 == 0 ? -2e-3 : -1e-3});  // to and fro
    }
    EXPECT_FALSE(ask({circle}).meet()) << in_bay;
    const std::uint64_t by_grid = polygon_simple_by_grid(Polygon(std::vector<Ring>{circle})).cost.probes;
    const std::uint64_t by_sweep = polygon_simple_by_sweep(Polygon(std::vector<Ring>{circle})).cost.probes;
    EXPECT_EQ(by_grid == by_sweep, in_bay == 600) << in_bay;  // too many in the bay: the grid leaves it to the sweep
    EXPECT_TRUE(in_bay == 600 || by_grid < 3 * circle.size()) << in_bay;
    for (int i = 0; i < tests::scaled_count(5, 3); ++i) {
      Ring worse = circle;
      const std::size_t n = circle.size(), k = i == 0 ? n - 9 : random.below(n), l = (k + n / 2) % n;
      switch (i % 3) {
        case 0: std::swap(worse[k], worse[(k + 2) % n]); break;
        case 1: worse[k] = worse[l]; break;
        default: worse.insert(worse.begin() + static_cast<std::ptrdiff_t>(k), worse[k]); break;
      }
      EXPECT_TRUE(ask({worse}).meet()) << in_bay << " " << i << " " << k;
    }
  }
}

}  // namespace
}  // namespace sunder::planar
