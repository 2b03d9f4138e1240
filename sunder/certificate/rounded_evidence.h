// Evidence in rounded numbers, for people and pictures. Nothing is decided by them.
#pragma once

#include <sunder/certificate/direction.h>
#include <sunder/certificate/pair.h>

namespace sunder {

// The common point of a `meet`, each coordinate within a few units in the last place (infinite beyond doubles).
// Requires true evidence.
Point3 rounded_common_point(const CommonVertices& evidence, const PlacedVertices& a, const PlacedVertices& b);

// What an `apart` shows.
struct RoundedGap {
  Point3 direction;  // from A to B, of length one up to rounding
  double width = 0;  // of the empty slab across the direction: the bodies are no closer than this. Positive, and
                     // rounded (0 where it is below the least double).
};

// Requires true evidence.
RoundedGap rounded_gap(const Separation& evidence, const PlacedVertices& a, const PlacedVertices& b);

}  // namespace sunder
