// What a search has found about two convex polyhedra: a claim, and the features that should prove it. Plain data of
// fixed size, without exact numbers; a search knows nothing of certificates. A proposal may be wrong in any way:
// polyhedron_polyhedron_answer.h disposes of it.
#pragma once

#include <sunder/base/function_ref.h>
#include <sunder/predicate/point.h>

#include <array>
#include <cstdint>

namespace sunder::solid {

struct Proposal {
  enum class Claim : std::uint8_t {
    // A direction parts the bodies strictly, A before B.
    apart_along,                // `direction`
    apart_along_sum,            // `direction` and `rest`, exactly
    apart_along_normal_of_a,    // the normal of three vertices of A, in the sense of `direction`
    apart_along_normal_of_b,    // the normal of three vertices of B, in that sense
    apart_along_edge_x_edge,    // two vertices of A, two of B: the cross product of the edges, in that sense
    apart_along_difference,     // of a vertex of A and one of B, in that sense
    apart_along_perpendicular,  // one to three of A and as many of B: from the origin to the simplex of their
                                // differences
    apart_at_vertices,          // the normal of a facet at near_a, or of one at near_b
    meet,                       // the hulls of these vertices of A and of B have a common point
  };
  Claim claim = Claim::meet;
  std::uint8_t count_a = 0, count_b = 0;
  std::array<std::uint32_t, 6> vertices{};  // count_a of A, and then count_b of B
  // Where to look first for the vertices that are extreme along the direction; for `meet`, vertices near the common
  // point.
  std::uint32_t near_a = 0, near_b = 0;
  Point3 direction{};  // finite; meaningless where not mentioned
  Point3 rest{};       // what is to be added to it
};

// Does a proposal hold? What a search asks of it: see answer_by in polyhedron_polyhedron_answer.h.
using Holds = FunctionRef<bool(const Proposal&)>;

inline Proposal apart_along(const Point3& direction, std::uint32_t near_a, std::uint32_t near_b) {
  return {Proposal::Claim::apart_along, 0, 0, {}, near_a, near_b, direction, {}};
}
inline Proposal apart_at_vertices(std::uint32_t near_a, std::uint32_t near_b) {
  return {Proposal::Claim::apart_at_vertices, 0, 0, {}, near_a, near_b, {}, {}};
}

}  // namespace sunder::solid
