// The directions of R^d, cut into cones along each of which one of a few points is furthest: the normal fan of their
// hull, triangulated. In floating point: it proposes, and may be wrong; what is built on it is verified.
// Also called: normal cones of vertices; the polar polytope, triangulated from the origin.
// Source: BL15 section 6, Lemma 6.1: a cone is a simplex of the polar, and the half-spaces of its d facets are a
// shell-simplex; from the origin d half-spaces do instead of d + 1. Triangulated by pulling the facet of the least
// number, which needs no order of its own where cones meet.
#pragma once

#include <sunder/predicate/filter/along_columns.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sunder::polytope {

struct NormalFan {
  static constexpr std::uint32_t none = 0xffffffff;
  using Numbers = std::array<std::uint32_t, most_columns>;  // the first d

  struct Cone {
    std::uint32_t apex = 0;  // the point that is furthest along all of the cone
    Numbers rays{};
    Numbers across{};  // the cone on the other side of the facet without ray i
  };

  std::size_t dimension = 0;
  std::vector<double> rays;  // d each: normals of the hull's facets, out of it, the greatest component of size 1
  std::vector<Cone> cones;
  std::vector<Numbers> facets;  // of the hull, by their points

  std::span<const double> ray(std::uint32_t k) const { return std::span(rays).subspan(k * dimension, dimension); }
};

// points: d after d, some d + 1 to some hundred, in general position (add noise). Nothing where floating point finds no
// hull with an interior, or no two cones at each facet. Cost: of n points some n times the facets of the hull, which
// are up to about n^(d/2); looks grows by how many facets were looked at, for each point and each face, and by d for
// each cone.
std::optional<NormalFan> normal_fan(std::size_t d, std::span<const double> points, std::uint64_t& looks);
inline std::optional<NormalFan> normal_fan(std::size_t d, std::span<const double> points) {
  std::uint64_t looks = 0;
  return normal_fan(d, points, looks);
}

}  // namespace sunder::polytope
