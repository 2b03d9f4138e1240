// Writes how deep two convex bodies are in each other into a certificate file (docs/claims.md, "depth"): statements
// `depth`. Each requires that the two stand in the table `bodies`, and that PairClaims (pair_claims.h) has written a
// statement to the file before: that they meet, say.
// None throws, but for want of memory, or what the writer's sink throws.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/certificate/pair.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/number/interval.h>
#include <sunder/predicate/point/along.h>

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace sunder {

// A closed surface around the origin. Corner k is the difference of point corners[k][0] of a body A and corners[k][1]
// of a body B; triangles are of corners, counterclockwise from outside; each edge is there once in each direction.
struct DepthSurface {
  std::vector<std::array<std::uint32_t, 2>> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  // The points that corners name of a cylinder, cone or ellipsoid; of hulls, whose vertices they name, none.
  std::vector<PointOf> of_a{}, of_b{};
};

// A point of each body, of hulls of its core.
struct DepthPoints {
  PointOf of_a, of_b;
  bool a_is_curved = false, b_is_curved = false;  // a cylinder, cone or ellipsoid
};

// That bodies are at least so deep: of 0 nothing proves it but that they meet.
using DepthProof = std::variant<std::monostate, DepthSurface, DepthPoints>;

// How deep two bodies that meet are in each other.
struct EnclosedDepth {
  static constexpr Verdict verdict = Verdict::meet;
  Interval depth;            // beyond the range of doubles: the largest, and infinity
  WorldDirection direction;  // from A to B: A, moved back along it by depth.high, does not overlap B
  DepthProof proof_of_low;   // that it is at least depth.low
};

// States both ends: that the depth is at most `high`, and at least `low`. Left out is the first where it is not finite,
// the second where it is 0.
void add_depth(ClaimsWriter& file, std::uint32_t a, std::uint32_t b, const EnclosedDepth& found);

// That A, moved back by `most` along the direction, which is from A to B and has as many numbers as there are
// dimensions, does not overlap B. Requires a finite most >= 0.
void add_depth_at_most(ClaimsWriter& file, std::uint32_t a, std::uint32_t b, double most,
                       std::span<const Dyadic> direction);

// That A, moved anyhow by `least` or less, meets B: as the surface shows; as the points do, which are no further apart
// than the radii of the hulls exceed `least`. Requires a finite least > 0.
void add_depth_at_least(ClaimsWriter& file, std::uint32_t a, std::uint32_t b, double least,
                        const DepthSurface& surface);
void add_depth_at_least(ClaimsWriter& file, std::uint32_t a, std::uint32_t b, double least, const DepthPoints& points);

// The same in the plane, of hulls: corners are as those of a DepthSurface, edges of corners counterclockwise around the
// origin, and each corner is the start of one and the end of one.
void add_depth_at_least(ClaimsWriter& file, std::uint32_t a, std::uint32_t b, double least,
                        std::span<const std::array<std::uint32_t, 2>> corners,
                        std::span<const std::array<std::uint32_t, 2>> edges);

}  // namespace sunder
