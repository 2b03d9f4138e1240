// Pairs of polytopes of two to six dimensions, plain and nasty: random, cross-polytopes, cubes, simplices, cyclic
// polytopes, lower-dimensional ones, those that touch, and those that are a last bit from it; of points or half-spaces.
#pragma once

#include <sunder/base/random.h>
#include <sunder/polytope/object/polytope.h>
#include <sunder/polytope/object/pose.h>
#include <sunder/polytope/represent/hierarchical_tree.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace sunder::tests {

enum class PolytopeFamily : std::uint8_t { random, cross, cube, simplex, cyclic, flat, touching, last_bit, scales };

inline constexpr std::array all_polytope_families{
    PolytopeFamily::random,   PolytopeFamily::cross,    PolytopeFamily::cube,
    PolytopeFamily::simplex,  PolytopeFamily::cyclic,   PolytopeFamily::flat,
    PolytopeFamily::touching, PolytopeFamily::last_bit, PolytopeFamily::scales};

std::string_view name_of(PolytopeFamily);

struct PolytopePair {
  PolytopeFamily family;
  polytope::Polytope a, b;
  polytope::Pose pose_a, pose_b;
};

// A tree of a body as small as these: nets and leaves of very few rows, which are taken as they come.
polytope::HierarchicalTree small_tree(const polytope::Polytope& body);

class PolytopePairs {
 public:
  explicit PolytopePairs(std::uint64_t seed) : random_(seed) {}

  // Two bodies of points of some dimension from 2 to 6, or of this one.
  PolytopePair next();
  PolytopePair next(std::size_t dimension);

  // At least one of half-spaces: few of them, so that all outcomes come about.
  PolytopePair next_of_half_spaces();

 private:
  using Numbers = std::vector<double>;
  polytope::Polytope body(PolytopeFamily family, std::size_t d, std::size_t count);
  polytope::Polytope half_spaces(std::size_t d);
  polytope::Pose pose(std::size_t d, double reach);
  PolytopePair touching(std::size_t d, PolytopeFamily family);

  Random random_;
  std::size_t turn_ = 0;
};

}  // namespace sunder::tests
