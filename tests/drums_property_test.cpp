// Lemmas 6 and 7 of Chazelle and Dobkin 1987, and what searches in drums rest on, in exact numbers on random polyhedra.
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/drums.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sunder::tests {
namespace {

using solid::ConvexPolyhedron;
using solid::Drums;
using Fraction = boost::multiprecision::cpp_rational;

struct Normal {
  int x, y, z;
};

// What n measures, without the height and with it.
Fraction sideways(const Normal& n, const Fraction& x, const Fraction& y) { return n.x * x + n.y * y; }

struct Measured {
  Fraction height, sideways;
};

// Where lateral edge k of a drum passes the slice.
Measured corner(const ConvexPolyhedron& body, const Drums& drums, std::uint32_t drum, std::uint32_t k,
                std::uint32_t slice, const Normal& n) {
  const solid::LateralEdge& e = drums.edge(drum, k);
  const Point3 &p = body.vertices()[e.low], &q = body.vertices()[e.high];
  const Fraction height(body.vertices()[drums.vertex_of(slice)].z);
  const Fraction t = (height - Fraction(p.z)) / (Fraction(q.z) - Fraction(p.z));
  const auto between = [&](double from, double to) -> Fraction {
    return Fraction(from) + t * (Fraction(to) - Fraction(from));
  };
  return {height, sideways(n, between(p.x, q.x), between(p.y, q.y))};
}

// The corners a_i and b_i of Q, from the drum above each slice, the last from the drum below.
struct Shadow {
  std::vector<Measured> least, greatest;
};

Shadow shadow_of(const ConvexPolyhedron& body, const Drums& drums, const Normal& n) {
  Shadow q;
  for (std::uint32_t slice = 0; slice < drums.slice_count(); ++slice) {
    const std::uint32_t drum = std::min(slice, drums.drum_count() - 1);
    for (std::uint32_t k = 0; k < drums.size(drum); ++k) {
      const Measured at = corner(body, drums, drum, k, slice, n);
      if (k == 0) {
        q.least.push_back(at);
        q.greatest.push_back(at);
      }
      if (at.sideways < q.least.back().sideways) q.least.back() = at;
      if (at.sideways > q.greatest.back().sideways) q.greatest.back() = at;
    }
  }
  return q;
}

int turn(const Measured& a, const Measured& b, const Measured& c) {
  const Fraction cross =
      (b.height - a.height) * (c.sideways - a.sideways) - (b.sideways - a.sideways) * (c.height - a.height);
  return cross.sign();
}

struct Case {
  ConvexPolyhedron body;
  Normal normal;
};

std::vector<Case> random_cases(std::uint64_t seed, int count) {
  Random random(seed);
  std::vector<Case> cases;
  while (static_cast<int>(cases.size()) < count) {
    const std::int64_t side = cases.size() % 3 == 0 ? 3 : 50;
    std::vector<Point3> points;
    for (std::int64_t i = random.between(4, 30); i > 0; --i) {
      const auto number = [&] { return static_cast<double>(random.between(-side, side)); };
      points.push_back({number(), number(), number()});
    }
    const ConvexPolyhedron body(points);
    if (body.drums().drum_count() == 0 || body.drums().direction() != Point3{0, 0, 1}) continue;
    const auto number = [&] { return static_cast<int>(random.between(-9, 9)); };
    const Normal n{number(), number(), number()};
    if (n.x == 0 && n.y == 0) continue;  // level: no lemma about these
    cases.push_back({body, n});
  }
  return cases;
}

TEST(DrumsProperty, Lemma6TheShadowPolygonIsConvex) {
  int turns = 0;
  for (const auto& [body, n] : random_cases(chosen_seed(6), scaled_count(500))) {
    const Shadow q = shadow_of(body, body.drums(), n);
    for (std::size_t i = 2; i < q.least.size(); ++i) {
      ASSERT_GE(turn(q.least[i - 2], q.least[i - 1], q.least[i]), 0);
      ASSERT_LE(turn(q.greatest[i - 2], q.greatest[i - 1], q.greatest[i]), 0);
      turns += turn(q.least[i - 2], q.least[i - 1], q.least[i]) > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(turns, scaled_count(500));
}

TEST(DrumsProperty, Lemma7ThePlaneMeetsTheBodyWhereItsLineMeetsTheShadow) {
  Random random(chosen_seed(7));
  int meet = 0, apart = 0, touch = 0;
  for (const auto& [body, n] : random_cases(chosen_seed(7), scaled_count(500))) {
    const Shadow q = shadow_of(body, body.drums(), n);
    for (int round = 0; round < 5; ++round) {
      const Point3& some = body.vertices()[random.below(body.vertices().size())];
      const Fraction offset = Fraction(random.between(-3, 3)) / 2 + sideways(n, Fraction(some.x), Fraction(some.y)) +
                              n.z * Fraction(some.z) + (round == 0 ? random.between(-100, 100) : 0);
      bool above = false, below = false, q_above = false, q_below = false, on = false;
      for (const Point3& v : body.vertices()) {
        const Fraction value = sideways(n, Fraction(v.x), Fraction(v.y)) + n.z * Fraction(v.z) - offset;
        above |= value >= 0;
        below |= value <= 0;
        on |= value == 0;
      }
      for (const auto* chain : {&q.least, &q.greatest}) {
        for (const Measured& corner : *chain) {
          q_above |= n.z * corner.height + corner.sideways >= offset;
          q_below |= n.z * corner.height + corner.sideways <= offset;
        }
      }
      ASSERT_EQ(above && below, q_above && q_below);
      ++(above && below ? meet : apart);
      touch += on ? 1 : 0;
    }
  }
  if (scaled_count(500) < 500) return;  // too few for the rates below
  EXPECT_GT(meet, 100);
  EXPECT_GT(apart, 100);
  EXPECT_GT(touch, 100);
}

// What pair/drum_search.h rests on: one lateral edge has the extreme corners of both slices of its drum.
TEST(DrumsProperty, OneLateralEdgeIsExtremeAllThroughADrum) {
  int drums_seen = 0;
  for (const auto& [body, n] : random_cases(chosen_seed(8), scaled_count(500))) {
    const Drums& drums = body.drums();
    for (std::uint32_t drum = 0; drum < drums.drum_count(); ++drum) {
      std::vector<Fraction> low, high;
      for (std::uint32_t k = 0; k < drums.size(drum); ++k) {
        low.push_back(corner(body, drums, drum, k, drum, n).sideways);
        high.push_back(corner(body, drums, drum, k, drum + 1, n).sideways);
      }
      const Fraction most_low = *std::max_element(low.begin(), low.end());
      const Fraction most_high = *std::max_element(high.begin(), high.end());
      bool one_is_both = false;
      for (std::size_t k = 0; k < low.size(); ++k) one_is_both |= low[k] == most_low && high[k] == most_high;
      ASSERT_TRUE(one_is_both);
      ++drums_seen;
    }
  }
  EXPECT_GT(drums_seen, scaled_count(500));
}

}  // namespace
}  // namespace sunder::tests
