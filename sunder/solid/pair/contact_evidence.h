// What proves that two placed convex polyhedra touch, that they overlap, and how far apart they are (docs/claims.md,
// "pair", "distance"): directions and points as exact numbers, for certificate files. For the questions themselves see
// polyhedron_polyhedron_contact and polyhedron_polyhedron_distance.
#pragma once

#include <sunder/certificate/asked_pair.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/exact/exact_simplex.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>

#include <array>
#include <cstdint>

namespace sunder::solid {

// Two points that are nearest to each other, with positive denominators. Throws nothing, but for want of memory.
struct ClosestPoints {
  PointOf of_a, of_b;
};
ClosestPoints closest_points(const ClosestFeatures& closest);

// Two placed bodies, and which bodies of a certificate file they are.
struct ClaimedPair {
  std::uint32_t index_a, index_b;
  const ConvexPolyhedron& a;
  const Pose& pose_a;
  const ConvexPolyhedron& b;
  const Pose& pose_b;
};

// States what polyhedron_polyhedron's certificate says: that they are apart, or meet; where the contact is not none,
// that they touch, or overlap.
void add_claims(PairClaims& pairs, const ClaimedPair& pair, const PairCertificate& certificate, Relation contact);

// States how far apart they are; of bodies that meet, nothing.
void add_distance(PairClaims& pairs, const ClaimedPair& pair, const PolyhedronDistance& distance);

// States that they are `least` apart, or more; or else that they are nearer. Requires a positive finite `least`.
void add_clearance(PairClaims& pairs, const ClaimedPair& pair, const PolyhedronDistance& distance, double least);

}  // namespace sunder::solid

namespace sunder {

// Writes what polyhedron_polyhedron says of them as a certificate file, whole. Requires the answer to be about these.
void prove(const TextSink& sink, const AskedPair<solid::ConvexPolyhedron, solid::Pose>& asked,
           const PairAnswer& answer);

}  // namespace sunder
