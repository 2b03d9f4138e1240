// Which point is deepest in N closed discs: where is the greatest of their powers least?
// Also called: centre of least greatest power; where radii are equal, smallest enclosing circle (minimax centre).
//
// The power of a disc at p is |p - center|^2 - radius^2. There is one deepest point, and its sign tells what the common
// part of the discs is: negative: it has an inside, and the point is inside of all; zero: it is that point; positive:
// it is empty.
//   D1. The point is named by at most three discs: it is their deepest point (predicate/disc/disc_powers.h), exactly.
//   D2. At that point no disc has a greater power than these; and theirs are equal.
//   D3. The weights of the point (deepest_weights) are positive. So the named discs alone prove an empty common part:
//       sum w (|c|^2 - r^2) - |sum w c|^2 > 0.
//   D4. The answer does not depend on the compiler. Which discs name the point where several sets do is not said.
// All is rational: no roots are taken. None throws, but for want of memory.
// Source: a program linear in the lifted plane but for one square; Seidel 1991 for its order of work, Welzl 1991 for
// smallest circles, which it is where radii are equal. Shamos & Hoey 1976 ask for the common part only (Theorem 13).
#pragma once

#include <sunder/base/cost.h>
#include <sunder/number/sign.h>
#include <sunder/planar/object/discs.h>
#include <sunder/predicate/disc/disc.h>

#include <array>
#include <cstdint>
#include <span>

namespace sunder::planar {

struct DeepestPoint {
  std::array<std::uint32_t, 3> discs{};
  std::uint32_t count = 0;  // of the discs that name the point: 1 to 3
  Sign power = Sign::zero;  // at the point

  std::span<const std::uint32_t> basis() const& { return {discs.data(), count}; }
};

struct [[nodiscard]] DiscsDeepest {
  DeepestPoint point;
  Cost cost;  // probes: discs compared with the power of others
};

// Those discs themselves, for predicate/disc/disc_powers.h.
struct DiscBasis {
  std::array<Disc, 3> discs;
  std::uint32_t count = 0;
  operator std::span<const Disc>() const& { return {discs.data(), count}; }
};
DiscBasis discs_of(std::span<const Disc> circles, std::span<const std::uint32_t> basis);

// Requires one circle at least. Floating point proposes the discs, going from one to the disc of greatest power at
// their point; exact signs compare all others, and where one is beyond, it is taken in, and all are compared again.
// Where that goes on for long, by order. Cost: expected O(N) probes.
DiscsDeepest discs_deepest(std::span<const Disc> circles);

// Disc after disc in random order, each that is beyond starting a search among those before it: expected O(N) probes.
DiscsDeepest discs_deepest_by_order(std::span<const Disc> circles);

}  // namespace sunder::planar
