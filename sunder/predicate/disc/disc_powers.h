// Where the greatest power of discs is least: signs about the point of least power of one, two or three discs. Exact,
// for every finite double.
// Also called: power distance; radical axis, radical centre; power diagram.
//
// The power of a disc at a point p is |p - center|^2 - radius^2: negative inside, zero on the circle. The deepest point
// of up to three discs is that of least power among the points where their powers are equal:
//   of one disc its centre;
//   of two the point where the line of their centres crosses their radical axis;
//   of three their radical centre.
// It has rational coordinates. Requires different centres of two; of three, that the centres are not on one line.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/rounded.h>
#include <sunder/predicate/disc/disc.h>
#include <sunder/predicate/disc/disc_crossing.h>
#include <sunder/predicate/line/crossing.h>
#include <sunder/predicate/posed.h>

#include <array>
#include <cstdint>
#include <span>

namespace sunder {

// At the deepest point of the discs `basis` (one to three): the power of k minus theirs.
Sign power_against(std::span<const Disc> basis, const Disc& k, StageTally* tally = nullptr);

// Their power there: negative: the point is inside of them all; zero: on their circles; positive: outside.
Sign deepest_power(std::span<const Disc> basis, StageTally* tally = nullptr);

// The deepest point; and its weights: numerators over one positive denominator, of sum one, so that it is the sum of
// the weights times the centres. With weights w of at least zero, sum w (|c|^2 - r^2) - |sum w c|^2 is that power,
// which no point's greatest power is less than.
ExactPoint2 deepest_point(std::span<const Disc> basis);
struct DeepestWeights {
  std::array<Dyadic, 3> numerators;  // zero beyond the basis
  Dyadic denominator;
};
DeepestWeights deepest_weights(std::span<const Disc> basis);

// The power of k at a point p of doubles.
Sign power_at(const Point2& p, const Disc& k, StageTally* tally = nullptr);

// The same at a point of exact numbers. Cost: exact arithmetic.
Sign power_at(const Viewpoint& p, const Disc& k);

// The deepest point, both coordinates cut to multiples of one power of two, so that the larger one has about this many
// bits. Cost: exact arithmetic.
Viewpoint deepest_viewpoint(std::span<const Disc> basis, std::uint32_t bits);

// A box, and a number: which discs surely have a power less than that at every point of the box? The first stage of the
// questions above where they are asked of many discs.
struct PowerBound {
  Enclosure2 box;
  double power = 0;
};

// For the deepest point of a basis and the basis' power there. (For a box that a disc is to hold: power zero.)
PowerBound power_bound(std::span<const Disc> basis);

// False also means: not sure. The formula is a Rounded<5> of the distances, which are rounded up first; another
// rounding is that of the sum with the error. Underflow is off by at most 2^-1073; overflow makes the comparison false.
inline bool is_surely_less(const Disc& k, const PowerBound& bound) {
  const auto furthest = [](double c, const Interval& in) { return std::max(in.high - c, c - in.low) * (1 + 0x1p-50); };
  const double x = furthest(k.center.x, bound.box.x), y = furthest(k.center.y, bound.box.y);
  const double distance = x * x + y * y, square = k.radius * k.radius;
  return (distance - square) + (Rounded<6>::bound * (distance + square) + 0x1p-1060) < bound.power;
}

}  // namespace sunder
