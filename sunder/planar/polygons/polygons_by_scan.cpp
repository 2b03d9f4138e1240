// The oracles: they share no search with the other methods.
//
// All edges of both polygons part each edge into pieces. Where the interiors have a common point, their common part is
// open, and its boundary holds some whole piece, with both interiors on one and the same side of it. So the polygons
// overlap iff, for the middle of some piece, an odd number of edges of both is just below it, or just above it. Points
// of an edge are a + t (b - a), t = n / d in exact numbers; "below" is lexicographic (ring_tests.h says how).
//
// Exact numbers are Dyadic, or, where all coordinates are whole and at most 2^8 in size, 64-bit integers, which is much
// faster: differences are below 2^10 then, n and d below 2^20, those of the middle of a piece below 2^42, the point's
// numerators below 2^50, and products of these with a difference, and their sums, below 2^62.
#include <sunder/number/dyadic.h>
#include <sunder/planar/polygons/polygon_contacts_in_order.h>
#include <sunder/planar/polygons/polygons_all.h>
#include <sunder/planar/polygons/polygons_any.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sunder::planar {

namespace {

Sign sign_of_number(const Dyadic& x) { return x.sign(); }
Sign sign_of_number(std::int64_t x) { return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero; }

template <class Number>
Number exactly(double x) {
  return static_cast<Number>(x);
}

// x / d and y / d, d positive.
template <class Number>
struct Fraction2 {
  Number x, y, d;
};
template <class Number>
struct Fraction {
  Number n, d;
};

template <class Number>
bool less(const Fraction<Number>& a, const Fraction<Number>& b) {
  return sign_of_number(a.n * b.d - b.n * a.d) == Sign::negative;
}

// The sign of (b - a) x (p - a) times the denominator.
template <class Number>
Sign side(const Segment& s, const Fraction2<Number>& p) {
  const Number ux = exactly<Number>(s.b.x) - exactly<Number>(s.a.x),
               uy = exactly<Number>(s.b.y) - exactly<Number>(s.a.y);
  const Number vx = p.x - exactly<Number>(s.a.x) * p.d, vy = p.y - exactly<Number>(s.a.y) * p.d;
  return sign_of_number(ux * vy - uy * vx);
}

// Lexicographically: p - q.
template <class Number>
Sign compare(const Fraction2<Number>& p, const Point2& q) {
  const Sign x = sign_of_number(p.x - exactly<Number>(q.x) * p.d);
  return x != Sign::zero ? x : sign_of_number(p.y - exactly<Number>(q.y) * p.d);
}

// Is the inside of the polygon just below p, and just above it? p is no vertex, and not on a crossing.
struct Sides {
  bool below, above;
};
template <class Number>
Sides sides_at(const Polygon& polygon, const Fraction2<Number>& p) {
  bool below = false, here = false;
  for (std::uint32_t k = 0; k < polygon.size(); ++k) {
    const Segment edge = sorted(polygon.edge(k));
    if (compare(p, edge.a) == Sign::negative || compare(p, edge.b) != Sign::negative) continue;
    const Sign from_edge = side(edge, p);
    below ^= from_edge == Sign::positive;
    here ^= from_edge == Sign::zero;
  }
  return {below, below != here};
}

template <class Number>
bool inside(const Polygon& polygon, const Point2& p) {
  const Fraction2<Number> at{exactly<Number>(p.x), exactly<Number>(p.y), exactly<Number>(1)};
  for (std::uint32_t k = 0; k < polygon.size(); ++k) {
    if (segment_segment({p, p}, sorted(polygon.edge(k))) != ContactKind::none) return false;
  }
  return sides_at(polygon, at).below;
}

// Where along s, from 0 to 1, an end of t lies on it, or the two cross.
template <class Number>
void add_common_points(const Segment& s, const Segment& t, std::vector<Fraction<Number>>& at) {
  const ContactKind kind = segment_segment(s, t);
  if (kind == ContactKind::none) return;
  const Number ux = exactly<Number>(s.b.x) - exactly<Number>(s.a.x),
               uy = exactly<Number>(s.b.y) - exactly<Number>(s.a.y);
  const auto part = [](const Number& n, const Number& d) {
    return sign_of_number(d) == Sign::negative ? Fraction<Number>{-n, -d} : Fraction<Number>{n, d};
  };
  if (kind != ContactKind::crossing) {
    for (const Point2& p : {t.a, t.b}) {
      if (segment_segment({p, p}, s) == ContactKind::none) continue;
      const Number vx = exactly<Number>(p.x) - exactly<Number>(s.a.x),
                   vy = exactly<Number>(p.y) - exactly<Number>(s.a.y);
      at.push_back(sign_of_number(ux) != Sign::zero ? part(vx, ux) : part(vy, uy));
    }
    return;
  }
  const Number wx = exactly<Number>(t.b.x) - exactly<Number>(t.a.x),
               wy = exactly<Number>(t.b.y) - exactly<Number>(t.a.y);
  const Number vx = exactly<Number>(t.a.x) - exactly<Number>(s.a.x),
               vy = exactly<Number>(t.a.y) - exactly<Number>(s.a.y);
  at.push_back(part(vx * wy - vy * wx, ux * wy - uy * wx));
}

// The point (1 - t) a + t b for t in the middle of two fractions.
template <class Number>
Fraction2<Number> middle(const Segment& s, const Fraction<Number>& from, const Fraction<Number>& to) {
  const Number n = from.n * to.d + to.n * from.d, d = (from.d * to.d) + (from.d * to.d), m = d - n;
  return {exactly<Number>(s.a.x) * m + exactly<Number>(s.b.x) * n,
          exactly<Number>(s.a.y) * m + exactly<Number>(s.b.y) * n, d};
}

template <class Number>
bool overlap(const Polygon& a, const Polygon& b, Cost& cost) {
  for (const Polygon* of : {&a, &b}) {
    for (std::uint32_t k = 0; k < of->size(); ++k) {
      const Segment s = sorted(of->edge(k));
      if (s.a == s.b) continue;
      std::vector<Fraction<Number>> at{{exactly<Number>(0), exactly<Number>(1)},
                                       {exactly<Number>(1), exactly<Number>(1)}};
      for (const Polygon* other : {&a, &b}) {
        for (std::uint32_t l = 0; l < other->size(); ++l) {
          ++cost.probes;
          if (other != of || l != k) add_common_points(s, sorted(other->edge(l)), at);
        }
      }
      std::sort(at.begin(), at.end(), less<Number>);
      for (std::size_t piece = 1; piece < at.size(); ++piece) {
        if (!less(at[piece - 1], at[piece])) continue;
        const Fraction2<Number> p = middle(s, at[piece - 1], at[piece]);
        const Sides in_a = sides_at(a, p), in_b = sides_at(b, p);
        cost.probes += a.size() + b.size();
        if ((in_a.below && in_b.below) || (in_a.above && in_b.above)) return true;
      }
    }
  }
  return false;
}

bool are_small_and_whole(const Polygon& polygon) {
  const auto fits = [](double x) { return x >= -256 && x <= 256 && static_cast<double>(static_cast<int>(x)) == x; };
  return std::all_of(polygon.vertices().begin(), polygon.vertices().end(),
                     [&](const Point2& p) { return fits(p.x) && fits(p.y); });
}

template <class Number>
PolygonsAnswer contact_in(const Polygon& a, const Polygon& b) {
  PolygonsAnswer answer;
  PolygonsContact found;
  for (std::uint32_t e = 0; e < a.size(); ++e) {
    for (std::uint32_t f = 0; f < b.size(); ++f) {
      ++answer.cost.probes;
      const ContactKind kind = segment_segment(sorted(a.edge(e)), sorted(b.edge(f)));
      if (kind <= found.kind) continue;
      found = {Relation::touching, kind, false, 0, 1, e, f};
    }
  }
  if (overlap<Number>(a, b, answer.cost)) {
    found.contact = Relation::overlapping;
    for (std::uint32_t v = 0; v < a.size() && found.kind == ContactKind::none; ++v) {
      if (inside<Number>(b, a.vertices()[v])) found = {Relation::overlapping, ContactKind::none, true, 0, 1, v, 0};
    }
    for (std::uint32_t v = 0; v < b.size() && found.kind == ContactKind::none && !found.i_inside; ++v) {
      if (inside<Number>(a, b.vertices()[v])) found = {Relation::overlapping, ContactKind::none, false, 0, 1, 0, v};
    }
  }
  if (found.contact != Relation::none) answer.found = found;
  return answer;
}

}  // namespace

