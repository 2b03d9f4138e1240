// Algorithm IHG: the section Q of a body by a plane T against a convex polygon R in T, whatever gives R's vertices; in
// floating point: nothing here decides anything. (1) Is the body beside T (IHP)? (2) T between two slices: Q against R.
// (3) W against R, W the polygon inside of Q whose corners are on slices. (4) Where a line parts these, it touches W at
// a corner or a side, and R meets Q only in the pockets beside it: these against R. Source: CD87 section 3.4, Lemma 9,
// Theorem 10.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/planar/pair/minkowski_difference_search.h>
#include <sunder/solid/search/caratheodory.h>
#include <sunder/solid/search/placed.h>
#include <sunder/solid/search/proposal.h>
#include <sunder/solid/section/scaled_pose.h>
#include <sunder/solid/section/section_polygons.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

namespace sunder::solid {

// Weights of up to three points of the plane whose mean is p; all of one kind.
template <class Real>
std::array<Real, 3> weights_around(const RoundedPoint<Real>& p, const std::array<RoundedPoint<Real>, 3>& at,
                                   std::size_t count) {
  const auto minus = [](const auto& a, const auto& b) { return RoundedPoint<Real>{a.x - b.x, a.y - b.y}; };
  const auto cross = [](const auto& a, const auto& b) -> Real { return a.x * b.y - a.y * b.x; };
  if (count == 1) return {1, 0, 0};
  const auto u = minus(at[1], at[0]), w = minus(p, at[0]);
  if (count == 2) {
    const Real length2 = u.x * u.x + u.y * u.y;
    const Real t = length2 > Real(0) ? (u.x * w.x + u.y * w.y) / length2 : Real(0);
    return {Real(1) - t, t, 0};
  }
  const auto v = minus(at[2], at[0]);
  const Real whole = cross(u, v);
  if (!(whole > Real(0)) && !(whole < Real(0))) return {1, 0, 0};  // too small to be told apart
  const Real of_1 = cross(w, v) / whole, of_2 = cross(u, w) / whole;
  return {Real(1) - of_1 - of_2, of_1, of_2};
}

// Some corners of a polygon, named by their indices, and what they weigh in a mean.
template <class Real>
struct WeighedCorners {
  std::span<const std::uint32_t> index;
  std::array<RoundedPoint<Real>, 3> at{};
  std::array<Real, 3> weight{};

  template <class Polygon>
  WeighedCorners(const Polygon& polygon, std::span<const std::uint32_t> some) : index(some) {
    for (std::size_t k = 0; k < index.size(); ++k) at[k] = polygon[index[k]];
  }
  // The mean, of the polygon's body's vertices.
  template <class Polygon>
  Mixture<Real> mixture(const Polygon& polygon) const {
    Mixture<Real> result;
    for (std::size_t k = 0; k < index.size(); ++k) {
      polygon.add_parts(index[k], [&](std::uint32_t v, const Real& w) { result.add(v, weight[k] * w); });
    }
    return result;
  }
};

// Weights whose means are one common point.
template <class Real>
void weigh_common_point(WeighedCorners<Real>& a, WeighedCorners<Real>& b) {
  RoundedPoint<Real> at = b.index.size() == 1 ? b.at[0] : a.at[0];
  if (a.index.size() == 2 && b.index.size() == 2) {
    const auto &p = a.at[0], &q = a.at[1], &r = b.at[0], &s = b.at[1];
    const Real across = (q.x - p.x) * (s.y - r.y) - (q.y - p.y) * (s.x - r.x);
    const bool is_told = across > Real(0) || across < Real(0);
    const Real t = is_told ? ((r.x - p.x) * (s.y - r.y) - (r.y - p.y) * (s.x - r.x)) / across : Real(0);
    at = {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  }
  for (WeighedCorners<Real>* corners : {&a, &b}) {
    corners->weight = weights_around(at, corners->at, corners->index.size());
  }
}

// Its vertex of the greatest weight.
template <class Real>
Mixture<Real> heaviest_of(const Mixture<Real>& mixture) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < mixture.count; ++k) best = mixture.weight[k] > mixture.weight[best] ? k : best;
  Mixture<Real> one;
  one.add(mixture.vertex[best], Real(1));
  return one;
}

