// Lemmas 6, 7 and 9 of Chazelle and Dobkin 1987, and what searches in drums rest on, in exact numbers on random
// polyhedra.
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/represent/of.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
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
    const Drums& drums = solid::represent::of<Drums>(body);
    if (drums.drum_count() == 0 || drums.direction() != Point3{0, 0, 1}) continue;
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
    const Shadow q = shadow_of(body, solid::represent::of<Drums>(body), n);
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
    const Shadow q = shadow_of(body, solid::represent::of<Drums>(body), n);
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

// A plane seen along an axis.
struct Flat {
  Fraction u, v;
  bool is_on_slice = false;
};
using Outline = std::vector<Flat>;  // counter-clockwise

Fraction cross(const Flat& o, const Flat& a, const Flat& b) {
  return (a.u - o.u) * (b.v - o.v) - (a.v - o.v) * (b.u - o.u);
}

// Is one side of a so that all of b is beyond it? Which.
std::optional<std::size_t> side_that_parts(const Outline& a, const Outline& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Flat &p = a[i], &q = a[(i + 1) % a.size()];
    if (std::all_of(b.begin(), b.end(), [&](const Flat& r) { return cross(p, q, r) < 0; })) return i;
  }
  return std::nullopt;
}
bool meet(const Outline& a, const Outline& b) { return !side_that_parts(a, b) && !side_that_parts(b, a); }

// The section of a body by n = offset as all of its outline's points on edges of the body and on slices. Empty where a
// corner of a slice is in the plane, or nothing is cut.
Outline section_of(const ConvexPolyhedron& body, const Drums& drums, const Normal& n, const Fraction& offset) {
  struct Corner {
    Fraction x, y, z, value;
  };
  const auto at = [&](std::uint32_t drum, std::uint32_t k, std::uint32_t slice) -> Corner {
    const solid::LateralEdge& e = drums.edge(drum, k);
    const Point3 &p = body.vertices()[e.low], &q = body.vertices()[e.high];
    const Fraction z(body.vertices()[drums.vertex_of(slice)].z);
    const Fraction t = (z - Fraction(p.z)) / (Fraction(q.z) - Fraction(p.z));
    const Fraction x = Fraction(p.x) + t * (Fraction(q.x) - Fraction(p.x)),
                   y = Fraction(p.y) + t * (Fraction(q.y) - Fraction(p.y));
    return {x, y, z, n.x * x + n.y * y + n.z * z - offset};
  };
  Outline points;
  bool is_general = true;
  const auto add = [&](const Corner& a, const Corner& b, bool is_on_slice) {
    is_general &= a.value != 0 && b.value != 0;
    if (!is_general || (a.value > 0) == (b.value > 0)) return;
    const Fraction t = a.value / (a.value - b.value);
    const auto between = [&](const Fraction& from, const Fraction& to) -> Fraction { return from + t * (to - from); };
    const Fraction along = n.x != 0 ? between(a.y, b.y) : between(a.x, b.x);
    points.push_back({along, between(a.z, b.z), is_on_slice});
  };
  for (std::uint32_t slice = 0; slice < drums.slice_count(); ++slice) {
    const std::uint32_t drum = std::min(slice, drums.drum_count() - 1), size = drums.size(drum);
    for (std::uint32_t k = 0; k < size; ++k) {
      add(at(drum, k, slice), at(drum, k + 1 < size ? k + 1 : 0, slice), true);
      if (slice == drum) add(at(drum, k, drum), at(drum, k, drum + 1), false);
    }
  }
  if (!is_general || points.size() < 3) return {};
  Flat middle;
  for (const Flat& p : points) {
    middle.u += p.u / points.size();
    middle.v += p.v / points.size();
  }
  const auto is_lower = [&](const Flat& p) { return p.v < middle.v || (p.v == middle.v && p.u < middle.u); };
  std::sort(points.begin(), points.end(), [&](const Flat& p, const Flat& q) {
    return is_lower(p) != is_lower(q) ? is_lower(q) : cross(middle, p, q) > 0;
  });
  return points;
}

// W are the section's corners on slices, a pocket what is between two that follow each other. Where a line parts R from
// W, R meets the section only in the pockets beside where the line is nearest to W.
TEST(DrumsProperty, Lemma9APolygonPartedFromTheCornersMeetsTheSectionInPocketsBesideThem) {
  Random random(chosen_seed(9));
  int in_pocket = 0, apart = 0, by_side = 0, by_corner = 0;
  for (const auto& [body, n] : random_cases(chosen_seed(10), scaled_count(500))) {
    const Point3& some = body.vertices()[random.below(body.vertices().size())];
    const Fraction offset = Fraction(random.between(-50, 50)) / 7 + sideways(n, Fraction(some.x), Fraction(some.y)) +
                            n.z * Fraction(some.z) + Fraction(1) / 13;
    const Outline q = section_of(body, solid::represent::of<Drums>(body), n, offset);
    std::vector<std::size_t> corners;  // of W, in q
    Outline w;
    for (std::size_t k = 0; k < q.size(); ++k) {
      if (!q[k].is_on_slice) continue;
      corners.push_back(k);
      w.push_back(q[k]);
    }
    if (w.size() < 3) continue;
    const auto pocket = [&](std::size_t i) {
      Outline part;
      const std::size_t end = corners[(i + 1) % corners.size()];
      for (std::size_t k = corners[i]; k != end; k = (k + 1) % q.size()) part.push_back(q[k]);
      part.push_back(q[end]);
      return part;
    };
    for (int round = 0; round < 20; ++round) {
      // About a point of the section's outline, which may be in a pocket.
      const Flat& about = q[random.below(q.size())];
      Outline r;
      for (int k = 0; k < 3; ++k) {
        const auto off = [&]() -> Fraction { return Fraction(random.between(-100, 100)) / 37; };
        r.push_back({about.u + off(), about.v + off(), false});
      }
      const int turn = cross(r[0], r[1], r[2]).sign();
      if (turn == 0) continue;
      if (turn < 0) std::swap(r[1], r[2]);
      std::vector<std::size_t> beside;
      if (const auto side = side_that_parts(w, r)) {
        beside = {*side};
        ++by_side;
      } else if (const auto of_r = side_that_parts(r, w)) {
        const Flat &a = r[*of_r], &b = r[(*of_r + 1) % r.size()];
        std::size_t nearest = 0;
        for (std::size_t k = 1; k < w.size(); ++k) {
          if (cross(a, b, w[k]) > cross(a, b, w[nearest])) nearest = k;
        }
        beside = {(nearest + w.size() - 1) % w.size(), nearest};
        ++by_corner;
      } else {
        continue;
      }
      const bool is_in_pocket =
          std::any_of(beside.begin(), beside.end(), [&](std::size_t i) { return meet(pocket(i), r); });
      ASSERT_EQ(meet(q, r), is_in_pocket);
      ++(is_in_pocket ? in_pocket : apart);
    }
  }
  if (scaled_count(500) < 500) return;  // too few for the rates below
  EXPECT_GT(in_pocket, 100);
  EXPECT_GT(apart, 100);
  EXPECT_GT(by_side, 100);
  EXPECT_GT(by_corner, 100);
}

// What search/drum_search.h rests on: one lateral edge has the extreme corners of both slices of its drum.
TEST(DrumsProperty, OneLateralEdgeIsExtremeAllThroughADrum) {
  int drums_seen = 0;
  for (const auto& [body, n] : random_cases(chosen_seed(8), scaled_count(500))) {
    const Drums& drums = solid::represent::of<Drums>(body);
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
