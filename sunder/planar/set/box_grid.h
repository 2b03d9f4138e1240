// A uniform grid over closed boxes: finds the pairs of boxes that meet, for sets of anything that has a box.
//
// A cell is a product of ranges of x and y; the number of a range grows with the coordinate, whatever is rounded in
// computing it. The low corner of the common part of two boxes has coordinates of theirs, so both boxes cover its cell:
// that cell is the one that looks at the pair.
#pragma once

#include <sunder/planar/object/box.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace sunder::planar {

class BoxGrid {
 public:
  // A grid with about as many cells as boxes, or nothing where it would not pay: boxes that cover more than
  // `most_covered` cells each on average, ranges that overflow, or fewer than two boxes. Cost: linear.
  static std::optional<BoxGrid> over(std::span<const Box> boxes, double most_covered = 8);

  std::uint32_t cell_count() const { return static_cast<std::uint32_t>(first_.size() - 1); }
  // The boxes that cover the cell, the lower numbers first.
  std::span<const std::uint32_t> cell(std::uint32_t c) const {
    return {covering_.data() + first_[c], covering_.data() + first_[c + 1]};
  }

  // The cell that looks at a pair of boxes whose common part begins at this left and bottom.
  std::uint32_t looking_cell(double left, double bottom) const { return row(bottom) * columns_ + column(left); }

  // How many places in cells are in crowds, that is, in cells of more than `crowd` boxes?
  std::size_t crowded(std::size_t crowd) const;

  // The boxes of all crowds, the lower numbers first.
  std::vector<std::uint32_t> members_of_crowds(std::size_t crowd) const;

 private:
  BoxGrid() = default;

  std::uint32_t column(double x) const { return static_cast<std::uint32_t>((x - left_) * per_x_); }
  std::uint32_t row(double y) const { return static_cast<std::uint32_t>((y - bottom_) * per_y_); }

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
bool for_each_near_box_pair(std::span<const Box> boxes, const BoxGrid& grid, std::size_t crowd, const OfPair& of_pair,
                            const std::function<void(double)>& progress = nullptr) {
  std::vector<Box> in_cell;
  std::vector<std::uint32_t> near;
  constexpr std::uint32_t ahead = 8;
  const std::uint32_t cells = grid.cell_count();
  for (std::uint32_t c = 0; c < cells; ++c) {
    if (progress && c % 65536 == 0) progress(static_cast<double>(c) / cells);
    if (c + ahead < cells) {
      for (const std::uint32_t i : grid.cell(c + ahead)) __builtin_prefetch(&boxes[i]);
    }
    const std::span<const std::uint32_t> cell = grid.cell(c);
    if (cell.size() < 2 || cell.size() > crowd) continue;
    if (in_cell.size() < cell.size()) {
      in_cell.resize(2 * cell.size());
      near.resize(2 * cell.size());
    }
    for (std::size_t l = 0; l < cell.size(); ++l) {
      const Box b = in_cell[l] = boxes[cell[l]];
      std::size_t found = 0;
      for (std::size_t k = 0; k < l; ++k) {  // without branches
        near[found] = static_cast<std::uint32_t>(k);
        const Box& a = in_cell[k];
        const std::size_t in_x = std::size_t{a.left <= b.right} & std::size_t{b.left <= a.right};
        const std::size_t in_y = std::size_t{a.bottom <= b.top} & std::size_t{b.bottom <= a.top};
        found += in_x & in_y;
      }
      for (std::size_t n = 0; n < found; ++n) {
        const Box& a = in_cell[near[n]];
        const double left = a.left > b.left ? a.left : b.left, bottom = a.bottom > b.bottom ? a.bottom : b.bottom;
        if (grid.looking_cell(left, bottom) == c && !of_pair(cell[near[n]], cell[l])) return false;
      }
    }
  }
  return true;
}

}  // namespace sunder::planar
