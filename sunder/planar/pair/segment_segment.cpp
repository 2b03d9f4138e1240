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
  if (boxes_are_apart(s, t)) return ContactKind::none;
  const Sign ta = orient_2d(s.a, s.b, t.a, tally), tb = orient_2d(s.a, s.b, t.b, tally);
  if (ta == tb && ta != Sign::zero) return ContactKind::none;
  const Sign sa = orient_2d(t.a, t.b, s.a, tally), sb = orient_2d(t.a, t.b, s.b, tally);
  if (sa == sb && sa != Sign::zero) return ContactKind::none;
  const bool one_line = ta == Sign::zero && tb == Sign::zero && sa == Sign::zero && sb == Sign::zero;
  if (one_line) return on_one_line(s, t);
  // The lines cross in one point, which is in both segments; where an end lies on the other's line, it is that end.
  if (ta != Sign::zero && tb != Sign::zero && sa != Sign::zero && sb != Sign::zero) return ContactKind::crossing;
  return is_end_of(s.a, t) || is_end_of(s.b, t) ? ContactKind::shared_endpoint : ContactKind::touch;
}

CommonPoint common_point(const Segment& s, const Segment& t) {
  const auto whole = [](const Point2& p) { return CommonPoint{{Dyadic(p.x), Dyadic(p.y)}, Dyadic(1)}; };
  // An end of one that the other holds; of an overlap, the first.
  const Segment first_of_s{s.a, s.a}, first_of_t{t.a, t.a}, last_of_s{s.b, s.b}, last_of_t{t.b, t.b};
  if (segment_segment(first_of_t, s) != ContactKind::none) return whole(t.a);
  if (segment_segment(first_of_s, t) != ContactKind::none) return whole(s.a);
  if (segment_segment(last_of_t, s) != ContactKind::none) return whole(t.b);
  if (segment_segment(last_of_s, t) != ContactKind::none) return whole(s.b);
  // s.a + (n / d) (s.b - s.a), where n and d are cross products.
  const auto minus = [](const Point2& p, const Point2& q) {
    return std::array{Dyadic(p.x) - Dyadic(q.x), Dyadic(p.y) - Dyadic(q.y)};
  };
  const auto cross = [](const std::array<Dyadic, 2>& u, const std::array<Dyadic, 2>& v) {
    return u[0] * v[1] - u[1] * v[0];
  };
  const auto along_s = minus(s.b, s.a), along_t = minus(t.b, t.a), across = minus(t.a, s.a);
  Dyadic n = cross(across, along_t), d = cross(along_s, along_t);
  if (d.sign() == Sign::negative) {
    n = -n;
    d = -d;
  }
  return {{Dyadic(s.a.x) * d + n * along_s[0], Dyadic(s.a.y) * d + n * along_s[1]}, d};
}

}  // namespace sunder::planar
