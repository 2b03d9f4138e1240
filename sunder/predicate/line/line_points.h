// Points on lines, each a vertex or the crossing of two lines, without computing them: how do they lie to lines and to
// each other? Exact, for every finite double.
// Also called: vertices of an arrangement of lines; indirect predicates.
#pragma once

#include <sunder/predicate/line/arrows.h>
#include <sunder/predicate/line/crossing.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <span>

namespace sunder {

struct LinePoint {
  Crossing lines;  // meaningless but for a, which is the point, where the enclosure is one point
  Enclosure2 in;

  bool is_double() const { return in.x.low == in.x.high && in.y.low == in.y.high; }
};

inline LinePoint line_point(const Point2& p) { return {{p, p, p, p}, {p.x, p.y}}; }

// Requires lines that are not parallel.
inline LinePoint line_point(const Crossing& lines) {
  LinePoint p{lines, enclosure(lines)};
  if (p.is_double()) p.lines.a = {p.in.x.low, p.in.y.low};
  return p;
}

ExactPoint2 exact_point(const LinePoint& p);

// By x: the sign of p - q. Cost: a comparison where enclosures are apart; else exact arithmetic.
Sign compare_x(const LinePoint& p, const LinePoint& q, StageTally* tally = nullptr);

// positive: p is to the left of the line from s to t; zero: it is on it.
Sign orient_2d(const Point2& s, const Point2& t, const LinePoint& p, StageTally* tally = nullptr);

// positive: p, q, r turn left. Cost: exact arithmetic where the enclosures do not tell.
Sign orient_2d(const LinePoint& p, const LinePoint& q, const LinePoint& r, StageTally* tally = nullptr);

// A half-plane: what is left of the arrow, moved so that it begins at a point. Requires from != to.
struct LeftOfMoved {
  Point2 at, from, to;
};

// Do two or three half-planes have no common point, and no fewer of them: is there a sum of positive multiples of their
// inequalities that says so? Cost: exact arithmetic.
bool have_no_common_point(std::span<const LeftOfMoved> half_planes);

// Is all of the box surely to the left of the line from s to t? False also means: not sure.
inline bool is_surely_left(const Point2& s, const Point2& t, const Enclosure2& box) {
  const double x = t.x - s.x, y = t.y - s.y;
  const double run = (y > 0 ? box.x.high : box.x.low) - s.x, rise = (x > 0 ? box.y.low : box.y.high) - s.y;
  return sign_of_products(x, rise, -y, run) == Guess::positive;
}

}  // namespace sunder
