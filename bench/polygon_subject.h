// The library under test in bench_polygons, asked as its peers are: all methods, in place and posed.
#pragma once

#include <sunder/planar/pair/polygon_polygon.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "peers/polygon_peer.h"

namespace bench {

struct PolygonMethod {
  std::string_view name;
  sunder::PairAnswer (*answer)(const sunder::planar::ConvexPolygon& a, const sunder::planar::Pose& pose_a,
                               const sunder::planar::ConvexPolygon& b, const sunder::planar::Pose& pose_b);
};

// The first one is the front door.
std::span<const PolygonMethod> polygon_methods();

// Sums over all pairs of a scenario.
struct PolygonTally {
  std::uint64_t pairs = 0, finishing = 0, probes = 0, exact = 0;
  std::uint64_t wrong = 0;  // another verdict than the truth, or a certificate that the absolute check refuses

  PolygonTally& operator+=(const PolygonTally& other);
};

class PolygonSubject : public PolygonPeer {
 public:
  // Untimed: answers all pairs once more, and adds up what the answers say. Checks their certificates if told to, which
  // is linear.
  virtual PolygonTally tally(bool certificates) const = 0;
};

// By the method, certificate included. Polygons and poses are prepared, answers are not kept. Posed: each pair has a
// rotation and translation of its own, the same for both polygons, so that the truth is the same exactly.
std::unique_ptr<PolygonSubject> make_polygon_subject(const PolygonScenario&, const PolygonMethod&, bool posed);

}  // namespace bench
