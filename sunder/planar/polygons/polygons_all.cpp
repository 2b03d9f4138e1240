#include <sunder/planar/polygons/edge_contact_lists.h>
#include <sunder/planar/polygons/polygon_contacts_in_order.h>
#include <sunder/planar/polygons/polygon_pairs.h>
#include <sunder/planar/polygons/polygon_sweep.h>
#include <sunder/planar/polygons/polygons_all.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace sunder::planar {

namespace {

// The contacts by this number, which is below `count`; those with the same one keep their order. Without comparisons,
// whose outcome nobody can predict.
std::vector<PolygonsContact> in_order_of(std::uint32_t PolygonsContact::* number, std::vector<PolygonsContact> contacts,
                                         std::uint32_t count) {
  std::vector<std::size_t> place(count);  // of the next one with this number
  for (const PolygonsContact& c : contacts) ++place[c.*number];
  std::size_t before = 0;
  for (std::size_t& p : place) before += std::exchange(p, before);
  std::vector<PolygonsContact> ordered(contacts.size());
  for (const PolygonsContact& c : contacts) ordered[place[c.*number]++] = c;
  return ordered;
}

// Pairs i < j that are added any number of times, each counted once: as an overlap where there is one. Kept are those
// of the lowest i: as bits of all pairs of so many i, or as keys, as many as may be held.
class PairCount {
 public:
  // Of `count` polygons. rows: the bits are of so many i; 0: keys are kept.
  PairCount(std::uint32_t count, std::uint32_t rows)
      : count_(count),
        most_(std::max(most_keys, std::size_t{2} * count)),
        end_(rows == 0 ? count : rows),
        is_there_(std::size_t{rows} * count),
        overlaps_(is_there_.size()) {}

  // Pairs whose i is below this are counted when all have been added. It falls where there are too many keys.
  const std::uint32_t& end() const { return end_; }

  void add(const PolygonsContact& c) {
    if (c.i >= end_) return;
    if (!is_there_.empty()) {
      const std::size_t at = std::size_t{c.i} * count_ + c.j;
      is_there_[at] = true;
      if (c.contact == Relation::overlapping) overlaps_[at] = true;
      return;
    }
    const std::uint64_t is_touching = c.contact == Relation::touching ? 1 : 0;
    const std::uint64_t key = std::uint64_t{c.i} << 32 | std::uint64_t{c.j} << 1 | is_touching;
    if (!keys_.empty() && keys_.back() == key) return;
    keys_.push_back(key);
    if (keys_.size() >= full_) compress();
  }

  void count_to(PolygonsCount& sum) {
    compress();
    for (const std::uint64_t key : keys_) ++(key % 2 == 1 ? sum.touching : sum.overlapping);
    const auto number = [](const std::vector<bool>& bits) {
      return static_cast<std::uint64_t>(std::count(bits.begin(), bits.end(), true));
    };
    sum.overlapping += number(overlaps_);
    sum.touching += number(is_there_) - number(overlaps_);
  }

  // Of so many i, all pairs of `count` polygons fit into the bits.
  static std::uint32_t rows_of_bits(std::uint32_t count) {
    return static_cast<std::uint32_t>(std::min(std::size_t{count}, most_bits / count));
  }

 private:
  static constexpr std::size_t most_bits = std::size_t{1} << 27, most_keys = std::size_t{1} << 20;

  // One of each pair, an overlap where there is one.
  void compress() {
    std::sort(keys_.begin(), keys_.end());
    const auto is_same = [](std::uint64_t a, std::uint64_t b) { return a / 2 == b / 2; };
    keys_.erase(std::unique(keys_.begin(), keys_.end(), is_same), keys_.end());
    if (keys_.size() > most_) {
      end_ = static_cast<std::uint32_t>(keys_[most_] >> 32);
      keys_.erase(std::lower_bound(keys_.begin(), keys_.end(), std::uint64_t{end_} << 32), keys_.end());
    }
    full_ = std::max(full_, std::min(2 * keys_.size(), 2 * most_));
    keys_.reserve(full_);
  }

