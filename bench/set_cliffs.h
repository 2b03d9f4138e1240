// Sets of polygons and segments where boxes tell little: what bench_sets demands of them, beside the growth of counted
// probes that tests/planar/polygon_sets_complexity_test.cpp and segments_growth_complexity_test.cpp bound. No peers:
// they were not chosen for these.
#pragma once

#include <bench/contest/contest.h>

#include <cstddef>

namespace bench {

// N square frames around one another; none overlap. With touching allowed, against the same with nothing allowed, as
// the peer "itself".
Contest frames_contest(std::size_t n);

// N / 2 lines across N / 2 others, all of one net, so that none of the crossings count, against the same without nets,
// as the peer "itself". How many contacts? With nets the crossings are added to the answer, to make it the same.
Contest net_contest(std::size_t n);

// N pieces of y = 2x, each of which overlaps each, against as many crossings of lines, as the peer "itself". How many
// contacts? Requires N to be even.
Contest overlaps_contest(std::size_t n);

// A star of 4 N vertices, and N triangles in it: which pairs meet? The sort is of the star's vertices.
Contest star_contest(std::size_t n);

// A ring of 3 N edges that touches itself N - 1 times in one point: is it a valid polygon? The sort is of the ends of
// its edges.
Contest petals_contest(std::size_t n);

}  // namespace bench
