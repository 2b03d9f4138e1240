// Few vertices of a body whose mean is in its relative interior.
#pragma once

#include <sunder/solid/object/convex_polyhedron.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sunder::solid {

// They span all that the body spans: as many as it has dimensions, and one. Cost: constant, but for a facet with very
// many corners.
inline std::vector<std::uint32_t> spanning_vertices(const ConvexPolyhedron& body) {
  if (body.dimension() == 0) return {0};
  if (body.dimension() == 1) return {0, 1};
  const auto facet = body.facet(0);
  std::vector<std::uint32_t> vertices(facet.begin(), facet.begin() + 3);
  if (body.dimension() == 2) return vertices;
  std::uint32_t off = 0;
  while (std::find(facet.begin(), facet.end(), off) != facet.end()) ++off;
  vertices.push_back(off);
  return vertices;
}

}  // namespace sunder::solid
