// A uniform grid over closed boxes of the plane: two that meet have a cell in common.
// Also called: uniform grid; spatial hashing; broad phase.
//
// What has a box is a Box2, or anything that box_of() and lanes_box_of() know: a segment's ends are its box, so sets of
// segments need no others.
// A cell is a product of ranges of x and y; the number of a range grows with the coordinate, whatever is rounded in
// computing it. The low corner of the common part of two boxes has coordinates of theirs, so both boxes cover its cell:
// that cell is the one that looks at the pair. In other words, one of both begins in its column, and one in its row.
#pragma once

#include <sunder/predicate/point.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace sunder {

inline Box2 box_of(const Box2& box) { return box; }

// Of some boxes: the box of all, and the sums of their widths and heights.
struct BoxExtents {
  Box2 box{{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()},
           {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}};
  double sum_x = 0, sum_y = 0;  // rounded

  void add(const Box2& b) {
    box = hull(box, b);
    sum_x += b.high.x - b.low.x;
    sum_y += b.high.y - b.low.y;
  }
};

template <class Member>
BoxExtents extents_of_boxes(std::span<const Member> members) {
  BoxExtents extents;
  for (const Member& member : members) extents.add(box_of(member));
  return extents;
}

// A member whose box covers a cell.
class Covering {
 public:
  static constexpr std::uint32_t most = 1u << 30;  // numbers are less

  Covering() = default;
  Covering(std::uint32_t number, bool begins_column, bool begins_row)
      : bits_(number | std::uint32_t{begins_column} << 30 | std::uint32_t{begins_row} << 31) {}

  std::uint32_t number() const { return bits_ & (most - 1); }
  // Bit 0: does the box begin in this column? Bit 1: in this row? So the cell of its low corner has both.
  std::uint32_t begins() const { return bits_ >> 30; }

 private:
  std::uint32_t bits_;
};

class BoxGrid {
 public:
  static constexpr double usual_covered = 8;

  // A grid with about `cells` cells for each box, from 0 to 1, fewer where boxes are large; or nothing where it would
  // not pay: boxes that cover more than `most_covered` cells each on average, ranges that overflow, fewer than two
  // boxes, or 2^30 and more. Requires boxes: no end is NaN, and none below its low one. Cost: linear.
  template <class Member>
  static std::optional<BoxGrid> over(std::span<const Member> members, const BoxExtents& extents, double cells = 1,
                                     double most_covered = usual_covered);
  template <class Member>
  static std::optional<BoxGrid> over(const std::vector<Member>& members, double cells = 1,
                                     double most_covered = usual_covered) {
    const std::span<const Member> all(members);
    return over(all, extents_of_boxes(all), cells, most_covered);
  }

  std::uint32_t cell_count() const { return static_cast<std::uint32_t>(first_.size() - 1); }
  // The members whose boxes cover the cell, the lower numbers first.
  std::span<const Covering> cell(std::uint32_t c) const {
    return {covering_.get() + first_[c], covering_.get() + first_[c + 1]};
  }

  // Cell c is in column c % column_count() and in row c / column_count(). Of coordinates in the range of the boxes:
  std::uint32_t column_count() const { return columns_; }
  std::uint32_t column(double x) const { return static_cast<std::uint32_t>((x - low_.x) * per_x_); }
  std::uint32_t row(double y) const { return static_cast<std::uint32_t>((y - low_.y) * per_y_); }

  // The cell that looks at a pair whose boxes' common part has this low corner.
  std::uint32_t looking_cell(const Point2& low_corner) const {
    return row(low_corner.y) * columns_ + column(low_corner.x);
  }

 private:
  BoxGrid() = default;

  // The cells; nothing where their number, or how many lie in the ranges, are not for doubles.
  static std::optional<BoxGrid> of_cells(const BoxExtents& extents, double count, double cells);

  // A box's cells: columns and rows beyond the one of the low corner. What is too many for this is told again.
  struct Range {
    static constexpr std::uint32_t too_many = 0xffff;
    std::uint32_t corner;
    std::uint16_t across, up;
    bool is_whole() const { return across != too_many && up != too_many; }
  };

