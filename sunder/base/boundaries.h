// How the boundaries of two convex objects lie to each other.
#pragma once

#include <sunder/base/names.h>

#include <cstdint>
#include <string_view>

namespace sunder {

enum class Boundaries : std::uint8_t {
  apart,       // the objects do not meet
  meet,        // the boundaries have a common point
  a_inside_b,  // A is in the interior of B
  b_inside_a,
};

inline std::string_view name_of(Boundaries relation) {  // "boundaries meet", "A inside B"
  return name_in<Boundaries::b_inside_a>({"apart", "boundaries meet", "A inside B", "B inside A"}, relation);
}

// `a_inside`, `b_inside`: is one strictly on the inner side of all edges or facets of the other?
inline Boundaries boundaries_of(bool meet, bool a_inside, bool b_inside) {
  return !meet      ? Boundaries::apart
         : a_inside ? Boundaries::a_inside_b
         : b_inside ? Boundaries::b_inside_a
                    : Boundaries::meet;
}

}  // namespace sunder