// Proposes that what these means have in common is a common point of a and b. True where it holds.
template <class Real>
bool propose_common_mean(const Placed& a, const Mixture<Real>& in_a, const Placed& b, const Mixture<Real>& in_b,
                         const Holds& holds) {
  const auto try_these = [&](const Mixture<Real>& some_of_a, const Mixture<Real>& some_of_b, bool drop_negligible) {
    Proposal p;
    p.near_a = some_of_a.vertex[0], p.near_b = some_of_b.vertex[0];
    return name_at_most_five(a, b, some_of_a, some_of_b, drop_negligible, p) && holds(p);
  };
  if (try_these(in_a, in_b, false) || try_these(in_a, in_b, true)) return true;
  // Where one body is next to nothing beside the other, any of its vertices will do.
  return (in_b.count > 1 && try_these(in_a, heaviest_of(in_b), false)) ||
         (in_a.count > 1 && try_these(heaviest_of(in_a), in_b, false));
}

// Proposes that a common point of two such polygons is one of a and b. True where it holds.
template <class Real, class A, class B>
bool propose_common_point(const Placed& a, const A& of_a, const Placed& b, const B& of_b, const CommonVertices& found,
                          const Holds& holds) {
  const std::span<const std::uint32_t> all(found.vertices);
  WeighedCorners<Real> in_a(of_a, all.first(found.count_a)), in_b(of_b, all.subspan(found.count_a, found.count_b));
  weigh_common_point(in_a, in_b);
  return propose_common_mean(a, in_a.mixture(of_a), b, in_b.mixture(of_b), holds);
}

// Is a point on a segment, or next to it, as rounding sees it? Where it is next to one of the ends only, that one is
// named alone.
template <class Real>
struct NextToSegment {
  bool is_next = false;
  std::array<bool, 2> has{true, true};  // the ends that are wanted

  NextToSegment(const RoundedPoint<Real>& p, const RoundedPoint<Real>& a, const RoundedPoint<Real>& b,
                double distance) {
    const double ux = nearest(b.x - a.x), uy = nearest(b.y - a.y), wx = nearest(p.x - a.x), wy = nearest(p.y - a.y);
    const double length = std::hypot(ux, uy);
    const double along = length > 0 ? (ux * wx + uy * wy) / length : 0;
    if (!(along > -distance && along < length + distance)) return;
    if (along < distance || along > length - distance) {
      has = {along < distance, !(along < distance)};
      is_next = std::hypot(wx - (has[1] ? ux : 0), wy - (has[1] ? uy : 0)) < distance;
    } else {
      is_next = std::fabs(nearest((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x))) < distance * length;
    }
  }
};

// Two such polygons that a line parts by no more than rounding: calls take(certificate) with what they may touch in, a
// vertex of one and a vertex or a side of the other, until it returns true. Returns whether it did.
template <class Real, class A, class B, class Take>
bool find_touch(const A& a, const B& b, const Separation& parted, double distance, const Take& take) {
  const auto after = [](std::uint32_t k, std::uint32_t n) { return k + 1 < n ? k + 1 : 0; };
  const auto before = [](std::uint32_t k, std::uint32_t n) { return k > 0 ? k - 1 : n - 1; };
  // The side that parts them, if it is one's own, else the two sides at the vertex that is nearest.
  const auto sides_of = [&](bool has_side, std::uint32_t extreme, std::uint32_t n) {
    const std::uint32_t j = parted.direction.index[0];
    return has_side ? std::array{j, j} : std::array{before(extreme, n), extreme};
  };
  const std::array<std::uint32_t, 2> sides_a =
      sides_of(parted.direction.kind == Direction::Kind::side_of_a, parted.extreme_a, a.size());
  const std::array<std::uint32_t, 2> sides_b =
      sides_of(parted.direction.kind == Direction::Kind::side_of_b, parted.extreme_b, b.size());
  const auto touch = [&](const auto& p, std::uint32_t v, const auto& q, std::uint32_t side, bool p_is_a) {
    const std::uint32_t end = after(side, q.size());
    const NextToSegment<Real> next(p[v], q[side], q[end], distance);
    if (!next.is_next) return false;
    const std::uint8_t ends = static_cast<std::uint8_t>(next.has[0] && next.has[1] ? 2 : 1);
    CommonVertices found;
    found.count_a = p_is_a ? 1 : ends;
    found.count_b = p_is_a ? ends : 1;
    std::size_t count = 0;
    if (p_is_a) found.vertices[count++] = v;
    if (next.has[0]) found.vertices[count++] = side;
    if (next.has[1]) found.vertices[count++] = end;
    if (!p_is_a) found.vertices[count++] = v;
    return take(found);
  };
  for (const std::uint32_t i : sides_a) {
    for (const std::uint32_t j : sides_b) {
      for (const std::uint32_t v : {i, after(i, a.size())}) {
        if (touch(a, v, b, j, true)) return true;
      }
      for (const std::uint32_t v : {j, after(j, b.size())}) {
        if (touch(b, v, a, i, false)) return true;
      }
    }
  }
  return false;
}

