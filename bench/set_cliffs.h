// Sets of polygons where boxes tell little: what bench_sets demands of them, beside the growth of counted probes that
// tests/polygon_sets_complexity_test.cpp bounds. No peers: they were not chosen for these.
#pragma once

#include <cstddef>

#include "set_contest.h"

namespace bench {

// N square frames around one another; none overlap. With touching allowed, against the same with nothing allowed, as
// the peer "itself".
Contest frames_contest(std::size_t n);

// A star of 4 N vertices, and N triangles in it: which pairs meet? The sort is of the star's vertices.
Contest star_contest(std::size_t n);

}  // namespace bench
