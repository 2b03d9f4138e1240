#include <sunder/solid/hull/spatial_order.h>

#include <algorithm>
#include <cstddef>

namespace sunder::solid {

namespace {

// The cells of one axis: 2^bits of equal width between the least and the greatest coordinate.
class CellsOfAxis {
 public:
  CellsOfAxis(std::span<const Point3> points, double Point3::* axis, int bits) : axis_(axis), count_(1u << bits) {
    const auto less = [axis](const Point3& p, const Point3& q) { return p.*axis < q.*axis; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    low_ = (*low).*axis;
    cells_per_unit_ = count_ / ((*high).*axis - low_);
  }

  // Whatever rounding, overflow and division by zero do, this is a cell.
  std::uint32_t operator()(const Point3& p) const {
    const double cell = (p.*axis_ - low_) * cells_per_unit_;
    return cell >= count_ ? count_ - 1 : cell > 0 ? static_cast<std::uint32_t>(cell) : 0;
  }

 private:
  double Point3::* axis_;
  std::uint32_t count_;
  double low_;
  double cells_per_unit_;
};

}  // namespace

std::vector<std::uint32_t> spatial_order(std::span<const Point3> points) {
  int bits = 0;  // of the cell numbers of each axis: at least half as many cells as points, bar the limit
  while (bits < 8 && std::size_t{1} << (3 * bits + 1) < points.size()) ++bits;
  const CellsOfAxis x_cell(points, &Point3::x, bits);
  const CellsOfAxis y_cell(points, &Point3::y, bits);
  const CellsOfAxis z_cell(points, &Point3::z, bits);
  const auto cell_of = [&](const Point3& p) {
    const std::uint32_t x = x_cell(p), y = y_cell(p), z = z_cell(p);
    std::uint32_t code = 0;
    for (int bit = bits - 1; bit >= 0; --bit) {
      code = code << 3 | (x >> bit & 1) << 2 | (y >> bit & 1) << 1 | (z >> bit & 1);
    }
    return code;
  };

  std::vector<std::uint32_t> cell;
  cell.reserve(points.size());
  for (const Point3& p : points) cell.push_back(cell_of(p));
  std::vector<std::uint32_t> place((std::size_t{1} << 3 * bits) + 1);  // where the points of a cell go
  for (const std::uint32_t c : cell) ++place[c + 1];
  for (std::size_t c = 1; c < place.size(); ++c) place[c] += place[c - 1];
  std::vector<std::uint32_t> order(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) order[place[cell[i]]++] = i;
  return order;
}

}  // namespace sunder::solid
