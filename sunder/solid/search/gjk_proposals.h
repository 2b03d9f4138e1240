// The proposals of Gilbert, Johnson and Keerthi's search, wherever it begins. See docs/design/solid-pair.md.
// Each is true where a proposal held.
#pragma once

#include <sunder/solid/search/graph_support.h>
#include <sunder/solid/search/simplex_proposals.h>
#include <sunder/solid/search/tilt_direction.h>

#include <type_traits>

namespace sunder::solid {

// Where the search's direction seems to part the bodies, w being furthest along it: a direction in doubles; in
// double-doubles, for gaps in the last bits, the perpendicular of the simplex.
template <class Real, class Support>
bool propose_apart(const Gjk<Real, Support>& search, const DifferenceVertexOf<Real>& w, const Holds& holds) {
  if (!(search.gap_at(w) > Real(0))) return false;
  if constexpr (std::is_same_v<Real, double>) {
    DifferenceVertex furthest = w;
    Point3 direction = search.direction;
    return tilt_direction(search.simplex, direction, furthest) && holds(apart_along(direction, furthest.a, furthest.b));
  } else {
    return propose_apart_along_perpendicular(search.simplex, w.a, w.b, holds);
  }
}

// From the search's direction on.
template <class Real>
bool propose_by_search(const Placed& a, const Placed& b, GjkSearch<Real>& search, const Holds& holds, Cost& cost) {
  const auto parts = [&](const auto& w) { return propose_apart(search, w, holds); };
  if (search.run({}, cost, parts) == GjkEnd::stopped) return true;
  return propose_meet(a, b, search.simplex, holds);
}

// In doubles, then in double-doubles.
inline bool propose_by_gjk(const Placed& a, const Placed& b, const Holds& holds, Cost& cost) {
  GjkSearch<double> search(a, b);
  search.begin({});
  search.support.begin_at_the_top();
  if (propose_by_search(a, b, search, holds, cost) ||
      propose_apart_along_features(search.simplex, search.direction, holds)) {
    return true;
  }
  GjkSearch<DoubleDouble> finer(a, b);
  const Point3& d = search.direction;
  finer.direction = {d.x, d.y, d.z};
  return propose_by_search(a, b, finer, holds, cost);
}

}  // namespace sunder::solid
