#include <sunder/base/random.h>
#include <sunder/planar/region/disc_intersection.h>
#include <sunder/planar/region/discs_prepared.h>
#include <sunder/predicate/disc/disc_powers.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace sunder::planar {
namespace {

using IntersectionKind = DiscIntersectionKind;
using Arcs = std::vector<std::uint32_t>;

DiscIntersection common_part_of_discs(const std::vector<Disc>& given) {
  const Discs circles(given);
  const DiscIntersection front = disc_intersection(circles);
  for (const auto method : {disc_intersection_by_division, disc_intersection_by_batches, disc_intersection_by_scan}) {
    const DiscIntersection other = method(circles);
    EXPECT_EQ(other.kind, front.kind);
    EXPECT_EQ(other.arcs, front.arcs);
  }
  return front;
}
Arcs arcs(const std::vector<Disc>& given) {
  const DiscIntersection part = common_part_of_discs(given);
  EXPECT_EQ(part.kind, IntersectionKind::region);
  return part.arcs;
}
IntersectionKind kind_of_discs(const std::vector<Disc>& given) { return common_part_of_discs(given).kind; }

TEST(DiscsTest, FewDiscs) {
  EXPECT_EQ(kind_of_discs({}), IntersectionKind::plane);
  EXPECT_EQ(kind_of_discs({{{1, 2}, 0}}), IntersectionKind::point);
  EXPECT_EQ(arcs({{{1, 2}, 3}}), (Arcs{0}));
  EXPECT_EQ(arcs({{{0, 0}, 5}, {{6, 0}, 5}}), (Arcs{0, 1}));
  EXPECT_EQ(arcs({{{0, 0}, 9}, {{1, 0}, 2}, {{0, 0}, 7}}), (Arcs{1}));
  EXPECT_EQ(arcs({{{0, 0}, 9}, {{1, 0}, 8}}), (Arcs{1}));               // touches from inside
  EXPECT_EQ(arcs({{{0, 0}, 2}, {{0, 0}, 1}, {{0, 0}, 1}}), (Arcs{1}));  // equal: the lowest
  EXPECT_EQ(kind_of_discs({{{0, 0}, 1}, {{3, 0}, 2}}), IntersectionKind::point);
  EXPECT_EQ(kind_of_discs({{{0, 0}, 1}, {{3, 0}, 1.5}}), IntersectionKind::empty);
  EXPECT_EQ(kind_of_discs({{{0, 0}, 5}, {{3, 4}, 0}}), IntersectionKind::point);  // a point on a circle
  EXPECT_EQ(kind_of_discs({{{3, 4}, 0}, {{3, 4}, 0}, {{0, 0}, 5}}), IntersectionKind::point);
  EXPECT_EQ(kind_of_discs({{{0, 0}, std::nextafter(5, 0)}, {{3, 4}, 0}}), IntersectionKind::empty);
}

// A small disc cut on both sides comes twice; corners go round.
TEST(DiscsTest, OneDiscTwice) {
  const std::vector<Disc> given{{{0, 0}, 5}, {{-3, 0}, 5}, {{3, 0}, 5}, {{0, 0}, 3.5}};
  const Discs circles(given);
  const DiscIntersection part = common_part_of_discs(given);
  EXPECT_EQ(part.arcs, (Arcs{1, 3, 2, 3}));
  const Point2 first = nearest(corner(circles, part, 0)), second = nearest(corner(circles, part, 1)),
               third = nearest(corner(circles, part, 2)), last = nearest(corner(circles, part, 3));
  EXPECT_GT(first.x, 0);
  EXPECT_GT(first.y, 0);
  EXPECT_EQ(second, (Point2{-first.x, first.y}));
  EXPECT_EQ(third, (Point2{-first.x, -first.y}));
  EXPECT_EQ(last, (Point2{first.x, -first.y}));
}

// Discs through one point have no arc there, but those that bound the part next to it.
TEST(DiscsTest, ThroughOnePoint) {
  // All through (0, 0); seen from there the centres are up.
  EXPECT_EQ(arcs({{{3, 4}, 5}, {{-3, 4}, 5}, {{0, 5}, 5}}), (Arcs{0, 1}));
  EXPECT_EQ(arcs({{{3, 4}, 5}, {{-3, 4}, 5}, {{0, 1}, 1}}), (Arcs{0, 1, 2}));
  EXPECT_EQ(kind_of_discs({{{4, 3}, 5}, {{-4, 3}, 5}, {{0, -5}, 5}}), IntersectionKind::point);
  EXPECT_EQ(kind_of_discs({{{4, 3}, 5}, {{-4, 3}, 5}, {{0, -5}, 5}, {{3, 4}, 5}, {{12, -5}, 13}}),
            IntersectionKind::point);
}

// Barely empty, a point, barely not: three discs about a common point, one of them a unit in the last place smaller or
// larger.
TEST(DiscsTest, LastBit) {
  for (const double scale : {1.0, 0x1p-1000, 0x1p1000}) {
    const auto set = [&](double r) {
      return std::vector<Disc>{
          {{4 * scale, 3 * scale}, 5 * scale}, {{-4 * scale, 3 * scale}, 5 * scale}, {{0, -5 * scale}, r}};
    };
    EXPECT_EQ(kind_of_discs(set(5 * scale)), IntersectionKind::point);
    EXPECT_EQ(kind_of_discs(set(std::nextafter(5 * scale, 0))), IntersectionKind::empty);
    EXPECT_EQ(arcs(set(std::nextafter(5 * scale, HUGE_VAL))), (Arcs{0, 1, 2}));
  }
}

// A part between two neighbouring doubles: the viewpoint has more bits.
TEST(DiscsTest, NarrowerThanDoubles) {
  const double x = 0x1p33, unit = 0x1p-19, part = 0x1p-30;
  const std::vector<Disc> lens{{{x, 0}, 3 * part}, {{x + unit, 0}, unit - part}};
  EXPECT_EQ(arcs(lens), (Arcs{0, 1}));
  Cost cost;
  const Viewpoint view = inside_of_all(lens, discs_deepest(lens).point, cost);
  EXPECT_LT(view.in.x.low, view.in.x.high);
  for (const Disc& c : lens) EXPECT_EQ(power_at(view, c), Sign::negative);
  std::vector<Disc> more = lens;
  more.push_back({{x, 2 * part}, 3 * part});
  more.push_back({{x + part, -part}, 2 * part});
  EXPECT_EQ(common_part_of_discs(more).kind, IntersectionKind::region);
  EXPECT_GT(common_part_of_discs(more).arcs.size(), 2u);
}

TEST(DiscsTest, Symmetries) {
  Random random(15);
  int regions = 0;
  for (int i = 0; i < 1500; ++i) {
    std::vector<Disc> given;
    for (std::int64_t n = random.between(1, 12); n > 0; --n) {
      given.push_back({{random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(0.8, 2)});
    }
    const DiscIntersection part = disc_intersection(Discs(given));
    regions += part.kind == IntersectionKind::region;
    const auto changed = [&](const auto& change) {
      std::vector<Disc> other = given;
      for (Disc& c : other) c = change(c);
      return disc_intersection(Discs(other));
    };
    const DiscIntersection scaled =
        changed([](const Disc& c) { return Disc{{c.center.x * 8, c.center.y * 8}, c.radius * 8}; });
    const DiscIntersection turned = changed([](const Disc& c) { return Disc{{-c.center.y, c.center.x}, c.radius}; });
    DiscIntersection reflected = changed([](const Disc& c) { return Disc{{-c.center.x, c.center.y}, c.radius}; });
    ASSERT_EQ(scaled.arcs, part.arcs) << i;
    ASSERT_EQ(turned.arcs, part.arcs) << i;
    std::reverse(reflected.arcs.begin(), reflected.arcs.end());
    if (part.arcs.empty()) continue;
    // Turned round, from the same arc on.
    Arcs& arcs = reflected.arcs;
    bool is_same = false;
    for (std::size_t k = 0; k < arcs.size() && !is_same; ++k) {
      std::rotate(arcs.begin(), arcs.begin() + 1, arcs.end());
      is_same = arcs == part.arcs;
    }
    ASSERT_TRUE(is_same) << i;
  }
  EXPECT_GT(regions, 300);
}

// Theorem 13: a constant times N log N, whether few discs bound the part or all of them do; with batches the first ones
// are linear. Both methods agree on large sets.
TEST(DiscsTest, ProbesGrowAsTheTheoremSays) {
  for (std::uint32_t n = 1u << 4; n <= 1u << 14; n *= 4) {
    Random random(n);
    std::vector<Disc> few, all, many_sizes;
    for (std::uint32_t k = 0; k < n; ++k) {
      const double t = 6.283185307179586 * (k + 0.4 * random.unit()) / n;
      few.push_back({{random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(1.6, 3)});
      all.push_back({{0.5 * std::cos(t), 0.5 * std::sin(t)}, 1});
      const double r = random.uniform(1, 1000);
      many_sizes.push_back({{r * std::cos(t), r * std::sin(t)}, r + 1});
    }
    tests::shuffle(all, random);
    const double bound = 1.5 * n * std::log2(n) + 20 * n;
    const DiscIntersection few_left = disc_intersection_by_division(Discs(few)),
                           all_left = disc_intersection_by_division(Discs(all)),
                           sizes = disc_intersection_by_division(Discs(many_sizes));
    EXPECT_EQ(few_left.kind, IntersectionKind::region);
    EXPECT_EQ(all_left.arcs.size(), n);
    EXPECT_LT(few_left.arcs.size(), n / 2 + 1);
    for (const DiscIntersection& part : {few_left, all_left, sizes}) {
      EXPECT_LE(static_cast<double>(part.cost.probes), bound) << n;
    }
    const DiscIntersection fast = disc_intersection_by_batches(Discs(few));
    EXPECT_EQ(fast.arcs, few_left.arcs);
    EXPECT_LE(static_cast<double>(fast.cost.probes), 16.0 * n + 1500) << n;
    EXPECT_EQ(disc_intersection_by_batches(Discs(all)).arcs, all_left.arcs);
    EXPECT_EQ(disc_intersection_by_batches(Discs(many_sizes)).arcs, sizes.arcs);
  }
}

// The box holds the part: points of it are found inside.
TEST(DiscsTest, BoxOfChain) {
  Random random(16);
  int tight = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<Disc> given;
    for (std::int64_t n = random.between(1, 6); n > 0; --n) {
      given.push_back({{random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(1.5, 3)});
    }
    Arcs all(given.size());
    std::iota(all.begin(), all.end(), 0u);
    ArcChains chains(given, viewpoint({0, 0}));  // inside of all: 1.5 > sqrt(2)
    const Enclosure2 box = chains.box(chains.divide(all));
    const auto in_all = [&](const Point2& p) {
      return std::all_of(given.begin(), given.end(), [&](const Disc& c) { return power_at(p, c) != Sign::positive; });
    };
    double left = 0, right = 0, low = 0, high = 0;
    for (int k = 0; k < 300; ++k) {
      const Point2 p{random.uniform(-3, 3), random.uniform(-3, 3)};
      if (!in_all(p)) continue;
      left = std::min(left, p.x);
      right = std::max(right, p.x);
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
    ASSERT_LE(box.x.low, left) << i;
    ASSERT_GE(box.x.high, right) << i;
    ASSERT_LE(box.y.low, low) << i;
    ASSERT_GE(box.y.high, high) << i;
    // No side could be further in by much.
    const auto is_tight = [&](double inner, double outer, double size) { return outer - inner < 0.5 * size; };
    tight += is_tight(right, box.x.high, box.x.high - box.x.low) && is_tight(high, box.y.high, box.y.high - box.y.low);
  }
  EXPECT_GT(tight, 1500);
}

}  // namespace
}  // namespace sunder::planar
