// The extreme rays of a cone that is given by half-spaces through the origin, with the half-spaces that each is on: the
// double description method. For degenerate cones, of which many half-spaces meet in a ray: there it makes rays alone,
// and no simplices.
// Also called: Chernikova's algorithm; vertex and facet enumeration.
#pragma once

#include <sunder/number/integer_internal.h>
#include <sunder/polytope/hull/bits.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sunder::polytope {

// D1. rays: the extreme rays of the cone, each once, of `width` integers without a common factor.
// D2. on[k]: the half-spaces whose boundary holds ray k.
// D3. next[k]: the rays that have a face of two dimensions in common with ray k.
struct ConeRays {
  bool has_lines = false;  // the cone holds a line: the rest is empty
  std::vector<std::vector<Integer>> rays;
  std::vector<Bits> on;
  std::vector<std::vector<std::uint32_t>> next;
  std::uint64_t signs = 0;  // of a ray and a half-space
  std::uint64_t looks = 0;  // at what half-spaces two rays have in common
};

enum class IntegerKind : std::uint8_t { words, any };

// The cone of all x with h x >= 0 for all rows h, of `width` numbers each, 2 to 7. Nothing where integers of one word
// are too short, or where the method gives up: hulls in floating point (full_hull.h) are faster about cones that are
// large, and not degenerate. All work beyond a fixed amount must be paid for by rays that were found to be on the
// boundary of a further half-space.
// Cost: a sign for each ray and half-space, and a look at each two rays that are on the boundary of a new one.
// Source: Motzkin, Raiffa, Thompson & Thrall 1953; Fukuda & Prodon 1996, who tell neighbours by the half-spaces that
// they have in common. Departure: neighbours are kept, so that only rays on one boundary are compared.
std::optional<ConeRays> double_description(std::size_t width, std::span<const Dyadic> rows, IntegerKind kind);

}  // namespace sunder::polytope
