#include <sunder/planar/pair/segment_segment.h>
#include <sunder/predicate/orient.h>

#include <algorithm>

namespace sunder::planar {

namespace {

bool boxes_are_apart(const Segment& s, const Segment& t) {
  const auto apart = [](double a, double b, double c, double d) {
    return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
  };
  return s.b.x < t.a.x || t.b.x < s.a.x || apart(s.a.y, s.b.y, t.a.y, t.b.y);
}

bool is_end_of(const Point2& p, const Segment& s) { return p == s.a || p == s.b; }

// Of two segments on one line, or points on it.
ContactKind on_one_line(const Segment& s, const Segment& t) {
  const Point2 first = lexicographically_less(s.a, t.a) ? t.a : s.a;
  const Point2 last = lexicographically_less(s.b, t.b) ? s.b : t.b;
  if (lexicographically_less(last, first)) return ContactKind::none;
  if (lexicographically_less(first, last)) return ContactKind::overlap;
  return is_end_of(first, s) && is_end_of(first, t) ? ContactKind::shared_endpoint : ContactKind::touch;
}

}  // namespace

std::string_view name_of(ContactKind kind) {
  switch (kind) {
    case ContactKind::none: return "none";
    case ContactKind::shared_endpoint: return "shared-endpoint";
    case ContactKind::touch: return "touch";
    case ContactKind::crossing: return "crossing";
    case ContactKind::overlap: return "overlap";
  }
  return "";
}

ContactKind segment_segment(const Segment& s, const Segment& t, StageTally* tally) {
  // One begins where the other ends: lexicographically, nothing else of them can meet.
  const bool same_first = s.a == t.a, same_last = s.b == t.b;
  if (!same_first && !same_last && (s.b == t.a || t.b == s.a)) return ContactKind::shared_endpoint;
  if (boxes_are_apart(s, t)) return ContactKind::none;
  if (same_first || same_last) {
    const bool one_line = orient_2d(s.a, s.b, same_first ? t.b : t.a, tally) == Sign::zero;
    return one_line ? on_one_line(s, t) : ContactKind::shared_endpoint;
  }
  const Guess cross = surely_cross_2d(s.a, s.b, t.a, t.b);
  if (is_sure(cross)) {
    if (tally) tally->rounded += 4;
    return cross == Guess::positive ? ContactKind::crossing : ContactKind::none;
  }
  const Sign ta = orient_2d(s.a, s.b, t.a, tally), tb = orient_2d(s.a, s.b, t.b, tally);
  if (ta == tb && ta != Sign::zero) return ContactKind::none;
  if (ta == Sign::zero && tb == Sign::zero && s.a != s.b) return on_one_line(s, t);
  const Sign sa = orient_2d(t.a, t.b, s.a, tally), sb = orient_2d(t.a, t.b, s.b, tally);
  if (sa == sb && sa != Sign::zero) return ContactKind::none;
  const bool one_line = ta == Sign::zero && tb == Sign::zero && sa == Sign::zero && sb == Sign::zero;
  if (one_line) return on_one_line(s, t);
  // The lines cross in one point, which is in both segments; where an end lies on the other's line, it is that end.
  if (ta != Sign::zero && tb != Sign::zero && sa != Sign::zero && sb != Sign::zero) return ContactKind::crossing;
  return is_end_of(s.a, t) || is_end_of(s.b, t) ? ContactKind::shared_endpoint : ContactKind::touch;
}

ExactPoint2 common_point(const Segment& s, const Segment& t) {
  const auto whole = [](const Point2& p) { return ExactPoint2{Dyadic(p.x), Dyadic(p.y), Dyadic(1)}; };
  // An end of one that the other holds; of an overlap, the first.
  const Segment first_of_s{s.a, s.a}, first_of_t{t.a, t.a}, last_of_s{s.b, s.b}, last_of_t{t.b, t.b};
  if (segment_segment(first_of_t, s) != ContactKind::none) return whole(t.a);
  if (segment_segment(first_of_s, t) != ContactKind::none) return whole(s.a);
  if (segment_segment(last_of_t, s) != ContactKind::none) return whole(t.b);
  if (segment_segment(last_of_s, t) != ContactKind::none) return whole(s.b);
  return exact_point({s.a, s.b, t.a, t.b});
}

Point2 common_point_rounded(const Segment& s, const Segment& t) {
  const ExactPoint2 p = common_point(s, t);
  return {nearest_ratio(p.x, p.denominator), nearest_ratio(p.y, p.denominator)};
}

Segment common_part(const Segment& s, const Segment& t) {
  // On one line, the lexicographic order is the order along it.
  return {lexicographically_less(s.a, t.a) ? t.a : s.a, lexicographically_less(s.b, t.b) ? s.b : t.b};
}

}  // namespace sunder::planar
