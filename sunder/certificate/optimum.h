// What comes out of a linear program, in the plane and in more dimensions: planar/region/linear_program.h,
// polytope/region/linear_program.h.
// Also called: status of a linear program.
#pragma once

#include <sunder/certificate/pair_answer.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <variant>

namespace sunder {

enum class Optimum : std::uint8_t {
  one,         // one point is best
  many,        // more than one
  all,         // the objective is zero: each common point is best, be they one or more
  unbounded,   // common points are as far as one likes
  infeasible,  // no common point
};

std::string_view name_of(Optimum);  // "infeasible"

// The evidence is a variant of plain data, one for each outcome, and the verdict is that of what it holds.
template <class EvidenceOf>
struct [[nodiscard]] ProgramAnswer {
  using Evidence = EvidenceOf;

  Evidence evidence{};
  DecidedBy decided_by = DecidedBy::filter;
  Cost cost{};

  Optimum verdict() const { return verdict_in(evidence); }
  bool feasible() const { return verdict() != Optimum::infeasible; }

 private:
  template <class... Held>
  static Optimum verdict_in(const std::variant<Held...>& evidence) {
    static constexpr std::array verdicts{Held::verdict...};
    return verdicts[evidence.index()];
  }
};

}  // namespace sunder
