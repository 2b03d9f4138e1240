// All pairs of boxes that meet.
// Also called: box or rectangle intersection reporting; broad phase.
//
// By a uniform grid (near_pairs.h) where it pays. Else by halving, for any boxes: in the order of their left sides, box
// j begins inside of box i, or where it begins, iff its place is in the range of those from the place after i to the
// last one that begins no further right than i ends. A tree over the places splits each range to nodes that it covers,
// two a level at most; there, those that cover the node are matched with those that have their place in it by their
// bottoms and tops alone, in one merge. Source: Zomorodian & Edelsbrunner 2000, in the plane.
// Pairs of one group are not looked at: in a merge, boxes of one group that follow each other are passed as one, and
// the next one is of another group.
#pragma once

#include <sunder/near/near_pairs.h>
#include <sunder/near/set_question.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace sunder {

template <class OfPair>
class BoxPairsByHalving {
 public:
  BoxPairsByHalving(std::span<const Box2> boxes, const OfPair& of_pair, Groups groups = {})
      : boxes_(boxes), of_pair_(of_pair), groups_(groups) {}

  bool run() {
    const std::uint32_t n = static_cast<std::uint32_t>(boxes_.size());
    List by_left(n), by_bottom(n);
    std::iota(by_left.begin(), by_left.end(), 0u);
    by_bottom = by_left;
    std::sort(by_left.begin(), by_left.end(), [&](std::uint32_t i, std::uint32_t j) {
      return boxes_[i].low.x != boxes_[j].low.x ? boxes_[i].low.x < boxes_[j].low.x : i < j;
    });
    std::sort(by_bottom.begin(), by_bottom.end(), [&](std::uint32_t i, std::uint32_t j) {
      return boxes_[i].low.y != boxes_[j].low.y ? boxes_[i].low.y < boxes_[j].low.y : i < j;
    });
    places_.resize(n);
    for (std::uint32_t place = 0; place < n; ++place) {
      const std::uint32_t i = by_left[place];
      const auto end = std::upper_bound(by_left.begin(), by_left.end(), boxes_[i].high.x,
                                        [&](double x, std::uint32_t j) { return x < boxes_[j].low.x; });
      places_[i] = {place, static_cast<std::uint32_t>(end - by_left.begin())};
    }
    List ranges;
    std::copy_if(by_bottom.begin(), by_bottom.end(), std::back_inserter(ranges),
                 [&](std::uint32_t i) { return places_[i].place + 1 < places_[i].end; });
    looks_ += 3 * std::uint64_t{n} * static_cast<std::uint64_t>(std::bit_width(n));  // three searches and sorts
    return visit(0, n, std::move(ranges), std::move(by_bottom));
  }

  std::uint64_t looks() const { return looks_; }

 private:
  using List = std::vector<std::uint32_t>;
  struct Places {
    std::uint32_t place, end;  // the range goes from place + 1 to end, which does not belong to it
  };

  bool report(std::uint32_t i, std::uint32_t j) { return of_pair_(std::min(i, j), std::max(i, j)); }

  // The boxes `in` have their places from `begin` to `end`; the ranges of `over` meet this. Both by their bottoms.
  bool visit(std::uint32_t begin, std::uint32_t end, List over, List in) {
    if (over.empty() || in.empty()) return true;
    looks_ += over.size() + in.size();
    if (are_of_one_group(over, in)) return true;
    if (end - begin <= few || over.size() <= few) return visit_all(over, in);
    const std::uint32_t middle = begin + (end - begin) / 2;
    List covering, over_left, over_right, in_left, in_right;
    for (const std::uint32_t i : over) {
      const auto [place, last] = places_[i];
      if (place < begin && end <= last) {
        covering.push_back(i);
        continue;
      }
      if (place + 1 < middle) over_left.push_back(i);
      if (last > middle) over_right.push_back(i);
    }
    if (!match(covering, in)) return false;
    for (const std::uint32_t i : in) (places_[i].place < middle ? in_left : in_right).push_back(i);
    List().swap(over);
    List().swap(in);
    return visit(begin, middle, std::move(over_left), std::move(in_left)) &&
           visit(middle, end, std::move(over_right), std::move(in_right));
  }

