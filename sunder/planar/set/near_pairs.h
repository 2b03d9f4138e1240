// The pairs of segments that a grid finds near each other.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/planar/object/lanes_box.h>
#include <sunder/planar/set/contact_rule.h>
#include <sunder/planar/set/prefetch.h>
#include <sunder/planar/set/segment_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace sunder::planar {

// How many segments make a crowd in a cell: of more, a sweep is faster than all pairs. The sweep that stops at a
// contact is fast, the one that passes them is slow.
inline constexpr std::size_t crowd_for_any = 48, crowd_for_all = 256;

// How many places in cells are in crowded ones?
inline std::size_t crowded(const SegmentGrid& grid, std::size_t crowd) {
  std::size_t count = 0;
  for (std::uint32_t c = 0; c < grid.cell_count(); ++c) {
    if (grid.cell(c).size() > crowd) count += grid.cell(c).size();
  }
  return count;
}

// Would a sweep over all be the better way? Where more than half of the places are in crowds, or the other cells have
// so many pairs of boxes to look at that few of them can be contacts. (A sweep takes as long for a comparison as a cell
// for a dozen pairs of boxes.)
inline bool is_too_much(const SegmentGrid& grid, std::size_t crowd, std::uint32_t count) {
  constexpr double most_looks = 10;  // over N log2 N
  std::uint64_t looks = 0, in_crowds = 0;
  for (std::uint32_t c = 0; c < grid.cell_count(); ++c) {
    const std::uint64_t size = grid.cell(c).size(), is_crowd = size > crowd;
    in_crowds += is_crowd * size;
    looks += (1 - is_crowd) * (size * (size - 1) / 2);
  }
  return in_crowds > count / 2 || static_cast<double>(looks) > most_looks * count * std::log2(count);
}

// The segments of all crowded cells, the lower numbers first.
inline std::vector<std::uint32_t> members_of_crowds(const SegmentGrid& grid, std::size_t crowd, std::uint32_t count) {
  std::vector<bool> is_member(count);
  for (std::uint32_t c = 0; c < grid.cell_count(); ++c) {
    if (grid.cell(c).size() <= crowd) continue;
    for (const Covering& s : grid.cell(c)) is_member[s.number()] = true;
  }
  std::vector<std::uint32_t> members;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (is_member[i]) members.push_back(i);
  }
  return members;
}

// The low corner of the common part of two boxes that have one.
inline Point2 low_corner(const Segment& s, const Segment& t) {
  return {std::max(s.a.x, t.a.x), std::max(std::min(s.a.y, s.b.y), std::min(t.a.y, t.b.y))};
}

// Some of the segments as a set of their own, with their groups.
struct Part {
  Part(const Segments& all, Groups all_groups, std::span<const std::uint32_t> members)
      : segments(chosen(all, members)) {
    if (all_groups.empty()) return;
    for (const std::uint32_t i : members) groups.push_back(all_groups[i]);
  }

  Segments segments;
  std::vector<std::uint32_t> groups;

 private:
  static Segments chosen(const Segments& all, std::span<const std::uint32_t> members) {
    std::vector<Segment> part;
    part.reserve(members.size());
    for (const std::uint32_t i : members) part.push_back(all[i]);
    return Segments(part);
  }
};

// Calls of_pair(i, j), i < j, once for each pair whose boxes meet, save for pairs that crowded cells look at. Stops,
// and returns false, when it returns false. Adds the pairs of boxes that it looks at to the probes of `cost`.
template <std::size_t crowd, class OfPair>
bool for_each_near_pair(std::span<const Segment> segments, const SegmentGrid& grid, const OfPair& of_pair,
                        const std::function<void(double)>& progress = nullptr, Cost* cost = nullptr) {
  struct Member {
    LanesBox box;
    std::uint32_t number, begins;
  };
  std::array<Member, crowd> members;
  // Pairs wait until there are many: who calls of_pair cannot predict where the few of a cell end.
  constexpr std::size_t batch = 32;
  std::array<std::array<std::uint32_t, 2>, batch + crowd> pairs;
  std::size_t found = 0;
  const auto hand_over = [&] {
    for (std::size_t n = 0; n < found; ++n) {
      if (!of_pair(pairs[n][0], pairs[n][1])) return false;
    }
    found = 0;
    return true;
  };
  constexpr std::uint32_t ahead = 8;
  const std::uint32_t cells = grid.cell_count();
  for (std::uint32_t c = 0; c < cells; ++c) {
    if (progress && c % 65536 == 0) progress(static_cast<double>(c) / cells);
    if (c + ahead < cells) {
      for (const Covering& s : grid.cell(c + ahead)) prefetch(segments[s.number()]);
    }
    const auto cell = grid.cell(c);
    if (cell.size() < 2 || cell.size() > crowd) continue;
    if (cost != nullptr) cost->probes += cell.size() * (cell.size() - 1) / 2;
    for (std::uint32_t l = 0; l < cell.size(); ++l) {
      const Segment& s = segments[cell[l].number()];
      const Member& b = members[l] = {box_of_edge(s.a, s.b), cell[l].number(), cell[l].begins()};
      for (std::uint32_t k = 0; k < l; ++k) {  // without branches
        const Member& a = members[k];
        pairs[found] = {a.number, b.number};
        found += std::size_t{meet(a.box, b.box)} & std::size_t{(a.begins | b.begins) == 3};
      }
      if (found >= batch && !hand_over()) return false;
    }
  }
  return hand_over();
}

}  // namespace sunder::planar
