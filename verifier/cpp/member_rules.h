// What the rules of sets ask of a member: how it meets another, which points it holds, and the box that it lies in.
#pragma once

#include <verifier/cpp/rules.h>

#include <string>

namespace sunder_verifier {

inline Integer square(const Integer& n) { return n * n; }

// x, y, w, in units of 2^exponent.
Integers in_units(Numbers point, std::int64_t exponent);

// Positive: the point is outside.
Integer power_of(const PlanarDisc& disc, const Integers& place);

PlanarBox box_of(const PlanarDisc& disc);
bool holds(const PlanarDisc& disc, const Integers& place);
std::string kind_of(const PlanarDisc& c, const PlanarDisc& d);  // empty where they do not meet

inline PlanarBox box_of(const PlanarBox& box) { return box; }
bool holds(const PlanarBox& box, const Integers& place);
std::string kind_of(const PlanarBox& a, const PlanarBox& b);

}  // namespace sunder_verifier
