// Searches in the section Q of a body by a plane T, which exists only implicitly, in floating point: nothing here
// decides anything. All is seen in the frame of the drums (Drums::shrink), and counted from one vertex.
//
// T meets the slices l .. m, and each of these in a segment, whose ends are corners of a polygon W inside of Q: first
// those on the right, bottom up, then those on the left, top down, so counter-clockwise seen from the tip of T's
// normal. Between two corners of W that follow each other, Q has a pocket: T goes there through facets of one drum, one
// after the other, sides of that which stand together. So a side of Q is found by two searches: for a corner of W, and
// for an edge of the drum behind it. The side that leaves a corner of W is known by its facet, and the directions in
// which sides go turn round once: where Q is furthest along a direction, or crosses a line, is found by halving.
// Source: CD87 sections 3.4 and 3.5, Lemma 9. Departures: the sides of Q that leave W's corners are searched, not those
// of W; so there is one pocket where the paper looks into two. (Extremes of W are not those of Q, but lie beside them.)
#pragma once

#include <sunder/planar/pair/edge_runs.h>
#include <sunder/solid/search/drum_search.h>

#include <cstdint>
#include <optional>
#include <utility>

namespace sunder::solid {

// The points x with normal . x + at_base = 0, x counted from the vertex Drums::vertex_of(0); positive above.
template <class Real>
struct LinearForm {
  VectorOf<Real> normal;
  Real at_base;

  Real at(const DrumSearch& search, std::uint32_t v) const {
    const Drums& drums = search.drums();
    const Point3 &p = search.vertex(v), &base = search.vertex(drums.vertex_of(0)), &by = drums.shrink();
    return normal.x * (difference<Real>(p.x, base.x) * Real(by.x)) +
           normal.y * (difference<Real>(p.y, base.y) * Real(by.y)) +
           normal.z * (difference<Real>(p.z, base.z) * Real(by.z)) + at_base;
  }
};

// How far from one value of a form to another is zero; 0 where they are equal.
template <class Real>
Real share_to_zero(const Real& value, const Real& other) {
  const Real whole = value - other;
  return !(whole > Real(0)) && !(whole < Real(0)) ? Real(0) : value / whole;
}

template <class Real>
class SectionSearch {
 public:
  // Keeps references.
  SectionSearch(const DrumSearch& search, const LinearForm<Real>& t)
      : search_(search), drums_(search.drums()), t_(t), normal_(rounded(t.normal)) {
    const Point3 level = cross(drums_.up(), normal_);
    is_level_ = level == Point3{};
  }

  // Finds l and m. `beyond`: a vertex on the other side of T than vertex_of(0), or on T; or that one, where it is on T.
  // Where T goes between two slices, or is level, it meets no slices, and pocket(0) is all of Q.
  // Cost: O(log^2 n) probes.
  void find_corners(std::uint32_t beyond) {
    const auto slice_of_beyond = slice_of(beyond);
    const bool starts_above = value_at(drums_.vertex_of(0)) > Real(0);
    const std::uint32_t low = planar::first_where(0, slice_of_beyond, [&](std::uint32_t slice) {
      return starts_above ? !(least(slice) > Real(0)) : !(greatest(slice) < Real(0));
    });
    low_ = low;
    meets_slices_ = !is_level_ && meets(low);
    if (!meets_slices_) return;
    high_ = planar::first_where(low + 1, drums_.slice_count(), [&](std::uint32_t slice) { return !meets(slice); }) - 1;
  }

  bool meets_slices() const { return meets_slices_; }

  std::uint32_t corner_count() const { return meets_slices_ ? 2 * (high_ - low_ + 1) : 1; }

  // Sides first, first + step, .. of a drum, modulo its size, `count` edges between them. Where `level` is not zero,
  // the section goes along the highest slice (positive) or the lowest.
  struct Pocket {
    std::uint32_t drum = 0, first = 0, count = 0;
    bool forward = true;
    Sign level = Sign::zero;
  };

  // Behind corner q of W, up to the next one.
  Pocket pocket(std::uint32_t q) const {
    if (!meets_slices_) return all_round();
    const std::uint32_t half = corner_count() / 2;
    if (q + 1 == half) return top();
    if (q + 1 == 2 * half) return bottom();
    const bool right = q < half;
    const std::uint32_t slice = right ? low_ + q : high_ - (q - half);
    const std::uint32_t drum = right ? slice : slice - 1;
    const Arcs arcs = arcs_of(drum);
    const std::uint32_t from = right ? side_on(arcs.right, slice) : side_on(arcs.left, slice);
    const std::uint32_t to = right ? side_on(arcs.right, slice + 1) : side_on(arcs.left, slice - 1);
    const bool forward = to >= from;
    const std::uint32_t begin = right ? arcs.right.begin : arcs.left.begin;
    return {drum, (begin + from) % drums_.size(drum), forward ? to - from : from - to, forward, Sign::zero};
  }

