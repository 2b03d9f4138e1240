// A uniform grid over closed boxes: finds the pairs of boxes that meet, for sets of anything that has a box.
//
// A cell is a product of ranges of x and y; the number of a range grows with the coordinate, whatever is rounded in
// computing it. The low corner of the common part of two boxes has coordinates of theirs, so both boxes cover its cell:
// that cell is the one that looks at the pair. In other words, one of both begins in its column, and one in its row.
#pragma once

#include <sunder/planar/object/lanes_box.h>
#include <sunder/predicate/point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace sunder::planar {

class BoxGrid {
 public:
  // A grid with about as many cells as boxes, fewer where boxes are large; or nothing where it would not pay: boxes
  // that cover more than `most_covered` cells each on average, ranges too wide or too narrow for doubles, fewer than
  // two boxes or 2^31. Cost: linear.
  static std::optional<BoxGrid> over(std::span<const Box2> boxes, double most_covered = 8);

  std::uint32_t cell_count() const { return static_cast<std::uint32_t>(first_.size() - 1); }
  // The boxes that cover the cell, the lower numbers first.
  std::span<const std::uint32_t> cell(std::uint32_t c) const {
    return {covering_.data() + first_[c], covering_.data() + first_[c + 1]};
  }

  // Cell c is in column c % column_count() and in row c / column_count(). Of coordinates in the range of the boxes:
  std::uint32_t column_count() const { return columns_; }
  std::uint32_t column(double x) const { return static_cast<std::uint32_t>((x - left_) * per_x_); }
  std::uint32_t row(double y) const { return static_cast<std::uint32_t>((y - bottom_) * per_y_); }

  // How many pairs of boxes have a cell in common, counted for each cell?
  std::uint64_t pairs() const;

  // How many places in cells are in crowds, that is, in cells of more than `crowd` boxes?
  std::size_t crowded(std::size_t crowd) const;

  // The boxes of all crowds, the lower numbers first.
  std::vector<std::uint32_t> members_of_crowds(std::size_t crowd) const;

 private:
  BoxGrid() = default;

  double left_ = 0, bottom_ = 0, per_x_ = 0, per_y_ = 0;
  std::uint32_t columns_ = 1, boxes_ = 0;
  std::vector<std::uint32_t> first_;     // of each cell, its place in covering_; and the end
  std::vector<std::uint32_t> covering_;  // boxes, cell after cell
};

// Where a cell has more boxes, a sweep is faster than all pairs.
inline constexpr std::size_t crowd_of_boxes = 64;

// Calls of_pair(i, j), i < j, once for each pair of boxes that meet, save for pairs that crowds look at. Stops, and
// returns false, when it returns false. The order of the pairs is that of the cells, then of j, then of i.
template <class OfPair>
bool for_each_near_box_pair(std::span<const Box2> boxes, const BoxGrid& grid, std::size_t crowd, const OfPair& of_pair,
                            const std::function<void(double)>& progress = nullptr) {
  struct Member {
    LanesBox box;
    std::uint32_t number, begins;  // begins: bit 0, in this column; bit 1, in this row
  };
  std::vector<Member> members;
  // Pairs wait until there are many: who calls of_pair cannot predict where the few of a cell end.
  constexpr std::size_t batch = 32;
  std::vector<std::array<std::uint32_t, 2>> pairs(2 * batch);
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
  std::uint32_t column = 0, row = 0;
  for (std::uint32_t c = 0; c < cells; ++c, ++column) {
    if (column == grid.column_count()) {
      column = 0;
      ++row;
    }
    if (progress && c % 65536 == 0) progress(static_cast<double>(c) / cells);
    if (c + ahead < cells) {
      for (const std::uint32_t i : grid.cell(c + ahead)) __builtin_prefetch(&boxes[i]);
    }
    const std::span<const std::uint32_t> cell = grid.cell(c);
    if (cell.size() < 2 || cell.size() > crowd) continue;
    if (members.size() < cell.size()) members.resize(2 * cell.size());
    for (std::size_t l = 0; l < cell.size(); ++l) {
      const Box2& box = boxes[cell[l]];
      const std::uint32_t begins =
          std::uint32_t{grid.column(box.low.x) == column} | std::uint32_t{grid.row(box.low.y) == row} << 1;
      const Member& b = members[l] = {LanesBox::of(box), cell[l], begins};
      if (pairs.size() < found + l) pairs.resize(2 * (found + l));
      for (std::size_t k = 0; k < l; ++k) {  // without branches
        const Member& a = members[k];
        pairs[found] = {a.number, b.number};
        found += std::size_t{meet(a.box, b.box)} & std::size_t{(a.begins | b.begins) == 3};
      }
      // A cell of thousands has millions of pairs.
      if (found >= batch && !hand_over()) return false;
    }
  }
  return hand_over();
}

}  // namespace sunder::planar
