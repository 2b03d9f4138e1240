#include <sunder/base/error.h>
#include <sunder/predicate/orient.h>
#include <sunder/solid/object/pose.h>

#include <algorithm>
#include <cmath>

namespace sunder::solid {

namespace {

template <std::size_t N>
void require_finite(const std::array<double, N>& numbers, const char* what) {
  for (const double x : numbers) {
    if (!std::isfinite(x)) {
      throw Error(ErrorCode::bad_pose, std::string(what) + " has a number that is not finite; give finite doubles",
                  "pose");
    }
  }
}

bool is_nearly_rigid(const std::array<double, 9>& m) {
  constexpr double allowed = 0x1p-20;
  const auto off = [&](std::size_t i, std::size_t j) {
    const double product = m[i] * m[j] + m[3 + i] * m[3 + j] + m[6 + i] * m[6 + j];
    return std::fabs(product - (i == j ? 1 : 0));
  };
  return std::max(std::max(std::max(off(0, 0), off(1, 1)), off(2, 2)),
                  std::max(std::max(off(0, 1), off(0, 2)), off(1, 2))) <= allowed;
}

}  // namespace

Pose::Pose(const Affine3& affine)
    : affine_(affine),
      linear_range_(size_range(std::span<const double>(affine.linear))),
      translation_range_(size_range(std::span<const double>(affine.translation))),
      is_rigid_(is_nearly_rigid(affine.linear)) {}

Pose Pose::from_matrix(const std::array<double, 9>& linear, const std::array<double, 3>& translation) {
  require_finite(linear, "the matrix");
  require_finite(translation, "the translation");
  const Affine3 affine{linear, translation};
  if (determinant_sign(affine) == Sign::zero) {
    throw Error(ErrorCode::bad_pose, "the matrix is singular; give an invertible one", "pose");
  }
  return Pose(affine);
}

Pose Pose::from_matrix4(const std::array<double, 16>& r) {
  if (r[12] != 0 || r[13] != 0 || r[14] != 0 || r[15] != 1) {
    throw Error(ErrorCode::bad_pose, "the last row of the 4 x 4 matrix is not 0 0 0 1; give rows, not columns", "pose");
  }
  return from_matrix({r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10]}, {r[3], r[7], r[11]});
}

Pose Pose::from_quaternion(double w, double x, double y, double z, const std::array<double, 3>& translation) {
  require_finite(std::array{w, x, y, z}, "the quaternion");
  // Scaled by a power of two first, so that squares neither overflow nor vanish.
  const double largest = std::max(std::max(std::fabs(w), std::fabs(x)), std::max(std::fabs(y), std::fabs(z)));
  if (largest == 0) {
    throw Error(ErrorCode::bad_pose, "the quaternion has length zero; give one of length one", "pose");
  }
  const int scale = -std::ilogb(largest);
  w = std::ldexp(w, scale);
  x = std::ldexp(x, scale);
  y = std::ldexp(y, scale);
  z = std::ldexp(z, scale);
  // As quotients, so that quarter and half turns about the axes come out exactly, whatever the quaternion's length.
  const double ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  const double n = (ww + xx) + (yy + zz);
  return from_matrix({((ww + xx) - (yy + zz)) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n,  //
                      2 * (x * y + w * z) / n, ((ww + yy) - (xx + zz)) / n, 2 * (y * z - w * x) / n,  //
                      2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, ((ww + zz) - (xx + yy)) / n},
                     translation);
}

Pose compose(const Pose& outer, const Pose& inner) {
  const Affine3& a = outer.affine();
  const Affine3& b = inner.affine();
  std::array<double, 9> linear;
  std::array<double, 3> translation;
  for (std::size_t i = 0; i < 3; ++i) {
    const double* row = &a.linear[3 * i];
    for (std::size_t j = 0; j < 3; ++j) {
      linear[3 * i + j] = row[0] * b.linear[j] + row[1] * b.linear[3 + j] + row[2] * b.linear[6 + j];
    }
    translation[i] =
        row[0] * b.translation[0] + row[1] * b.translation[1] + row[2] * b.translation[2] + a.translation[i];
  }
  return Pose::from_matrix(linear, translation);
}

}  // namespace sunder::solid