// Proposes what two such polygons may touch in, where the line that parts them is a matter of rounding.
template <class Real, class A, class B>
bool propose_touch(const Placed& a, const A& of_a, const Placed& b, const B& of_b, const Separation& parted,
                   const Holds& holds) {
  constexpr double distance = std::is_same_v<Real, double> ? 0x1p-40 : 0x1p-90;  // bodies are about 1 long here
  return find_touch<Real>(of_a, of_b, parted, distance, [&](const CommonVertices& found) {
    return propose_common_point<Real>(a, of_a, b, of_b, found, holds);
  });
}

// Three vertices of a facet that are far from each other.
inline std::array<std::uint32_t, 3> thirds_of(std::span<const std::uint32_t> facet) {
  const std::size_t n = facet.size();
  return {facet[0], facet[std::max<std::size_t>(1, n / 3)], facet[std::max<std::size_t>(2, 2 * n / 3)]};
}

// A vector with its greatest component between 1 and 2.
template <class Vector>
Vector scaled_to_one(const Vector& n) {
  const Point3 size = rounded(n);
  const double greatest = std::max({std::fabs(size.x), std::fabs(size.y), std::fabs(size.z)});
  const double by = greatest > 0 && std::isfinite(greatest) ? std::ldexp(1.0, -std::ilogb(greatest)) : 1.0;
  return {scaled(n.x, by), scaled(n.y, by), scaled(n.z, by)};
}