  // The facet of side j of a pocket, 0 .. count; none where the slice that it goes along is no facet: then it goes
  // through a point.
  std::optional<std::uint32_t> facet(const Pocket& pocket, std::uint32_t j) const {
    if (pocket.level != Sign::zero) return drums_.level_facet(pocket.level == Sign::positive ? 1 : 0);
    return search_.edge(pocket.drum, side(pocket, j)).side;
  }

  // The edge between sides j - 1 and j of a pocket. Requires 0 < j <= count.
  const LateralEdge& edge(const Pocket& pocket, std::uint32_t j) const {
    const std::uint32_t n = drums_.size(pocket.drum);
    return search_.edge(pocket.drum, pocket.forward ? side(pocket, j) : (side(pocket, j) + 1) % n);
  }

  // Where Q is furthest along g: at the end of side j of pocket q, which is an edge if there are more sides, and else
  // the next corner of W.
  struct Place {
    std::uint32_t q = 0, j = 0;
  };

  // Cost: O(log^2 n) probes.
  Place furthest(const Point3& g) const {
    std::uint32_t q = 0;
    if (meets_slices_) {
      const std::uint32_t half = corner_count() / 2;
      const double sideways = dot(g, cross(drums_.up(), normal_));
      const bool right = sideways > 0 || (sideways == 0 && dot(g, drums_.up()) > 0);
      const std::uint32_t begin = right ? 0 : half;
      const std::uint32_t falling =
          planar::first_where(begin, begin + half, [&](std::uint32_t k) { return !rises(g, leaving_normal(k)); });
      q = (falling + 2 * half - 1) % (2 * half);
    }
    const Pocket p = pocket(q);
    if (p.level != Sign::zero || p.count == 0) return {q, 0};
    const auto falls = [&](std::uint32_t j) { return !rises(g, normal_of(p, j)); };
    const std::uint32_t half = corner_count() / 2;
    const bool at_end = !meets_slices_ || q + 1 == half || q + 1 == 2 * half;
    if (!at_end) return {q, planar::first_where(1, p.count + 1, falls) - 1};
    // All round, or above or below all slices that T meets: the sides may turn by more than half a turn. Those that
    // rise stand together. As DrumSearch::furthest_edge, by turns from the first side.
    const bool first_rises = !falls(0);
    const auto turned = [&](std::uint32_t j) { return is_before(normal_of(p, 0), normal_of(p, j)); };
    const std::uint32_t opposite = planar::first_where(1, p.count + 1, [&](std::uint32_t j) { return !turned(j); });
    const std::uint32_t from = first_rises ? 1 : opposite, to = first_rises ? opposite : p.count + 1;
    return {q, planar::first_where(from, to, falls) - 1};
  }

  // The facets before and after a place.
  std::uint32_t facet_before(const Place& place) const {
    const auto found = facet(pocket(place.q), place.j);
    return found ? *found : last_facet(place.q + corner_count() - 1);
  }
  std::uint32_t facet_after(const Place& place) const {
    const Pocket p = pocket(place.q);
    if (place.j < p.count) return *facet(p, place.j + 1);
    if (!meets_slices_) return *facet(p, 0);
    const auto next = facet(pocket((place.q + 1) % corner_count()), 0);
    return next ? *next : *facet(pocket((place.q + 2) % corner_count()), 0);
  }

  // What g is at a place.
  Real value(const LinearForm<Real>& g, const Place& place) const {
    const Pocket p = pocket(place.q);
    if (place.j < p.count || !meets_slices_) return value_on(g, edge(p, place.j == p.count ? 0 : place.j + 1));
    return value_at_corner(g, (place.q + 1) % corner_count());
  }

  // The side by which Q goes up through g = 0 (or down, with the form negated), on the way counter-clockwise from one
  // place to the other, along which g rises from below 0 to above. The facet. Cost: O(log^2 n) probes.
  std::uint32_t crossed(const LinearForm<Real>& g, const Place& from, const Place& to) const {
    if (!meets_slices_) {
      const std::uint32_t end = to.j > from.j ? to.j : to.j + drums_.size(pocket(0).drum);
      return crossed_in(pocket(0), g, from.j + 1, end);
    }
    const std::uint32_t corners = corner_count();
    const bool wraps = to.q < from.q || (to.q == from.q && to.j < from.j);
    const std::uint32_t last_q = wraps ? to.q + corners : to.q;
    const std::uint32_t next = planar::first_where(
        from.q + 1, last_q + 1, [&](std::uint32_t k) { return value_at_corner(g, k % corners) > Real(0); });
    const std::uint32_t q = next - 1;
    const Pocket p = pocket(q % corners);
    std::uint32_t first = from.j + 1;  // the first side that may cross
    if (q != from.q) first = 0;
    if (first > p.count) return facet_after(from);  // the place is a corner of W
    if (p.level != Sign::zero) return facet_before({q % corners, 0});
    return crossed_in(p, g, first, q == last_q ? to.j : p.count);
  }

