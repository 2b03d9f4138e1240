#include <sunder/base/error.h>
#include <sunder/planar/object/pose.h>
#include <sunder/predicate/line/arrows.h>

#include <cmath>

namespace sunder::planar {

namespace {

void require_finite(std::span<const double> numbers) {
  for (const double x : numbers) {
    if (!std::isfinite(x)) throw Error(ErrorCode::bad_pose, "a number is not finite; give finite doubles", "pose");
  }
}

Sign determinant_sign(const Affine2& pose) {
  const auto& m = pose.linear;
  return cross_2d(Point2{}, {m[0], m[2]}, Point2{}, {m[1], m[3]});
}

}  // namespace

Pose::Pose(const Affine2& affine)
    : affine_(affine),
      reflects_(determinant_sign(affine) == Sign::negative),
      linear_range_(size_range(std::span<const double>(affine.linear))),
      translation_range_(size_range(std::span<const double>(affine.translation))) {}

Pose Pose::from_matrix(const std::array<double, 4>& linear, const std::array<double, 2>& translation) {
  require_finite(linear);
  require_finite(translation);
  const Affine2 affine{linear, translation};
  if (determinant_sign(affine) == Sign::zero) {
    throw Error(ErrorCode::bad_pose, "the matrix is singular; give an invertible one", "pose");
  }
  return Pose(affine);
}

Pose Pose::from_angle(double angle, const std::array<double, 2>& translation) {
  require_finite({&angle, 1});
  const double c = std::cos(angle), s = std::sin(angle);
  return from_matrix({c, -s, s, c}, translation);
}

Affine3 in_space(const Affine2& pose) {
  const auto& [m, t] = pose;
  return {{m[0], m[1], 0, m[2], m[3], 0, 0, 0, 1}, {t[0], t[1], 0}};
}

}  // namespace sunder::planar
