#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/line/line_points.h>
#include <sunder/predicate/point/orient.h>

namespace sunder {

namespace {

bool is_same(const Crossing& p, const Crossing& q) { return p.a == q.a && p.b == q.b && p.c == q.c && p.d == q.d; }

// A degree more than of the crossings: of points as x / denominator, the determinant of three.
Dyadic minor(const Dyadic& a, const Dyadic& b, const Dyadic& c, const Dyadic& d) { return a * d - b * c; }

struct ExactEdge {
  Vector2<Dyadic> at, arrow;
};
ExactEdge exact(const LeftOfMoved& h) {
  return {lift<ExactStage>(h.at), lift<ExactStage>(h.to) - lift<ExactStage>(h.from)};
}

}  // namespace

// With arrow d, the half-plane is d x p >= d x at. Multiples m with sum m d = 0 and sum m (d x at) > 0 contradict.
bool have_no_common_point(std::span<const LeftOfMoved> half_planes) {
  if (half_planes.size() == 2) {
    const ExactEdge a = exact(half_planes[0]), b = exact(half_planes[1]);
    if (cross(a.arrow, b.arrow).sign() != Sign::zero || dot(a.arrow, b.arrow).sign() != Sign::negative) return false;
    return cross(a.arrow, b.at - a.at).sign() == Sign::negative;
  }
  if (half_planes.size() != 3) return false;
  const ExactEdge a = exact(half_planes[0]), b = exact(half_planes[1]), c = exact(half_planes[2]);
  const Dyadic of_a = cross(b.arrow, c.arrow), of_b = cross(c.arrow, a.arrow), of_c = cross(a.arrow, b.arrow);
  if (of_a.sign() != of_b.sign() || of_b.sign() != of_c.sign() || of_a.sign() == Sign::zero) return false;
  const Dyadic sum = of_a * cross(a.arrow, a.at) + of_b * cross(b.arrow, b.at) + of_c * cross(c.arrow, c.at);
  return sum.sign() == of_a.sign();
}

ExactPoint2 exact_point(const LinePoint& p) {
  if (p.is_double()) return {p.in.x.low, p.in.y.low, Dyadic(1)};
  return exact_point(p.lines);
}

Sign compare_x(const LinePoint& p, const LinePoint& q, StageTally* tally) {
  if (p.in.x.low > q.in.x.high) return counted(&StageTally::interval, tally, Sign::positive);
  if (p.in.x.high < q.in.x.low) return counted(&StageTally::interval, tally, Sign::negative);
  if (p.is_double() && q.is_double()) return sign_of(p.in.x.low - q.in.x.low);
  if (!p.is_double() && !q.is_double() && is_same(p.lines, q.lines)) return Sign::zero;
  const ExactPoint2 e = exact_point(p), f = exact_point(q);
  return counted(&StageTally::exact, tally, (e.x * f.denominator - f.x * e.denominator).sign());
}

Sign orient_2d(const Point2& s, const Point2& t, const LinePoint& p, StageTally* tally) {
  if (p.is_double()) return orient_2d(s, t, Point2{p.in.x.low, p.in.y.low}, tally);
  return orient_2d(s, t, p.lines, p.in, tally);
}

Sign orient_2d(const LinePoint& p, const LinePoint& q, const LinePoint& r, StageTally* tally) {
  const Guess guess = sign((q.in.x - p.in.x) * (r.in.y - p.in.y) - (q.in.y - p.in.y) * (r.in.x - p.in.x));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  const ExactPoint2 a = exact_point(p), b = exact_point(q), c = exact_point(r);
  const Dyadic sum = a.x * minor(b.y, b.denominator, c.y, c.denominator) -
                     a.y * minor(b.x, b.denominator, c.x, c.denominator) + a.denominator * minor(b.x, b.y, c.x, c.y);
  return counted(&StageTally::exact, tally, sum.sign());
}

}  // namespace sunder
