// The search of Gilbert, Johnson and Keerthi in exact numbers: the nearest points of the hulls A and B. What it finds
// is decided. (solid/search/gjk.h is the search in floating point, which proposes.)
// Also called: Wolfe's algorithm for the nearest point in a polytope.
// Source: Gilbert, Johnson & Keerthi 1988; Wolfe 1976, "Finding the nearest point in a polytope".
#pragma once

#include <sunder/solid/search/closest_features.h>

#include <array>
#include <cstdint>

namespace sunder::solid {

// Few vertices of A and of B, and the way from A to B between the nearest points of their hulls.
struct ExactNearest {
  VertexSet<Dyadic> a, b;
  ClosestWay<Dyadic> closest;

  // With A the origin alone: the point of B that is nearest to the origin.
  static ExactNearest to_origin();

  std::uint32_t of_a() const { return closest.features.of_a(0); }
  std::uint32_t of_b() const { return closest.features.of_b(0); }

  // Leaves only the vertices that the nearest points need, in their order, and finds the way. False where the hulls
  // meet: where the way is zero, its ends are a common point. Ways are counted, as closest_way does.
  bool reduce(std::uint32_t& ways);
};

// From these vertices on. Each step comes strictly nearer: where a vertex is further along the way d than the features
// are, the segment from their end of d to it has points that are nearer to the other end. So no features come twice,
// and there are only so many of them. False where the hulls meet, as of `reduce`. Some one to fifteen steps.
// Support: what the search knows of A and B, which are given by the vertices that it names.
//   extreme(nearest)     a vertex of A that is furthest along the way, and one of B that is least far: those of the
//                        first features, nearest.of_a() and nearest.of_b(), where none are beyond them
//   join(nearest, next)  adds such vertices to the sets, as far as they are not there. All of them may be times a number
//                        that changes from step to step.
template <class Support>
bool exact_gjk(Support& support, ExactNearest& nearest, std::uint32_t& ways) {
  while (nearest.reduce(ways)) {
    const std::array<std::uint32_t, 2> next = support.extreme(nearest);
    if (next == std::array{nearest.of_a(), nearest.of_b()}) return true;
    support.join(nearest, next);
  }
  return false;
}

}  // namespace sunder::solid
