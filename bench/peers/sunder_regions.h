// The library under test in bench_regions, asked as its peers are.
#pragma once

#include <bench/inputs/region_scenarios.h>
#include <bench/peers/region_peer.h>

#include <span>

namespace bench {

// Sunder's front doors. Objects are prepared; the input need not outlive the call.
Asked ask_sunder(const RegionInput& input);                    // the number of sides
Asked ask_sunder_for_evidence(const RegionInput& input);       // the same with evidence; half-planes only
Asked ask_sunder(const RegionInput& input, const Objective&);  // a linear program: pair_of the two half-planes

// The sum of the pairs of all objectives, by the region, which is prepared.
Asked ask_sunder_by_region(const RegionInput& input, std::span<const Objective> objectives);

}  // namespace bench
