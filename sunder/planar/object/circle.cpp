#include <sunder/base/error.h>
#include <sunder/planar/object/circle.h>

#include <cmath>
#include <string>

namespace sunder::planar {

Circles::Circles(std::span<const Circle> given) {
  if (given.size() >= std::size_t{1} << 31) {
    throw Error(ErrorCode::bad_shape, "a set holds fewer than 2^31 circles; split it");
  }
  circles_.reserve(given.size());
  for (const Circle& c : given) {
    const auto place = [&] { return "circle " + std::to_string(circles_.size()); };
    if (!std::isfinite(c.center.x) || !std::isfinite(c.center.y)) {
      throw Error(ErrorCode::bad_value, "a coordinate is not finite; every number must be: repair the data", place());
    }
    if (!std::isfinite(c.radius)) {
      throw Error(ErrorCode::bad_value, "its radius is not finite; every number must be: repair the data", place());
    }
    if (c.radius < 0) {
      throw Error(ErrorCode::bad_value, "its radius is negative; give zero (a point) or more", place());
    }
    circles_.push_back(c);
  }
}

}  // namespace sunder::planar
