// What a joint does, as bare numbers. Inline, for those who multiply it with others at once: it need not be stored.
#pragma once

#include <sunder/io/urdf.h>
#include <sunder/predicate/point.h>

#include <array>
#include <cmath>

namespace sunder::io {

// Where a joint of this value has its child, within its frame at value 0. A turn is computed in doubles; its entries
// are exactly 0, 1, +-sine and cosine where the axis is a coordinate axis.
inline Affine3 joint_map(const Joint& joint, double value) {
  const auto [x, y, z] = joint.axis;
  switch (joint.type) {
    case JointType::fixed: break;
    case JointType::prismatic: return {Affine3{}.linear, {x * value, y * value, z * value}};
    case JointType::revolute:
    case JointType::continuous: {
      const double c = std::cos(value), s = std::sin(value), d = 1 - c;
      return {{x * x + c * (1 - x * x), x * y * d - z * s, x * z * d + y * s,  //
               x * y * d + z * s, y * y + c * (1 - y * y), y * z * d - x * s,  //
               x * z * d - y * s, y * z * d + x * s, z * z + c * (1 - z * z)},
              {}};
    }
  }
  return {};
}

}  // namespace sunder::io
