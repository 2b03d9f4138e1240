// Sets of half-spaces of two to six dimensions, with an objective, for tests: small and nasty, from a seed.
#pragma once

#include <sunder/base/random.h>
#include <sunder/polytope/object/polytope.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace sunder::tests {

enum class HalfSpaceFamily : std::uint8_t {
  grid,        // small whole numbers: every degeneracy is common
  concurrent,  // nearly all through one point
  few_ways,    // of up to three directions and their opposites
  cube,        // a cube, and what is redundant or touches it
  flat,        // pairs of opposite ones, whose common part is a flat
  last_bit,    // opposite, but for a unit in the last place
  tangents,    // of a sphere: none is redundant
  scaled,      // small whole numbers, each half-space scaled by a power of two up to 2^900 and down to 2^-900
};
inline constexpr std::size_t half_space_family_count = 8;

std::string_view name_of(HalfSpaceFamily);

struct HalfSpaceSet {
  HalfSpaceFamily family;
  polytope::Polytope half_spaces;
  std::vector<double> objective;
};

class HalfSpaceSets {
 public:
  explicit HalfSpaceSets(std::uint64_t seed) : random_(seed) {}

  // Of each family in turn, of any dimension; of `most` half-spaces at most, but for a few that make it nasty.
  HalfSpaceSet next(std::size_t most = 16);

  // Of this family, dimension and about this number.
  HalfSpaceSet next(HalfSpaceFamily family, std::size_t dimension, std::size_t count);

 private:
  double whole(int most) { return static_cast<double>(random_.between(-most, most)); }

  Random random_;
  std::size_t turn_ = 0;
};

}  // namespace sunder::tests
