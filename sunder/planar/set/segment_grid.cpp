#include <sunder/planar/set/segment_grid.h>

#include <cmath>
#include <limits>

namespace sunder::planar {

namespace {

constexpr double finest = 1.2;  // cells that the mean box is long

}  // namespace

std::optional<SegmentGrid> SegmentGrid::over(std::span<const Segment> segments, double cells, double most_covered) {
  SegmentExtents extents;
  for (const Segment& s : segments) extents.add(s);
  return over(segments, extents, cells, most_covered);
}

std::optional<SegmentGrid> SegmentGrid::over(std::span<const Segment> segments, const SegmentExtents& extents,
                                             double cells, double most_covered) {
  if (segments.size() < 2 || segments.size() >= Covering::most) return std::nullopt;
  const double count = static_cast<double>(segments.size());
  const Point2 &low = extents.box.low, &high = extents.box.high;
  const double width = high.x - low.x, height = high.y - low.y;
  // Columns and rows in the proportion of how many mean segments the range holds, at most as many as segments each.
  const auto fit = [&](double range, double sum) { return sum > 0 ? std::min(range / (sum / count), count) : count; };
  const double fit_x = fit(width, extents.sum_x), fit_y = fit(height, extents.sum_y);
  // As many cells as asked for, but none smaller than most boxes.
  const double scale = std::min(std::sqrt(cells * count / (fit_x * fit_y)), finest);
  const double columns = std::floor(std::clamp(fit_x * scale, 1.0, count));
  const double rows = std::floor(std::clamp(fit_y * scale, 1.0, std::max(1.0, count / columns)));
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!finite(width) || !finite(height) || !finite(scale)) return std::nullopt;
  SegmentGrid grid;
  grid.low_ = low;
  // A little less than columns / width, so that rounding does not lead beyond the last column.
  grid.per_x_ = width > 0 ? columns * (1 - 0x1p-40) / width : 0;
  grid.per_y_ = height > 0 ? rows * (1 - 0x1p-40) / height : 0;
  if (!finite(grid.per_x_) || !finite(grid.per_y_)) return std::nullopt;
  grid.columns_ = static_cast<std::uint32_t>(columns);

  // A segment's cells: columns and rows beyond the one of the low corner. What is too many for this is told again.
  struct Range {
    std::uint32_t corner;
    std::uint16_t across, up;
  };
  constexpr std::uint32_t too_many = 0xffff;
  const std::uint32_t stride = grid.columns_;
  const auto extent_of = [&grid](const Segment& s, const auto& visit) {
    const double y_low = std::min(s.a.y, s.b.y), y_high = std::max(s.a.y, s.b.y);
    const std::uint32_t left = grid.column(s.a.x), bottom = grid.row(y_low);
    return visit(bottom * grid.columns_ + left, grid.column(s.b.x) - left, grid.row(y_high) - bottom);
  };
  const auto for_each_cell = [stride](std::uint32_t corner, std::uint32_t across, std::uint32_t up, const auto& visit) {
    for (std::uint32_t r = 0; r <= up; ++r, corner += stride) {
      for (std::uint32_t c = 0; c <= across; ++c) visit(corner + c, c == 0, r == 0);
    }
  };
  // How many segments cover each cell, until it is clear that the grid does not pay.
  const std::size_t all_cells = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  const double most = std::min(most_covered * count, 0x1p32 - 16);
  double covered = 0;
  grid.first_.assign(all_cells + 1, 0);
  std::uint32_t* const first = grid.first_.data();
  const auto ranges = std::make_unique_for_overwrite<Range[]>(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    extent_of(segments[i], [&](std::uint32_t corner, std::uint32_t across, std::uint32_t up) {
      ranges[i] = {corner, static_cast<std::uint16_t>(std::min(across, too_many)),
                   static_cast<std::uint16_t>(std::min(up, too_many))};
      covered += (across + 1.0) * (up + 1.0);
      if (covered <= most) for_each_cell(corner, across, up, [&](std::uint32_t c, bool, bool) { ++first[c]; });
    });
    if (covered > most) return std::nullopt;
  }
  std::uint32_t end = 0;
  for (std::uint32_t& f : grid.first_) f = end += f;  // the end of each cell, lowered to its beginning below
  grid.covering_ = std::make_unique_for_overwrite<Covering[]>(end);
  Covering* const covering = grid.covering_.get();
  for (std::uint32_t i = static_cast<std::uint32_t>(segments.size()); i-- > 0;) {
    const auto cover = [&](std::uint32_t corner, std::uint32_t across, std::uint32_t up) {
      for_each_cell(corner, across, up, [&](std::uint32_t c, bool begins_column, bool begins_row) {
        covering[--first[c]] = {i, begins_column, begins_row};
      });
    };
    const Range& range = ranges[i];
    if (range.across == too_many || range.up == too_many) {
      extent_of(segments[i], cover);
    } else {
      cover(range.corner, range.across, range.up);
    }
  }
  return grid;
}

}  // namespace sunder::planar