  // A corner of W: on a slice, between where two lateral edges pass it.
  struct Corner {
    LateralEdge e, f;
    std::uint32_t slice;
  };
  Corner corner(std::uint32_t q) const {
    const std::uint32_t half = corner_count() / 2;
    const bool right = q < half;
    const std::uint32_t slice = right ? low_ + q : high_ - (q - half), drum = drum_of(slice);
    const Arcs arcs = arcs_of(drum);
    const Arc& arc = right ? arcs.right : arcs.left;
    const std::uint32_t n = drums_.size(drum), k = (arc.begin + side_on(arc, slice)) % n;
    return {search_.edge(drum, k), search_.edge(drum, (k + 1) % n), slice};
  }
  Real value(const LinearForm<Real>& g, const Corner& c) const {
    return between(value_of_corner(g, c.e, c.slice), value_of_corner(t_, c.e, c.slice),
                   value_of_corner(g, c.f, c.slice), value_of_corner(t_, c.f, c.slice));
  }

  // What points are means of: weights of the body's vertices. Of a corner of W, and of where an edge crosses T.
  template <class Add>
  void add_parts(const Corner& c, const Add& add) const {
    const Real to_f = share_to_zero(value_of_corner(t_, c.e, c.slice), value_of_corner(t_, c.f, c.slice));
    const auto part = [&](const LateralEdge& e, const Real& weight) {
      const Real up = search_.share_at<Real>(e, c.slice);
      add(e.low, weight * (Real(1) - up));
      add(e.high, weight * up);
    };
    part(c.e, Real(1) - to_f);
    part(c.f, to_f);
  }
  template <class Add>
  void add_parts(const LateralEdge& e, const Add& add) const {
    const Real up = share_to_zero(value_at(e.low), value_at(e.high));
    add(e.low, Real(1) - up);
    add(e.high, up);
  }

  // Where an edge crosses T.
  Real value(const LinearForm<Real>& g, const LateralEdge& e) const { return value_on(g, e); }

  // g at vertex v of the body.
  Real value_at(const LinearForm<Real>& g, std::uint32_t v) const { return g.at(search_, v); }

 private:
  // Corners begin .. begin + length of a drum, modulo its size, from the greatest value of T to the least, or back.
  struct Arc {
    std::uint32_t drum, begin, length;
    bool falls;
  };
  struct Arcs {
    Arc right, left;
  };

  Arcs arcs_of(std::uint32_t drum) const {
    const std::uint32_t n = drums_.size(drum);
    const std::uint32_t a = search_.furthest_edge(drum, normal_), b = search_.furthest_edge(drum, negated(normal_));
    return {{drum, a, (b + n - a) % n, true}, {drum, b, (a + n - b) % n, false}};
  }

  // The side of the arc on which T crosses a slice, counted from the arc's beginning.
  std::uint32_t side_on(const Arc& arc, std::uint32_t slice) const {
    const std::uint32_t n = drums_.size(arc.drum);
    if (arc.length == 0) return 0;
    return planar::first_where(1, arc.length,
                               [&](std::uint32_t k) {
                                 const Real v = value_of_corner(t_, search_.edge(arc.drum, (arc.begin + k) % n), slice);
                                 return arc.falls ? v < Real(0) : !(v < Real(0));
                               }) -
           1;
  }

  std::uint32_t drum_of(std::uint32_t slice) const { return std::min(slice, drums_.drum_count() - 1); }

  Real extreme_of(std::uint32_t slice, const Point3& d) const {
    const std::uint32_t drum = drum_of(slice);
    return value_of_corner(t_, search_.edge(drum, search_.furthest_edge(drum, d)), slice);
  }
  Real greatest(std::uint32_t slice) const { return extreme_of(slice, normal_); }
  Real least(std::uint32_t slice) const { return extreme_of(slice, negated(normal_)); }
  bool meets(std::uint32_t slice) const { return !(greatest(slice) < Real(0)) && !(least(slice) > Real(0)); }

  // Of sides first .. last of a pocket, all round: the one at whose end g is above 0. The facet.
  std::uint32_t crossed_in(const Pocket& p, const LinearForm<Real>& g, std::uint32_t first, std::uint32_t last) const {
    const std::uint32_t sides = p.count + 1;
    const std::uint32_t j = planar::first_where(
        first, last, [&](std::uint32_t k) { return value_on(g, edge(p, (k + 1) % sides)) > Real(0); });
    return *facet(p, j % sides);
  }

