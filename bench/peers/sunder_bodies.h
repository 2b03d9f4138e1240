// The library under test in bench_pair, asked as its peers are.
#pragma once

#include <bench/contest/contest.h>
#include <bench/inputs/body_scenarios.h>

namespace bench {

// The front door, certificate included. Bodies and poses are prepared, answers are not kept.
Ready prepare_sunder(const Scenario&);

}  // namespace bench
