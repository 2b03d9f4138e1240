// A frame of a plane in space: where its flat objects lie.
// Also called: plane coordinates, local coordinate system; workplane, sketch plane.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/object/pose.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace sunder::solid {

// The point (s, t) of the plane is origin + s u + t v in space, exactly. So what is flat in the frame is exactly planar
// in space, whatever the doubles are. u and v need neither have length 1 nor be at a right angle.
struct Frame {
  Point3 origin, u, v;
  friend bool operator==(const Frame&, const Frame&) = default;

  // Throws Error: bad_value where a number is not finite, bad_shape where u and v are parallel (decided exactly).
  static Frame of(const Point3& origin, const Point3& u, const Point3& v) {
    const Frame frame{origin, u, v};
    for (const Point3& p : {origin, u, v}) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        throw Error(ErrorCode::bad_value, "a number is not finite; give finite numbers", "frame");
      }
    }
    if (!frame.third_axis()) {
      throw Error(ErrorCode::bad_shape, "u and v are parallel, or one is zero; give two directions that span a plane",
                  "frame");
    }
    return frame;
  }

  // Takes (s, t, 0) to the point (s, t). What it does to other points is of no meaning.
  Pose pose() const {
    const Point3 w = *third_axis();
    return Pose::from_matrix({u.x, v.x, w.x, u.y, v.y, w.y, u.z, v.z, w.z}, {origin.x, origin.y, origin.z});
  }

 private:
  // An axis that is not in the plane of u and v: that on which their cross product is greatest, as far as rounding
  // tells. Nothing, where there is none.
  std::optional<Point3> third_axis() const {
    const std::array<double, 3> cross{std::fabs(u.y * v.z - u.z * v.y), std::fabs(u.z * v.x - u.x * v.z),
                                      std::fabs(u.x * v.y - u.y * v.x)};
    const std::size_t best = cross[0] >= cross[1] && cross[0] >= cross[2] ? 0 : cross[1] >= cross[2] ? 1 : 2;
    for (const std::size_t k : {best, std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
      Point3 w;
      w[k] = 1;
      const Affine3 affine{{u.x, v.x, w.x, u.y, v.y, w.y, u.z, v.z, w.z}, {}};
      if (determinant_sign(affine) != Sign::zero) return w;
    }
    return std::nullopt;
  }
};

}  // namespace sunder::solid
