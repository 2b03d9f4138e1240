// The nearest points of the cores of two bodies on their ways, exactly. For the sources of solid/round.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/certificate/common_point.h>
#include <sunder/number/dyadic.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/point/shortest_way.h>
#include <sunder/solid/search/placed.h>

#include <optional>

namespace sunder::solid {

// The least way of all that lead from B's core to A's at one time. Its ends are made of up to three vertices of each,
// over the way's denominator; of the same, `at_end` is the time.
struct NearestOnTheWay {
  ShortestWay<Dyadic> way;
  Combination of_a, of_b;
  Dyadic at_end;
};

// Both cores at a pose each; `begin`, `end`: what A is moved from there, less what B is, when the way begins and when
// it ends; at rest they are equal. Nothing where the cores meet on their ways. Exact: the search of exact_gjk.h among
// differences of a vertex of A and one of B, at the beginning or at the end. Cost: some three to fifteen of these.
std::optional<NearestOnTheWay> nearest_on_the_way(const Placed& a, const Placed& b, const Vector3<Dyadic>& begin,
                                                  const Vector3<Dyadic>& end, Cost& cost, StageTally& tally);

}  // namespace sunder::solid
