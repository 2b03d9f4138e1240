// What a search for bodies with a radius proposes, and how it is disposed of. For the sources of solid/round.
#pragma once

#include <sunder/solid/pair/extreme_vertex.h>
#include <sunder/solid/round/round_finish.h>
#include <sunder/solid/round/round_round.h>
#include <sunder/solid/round/round_search.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace sunder::solid {

namespace round_detail {

inline WeightedPoint weighted(const PlacedRound& body, const RoundCombination& c) {
  WeightedPoint point;
  point.count = c.count;
  for (std::size_t k = 0; k < c.count; ++k) {
    point.points[k] = body.core[c.vertices[k]];
    point.weights[k] = c.weights[k];
  }
  return point;
}

inline Combination exact(const RoundCombination& c) {
  Combination made;
  made.denominator = Dyadic(0.0);
  for (std::size_t k = 0; k < c.count; ++k) {
    made.parts.push_back({c.vertices[k], Dyadic(c.weights[k])});
    made.denominator = made.denominator + Dyadic(c.weights[k]);
  }
  return made;
}

inline constexpr Affine3 in_place{};
inline WeightedPoint weighted(const Point3& p) { return {1, {Posed3{p, &in_place, false}}, {1}}; }

inline bool is_finite(const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace round_detail

// Checks what is proposed. True: the evidence is filled in.
class RoundDisposal {
 public:
  // strictly: points have to be inside of bodies with a radius.
  RoundDisposal(const PlacedRound& a, const PlacedRound& b, RoundAnswer& answer, StageTally& tally,
                bool strictly = false)
      : a_(a),
        b_(b),
        answer_(answer),
        evidence_(answer.evidence),
        tally_(tally),
        least_(strictly ? Sign::positive : Sign::zero) {}

  // The direction parts A from B. Vertices of hulls to look from.
  bool parts(const WorldDirection& direction, std::uint32_t near_a, std::uint32_t near_b) {
    ++answer_.cost.proposals;
    const RoundShape a = shape_along(a_, direction, End::greatest, near_a);
    const RoundShape b = shape_along(b_, direction, End::least, near_b);
    if (gap_sign(direction, a, b, &tally_) != Sign::positive) return false;
    evidence_.verdict = Verdict::apart;
    if (direction.is_doubles()) {
      evidence_.direction = direction.doubles();
      return true;
    }
    const Vector3<Dyadic> d = direction.exact();
    const Vector3<Interval> about = direction.enclosure();
    evidence_.direction = {about.x.low, about.y.low, about.z.low};
    evidence_.exact_direction = std::make_shared<const std::array<Dyadic, 3>>(std::array{d.x, d.y, d.z});
    return true;
  }

  // Points of both cores are near enough to each other. Requires hulls.
  bool meets_between(const RoundCombination& a, const RoundCombination& b) {
    ++answer_.cost.proposals;
    if (nearness(round_detail::weighted(a_, a), a_.radius(), round_detail::weighted(b_, b), b_.radius(), &tally_) <
        least_)
      return false;
    return meets(RoundEvidence::Source::between, {}, a, b);
  }

  // Both hold the point. Combinations are of hulls.
  bool meets_at(const Point3& point, const RoundCombination& a, const RoundCombination& b) {
    if (!round_detail::is_finite(point)) return false;
    ++answer_.cost.proposals;
    const WeightedPoint x = round_detail::weighted(point);
    return holds(a_, x, a) && holds(b_, x, b) && meets(RoundEvidence::Source::point, point, a, b);
  }

  // The same of a point in exact numbers.
  bool meets_at(const ExactPoint3& x, const RoundCombination& a, const RoundCombination& b) {
    ++answer_.cost.proposals;
    tally_.exact += 2;
    if (!holds(a_, x, a) || !holds(b_, x, b)) return false;
    evidence_.exact = std::make_shared<const CommonPoint>(CommonPoint{x, combination(a_, x, a), combination(b_, x, b)});
    return meets(RoundEvidence::Source::exact, {}, a, b);
  }

  // A point of one core, which the other body holds. `core_a`: of A.
  bool meets_in_core(bool core_a, const RoundCombination& c) {
    ++answer_.cost.proposals;
    const WeightedPoint x = round_detail::weighted(core_a ? a_ : b_, c);
    if (side_of((core_a ? b_ : a_).shape, x, &tally_) < least_) return false;
    return core_a ? meets(RoundEvidence::Source::of_a, {}, c, {}) : meets(RoundEvidence::Source::of_b, {}, {}, c);
  }

 private:
  RoundShape shape_along(const PlacedRound& body, const WorldDirection& direction, End end, std::uint32_t near) {
    RoundShape shape = body.shape;
    if (body.body.is_curved()) return shape;
    if (body.core.graph.vertices.size() == 1) {
      shape.points[0] = body.core.graph.vertices[0];
      return shape;
    }
    Along along(direction, body.core.pose, body.core.tame);
    shape.points[0] = body.core.graph.vertices[extreme_vertex_from(body.core, along, end, near, answer_.cost, tally_)];
    return shape;
  }
  bool holds(const PlacedRound& body, const WeightedPoint& x, const RoundCombination& c) {
    if (body.body.is_curved()) return side_of(body.shape, x, &tally_) >= least_;
    return c.count > 0 && nearness(round_detail::weighted(body, c), body.radius(), x, 0, &tally_) >= least_;
  }
  bool holds(const PlacedRound& body, const ExactPoint3& x, const RoundCombination& c) const {
    if (body.body.is_curved()) return side_of(body.shape, x) >= least_;
    return c.count > 0 && nearness(exact_point(round_detail::weighted(body, c)), body.radius(), x, 0) >= least_;
  }
  static Combination combination(const PlacedRound& body, const ExactPoint3& x, const RoundCombination& c) {
    return body.body.is_curved() ? combination_of(body, x) : round_detail::exact(c);
  }
  bool meets(RoundEvidence::Source source, const Point3& point, const RoundCombination& a, const RoundCombination& b) {
    evidence_.verdict = Verdict::meet;
    evidence_.source = source;
    evidence_.point = point;
    evidence_.a = a;
    evidence_.b = b;
    return true;
  }

  const PlacedRound& a_;
  const PlacedRound& b_;
  RoundAnswer& answer_;
  RoundEvidence& evidence_;
  StageTally& tally_;
  Sign least_;
};

// What the simplex of a search makes: the point of each body that its weights mean.
template <class Real>
struct Made {
  VectorOf<Real> of_a{}, of_b{};
  RoundCombination a, b;  // of hulls
};

template <class Real>
void add_weight(RoundCombination& c, std::uint32_t v, double weight) {
  for (std::size_t k = 0; k < c.count; ++k) {
    if (c.vertices[k] != v) continue;
    c.weights[k] += weight;
    return;
  }
  c.vertices[c.count] = v;
  c.weights[c.count++] = weight;
}

template <class Real>
std::optional<Made<Real>> made_of(const RoundSearch<Real>& search) {
  if (search.simplex.count == 0) return std::nullopt;
  const std::array<Real, 4> weights = weights_of_nearest(search.simplex);
  Real total = 0;
  const std::size_t n = static_cast<std::size_t>(search.simplex.count);
  for (std::size_t k = 0; k < n; ++k) {
    if (weights[k] > Real(0)) total = total + weights[k];
  }
  if (!(total > Real(0))) return std::nullopt;
  Made<Real> made;
  for (std::size_t k = 0; k < n; ++k) {
    if (!(weights[k] > Real(0))) continue;
    const Real weight = weights[k] / total;
    const auto& slot = search.slots[search.simplex.vertex[k].a];
    made.of_a = round_detail::sum<Real>(made.of_a, weight, slot.of_a);
    made.of_b = round_detail::sum<Real>(made.of_b, weight, slot.of_b);
    const double w = nearest(weight);
    if (!(w > 0)) continue;
    add_weight<Real>(made.a, slot.vertex_a, w);
    add_weight<Real>(made.b, slot.vertex_b, w);
  }
  if (made.a.count == 0) return std::nullopt;
  return made;
}

// One search, and what it proposes.
template <class Real>
class RoundProposer {
 public:
  using Vector = VectorOf<Real>;

  RoundProposer(const PlacedRound& a, const PlacedRound& b, RoundDisposal& dispose, Cost& cost)
      : a_(a), b_(b), dispose_(dispose), cost_(cost), search(a, b) {}

  // As they are; and where that neither parts them nor finds a point that both hold, as curved bodies are when they
  // have shrunk a little: what is of the surface there is inside of them. Where they overlap by less than they shrink,
  // they have to shrink by less.
  bool propose(const Vector& first) {
    if (run(first)) return true;
    if (!is_near_ || !(a_.body.is_curved() || b_.body.is_curved())) return false;
    const std::array<Point3, 2> found = nearest_points;
    const std::array<RoundCombination, 2> made = nearest_made;
    for (const double shrink : RoundSearch<Real>::shrinks) {
      search.shrink(shrink);
      for (int again = 0; again < RoundSearch<Real>::runs; ++again) {
        if (run(search.direction)) return true;
      }
    }
    nearest_points = found;
    nearest_made = made;
    return false;
  }

 private:
  bool run(const Vector& first) {
    search.simplex.count = 0;
    search.direction = dot(first, first) > Real(0) ? first : search.first_direction();
    Real nearest2 = std::numeric_limits<double>::infinity();
    int in_vain = 0;
    for (int i = 0; i < search.most_iterations; ++i) {
      ++cost_.iterations;
      const DifferenceVertexOf<Real> w = search.probe(cost_);
      near_a = search.slots[w.a].vertex_a;
      near_b = search.slots[w.a].vertex_b;
      const Real length2 = dot(search.direction, search.direction);
      const double gap = nearest(search.gap_at(w)) / std::sqrt(nearest(length2));
      if (gap > best_gap_) {
        best_gap_ = gap;
        best_direction = rounded(search.direction);
      }
      if (parts_clearly(w) && parts()) return true;
      if (!search.gains_by(w) || !search.step_to(w)) break;
      if (search.reach > Real(0) && search.distance2 < search.reach * search.reach && meets()) return true;
      if (search.distance2 < nearest2) {
        nearest2 = search.distance2;
        in_vain = 0;
      } else if (++in_vain == search.most_in_vain) {
        break;
      }
    }
    if (parts_narrowly()) return true;
    is_near_ = true;
    return meets(true);
  }

 public:
  std::uint32_t near_a = 0, near_b = 0;
  std::array<Point3, 2> nearest_points{};          // of A and of B, about
  std::array<RoundCombination, 2> nearest_made{};  // of hulls: these of their cores
  Point3 best_direction{};                         // which parts them furthest, about

 private:
  // By more than rounding may be wrong?
  bool parts_clearly(const DifferenceVertexOf<Real>& w) const {
    const Real gap = search.gap_at(w);
    if (!(gap > Real(0))) return false;
    const Vector& d = search.direction;
    const Real length2 = dot(d, d), reach = search.reach;
    return gap * gap > reach * reach * length2 * Real(1 + 16 * search.noise);
  }

  bool parts() {
    const Vector& d = search.direction;
    Point3 direction = rounded(d);
    if (!make_tame(direction)) return false;
    if (dispose_.parts(WorldDirection(direction), near_a, near_b)) return true;
    return parts_exactly(d);
  }
  bool parts_exactly(const Point3&) { return false; }
  bool parts_exactly(const Vector3<DoubleDouble>& d) {
    const auto exact = [](const DoubleDouble& x) { return Dyadic(x.high) + Dyadic(x.low); };
    return dispose_.parts(WorldDirection(Vector3<Dyadic>{exact(d.x), exact(d.y), exact(d.z)}), near_a, near_b);
  }

  // At the end: the last direction, whatever rounding says of it.
  bool parts_narrowly() { return search.simplex.count > 0 && search.simplex.count < 4 && parts(); }

  bool meets(bool is_last = false) {
    const auto made = made_of(search);
    if (!made) return false;
    const bool curved_a = a_.body.is_curved(), curved_b = b_.body.is_curved();
    if (!curved_a && !curved_b) return dispose_.meets_between(made->a, made->b);
    const RoundCombination of_a = curved_a ? RoundCombination{} : made->a,
                           of_b = curved_b ? RoundCombination{} : made->b;
    if (!curved_a && dispose_.meets_in_core(true, of_a)) return true;
    if (!curved_b && dispose_.meets_in_core(false, of_b)) return true;
    if (a_.body.is_polyhedron() || b_.body.is_polyhedron()) return false;
    // Between the points of both that are nearest: of a hull as far from the core as its radius lets it be, and half of
    // what is left over.
    const Vector way = minus(made->of_b, made->of_a);
    const Real length = round_detail::root_of(dot(way, way));
    const auto at = [&](const Vector& from, const Real& by) {
      return length > Real(0) ? round_detail::sum<Real>(from, by / length, way) : from;
    };
    const Real slack = search.reach - length;
    nearest_points = {search.in_world(made->of_a), search.in_world(made->of_b)};
    nearest_made = {of_a, of_b};
    for (const double part : {0.5, 0.0625, 0.0, 1.0}) {
      const Real depth = slack > Real(0) ? slack * Real(part) : Real(0);
      const Vector& from = curved_a ? made->of_a : made->of_b;
      const Vector x = curved_a && curved_b ? at(made->of_a, length * Real(part)) : at(from, curved_a ? -depth : depth);
      if (dispose_.meets_at(search.in_world(x), of_a, of_b)) return true;
      if (is_last && meets_exactly(x, of_a, of_b)) return true;
    }
    return false;
  }
  // Doubles may hold no point of what is thinner than their last bit.
  bool meets_exactly(const Point3&, const RoundCombination&, const RoundCombination&) { return false; }
  bool meets_exactly(const Vector3<DoubleDouble>& x, const RoundCombination& a, const RoundCombination& b) {
    const auto in_world = search.exactly_in_world(x);
    return in_world && dispose_.meets_at(*in_world, a, b);
  }

  const PlacedRound& a_;
  const PlacedRound& b_;
  RoundDisposal& dispose_;
  Cost& cost_;
  double best_gap_ = -std::numeric_limits<double>::infinity();
  bool is_near_ = false;  // the search ended without parting them

 public:
  RoundSearch<Real> search;
};

}  // namespace sunder::solid
