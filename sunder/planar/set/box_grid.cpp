#include <sunder/planar/set/box_grid.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder::planar {

namespace {

// Of all boxes: their common box, and the sums of their extents.
struct Extents {
  Box2 all;
  double sum_x = 0, sum_y = 0;

  explicit Extents(std::span<const Box2> boxes) : all(boxes[0]) {
    for (const Box2& b : boxes) {
      all = hull(all, b);
      sum_x += b.high.x - b.low.x;
      sum_y += b.high.y - b.low.y;
    }
  }
};

constexpr double finest = 1.2;  // cells that the mean box is long

}  // namespace

std::optional<BoxGrid> BoxGrid::over(std::span<const Box2> boxes, double most_covered) {
  if (boxes.empty()) return std::nullopt;
  if (boxes.size() < 2 || boxes.size() >= std::size_t{1} << 31) return std::nullopt;
  const double count = static_cast<double>(boxes.size());
  const Extents extents(boxes);
  const double width = extents.all.high.x - extents.all.low.x, height = extents.all.high.y - extents.all.low.y;
  // Columns and rows in the proportion of how many mean boxes the range holds, at most as many as boxes each.
  const auto fit = [&](double range, double sum) { return sum > 0 ? std::min(range / (sum / count), count) : count; };
  const double fit_x = fit(width, extents.sum_x), fit_y = fit(height, extents.sum_y);
  // As many cells as boxes, but hardly smaller ones than the mean box.
  const double scale = std::min(std::sqrt(count / (fit_x * fit_y)), finest);
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!finite(width) || !finite(height) || !finite(scale)) return std::nullopt;
  const double columns = std::floor(std::clamp(fit_x * scale, 1.0, count));
  const double rows = std::floor(std::clamp(fit_y * scale, 1.0, std::max(1.0, count / columns)));
  BoxGrid grid;
  grid.left_ = extents.all.low.x;
  grid.bottom_ = extents.all.low.y;
  // A little less than columns / width, so that rounding does not lead beyond the last column.
  grid.per_x_ = width > 0 ? columns * (1 - 0x1p-40) / width : 0;
  grid.per_y_ = height > 0 ? rows * (1 - 0x1p-40) / height : 0;
  if (!finite(grid.per_x_) || !finite(grid.per_y_)) return std::nullopt;
  grid.columns_ = static_cast<std::uint32_t>(columns);
  grid.boxes_ = static_cast<std::uint32_t>(boxes.size());

  const auto for_each_cell = [&grid](const Box2& b, const auto& visit) {
    const std::uint32_t left = grid.column(b.low.x), right = grid.column(b.high.x);
    const std::uint32_t bottom = grid.row(b.low.y), top = grid.row(b.high.y);
    for (std::uint32_t r = bottom; r <= top; ++r) {
      for (std::uint32_t c = left; c <= right; ++c) visit(r * grid.columns_ + c);
    }
  };
  double covered = 0;
  for (const Box2& b : boxes) {
    const double across = grid.column(b.high.x) - grid.column(b.low.x) + 1,
                 up = grid.row(b.high.y) - grid.row(b.low.y) + 1;
    covered += across * up;
  }
  if (covered > most_covered * count || covered > 0xfffffff0u) return std::nullopt;

  const std::size_t cells = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  grid.first_.assign(cells + 1, 0);
  for (const Box2& b : boxes) {
    for_each_cell(b, [&](std::uint32_t c) { ++grid.first_[c]; });
  }
  std::uint32_t end = 0;
  for (std::uint32_t& f : grid.first_) f = end += f;  // the end of each cell, lowered to its beginning below
  grid.covering_.resize(end);
  for (std::uint32_t i = grid.boxes_; i-- > 0;) {
    for_each_cell(boxes[i], [&](std::uint32_t c) { grid.covering_[--grid.first_[c]] = i; });
  }
  return grid;
}

std::uint64_t BoxGrid::pairs() const {
  std::uint64_t count = 0;
  for (std::uint32_t c = 0; c < cell_count(); ++c) {
    const std::uint64_t size = cell(c).size();
    count += size < 2 ? 0 : size * (size - 1) / 2;
  }
  return count;
}

std::size_t BoxGrid::crowded(std::size_t crowd) const {
  std::size_t count = 0;
  for (std::uint32_t c = 0; c < cell_count(); ++c) {
    if (cell(c).size() > crowd) count += cell(c).size();
  }
  return count;
}

std::vector<std::uint32_t> BoxGrid::members_of_crowds(std::size_t crowd) const {
  std::vector<bool> is_member(boxes_);
  for (std::uint32_t c = 0; c < cell_count(); ++c) {
    if (cell(c).size() <= crowd) continue;
    for (const std::uint32_t i : cell(c)) is_member[i] = true;
  }
  std::vector<std::uint32_t> members;
  for (std::uint32_t i = 0; i < boxes_; ++i) {
    if (is_member[i]) members.push_back(i);
  }
  return members;
}

}  // namespace sunder::planar
