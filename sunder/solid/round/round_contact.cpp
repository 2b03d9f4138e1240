// Why a point inside of one body and in the core of the other, a polyhedron, is enough: from it a small step towards
// the middle of that polyhedron leads to a point of its relative interior, and stays inside of the first.
#include <sunder/number/exact_vector.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/exact/spanning_vertices.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/round/round_contact.h>
#include <sunder/solid/round/round_finish.h>
#include <sunder/solid/round/round_methods.h>
#include <sunder/solid/round/round_placed.h>
#include <sunder/solid/round/round_propose.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;

// A common point that is inside of every body with a radius: made inside of a polyhedron too, if there is one. Fails
// where it is not inside.
std::optional<CommonPoint> inner_point(const PlacedRound& a, const PlacedRound& b, const CommonPoint& point) {
  const ExactPoint3& x = point.at;
  if (!is_inside(a, x, point.of_a) || !is_inside(b, x, point.of_b)) return std::nullopt;
  for (int bits = 1;; bits = bits < 64 ? bits + 4 : 2 * bits) {
    CommonPoint moved = point;
    std::optional<ExactPoint3> inner = moved_in(a, x, bits, moved.of_a);
    const bool is_of_a = inner.has_value();
    if (!is_of_a) inner = moved_in(b, x, bits, moved.of_b);
    if (!inner) return point;
    const PlacedRound& other = is_of_a ? b : a;
    Combination& of_other = is_of_a ? moved.of_b : moved.of_a;
    of_other = made_by(other, *inner, of_other);
    if (!is_inside(other, *inner, of_other)) continue;
    moved.at = *std::move(inner);
    return moved;
  }
}

// Does the direction part A from B weakly?
bool parts_weakly(const PlacedRound& a, const PlacedRound& b, const std::array<Dyadic, 3>& d) {
  const WorldDirection direction(Vector3<Dyadic>{d[0], d[1], d[2]});
  Cost cost;
  StageTally tally;
  return gap_sign(direction, shape_along(a, direction, End::greatest, 0, cost, tally),
                  shape_along(b, direction, End::least, 0, cost, tally), &tally) != Sign::negative;
}

class Contacts {
 public:
  Contacts(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence)
      : a_(a), b_(b), point_(common_point_of(a, b, evidence)) {}

  RoundContact decide() {
    if (const auto inner = inner_point(a_, b_, point_)) return overlapping(*inner);
    if (const auto cores = distance_of_cores(a_, b_)) return of_hulls(*cores);
    if (const auto inner = searched()) return overlapping(*inner);
    // Out of a hull: from the point of its core.
    for (const bool is_a : {true, false}) {
      const auto of_core = core_point(is_a ? a_ : b_, (is_a ? point_.of_a : point_.of_b).parts);
      if (!of_core) continue;
      const ExactPoint3 &x = point_.at, &y = of_core->at;
      const Exact out = times(y.denominator, x.numerators()) - times(x.denominator, y.numerators());
      const bool turned = (x.denominator.sign() == Sign::negative) == is_a;
      const std::array<Dyadic, 3> d = turned ? std::array{-out.x, -out.y, -out.z} : std::array{out.x, out.y, out.z};
      if (!is_zero(out) && parts_weakly(a_, b_, d)) return touching(d);
    }
    for (const auto& [curved, other, is_a] : {std::tuple(&a_, &b_, true), std::tuple(&b_, &a_, false)}) {
      for (const std::array<Dyadic, 3>& outwards : outward_directions(*curved, point_.at)) {
        const std::array<Dyadic, 3> d = is_a ? outwards : std::array{-outwards[0], -outwards[1], -outwards[2]};
        if (parts_weakly(a_, b_, d)) return touching(d);
      }
      StageTally tally;
      Cost cost;
      const auto found = curved_polyhedron(*curved, *other, 0, cost, tally);
      if (!found) continue;
      if (found->sign == Sign::positive && found->point) {
        CommonPoint nearest = *found->point;
        if (!is_a) std::swap(nearest.of_a, nearest.of_b);
        if (const auto inner = inner_point(a_, b_, nearest)) return overlapping(*inner);
        return overlapping(off_the_ends(*curved, *other, nearest, is_a));
      }
      if (found->direction) {
        const Exact& n = *found->direction;
        const std::array<Dyadic, 3> d = is_a ? std::array{n.x, n.y, n.z} : std::array{-n.x, -n.y, -n.z};
        if (parts_weakly(a_, b_, d)) return touching(d);
      }
    }
    return {};
  }

