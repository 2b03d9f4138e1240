#include <sunder/near/box_grid.h>

namespace sunder {

std::optional<BoxGrid> BoxGrid::of_cells(const BoxExtents& extents, double count, double cells) {
  constexpr double finest = 1.2;  // cells that the mean box is long
  const Point2 &low = extents.box.low, &high = extents.box.high;
  const double width = high.x - low.x, height = high.y - low.y;
  // Columns and rows in the proportion of how many mean boxes the range holds, at most as many as boxes each.
  const auto fit = [&](double range, double sum) { return sum > 0 ? std::min(range / (sum / count), count) : count; };
  const double fit_x = fit(width, extents.sum_x), fit_y = fit(height, extents.sum_y);
  // As many cells as asked for, but none smaller than most boxes.
  const double scale = std::min(std::sqrt(cells * count / (fit_x * fit_y)), finest);
  const double columns = std::floor(std::clamp(fit_x * scale, 1.0, count));
  const double rows = std::floor(std::clamp(fit_y * scale, 1.0, std::max(1.0, count / columns)));
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!finite(width) || !finite(height) || !finite(scale)) return std::nullopt;
  BoxGrid grid;
  grid.low_ = low;
  // A little less than columns / width, so that rounding does not lead beyond the last column.
  grid.per_x_ = width > 0 ? columns * (1 - 0x1p-40) / width : 0;
  grid.per_y_ = height > 0 ? rows * (1 - 0x1p-40) / height : 0;
  if (!finite(grid.per_x_) || !finite(grid.per_y_)) return std::nullopt;
  grid.columns_ = static_cast<std::uint32_t>(columns);
  grid.first_.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) + 1, 0);
  return grid;
}

std::size_t crowded(const BoxGrid& grid, std::size_t crowd) {
  std::size_t count = 0;
  for (std::uint32_t c = 0; c < grid.cell_count(); ++c) {
    if (grid.cell(c).size() > crowd) count += grid.cell(c).size();
  }
  return count;
}

std::vector<std::uint32_t> members_of_crowds(const BoxGrid& grid, std::size_t crowd, std::size_t count) {
  if (crowded(grid, crowd) == 0) return {};
  std::vector<bool> is_member(count);
  for (std::uint32_t c = 0; c < grid.cell_count(); ++c) {
    if (grid.cell(c).size() <= crowd) continue;
    for (const Covering& s : grid.cell(c)) is_member[s.number()] = true;
  }
  std::vector<std::uint32_t> members;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (is_member[i]) members.push_back(i);
  }
  return members;
}

std::uint64_t pairs_in_cells(const BoxGrid& grid) {
  std::uint64_t count = 0;
  for (std::uint32_t c = 0; c < grid.cell_count(); ++c) {
    const std::uint64_t size = grid.cell(c).size();
    count += size < 2 ? 0 : size * (size - 1) / 2;
  }
  return count;
}

bool is_too_much(const BoxGrid& grid, std::size_t crowd, std::size_t count) {
  constexpr double most_looks = 10;  // over N log2 N
  std::uint64_t looks = 0, in_crowds = 0;
  for (std::uint32_t c = 0; c < grid.cell_count(); ++c) {
    const std::uint64_t size = grid.cell(c).size(), is_crowd = size > crowd;
    in_crowds += is_crowd * size;
    looks += (1 - is_crowd) * (size * (size - 1) / 2);
  }
  const double n = static_cast<double>(count);
  return in_crowds > count / 2 || static_cast<double>(looks) > most_looks * n * std::log2(n);
}

}  // namespace sunder
