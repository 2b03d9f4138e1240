#include <sunder/planar/set/segment_grid.h>

#include <cmath>
#include <limits>

namespace sunder::planar {

namespace {

// Of all segments: their common box, and the sums of the extents of their boxes.
struct Extents {
  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  double sum_x = 0, sum_y = 0;

  explicit Extents(std::span<const Segment> segments) {
    for (const Segment& s : segments) {
      const double y_low = std::min(s.a.y, s.b.y), y_high = std::max(s.a.y, s.b.y);
      low.x = std::min(low.x, s.a.x);
      high.x = std::max(high.x, s.b.x);
      low.y = std::min(low.y, y_low);
      high.y = std::max(high.y, y_high);
      sum_x += s.b.x - s.a.x;
      sum_y += y_high - y_low;
    }
  }
};

constexpr double finest = 1.2;  // cells that the mean box is long

}  // namespace

std::optional<SegmentGrid> SegmentGrid::over(std::span<const Segment> segments, double cells, double most_covered) {
  if (segments.size() < 2) return std::nullopt;
  const double count = static_cast<double>(segments.size());
  const Extents extents(segments);
  const double width = extents.high.x - extents.low.x, height = extents.high.y - extents.low.y;
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
  grid.low_ = extents.low;
  // A little less than columns / width, so that rounding does not lead beyond the last column.
  grid.per_x_ = width > 0 ? columns * (1 - 0x1p-40) / width : 0;
  grid.per_y_ = height > 0 ? rows * (1 - 0x1p-40) / height : 0;
  if (!finite(grid.per_x_) || !finite(grid.per_y_)) return std::nullopt;
  grid.columns_ = static_cast<std::uint32_t>(columns);

  struct Range {
    std::uint32_t left, right, bottom, top;
  };
  const auto range_of = [&grid](const Segment& s) {
    return Range{grid.column(s.a.x), grid.column(s.b.x), grid.row(std::min(s.a.y, s.b.y)),
                 grid.row(std::max(s.a.y, s.b.y))};
  };
  const auto for_each_cell = [&grid](const Range& range, const auto& visit) {
    for (std::uint32_t r = range.bottom; r <= range.top; ++r) {
      for (std::uint32_t c = range.left; c <= range.right; ++c) visit(r * grid.columns_ + c);
    }
  };
  // How many segments cover each cell, until it is clear that the grid does not pay.
  const std::size_t all_cells = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  const double most = std::min(most_covered * count, 0x1p32 - 16);
  double covered = 0;
  grid.first_.assign(all_cells + 1, 0);
  for (const Segment& s : segments) {
    const Range range = range_of(s);
    covered += (range.right - range.left + 1.0) * (range.top - range.bottom + 1.0);
    if (covered > most) return std::nullopt;
    for_each_cell(range, [&](std::uint32_t c) { ++grid.first_[c]; });
  }
  std::uint32_t end = 0;
  for (std::uint32_t& f : grid.first_) f = end += f;  // the end of each cell, lowered to its beginning below
  grid.covering_.resize(end);
  for (std::uint32_t i = static_cast<std::uint32_t>(segments.size()); i-- > 0;) {
    for_each_cell(range_of(segments[i]), [&](std::uint32_t c) { grid.covering_[--grid.first_[c]] = i; });
  }
  return grid;
}

}  // namespace sunder::planar
