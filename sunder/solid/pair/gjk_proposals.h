// The proposals of Gilbert, Johnson and Keerthi's search, wherever it begins. See docs/design/solid-pair.md.
// holds(proposal): see answer_by in polyhedron_polyhedron_answer.h. Each is true where a proposal held.
#pragma once

#include <sunder/solid/pair/gjk_search.h>
#include <sunder/solid/pair/settle.h>
#include <sunder/solid/pair/simplex_proposals.h>

namespace sunder::solid {

// In doubles, from search.direction on, with directions in doubles for bodies that are apart.
template <class Holds>
bool propose_in_doubles(const Placed& a, const Placed& b, GjkSearch<double>& search, const Holds& holds, Cost& cost) {
  Nearing<double> nearing;
  for (int i = 0; i < search.most_iterations; ++i) {
    ++cost.iterations;
    const DifferenceVertex w = search.probe(cost);
    if (dot(search.direction, w.at) < 0) {
      if (search.refine()) continue;
      DifferenceVertex furthest = w;
      Point3 direction = search.direction;
      if (settle(search.simplex, direction, furthest) && holds(apart_along(direction, furthest.a, furthest.b))) {
        return true;
      }
    }
    if (!search.gains_by(w)) {
      if (search.refine()) continue;
      break;
    }
    if (!search.step_to(w)) break;
    if (!nearing.goes_on(search.distance2)) break;
  }
  return propose_meet(a, b, search.simplex, holds) ||
         propose_apart_along_features(search.simplex, search.direction, holds);
}

// The same search in twice the precision, for gaps and depths in the last bits; with directions perpendicular to the
// simplex for bodies that are apart.
template <class Holds>
bool propose_in_double_doubles(const Placed& a, const Placed& b, const Point3& direction, const Holds& holds,
                               Cost& cost) {
  GjkSearch<DoubleDouble> search(a, b);
  search.direction = {direction.x, direction.y, direction.z};
  Nearing<DoubleDouble> nearing;
  for (int i = 0; i < search.most_iterations; ++i) {
    ++cost.iterations;
    const DifferenceVertexOf<DoubleDouble> w = search.probe(cost);
    if (dot(search.direction, w.at) < 0 && propose_apart_along_perpendicular(search.simplex, w.a, w.b, holds)) {
      return true;
    }
    if (!search.gains_by(w) || !search.step_to(w) || !nearing.goes_on(search.distance2)) break;
  }
  return propose_meet(a, b, search.simplex, holds);
}

// In doubles, then in double-doubles; from search.direction on, which is not zero.
template <class Holds>
bool propose_by_gjk(const Placed& a, const Placed& b, GjkSearch<double>& search, const Holds& holds, Cost& cost) {
  search.begin_at_the_top();
  return propose_in_doubles(a, b, search, holds, cost) ||
         propose_in_double_doubles(a, b, search.direction, holds, cost);
}

}  // namespace sunder::solid
