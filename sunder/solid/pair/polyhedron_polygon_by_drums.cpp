// Algorithm IHG: R is the polygon, T its plane, Q the section of the body P by T, W the polygon inside of Q whose
// corners are on slices. (1) Is P beside T (IHP)? (2) T between two slices: Q against R. (3) W against R. (4) Where a
// line parts these, it touches W at a corner or a side, and R meets Q only in the pockets beside it: these against R.
// What parts them is a side of Q, which is in a facet of P, and then the facet's plane does; or a side of R at a vertex
// of Q, which is on an edge of P: then the plane along both does (Lemma 12, its first case).
#include <sunder/planar/pair/minkowski_difference_search.h>
#include <sunder/solid/pair/caratheodory.h>
#include <sunder/solid/pair/polyhedron_polygon.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/pair/scaled_pose.h>
#include <sunder/solid/pair/section_polygons.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace sunder::solid {

namespace {

// Weights of up to three points of the plane whose mean is p; all of one kind.
template <class Real>
std::array<Real, 3> weights_around(const RoundedPoint<Real>& p, const std::array<RoundedPoint<Real>, 3>& at,
                                   std::size_t count) {
  const auto minus = [](const auto& a, const auto& b) { return RoundedPoint<Real>{a.x - b.x, a.y - b.y}; };
  const auto cross = [](const auto& a, const auto& b) -> Real { return a.x * b.y - a.y * b.x; };
  if (count == 1) return {1, 0, 0};
  const auto u = minus(at[1], at[0]), w = minus(p, at[0]);
  if (count == 2) {
    const Real t = (u.x * w.x + u.y * w.y) / (u.x * u.x + u.y * u.y);
    return {Real(1) - t, t, 0};
  }
  const auto v = minus(at[2], at[0]);
  const Real whole = cross(u, v), of_1 = cross(w, v) / whole, of_2 = cross(u, w) / whole;
  return {Real(1) - of_1 - of_2, of_1, of_2};
}

template <class Real>
class PolygonByDrums {
 public:
  PolygonByDrums(const Placed& body, const Placed& polygon, Cost& cost)
      : body_(body),
        polygon_(polygon),
        cost_(cost),
        drums_(body.body.drums()),
        search_(drums_, body.body.vertices(), cost),
        frame_(body.pose, drums_.shrink()) {
    const std::span<const std::uint32_t> cycle = polygon.body.facet(0);
    const std::size_t n = cycle.size();
    thirds_ = {cycle[0], cycle[std::max<std::size_t>(1, n / 3)], cycle[std::max<std::size_t>(2, 2 * n / 3)]};
    const auto image = rounded_image(polygon[thirds_[0]]);
    from_ = {image.x, image.y, image.z};
    const auto way = [&](std::uint32_t v) {
      return frame_.way_to_image<Real>(from_, polygon.pose, polygon.graph.vertices[v]);
    };
    const auto r = way(thirds_[0]);
    normal_ = scaled(cross(minus(way(thirds_[1]), r), minus(way(thirds_[2]), r)));
    const auto away = frame_.way_to_image<Real>(from_, search_.vertex(drums_.vertex_of(0)));
    t_ = frame_.form<Real>(normal_, minus(away, r));
    choose_coordinates(away);
  }

  template <class Holds>
  bool propose(const Holds& holds) const {
    SectionSearch<Real> section(search_, t_);
    const std::uint32_t first = drums_.vertex_of(0);
    const bool starts_above = section.value_at(t_, first) > Real(0);
    const auto is_beyond = [&](std::uint32_t v) {
      const Real value = section.value_at(t_, v);
      return starts_above ? !(value > Real(0)) : !(value < Real(0));
    };
    const std::uint32_t beyond =
        search_.furthest_vertex<Real>(starts_above ? negated(t_.normal) : t_.normal, is_beyond);
    if (!is_beyond(beyond)) return holds(beside(beyond, starts_above));
    section.find_corners(beyond);
    const FlatSequence<Real> r(polygon_, frame_, from_, x_, y_, turned_, cost_);
    if (!section.meets_slices()) return in_pockets(section, 0, 1, r, holds);
    const CornerSequence<Real> w(section, coordinates_);
    const PairCertificate found = meet_or_part(w, r);
    if (found.verdict == Verdict::meet) return meet(w, r, found, holds);
    const bool by_side = found.direction.kind == Direction::Kind::side_of_a;
    const auto pockets = by_side ? w.behind(found.direction.index[0]) : w.beside(found.extreme_a);
    return in_pockets(section, pockets.begin, pockets.count, r, holds);
  }

