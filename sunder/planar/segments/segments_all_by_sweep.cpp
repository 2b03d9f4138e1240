// A sweep: which one, a sample of pairs tells.
//
// Balaban's passes each crossing for itself: O(N log N + k). That of Bentley and Ottmann takes log N for each place,
// but many that cross in one point are one place; where they are of one group, none of their crossings has to be given.
// Both pass crossings within groups. So where many segments cross, and few boxes of different groups meet, these pairs
// are tested, and no others.
#include <sunder/base/random.h>
#include <sunder/near/set_methods.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/predicate/line/crossing.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

namespace sunder::planar {

namespace {

constexpr std::uint32_t few_segments = 128;  // of so many, all pairs are tested faster than any order is made
constexpr std::uint32_t many = 16;           // hits among N pairs by chance: k is about N times half of that
constexpr std::size_t enough = 128;          // crossings within groups
constexpr std::uint32_t no_chance = 4;       // so many of these have a point in common, and it is not by chance

// Of N pairs at most, always the same ones; those that only share an end, or overlap, are no hits: these no sweep
// passes one by one.
struct Sample {
  double pairs = 0, hits = 0;
  std::vector<Enclosure2> within_groups;  // of the hits, the crossings that need not be given

  Sample(const Segments& segments, Groups groups) {
    Random random(1);
    for (; pairs < segments.size() && (groups.empty() ? hits < many : within_groups.size() < enough); ++pairs) {
      const std::uint32_t i = static_cast<std::uint32_t>(random.below(segments.size()));
      const std::uint32_t j = static_cast<std::uint32_t>(random.below(segments.size()));
      const Segment &s = segments[i], &t = segments[j];
      const ContactKind kind = i == j ? ContactKind::none : segment_segment(s, t);
      if (kind == ContactKind::none || kind == ContactKind::shared_endpoint || kind == ContactKind::overlap) {
        continue;
      }
      ++hits;
      if (kind == ContactKind::crossing && may_meet(groups, i, j)) {
        within_groups.push_back(enclosure({s.a, s.b, t.a, t.b}));
      }
    }
  }

  // How many pairs of these have a point in common, it seems?
  double together() const {
    const auto meet = [](const Interval& a, const Interval& b) { return a.low <= b.high && b.low <= a.high; };
    double count = 0;
    for (auto p = within_groups.begin(); p != within_groups.end(); ++p) {
      count += static_cast<double>(std::count_if(
          within_groups.begin(), p, [&](const Enclosure2& q) { return meet(p->x, q.x) && meet(p->y, q.y); }));
    }
    return count;
  }

  // Does Bentley and Ottmann's sweep take less? With u crossings within groups in d points, about sqrt(2 u d) segments
  // pass through these; of a sample of c, c^2 / (2 d) pairs have a point in common.
  bool is_for_bentley_ottmann(double n) const {
    if (hits < many) return true;
    const double pairs_together = together(), c = static_cast<double>(within_groups.size());
    if (pairs_together < no_chance) return false;
    const double all = hits / pairs * n * n / 2, within = c / hits * all, points = c * c / (2 * pairs_together);
    return (all - within + std::sqrt(2 * within * points)) * std::log2(n) < all;
  }
};

std::vector<Box2> boxes_of(const Segments& segments) {
  std::vector<Box2> boxes;
  boxes.reserve(segments.size());
  for (const Segment& s : segments.all()) boxes.push_back(box_of(s));
  return boxes;
}

// The pairs of different groups whose boxes meet, where they are at most 4 N log2 N: else nothing, and `cost` is what
// it took to know this.
std::optional<Cost> visit_across_groups(const Segments& segments, const SetOptions& options,
                                        const SegmentsVisitor& visit, Cost& cost) {
  const std::vector<Box2> boxes = boxes_of(segments);
  const std::uint64_t most =
      std::uint64_t{4} * segments.size() * static_cast<std::uint64_t>(std::bit_width(segments.size()));
  const std::size_t most_held = 4 * boxes.size();
  std::vector<std::array<std::uint32_t, 2>> held;
  std::uint64_t pairs = 0;
  const auto hold = [&](std::uint32_t i, std::uint32_t j) {
    if (held.size() < most_held) held.push_back({i, j});
    return ++pairs <= most;
  };
  BoxPairsByHalving<decltype(hold)> halving(boxes, hold, options.groups);
  const bool are_few = halving.run();
  cost.probes += halving.looks() + pairs;
  if (!are_few) return std::nullopt;
  Cost visited = cost;
  if (pairs == held.size()) {
    const auto test = pair_test(segments, options, visited, visit);
    static_cast<void>(std::all_of(held.begin(), held.end(), [&](const auto& pair) { return test(pair[0], pair[1]); }));
  } else {
    visited.probes += visit_by_halving(segments, boxes, options, visit).probes;
  }
  return visited;
}

}  // namespace

Cost segments_all_by_sweep(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit) {
  check_groups(options.groups, segments.size());
  if (segments.size() <= few_segments) return segments_all_by_scan(segments, options, visit);
  if (are_one_group(options.groups)) return Cost{segments.size()};
  const Sample sample(segments, options.groups);
  Cost before{static_cast<std::uint64_t>(sample.pairs)};
  if (!options.groups.empty() && sample.hits >= many) {
    if (const std::optional<Cost> all = visit_across_groups(segments, options, visit, before)) return *all;
  }
  SegmentsMethod& method =
      sample.is_for_bentley_ottmann(segments.size()) ? segments_all_by_bentley_ottmann : segments_all_by_balaban;
  Cost cost = method(segments, options, visit);
  cost.probes += before.probes;
  return cost;
}

}  // namespace sunder::planar
