// Seen from the centre of a, with d that of b and d' = d turned left by a right angle, the crossing is
// (E d + sqrt(W) d') / (2 |d|^2), where E is the lead of b and W the crossing area (see disc_stages.h).
#include <sunder/predicate/disc/disc_crossing.h>
#include <sunder/predicate/disc/disc_stages.h>
#include <sunder/predicate/disc/discs.h>
#include <sunder/predicate/filter/radicals.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace sunder {

namespace {

constexpr auto side_of_disc_formula = [](const auto& a, const auto& b, const auto& k) {
  const auto d = center_from(a, b);
  const auto e = center_from(a, k);
  return sign_with_root(lead(a, b) * dot(d, e) - dot(d, d) * lead(a, k), cross(d, e), crossing_area(a, b));
};

// With w from s to t, times 2 |d|^2: w x (2 |d|^2 (c_a - s) + E d + sqrt(W) d'), where w x d' is w d.
constexpr auto orient_formula = [](const auto& s, const auto& t, const auto& a, const auto& b) {
  const auto d = center_from(a, b);
  const auto w = center_from(s, t);
  const auto whole = dot(d, d) * cross(w, center_from(s, a));
  return sign_with_root((whole + whole) + lead(a, b) * cross(w, d), dot(w, d), crossing_area(a, b));
};

// From the centre of a.
Enclosure2 from_center(const Disc& a, const Disc& b) {
  const auto i = lift<IntervalStage>(a), k = lift<IntervalStage>(b);
  const auto d = center_from(i, k);
  const Interval half = Interval(0.5) / dot(d, d);
  const Interval along = lead(i, k) * half, across = square_root(crossing_area(i, k)) * half;
  return {along * d.x - across * d.y, along * d.y + across * d.x};
}

// Coordinates from a viewpoint, times 2 |d|^2, as (x + x_root sqrt(area), y + y_root sqrt(area)).
struct Seen {
  Dyadic x, x_root, y, y_root, area;
};
Seen seen(const DiscCrossing& p, const Viewpoint& from) {
  const auto i = lift<ExactStage>(p.a), k = lift<ExactStage>(p.b);
  const auto d = center_from(i, k);
  const Dyadic at_b = lead(i, k), twice = Dyadic(2) * dot(d, d);
  return {twice * (i.x - from.x) + at_b * d.x, -d.y, twice * (i.y - from.y) + at_b * d.y, d.x, crossing_area(i, k)};
}

Sign sign_of_x(const Seen& s) { return to_sign(sign_with_root(s.x, s.x_root, s.area)); }
Sign sign_of_y(const Seen& s) { return to_sign(sign_with_root(s.y, s.y_root, s.area)); }

// The double nearest to a number, by halving the doubles between two that hold it between them. against(t): the sign of
// the number minus t.
template <class Against>
double nearest_by_halving(const Interval& in, const Against& against) {
  constexpr double largest = std::numeric_limits<double>::max();
  // Doubles in order, as whole numbers.
  const auto rank = [](double x) {
    const auto bits = std::bit_cast<std::int64_t>(x);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
  };
  const auto at = [](std::int64_t r) {
    return std::bit_cast<double>(r < 0 ? std::numeric_limits<std::int64_t>::min() - r : r);
  };
  std::int64_t low = rank(std::clamp(in.low, -largest, largest)), high = rank(std::clamp(in.high, -largest, largest));
  // Half a unit beyond the largest double, numbers are infinite.
  const Dyadic beyond = Dyadic(largest) + Dyadic(0x1p970);
  if (against(Dyadic(at(high))) == Sign::positive) return against(beyond) == Sign::negative ? largest : HUGE_VAL;
  if (against(Dyadic(at(low))) == Sign::negative) return against(-beyond) == Sign::positive ? -largest : -HUGE_VAL;
  const auto between = [&] { return static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low); };
  while (between() > 1) {
    const std::int64_t middle = low + static_cast<std::int64_t>(between() / 2);
    (against(Dyadic(at(middle))) == Sign::negative ? high : low) = middle;
  }
  const Sign side = against((Dyadic(at(low)) + Dyadic(at(high))) * Dyadic(0.5));
  return at(side == Sign::negative || (side == Sign::zero && low % 2 == 0) ? low : high);
}

// Is the angle at least a half turn?
bool is_lower_half(const Seen& s) {
  const Sign y = sign_of_y(s);
  return y == Sign::negative || (y == Sign::zero && sign_of_x(s) == Sign::negative);
}

// The measure within a half turn of (x, y), y > 0, from t = x / y; it falls as t grows. Three roundings, of results of
// at most two: off by less than 2^-50.
double within_half_turn(double t) { return t >= 0 ? 1 / (1 + t) : 1 + 1 / (1 - 1 / t); }

