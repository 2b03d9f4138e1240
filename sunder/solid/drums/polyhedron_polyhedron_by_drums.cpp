// long because: five steps of one algorithm share what is left of the body and the planes that were kept
//
// Algorithm IHH: P, the body that is cut, is reduced to a drum, to what is between two planes through an edge of that,
// and to a pyramid under one facet, by planes T (CD87 section 3.6). Each cuts P, or what is left of it, in a polygon R,
// which is asked whether it meets Q, the other body (IHG, section_against.h). If not, a plane T_Q along a line that
// parts them supports Q, and:
//   D1. What is left of P beyond T_Q is convex and has no point in T. So any point of it tells on which side of T all
//       common points of P and Q are; where there is none, P and Q are apart.
//   D2. In the end the planes T_Q that were kept and P have no point in common. So a mix of these planes has all of P
//       on its other side, and parts the bodies (Helly's theorem; Farkas' lemma).
//   D3. Planes through a lateral edge e turn about it: first those through corners of the lower slice, then those of
//       the upper one. A corner of the lower slice that is e's own gives no plane: its upper corner does in its place,
//       in the same order.
//   D4. A plane T_Q that is kept answers for every T whose R has nothing beyond it: T is not asked about. In a drum the
//       corners beyond T_Q are a run of lateral edges, which holds the furthest one, the same at all heights.
#include <sunder/base/contract.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/drums/drum_polygons.h>
#include <sunder/solid/pair/polyhedron_polygon.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/search/axis_scaled.h>
#include <sunder/solid/search/matrix_game.h>
#include <sunder/solid/section/section_against.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

namespace sunder::solid {

namespace {

// The same proposal with the bodies' names exchanged.
Proposal exchanged(const Proposal& p) {
  using enum Proposal::Claim;
  Proposal q = p;
  if (p.claim == apart_along_normal_of_a) q.claim = apart_along_normal_of_b;
  if (p.claim == apart_along_normal_of_b) q.claim = apart_along_normal_of_a;
  std::swap(q.count_a, q.count_b);
  std::copy_n(p.vertices.begin() + p.count_a, p.count_b, q.vertices.begin());
  std::copy_n(p.vertices.begin(), p.count_a, q.vertices.begin() + p.count_b);
  std::swap(q.near_a, q.near_b);
  q.direction = negated(p.direction);
  q.rest = negated(p.rest);
  return q;
}

// Normals of planes that support Q, of its scaled world, towards Q.
struct Ways {
  static constexpr std::size_t most = 8;
  std::array<Point3, most> way{};
  std::size_t count = 0;
};

template <class Real>
class PolyhedraByDrums {
  using Vector = VectorOf<Real>;
  using Form = LinearForm<Real>;

 public:
  // Proposals are about q as A, and p as B. Begins with the planes that have these normals; where there are none, with
  // the one across the way from P's middle to that of Q.
  PolyhedraByDrums(const Placed& q, const Placed& p, Cost& cost, const Ways& ways)
      : q_(q),
        p_(p),
        cost_(cost),
        search_q_(represent::of<Drums>(q.body), q.body.vertices(), cost),
        search_p_(represent::of<Drums>(p.body), p.body.vertices(), cost),
        frame_q_(q.pose, represent::of<Drums>(q.body).shrink()),
        frame_p_(p.pose, represent::of<Drums>(p.body).shrink(), frame_q_),
        from_(image(p, represent::of<Drums>(p.body).vertex_of(0))),
        base_q_(frame_q_.way_to_image<Real>(from_, search_q_.vertex(represent::of<Drums>(q.body).vertex_of(0)))),
        body_(search_p_, p, frame_q_, from_),
        base_p_(body_.at(drums().vertex_of(0))),
        proposals_(q),
        ways_(ways) {}

  bool propose(const Holds& holds) {
    const End end = reduce(holds);
    return end == End::held || (end == End::parted && mix(holds));
  }

  // The directions of the planes that the search ended with. A more precise search begins with them.
  Ways ways() const {
    Ways found;
    distinct([&](std::size_t k) {
      if (found.count < Ways::most) found.way[found.count++] = rounded(kept_[k]->normal);
    });
    return found;
  }

 private:
  enum class End : std::uint8_t {
    held,    // a proposal held
    stuck,   // rounding spoilt it
    parted,  // what is left of P is beyond none of the planes that are kept
    goes_on,
  };

  // The search keeps a plane T_Q for each side of the planes asked about on which what is left of P may be, and the
  // last plane. The planes that the search begins with are kept from `first` on.
  enum Place : std::size_t { above_slice, below_slice, right, left, above_triangle, below_triangle, last, first };
  static constexpr std::size_t most_kept = first + Ways::most, most_in_game = 16;
  static_assert(most_kept <= most_in_game);

  // A plane that supports Q, as a form over P's drums: positive beyond it, where Q is.
  struct Support {
    Form beyond{};
    Vector normal{};           // of the scaled world, towards Q
    double by = 1;             // what the form is, beside the normal
    bool is_beside = false;    // all of Q is on one side of the plane that was asked about
    Proposal claim;            // that it parts the bodies; of kind `meet`: by nothing but its normal
    std::uint32_t number = 0;  // counted as they are found
    // What is beyond it in the drum is between these two lateral edges, counted from e: none where e is beyond it.
    std::optional<std::array<std::uint32_t, 2>> extent;
  };

