// The library under test in bench_pair, asked as its peers are.
#pragma once

#include <bench/contest/contest.h>
#include <bench/inputs/body_scenarios.h>

#include <cstdint>

namespace bench {

// The front door, certificate included. Bodies and poses are prepared, answers are not kept.
Ready prepare_sunder(const Scenario&);

// Other methods, certificates included. What a body needs for the method is made by its first question.
enum class PairBy : std::uint8_t { hierarchy, bounded, polar, drums, scan };
Ready prepare_sunder_by(const Scenario&, PairBy);

// How far apart: the closest features, exactly; and the distance besides, a number to the last bit, which is made when
// asked for.
enum class DistanceAs : std::uint8_t { features, number };
Ready prepare_sunder_distance(const Scenario&, DistanceAs);

}  // namespace bench
