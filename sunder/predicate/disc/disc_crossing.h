// The points in which two circles cross, without computing them: predicates decide about the exact points.
// Also called: intersection points of circles; vertices of an arrangement of circles.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/interval.h>
#include <sunder/predicate/disc/disc.h>
#include <sunder/predicate/line/crossing.h>
#include <sunder/predicate/posed.h>

namespace sunder {

// Where the boundary of the common part of discs a and b, counter-clockwise, leaves the circle of a for that of b: the
// common point of the circles to the left of the way from a's centre to b's. The other one is {b, a}. Requires that the
// circles have a common point and different centres; where they touch, the two are one point.
struct DiscCrossing {
  Disc a, b;
};

// Holds its coordinates; the whole line where floating point can tell nothing.
Enclosure2 enclosure(const DiscCrossing& p);

// The nearest doubles to its coordinates, ties to even; infinite beyond the range. Cost: exact arithmetic.
Point2 nearest(const DiscCrossing& p);

// positive: the point is inside of disc k; zero: on its circle; negative: outside.
// Formula: with d, e the centres of b, k from that of a, and E, F the leads (predicate/disc/disc_stages.h) of b, k:
// E d e + sqrt(W) d x e - |d|^2 F, where W is the crossing area. One root: no roots are mixed.
Sign side_of_disc(const DiscCrossing& p, const Disc& k, StageTally* tally = nullptr);

// As orient_2d of s, t and p: positive where p is left of the line from s to t. So {a, b} is left of the way from a's
// centre to b's, and {b, a} right of it.
Sign orient_2d(const Point2& s, const Point2& t, const DiscCrossing& p, StageTally* tally = nullptr);

// Where the circles of two discs cross in two points, decided exactly.
bool circles_cross(const Disc& a, const Disc& b, StageTally* tally = nullptr);

// A point to look from.
struct Viewpoint {
  Dyadic x, y;
  Enclosure2 in;
};
Viewpoint viewpoint(const Point2& p);

// In which direction a crossing is seen. The measure rises with the angle from the x axis, counter-clockwise, from 0 to
// 4, a quarter turn being 1: the bearing of (x, y) is y / (x + y) in the first quarter.
struct Bearing {
  double low = 0, high = 4;
};
Bearing bearing(const DiscCrossing& p, const Viewpoint& from, StageTally* tally = nullptr);

// The order of the angles of two crossings seen from a point, both in [0, 2 pi). `p_in` and `q_in` are their bearings.
// Requires that the point is neither of the two. Cost: comparisons where the bearings are apart; else exact arithmetic.
Sign compare_bearings(const DiscCrossing& p, const Bearing& p_in, const DiscCrossing& q, const Bearing& q_in,
                      const Viewpoint& from, StageTally* tally = nullptr);

// Is the crossing exactly in the direction of the x axis? Requires as above.
bool is_bearing_zero(const DiscCrossing& p, const Bearing& p_in, const Viewpoint& from, StageTally* tally = nullptr);

}  // namespace sunder
