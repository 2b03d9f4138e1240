// Why a point inside of one body and in the core of the other, a polyhedron, is enough: from it a small step towards
// the middle of that polyhedron leads to a point of its relative interior, and stays inside of the first.
#include <sunder/number/exact_vector.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/exact/spanning_vertices.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/round/round_contact.h>
#include <sunder/solid/round/round_finish.h>
#include <sunder/solid/round/round_propose.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;

// The point of the core that a combination makes. Requires a hull.
ExactPoint3 core_point(const PlacedRound& hull, const Combination& c) {
  return exact_point(numerators_of(c, [&](std::uint32_t v) { return coordinates<Dyadic>(hull.core[v]); }),
                     c.denominator);
}

// Inside, as `inside` of docs/claims.md wants it; of polyhedra nothing is asked here.
bool is_inside(const PlacedRound& body, const ExactPoint3& x, const Combination& made) {
  if (body.body.is_polyhedron()) return true;
  if (body.body.is_curved()) return side_of(body.shape, x) == Sign::positive;
  return nearness(core_point(body, made), body.radius(), x, 0) == Sign::positive;
}

// For a polyhedron of radius 0 of which the point is: the point moved towards its middle by 2^-bits of the way, and all
// weights that it then has.
ExactPoint3 moved_in(const PlacedRound& polyhedron, const ExactPoint3& x, int bits, Combination& made) {
  const std::vector<std::uint32_t> spanning = spanning_vertices(polyhedron.body.core());
  const Dyadic n(static_cast<double>(spanning.size())), part = Dyadic::power_of_two(-bits), rest = Dyadic(1.0) - part;
  // Over n times the old denominator.
  Combination moved{{}, made.denominator * n};
  for (const auto& [index, numerator] : made.parts) moved.parts.push_back({index, numerator * n * rest});
  Exact middle{Dyadic(0.0), Dyadic(0.0), Dyadic(0.0)};
  for (const std::uint32_t v : spanning) {
    middle = sum(middle, coordinates<Dyadic>(polyhedron.core[v]));
    moved.add(v, made.denominator * part);
  }
  made = std::move(moved);
  return exact_point(sum(times(n * rest, x.numerators()), times(x.denominator * part, middle)), x.denominator * n);
}

// A common point that is inside of every body with a radius: made inside of a polyhedron too, if there is one. Fails
// where it is not inside.
std::optional<CommonPoint> inner_point(const PlacedRound& a, const PlacedRound& b, const CommonPoint& point) {
  const ExactPoint3& x = point.at;
  if (!is_inside(a, x, point.of_a) || !is_inside(b, x, point.of_b)) return std::nullopt;
  if (!a.body.is_polyhedron() && !b.body.is_polyhedron()) return point;
  const bool polyhedron_a = a.body.is_polyhedron();
  const PlacedRound& other = polyhedron_a ? b : a;
  for (int bits = 1;; bits = bits < 64 ? bits + 4 : 2 * bits) {
    CommonPoint moved = point;
    Combination &own = polyhedron_a ? moved.of_a : moved.of_b, &of_other = polyhedron_a ? moved.of_b : moved.of_a;
    const ExactPoint3 inner = moved_in(polyhedron_a ? a : b, x, bits, own);
    if (other.body.is_curved()) of_other = combination_of(other, inner);
    if (!is_inside(other, inner, of_other)) continue;
    moved.at = inner;
    return moved;
  }
}

// Does the direction part A from B weakly?
bool parts_weakly(const PlacedRound& a, const PlacedRound& b, const std::array<Dyadic, 3>& d) {
  const WorldDirection direction(Vector3<Dyadic>{d[0], d[1], d[2]});
  Cost cost;
  StageTally tally;
  const auto shape_along = [&](const PlacedRound& body, End end) {
    RoundShape shape = body.shape;
    if (body.body.is_curved()) return shape;
    Along along(direction, body.core.pose, body.core.tame);
    shape.points[0] = body.core.graph.vertices[extreme_vertex_from(body.core, along, end, 0, cost, tally)];
    return shape;
  };
  return gap_sign(direction, shape_along(a, End::greatest), shape_along(b, End::least), &tally) != Sign::negative;
}

class Contacts {
 public:
  Contacts(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence)
      : a_(a), b_(b), point_(common_point_of(a, b, evidence)) {}

