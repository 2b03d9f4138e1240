// Evidence in rounded numbers, for people and pictures. Nothing is decided by them.
#pragma once

#include <sunder/certificate/direction.h>
#include <sunder/certificate/pair.h>
#include <sunder/scene/scene.h>
#include <sunder/solid/round/round_round.h>

namespace sunder::scene {

// The common point of a `meet`, each coordinate within a few units in the last place (infinite beyond doubles).
// Requires a true certificate of that verdict.
Point3 rounded_common_point(const PairCertificate& certificate, const PlacedVertices& a, const PlacedVertices& b);

// Of a pair of parts that meets, whatever their shapes.
Point3 rounded_common_point(const PartPair& pair, const Part& a, const Part& b);

// What an `apart` shows.
struct RoundedGap {
  Point3 direction;  // from A to B, of length one up to rounding
  double width = 0;  // of the empty slab across the direction: the bodies are no closer than this. Positive, and
                     // rounded (0 where it is below the least double).
};

// Requires a true certificate of that verdict.
RoundedGap rounded_gap(const PairCertificate& certificate, const PlacedVertices& a, const PlacedVertices& b);

// Of bodies with a radius that are apart or undecided: the direction, of length one up to rounding.
Point3 rounded_direction(const solid::RoundEvidence& evidence);

// Of bodies with a radius. Requires true evidence of that verdict.
RoundedGap rounded_gap(const solid::RoundEvidence& evidence, const solid::PlacedRound& a, const solid::PlacedRound& b);

}  // namespace sunder::scene
