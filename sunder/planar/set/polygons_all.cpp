#include <sunder/planar/set/edge_contact_lists.h>
#include <sunder/planar/set/polygon_contacts_in_order.h>
#include <sunder/planar/set/polygon_pairs.h>
#include <sunder/planar/set/polygon_sweep.h>
#include <sunder/planar/set/polygons_all.h>

#include <algorithm>
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

// Counts pairs that are added any number of times. Memory: at most 16 bytes for each pair.
class PairCount {
 public:
  void add(const PolygonsContact& c) {
    const std::uint64_t is_touching = c.contact == Contact::touching ? 1 : 0;
    const std::uint64_t key = std::uint64_t{c.i} << 32 | std::uint64_t{c.j} << 1 | is_touching;
    if (!keys_.empty() && keys_.back() == key) return;
    keys_.push_back(key);
    if (keys_.size() >= full_) compress();
  }

  PolygonsCountAnswer counted() && {
    compress();
    PolygonsCountAnswer answer;
    for (const std::uint64_t key : keys_) ++(key % 2 == 1 ? answer.touching : answer.overlapping);
    return answer;
  }

 private:
  // One of each pair, an overlap where there is one.
  void compress() {
    std::sort(keys_.begin(), keys_.end());
    const auto is_same = [](std::uint64_t a, std::uint64_t b) { return a / 2 == b / 2; };
    keys_.erase(std::unique(keys_.begin(), keys_.end(), is_same), keys_.end());
    full_ = std::max(full_, 2 * keys_.size());
    keys_.reserve(full_);
  }

  std::vector<std::uint64_t> keys_;  // i, j, and whether they touch
  std::size_t full_ = 1 << 16;
};

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

// Nothing but the pairs is kept, and that only where boxes give up: then a pair may be found many times.
PolygonsCountAnswer polygons_count(std::span<const Polygon> polygons, const SetOptions& options) {
  check_groups(options.groups, polygons.size());
  PolygonsCountAnswer answer;
  Cost cost;
  const bool is_counted = for_each_meeting_pair(polygons, options, cost, [&](const PolygonsContact& c) {
                            if (counts(c, options.allowed)) {
                              ++(c.contact == Contact::touching ? answer.touching : answer.overlapping);
                            }
                            return true;
                          }).has_value();
  if (!is_counted) {
    const PolygonEdges edges(pointers_to(polygons));
    PairCount count;
    PolygonSweep sweep(edges, options, [&](const PolygonsContact& c) {
      if (counts(c, options.allowed)) count.add(c);
      return true;
    });
    sweep.run();
    answer = std::move(count).counted();
    answer.cost = sweep.cost;
  }
  answer.cost.probes += cost.probes;
  return answer;
}

PolygonsAllAnswer polygons_all_by_boxes(std::span<const Polygon> polygons, const SetOptions& options) {
  check_groups(options.groups, polygons.size());
  PolygonsAllAnswer answer;
  const auto add = [&](const PolygonsContact& c) {
    if (counts(c, options.allowed)) answer.contacts.push_back(c);
    return true;
  };
  Cost cost;
  if (for_each_meeting_pair(polygons, options, cost, add)) {
    const std::uint32_t count = static_cast<std::uint32_t>(polygons.size());
    answer.contacts = in_order_of(&PolygonsContact::j, std::move(answer.contacts), count);
    answer.contacts = in_order_of(&PolygonsContact::i, std::move(answer.contacts), count);
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
  PolygonSweep sweep(edges, options, [&](const PolygonsContact& c) { return found.add(c); });
  sweep.run();
  return sweep.cost;
}

}  // namespace sunder::planar
