// What proves that two placed convex polygons touch, that they overlap, and how far apart they are (docs/claims.md,
// "pair", "distance"): directions and points as exact numbers, for certificate files. For the questions themselves see
// polygon_polygon.h and polygon_polygon_distance.h.
//
// None throws, but for want of memory. Cost: exact arithmetic on a few vertices; overlapping_point that of
// polygon_polygon_intersection besides.
#pragma once

#include <sunder/certificate/asked_pair.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>
#include <sunder/planar/pair/exact_image.h>
#include <sunder/planar/pair/polygon_polygon_distance.h>
#include <sunder/predicate/line/crossing.h>

#include <array>
#include <cstdint>

namespace sunder::planar {

// Two placed polygons, and which bodies of a certificate file they are.
struct ClaimedPair {
  std::uint32_t index_a, index_b;
  const ConvexPolygon& a;
  const Pose& pose_a;
  const ConvexPolygon& b;
  const Pose& pose_b;
};

// States what polygon_polygon's certificate says: that they are apart, or meet; where the contact is not none, that
// they touch, or overlap.
void add_claims(PairClaims& pairs, const ClaimedPair& pair, const PairCertificate& certificate, Relation contact);

// States how far apart they are; of polygons that meet, nothing.
void add_distance(PairClaims& pairs, const ClaimedPair& pair, const PolygonDistance& distance);

// States that they are `least` apart, or more; or else that they are nearer. Requires a positive finite `least`.
void add_clearance(PairClaims& pairs, const ClaimedPair& pair, const PolygonDistance& distance, double least);

// A direction along which no point of A is further than any of B, and not all of both are as far: so the relative
// interiors have no common point. Requires polygon_polygon_contact to be touching, and `meet` a certificate of
// polygon_polygon's.
// Why there is one that is easily found: the directions along which A ends and B begins at a common point p are those
// outward of A at p and inward of B. Outward of A is a cone, spanned by the normals of the edges at p; for an end of a
// segment also by the way out of it. Where the cones of both meet, and neither is all of the plane, an edge of one of
// them is in the other; and if all common directions but one have all of both on one line, that one is an edge, too.
std::array<Dyadic, 3> touching_direction(const ConvexPolygon& a, const Pose& pose_a,  //
                                         const ConvexPolygon& b, const Pose& pose_b, const CommonVertices& meet);

// A point of both relative interiors, with how they make it. Requires the contact to be overlapping. It is the mean of
// corners of the common part; rounded, where that still is inside both.
CommonPoint overlapping_point(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b, const Pose& pose_b);

// Two points that are nearest to each other, with positive denominators. Requires the closest features of these
// polygons.
struct ClosestPoints {
  PointOf of_a, of_b;
};
ClosestPoints closest_points(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b, const Pose& pose_b,
                             const ClosestFeatures& closest);

// How a point of the relative interior is made of at most six vertices, all with positive weights, which span all that
// the polygon spans. Requires such a point, with a positive denominator.
Combination inner_combination(const ConvexPolygon& polygon, const Pose& pose, const ExactPoint2& point);

// The exact image of the mean of up to three vertices that span all that the polygon spans.
ExactPoint2 exact_middle(const ConvexPolygon& polygon, const Pose& pose);

// From vertex v to the next one: a quarter turn to the outside from there. Of a segment: to its right.
std::array<Dyadic, 2> outward_normal(const ConvexPolygon& polygon, const Pose& pose, std::uint32_t v);

}  // namespace sunder::planar

namespace sunder {

// Writes what polygon_polygon says of them as a certificate file, whole. Requires the answer to be about these.
void prove(const TextSink& sink, const AskedPair<planar::ConvexPolygon, planar::Pose>& asked, const PairAnswer& answer);

}  // namespace sunder
