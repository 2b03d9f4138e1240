#include <sunder/solid/exact/sweep_contact.h>

#include <cmath>
#include <limits>

namespace sunder::solid {

Interval SweepContact::about() const {
  const double nearest = nearest_ratio(time, denominator);
  const Sign rest = (Dyadic(nearest) * denominator - time).sign();
  if (rest == Sign::zero) return {nearest, nearest};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return rest == Sign::positive ? Interval{std::nextafter(nearest, -infinity), nearest}
                                : Interval{nearest, std::nextafter(nearest, infinity)};
}

}  // namespace sunder::solid
