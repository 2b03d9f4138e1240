// How many pairs of discs or of polygons meet: the truth for bench_sets, by 128-bit integers.
#pragma once

#include <bench/inputs/set_scenarios.h>

#include <cstdint>
#include <span>

namespace bench {

// Do these meet? Closed, with their insides.
bool exact_contact(const Disc& a, const Disc& b);
bool exact_contact(const Ring& a, const Ring& b);

// The number of pairs that meet. Boxes are looked up in a grid.
std::uint64_t count_pairs(std::span<const Disc> discs);
std::uint64_t count_pairs(std::span<const Ring> rings);

}  // namespace bench
