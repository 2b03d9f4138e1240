#include <sunder/base/names.h>
#include <sunder/planar/pair/segment_segment.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <utility>

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
  const auto [first, last] = common_part(s, t);
  if (lexicographically_less(last, first)) return ContactKind::none;
  if (lexicographically_less(first, last)) return ContactKind::overlap;
  return is_end_of(first, s) && is_end_of(first, t) ? ContactKind::shared_endpoint : ContactKind::touch;
}

}  // namespace

std::string_view name_of(ContactKind kind) {
  return name_in<ContactKind::overlap>({"none", "shared-endpoint", "touch", "crossing", "overlap"}, kind);
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
  // An end of one that the other holds; of an overlap, the first.
  for (const auto& [end, other] : {std::pair(t.a, s), std::pair(s.a, t), std::pair(t.b, s), std::pair(s.b, t)}) {
    if (segment_segment({end, end}, other) != ContactKind::none) return exactly(end);
  }
  return exact_point({s.a, s.b, t.a, t.b});
}

Point2 common_point_rounded(const Segment& s, const Segment& t) { return nearest(common_point(s, t)); }

}  // namespace sunder::planar
