// Sets of discs and of polygons for bench_sets, the same for every library.
//
// All coordinates and radii are multiples of 2^-40 below 2^12, so that what is true of an input is counted with 128-bit
// integers (set_count.h), apart from the library under test. Objects come in random order. Where nothing meets, the
// boxes of neighbours do, but in the families `spread` and `one`.
#pragma once

#include <bench/inputs/segment_scenarios.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace bench {

struct Disc {
  Xy center;
  double radius = 0;
};

using Ring = std::vector<Xy>;  // counter-clockwise, simple

enum class SetFamily : std::uint8_t {
  // Discs.
  spread_discs,   // one in each cell of a grid, small, somewhere in it: no contact
  packed_discs,   // nearly touching, on a grid that is turned by an eighth: boxes of neighbours meet; no contact
  sized_discs,    // in the squares of a quadtree of 11 levels, turned by an eighth: radii over 3 decades; no contact
  one_disc,       // spread_discs, and a small one across the edge of any of them
  crowded_discs,  // anywhere: about N contacts
  // Convex polygons of 16 vertices.
  coins,           // nearly round, in packed_discs: no contact
  needles,         // four times as long as wide, side by side, turned by an eighth: each box meets eleven; no contact
  one_in_coins,    // coins, and a small one across the edge of any of them
  one_in_needles,  // needles, the same
  // Simple polygons.
  stars,          // of 8 to 64 vertices, in packed_discs: no contact
  tracts,         // a map of tracts of 32 vertices, each shrunk a little: no contact
  one_in_stars,   // stars, and a tiny one across the edge of any of them
  one_in_tracts,  // tracts, the same
  inside_star,    // stars, and a tiny one inside any of them
  // Either.
  crowded_coins,  // coins of packed_discs' sizes anywhere: about N contacts
};

std::string_view name_of(SetFamily);

struct SetInput {
  std::vector<Disc> discs;  // or
  std::vector<Ring> rings;  // one of both is empty
  std::uint64_t pairs = 0;  // that meet: the truth
};

// Several inputs of one family and size, so that small ones are not learnt by heart by the machine, and so that luck in
// finding a single contact evens out. pairs is filled in.
// Throws std::logic_error where an input is not what its family promises.
std::vector<SetInput> make_set_inputs(SetFamily family, std::size_t n, std::uint64_t seed);

}  // namespace bench