  std::uint32_t count_;
  std::size_t most_;
  std::uint32_t end_;
  std::vector<bool> is_there_, overlaps_;  // of i and j, row by row
  std::vector<std::uint64_t> keys_;        // i, j, and whether they touch
  std::size_t full_ = 1 << 16;
};

// By sweeps, each of which counts the pairs of some i, from the lowest on: by keys, or by bits where these tell of
// more.
PolygonsCountAnswer count_by_sweeps(std::span<const Polygon> polygons, const SetOptions& all_options) {
  PolygonsCountAnswer answer;
  SetOptions options = all_options;
  for (std::uint32_t rows = 0; !polygons.empty();) {
    const std::uint32_t count = static_cast<std::uint32_t>(polygons.size());
    const PolygonEdges edges(pointers_to(polygons));
    PairCount pairs(count, rows);
    const auto add = [&](const PolygonsContact& c) {
      if (counts(c, options.allowed)) pairs.add(c);
      return true;
    };
    PolygonSweep sweep(edges, options, add, &pairs.end());
    sweep.run();
    pairs.count_to(answer.count);
    answer.cost.probes += sweep.cost.probes;
    polygons = polygons.subspan(pairs.end());
    if (!options.groups.empty()) options.groups = options.groups.subspan(pairs.end());
    if (polygons.empty()) break;
    const std::uint32_t left = static_cast<std::uint32_t>(polygons.size()), of_bits = PairCount::rows_of_bits(left);
    rows = of_bits >= std::min(pairs.end(), left) ? of_bits : 0;
  }
  return answer;
}

PolygonsAllAnswer all_by(PolygonsFinder* find, std::span<const Polygon> polygons, const SetOptions& options) {
  check_groups(options.groups, polygons.size());
  LowestContacts found(static_cast<std::uint32_t>(polygons.size()), std::numeric_limits<std::size_t>::max() / 2,
                       options.allowed);
  const Cost cost = find(polygons, options, found);
  return {found.take_in_order(), cost};
}

}  // namespace

PolygonsAllAnswer polygons_all(std::span<const Polygon> polygons, const SetOptions& options) {
  return polygons_all_by_boxes(polygons, options);
}

// Boxes give each pair once. Where they give up, a pair may be found many times.
PolygonsCountAnswer polygons_count(std::span<const Polygon> polygons, const SetOptions& options) {
  check_groups(options.groups, polygons.size());
  PolygonsCountAnswer answer;
  Cost cost;
  const bool is_counted = for_each_meeting_pair(polygons, options, cost, [&](const PolygonsContact& c) {
                            if (counts(c, options.allowed)) {
                              ++(c.contact == Relation::touching ? answer.count.touching : answer.count.overlapping);
                            }
                            return true;
                          }).has_value();
  if (!is_counted) answer = count_by_sweeps(polygons, options);
  answer.cost.probes += cost.probes;
  return answer;
}

PolygonsAllAnswer polygons_all_by_boxes(std::span<const Polygon> polygons, const SetOptions& options) {
  check_groups(options.groups, polygons.size());
  PolygonsAllAnswer answer;
  answer.found.reserve(std::min<std::size_t>(polygons.size(), 1024));
  const auto add = [&](const PolygonsContact& c) {
    if (counts(c, options.allowed)) answer.found.push_back(c);
    return true;
  };
  Cost cost;
  if (for_each_meeting_pair(polygons, options, cost, add)) {
    const std::uint32_t count = static_cast<std::uint32_t>(polygons.size());
    answer.found = in_order_of(&PolygonsContact::j, std::move(answer.found), count);
    answer.found = in_order_of(&PolygonsContact::i, std::move(answer.found), count);
  } else {
    answer = polygons_all_by_sweep(polygons, options);
  }
  answer.cost.probes += cost.probes;
  return answer;
}

PolygonsAllAnswer polygons_all_by_grid(std::span<const Polygon> polygons, const SetOptions& options) {
  return all_by(find_contacts_by_grid, polygons, options);
}

PolygonsAllAnswer polygons_all_by_sweep(std::span<const Polygon> polygons, const SetOptions& options) {
  return all_by(find_contacts_by_sweep, polygons, options);
}

Cost find_contacts_by_boxes(std::span<const Polygon> polygons, const SetOptions& options, LowestContacts& found) {
  Cost cost;
  const auto add = [&](const PolygonsContact& c) { return found.add(c); };
  if (for_each_meeting_pair(polygons, options, cost, add, &found.end())) return cost;
  found.forget();
  cost.probes += find_contacts_by_sweep(polygons, options, found).probes;
  return cost;
}

Cost find_contacts_by_grid(std::span<const Polygon> polygons, const SetOptions& options, LowestContacts& found) {
  PolygonEdges edges(pointers_to(polygons));
  PolygonMeetings meetings(edges, options.groups, [&](const PolygonsContact& c) { return found.add(c); });
  if (!take_contacts_by_grid(edges, {options.groups, true, options.progress}, meetings)) {
    found.forget();
    return find_contacts_by_sweep(polygons, options, found);
  }
  meetings.look_around_points();
  meetings.look_inside();
  return meetings.cost;
}

Cost find_contacts_by_sweep(std::span<const Polygon> polygons, const SetOptions& options, LowestContacts& found) {
  const PolygonEdges edges(pointers_to(polygons));
  PolygonSweep sweep(edges, options, [&](const PolygonsContact& c) { return found.add(c); }, &found.end());
  sweep.run();
  return sweep.cost;
}

}  // namespace sunder::planar
