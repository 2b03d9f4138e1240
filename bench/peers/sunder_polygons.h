// The library under test in bench_polygons, asked as its peers are: all methods, in place and posed.
#pragma once

#include <bench/contest/contest.h>
#include <bench/inputs/polygon_scenarios.h>

#include <sunder/planar/pair/polygon_polygon.h>

#include <memory>
#include <span>
#include <string_view>

namespace bench {

struct PolygonMethod {
  std::string_view name;
  sunder::PairAnswer (*answer)(const sunder::planar::ConvexPolygon& a, const sunder::planar::Pose& pose_a,
                               const sunder::planar::ConvexPolygon& b, const sunder::planar::Pose& pose_b);
};

// The first one is the front door.
std::span<const PolygonMethod> polygon_methods();

// By the method, certificate included. Polygons and poses are prepared, answers are not kept. Posed: each pair has a
// rotation and translation of its own, the same for both polygons, so that the truth is the same exactly. The tally
// checks certificates, if told to, which is linear.
Ready prepare_sunder(std::shared_ptr<const PolygonScenario>, const PolygonMethod&, bool posed, bool certificates);

}  // namespace bench
