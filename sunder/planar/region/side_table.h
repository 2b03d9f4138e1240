// Where in the order of sides does a normal belong? A table of angles in doubles proposes.
#pragma once

#include <sunder/base/contract.h>
#include <sunder/predicate/line/constraints.h>

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
  const double size = std::max(std::fabs(i.a), std::fabs(i.b));
  const double scale = size < 0x1p-900 ? 0x1p100 : size > 0x1p1000 ? 0x1p-100 : 1;
  return key_of(i.a * scale, i.b * scale, points_down(i));
}

inline double key_of(const LeftOf& i) {
  const double a = i.to.y - i.from.y, b = i.from.x - i.to.x, size = std::max(std::fabs(a), std::fabs(b));
  if (size < 0x1p1000) return key_of(a, b, points_down(i));
  return key_of(i.to.y * 0x1p-100 - i.from.y * 0x1p-100, i.from.x * 0x1p-100 - i.to.x * 0x1p-100, points_down(i));
}

}  // namespace side_table_detail

// Which sides, in the order of angles from any one on, have keys in the same small range as a given key?
class AngleBuckets {
 public:
  // Requires keys of sides in the order of angles: they ascend but for rounding, and for one step where they wrap.
  // Where they wrap, sides lie within a half turn.
  explicit AngleBuckets(std::span<const double> keys)
      : starts_(2 * keys.size() + 2),
        last_(static_cast<double>(2 * keys.size())),
        origin_(keys.empty() || keys.front() <= keys.back() ? 0 : keys.front()) {
    for (const double key : keys) ++starts_[bucket_of(key) + 1];
    for (std::size_t b = 1; b < starts_.size(); ++b) starts_[b] += starts_[b - 1];
  }

  // From the first side of the key's range to before the last one: positions. Keys are rounded: a neighbour may belong
  // to it too. Cost: constant.
  struct Range {
    std::uint32_t first, last;
  };
  Range around(double key) const {
    const std::size_t b = bucket_of(key);
    return {starts_[b], starts_[b + 1]};
  }

  // From the first side on, from 0 to 4; a little less than 0 by rounding.
  double from_first(double key) const {
    const double difference = key - origin_;
    return difference < -1 ? difference + 4 : difference;
  }

 private:
  std::size_t bucket_of(double key) const {
    return static_cast<std::size_t>(std::min(std::max(from_first(key), 0.0) * (last_ / 4), last_));
  }

  std::vector<std::uint32_t> starts_;
  double last_, origin_;
};

// Sides in the order of angles, counter-clockwise from any one on. Proposes for a normal the position of the last side
// that is not after it; where it is before all, that of the last. Keys are rounded: a neighbour may be meant.
class SideTable {
 public:
  template <class Given>
  SideTable(const Given& given, std::span<const std::uint32_t> sides) : keys_(keys_of(given, sides)), buckets_(keys_) {
    for (double& key : keys_) key = buckets_.from_first(key);
  }

  // Requires at least one side. Cost: O(1) for angles spread evenly, O(log n) at worst.
  template <class Half>
  std::uint32_t position(const Half& half) const {
    SUNDER_REQUIRE(!keys_.empty());
    const double key = side_table_detail::key_of(half);
    const auto [first, last] = buckets_.around(key);
    const auto after = std::upper_bound(keys_.begin() + first, keys_.begin() + last, buckets_.from_first(key));
    const auto count = static_cast<std::uint32_t>(after - keys_.begin());
    return (count == 0 ? static_cast<std::uint32_t>(keys_.size()) : count) - 1;
  }

  template <class Given>
  static std::vector<double> keys_of(const Given& given, std::span<const std::uint32_t> sides) {
    std::vector<double> keys;
    keys.reserve(sides.size());
    for (const std::uint32_t side : sides) keys.push_back(side_table_detail::key_of(given[side]));
    return keys;
  }

 private:
  std::vector<double> keys_;
  AngleBuckets buckets_;
};

}  // namespace sunder::planar
