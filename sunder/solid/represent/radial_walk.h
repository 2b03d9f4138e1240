// Down a hierarchy to the triangle of the polyhedron's surface that a ray from a point inside goes through, in O(log n)
// steps on every polyhedron.
// Also called: point location on a convex surface; ray shooting from inside (Dobkin and Kirkpatrick).
//
// The ray goes through a triangle of the tetrahedron on the top; it goes on through that as long as it is there, and
// then through one of the star of the vertex that comes beyond it, which is in the place of it.
// Source: Dobkin and Kirkpatrick 1990; Kirkpatrick 1983 for the search.
#pragma once

#include <sunder/number/sign.h>
#include <sunder/solid/represent/hierarchy.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace sunder::solid {

// Three ranks, counter-clockwise from outside.
using RankTriangle = std::array<std::uint32_t, 3>;

// turn(i, j): the sign of the determinant of the vertices of ranks i and j, as seen from a point inside the tetrahedron
// on the top, and of the ray. Where it is exact, so is the answer, a closed triangle; else it is some triangle. Adds
// the vertices asked about to `probes`. Requires a hierarchy that is not flat.
template <class Turn>
RankTriangle triangle_on_ray(const Hierarchy& hierarchy, const Turn& turn, std::uint64_t& probes) {
  const auto& nodes = hierarchy.nodes;
  const auto is_left = [&](std::uint32_t i, std::uint32_t j) { return turn(i, j) != Sign::negative; };
  RankTriangle at{};
  std::uint32_t beyond = Hierarchy::none;
  probes += 4;
  bool found = false;
  for (const std::uint32_t of : {2u, 3u}) {
    for (const Hierarchy::Triangle triangle : nodes[of].star()) {
      if (found) break;
      at = {of, triangle.a, triangle.b};
      beyond = triangle.beyond;
      found = is_left(at[0], at[1]) && is_left(at[1], at[2]) && is_left(at[2], at[0]);
    }
  }
  while (beyond != Hierarchy::none) {
    const std::uint32_t w = beyond;
    const Hierarchy::Star star = nodes[w].star();
    const std::size_t size = star.size();
    probes += size;
    std::size_t k = 0;
    bool is_left_of_k = is_left(w, star[0].a);
    for (; k + 1 < size; ++k) {
      const Sign of_next = turn(w, star[k].b);
      if (is_left_of_k && of_next != Sign::positive) break;
      is_left_of_k = of_next != Sign::negative;
    }
    at = {w, star[k].a, star[k].b};
    beyond = star[k].beyond;
  }
  return at;
}

}  // namespace sunder::solid
