// The methods of polygon_polygon.h over any sequences of vertices (placed.h): so a search can be watched.
// Each is right on its own, and throws nothing. Cost: as in polygon_polygon.h.
#pragma once

#include <sunder/planar/pair/cone_search.h>
#include <sunder/planar/pair/halving.h>
#include <sunder/planar/pair/nearest_search.h>
#include <sunder/planar/pair/polygon_polygon_answer.h>

namespace sunder::planar {

template <class A, class B>
PairAnswer answer_by_cone(const A& a, const B& b) {
  return answer_by(a, b, [&](const auto& holds, Cost& cost, StageTally& tally) {
    return propose_by_cone(a, b, holds, cost, tally);
  });
}

template <class A, class B>
PairAnswer answer_by_halving(const A& a, const B& b) {
  return answer_by(a, b, [&](const auto& holds, Cost& cost, StageTally& tally) {
    return propose_by_halving(a, b, holds, cost, tally);
  });
}

template <class A, class B>
PairAnswer answer_by_nearest(const A& a, const B& b) {
  return answer_by(a, b,
                   [&](const auto& holds, Cost& cost, StageTally&) { return propose_by_nearest(a, b, holds, cost); });
}

}  // namespace sunder::planar
