// polygon_defects against its oracle, on small nasty multipolygons, under every rule.
#include <tests/support/nasty_polygons.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <sunder/planar/polygons/polygon_simple.h>
#include <sunder/planar/polygons/polygon_valid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace sunder::tests {
namespace {

using planar::PolygonDefect;
using planar::PolygonDefectKind;
using planar::PolygonDefects;
using planar::PolygonRings;
using planar::PolygonRule;
using planar::RingPlace;
using Kind = PolygonDefectKind;
using Parts = std::vector<PolygonRings>;

constexpr std::array<PolygonRule, 3> polygon_rules{PolygonRule::simple, PolygonRule::valid, PolygonRule::self_touch};

bool has(const PolygonDefects& answer, Kind kind) {
  return std::any_of(answer.found.begin(), answer.found.end(), [&](const PolygonDefect& d) { return d.kind == kind; });
}

// What both must name alike: of two edges all; of points the ring and the point; of holes and parts the rings.
using Named = std::tuple<Kind, RingPlace, RingPlace, double, double>;
std::set<Named> named(const PolygonDefects& answer) {
  std::set<Named> all;
  for (const PolygonDefect& d : answer.found) {
    const auto ring = [](RingPlace place) {
      place.edge = 0;
      return place;
    };
    switch (d.kind) {
      case Kind::too_few_points:
      case Kind::crossing:
      case Kind::overlap:
      case Kind::repeated_vertex: all.insert({d.kind, d.a, d.b, d.place.a.x, d.place.b.y}); break;
      case Kind::self_touch: all.insert({d.kind, ring(d.a), ring(d.b), d.place.a.x, d.place.a.y}); break;
      case Kind::rings_touch: all.insert({d.kind, {d.a.part, 0, 0}, {}, d.place.a.x, d.place.a.y}); break;
      case Kind::hole_outside: all.insert({d.kind, ring(d.a), ring(d.b), 0, 0}); break;
      case Kind::nested_holes: all.insert({d.kind, ring(d.a), {}, 0, 0}); break;
      case Kind::disconnected: all.insert({d.kind, {d.a.part, 0, 0}, {}, 0, 0}); break;
      case Kind::nested_parts: all.insert({d.kind, {}, {}, 0, 0}); break;
    }
  }
  return all;
}

// What is named is a place of that ring, and the point is on its edge.
void expect_places(const PolygonDefects& answer, const Parts& parts) {
  for (const PolygonDefect& d : answer.found) {
    for (const RingPlace& place : {d.a, d.b}) {
      ASSERT_LT(place.part, parts.size());
      ASSERT_LT(place.ring, parts[place.part].size());
      ASSERT_LT(place.edge, parts[place.part][place.ring].size());
    }
    const std::vector<Point2>& ring = parts[d.a.part][d.a.ring];
    const Point2 &p = ring[d.a.edge], &q = ring[(d.a.edge + 1) % ring.size()];
    if (d.kind == Kind::crossing) continue;  // its point may be rounded
    const Point2 at = d.place.a;
    EXPECT_EQ((q.x - p.x) * (at.y - p.y), (q.y - p.y) * (at.x - p.x)) << name_of(d.kind);
  }
}

struct ValidRates {
  int valid = 0, of_several = 0;
  std::map<Kind, int> kinds;
};

void compare_valid_on(const Parts& parts, PolygonRule rule, bool check_places, ValidRates& rates) {
  const PolygonDefects truth = planar::polygon_defects_by_scan(parts, {rule});
  const PolygonDefects answer = planar::polygon_defects(parts, {rule});
  ASSERT_EQ(answer.found.empty(), truth.found.empty());
  const std::set<Named> expected = named(truth), found = named(answer);
  const auto is_of_loops = [](const Named& n) { return std::get<0>(n) >= Kind::hole_outside; };
  const bool touches_itself = has(planar::polygon_defects(parts, {PolygonRule::valid}), Kind::self_touch);
  if (touches_itself) {  // then the oracle has no loops, and may know less of what lies in them
    std::set<Named> expected_here, found_here;
    std::copy_if(expected.begin(), expected.end(), std::inserter(expected_here, expected_here.end()),
                 std::not_fn(is_of_loops));
    std::copy_if(found.begin(), found.end(), std::inserter(found_here, found_here.end()), std::not_fn(is_of_loops));
    ASSERT_EQ(found_here, expected_here);
  } else {
    ASSERT_EQ(found, expected);
  }
  if (check_places) {
    ASSERT_NO_FATAL_FAILURE(expect_places(answer, parts));
  }
  const PolygonDefects first = planar::polygon_defects(parts, {rule, 1});
  ASSERT_EQ(first.found.size(), truth.found.empty() ? 0u : 1u);
  if (!first.found.empty()) {
    ASSERT_TRUE(has(answer, first.found[0].kind));
  }
  rates.valid += answer.found.empty();
  rates.of_several += !answer.found.empty() && answer.found.front().kind != answer.found.back().kind;
  for (int k = 0; k <= static_cast<int>(Kind::nested_parts); ++k) {
    rates.kinds[static_cast<Kind>(k)] += has(answer, static_cast<Kind>(k));
  }
}

std::string text_of_defects(const Parts& parts) {
  std::string text = "MULTIPOLYGON (";
  for (std::size_t p = 0; p < parts.size(); ++p) {
    text += p > 0 ? ", (" : "(";
    for (std::size_t r = 0; r < parts[p].size(); ++r) {
      text += r > 0 ? ", (" : "(";
      for (const Point2& v : parts[p][r]) text += std::to_string(v.x) + " " + std::to_string(v.y) + ", ";
      text += ")";
    }
    text += ")";
  }
  return text + ")";
}

TEST(PolygonValidDifferential, AgreesWithTheScan) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261122);
  SCOPED_TRACE("seed " + std::to_string(seed));
  NastyPolygons polygons(seed);
  std::array<ValidRates, 3> rates;
  for (int k = 0; k < count; ++k) {
    const NastyFamily family = static_cast<NastyFamily>(k % nasty_family_count);
    Parts parts = polygons.next(family);
    const bool any_scale = k % 97 == 0;  // exact fractions are slow
    if (any_scale) {
      const int scale = static_cast<int>(polygons.random().between(-1070, 1015));
      for (PolygonRings& rings : parts) {
        for (std::vector<Point2>& ring : rings) {
          for (Point2& p : ring) p = {std::ldexp(p.x, scale), std::ldexp(p.y, scale)};
        }
      }
    }
    for (std::size_t r = 0; r < polygon_rules.size(); ++r) {
      ASSERT_NO_FATAL_FAILURE(compare_valid_on(parts, polygon_rules[r], !any_scale, rates[r]))
          << k << " " << name_of(family) << " rule " << r << "\n"
          << text_of_defects(parts);
    }
  }
  for (std::size_t r = 0; r < polygon_rules.size(); ++r) {
    std::printf("rule %d: %d of %d valid, %d with several kinds\n", static_cast<int>(r), rates[r].valid, count,
                rates[r].of_several);
    for (const auto& [kind, n] : rates[r].kinds) std::printf("  %-16s %6d\n", name_of(kind).data(), n);
  }
  if (count < 2000) return;  // too few for the rates below
  for (std::size_t r = 0; r < polygon_rules.size(); ++r) {
    EXPECT_GT(rates[r].valid, count / 20);
    EXPECT_LT(rates[r].valid, count / 2);
    for (const auto& [kind, n] : rates[r].kinds) {
      const bool only_simple = kind == Kind::repeated_vertex || kind == Kind::rings_touch;
      const bool is_asked = only_simple ? r == 0 : kind != Kind::self_touch || r < 2;
      if (is_asked) {
        EXPECT_GT(n, count / 150) << r << " " << name_of(kind);
      } else {
        EXPECT_EQ(n, 0) << r << " " << name_of(kind);
      }
    }
    EXPECT_GT(rates[r].of_several, count / 20);
  }
}

