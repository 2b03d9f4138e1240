#include <sunder/base/error.h>
#include <sunder/planar/object/constraints.h>

#include <cmath>
#include <string>
#include <utility>

namespace sunder::planar {

Constraints::Constraints(std::vector<Constraint> given) : constraints_(std::move(given)) {
  if (constraints_.size() >= std::size_t{1} << 31) {
    throw Error(ErrorCode::bad_shape, "a set holds fewer than 2^31 half-planes; split it");
  }
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    const auto place = [k] { return "half-plane " + std::to_string(k); };
    const auto& [a, b, c] = constraints_[k];
    if (!std::isfinite(a) || !std::isfinite(b) || !std::isfinite(c)) {
      throw Error(ErrorCode::bad_value, "a coefficient is not finite; every number must be: repair the data", place());
    }
    if (a == 0 && b == 0) {
      throw Error(ErrorCode::bad_shape, "a and b are zero; leave it out, or give one of them another value", place());
    }
  }
}

}  // namespace sunder::planar
