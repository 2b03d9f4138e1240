// The square root of a fraction, between neighbouring doubles.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/estimate.h>
#include <sunder/number/interval.h>

#include <optional>

namespace sunder {

// sqrt(numerator / denominator): both ends are that double where it is one, else they are neighbours around it. Beyond
// the range of doubles: the largest and infinity, zero and the least one. Requires numerator >= 0, denominator > 0.
Interval root(const Dyadic& numerator, const Dyadic& denominator);

// The same of estimates, where they are sure. Never of a root that is a double.
std::optional<Interval> sure_root(const Estimate& numerator, const Estimate& denominator);

}  // namespace sunder
