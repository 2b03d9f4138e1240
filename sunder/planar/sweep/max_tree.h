// Numbered values of which the next one that is not below a bound is found fast.
// Also called: tournament tree; segment tree of maxima.
//
// A tree of maxima over groups of eight (a cache line), level by level in arrays.
// Cost: O(log N) to change a value or to find the next.
#pragma once

#include <sunder/base/contract.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace sunder::planar {

class MaxTree {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;
  static constexpr double nothing = -std::numeric_limits<double>::infinity();

  // All values are `nothing`. Requires count < 2^31.
  explicit MaxTree(std::uint32_t count) {
    SUNDER_REQUIRE(count < 1u << 31);
    std::size_t size = count;
    do {
      size = (size + width - 1) / width;
      levels_.emplace_back(size * width, nothing);
    } while (size > 1);
  }

  void set(std::uint32_t k, double value) {
    levels_[0][k] = value;
    for (std::size_t level = 1; level < levels_.size(); ++level) {
      const auto group = levels_[level - 1].begin() + k / width * width;
      k /= width;
      const double greatest = *std::max_element(group, group + width);
      if (levels_[level][k] == greatest) return;
      levels_[level][k] = greatest;
    }
  }

  // The least number from k on whose value is at least the bound, or none. Requires bound > nothing.
  std::uint32_t next(std::uint32_t k, double bound) const {
    SUNDER_REQUIRE(bound > nothing);
    for (std::size_t level = 0; level < levels_.size(); ++level) {
      const std::vector<double>& values = levels_[level];
      if (k >= values.size()) return none;
      const std::uint32_t end = (k / width + 1) * width;
      while (k < end && values[k] < bound) ++k;
      if (k < end) return first_under(level, k, bound);
      k = end / width;
    }
    return none;
  }

 private:
  static constexpr std::uint32_t width = 8;

  std::uint32_t first_under(std::size_t level, std::uint32_t k, double bound) const {
    while (level-- > 0) {
      k *= width;
      while (levels_[level][k] < bound) ++k;
    }
    return k;
  }

  std::vector<std::vector<double>> levels_;
};

}  // namespace sunder::planar
