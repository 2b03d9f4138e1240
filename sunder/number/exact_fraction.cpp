#include <sunder/number/exact_fraction.h>

#include <cmath>
#include <limits>

namespace sunder {

Interval ExactFraction::enclosure() const {
  const double near = nearest();
  const Sign rest = (Dyadic(near) * denominator - numerator).sign();
  if (rest == Sign::zero) return {near, near};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return rest == Sign::positive ? Interval{std::nextafter(near, -infinity), near}
                                : Interval{near, std::nextafter(near, infinity)};
}

}  // namespace sunder