PolygonsAnswer polygons_contact_by_scan(const Polygon& a, const Polygon& b) {
  const bool small = are_small_and_whole(a) && are_small_and_whole(b);
  return small ? contact_in<std::int64_t>(a, b) : contact_in<Dyadic>(a, b);
}

PolygonsAllAnswer polygons_all_by_scan(std::span<const Polygon> polygons, const SetOptions& options) {
  check_groups(options.groups, polygons.size());
  PolygonsAllAnswer answer;
  for (std::uint32_t i = 0; i < polygons.size(); ++i) {
    for (std::uint32_t j = i + 1; j < polygons.size(); ++j) {
      if (may_meet(options.groups, i, j)) continue;
      PolygonsAnswer pair = polygons_contact_by_scan(polygons[i], polygons[j]);
      answer.cost.probes += pair.cost.probes;
      if (!pair.meet() || !counts(*pair.found, options.allowed)) continue;
      pair.found->i = i;
      pair.found->j = j;
      answer.found.push_back(*pair.found);
    }
  }
  return answer;
}

Cost find_contacts_by_scan(std::span<const Polygon> polygons, const SetOptions& options, LowestContacts& found) {
  const PolygonsAllAnswer all = polygons_all_by_scan(polygons, options);
  for (const PolygonsContact& c : all.found) found.add(c);
  return all.cost;
}

PolygonsAnswer polygons_any_by_scan(std::span<const Polygon> polygons, const SetOptions& options) {
  check_groups(options.groups, polygons.size());
  PolygonsAnswer answer;
  const PolygonsAllAnswer all = polygons_all_by_scan(polygons, options);
  answer.cost = all.cost;
  if (!all.found.empty()) answer.found = all.found.front();
  return answer;
}

}  // namespace sunder::planar