  // A plane through e: of corners 1 .. n - 1 of either slice, the last that is right of it and the first that is left.
  struct Fan {
    CutPolygon<Real> polygon;
    std::array<Mean<Real>, 2> across;  // where it leaves either slice
    Vector normal{};
    std::array<std::uint32_t, 2> last_right{}, first_left{};
    std::optional<Support> support;
  };

  static Point3 image(const Placed& body, std::uint32_t v) {
    const auto p = rounded_image(body[v]);
    return {p.x, p.y, p.z};
  }
  const Drums& drums() const { return represent::of<Drums>(p_.body); }
  const LateralEdge& edge(std::uint32_t k) const { return search_p_.edge(drum_, k); }

  // ---- One plane ----------------------------------------------------------------------------------------------------

  template <class R>
  struct Found {
    PolyhedraByDrums& search;
    const R& r;
    const Vector& normal;
    const Holds& holds;
    Support& support;

    End beside(std::uint32_t v, bool is_above) const {
      support.is_beside = true;
      support.claim.near_a = v;
      return search.towards(is_above ? normal : negated(normal), search.at_q(v), support);
    }

    template <class Sequence>
    End meet(const Sequence& q, const CommonVertices& found) const {
      return propose_common_point<Real>(search.q_, q, search.p_, r, found, holds) ? End::held : End::stuck;
    }

    End parted(const PocketSequence<Real>& q, const Separation& found) const {
      if (propose_touch<Real>(search.q_, q, search.p_, r, found, holds)) return End::held;
      if (found.direction.kind == Direction::Kind::side_of_a) return by_facet(q.facet_behind(found.direction.index[0]));
      if (found.direction.kind != Direction::Kind::side_of_b) return End::stuck;
      const std::uint32_t k = found.extreme_a, j = found.direction.index[0];
      const auto before = q.facet_behind(k > 0 ? k - 1 : q.size() - 1), after = q.facet_behind(k);
      if (!before || !after || *before == *after) return by_facet(before ? before : after);
      // Both facets support Q in vertex k, and so does every mix of them.
      const Vector along = minus(search.body_at(r, j + 1 < r.size() ? j + 1 : 0), search.body_at(r, j));
      const Vector m = search.inwards(*before), n = search.inwards(*after);
      const Real of_m = dot(m, along), of_n = dot(n, along);
      const bool between = (of_m > Real(0)) != (of_n > Real(0));
      if (!between) return by_facet(of_m * of_m < of_n * of_n ? before : after);
      const Real x = of_n > Real(0) ? of_n : -of_n, y = of_m > Real(0) ? of_m : -of_m;
      const Vector mixed{x * m.x + y * n.x, x * m.y + y * n.y, x * m.z + y * n.z};
      Mixture<Real> at;
      q.add_parts(k, [&](std::uint32_t v, const Real& w) { at.add(v, w); });
      const auto line_p = r.line_behind(j);
      const auto line_q = q.edge_at(k);
      if (line_p && line_q) support.claim = search.proposals_.beyond_edge(*line_q, *line_p, (*line_p)[0]);
      support.claim.near_a = line_q ? (*line_q)[0] : at.vertex[0];
      return search.towards(mixed, line_q ? search.at_q((*line_q)[0]) : search.at_q(at), support);
    }

    End by_facet(const std::optional<std::uint32_t>& facet) const {
      if (!facet) return End::stuck;
      support.claim = search.proposals_.beyond_facet(*facet, 0);
      return search.towards(search.inwards(*facet), search.at_q(search.q_.body.facet(*facet)[0]), support);
    }
  };

  // Does R, in a plane with this normal and point, meet Q? If not: a plane that parts them.
  template <class MakeSequence>
  End ask(const Vector& of_normal, const Vector& point, const MakeSequence& make, const Holds& holds,
          Support& support) {
    const Vector normal = scaled_to_one(of_normal);
    const SectionAgainst<Real> against(search_q_, frame_q_, base_q_, normal, point, cost_);
    const auto r = make(against.axes(), frame_q_.reflects());
    return against.run(r, Found<std::remove_const_t<decltype(r)>>{*this, r, normal, holds, support});
  }
  End ask(const Vector& normal, const Vector& point, const CutPolygon<Real>& polygon, const Holds& holds,
          Support& support) {
    return ask(
        normal, point, [&](const auto& axes, bool turned) { return CutSequence<Real>(body_, polygon, axes, turned); },
        holds, support);
  }

  Vector at_q(std::uint32_t v) const { return frame_q_.way_to_image<Real>(from_, search_q_.vertex(v)); }
  Vector at_q(const Mixture<Real>& mixture) const {
    return mean_of<Real>(mixture, [&](std::uint32_t v) { return at_q(v); });
  }
  template <class R>
  Vector body_at(const R& r, std::uint32_t k) const {
    Mixture<Real> parts;
    r.add_parts(k, [&](std::uint32_t v, const Real& w) { parts.add(v, w); });
    return mean_of<Real>(parts, [&](std::uint32_t v) { return body_.at(v); });
  }
  // The normal of a facet of Q, into Q.
  Vector inwards(std::uint32_t f) const {
    const auto [a, b, c] = thirds_of(q_.body.facet(f));
    const Vector p = at_q(a), n = scaled_to_one(cross_of<Real>(minus(at_q(b), p), minus(at_q(c), p)));
    return frame_q_.reflects() ? n : negated(n);
  }

