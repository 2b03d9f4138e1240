// A uniform grid over the boxes of segments: two segments that meet have a cell in common.
//
// A cell is a product of ranges of x and y; the number of a range grows with the coordinate, whatever is rounded in
// computing it. The low corner of the common part of two boxes has coordinates of the segments' ends, so both boxes
// cover its cell: that cell is the one that looks at the pair.
#pragma once

#include <sunder/planar/object/segments.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace sunder::planar {

// A segment whose box covers a cell.
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

class SegmentGrid {
 public:
  static constexpr double usual_cells = 0.65, usual_covered = 8;

  // A grid with about `cells` cells for each segment, or nothing where it would not pay: boxes that cover more than
  // `most_covered` cells each on average, ranges that overflow, fewer than two segments, or 2^30. Cost: linear.
  // (For meshes of 300 to 10^6 segments, 0.65 is faster than 1 by a tenth, and than 0.3 to 0.5 where they are small.)
  static std::optional<SegmentGrid> over(std::span<const Segment> segments, double cells = usual_cells,
                                         double most_covered = usual_covered);
  static std::optional<SegmentGrid> over(const Segments& segments) {
    return over(segments.all(), segments.extents(), usual_cells, usual_covered);
  }

  std::uint32_t cell_count() const { return static_cast<std::uint32_t>(first_.size() - 1); }
  // The segments whose boxes cover the cell, the lower numbers first.
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
  SegmentGrid() = default;
  static std::optional<SegmentGrid> over(std::span<const Segment> segments, const SegmentExtents& extents, double cells,
                                         double most_covered);

  Point2 low_{};
  double per_x_ = 0, per_y_ = 0;
  std::uint32_t columns_ = 1;
  std::vector<std::uint32_t> first_;      // of each cell, its place in covering_; and the end
  std::unique_ptr<Covering[]> covering_;  // segments, cell after cell
};

}  // namespace sunder::planar