// The measure of (1, s), s >= 0, and its distance to 2 for (-1, s).
double within_quarter_turn(double s) { return std::isinf(s) ? 1 : s / (1 + s); }

Bearing widened(double low, double high) { return {std::max(low - 0x1p-50, 0.0), std::min(high + 0x1p-50, 4.0)}; }

}  // namespace

Enclosure2 enclosure(const DiscCrossing& p) {
  const Enclosure2 q = from_center(p.a, p.b);
  return {q.x + p.a.center.x, q.y + p.a.center.y};
}

Point2 nearest(const DiscCrossing& p) {
  const auto i = lift<ExactStage>(p.a), k = lift<ExactStage>(p.b);
  const auto d = center_from(i, k);
  const Dyadic twice = Dyadic(2) * dot(d, d), at_b = lead(i, k), area = crossing_area(i, k);
  const Enclosure2 in = enclosure(p);
  const auto x_against = [&](const Dyadic& t) {
    return to_sign(sign_with_root(at_b * d.x - twice * (t - i.x), -d.y, area));
  };
  const auto y_against = [&](const Dyadic& t) {
    return to_sign(sign_with_root(at_b * d.y - twice * (t - i.y), d.x, area));
  };
  return {nearest_by_halving(in.x, x_against), nearest_by_halving(in.y, y_against)};
}

Sign side_of_disc(const DiscCrossing& p, const Disc& k, StageTally* tally) {
  return decide_discs(tally, side_of_disc_formula, p.a, p.b, k);
}

Sign orient_2d(const Point2& s, const Point2& t, const DiscCrossing& p, StageTally* tally) {
  return decide_discs(tally, orient_formula, Disc{s, 0}, Disc{t, 0}, p.a, p.b);
}

bool circles_cross(const Disc& a, const Disc& b, StageTally* tally) {
  return distance_against_sum(a.center, a.radius, b.center, b.radius, tally) == Sign::negative &&
         distance_against_difference(a.center, a.radius, b.center, b.radius, tally) == Sign::positive;
}

Viewpoint viewpoint(const Point2& p) { return {p.x, p.y, {p.x, p.y}}; }

Bearing bearing(const DiscCrossing& p, const Viewpoint& from, StageTally* tally) {
  const Enclosure2 q = from_center(p.a, p.b);
  const Interval x = q.x + (Interval(p.a.center.x) - from.in.x);
  Interval y = q.y + (Interval(p.a.center.y) - from.in.y);
  if (y.low > 0 || y.high < 0) {
    const Interval t = x / y;
    const double base = y.low > 0 ? 0 : 2;
    return widened(base + within_half_turn(t.high), base + within_half_turn(t.low));
  }
  if (x.high < 0) {
    const Interval s = y / -x;
    return widened(2 - within_quarter_turn(std::max(s.high, 0.0)), 2 + within_quarter_turn(std::max(-s.low, 0.0)));
  }
  // The measure may be near 0 or near 4.
  const bool lower = is_lower_half(seen(p, from));
  if (tally) ++tally->exact;
  if (!(x.low > 0)) return lower ? Bearing{2, 4} : Bearing{0, 2};
  const Interval s = y / x;
  return lower ? widened(4 - within_quarter_turn(std::max(-s.low, 0.0)), 4)
               : widened(0, within_quarter_turn(std::max(s.high, 0.0)));
}

Sign compare_bearings(const DiscCrossing& p, const Bearing& p_in, const DiscCrossing& q, const Bearing& q_in,
                      const Viewpoint& from, StageTally* tally) {
  if (p_in.low > q_in.high) return counted(&StageTally::interval, tally, Sign::positive);
  if (p_in.high < q_in.low) return counted(&StageTally::interval, tally, Sign::negative);
  if (p.a == q.a && p.b == q.b) return Sign::zero;
  if (tally) ++tally->exact;
  const Seen v = seen(p, from), w = seen(q, from);
  const bool v_lower = is_lower_half(v), w_lower = is_lower_half(w);
  if (v_lower != w_lower) return v_lower ? Sign::positive : Sign::negative;
  // w x v, positive where v is further on.
  const auto minor = [](const Dyadic& a, const Dyadic& b, const Dyadic& c, const Dyadic& d) { return a * d - b * c; };
  return to_sign(sign_with_roots(minor(w.x, w.y, v.x, v.y), minor(w.x_root, w.y_root, v.x, v.y),
                                 minor(w.x, w.y, v.x_root, v.y_root), minor(w.x_root, w.y_root, v.x_root, v.y_root),
                                 w.area, v.area));
}

bool is_bearing_zero(const DiscCrossing& p, const Bearing& p_in, const Viewpoint& from, StageTally* tally) {
  if (p_in.low > 0) return false;
  if (tally) ++tally->exact;
  const Seen v = seen(p, from);
  return sign_of_y(v) == Sign::zero && sign_of_x(v) == Sign::positive;
}

}  // namespace sunder
