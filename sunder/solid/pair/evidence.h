// From what a search proposes to a certificate: each function checks a proposal exactly, and fills in the certificate
// where it holds. A proposal that does not hold proves nothing.
#pragma once

#include <sunder/certificate/pair.h>
#include <sunder/solid/pair/closest_simplex.h>
#include <sunder/solid/pair/extreme_vertex.h>

namespace sunder::solid {

// Does the direction (finite doubles, from A to B) part the bodies strictly? `near_a` and `near_b` are where to look
// first for the extreme vertices.
bool check_apart(const Placed& a, const Placed& b, const Point3& direction, std::uint32_t near_a, std::uint32_t near_b,
                 PairCertificate& certificate, StageTally& tally);

// Does a direction named by the features of the simplex part the bodies: a facet's normal, edge x edge, or the
// difference of two vertices, whichever its vertices allow? `towards` tells the sense.
bool check_apart_by_features(const Placed& a, const Placed& b, const DifferenceSimplex& simplex, const Point3& towards,
                             PairCertificate& certificate, StageTally& tally);

// Does the exact direction perpendicular to the simplex, a vertex, an edge or a triangle of the difference, part the
// bodies? `near_a` and `near_b` are where to look first for the extreme vertices. Allocates where it does.
bool check_apart_perpendicular(const Placed& a, const Placed& b, const DifferenceSimplexOf<DoubleDouble>& simplex,
                               std::uint32_t near_a, std::uint32_t near_b, PairCertificate& certificate,
                               StageTally& tally);

// Have the simplex's vertices of A and of B a common point? Picks at most five of them first (caratheodory.h).
template <class Real>
bool check_meet(const Placed& a, const Placed& b, const DifferenceSimplexOf<Real>& simplex,
                PairCertificate& certificate, StageTally& tally);

}  // namespace sunder::solid
