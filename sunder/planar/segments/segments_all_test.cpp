// Known answers, stopping, groups, progress, and how the number of comparisons grows.
#include <sunder/base/random.h>
#include <sunder/planar/segments/segments_all.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace sunder::planar {
namespace {

using tests::on_circle, tests::short_segments;

constexpr std::array segment_methods{&segments_all_by_scan, &segments_all_by_bentley_ottmann, &segments_all_by_grid,
                                     &segments_visit};

using SegmentKinds = std::map<ContactKind, std::size_t>;

// What all methods list, kind by kind.
SegmentKinds segment_kinds_of(const std::vector<Segment>& given, const SetOptions& options = {}) {
  const Segments segments(given);
  SegmentKinds first;
  for (std::size_t m = 0; m < segment_methods.size(); ++m) {
    SegmentKinds kinds;
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    segment_methods[m](segments, options, [&](const SegmentsContact& contact) {
      EXPECT_LT(contact.i, contact.j);
      EXPECT_LT(contact.j, segments.size());
      EXPECT_TRUE(pairs.insert({contact.i, contact.j}).second) << m << ": " << contact.i << ", " << contact.j;
      ++kinds[contact.kind];
      return true;
    });
    if (m == 0) first = kinds;
    EXPECT_EQ(kinds, first) << m;
    EXPECT_EQ(segments_all(segments, options).found.size(), pairs.size());
    EXPECT_EQ(segments_count(segments, options).count, pairs.size());
  }
  return first;
}

TEST(SegmentsAllTest, NoneAndOne) {
  EXPECT_EQ(segment_kinds_of({}), SegmentKinds{});
  EXPECT_EQ(segment_kinds_of({{{0, 0}, {1, 1}}}), SegmentKinds{});
  EXPECT_EQ(segment_kinds_of({{{1, 1}, {1, 1}}}), SegmentKinds{});
  EXPECT_EQ(segment_kinds_of({{{0, 0}, {1, 1}}, {{0, 1}, {1, 2}}}), SegmentKinds{});
}

// n from one point, whichever way: n (n - 1) / 2 pairs.
TEST(SegmentsAllTest, Fans) {
  for (const std::size_t n : {3u, 12u, 200u}) {
    const std::size_t pairs = n * (n - 1) / 2;
    std::vector<Segment> fan, touching, star;
    for (std::size_t k = 0; k < n; ++k) {
      const Point2 tip = on_circle((static_cast<double>(k) + 0.25) / static_cast<double>(n));
      fan.push_back({{0, 0}, tip});
    }
    EXPECT_EQ(segment_kinds_of(fan), (SegmentKinds{{ContactKind::shared_endpoint, pairs}})) << n;
    EXPECT_EQ(segment_kinds_of(fan, {Allowed::shared_endpoint}), SegmentKinds{});
    fan.push_back({{-2, 0}, {2, 0}});  // through their common end
    EXPECT_EQ(segment_kinds_of(fan), (SegmentKinds{{ContactKind::shared_endpoint, pairs}, {ContactKind::touch, n}}));
    EXPECT_EQ(segment_kinds_of(fan, {Allowed::shared_endpoint}), (SegmentKinds{{ContactKind::touch, n}}));
    EXPECT_EQ(segment_kinds_of(fan, {Allowed::touch}), SegmentKinds{});
    fan.push_back({{0, 0}, {0, 0}});  // and a point there
    EXPECT_EQ(segment_kinds_of(fan),
              (SegmentKinds{{ContactKind::shared_endpoint, pairs + n}, {ContactKind::touch, n + 1}}));
    // Exactly through one point, which is no end.
    for (std::size_t k = 1; k <= n; ++k) {
      const double x = static_cast<double>(k), y = static_cast<double>(n + 1 - k);
      star.push_back({{0.5 - x, 0.25 - y}, {0.5 + x, 0.25 + y}});
    }
    EXPECT_EQ(segment_kinds_of(star), (SegmentKinds{{ContactKind::crossing, pairs}})) << n;
    EXPECT_EQ(segment_kinds_of(star, {Allowed::touch}), (SegmentKinds{{ContactKind::crossing, pairs}})) << n;
  }
}

TEST(SegmentsAllTest, GridsOfLines) {
  for (const std::size_t n : {1u, 2u, 7u, 40u}) {
    for (const double out : {1.0, 0.0}) {  // beyond the others' ends, or up to these
      std::vector<Segment> lines, tilted;
      const double last = static_cast<double>(n) - 1;
      for (std::size_t k = 0; k < n; ++k) {
        const double at = static_cast<double>(k);
        lines.push_back({{at, -out}, {at, last + out}});
        lines.push_back({{-out, at}, {last + out, at}});
      }
      for (const Segment& s : lines) tilted.push_back({{s.a.x - s.a.y, s.a.x + s.a.y}, {s.b.x - s.b.y, s.b.x + s.b.y}});
      const SegmentKinds expected = out > 0  ? SegmentKinds{{ContactKind::crossing, n * n}}
                                    : n == 1 ? SegmentKinds{{ContactKind::shared_endpoint, 1}}
                                    : n == 2 ? SegmentKinds{{ContactKind::shared_endpoint, 4}}
                                             : SegmentKinds{{ContactKind::shared_endpoint, 4},
                                                            {ContactKind::touch, 4 * (n - 2)},
                                                            {ContactKind::crossing, (n - 2) * (n - 2)}};
      EXPECT_EQ(segment_kinds_of(lines), expected) << n << " " << out;
      EXPECT_EQ(segment_kinds_of(tilted), expected) << n << " " << out;
    }
  }
}

TEST(SegmentsAllTest, OnOneLineAndRepeated) {
  std::vector<Segment> same(20, Segment{{0, 0}, {3, 1}}), points(20, Segment{{1, 1}, {1, 1}}), chain, nested;
  EXPECT_EQ(segment_kinds_of(same), (SegmentKinds{{ContactKind::overlap, 190}}));
  EXPECT_EQ(segment_kinds_of(same, {Allowed::touch}), (SegmentKinds{{ContactKind::overlap, 190}}));
  EXPECT_EQ(segment_kinds_of(points), (SegmentKinds{{ContactKind::shared_endpoint, 190}}));
  for (int k = 0; k < 20; ++k) {
    chain.push_back({{3.0 * k, 1.0 * k}, {3.0 * k + 3, 1.0 * k + 1}});
    nested.push_back({{-3.0 * k - 1.5, -1.0 * k - 0.5}, {3.0 * k + 4.5, 1.0 * k + 1.5}});
  }
  EXPECT_EQ(segment_kinds_of(chain), (SegmentKinds{{ContactKind::shared_endpoint, 19}}));
  EXPECT_EQ(segment_kinds_of(nested), (SegmentKinds{{ContactKind::overlap, 190}}));
  nested.push_back({{1.5, -9}, {1.5, 9}});  // across all
  EXPECT_EQ(segment_kinds_of(nested), (SegmentKinds{{ContactKind::overlap, 190}, {ContactKind::crossing, 20}}));
  nested.push_back({{1.5, 0.5}, {1.5, 0.5}});  // a point on all
  EXPECT_EQ(segment_kinds_of(nested),
            (SegmentKinds{{ContactKind::overlap, 190}, {ContactKind::crossing, 20}, {ContactKind::touch, 21}}));
}

TEST(SegmentsAllTest, Groups) {
  const std::vector<Segment> plus{{{-1, 0}, {1, 0}}, {{0, -1}, {0, 1}}, {{-1, -1}, {1, 1}}};
  const std::vector<std::uint32_t> all_one{4, 4, 4}, two{0, 9, 0}, own{0, 1, 2};
  SetOptions options;
  options.groups = all_one;
  EXPECT_EQ(segment_kinds_of(plus, options), SegmentKinds{});
  options.groups = two;
  EXPECT_EQ(segment_kinds_of(plus, options), (SegmentKinds{{ContactKind::crossing, 2}}));
  options.groups = own;
  EXPECT_EQ(segment_kinds_of(plus, options), (SegmentKinds{{ContactKind::crossing, 3}}));
}

// Some hundred edges of a mesh, or many in one place, or across each other: enough for each way of going on.
std::vector<Segment> mesh(std::uint32_t side, Random& random) {
  std::vector<Segment> edges;
  std::vector<Point2> p;
  for (std::uint32_t k = 0; k < (side + 1) * (side + 1); ++k) {
    p.push_back({k % (side + 1) + random.uniform(-0.3, 0.3), k / (side + 1) + random.uniform(-0.3, 0.3)});
  }
  for (std::uint32_t k = 0; k < p.size(); ++k) {
    if (k % (side + 1) < side) edges.push_back({p[k], p[k + 1]});
    if (k / (side + 1) < side) edges.push_back({p[k], p[k + side + 1]});
  }
  return edges;
}

TEST(SegmentsAllTest, StopsWhenTold) {
  Random random(161);
  std::vector<Segment> crowded = short_segments(1200, {0, 0}, 30, 1, random), long_ones;
  for (const Segment& s : short_segments(300, {10.25, 10.25}, 0.01, 0.01, random)) crowded.push_back(s);
  long_ones = short_segments(200, {0, 0}, 1, 1, random);
  for (const auto& given : {crowded, long_ones, mesh(12, random)}) {
    const Segments segments(given);
    const std::size_t all = segments_count(segments).count;
    ASSERT_GT(all, 100u);
    for (const auto& method : segment_methods) {
      for (const std::size_t most : {std::size_t{1}, std::size_t{2}, all / 3, all - 1}) {
        std::size_t called = 0;
        method(segments, {}, [&](const SegmentsContact&) { return ++called < most; });
        EXPECT_EQ(called, most);
      }
    }
  }
}

// Where many crowd in a cell of the grid: each rule, and groups.
TEST(SegmentsAllTest, Crowds) {
  Random random(166);
  for (const double grain : {0x1p-7, 0x1p-40}) {  // coarse: touches and overlaps
    if (grain == 0x1p-40 && tests::is_scaled_down()) continue;
    std::vector<Segment> given = short_segments(1000, {0, 0}, 30, 0.5, random);
    for (Segment s : short_segments(270, {10.25, 10.25}, 0.02, 0.05, random)) {
      for (double* x : {&s.a.x, &s.a.y, &s.b.x, &s.b.y}) *x = std::round(*x / grain) * grain;
      given.push_back(s);
    }
    std::vector<std::uint32_t> groups;
    for (std::size_t k = 0; k < given.size(); ++k) groups.push_back(static_cast<std::uint32_t>(random.below(3)));
    for (const Allowed allowed : {Allowed::nothing, Allowed::shared_endpoint, Allowed::touch}) {
      SetOptions options{allowed};
      const std::size_t all = segment_kinds_of(given, options)[ContactKind::crossing];
      EXPECT_GT(all, 2000u);
      options.groups = groups;
      EXPECT_LT(segment_kinds_of(given, options)[ContactKind::crossing], all);
    }
  }
  // Two bundles whose members cross, all of one group but for one pair in either of them, or elsewhere.
  std::vector<Segment> given = short_segments(1200, {0, 0}, 30, 1e-6, random);
  for (const double at : {10.25, 20.25}) {
    for (int k = 0; k < 60; ++k) {
      const double y = 1e-4 * k;
      given.push_back({{at, at + y}, {at + 0.05, at + 0.05 - y}});
    }
  }
  given.push_back({{29, 29}, {29.25, 29}});
  given.push_back({{29.125, 28.9}, {29.125, 29.1}});
  const Segments segments(given);
  for (const std::uint32_t other : {segments.size(), 1210u, 1270u, segments.size() - 1}) {
    std::vector<std::uint32_t> groups(segments.size(), 5);
    if (other < segments.size()) groups[other] = 6;
    SetOptions options;
    options.groups = groups;
    const SegmentsAnswer grid = segments_any_by_grid(segments, options);
    ASSERT_EQ(grid.meet(), other < segments.size()) << other;
    if (!grid.meet()) continue;
    EXPECT_LT(grid.found->i, grid.found->j);
    EXPECT_TRUE(grid.found->i == other || grid.found->j == other) << other;
    EXPECT_EQ(segment_segment(segments[grid.found->i], segments[grid.found->j]), grid.found->kind);
  }
}

// The whole, in parts that do not shrink.
TEST(SegmentsAllTest, ProgressIsTold) {
  Random random(162);
  const Segments edges(short_segments(40000, {0, 0}, 1, 1e-5, random));  // apart, of 80000 ends
  SetOptions options;
  std::vector<double> told;
  options.progress = [&](double part) { told.push_back(part); };
  const auto check = [&](std::size_t least_calls) {
    EXPECT_GE(told.size(), least_calls);
    EXPECT_LE(told.size(), 4u);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    for (const double part : told) EXPECT_TRUE(0 <= part && part <= 1);
    told.clear();
  };
  const SegmentsVisitor go_on = [](const SegmentsContact&) { return true; };
  segments_all_by_bentley_ottmann(edges, options, go_on);
  check(2);
  segments_all_by_grid(edges, options, go_on);
  check(1);
  EXPECT_FALSE(segments_any_by_grid(edges, options).meet());
  check(1);
  EXPECT_FALSE(segments_any_by_sweep(edges, options).meet());
  check(2);
  EXPECT_FALSE(segments_any_by_bentley_ottmann(edges, options).meet());
  check(2);
}

// Counted by hand, in small sets: each comparison once, and none too many.
TEST(SegmentsAllTest, Comparisons) {
  const std::vector<Segment> parallel{{{0, 0}, {2, 0}}, {{1, 1}, {3, 1}}}, cross{{{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}},
      across_both{{{0, 0}, {4, 0}}, {{1, 1}, {5, 1}}, {{2, 0.5}, {2.25, 3}}};
  const auto sweep = [](const std::vector<Segment>& given) {
    return segments_any_by_sweep(Segments(given)).cost.probes;
  };
  const auto all = [](SegmentsMethod& method, const std::vector<Segment>& given) {
    return method(Segments(given), {}, [](const SegmentsContact&) { return true; }).probes;
  };
  // Where it enters; whether they will meet, which ends the matter, or else what they do.
  EXPECT_EQ(sweep(parallel), 2u);
  EXPECT_EQ(sweep(cross), 3u);
  EXPECT_EQ(all(segments_all_by_bentley_ottmann, parallel), 2u);
  EXPECT_EQ(all(segments_all_by_bentley_ottmann, cross), 3u);
  // The third one enters between two, with the one above a contact: nothing more.
  EXPECT_EQ(sweep(across_both), 2u + 2u + 1u + 2u);
  // The second one stands beside the first, above or below: nothing is searched, nothing left to look at.
  for (const double y : {1, -1}) {
    const Segments corner(std::vector<Segment>{{{0, 0}, {3, 0}}, {{0, 0}, {2, y}}});
    EXPECT_EQ(segments_any_by_sweep(corner, {Allowed::shared_endpoint}).cost.probes, 1u);
  }
  EXPECT_EQ(all(segments_all_by_scan, across_both), 3u);
  EXPECT_EQ(all(segments_all_by_grid, across_both), 3u + 1u);  // boxes, of which two meet
}

// Complexity: (N + k) (log2 N + 3) comparisons, whatever the kinds of contacts are.
TEST(SegmentsAllTest, ComparisonsGrowAsNAndContactsTimesLogN) {
  Random random(163);
  for (std::uint32_t n = 64; n <= 4096; n *= 4) {
    const double size = n;
    std::vector<std::pair<const char*, std::vector<Segment>>> families{
        {"apart", short_segments(n, {0, 0}, 1, 0.1 / size, random)},
        {"some cross", short_segments(n, {0, 0}, 1, 1 / std::sqrt(size), random)},
        {"many cross", short_segments(n, {0, 0}, 1, 4 / std::sqrt(size), random)},
        {"mesh", mesh(static_cast<std::uint32_t>(std::sqrt(size / 2)), random)},
        {"lines", {}},
        {"fans", {}},
        {"towers", {}},
        {"combs", {}}};
    const double half = size / 2;
    for (std::uint32_t k = 0; k < n; ++k) {
      const double at = k / 2;
      families[4].second.push_back(k % 2 == 0 ? Segment{{at, -1}, {at, half}} : Segment{{-1, at}, {half, at}});
      families[5].second.push_back({{std::floor(k / 16.0), 0}, {std::floor(k / 16.0) + 0.5, k % 16 - 8.0}});
      families[6].second.push_back({{std::floor(k / 32.0), k % 32 * 1.0}, {std::floor(k / 32.0), k % 32 + 1.0}});
      families[7].second.push_back(k % 8 == 0 ? Segment{{at, 0}, {at + 4, 0}}
                                              : Segment{{at + 0.25, 0}, {at + 0.25, k % 3 - 1.0}});
    }
    if (n > 1024) families.erase(families.begin() + 4);  // a million crossings
    for (const auto& [name, given] : families) {
      const Segments segments(given);
      std::size_t contacts = 0;
      const Cost cost = segments_all_by_bentley_ottmann(segments, {}, [&](const SegmentsContact&) {
        ++contacts;
        return true;
      });
      const double count = segments.size();
      EXPECT_LE(static_cast<double>(cost.probes),
                1.5 * (count + static_cast<double>(contacts)) * (std::log2(count) + 3))
          << n << " " << name << ", contacts: " << contacts;
    }
  }
}

// On a mesh a grid finds a few pairs to compare for each edge, however many there are; and where it lists contacts.
TEST(SegmentsAllTest, ComparisonsByGridGrowAsN) {
  Random random(164);
  for (std::uint32_t n = 1u << 6; n <= 1u << 18; n *= 8) {
    const Segments edges(mesh(static_cast<std::uint32_t>(std::sqrt(n / 2)), random));
    const SegmentsAnswer answer = segments_any_by_grid(edges, {Allowed::shared_endpoint});
    EXPECT_FALSE(answer.meet());
    EXPECT_GE(answer.cost.probes, edges.size());  // those that share an end
    EXPECT_LE(answer.cost.probes, 8 * std::uint64_t{edges.size()}) << n;
    const CountAnswer<> all = segments_count(edges, {Allowed::nothing});
    EXPECT_LE(all.cost.probes, 8 * std::uint64_t{edges.size()}) << n;
  }
}

// Overlaps: k grows as N^2, and so may the comparisons, but not as N^3.
TEST(SegmentsAllTest, OverlapsAreNotComparedAgainAtEachEnd) {
  for (std::uint32_t n = 64; n <= 512; n *= 2) {
    std::vector<Segment> stairs, across;
    for (std::uint32_t k = 0; k < n; ++k) {
      stairs.push_back({{1.0 * k, 0}, {n + k + 0.5, 0}});
      across.push_back(k % 2 == 0 ? Segment{{-1.0 - k, 0}, {1.0 * n + k, 0}} : Segment{{k + 0.5, -1}, {k + 0.25, 1}});
    }
    for (const auto& given : {stairs, across}) {
      const Segments segments(given);
      const double size = n, contacts = static_cast<double>(segments_count(segments).count);
      for (const auto& method : {&segments_all_by_bentley_ottmann, &segments_visit}) {
        const Cost cost = method(segments, {}, [](const SegmentsContact&) { return true; });
        EXPECT_LE(static_cast<double>(cost.probes), 1.5 * (size + contacts) * (std::log2(size) + 3)) << n;
      }
    }
  }
}

// Long ones that cross each other and share many crowded cells: their contacts are looked for once, not in each cell.
TEST(SegmentsAllTest, CrowdsThatShareSegments) {
  Random random(165);
  const std::uint32_t n = 1u << 18, longs = 512;
  const double side = std::sqrt(n);
  std::vector<Segment> given;
  for (std::uint32_t k = 0; k < n; ++k) {
    const Point2 p{random.uniform(0, side), random.uniform(1.2, side)};
    given.push_back({p, {p.x + random.uniform(0, 0.3), p.y + random.uniform(-0.2, 0.3)}});
  }
  for (std::uint32_t k = 0; k < longs; ++k) {
    given.push_back({{1, random.uniform(0, 0.3)}, {230, random.uniform(0, 0.3)}});
  }
  const Segments segments(given);
  std::size_t contacts = 0;
  const Cost cost = segments_all_by_grid(segments, {}, [&](const SegmentsContact&) { return ++contacts != 0; });
  const double size = segments.size();
  EXPECT_LE(static_cast<double>(cost.probes), 1.5 * (size + static_cast<double>(contacts)) * (std::log2(size) + 3));
}

}  // namespace
}  // namespace sunder::planar
