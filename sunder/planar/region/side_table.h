// Where in the order of sides does a normal belong? A table of angles in doubles proposes.
#pragma once

#include <sunder/predicate/constraints.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

namespace side_table_detail {

// Of a normal (a, b): from 0 to 4, as its angle from 0 to 2 pi. With q = a / (|a| + |b|): 1 - q where it points up,
// 3 + q where it points down. With a and b each off by 2^-53 of itself, q is off by at most 2^-51 + 2^-1074, and the
// key by 2^-50.
inline constexpr double key_error = 0x1p-50;

inline double key_of(double a, double b, bool down) {
  const double q = a / (std::fabs(a) + std::fabs(b));
  return down ? 3 + q : 1 - q;
}

// Numbers so small or so large that sums overflow or lose bits are scaled first.
inline double key_of(const Constraint& i) {
  const double size = std::fmax(std::fabs(i.a), std::fabs(i.b));
  const double scale = size < 0x1p-900 ? 0x1p100 : size > 0x1p1000 ? 0x1p-100 : 1;
  return key_of(i.a * scale, i.b * scale, points_down(i));
}

inline double key_of(const LeftOf& i) {
  const double a = i.to.y - i.from.y, b = i.from.x - i.to.x, size = std::fmax(std::fabs(a), std::fabs(b));
  if (size < 0x1p1000) return key_of(a, b, points_down(i));
  return key_of(i.to.y * 0x1p-100 - i.from.y * 0x1p-100, i.from.x * 0x1p-100 - i.to.x * 0x1p-100, points_down(i));
}

}  // namespace side_table_detail

// Sides in the order of angles, counter-clockwise from any one on. Proposes for a normal the position of the last side
// that is not after it; where it is before all, that of the last. Keys are rounded: a neighbour may be meant.
class SideTable {
 public:
  template <class Given>
  SideTable(const Given& given, std::span<const std::uint32_t> sides) : starts_(2 * sides.size() + 2) {
    keys_.reserve(sides.size());
    std::size_t least = 0;
    for (std::size_t p = 0; p < sides.size(); ++p) {
      keys_.push_back(side_table_detail::key_of(given[sides[p]]));
      if (keys_[p] < keys_[least]) least = p;
    }
    shift_ = static_cast<std::uint32_t>(least);
    std::rotate(keys_.begin(), keys_.begin() + static_cast<std::ptrdiff_t>(least), keys_.end());
    for (const double key : keys_) ++starts_[bucket_of(key) + 1];
    for (std::size_t b = 1; b < starts_.size(); ++b) starts_[b] += starts_[b - 1];
  }

  // Requires at least one side. Cost: O(1) for angles spread evenly, O(log n) at worst.
  template <class Half>
  std::uint32_t position(const Half& half) const {
    const double key = side_table_detail::key_of(half);
    const std::size_t b = bucket_of(key);
    const auto first = keys_.begin() + starts_[b], last = keys_.begin() + starts_[b + 1];
    const auto count = static_cast<std::size_t>(std::upper_bound(first, last, key) - keys_.begin());
    const std::size_t n = keys_.size(), p = (count == 0 ? n : count) - 1 + shift_;
    return static_cast<std::uint32_t>(p < n ? p : p - n);
  }

 private:
  std::size_t bucket_of(double key) const {
    const auto last = static_cast<double>(starts_.size() - 2);
    return static_cast<std::size_t>(std::fmin(std::fmax(key, 0) * (last / 4), last));
  }

  std::vector<double> keys_;
  std::vector<std::uint32_t> starts_;
  std::uint32_t shift_ = 0;
};

}  // namespace sunder::planar
