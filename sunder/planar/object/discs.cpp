#include <sunder/base/error.h>
#include <sunder/planar/object/discs.h>

#include <cmath>
#include <string>
#include <utility>

namespace sunder::planar {

Discs::Discs(std::vector<Disc> given) : discs_(std::move(given)) {
  if (discs_.size() >= std::size_t{1} << 31) {
    throw Error(ErrorCode::bad_shape, "a set holds fewer than 2^31 circles; split it");
  }
  for (const Disc& c : discs_) {
    const auto place = [&] { return "circle " + std::to_string(&c - discs_.data()); };
    if (!std::isfinite(c.center.x) || !std::isfinite(c.center.y)) {
      throw Error(ErrorCode::bad_value, "a coordinate is not finite; every number must be: repair the data", place());
    }
    if (!std::isfinite(c.radius)) {
      throw Error(ErrorCode::bad_value, "its radius is not finite; every number must be: repair the data", place());
    }
    if (c.radius < 0) {
      throw Error(ErrorCode::bad_value, "its radius is negative; give zero (a point) or more", place());
    }
  }
}

}  // namespace sunder::planar
