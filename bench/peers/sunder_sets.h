// The library under test in bench_sets, asked as its peers are.
#pragma once

#include <bench/inputs/set_scenarios.h>
#include <bench/peers/set_peer.h>

namespace bench {

// Sunder's front doors: discs_any and discs_all, convex_polygons_any where the polygons are convex (there is no
// convex_polygons_all), polygons_any and polygons_all else. Objects are prepared; the input need not outlive the call.
enum class SetKind { discs, convex_polygons, polygons };
Asked ask_sunder(const SetInput& input, SetKind kind, SetQuestion question);

// The same with the transcript that proves that there are none. Empty where there is no such.
Asked ask_sunder_for_transcript(const SetInput& input, SetKind kind);

}  // namespace bench
