// Sets of segments for bench_segments, the same for every library.
//
// All coordinates are multiples of 2^-40 below 2^12, so that what is true of an input is counted with 128-bit integers
// (segment_count.h), apart from the library under test. Segments of meshes and of random sets come in random order;
// those of stars, meanders and the map in the order of the line that they belong to.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bench {

struct Xy {
  double x = 0, y = 0;
  friend bool operator==(const Xy&, const Xy&) = default;
};

struct Line {
  Xy a, b;
};

enum class SegmentFamily : std::uint8_t {
  mesh,           // edges between neighbours of a jittered grid: shared ends, else no contact
  loose_mesh,     // the middle 90 % of each of them: no contact
  star,           // a polygon of N / 2 spikes, from radius 0.015 to 1: simple
  loose_star,     // the middle 90 % of each edge: no contact
  map,            // consecutive edges of a coastline; if it is too short, copies of it side by side
  wires,          // long horizontals, beside them long verticals; many ends have the same x: no contact
  hidden_end,     // the mesh, and a short segment across the edge that begins furthest right; last in order
  hidden_random,  // the mesh, and a short segment across any edge
  meander,        // a polygon through all vertices of a jittered grid, along its edges: simple
  crossed_mesh,   // half mesh, half short random segments: about N crossings
  random,         // short random segments: about 10 N crossings
  tangled_star,   // a star whose tips are moved sideways: about N crossings of long edges
};

std::string_view name_of(SegmentFamily);

struct SegmentInput {
  std::vector<Line> lines;
  std::vector<Xy> ring;      // of a polygon: its vertices, counter-clockwise; lines are its edges in order
  bool shared_ends = false;  // a common point that is an end of both does not count as a contact
  std::uint64_t pairs = 0;   // that meet in a way that counts: the truth
};

// Several inputs of one family and size, so that small ones are not learnt by heart by the machine.
// n: about the number of segments (exactly, but for the meander). pairs is filled in.
// Throws std::logic_error where an input is not what its family promises.
std::vector<SegmentInput> make_segment_inputs(SegmentFamily family, std::size_t n, std::uint64_t seed,
                                              const std::vector<Line>& map);

// Rounds the coordinates as said above.
std::vector<Line> rounded(std::vector<Line> lines);

}  // namespace bench
