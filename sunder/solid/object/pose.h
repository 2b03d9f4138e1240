// Where a body is: an affine map from the body's frame to the world's.
// Also called: affine transformation, transform; placement, configuration; rigid motion.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <array>

namespace sunder::solid {

// A pose holds twelve doubles, and these doubles are the map, exactly: x_world = linear x_body + translation.
// A rotation whose matrix was rounded to doubles is very nearly a rotation; answers are exact for the rounded matrix.
// Any invertible linear part is allowed: scale, shear, and reflection (negative determinant) too.
class Pose {
 public:
  // The identity.
  Pose() : Pose(Affine3{}) {}

  // linear: row by row. Throws Error bad_pose where a number is not finite or the linear part is singular
  // (decided exactly).
  static Pose from_matrix(const std::array<double, 9>& linear, const std::array<double, 3>& translation);

  // A 4 x 4 matrix row by row, last row 0 0 0 1. Throws Error bad_pose as above, or for another last row.
  static Pose from_matrix4(const std::array<double, 16>& rows);

  // The rotation of the quaternion w + x i + y j + z k, which need not have unit length: the usual matrix of
  // q / |q|, rounded to doubles, then the translation. Throws Error bad_pose for a quaternion of length zero or
  // numbers that are not finite.
  static Pose from_quaternion(double w, double x, double y, double z, const std::array<double, 3>& translation);

  const Affine3& affine() const { return affine_; }

  // The sizes of the numbers of the two parts, for predicates (see predicate/posed.h).
  const SizeRange& linear_range() const { return linear_range_; }
  const SizeRange& translation_range() const { return translation_range_; }

  // A rotation or a reflection, but for the translation? Columns of the linear part may be off being perpendicular and
  // of length 1 by 2^-20 at most: a check of what users give, in doubles.
  bool is_rigid() const { return is_rigid_; }

 private:
  explicit Pose(const Affine3& affine);
  Affine3 affine_;
  SizeRange linear_range_;
  SizeRange translation_range_;
  bool is_rigid_;
};

// The pose that applies `inner` first, then `outer`, rounded to doubles (one rounding of each sum of products is not
// promised). For chains of joints: the result, as doubles, is what later answers are exact for.
// Throws Error bad_pose when the product overflows or becomes singular.
Pose compose(const Pose& outer, const Pose& inner);

}  // namespace sunder::solid
