// Bundles of every make against all of their pairs.
#include <sunder/base/random.h>
#include <sunder/planar/segments/contact_bundle.h>
#include <sunder/predicate/point/orient.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace sunder::planar {
namespace {

// About the origin: segments along few lines that end, pass, begin, or are points there.
struct Made {
  std::vector<Segment> given;
  std::vector<std::uint32_t> groups, row, begins, points, aside;
  std::vector<Point2> way;
};

Made make(Random& random, std::uint64_t most, std::uint64_t group_count) {
  constexpr std::array<Point2, 5> ways{{{1, 0}, {2, 1}, {1, 1}, {1, -3}, {0, 1}}};  // on, in the order of the sweep
  Made made;
  const std::uint64_t way_of_aside = random.below(ways.size()), way_count = 1 + random.below(ways.size());
  for (std::uint64_t n = random.below(most); n > 0; --n) {
    const std::uint32_t i = static_cast<std::uint32_t>(made.given.size());
    const bool is_aside = random.below(4) == 0;
    const Point2 way = ways[is_aside ? way_of_aside : random.below(way_count)];
    const double back = is_aside ? 1 : static_cast<double>(random.below(3));
    const double on = is_aside ? 2 : static_cast<double>(random.below(3));
    made.given.push_back({{-back * way.x, -back * way.y}, {on * way.x, on * way.y}});
    made.way.push_back(way);
    made.groups.push_back(static_cast<std::uint32_t>(random.below(group_count)));
    (is_aside ? made.aside : back > 0 ? made.row : on > 0 ? made.begins : made.points).push_back(i);
  }
  std::sort(made.row.begin(), made.row.end(), [&](std::uint32_t i, std::uint32_t j) {  // from below, before the origin
    const Sign side = orient_2d({0, 0}, made.given[i].a, made.given[j].a);
    return side == Sign::negative || (side == Sign::zero && i < j);
  });
  return made;
}

// What comes before: those that go back begin on lines by themselves, two steps before the origin and one.
void begin_before(ContactBundle& bundle, const Made& made) {
  for (std::uint32_t i = 0; i < made.given.size(); ++i) {
    std::vector<std::uint32_t> first, second;
    for (std::uint32_t j = 0; j < made.given.size(); ++j) {
      if (made.way[j] != made.way[i]) continue;
      if (made.given[j].a == Point2{-2 * made.way[i].x, -2 * made.way[i].y}) first.push_back(j);
      if (made.given[j].a == Point2{-made.way[i].x, -made.way[i].y}) second.push_back(j);
    }
    if (!first.empty()) bundle.set({}, first, {}, &made.given[first[0]].a);
    if (!second.empty()) bundle.set(first, second, {}, &made.given[second[0]].a);
  }
}

TEST(ContactBundleTest, GivesThePairsThatCount) {
  Random random(20261123);
  const Point2 origin{0, 0};
  std::map<ContactKind, int> kinds;
  for (int turn = 0; turn < 6000; ++turn) {
    const Made made = make(random, turn % 10 == 0 ? 40 : 9, 1 + random.below(5));
    const Segments segments(made.given);
    SetOptions options{static_cast<Allowed>(turn % 3)};
    if (turn % 2 == 0) options.groups = made.groups;
    const auto begins = [&](std::uint32_t i) { return segments[i].a == origin && segments[i].b != origin; };
    const auto passes_aside = [&](std::uint32_t i) { return std::count(made.aside.begin(), made.aside.end(), i) > 0; };
    std::vector<SegmentsContact> truth, given;
    for (std::uint32_t j = 0; j < segments.size(); ++j) {
      for (std::uint32_t i = 0; i < j; ++i) {
        const ContactKind kind = segment_segment(segments[i], segments[j]);
        ASSERT_NE(kind, ContactKind::none);
        if (!counts(kind, options.allowed) || may_meet(options.groups, i, j)) continue;
        if (kind == ContactKind::overlap && !begins(i) && !begins(j)) continue;
        if (kind == ContactKind::crossing && (passes_aside(i) || passes_aside(j))) continue;
        truth.push_back({i, j, kind});
        ++kinds[kind];
      }
    }
    const SegmentsVisitor visit = [&](const SegmentsContact& contact) {
      given.push_back(contact);
      return true;
    };
    Cost cost;
    ContactBundle bundle(segments, options, visit, cost);
    begin_before(bundle, made);
    bundle.set(made.row, made.begins, made.points, &origin);
    std::vector<std::uint32_t> after;
    for (const std::uint32_t i : made.row) {
      if (segments[i].b != origin) after.push_back(i);
    }
    after.insert(after.end(), made.begins.begin(), made.begins.end());
    std::sort(after.begin(), after.end(), [&](std::uint32_t i, std::uint32_t j) {
      const Sign side = orient_2d(origin, segments[i].b, segments[j].b);
      return side == Sign::positive || (side == Sign::zero && i < j);
    });
    ASSERT_EQ(bundle.after(), after) << turn;
    if (!made.aside.empty()) bundle.add_aside(made.aside);
    ASSERT_TRUE(bundle.visit());
    for (std::uint32_t j = 0; j < segments.size(); ++j) {
      for (std::uint32_t i = 0; i < j; ++i) {
        if (segments[i].b == origin || segments[j].b == origin) continue;  // not at one time on the line
        ASSERT_EQ(bundle.on_one_line(i, j), made.way[i] == made.way[j]) << turn;
      }
    }
    std::sort(given.begin(), given.end());
    std::sort(truth.begin(), truth.end());
    ASSERT_EQ(given, truth) << turn;
    if (truth.empty()) continue;
    const SegmentsVisitor stop = [](const SegmentsContact&) { return false; };
    ContactBundle stopped(segments, options, stop, cost);
    begin_before(stopped, made);
    stopped.set(made.row, made.begins, made.points, &origin);
    if (!made.aside.empty()) stopped.add_aside(made.aside);
    ASSERT_FALSE(stopped.visit()) << turn;
  }
  for (const ContactKind kind :
       {ContactKind::shared_endpoint, ContactKind::touch, ContactKind::crossing, ContactKind::overlap}) {
    EXPECT_GT(kinds[kind], 5000) << name_of(kind);
  }
}

// What does not count is not looked at one by one: by kind, by one group, by one line with as many groups.
TEST(ContactBundleTest, PairsThatDoNotCountAreFree) {
  constexpr std::uint32_t n = 10000;
  const Point2 origin{0, 0};
  std::vector<Segment> fan, pencil, line;
  std::vector<std::uint32_t> one(n, 0), all(n), reversed(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double k = i;
    fan.push_back({{0, 0}, {n, k}});
    pencil.push_back({{-1.0 * n, -k}, {n, k}});
    line.push_back({{-1.0 * n, 0}, {n + k, 0}});
    all[i] = i;
    reversed[n - 1 - i] = i;
  }
  const auto probes = [&](const std::vector<Segment>& given, const SetOptions& options, bool begin) {
    const Segments segments(given);
    const SegmentsVisitor none = [](const SegmentsContact&) {
      ADD_FAILURE();
      return false;
    };
    Cost cost;
    ContactBundle bundle(segments, options, none, cost);
    if (!begin && segments[0].a == segments[n - 1].a) bundle.set({}, all, {}, &segments[0].a);
    cost = {};
    bundle.set(begin ? std::span<const std::uint32_t>() : reversed, begin ? all : std::span<const std::uint32_t>(), {},
               &origin);
    EXPECT_TRUE(bundle.visit());
    return cost.probes;
  };
  EXPECT_LE(probes(fan, {Allowed::touch}, true), 20 * n);
  EXPECT_LE(probes(fan, {Allowed::nothing, one}, true), 20 * n);
  EXPECT_LE(probes(pencil, {Allowed::nothing, one}, false), 4 * n);
  EXPECT_LE(probes(line, {Allowed::nothing, all}, false), 4 * n);
}

}  // namespace
}  // namespace sunder::planar
