// Closed discs of the plane: circles with their insides. So nested ones have common points. Radius zero is a point.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/disc.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

// A set of discs, numbered from 0. Immutable; any number of threads may use it.
// P1. All numbers are finite, and no radius is negative. (Centre plus radius may lie beyond the doubles.)
class Discs {
 public:
  // Throws Error bad_value: "circle 7: ..." where a number is not finite or a radius is negative; bad_shape for 2^31
  // circles or more.
  explicit Discs(std::vector<Disc> given);

  std::uint32_t size() const { return static_cast<std::uint32_t>(discs_.size()); }
  const Disc& operator[](std::uint32_t i) const { return discs_[i]; }
  std::span<const Disc> all() const { return discs_; }

 private:
  std::vector<Disc> discs_;
};

}  // namespace sunder::planar
