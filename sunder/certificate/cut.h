// The common part of a convex body and a line, a ray or a segment: the types that the plane and space share. The
// answers are in planar/pair/polygon_cut.h and solid/line/polyhedron_cut.h. The evidence of each has one alternative
// for each outcome.
// Also called: clipped line; chord.
//
// The line runs from its point a through its point b; so do the ray, from a on, and the segment, from a to b.
#pragma once

#include <sunder/certificate/pair_answer.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

namespace sunder {

enum class CutKind : std::uint8_t {
  nothing,
  point,   // one point
  along,   // a part of an edge, or of a facet, of positive length: nothing of it is inside the body
  across,  // a segment through the body's inside
  part,    // of a half-plane: what its line cuts off
  whole,   // of a half-plane: all of the polygon
};

std::string_view name_of(CutKind);  // "across"

// Is an end of the common part one of the ray or segment itself?
enum class OwnEnd : std::uint8_t { none, a, b };

// Which of its points a and b end the other: both of a segment, a of a ray, none of a line.
struct OwnEnds {
  bool a = false, b = false;
};

// Each alternative says its kind.
template <class... Cut>
  requires(std::is_same_v<decltype(Cut::kind), const CutKind> && ...)
CutKind kind_of(const std::variant<Cut...>& evidence) {
  static constexpr std::array kinds{Cut::kind...};
  return kinds[evidence.index()];
}
template <class Evidence>
CutKind kind_of(const Answer<Evidence>& cut) {
  return kind_of(cut.evidence);
}

// The ends of a common part, in the direction from a to b; of a point, that twice.
template <class End>
struct CutEnds {
  End first, last;
  friend bool operator==(const CutEnds&, const CutEnds&) = default;
};

// Nothing where there is no common part, or it has no ends on the line.
template <class End, class... Cut>
std::optional<CutEnds<End>> ends_in(const std::variant<Cut...>& evidence) {
  return std::visit(
      [](const auto& cut) -> std::optional<CutEnds<End>> {
        if constexpr (requires { cut.at; }) return CutEnds<End>{cut.at, cut.at};
        if constexpr (requires { cut.first; }) return CutEnds<End>{cut.first, cut.last};
        return std::nullopt;
      },
      evidence);
}

}  // namespace sunder