 private:
  static VectorOf<Real> minus(const VectorOf<Real>& a, const VectorOf<Real>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  static VectorOf<Real> cross(const VectorOf<Real>& a, const VectorOf<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  static VectorOf<Real> scaled(const VectorOf<Real>& n) {
    const Point3 size = rounded(n);
    const double greatest = std::max({std::fabs(size.x), std::fabs(size.y), std::fabs(size.z)});
    const Real by(greatest > 0 && std::isfinite(greatest) ? std::ldexp(1.0, -std::ilogb(greatest)) : 1.0);
    return {n.x * by, n.y * by, n.z * by};
  }

  // Two axes of the world, so that the section runs counter-clockwise in them.
  void choose_coordinates(const VectorOf<Real>& away) {
    const Point3 n = rounded(normal_);
    std::size_t k = 0;
    for (const std::size_t i : {1u, 2u}) k = std::fabs(n[i]) > std::fabs(n[k]) ? i : k;
    x_ = (k + 1) % 3, y_ = (k + 2) % 3;
    const bool polygon_turns_left = n[k] > 0;
    const bool swapped = polygon_turns_left == frame_.reflects();
    if (swapped) std::swap(x_, y_);
    turned_ = polygon_turns_left == swapped;
    const auto along = [&](std::size_t axis) {
      return frame_.form<Real>({Real(axis == 0 ? 1 : 0), Real(axis == 1 ? 1 : 0), Real(axis == 2 ? 1 : 0)}, away);
    };
    coordinates_ = {along(x_), along(y_)};
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

  // All of the body is on one side of T.
  Proposal beside(std::uint32_t v, bool is_above) const {
    Proposal p{Proposal::Claim::apart_along_normal_of_b, 0, 3, {}, v, thirds_[0], {}, {}};
    std::copy(thirds_.begin(), thirds_.end(), p.vertices.begin());
    p.direction = frame_.in_world_as_normal(rounded(is_above ? negated(normal_) : normal_));
    return p;
  }

  template <class Sequence, class Holds>
  bool meet(const Sequence& q, const FlatSequence<Real>& r, const PairCertificate& found, const Holds& holds) const {
    std::array<RoundedPoint<Real>, 3> of_q{}, of_r{};
    const std::size_t count_q = found.count_a, count_r = found.count_b;
    for (std::size_t k = 0; k < count_q; ++k) of_q[k] = q[found.vertices[k]];
    for (std::size_t k = 0; k < count_r; ++k) of_r[k] = r[found.vertices[count_q + k]];
    RoundedPoint<Real> at = count_r == 1 ? of_r[0] : of_q[0];
    if (count_q == 2 && count_r == 2) {
      const auto& [a, b, unused_a] = of_q;
      const auto& [c, d, unused_c] = of_r;
      const Real across = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
      const Real t = ((c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x)) / across;
      at = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    }
    const auto weights_q = weights_around(at, of_q, count_q), weights_r = weights_around(at, of_r, count_r);
    Mixture<Real> mixture_q, mixture_r;
    for (std::size_t k = 0; k < count_q; ++k) {
      q.add_parts(found.vertices[k], [&](std::uint32_t v, const Real& w) { mixture_q.add(v, weights_q[k] * w); });
    }
    for (std::size_t k = 0; k < count_r; ++k) mixture_r.add(r.vertex(found.vertices[count_q + k]), weights_r[k]);
    Proposal p;
    p.near_a = mixture_q.vertex[0], p.near_b = mixture_r.vertex[0];
    return (name_at_most_five(body_, polygon_, mixture_q, mixture_r, false, p) && holds(p)) ||
           (name_at_most_five(body_, polygon_, mixture_q, mixture_r, true, p) && holds(p));
  }

  template <class Holds>
  bool in_pockets(const SectionSearch<Real>& section, std::uint32_t begin, std::uint32_t count,
                  const FlatSequence<Real>& r, const Holds& holds) const {
    const PocketSequence<Real> q(section, coordinates_, begin, count);
    const PairCertificate found = meet_or_part(q, r);
    if (found.verdict == Verdict::meet) return meet(q, r, found, holds);
    const std::uint32_t n = q.size();
    const auto by_side = [&](std::uint32_t k, std::uint32_t near) {
      const std::optional<std::uint32_t> facet = q.facet_behind(k);
      return facet && holds(beyond_facet(*facet, near));
    };
    if (found.direction.kind == Direction::Kind::side_of_a) {
      return by_side(found.direction.index[0], r.vertex(found.extreme_b));
    }
    const std::uint32_t k = found.extreme_a, j = found.direction.index[0], near = r.vertex(found.extreme_b);
    if (found.direction.kind == Direction::Kind::side_of_b) {
      const std::optional<std::array<std::uint32_t, 2>> e = q.edge_at(k);
      const std::array<std::uint32_t, 2> side{r.vertex(j), r.vertex(j + 1 < r.size() ? j + 1 : 0)};
      if (e && holds(beyond_edge(*e, side))) return true;
    }
    return by_side(k, near) || by_side(k > 0 ? k - 1 : n - 1, near) ||
           holds(apart_at_vertices(vertex_near(q, k), near));
  }

  std::uint32_t vertex_near(const PocketSequence<Real>& q, std::uint32_t k) const {
    std::uint32_t near = 0;
    q.add_parts(k, [&](std::uint32_t v, const Real& w) { near = w > Real(0.5) ? v : near; });
    return near;
  }

  // From the middle of the body to a vertex: outwards, for directions that need a sense only.
  Point3 outwards(std::uint32_t v) const {
    const SearchGraph& graph = body_.graph;
    const Point3 way = solid::minus(graph.vertices[v], graph.middle);
    return body_.turned<double>(way, scale_to_one(std::max({std::fabs(way.x), std::fabs(way.y), std::fabs(way.z)})));
  }
  Proposal beyond_facet(std::uint32_t f, std::uint32_t near) const {
    const std::span<const std::uint32_t> facet = body_.body.facet(f);
    const std::size_t n = facet.size();
    Proposal p{Proposal::Claim::apart_along_normal_of_a, 3, 0, {}, facet[0], near, outwards(facet[0]), {}};
    p.vertices = {facet[0], facet[std::max<std::size_t>(1, n / 3)], facet[std::max<std::size_t>(2, 2 * n / 3)]};
    return p;
  }
  Proposal beyond_edge(const std::array<std::uint32_t, 2>& e, const std::array<std::uint32_t, 2>& side) const {
    Proposal p{Proposal::Claim::apart_along_edge_x_edge, 2, 2, {}, e[0], side[0], outwards(e[0]), {}};
    p.vertices = {e[0], e[1], side[0], side[1]};
    return p;
  }

  const Placed &body_, &polygon_;
  Cost& cost_;
  const Drums& drums_;
  DrumSearch search_;
  ScaledPose frame_;
  std::array<std::uint32_t, 3> thirds_{};
  Point3 from_;
  VectorOf<Real> normal_{};
  LinearForm<Real> t_{};
  std::size_t x_ = 0, y_ = 1;
  bool turned_ = false;
  Coordinates<Real> coordinates_{};
};

}  // namespace

PairAnswer polyhedron_polygon_by_drums(const ConvexPolyhedron& body, const Pose& pose,  //
                                       const ConvexPolyhedron& polygon, const Pose& pose_of_polygon) {
  if (body.dimension() < 3 || polygon.dimension() != 2) {
    return polyhedron_polyhedron(body, pose, polygon, pose_of_polygon);
  }
  const Placed a(body, pose), b(polygon, pose_of_polygon);
  return answer_by(a, b, [&](const auto& holds, Cost& cost) {
    return PolygonByDrums<double>(a, b, cost).propose(holds) || PolygonByDrums<DoubleDouble>(a, b, cost).propose(holds);
  });
}

}  // namespace sunder::solid
