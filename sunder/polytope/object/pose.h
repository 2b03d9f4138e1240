// Where a polytope is: an affine map of R^d.
// Also called: affine transformation; placement, configuration.
#pragma once

#include <sunder/base/error.h>
#include <sunder/polytope/object/polytope.h>
#include <sunder/predicate/posed.h>

#include <array>
#include <cstddef>
#include <span>

namespace sunder::polytope {

// A pose is its d d + d doubles, exactly: x_world = linear x_body + translation. Any invertible linear part is allowed,
// reflections too.
class Pose {
 public:
  // The identity. Requires a dimension from 2 to 6.
  explicit Pose(std::size_t dimension);

  // linear: row by row. Throws Error bad_pose where the dimension is none of 2 to 6, the numbers are not d d and d, one
  // is not finite, or the linear part is singular (decided exactly).
  static Pose from_matrix(std::size_t dimension, std::span<const double> linear, std::span<const double> translation);

  std::size_t dimension() const { return dimension_; }
  std::span<const double> linear() const { return std::span(linear_).first(dimension_ * dimension_); }
  std::span<const double> translation() const { return std::span(translation_).first(dimension_); }
  double linear(std::size_t row, std::size_t column) const { return linear_[row * dimension_ + column]; }
  bool is_identity() const { return is_identity_; }

  // The sizes of the numbers of the two parts, for predicates.
  const SizeRange& linear_range() const { return linear_range_; }
  const SizeRange& translation_range() const { return translation_range_; }

 private:
  Pose(std::size_t dimension, std::span<const double> linear, std::span<const double> translation);

  std::size_t dimension_;
  std::array<double, most_dimension * most_dimension> linear_{};
  std::array<double, most_dimension> translation_{};
  bool is_identity_ = true;
  SizeRange linear_range_, translation_range_;
};

}  // namespace sunder::polytope