  // Q is beyond the plane through a point of it.
  End towards(const Vector& of_normal, const Vector& point, Support& support) {
    support.number = ++found_;
    support.normal = scaled_to_one(of_normal);
    Form& g = support.beyond;
    g = frame_p_.form<Real>(support.normal, minus(base_p_, point));
    const Point3 n = rounded(g.normal);
    const double size = std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z), std::fabs(nearest(g.at_base))});
    if (!(size > 0) || !std::isfinite(size)) return End::stuck;
    const double by = support.by = std::ldexp(1.0, std::clamp(-2 - std::ilogb(size), -1000, 1000));
    g = {{scaled(g.normal.x, by), scaled(g.normal.y, by), scaled(g.normal.z, by)}, scaled(g.at_base, by)};
    return End::goes_on;
  }

  std::uint32_t furthest_vertex(const Form& g) const {
    return search_p_.furthest_vertex<Real>(g.normal, [](std::uint32_t) { return false; });
  }
  // The furthest vertex, or one that is beyond.
  std::uint32_t vertex_beyond(const Form& g) const {
    return search_p_.furthest_vertex<Real>(g.normal, [&](std::uint32_t v) { return g.at(search_p_, v) > Real(0); });
  }

  // ---- The steps ----------------------------------------------------------------------------------------------------

  End reduce(const Holds& holds) {
    if (const End end = to_drum(holds); end != End::goes_on) return end;
    if (const End end = to_wedge(holds); end != End::goes_on) return end;
    return to_pyramid(holds);
  }

  // Does the plane, or what it was found by, part the bodies? v: P's vertex furthest beyond it.
  bool parts(const Support& support, std::uint32_t v, const Holds& holds) const {
    Proposal claim = support.claim;
    claim.near_b = v;
    return (claim.claim != Proposal::Claim::meet && holds(claim)) ||
           holds(along(support.normal, support.claim.near_a, v));
  }

  void keep(const Support& support, std::size_t place) {
    kept_[place] = support;
    newest_ = place;
  }

  // Calls take(k) for the places of planes that are kept, once for each plane.
  template <class Take>
  void distinct(const Take& take) const {
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      if (!kept_[k]) continue;
      std::size_t same = 0;
      while (!kept_[same] || kept_[same]->number != kept_[k]->number) ++same;
      if (same == k) take(k);
    }
  }

  // D4: planes to begin with.
  End begin(const Holds& holds) {
    low_ = 0, high_ = drums().drum_count();
    if (ways_.count == 0) {
      const Vector p = frame_q_.way_to_image<Real>(from_, p_.pose, p_.graph.middle);
      ways_.way[ways_.count++] = rounded(minus(frame_q_.way_to_image<Real>(from_, q_.graph.middle), p));
    }
    for (std::size_t k = 0; k < ways_.count; ++k) {
      const Point3& of = ways_.way[k];
      const Vector way = scaled_to_one(Vector{Real(of.x), Real(of.y), Real(of.z)});
      const Vector back = frame_q_.form<Real>(negated(way), base_q_).normal;
      Support support;
      support.claim.near_a = search_q_.furthest_vertex<Real>(back, [](std::uint32_t) { return false; });
      if (towards(way, at_q(support.claim.near_a), support) != End::goes_on) continue;
      const std::uint32_t v = vertex_beyond(support.beyond);
      const Real value = support.beyond.at(search_p_, v);
      if (!(value > Real(noise)) && parts(support, v, holds)) return End::held;
      keep(support, first + k);
      if (value < Real(-noise)) return End::parted;
      narrow(support, v);
    }
    return End::goes_on;
  }

  // Step 1.
  End to_drum(const Holds& holds) {
    if (const End end = begin(holds); end != End::goes_on) return end;
    while (high_ - low_ > 1) {
      const std::uint32_t middle = low_ + (high_ - low_) / 2;
      std::uint32_t v = 0;
      if (const End end = ask_slice(middle, holds, v); end != End::goes_on) return end;
      (drums().slice_of(v) > middle ? low_ : high_) = middle;
      narrow(*kept_[newest_], v);
    }
    drum_ = low_;
    return End::goes_on;
  }

  // D4: slices that have nothing beyond the plane, which has vertex v of P beyond it, are no further asked about.
  void narrow(const Support& of, std::uint32_t v) {
    const Support support = of;
    const auto is_beyond = [&](std::uint32_t slice) { return reaches(slice, support); };
    const std::uint32_t at = std::clamp(drums().slice_of(v), low_, high_);
    const std::uint32_t from = planar::first_where(low_ + 1, at, is_beyond);
    const std::uint32_t to =
        planar::first_where(std::max(at, low_ + 1), high_, [&](std::uint32_t slice) { return !is_beyond(slice); });
    if (from > low_ + 1) low_ = from - 1, kept_[above_slice] = support;
    if (to < high_) high_ = to, kept_[below_slice] = support;
  }

  // Has the slice a point beyond the plane, or on it?
  bool reaches(std::uint32_t slice, const Support& support) const {
    const std::uint32_t drum = std::min(slice, drums().drum_count() - 1);
    const std::uint32_t k = search_p_.furthest_edge(drum, rounded(support.beyond.normal));
    return !(body_.value_at(support.beyond, search_p_.edge(drum, k), slice) < Real(-noise));
  }

  // v: a vertex of P beyond T_Q.
  End ask_slice(std::uint32_t slice, const Holds& holds, std::uint32_t& v) {
    const Point3& up = drums().up();
    const std::size_t k = std::fabs(up.x) >= std::max(std::fabs(up.y), std::fabs(up.z)) ? 0
                          : std::fabs(up.y) >= std::fabs(up.z)                          ? 1
                                                                                        : 2;
    const std::array<Point3, 3> level{Point3{0, -up.z, up.y}, Point3{up.z, 0, -up.x}, Point3{-up.y, up.x, 0}};
    const auto turned = [&](const Point3& d) -> Vector {
      const auto row = [&](std::size_t i) -> Real {
        return product<Real>(frame_p_(i, 0), d.x) + product<Real>(frame_p_(i, 1), d.y) +
               product<Real>(frame_p_(i, 2), d.z);
      };
      return {row(0), row(1), row(2)};
    };
    Vector normal = cross_of<Real>(turned(level[(k + 1) % 3]), turned(level[(k + 2) % 3]));
    if (up[k] < 0) normal = negated(normal);
    Support support;
    const End end = ask(
        normal, body_.at(drums().vertex_of(slice)),
        [&](const auto& axes, bool reversed) { return SliceSequence<Real>(body_, slice, axes, reversed); }, holds,
        support);
    if (end != End::goes_on) return end;
    v = vertex_beyond(support.beyond);
    const Real value = support.beyond.at(search_p_, v);
    if (!(value > Real(noise)) && parts(support, v, holds)) return End::held;
    const bool is_parted = value < Real(-noise);
    const bool is_above = drums().slice_of(v) > slice;
    keep(support, is_parted ? last : is_above ? above_slice : below_slice);
    if (is_parted) return End::parted;
    return drums().slice_of(v) == slice ? End::stuck : End::goes_on;
  }

  // Corners of either slice that are left to be told apart: none where `first` is `last` + 1.
  struct Range {
    std::array<std::uint32_t, 2> first, last;
  };

  // The plane of e and corner j of the lower slice, or of the upper one (D3: where corner j below is e's own, in any
  // case of the upper one). What is right of it, and left, is told within the range; what is before that is right, and
  // what is behind is left, whatever rounding says.
  Fan fan_through(std::uint32_t j, bool by_upper, const Range& range) {
    const LateralEdge e = edge(0), f = edge(j);
    const std::uint32_t n = drums().size(drum_);
    const bool is_own_below = f.begin == drum_ && f.low == e.low;
    const std::size_t end = by_upper || is_own_below ? 1 : 0, other = 1 - end;
    const auto slice_at = [&](std::size_t s) { return drum_ + static_cast<std::uint32_t>(s); };
    const Vector from = body_.at(body_.corner(e, slice_at(end)));
    const Vector outwards = scaled_to_one(minus(body_.at(body_.corner(f, slice_at(end))), from));
    const Vector up = scaled_to_one(minus(body_.at(e.high), body_.at(e.low)));
    Fan fan;
    fan.normal = scaled_to_one(cross_of<Real>(outwards, up));
    const Form t = frame_p_.form<Real>(fan.normal, minus(base_p_, body_.at(e.low)));
    const auto are_one = [&](std::size_t s, const LateralEdge& g, const LateralEdge& h) {
      return s == 0 ? g.begin == drum_ && h.begin == drum_ && g.low == h.low
                    : g.end == drum_ + 1 && h.end == drum_ + 1 && g.high == h.high;
    };
    const auto keep_in_range = [&](std::size_t s, std::uint32_t last_right, std::uint32_t first_left) {
      fan.last_right[s] = std::clamp(last_right, range.first[s] - 1, range.last[s]);
      fan.first_left[s] = std::clamp(first_left, range.first[s], range.last[s] + 1);
    };
    // The plane goes through corner j of slice s, and through those that are one with it.
    const auto goes_through = [&](std::size_t s) {
      if (are_one(s, f, e)) return keep_in_range(s, j - 1, j + 1);
      const auto is_one = [&](std::uint32_t k) { return are_one(s, f, edge(k)); };
      keep_in_range(s, planar::first_where(1, j, is_one) - 1,
                    planar::first_where(j + 1, n, [&](std::uint32_t k) { return !is_one(k); }));
    };
    goes_through(end);
    // On the other slice, too, where corner j below is e's own, and beside a facet of e, which is in the plane.
    const bool through_both = is_own_below || j == 1 || j == n - 1;
    if (through_both) {
      goes_through(other);
    } else {
      // t turns from one sign to the other; it points outwards x up, to the right where the pose does not reflect.
      const bool left_is_positive = frame_p_.reflects();
      const std::uint32_t first_left =
          planar::first_where(range.first[other], range.last[other] + 1, [&](std::uint32_t k) {
            const LateralEdge& g = edge(k);
            const Real value = body_.value_at(t, g, slice_at(are_one(other, g, e) ? end : other));
            return left_is_positive ? value > Real(0) : value < Real(0);
          });
      keep_in_range(other, first_left - 1, first_left);
    }
    make_polygon(fan, t, end, j, through_both);
    return fan;
  }

  void make_polygon(Fan& fan, const Form& t, std::size_t end, std::uint32_t j, bool through_both) {
    const std::uint32_t n = drums().size(drum_);
    const LateralEdge e = edge(0);
    CutPolygon<Real>& polygon = fan.polygon;
    polygon.t = t;
    polygon.drum = drum_;
    std::array<Mean<Real>, 2> own, &across = fan.across;
    for (std::size_t s = 0; s < 2; ++s) {
      const std::uint32_t slice = drum_ + static_cast<std::uint32_t>(s);
      own[s] = body_.corner(e, slice);
      if (s == end || through_both) {
        across[s] = body_.corner(edge(j), slice);
      } else {
        across[s] =
            body_.crossing(t, edge(fan.last_right[s]), edge(fan.first_left[s] < n ? fan.first_left[s] : 0), slice);
      }
    }
    const auto is_same = [&](std::size_t s) {
      const Vector p = body_.at(own[s]), q = body_.at(across[s]);
      const auto equal = [](const Real& x, const Real& y) { return !(x < y) && !(y < x); };
      return equal(p.x, q.x) && equal(p.y, q.y) && equal(p.z, q.z);
    };
    polygon.add_head(own[0]);
    if (!is_same(0)) polygon.add_head(across[0]);
    if (!is_same(1)) polygon.add_tail(across[1]);
    polygon.add_tail(own[1]);
    polygon.line_to_first = std::array{e.low, e.high};
    if (fan.first_left[0] <= fan.last_right[1]) {
      polygon.first = fan.first_left[0];
      polygon.run = fan.last_right[1] - fan.first_left[0] + 1;
    } else if (fan.first_left[1] <= fan.last_right[0]) {
      polygon.first = fan.last_right[0];
      polygon.run = fan.last_right[0] - fan.first_left[1] + 1;
      polygon.forward = false;
    }
  }

  // What is beyond the plane is, at each height of the drum, within the same run of lateral edges and the two sides
  // beside it (D4). False where there is nothing.
  bool find_extent(Support& support) const {
    const std::uint32_t n = drums().size(drum_);
    const Point3 normal = rounded(support.beyond.normal);
    const std::uint32_t furthest = search_p_.furthest_edge(drum_, normal);
    const std::uint32_t opposite = search_p_.furthest_edge(drum_, negated(normal));
    const std::uint32_t middle = (furthest + n - opposite) % n;  // counted from the opposite edge
    std::uint32_t from = n, to = 0;
    for (const std::uint32_t slice : {drum_, drum_ + 1}) {
      const auto is_beyond = [&](std::uint32_t k) {
        return !(body_.value_at(support.beyond, edge((opposite + k) % n), slice) < Real(-noise));
      };
      if (!is_beyond(middle)) continue;
      from = std::min(from, planar::first_where(0, middle, is_beyond));
      to = std::max(to, planar::first_where(middle + 1, n, [&](std::uint32_t k) { return !is_beyond(k); }));
    }
    if (from == n) return false;
    // Between edges from - 1 and to, counted from the opposite one.
    const std::uint32_t e = (n - opposite) % n;
    if (from > 0 && (e < from || e >= to)) {
      const std::uint32_t by = e < from ? 0 : n;
      support.extent = std::array<std::uint32_t, 2>{from - 1 + by - e, to + by - e};
    }
    return true;
  }

  // Is what is left of P beyond T_Q right of the plane?
  End ask_fan(Fan& fan, const Holds& holds, bool& is_right) {
    for (const std::optional<Support>& kept : kept_) {
      if (!kept || !kept->extent) continue;
      const auto [from, to] = *kept->extent;
      is_right = to <= std::min(fan.last_right[0], fan.last_right[1]);
      if (!is_right && from < std::max(fan.first_left[0], fan.first_left[1])) continue;
      fan.support = kept;
      return End::goes_on;
    }
    Support support;
    const Vector normal = fan.normal;
    const End end = ask(normal, body_.at(fan.polygon.head[0]), fan.polygon, holds, support);
    if (end != End::goes_on) return end;
    (void)find_extent(support);
    fan.support = support;
    const std::uint32_t k = search_p_.furthest_edge(drum_, rounded(support.beyond.normal));
    const LateralEdge e = edge(k);
    const Real low = body_.value_at(support.beyond, e, drum_), high = body_.value_at(support.beyond, e, drum_ + 1);
    const std::size_t s = high > low ? 1 : 0;
    if ((s == 1 ? high : low) < Real(-noise)) {
      keep(support, last);
      return End::parted;
    }
    is_right = k <= fan.last_right[s];
    return k > 0 && (is_right || k >= fan.first_left[s]) ? End::goes_on : End::stuck;
  }

  // Steps 2 and 3.
  End to_wedge(const Holds& holds) {
    const std::uint32_t n = drums().size(drum_);
    const std::array<std::uint32_t, 2> all{n - 1, n - 1};
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      if (!kept_[k] || find_extent(*kept_[k])) continue;
      newest_ = k;
      return End::parted;
    }
    a_ = fan_through(1, false, {{1, 1}, all});
    b_ = fan_through(n - 1, false, {a_.first_left, all});
    for (const std::size_t s : {0u, 1u}) {
      while (a_.first_left[s] <= b_.last_right[s]) {
        const std::uint32_t low = a_.first_left[s], high = b_.last_right[s];
        Fan fan = fan_through(low + (high - low) / 2, s == 1, {a_.first_left, b_.last_right});
        bool is_right = false;
        if (const End end = ask_fan(fan, holds, is_right); end != End::goes_on) return end;
        if (is_right) {
          b_ = fan;
          keep(*fan.support, left);
        } else {
          a_ = fan;
          keep(*fan.support, right);
        }
      }
    }
    return End::goes_on;
  }

  // Lateral edge s of the wedge, counted from the bottom, 1 .. edges_; 0 and edges_ + 1 are its ends.
  std::uint32_t wedge_edge(std::uint32_t s) const { return ascends_ ? side_below_ + s : side_below_ - s + 1; }
  Mean<Real> wedge_point(bool of_b, std::uint32_t s) const {
    const Fan& fan = of_b ? b_ : a_;
    if (s == 0) return fan.across[0];
    if (s > edges_) return fan.across[1];
    return body_.crossing(fan.polygon.t, edge(wedge_edge(s)));
  }

  // Steps 4 and 5.
  End to_pyramid(const Holds& holds) {
    side_below_ = a_.first_left[0] - 1;
    const std::uint32_t side_above = a_.first_left[1] - 1;
    SUNDER_REQUIRE(b_.last_right[0] == side_below_ && b_.last_right[1] == side_above);
    ascends_ = side_above >= side_below_;
    edges_ = ascends_ ? side_above - side_below_ : side_below_ - side_above;
    std::uint32_t low = 0, high = edges_ + 1;
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      bool is_above = false;
      if (const End end = ask_triangle(middle, holds, is_above); end != End::goes_on) return end;
      (is_above ? low : high) = middle;
    }
    return ask_rest(low, holds);
  }

  End ask_triangle(std::uint32_t s, const Holds& holds, bool& is_above) {
    const LateralEdge e = edge(wedge_edge(s));
    const Mean<Real> top = body_.corner(edge(0), drum_);
    const Vector x = body_.at(top);
    // Counter-clockwise seen from above: x, A's point, B's point.
    const Vector low = body_.at(e.low), high = body_.at(e.high);
    Vector normal = scaled_to_one(cross_of<Real>(minus(low, x), minus(high, x)));
    const Vector pa = body_.at(wedge_point(false, s)), pb = body_.at(wedge_point(true, s));
    const Vector by_points = cross_of<Real>(minus(pa, x), minus(pb, x));
    if (dot(normal, by_points) < Real(0)) normal = negated(normal);
    CutPolygon<Real> triangle;
    triangle.add_head(top);
    triangle.add_head(wedge_point(false, s), std::array{e.low, e.high});
    triangle.add_head(wedge_point(true, s));
    Support support;
    const auto parts_triangle = [&](const std::optional<Support>& kept) {
      if (!kept) return false;
      const auto is_beside = [&](const Mean<Real>& corner) {
        return body_.value_at(kept->beyond, corner) < Real(-noise);
      };
      return is_beside(triangle.head[0]) && is_beside(triangle.head[1]) && is_beside(triangle.head[2]);
    };
    if (const auto kept = std::find_if(kept_.begin(), kept_.end(), parts_triangle); kept != kept_.end()) {
      support = **kept;
    } else if (const End end = ask(normal, x, triangle, holds, support); end != End::goes_on) {
      return end;
    }
    // The furthest of the wedge's corners, which are on its two planes.
    Real best(-noise);
    bool is_parted = true;
    const auto consider = [&](std::uint32_t at, const Real& value) {
      if (!(value > best)) return;
      best = value;
      is_parted = false;
      is_above = at > s;
    };
    consider(edges_ + 1, body_.value_at(support.beyond, edge(0), drum_ + 1));
    for (const bool of_b : {false, true}) {
      const auto value = [&](std::uint32_t at) { return body_.value_at(support.beyond, wedge_point(of_b, at)); };
      // Up to the top it rises and then falls, or falls and then rises.
      if (value(1) > value(0)) {
        const std::uint32_t at =
            planar::first_where(1, edges_ + 1, [&](std::uint32_t k) { return !(value(k + 1) > value(k)); });
        if (at != s) consider(at, value(at));
      } else {
        consider(0, value(0));
        consider(edges_ + 1, value(edges_ + 1));
      }
    }
    keep(support, is_parted ? last : is_above ? above_triangle : below_triangle);
    return is_parted ? End::parted : End::goes_on;
  }

  // What is left is under one facet, between edges s and s + 1 of the wedge. Its faces that have not been asked about:
  // on that facet, on slices and facets at the ends of the searches.
  End ask_rest(std::uint32_t s, const Holds& holds) {
    const std::uint32_t side = s == 0 ? side_below_ : ascends_ ? wedge_edge(s) : wedge_edge(s) - 1;
    const std::uint32_t f = edge(side).side;
    const auto facet = p_.body.facet(f);
    const auto [u, v, w] = thirds_of(facet);
    const Vector at = body_.at(u), normal = cross_of<Real>(minus(body_.at(v), at), minus(body_.at(w), at));
    const auto line = [&](std::uint32_t of) -> LineOfVertices {
      if (of == 0 || of > edges_) return std::nullopt;
      const LateralEdge e = edge(wedge_edge(of));
      return std::array{e.low, e.high};
    };
    CutPolygon<Real> face;
    face.add_head(wedge_point(false, s), line(s));
    face.add_head(wedge_point(true, s));
    face.add_head(wedge_point(true, s + 1), line(s + 1));
    face.add_head(wedge_point(false, s + 1));
    Support support;
    const End end = ask(normal, at, face, holds, support);
    if (end != End::goes_on) return end;
    if (support.is_beside) {
      // Beyond the facet: then that parts the bodies.
      Proposal p{Proposal::Claim::apart_along_normal_of_b, 0, 3, {u, v, w}, support.claim.near_a, u, {}, {}};
      p.direction = frame_q_.in_world_as_normal(rounded(negated(support.normal)));
      const bool outside = (dot(scaled_to_one(normal), support.normal) > Real(0)) != frame_p_.reflects();
      if (outside && holds(p)) return End::held;
      if (!outside && inside(s, support.claim.near_a, holds)) return End::held;
    }
    keep(support, last);
    for (const Place k : {above_slice, below_slice}) {
      const std::uint32_t slice = k == above_slice ? drum_ : drum_ + 1;
      const auto parts_slice = [&](const std::optional<Support>& kept) { return kept && !reaches(slice, *kept); };
      if (kept_[k] || std::any_of(kept_.begin(), kept_.end(), parts_slice)) continue;
      std::uint32_t beyond = 0;
      const std::size_t newest = newest_;
      if (const End of_slice = ask_slice(slice, holds, beyond); of_slice == End::held || of_slice == End::parted) {
        return of_slice;
      }
      newest_ = newest;
    }
    for (const Place k : {right, left}) {
      if (kept_[k]) continue;
      bool is_right = false;
      Fan& fan = k == right ? a_ : b_;
      const End of_fan = ask_fan(fan, holds, is_right);
      if (of_fan == End::held || of_fan == End::parted) return of_fan;
      if (fan.support) kept_[k] = fan.support;
    }
    return End::parted;
  }

  // Is a vertex of Q in what is left of P?
  bool inside(std::uint32_t s, std::uint32_t vertex, const Holds& holds) {
    const Vector point = at_q(vertex);
    const Mean<Real> x = body_.corner(edge(0), drum_), y = body_.corner(edge(0), drum_ + 1);
    const std::array<Mean<Real>, 4> face{wedge_point(false, s), wedge_point(true, s), wedge_point(true, s + 1),
                                         wedge_point(false, s + 1)};
    const auto in = [&](const Mean<Real>& a, const Mean<Real>& b, const Mean<Real>& c) {
      const Vector p = body_.at(x), u = minus(body_.at(a), p), v = minus(body_.at(b), p), w = minus(body_.at(c), p),
                   d = minus(point, p);
      const Real whole = dot(u, cross_of<Real>(v, w));
      const Real of_u = dot(d, cross_of<Real>(v, w)) / whole, of_v = dot(d, cross_of<Real>(w, u)) / whole,
                 of_w = dot(d, cross_of<Real>(u, v)) / whole, of_p = Real(1) - of_u - of_v - of_w;
      for (const Real& weight : {of_u, of_v, of_w, of_p}) {
        if (weight < Real(0)) return false;
      }
      Mixture<Real> mixture, of_q;  // the face is between two edges: at most six vertices with e's
      of_q.add(vertex, Real(1));
      const auto add = [&](const Mean<Real>& mean, const Real& weight) {
        for (std::size_t i = 0; i < mean.count; ++i) mixture.add(mean.vertex[i], mean.weight[i] * weight);
      };
      add(a, of_u), add(b, of_v), add(c, of_w), add(x, of_p);
      Proposal proposal;
      proposal.near_a = vertex, proposal.near_b = mixture.vertex[0];
      return name_at_most_five(q_, p_, of_q, mixture, false, proposal) && holds(proposal);
    };
    if (in(face[0], face[1], face[2]) || in(face[0], face[2], face[3])) return true;
    return s == edges_ && in(face[3], face[2], y);
  }

  // ---- The certificate of what is apart -----------------------------------------------------------------------------

  // D2: the planes that were kept and vertices of P, as a game.
  bool mix(const Holds& holds) {
    std::array<const Support*, most_kept> support{};
    std::size_t count = 0, newest = 0;
    distinct([&](std::size_t k) {
      if (kept_[newest_] && kept_[k]->number == kept_[newest_]->number) newest = count;
      support[count++] = &*kept_[k];
    });
    if (count == 0) return false;
    std::array<Real, most_kept> weight{};
    weight[newest] = 1;
    MatrixGame<Real, most_in_game> game;
    game.rows = count;
    game.columns = 0;
    while (game.columns < most_in_game) {
      ++cost_.iterations;
      Form g{{Real(0), Real(0), Real(0)}, Real(0)};
      Vector normal{Real(0), Real(0), Real(0)};
      for (std::size_t k = 0; k < count; ++k) {
        const Form& h = support[k]->beyond;
        const Vector& n = support[k]->normal;
        const Real& x = weight[k];
        g = {{g.normal.x + x * h.normal.x, g.normal.y + x * h.normal.y, g.normal.z + x * h.normal.z},
             g.at_base + x * h.at_base};
        const Real y = x * Real(support[k]->by);
        normal = {normal.x + y * n.x, normal.y + y * n.y, normal.z + y * n.z};
      }
      const std::uint32_t v = furthest_vertex(g);
      if (!(g.at(search_p_, v) > Real(0))) {
        if (game.columns == 0 && parts(*support[newest], v, holds)) return true;
        return holds(along(normal, near_of_q(support, weight, count), v));
      }
      for (std::size_t k = 0; k < count; ++k) {
        game.pay[k][game.columns] = -support[k]->beyond.at(search_p_, v);
      }
      ++game.columns;
      if (!game.solve() || !(game.value > Real(0))) return false;
      for (std::size_t k = 0; k < count; ++k) weight[k] = game.row_weight[k];
    }
    return false;
  }

  static std::uint32_t near_of_q(const std::array<const Support*, most_kept>& support,
                                 const std::array<Real, most_kept>& weight, std::size_t count) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < count; ++k) best = weight[k] > weight[best] ? k : best;
    return support[best]->claim.near_a;
  }

  // From Q to P, against the normal.
  Proposal along(const Vector& towards_q, std::uint32_t near_q, std::uint32_t near_p) const {
    const Vector n = scaled_to_one(negated(towards_q));
    Proposal p = apart_along(frame_q_.in_world_as_normal(rounded(n)), near_q, near_p);
    if constexpr (!std::is_same_v<Real, double>) {
      p.claim = Proposal::Claim::apart_along_sum;
      p.direction = frame_q_.in_world_as_normal({n.x.high, n.y.high, n.z.high});
      p.rest = frame_q_.in_world_as_normal({n.x.low, n.y.low, n.z.low});
    }
    return p;
  }

  static constexpr double noise = MatrixGame<Real, 1>::noise;

  const Placed &q_, &p_;
  Cost& cost_;
  DrumSearch search_q_, search_p_;
  ScaledPose frame_q_, frame_p_;
  Point3 from_;
  Vector base_q_;
  DrumsInWorld<Real> body_;
  Vector base_p_;
  SectionProposals proposals_;
  Ways ways_;

  std::uint32_t low_ = 0, high_ = 0;  // slices around what is left
  std::uint32_t drum_ = 0;
  Fan a_, b_;
  std::uint32_t side_below_ = 0, edges_ = 0;
  bool ascends_ = true;
  std::array<std::optional<Support>, most_kept> kept_;
  std::size_t newest_ = last;
  std::uint32_t found_ = 0;  // how many planes were
};

