// The boundary of a common part of discs, as seen from a point inside of all of them.
// Also called: lower envelope in polar coordinates.
//
// From there each circle is a function of direction, so the boundary of a common part is the least of them: pieces of
// circles. A chain of pieces begins in the direction of the x axis and goes once round. Two circles change places where
// they cross, at most twice: from a to b, counter-clockwise, at the crossing {a, b}.
//   A1. Each piece is seen under an angle greater than zero.
//   A2. Pieces that follow each other are of different discs; the first and the last one may be of one disc.
// Where functions are equal, that of the lowest disc serves.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/planar/region/discs_deepest.h>
#include <sunder/predicate/disc/disc_crossing.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

inline constexpr std::uint32_t no_disc = 0xffffffffu;

struct ArcPiece {
  std::uint32_t from = no_disc;  // the disc of the piece before; no_disc for the first piece
  std::uint32_t disc = 0;
  Bearing begin{0, 0};  // of the crossing {from, disc}; zero for the first piece
};

// The discs of a chain that goes once round, from some arc on: of two arcs or more, those next to each other differ.
std::vector<std::uint32_t> discs_around(std::span<const ArcPiece> chain);

class ArcChains {
 public:
  // Keeps a reference to the circles. Requires that the viewpoint is inside of all discs that it is asked about.
  ArcChains(std::span<const Disc> circles, Viewpoint from) : circles_(circles), from_(std::move(from)) {}

  // The chain of the common part of these discs, one at least. Cost: O(n log n) probes.
  std::vector<ArcPiece> divide(std::span<const std::uint32_t> discs);

  // The common part of both. Cost: as many probes as there are pieces in all, at most.
  void merge(std::span<const ArcPiece> p, std::span<const ArcPiece> q, std::vector<ArcPiece>& out);

  // A box that holds the common part that the chain bounds.
  Enclosure2 box(std::span<const ArcPiece> chain) const;

  // probes: sectors of directions in which two circles were compared.
  Cost cost() const { return {probes_, 0, tally_.exact}; }

 private:
  // A direction: of the crossing at which a piece begins, or of the x axis.
  struct Direction {
    std::uint32_t from, to;
    Bearing bearing;
  };
  DiscCrossing crossing(const Direction& d) const { return {circles_[d.from], circles_[d.to]}; }
  Direction toward(std::uint32_t from, std::uint32_t to);
  Sign compare(const Direction& a, const Direction& b);
  void compare_in_sector(std::uint32_t a, std::uint32_t b, const Direction& begin, const ArcPiece* end,
                         std::vector<ArcPiece>& out);

  std::span<const Disc> circles_;
  Viewpoint from_;
  std::uint64_t probes_ = 0;
  std::size_t start_ = 0;  // where the chain that is being merged begins
  StageTally tally_;
};

}  // namespace sunder::planar