  // visit(cell of the low corner, columns beyond it, rows beyond it)
  template <class Visit>
  void extent_of(const Box2& box, const Visit& visit) const {
    const std::uint32_t left = column(box.low.x), bottom = row(box.low.y);
    visit(bottom * columns_ + left, column(box.high.x) - left, row(box.high.y) - bottom);
  }
  // visit(cell, is it in the first column, in the first row?)
  template <class Visit>
  void for_each_cell(std::uint32_t corner, std::uint32_t across, std::uint32_t up, const Visit& visit) const {
    const std::uint32_t stride = columns_;
    for (std::uint32_t r = 0; r <= up; ++r, corner += stride) {
      for (std::uint32_t c = 0; c <= across; ++c) visit(corner + c, c == 0, r == 0);
    }
  }

  Point2 low_{};
  double per_x_ = 0, per_y_ = 0;
  std::uint32_t columns_ = 1;
  std::vector<std::uint32_t> first_;      // of each cell, its place in covering_; and the end
  std::unique_ptr<Covering[]> covering_;  // members, cell after cell
};

template <class Member>
std::optional<BoxGrid> BoxGrid::over(std::span<const Member> members, const BoxExtents& extents, double cells,
                                     double most_covered) {
  if (members.size() < 2 || members.size() >= Covering::most) return std::nullopt;
  const double count = static_cast<double>(members.size());
  std::optional<BoxGrid> made = of_cells(extents, count, cells);
  if (!made) return std::nullopt;
  BoxGrid& grid = *made;
  // How many boxes cover each cell, until it is clear that the grid does not pay.
  const double most = std::min(most_covered * count, 0x1p32 - 16);
  double covered = 0;
  std::uint32_t* const first = grid.first_.data();
  const auto ranges = std::make_unique_for_overwrite<Range[]>(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    grid.extent_of(box_of(members[i]), [&](std::uint32_t corner, std::uint32_t across, std::uint32_t up) {
      ranges[i] = {corner, static_cast<std::uint16_t>(std::min(across, Range::too_many)),
                   static_cast<std::uint16_t>(std::min(up, Range::too_many))};
      covered += (across + 1.0) * (up + 1.0);
      if (covered <= most) grid.for_each_cell(corner, across, up, [&](std::uint32_t c, bool, bool) { ++first[c]; });
    });
    if (covered > most) return std::nullopt;
  }
  std::uint32_t end = 0;
  for (std::uint32_t& f : grid.first_) f = end += f;  // the end of each cell, lowered to its beginning below
  grid.covering_ = std::make_unique_for_overwrite<Covering[]>(end);
  Covering* const covering = grid.covering_.get();
  for (std::uint32_t i = static_cast<std::uint32_t>(members.size()); i-- > 0;) {
    const auto cover = [&](std::uint32_t corner, std::uint32_t across, std::uint32_t up) {
      grid.for_each_cell(corner, across, up, [&](std::uint32_t c, bool begins_column, bool begins_row) {
        covering[--first[c]] = {i, begins_column, begins_row};
      });
    };
    const Range& range = ranges[i];
    if (range.is_whole()) {
      cover(range.corner, range.across, range.up);
    } else {
      grid.extent_of(box_of(members[i]), cover);
    }
  }
  return made;
}

// How many places in cells are in crowds, that is, in cells of more than `crowd` members?
std::size_t crowded(const BoxGrid& grid, std::size_t crowd);

// The members of all crowds, the lower numbers first. count: of all members.
std::vector<std::uint32_t> members_of_crowds(const BoxGrid& grid, std::size_t crowd, std::size_t count);

// How many pairs have a cell in common, counted for each cell?
std::uint64_t pairs_in_cells(const BoxGrid& grid);

// Would a sweep over all be the better way? Where the places in crowds are more than half as many as the members, or
// the other cells have so many pairs of boxes to look at that few of them can be contacts. (A sweep takes as long for a
// comparison as a cell for a dozen pairs of boxes.)
bool is_too_much(const BoxGrid& grid, std::size_t crowd, std::size_t count);

}  // namespace sunder
