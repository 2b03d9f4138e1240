// What the simplex that a search leaves, of vertices of the difference, is good for: proposals, one after another.
// Each is true where one of its proposals held.
#pragma once

#include <sunder/solid/search/caratheodory.h>

namespace sunder::solid {

// The simplex's vertices of A and of B have a common point: at most five of them (caratheodory.h).
template <class Real>
bool propose_meet(const Placed& a, const Placed& b, const DifferenceSimplexOf<Real>& simplex, const Holds& holds);

// The direction perpendicular to the simplex, a vertex, an edge or a triangle of the difference, parts the bodies;
// near_a and near_b are extreme along it. Nothing is proposed of other simplices.
template <class Real>
bool propose_apart_along_perpendicular(const DifferenceSimplexOf<Real>& simplex, std::uint32_t near_a,
                                       std::uint32_t near_b, const Holds& holds);

// A direction named by the features of the simplex parts the bodies: a facet's normal, edge x edge, or the difference
// of two vertices, whichever its vertices allow. `towards` tells the sense.
bool propose_apart_along_features(const DifferenceSimplex& given, const Point3& towards, const Holds& holds);

}  // namespace sunder::solid
