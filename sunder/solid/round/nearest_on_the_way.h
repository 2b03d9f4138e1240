// The nearest points of the cores of two bodies on their ways, exactly. For the sources of solid/round.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/number/dyadic.h>
#include <sunder/number/vector.h>
#include <sunder/solid/search/placed.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace sunder::solid {

// A vertex of A's core and one of B's, at the beginning or at the end; weight over the sum of all weights.
struct WayCorner {
  std::uint32_t a = 0, b = 0;
  bool at_end = false;
  Vector3<Dyadic> at;  // A's less B's, with what A goes as seen from B
  Dyadic weight;       // above zero
};

// At most three corners make `way`, the least vector of all that lead from B's core to A's at one time, times
// `weight`, the sum of their weights.
struct NearestOnTheWay {
  std::vector<WayCorner> corners;
  Vector3<Dyadic> way;
  Dyadic weight;
};

// Both cores at a pose each; `begin`, `end`: what A is moved from there, less what B is, when the way begins and when
// it ends; at rest they are equal. Nothing where the cores meet on their ways. Exact. Source: Wolfe 1976, "Finding the
// nearest point in a polytope", in exact numbers: it comes nearer with each corner, so it ends. Cost: some three to
// fifteen corners.
std::optional<NearestOnTheWay> nearest_on_the_way(const Placed& a, const Placed& b, const Vector3<Dyadic>& begin,
                                                  const Vector3<Dyadic>& end, Cost& cost, StageTally& tally);

}  // namespace sunder::solid
