// What bounds a common part: the truth for bench_regions.
#pragma once

#include <bench/inputs/region_scenarios.h>

#include <cstdint>
#include <span>
#include <vector>

namespace bench {

// a x + b y <= c with |a|, |b| < 2^41, 0 < c < 2^56, and |a c|, |b c| < 2^84.
struct WholeInequality {
  std::int64_t a = 0, b = 0, c = 0;
};

// Times 2^40. Requires multiples of 2^-40 below 2.
std::vector<WholeInequality> whole(std::span<const Inequality> half_planes);
// Of the edges, ring after ring; times 2^26. Requires vertices that are multiples of 2^-26, at most 2.
std::vector<WholeInequality> whole(std::span<const Ring> rings);

// Those of which a side remains in the common part, counter-clockwise by their normals: by 128-bit integers. Of equal
// ones the lowest number. Throws std::logic_error where the common part is not bounded.
std::vector<std::uint32_t> essential_sides(std::span<const WholeInequality> half_planes);

// The number of arcs around the common part, which must hold the origin. In floating point: throws std::logic_error
// where arcs are so short that rounding could matter. Cost: linear for each arc.
std::uint64_t count_arcs(std::span<const Disc> discs);

}  // namespace bench
