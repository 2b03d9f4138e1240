// Where and when two bodies in motion have a common point, in exact numbers.
#pragma once

#include <sunder/certificate/common_point.h>
#include <sunder/number/exact_fraction.h>

#include <array>

namespace sunder::solid {

// A time at which bodies have a common point, and that point: all exact.
struct SweepContact {
  ExactFraction time;  // from 0 to 1
  CommonPoint point;   // weights of the bodies' vertices, where the bodies are at that time
  // Of the first such time, where it is not 0: along it A ends before B begins, at all times before, and where B begins
  // at this one. Else zero.
  std::array<Dyadic, 3> direction{};
};

}  // namespace sunder::solid
