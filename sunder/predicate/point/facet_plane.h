// On which side of one plane are many points? A plane through three points, kept in floating point with an error bound
// that serves every point of a box; where it is unsure, orient_3d_of_any_size decides.
#pragma once

#include <sunder/number/sign.h>
#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/predicate/point/scaled_orient.h>

namespace sunder {

// The plane does not keep its points: every call gets those that it was made of. A test that the filter decides costs
// a subtraction, a scalar product and two comparisons.
class FacetPlane {
 public:
  FacetPlane() = default;

  // The plane through a, b, c, for questions about points q with |q - a| <= extent in each coordinate, the difference
  // as rounded. For points of a box its highest corner minus its lowest is enough, because rounding is monotone.
  FacetPlane(const Point3& a, const Point3& b, const Point3& c, const Point3& extent) {
    const auto origin = lift<RoundedStage>(a);
    const auto normal = cross(lift<RoundedStage>(b) - origin, lift<RoundedStage>(c) - origin);
    normal_ = {normal.x.value, normal.y.value, normal.z.value};
    const Vector3<Rounded<1>> reach{{extent.x, extent.x}, {extent.y, extent.y}, {extent.z, extent.z}};
    const auto height = dot(normal, reach);
    error_ = height.bound * height.magnitude + underflow * (1 + extent.x + extent.y + extent.z);
  }

  // A value for orient_3d's formula at q. For choosing among points, not for deciding a sign; may be infinite or NaN.
  double height(const Point3& a, const Point3& q) const {
    return normal_.x * (q.x - a.x) + normal_.y * (q.y - a.y) + normal_.z * (q.z - a.z);
  }

  // orient_3d(a, b, c, q), exactly.
  Sign side(const Point3& a, const Point3& b, const Point3& c, const Point3& q) const {
    const Guess guess = guess_side(a, q);
    return is_sure(guess) ? to_sign(guess) : orient_3d_of_any_size(a, b, c, q);
  }

  // The filter alone, for tests.
  Guess guess_side(const Point3& a, const Point3& q) const {
    const double h = height(a, q);
    if (h > error_) return Guess::positive;
    if (h < -error_) return Guess::negative;
    return Guess::unsure;
  }

  // The same without branches: bit 0 says surely positive, bit 1 surely negative.
  unsigned sure_bits(const Point3& a, const Point3& q) const {
    const double h = height(a, q);
    return static_cast<unsigned>(h > error_) | static_cast<unsigned>(h < -error_) << 1;
  }

 private:
  // `height` evaluates orient_3d's formula, so R1 to R3 of number/rounded.h bound its error by the bound times the
  // magnitude at q, and the magnitude at q is at most that at the extent, because rounding is monotone. Overflow makes
  // the error infinite or NaN, and then nothing is sure.
  // Underflow: a product errs by up to h = 2^-1075 beyond its relative error, sums and differences do not. So each
  // component of the normal is off by at most 2 h more, its product with a coordinate d <= extent by (2 d + 1) h more,
  // and the height by (2 s + 3) h (1 + 3 u), s the sum of the extents. What the magnitude lost is multiplied by the
  // bound, and the last two products err by h each. 8 h (1 + s) covers all of it.
  static constexpr double underflow = 0x1p-1072;

  Point3 normal_;
  double error_ = 0;
};

}  // namespace sunder