// A hole around all of a part, after its other holes, or before them.
TEST(PolygonValidDifferential, AHoleAroundAll) {
  const int count = scaled_count(4000);
  const std::uint64_t seed = chosen_seed(20261124);
  SCOPED_TRACE("seed " + std::to_string(seed));
  NastyPolygons polygons(seed);
  std::array<ValidRates, 3> rates;
  for (int k = 0; k < count; ++k) {
    Parts parts = polygons.next(static_cast<NastyFamily>(k % nasty_family_count));
    PolygonRings& rings = parts[polygons.random().below(parts.size())];
    const std::size_t at = polygons.random().below(rings.size()) + 1;
    rings.insert(rings.begin() + static_cast<std::ptrdiff_t>(at), box_ring(-200, -200, 200, 200));
    for (std::size_t r = 0; r < polygon_rules.size(); ++r) {
      ASSERT_NO_FATAL_FAILURE(compare_valid_on(parts, polygon_rules[r], true, rates[r])) << k << " rule " << r << "\n"
                                                                                         << text_of_defects(parts);
    }
  }
  if (count < 2000) return;  // too few for the rates below
  EXPECT_EQ(rates[1].valid, 0);
  for (const Kind kind : {Kind::nested_holes, Kind::disconnected}) EXPECT_GT(rates[1].kinds[kind], count / 150);
}

// The rule `simple` is polygon_simple, and that holes lie where they must.
TEST(PolygonValidDifferential, SimpleIsAsPolygonSimple) {
  const int count = scaled_count(20000);
  NastyPolygons polygons(chosen_seed(20261123));
  int simple = 0;
  for (int k = 0; k < count; ++k) {
    const Parts parts = polygons.next(static_cast<NastyFamily>(k % nasty_family_count));
    for (const PolygonRings& rings : parts) {
      const PolygonDefects answer = planar::polygon_defects(std::span(&rings, 1), {PolygonRule::simple});
      const bool is_long = std::all_of(rings.begin(), rings.end(), [](const std::vector<Point2>& ring) {
        return ring.size() > 3 || (ring.size() == 3 && ring.front() != ring.back());
      });
      if (!is_long) continue;
      const bool is_simple = !polygon_simple_by_scan(planar::Polygon(rings)).meet();
      const bool only_placed = !answer.found.empty() && answer.found.front().kind >= Kind::hole_outside;
      ASSERT_EQ(answer.found.empty() || only_placed, is_simple) << text_of_defects(parts);
      simple += is_simple;
    }
  }
  EXPECT_GT(simple, count / 20);
}

}  // namespace
}  // namespace sunder::tests
