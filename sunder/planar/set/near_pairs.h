// The pairs of segments that a grid finds near each other.
#pragma once

#include <sunder/planar/set/contact_rule.h>
#include <sunder/planar/set/segment_grid.h>

#include <algorithm>
#include <array>
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

// The segments of all crowded cells, the lower numbers first.
inline std::vector<std::uint32_t> members_of_crowds(const SegmentGrid& grid, std::size_t crowd, std::uint32_t count) {
  std::vector<bool> is_member(count);
  for (std::uint32_t c = 0; c < grid.cell_count(); ++c) {
    if (grid.cell(c).size() <= crowd) continue;
    for (const std::uint32_t i : grid.cell(c)) is_member[i] = true;
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
// and returns false, when it returns false.
template <std::size_t crowd, class OfPair>
bool for_each_near_pair(std::span<const Segment> segments, const SegmentGrid& grid, const OfPair& of_pair,
                        const std::function<void(double)>& progress = nullptr) {
  std::array<double, crowd> left, right, bottom, top;  // of the boxes of a cell
  std::array<std::uint32_t, crowd> near;
  constexpr std::uint32_t ahead = 8;
  const std::uint32_t cells = grid.cell_count();
  for (std::uint32_t c = 0; c < cells; ++c) {
    if (progress && c % 65536 == 0) progress(static_cast<double>(c) / cells);
    if (c + ahead < cells) {
      for (const std::uint32_t i : grid.cell(c + ahead)) __builtin_prefetch(&segments[i]);
    }
    const auto cell = grid.cell(c);
    if (cell.size() < 2 || cell.size() > crowd) continue;
    for (std::uint32_t l = 0; l < cell.size(); ++l) {
      const Segment& t = segments[cell[l]];
      const double t_bottom = std::min(t.a.y, t.b.y), t_top = std::max(t.a.y, t.b.y);
      std::size_t found = 0;
      for (std::uint32_t k = 0; k < l; ++k) {  // without branches
        near[found] = k;
        const std::size_t in_x = std::size_t{left[k] <= t.b.x} & std::size_t{t.a.x <= right[k]};
        const std::size_t in_y = std::size_t{bottom[k] <= t_top} & std::size_t{t_bottom <= top[k]};
        found += in_x & in_y;
      }
      for (std::size_t n = 0; n < found; ++n) {
        const std::uint32_t k = near[n];
        const Point2 corner{std::max(left[k], t.a.x), std::max(bottom[k], t_bottom)};
        if (grid.looking_cell(corner) == c && !of_pair(cell[k], cell[l])) return false;
      }
      left[l] = t.a.x;
      right[l] = t.b.x;
      bottom[l] = t_bottom;
      top[l] = t_top;
    }
  }
  return true;
}

}  // namespace sunder::planar
