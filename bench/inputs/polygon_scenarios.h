// Pairs of convex polygons for bench_polygons, the same for every library.
//
// A shape is the exact hull of n points of an ellipse about the origin, with half-axes 1 (the size) and 0.4 to 1,
// turned by any angle; its points are at random angles or at equal distances along it. A pair is a shape and another
// that was moved, in either order; vertices begin anywhere.
//
// Coordinates are multiples of 2^-52 below 8, so that moving is exact, and what is true of a pair is proved with
// 128-bit integers, apart from the library under test: parted by a line, or a point in common.
#pragma once

#include <sunder/planar/object/convex_polygon.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace bench {

enum class PolygonRegime : std::uint8_t {
  apart,        // by a gap of 0.1 to 0.5; their boxes meet
  near,         // half apart, half meeting; gap or depth log-uniform in 1e-6 to 1e-3; their boxes meet
  overlapping,  // the boundaries cross
  contained,    // one inside the other
  touching,     // exactly: a vertex on a vertex, a vertex on an edge, or equal edges
  boxes_apart,  // by a gap of 0.1 to 1, and a horizontal or vertical line parts them
};

inline constexpr std::array kPolygonRegimes{PolygonRegime::apart,       PolygonRegime::near,
                                            PolygonRegime::overlapping, PolygonRegime::contained,
                                            PolygonRegime::touching,    PolygonRegime::boxes_apart};

std::string_view name_of(PolygonRegime);

struct PolygonPair {
  std::uint32_t a = 0, b = 0;  // positions among the polygons
  bool meet = false;           // the truth
};

struct PolygonScenario {
  std::size_t n = 0;
  PolygonRegime regime = PolygonRegime::apart;
  std::vector<sunder::planar::ConvexPolygon> polygons;
  std::vector<PolygonPair> pairs;
};

// So many pairs at least: at the largest sizes they are few, and what a search looks at stays in the cache.
inline constexpr std::size_t kFewPairs = 8;

// The shapes of a size, for all of its regimes. n vertices up to 1,000; beyond, rounding takes one or two in a hundred.
std::vector<sunder::planar::ConvexPolygon> make_shapes(std::size_t n, std::uint64_t seed);

// Many pairs of small shapes, so that no branch predictor learns them by heart. The result depends on the arguments
// only. Throws std::logic_error where the promises of a regime cannot be kept.
PolygonScenario make_polygon_scenario(std::size_t n, PolygonRegime regime,
                                      const std::vector<sunder::planar::ConvexPolygon>& shapes, std::uint64_t seed);

}  // namespace bench
