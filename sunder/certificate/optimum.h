// What comes out of a linear program, in the plane and in more dimensions. Its answer is an Answer of evidence that has
// one alternative for each outcome: planar/region/linear_program.h, polytope/region/linear_program.h.
// Also called: status of a linear program.
#pragma once

#include <sunder/certificate/pair_answer.h>

#include <cstdint>
#include <string_view>

namespace sunder {

enum class Optimum : std::uint8_t {
  one,         // one point is best
  many,        // more than one
  all,         // the objective is zero: each common point is best, be they one or more
  unbounded,   // common points are as far as one likes
  infeasible,  // no common point
};

std::string_view name_of(Optimum);  // "infeasible"

// Has the program a common point?
template <class Evidence>
bool is_feasible(const Answer<Evidence>& program) {
  return program.verdict() != Optimum::infeasible;
}

}  // namespace sunder