  RoundContact decide() {
    if (a_.body.is_polyhedron() && b_.body.is_polyhedron()) return of_polyhedra();
    if (const auto inner = inner_point(a_, b_, point_)) return overlapping(*inner);
    if (!a_.body.is_curved() && !b_.body.is_curved()) return of_hulls();
    if (const auto inner = searched()) return overlapping(*inner);
    // Out of a hull: from the point of its core.
    for (const bool is_a : {true, false}) {
      const PlacedRound& hull = is_a ? a_ : b_;
      if (hull.body.is_curved() || hull.body.is_polyhedron()) continue;
      const ExactPoint3 &x = point_.at, y = core_point(hull, is_a ? point_.of_a : point_.of_b);
      const Exact out = times(y.denominator, x.numerators()) - times(x.denominator, y.numerators());
      const bool turned = (x.denominator.sign() == Sign::negative) == is_a;
      const std::array<Dyadic, 3> d = turned ? std::array{-out.x, -out.y, -out.z} : std::array{out.x, out.y, out.z};
      if (!is_zero(out) && parts_weakly(a_, b_, d)) return touching(d);
    }
    for (const auto& [curved, other, is_a] : {std::tuple(&a_, &b_, true), std::tuple(&b_, &a_, false)}) {
      if (!curved->body.is_curved()) continue;
      const Sides sides(*curved, point_.at);
      for (const std::array<Dyadic, 3>& outwards : sides.directions) {
        const std::array<Dyadic, 3> d = is_a ? outwards : std::array{-outwards[0], -outwards[1], -outwards[2]};
        if (parts_weakly(a_, b_, d)) return touching(d);
      }
      if (!other->body.is_polyhedron()) continue;
      StageTally tally;
      Cost cost;
      const CurvedVerdict found = curved_polyhedron(*curved, *other, 0, cost, tally);
      if (found.sign == Sign::positive && found.point) {
        CommonPoint nearest = *found.point;
        if (!is_a) std::swap(nearest.of_a, nearest.of_b);
        if (const auto inner = inner_point(a_, b_, nearest)) return overlapping(*inner);
        if (curved->kind() == RoundKind::cylinder) return overlapping(off_the_ends(*curved, *other, nearest, is_a));
      }
      if (found.direction) {
        const Exact& n = *found.direction;
        const std::array<Dyadic, 3> d = is_a ? std::array{n.x, n.y, n.z} : std::array{-n.x, -n.y, -n.z};
        if (parts_weakly(a_, b_, d)) return touching(d);
      }
    }
    return {};
  }

 private:
  // Directions out of a curved body at one of its points: across its planes, and across what is round there.
  struct Sides {
    std::vector<std::array<Dyadic, 3>> directions;

    Sides(const PlacedRound& curved, const ExactPoint3& x) {
      if (curved.kind() == RoundKind::ellipsoid) {
        // L^-T L^-1 (x - t - L c), up to a positive factor.
        const std::array<Dyadic, 9> m = adjoint(curved.core.pose);
        const Exact centre = coordinates<Dyadic>(Posed3{curved.shape.points[0], &curved.core.pose, false});
        const Exact from = x.numerators() - times(x.denominator, centre);
        const auto row = [&](std::size_t i) { return m[i] * from.x + m[i + 1] * from.y + m[i + 2] * from.z; };
        const Exact v{row(0), row(3), row(6)};
        const auto column = [&](std::size_t j) { return m[j] * v.x + m[3 + j] * v.y + m[6 + j] * v.z; };
        add({column(0), column(1), column(2)});
        return;
      }
      const Exact base = coordinates<Dyadic>(Posed3{curved.shape.points[0], &curved.core.pose, false});
      const Exact top = coordinates<Dyadic>(Posed3{curved.shape.points[1], &curved.core.pose, false});
      const Exact axis = top - base, from = x.numerators() - times(x.denominator, base);
      const Dyadic length2 = dot(axis, axis), along = dot(from, axis);
      const Exact across = times(length2, from) - times(along, axis);
      if (curved.kind() == RoundKind::cylinder) {
        add(across);
        add(axis);
      } else {
        const Dyadic r(curved.radius());
        add(sum(times(length2, across), times(r * r * (x.denominator * length2 - along), axis)));
        add(axis);
      }
      add({-axis.x, -axis.y, -axis.z});
    }
    void add(const Exact& n) {
      if (!is_zero(n)) directions.push_back({n.x, n.y, n.z});
    }
  };

  // For a cylinder and a polyhedron that overlap, a common point that lies within the radius, but perhaps in the plane
  // of base or top: moved towards a point of the polyhedron that is between the planes.
  CommonPoint off_the_ends(const PlacedRound& cylinder, const PlacedRound& polyhedron, const CommonPoint& point,
                           bool is_a) const {
    const Exact base = coordinates<Dyadic>(Posed3{cylinder.shape.points[0], &cylinder.core.pose, false});
    const Exact axis = coordinates<Dyadic>(Posed3{cylinder.shape.points[1], &cylinder.core.pose, false}) - base;
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
      (is_a ? moved.of_a : moved.of_b) = combination_of(cylinder, moved.at);
      if (const auto inner = inner_point(a_, b_, moved)) return *inner;
    }
  }

  static RoundContact overlapping(const CommonPoint& inner) { return OverlappingAt{inner}; }
  RoundContact touching(const std::array<Dyadic, 3>& direction) const { return TouchingAt{point_, direction}; }

  RoundContact of_polyhedra() const {
    const Interiors found = interiors(a_.body.core(), a_.pose, b_.body.core(), b_.pose);
    return found.meet ? overlapping(found.point) : touching(found.direction);
  }

  // With a radius above 0, and no point inside yet.
  RoundContact of_hulls() const {
    const PolyhedronDistance distance =
        polyhedron_polyhedron_distance(a_.body.core(), a_.pose, b_.body.core(), b_.pose);
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

RoundContact round_round_contact(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence) {
  if (verdict_of(evidence) != Verdict::meet) return {};
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