  Pocket top() const {
    if (high_ == drums_.drum_count()) return {.level = Sign::positive};
    const Arcs arcs = arcs_of(high_);
    const std::uint32_t n = drums_.size(high_);
    const std::uint32_t from = (arcs.right.begin + side_on(arcs.right, high_)) % n;
    const std::uint32_t to = (arcs.left.begin + side_on(arcs.left, high_)) % n;
    const bool forward = greatest_above(high_) > Real(0);
    return {high_, from, forward ? (to + n - from) % n : (from + n - to) % n, forward, Sign::zero};
  }
  Pocket bottom() const {
    if (low_ == 0) return {.level = Sign::negative};
    const std::uint32_t drum = low_ - 1, n = drums_.size(drum);
    const Arcs arcs = arcs_of(drum);
    const std::uint32_t from = (arcs.left.begin + side_on(arcs.left, low_)) % n;
    const std::uint32_t to = (arcs.right.begin + side_on(arcs.right, low_)) % n;
    const bool forward = value_of_corner(t_, search_.edge(drum, arcs.right.begin), drum) < Real(0);
    return {drum, from, forward ? (to + n - from) % n : (from + n - to) % n, forward, Sign::zero};
  }
  Real greatest_above(std::uint32_t drum) const {
    return value_of_corner(t_, search_.edge(drum, search_.furthest_edge(drum, normal_)), drum + 1);
  }
  std::uint32_t last_facet(std::uint32_t q) const {
    const Pocket p = pocket(q % corner_count());
    return *facet(p, p.count);
  }
  // T goes between two slices: all edges of the drum cross it.
  Pocket all_round() const {
    const std::uint32_t drum = low_ == 0 ? 0 : low_ - 1;
    const bool forward = is_level_ ? dot(normal_, drums_.up()) > 0 : greatest_above(drum) > Real(0);
    return {drum, 0, drums_.size(drum) - 1, forward, Sign::zero};
  }

  std::uint32_t side(const Pocket& p, std::uint32_t j) const {
    const std::uint32_t n = drums_.size(p.drum);
    return p.forward ? (p.first + j) % n : (p.first + n - j % n) % n;
  }
  const Point3& normal_of(const Pocket& p, std::uint32_t j) const {
    return drums_.normal(search_.edge(p.drum, side(p, j)).side);
  }

  // Of the side of Q that leaves corner q of W.
  Point3 leaving_normal(std::uint32_t q) const {
    const std::uint32_t half = corner_count() / 2;
    const bool right = q < half;
    const std::uint32_t slice = right ? low_ + q : high_ - (q - half);
    if (right && slice == drums_.drum_count()) return drums_.up();
    if (!right && slice == 0) return negated(drums_.up());
    const std::uint32_t drum = right ? slice : slice - 1;
    const Arcs arcs = arcs_of(drum);
    const Arc& arc = right ? arcs.right : arcs.left;
    return drums_.normal(search_.edge(drum, (arc.begin + side_on(arc, slice)) % drums_.size(drum)).side);
  }

  // Does g rise along a side of Q with this normal?
  bool rises(const Point3& g, const Point3& normal) const { return dot(g, cross(normal_, normal)) > 0; }

  // Seen from the tip of T's normal: is normal b at most half a turn to the left of a?
  bool is_before(const Point3& a, const Point3& b) const {
    const double left = dot(normal_, cross(a, b));
    if (left != 0) return left > 0;
    return dot(cross(normal_, a), cross(normal_, b)) > 0;
  }

  Real value_at(std::uint32_t v) const { return value_at(t_, v); }

  std::uint32_t slice_of(std::uint32_t v) const { return drums_.slice_of(v); }

  // Where an edge passes a slice.
  Real value_of_corner(const LinearForm<Real>& g, const LateralEdge& e, std::uint32_t slice) const {
    if (slice <= e.begin) return value_at(g, e.low);
    if (slice >= e.end) return value_at(g, e.high);
    const Real from = value_at(g, e.low), to = value_at(g, e.high);
    return from + (to - from) * search_.share_at<Real>(e, slice);
  }

  // Between two values of T of which one is not negative and one is not positive.
  static Real between(const Real& g, const Real& t, const Real& g_other, const Real& t_other) {
    return g + (g_other - g) * share_to_zero(t, t_other);
  }

  // Where an edge crosses T.
  Real value_on(const LinearForm<Real>& g, const LateralEdge& e) const {
    return between(value_at(g, e.low), value_at(e.low), value_at(g, e.high), value_at(e.high));
  }

  Real value_at_corner(const LinearForm<Real>& g, std::uint32_t q) const { return value(g, corner(q)); }

  const DrumSearch& search_;
  const Drums& drums_;
  LinearForm<Real> t_;
  Point3 normal_;
  bool is_level_ = false, meets_slices_ = false;
  std::uint32_t low_ = 0, high_ = 0;
};

}  // namespace sunder::solid
