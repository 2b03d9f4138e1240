// Sets of half-planes, convex polygons and discs for bench_regions, which have a common part around the origin.
//
// Numbers are multiples of 2^-40 at most 2, those of polygons multiples of 2^-26, so that the sides of the common part
// are counted with 128-bit integers (region_count.h), apart from the library under test. Objects come in random order.
#pragma once

#include <bench/inputs/set_scenarios.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace bench {

struct Inequality {  // a x + b y <= c, of a half-plane; c > 0
  double a = 0, b = 0, c = 0;
};

enum class RegionFamily : std::uint8_t {
  tangents,         // half-planes that touch the unit circle, evenly but for a jitter: all are essential
  random,           // any angle, at a distance of 1 to 2: few are essential
  parallels,        // tangents, and beside each of them one that is parallel, a little further out: half are essential
  polygons_around,  // convex 16-gons whose sides touch the unit circle: many sides are essential
  polygons,         // convex 16-gons of a radius from 1 to 1.5: few sides are essential
  discs_around,     // unit discs with centres on a circle of radius 1/2: all are essential
  discs,            // with centres in a disc of radius 1/2, and radii from 1 to 1.5: few are essential
};

std::string_view name_of(RegionFamily);

struct RegionInput {
  std::vector<Inequality> half_planes;   // or
  std::vector<Ring> rings;               // or
  std::vector<Disc> discs;               // the others are empty
  std::uint64_t sides = 0;               // of the common part: segments, or arcs
  std::vector<std::uint32_t> essential;  // half-planes with a side, counter-clockwise
};

// Several inputs of one family and size, so that small ones are not learnt by heart by the machine. sides and essential
// are filled in. Throws std::logic_error where an input is not what its family promises.
std::vector<RegionInput> make_region_inputs(RegionFamily family, std::size_t n, std::uint64_t seed);

}  // namespace bench
