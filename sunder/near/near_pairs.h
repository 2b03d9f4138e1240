// The pairs of boxes that the cells of a grid find.
// Also called: candidate pairs of a broad phase.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/base/interruption.h>
#include <sunder/base/prefetch.h>
#include <sunder/near/box_grid.h>
#include <sunder/near/lanes_box.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace sunder {

// How many members make a crowd in a cell: of more, a sweep is faster than all pairs. The sweep that stops at a contact
// is fast, the one that passes them is slow; that of polygons is between.
inline constexpr std::size_t crowd_for_any = 48, crowd_for_all = 256, crowd_of_polygons = 64;

// The low corner of the common part of two boxes that have one.
template <class Member>
Point2 low_corner(const Member& s, const Member& t) {
  return common_part(box_of(s), box_of(t)).low;
}

// Calls of_pair(i, j), i < j, once for each pair whose boxes meet, save for pairs that crowds look at. Stops, and
// returns false, when it returns false. The order of the pairs is that of the cells, then of j, then of i. Adds the
// pairs of boxes that it looks at to the probes of `cost`.
template <std::size_t crowd, class Member, class OfPair>
bool for_each_near_pair(std::span<const Member> members, const BoxGrid& grid, const OfPair& of_pair,
                        const std::function<void(double)>& progress = nullptr, Cost* cost = nullptr) {
  struct Entry {
    LanesBox box;
    std::uint32_t number, begins;
  };
  std::array<Entry, crowd> entries;
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
    if (c % 4096 == 0) may_be_interrupted(4096);
    if (progress && c % 65536 == 0) progress(static_cast<double>(c) / cells);
    if (c + ahead < cells) {
      for (const Covering& s : grid.cell(c + ahead)) prefetch(members[s.number()]);
    }
    const auto cell = grid.cell(c);
    if (cell.size() < 2 || cell.size() > crowd) continue;
    if (cost != nullptr) cost->probes += cell.size() * (cell.size() - 1) / 2;
    for (std::uint32_t l = 0; l < cell.size(); ++l) {
      const Entry& b = entries[l] = {lanes_box_of(members[cell[l].number()]), cell[l].number(), cell[l].begins()};
      for (std::uint32_t k = 0; k < l; ++k) {  // without branches
        const Entry& a = entries[k];
        pairs[found] = {a.number, b.number};
        found += std::size_t{meet(a.box, b.box)} & std::size_t{(a.begins | b.begins) == 3};
      }
      if (found >= batch && !hand_over()) return false;
    }
  }
  return hand_over();
}

}  // namespace sunder