  bool visit_all(const List& over, const List& in) {
    for (const std::uint32_t i : over) {
      const Box2& a = boxes_[i];
      for (const std::uint32_t j : in) {
        const Box2& b = boxes_[j];
        ++looks_;
        if (b.low.y > a.high.y) break;
        const bool begins_inside = places_[i].place < places_[j].place && places_[j].place < places_[i].end;
        if (begins_inside && a.low.y <= b.high.y && !may_meet(groups_, i, j) && !report(i, j)) return false;
      }
    }
    return true;
  }

  // Each of one list with each of the other, by bottoms and tops.
  bool match(const List& some, const List& others) {
    const List some_runs = ends_of_runs(some), other_runs = ends_of_runs(others);
    std::size_t k = 0, l = 0;
    while (k < some.size() && l < others.size()) {
      const bool first = boxes_[some[k]].low.y <= boxes_[others[l]].low.y;
      const List& list = first ? others : some;
      const List& runs = first ? other_runs : some_runs;
      const std::uint32_t i = first ? some[k++] : others[l++];
      for (std::size_t at = first ? l : k; at < list.size() && boxes_[list[at]].low.y <= boxes_[i].high.y;) {
        if (may_meet(groups_, i, list[at])) {
          ++looks_;
          at = runs[at];
        } else if (!report(i, list[at++])) {
          return false;
        }
      }
    }
    return true;
  }

  // Where there are groups: of each place of the list, the next one whose box is of another group.
  List ends_of_runs(const List& list) const {
    if (groups_.empty()) return {};
    List ends(list.size());
    for (std::size_t k = list.size(); k-- > 0;) {
      const bool goes_on = k + 1 < list.size() && may_meet(groups_, list[k], list[k + 1]);
      ends[k] = goes_on ? ends[k + 1] : static_cast<std::uint32_t>(k + 1);
    }
    return ends;
  }

  bool are_of_one_group(const List& some, const List& others) const {
    const auto is_of_it = [&](std::uint32_t i) { return may_meet(groups_, i, some[0]); };
    return !groups_.empty() && std::all_of(some.begin(), some.end(), is_of_it) &&
           std::all_of(others.begin(), others.end(), is_of_it);
  }

  static constexpr std::uint32_t few = 16;
  std::span<const Box2> boxes_;
  const OfPair& of_pair_;
  Groups groups_;
  std::vector<Places> places_;
  std::uint64_t looks_ = 0;
};

// Calls of_pair(i, j), i < j, once for each pair of boxes that meet and are not of one group, in no particular order,
// until it returns false. Requires fewer than 2^31 boxes, no end NaN, none below its low one. Returns whether it never
// did. Adds to `looks`, where given, how often it looked at a box. Cost: O(N log N + k) for k pairs that are given.
template <class OfPair>
bool for_each_box_pair(std::span<const Box2> boxes, const OfPair& of_pair,
                       const std::function<void(double)>& progress = nullptr, std::uint64_t* looks = nullptr,
                       Groups groups = {}) {
  if (looks != nullptr) *looks += boxes.size();
  if (are_one_group(groups)) return true;
  const std::optional<BoxGrid> grid = BoxGrid::over(boxes, extents_of_boxes(boxes));
  if (grid && crowded(*grid, crowd_of_polygons) == 0) {
    if (looks != nullptr) *looks += pairs_in_cells(*grid);
    const auto across_groups = [&](std::uint32_t i, std::uint32_t j) {
      return may_meet(groups, i, j) || of_pair(i, j);
    };
    return for_each_near_pair<crowd_of_polygons>(boxes, *grid, across_groups, progress);
  }
  BoxPairsByHalving<OfPair> halving(boxes, of_pair, groups);
  const bool all = halving.run();
  if (looks != nullptr) *looks += halving.looks();
  return all;
}

}  // namespace sunder