 private:
  // For a cylinder and a polyhedron that overlap, a common point that lies within the radius, but perhaps in the plane
  // of base or top: moved towards a point of the polyhedron that is between the planes.
  CommonPoint off_the_ends(const PlacedRound& cylinder, const PlacedRound& polyhedron, const CommonPoint& point,
                           bool is_a) const {
    const auto [base, axis] = *axis_of(cylinder);
    const Dyadic height = dot(axis, axis), half = height.scaled(-1);
    // The vertices that are lowest and highest along the axis; between them, or one of them.
    std::array<std::uint32_t, 2> vertex{};
    std::array<Dyadic, 2> along{dot(coordinates<Dyadic>(polyhedron.core[0]) - base, axis)};
    along[1] = along[0];
    for (std::uint32_t v = 1; v < polyhedron.body.core().vertices().size(); ++v) {
      const Dyadic here = dot(coordinates<Dyadic>(polyhedron.core[v]) - base, axis);
      for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
        if ((here - along[k]).sign() != (k == 0 ? Sign::negative : Sign::positive)) continue;
        vertex[k] = v;
        along[k] = here;
      }
    }
    std::array<Dyadic, 2> weight{Dyadic(1.0), Dyadic(0.0)};
    if (along[0].sign() != Sign::positive) {
      weight = {Dyadic(0.0), Dyadic(1.0)};
      if ((along[1] - height).sign() != Sign::negative) weight = {along[1] - half, half - along[0]};
    }
    const Dyadic all = weight[0] + weight[1];
    const Exact between = sum(times(weight[0], coordinates<Dyadic>(polyhedron.core[vertex[0]])),
                              times(weight[1], coordinates<Dyadic>(polyhedron.core[vertex[1]])));
    for (int bits = 1;; bits *= 2) {
      const Dyadic part = Dyadic::power_of_two(-bits), rest = Dyadic(1.0) - part;
      CommonPoint moved = point;
      const Dyadic& over = point.at.denominator;
      moved.at = exact_point(sum(times(rest * all, point.at.numerators()), times(part * over, between)), over * all);
      Combination& of = is_a ? moved.of_b : moved.of_a;
      const Dyadic before = of.denominator;
      for (auto& [index, numerator] : of.parts) numerator = numerator * rest * all;
      of.denominator = before * all;
      for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
        if (weight[k].sign() == Sign::zero) continue;
        of.add(vertex[k], before * part * weight[k]);
      }
      (is_a ? moved.of_a : moved.of_b) = made_by(cylinder, moved.at);
      if (const auto inner = inner_point(a_, b_, moved)) return *inner;
    }
  }

  static RoundContact overlapping(const CommonPoint& inner) { return OverlappingAt{inner}; }
  RoundContact touching(const std::array<Dyadic, 3>& direction) const { return TouchingAt{point_, direction}; }

  // With a radius above 0, and no point inside yet.
  RoundContact of_hulls(const PolyhedronDistance& distance) const {
    const ClosestFeatures* closest = closest_of(distance);
    if (closest == nullptr) return {};  // not so: a point of both cores is inside
    const auto [of_a, of_b] = closest_points(*closest);
    const CommonPoint nearest = point_between(of_a, a_.radius(), of_b, b_.radius());
    if (const auto inner = inner_point(a_, b_, nearest)) return overlapping(*inner);
    return TouchingAt{nearest, way_between(of_a, of_b)};
  }

  // By the search that wants points inside.
  std::optional<CommonPoint> searched() const {
    RoundAnswer answer;
    StageTally tally;
    RoundDisposal dispose(a_, b_, answer, tally, true);
    RoundProposer<double> first(a_, b_, dispose, answer.cost);
    bool held = first.propose({});
    if (!held) {
      RoundProposer<DoubleDouble> second(a_, b_, dispose, answer.cost);
      held = second.propose({});
    }
    if (!held || !answer.meet()) return std::nullopt;
    return inner_point(a_, b_, common_point_of(a_, b_, answer.evidence));
  }

  const PlacedRound& a_;
  const PlacedRound& b_;
  CommonPoint point_;
};

}  // namespace

RoundContact contact_searched(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence) {
  return Contacts(a, b, evidence).decide();
}

Relation round_round_relation(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence) {
  const auto* common = std::get_if<CommonVertices>(&evidence);
  if (common == nullptr) return relation_of(round_round_contact(a, b, evidence));
  // Five vertices whose weights are unique and positive span A - B around the origin.
  if (common->count_a + common->count_b == 5) return Relation::overlapping;
  StageTally tally;
  return interiors_meet(a.body.core(), a.core, b.body.core(), b.core, tally) ? Relation::overlapping
                                                                             : Relation::touching;
}

RoundContact round_round_contact(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b) {
  return round_round_contact(PlacedRound(a, pose_a), PlacedRound(b, pose_b),
                             round_round(a, pose_a, b, pose_b).evidence);
}

}  // namespace sunder::solid