bool propose_by_drums(const Placed& q, const Placed& p, Cost& cost, const Holds& holds) {
  PolyhedraByDrums<double> rough(q, p, cost, {});
  if (rough.propose(holds)) return true;
  return PolyhedraByDrums<DoubleDouble>(q, p, cost, rough.ways()).propose(holds);
}

// About how long the image of a body is.
double size_of(const ConvexPolyhedron& body, const Pose& pose) {
  const auto [low, high] = body.box();
  const std::array<double, 9>& linear = pose.affine().linear;
  double stretch = 0;
  for (const double x : linear) stretch = std::max(stretch, std::fabs(x));
  return stretch * std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

}  // namespace

PairAnswer polyhedron_polyhedron_by_drums(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                          const ConvexPolyhedron& body_b, const Pose& pose_b) {
  const int dimension_a = body_a.dimension(), dimension_b = body_b.dimension();
  if (dimension_a == 3 && dimension_b == 2) return polyhedron_polygon_by_drums(body_a, pose_a, body_b, pose_b);
  if (dimension_a == 2 && dimension_b == 3) {
    return exchanged(polyhedron_polygon_by_drums(body_b, pose_b, body_a, pose_a));
  }
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  if (dimension_a < 3 || dimension_b < 3) return answer_by(a, b, [](const Holds&, Cost&) { return false; });
  // The one with fewer vertices is cut; of two that are next to nothing beside each other, that one: the world is the
  // other one's.
  const double size_a = size_of(body_a, pose_a), size_b = size_of(body_b, pose_b);
  const bool is_a_less = body_a.vertices().size() < body_b.vertices().size();
  const bool cuts_a = size_a < size_b * 0x1p-30 || (is_a_less && !(size_b < size_a * 0x1p-30));
  return answer_by(a, b, [&](const Holds& holds, Cost& cost) {
    const auto propose_of = [&](const Placed& p, const Placed& q, const Holds& of) {
      const auto of_exchanged = [&](const Proposal& proposal) { return of(exchanged(proposal)); };
      return cuts_a ? propose_by_drums(q, p, cost, of_exchanged) : propose_by_drums(p, q, cost, of);
    };
    return propose_axis_scaled_where_wanted(a, b, holds, propose_of);
  });
}

}  // namespace sunder::solid