template <class Real>
VectorOf<Real> cross_of(const VectorOf<Real>& a, const VectorOf<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Real>
class SectionAgainst {
 public:
  using Vector = VectorOf<Real>;

  // T: of the body's scaled world (frame), where points are counted from one of them, by its normal and one of its
  // points; `base`: where the drums' Drums::vertex_of(0) is. Keeps references to the search and the cost.
  SectionAgainst(const DrumSearch& search, const ScaledPose& frame, const Vector& base, const Vector& normal,
                 const Vector& point, Cost& cost)
      : search_(search), cost_(cost), t_(frame.form<Real>(normal, minus(base, point))) {
    const Point3 n = rounded(normal);
    std::size_t k = 0;
    for (const std::size_t i : {1u, 2u}) k = std::fabs(n[i]) > std::fabs(n[k]) ? i : k;
    // So that the section runs counter-clockwise in them.
    axes_ = {(k + 1) % 3, (k + 2) % 3};
    if ((n[k] > 0) == frame.reflects()) std::swap(axes_[0], axes_[1]);
    const auto along = [&](std::size_t axis) {
      return frame.form<Real>({Real(axis == 0 ? 1 : 0), Real(axis == 1 ? 1 : 0), Real(axis == 2 ? 1 : 0)}, base);
    };
    coordinates_ = {along(axes_[0]), along(axes_[1])};
  }

  // The axes of the world that are coordinates in T. A polygon that runs counter-clockwise there, seen from the tip of
  // the normal, does so in them where the pose does not reflect.
  const std::array<std::size_t, 2>& axes() const { return axes_; }

  // Calls one of these, and returns what it does. R's vertices are RoundedPoint, its parts those of another body.
  //   found.beside(v, is_above): all of the body is on one side of T; v is nearest to it.
  //   found.meet(q, certificate): a sequence of the body's, Q or W, meets R in vertices of both.
  //   found.parted(q, certificate): Q is parted from R by a side of either.
  template <class R, class Found>
  auto run(const R& r, const Found& found) const {
    SectionSearch<Real> section(search_, t_);
    const bool starts_above = section.value_at(t_, search_.drums().vertex_of(0)) > Real(0);
    const auto is_beyond = [&](std::uint32_t v) {
      const Real value = section.value_at(t_, v);
      return starts_above ? !(value > Real(0)) : !(value < Real(0));
    };
    const std::uint32_t beyond =
        search_.furthest_vertex<Real>(starts_above ? negated(t_.normal) : t_.normal, is_beyond);
    if (!is_beyond(beyond)) return found.beside(beyond, starts_above);
    section.find_corners(beyond);
    if (!section.meets_slices()) return in_pockets(section, 0, 1, r, found);
    const CornerSequence<Real> w(section, coordinates_);
    const PairCertificate of_w = meet_or_part(w, r);
    if (const auto* common = std::get_if<CommonVertices>(&of_w)) return found.meet(w, *common);
    const auto& [direction, extreme_a, extreme_b] = std::get<Separation>(of_w);
    const bool by_side = direction.kind == Direction::Kind::side_of_a;
    const auto pockets = by_side ? w.behind(direction.index[0]) : w.beside(extreme_a);
    return in_pockets(section, pockets.begin, pockets.count, r, found);
  }

 private:
  template <class R, class Found>
  auto in_pockets(const SectionSearch<Real>& section, std::uint32_t begin, std::uint32_t count, const R& r,
                  const Found& found) const {
    const PocketSequence<Real> q(section, coordinates_, begin, count);
    const PairCertificate certificate = meet_or_part(q, r);
    const auto* common = std::get_if<CommonVertices>(&certificate);
    return common != nullptr ? found.meet(q, *common) : found.parted(q, std::get<Separation>(certificate));
  }

  template <class A, class B>
  PairCertificate meet_or_part(const A& a, const B& b) const {
    PairCertificate certificate;
    StageTally tally;
    Cost steps;
    (void)planar::search_difference(a, 0, b, 0, certificate, steps, tally);
    cost_.iterations += steps.iterations;
    return certificate;
  }

  const DrumSearch& search_;
  Cost& cost_;
  LinearForm<Real> t_;
  std::array<std::size_t, 2> axes_{};
  Coordinates<Real> coordinates_{};
};

// What parts a section of A from a polygon of B, as proposals with features of both.
class SectionProposals {
 public:
  explicit SectionProposals(const Placed& a) : a_(a) {}

  // In the plane of a facet of A. near: a vertex of B that should be nearest.
  Proposal beyond_facet(std::uint32_t f, std::uint32_t near) const {
    const auto thirds = thirds_of(a_.body.facet(f));
    Proposal p{Proposal::Claim::apart_along_normal_of_a, 3, 0, {}, thirds[0], near, outwards(thirds[0]), {}};
    std::copy(thirds.begin(), thirds.end(), p.vertices.begin());
    return p;
  }
  // Along an edge of A and two vertices of B.
  Proposal beyond_edge(const std::array<std::uint32_t, 2>& e, const std::array<std::uint32_t, 2>& side,
                       std::uint32_t near) const {
    Proposal p{Proposal::Claim::apart_along_edge_x_edge, 2, 2, {}, e[0], near, outwards(e[0]), {}};
    p.vertices = {e[0], e[1], side[0], side[1]};
    return p;
  }

 private:
  // From the middle of the body to a vertex: outwards, for directions that need a sense only.
  Point3 outwards(std::uint32_t v) const {
    const Point3 way = minus(a_.graph.vertices[v], a_.graph.middle);
    return a_.turned<double>(way, scale_to_one(std::max({std::fabs(way.x), std::fabs(way.y), std::fabs(way.z)})));
  }

  const Placed& a_;
};

}  // namespace sunder::solid
