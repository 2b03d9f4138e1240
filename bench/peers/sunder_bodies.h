// The library under test in bench_pair, asked as its peers are.
#pragma once

#include <bench/contest/contest.h>
#include <bench/inputs/body_scenarios.h>

#include <cstdint>

namespace bench {

// The front door, certificate included. Bodies and poses are prepared, answers are not kept.
Ready prepare_sunder(const Scenario&);

// How far apart: the closest features, exactly; and the distance besides, a number to the last bit, which is made when
// asked for.
enum class DistanceAs : std::uint8_t { features, number };
Ready prepare_sunder_distance(const Scenario&, DistanceAs);

}  // namespace bench
