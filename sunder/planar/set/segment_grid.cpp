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

std::optional<SegmentGrid> SegmentGrid::over(std::span<const Segment> segments, double most_covered) {
  if (segments.size() < 2) return std::nullopt;
  const double count = static_cast<double>(segments.size());
  const Extents extents(segments);
  const double width = extents.high.x - extents.low.x, height = extents.high.y - extents.low.y;
  // Columns and rows in the proportion of how many mean segments the range holds, at most as many as segments each.
  const auto fit = [&](double range, double sum) { return sum > 0 ? std::min(range / (sum / count), count) : count; };
  const double fit_x = fit(width, extents.sum_x), fit_y = fit(height, extents.sum_y);
  // As many cells as segments, but none smaller than most boxes.
  const double scale = std::min(std::sqrt(count / (fit_x * fit_y)), finest);
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

  const auto for_each_cell = [&grid](const Segment& s, const auto& visit) {
    const std::uint32_t left = grid.column(s.a.x), right = grid.column(s.b.x);
    const std::uint32_t bottom = grid.row(std::min(s.a.y, s.b.y)), top = grid.row(std::max(s.a.y, s.b.y));
    for (std::uint32_t r = bottom; r <= top; ++r) {
      for (std::uint32_t c = left; c <= right; ++c) visit(r * grid.columns_ + c);
    }
  };
  const double most = most_covered * count;
  double covered = 0;
  for (const Segment& s : segments) {
    const double across = grid.column(s.b.x) - grid.column(s.a.x) + 1;
    const double up = grid.row(std::max(s.a.y, s.b.y)) - grid.row(std::min(s.a.y, s.b.y)) + 1;
    covered += across * up;
  }
  if (covered > most || covered > 0xfffffff0u) return std::nullopt;

  const std::size_t cells = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  grid.first_.assign(cells + 1, 0);
  for (const Segment& s : segments) {
    for_each_cell(s, [&](std::uint32_t c) { ++grid.first_[c]; });
  }
  std::uint32_t end = 0;
  for (std::uint32_t& f : grid.first_) f = end += f;  // the end of each cell, lowered to its beginning below
  grid.covering_.resize(end);
  for (std::uint32_t i = static_cast<std::uint32_t>(segments.size()); i-- > 0;) {
    for_each_cell(segments[i], [&](std::uint32_t c) { grid.covering_[--grid.first_[c]] = i; });
  }
  return grid;
}

}  // namespace sunder::planar
