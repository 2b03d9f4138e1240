// Where a planar object is: an affine map from the object's frame to the world's.
// Also called: affine transformation, transform; placement, configuration; rigid motion.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <array>

namespace sunder::planar {

// A pose holds six doubles, and these doubles are the map, exactly: x_world = linear x_object + translation.
// A rotation whose matrix was rounded to doubles is very nearly a rotation; answers are exact for the rounded matrix.
// Any invertible linear part is allowed: scale, shear, and reflection (negative determinant) too.
class Pose {
 public:
  // The identity.
  Pose() : Pose(Affine2{}) {}

  // linear: row by row. Throws Error bad_pose where a number is not finite or the linear part is singular
  // (decided exactly).
  static Pose from_matrix(const std::array<double, 4>& linear, const std::array<double, 2>& translation);

  // The rotation about the origin by the angle (radians, counter-clockwise), its sine and cosine rounded to doubles,
  // then the translation. Throws Error bad_pose for numbers that are not finite.
  static Pose from_angle(double angle, const std::array<double, 2>& translation);

  const Affine2& affine() const { return affine_; }
  bool is_identity() const { return affine_ == Affine2{}; }
  bool reflects() const { return reflects_; }  // negative determinant

  // The sizes of the numbers of the two parts, for predicates (see predicate/posed.h).
  const SizeRange& linear_range() const { return linear_range_; }
  const SizeRange& translation_range() const { return translation_range_; }

 private:
  explicit Pose(const Affine2& affine);
  Affine2 affine_;
  bool reflects_ = false;
  SizeRange linear_range_;
  SizeRange translation_range_;
};

// The same map on the plane z = 0 of space.
Affine3 in_space(const Affine2& pose);

}  // namespace sunder::planar
