// How many pairs of segments meet: the truth for bench_segments, by 128-bit integers.
#pragma once

#include <bench/inputs/segment_scenarios.h>

#include <cstdint>
#include <span>

namespace bench {

// The sign of the turn from pq to pr. Requires coordinates that are multiples of 2^-40 below 2^20.
int exact_turn(const Xy& p, const Xy& q, const Xy& r);

// Do these meet in a way that counts?
bool exact_contact(const Line& s, const Line& t, bool shared_ends);

// The number of pairs that meet in a way that counts. Segments are looked up in a grid: fast where they are short.
std::uint64_t count_by_grid(std::span<const Line> lines, bool shared_ends);

// The same for segments that do not pass through the origin, by the angles under which they are seen from there: fast
// where these are narrow.
std::uint64_t count_by_angle(std::span<const Line> lines, bool shared_ends);

}  // namespace bench
