#include <sunder/base/error.h>
#include <sunder/base/lanes.h>
#include <sunder/predicate/filter/regular.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/object/affine_product.h>
#include <sunder/solid/object/pose.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

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

// Two at a time, without branches.
template <std::size_t N>
SizeRange range_of(const std::array<double, N>& numbers) {
  constexpr double none = std::numeric_limits<double>::infinity();
  Lanes least{none, none}, greatest{0, 0};
  const auto include = [&](Lanes pair) {
    const Lanes size = absolute(pair);
    // All bits of a lane make it no number, which is never the smaller one.
    least = smaller_of(least, reinterpret_cast<Lanes>(reinterpret_cast<LanesMask>(size) | (size == 0)));
    greatest = greater_of(greatest, size);
  };
  for (std::size_t k = 0; k + 1 < N; k += 2) include(lanes_at(&numbers[k]));
  if (N % 2 == 1) include(Lanes{numbers[N - 1], 0});
  return {std::min(least[0], least[1]), greater_lane(greatest)};
}

// Read as they are stored (affine_product.h).
bool is_nearly_rigid(const std::array<double, 9>& m) {
  constexpr Lanes allowed{0x1p-20, 0x1p-20};
  const Lanes p = lanes_at(&m[0]), q = lanes_at(&m[2]), r = lanes_at(&m[4]), s = lanes_at(&m[6]);
  Lanes same{0, 0}, third{0, 0}, rest{0, 0};  // of columns: 00 and 11, 02 and 12, 01 and 22
  const auto add_row = [&](Lanes first, double last) {
    same += first * first;
    third += first * last;
    rest += Lanes{first[0], last} * Lanes{first[1], last};
  };
  add_row(p, q[0]);
  add_row(Lanes{q[1], r[0]}, r[1]);
  add_row(s, m[8]);
  const auto is_near = [&](Lanes x, Lanes to) { return is_at_most(absolute(x - to), allowed); };
  return bits_of(is_near(same, Lanes{1, 1}) & is_near(third, Lanes{0, 0}) & is_near(rest, Lanes{0, 1})) == 3;
}

}  // namespace

Pose::Pose(const Affine3& affine)
    : affine_(affine),
      linear_range_(range_of(affine.linear)),
      translation_range_(range_of(affine.translation)),
      is_rigid_(is_nearly_rigid(affine.linear)) {}

Pose Pose::from_matrix(const std::array<double, 9>& linear, const std::array<double, 3>& translation) {
  const auto& m = linear;
  const auto& t = translation;
  // Two numbers at a time, as they are copied (affine_product.h).
  const Pose made(
      std::bit_cast<Affine3>(std::array<Lanes, 6>{Lanes{m[0], m[1]}, Lanes{m[2], m[3]}, Lanes{m[4], m[5]},  //
                                                  Lanes{m[6], m[7]}, Lanes{m[8], t[0]}, Lanes{t[1], t[2]}}));
  const bool is_regular = is_surely_regular(made.affine_, made.linear_range_.greatest);
  if (!is_regular) require_finite(linear, "the matrix");
  require_finite(translation, "the translation");
  if (!is_regular && determinant_sign(made.affine_) == Sign::zero) {
    throw Error(ErrorCode::bad_pose, "the matrix is singular; give an invertible one", "pose");
  }
  return made;
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
  const Affine3 product = affine_product(outer.affine(), inner.affine());
  return Pose::from_matrix(product.linear, product.translation);
}

}  // namespace sunder::solid
