// The search proposes, exact signs dispose, and where nothing holds exact methods decide.
#include <sunder/base/contract.h>
#include <sunder/certificate/common_point.h>
#include <sunder/certificate/direction.h>
#include <sunder/number/exact_vector.h>
#include <sunder/number/root.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/round/round_finish.h>
#include <sunder/solid/round/round_methods.h>
#include <sunder/solid/round/round_placed.h>
#include <sunder/solid/round/round_propose.h>
#include <sunder/solid/round/round_quick.h>
#include <sunder/solid/round/round_round.h>
#include <sunder/solid/round/round_round_warm.h>
#include <sunder/solid/round/simple_numbers.h>
#include <sunder/solid/round/world_box.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

using round_detail::is_finite, round_detail::weighted;

// ---- What is exact.

class RoundFinish {
  using Exact = Vector3<Dyadic>;

 public:
  RoundFinish(const PlacedRound& a, const PlacedRound& b, RoundAnswer& answer, StageTally& tally)
      : a_(a), b_(b), answer_(answer), tally_(tally) {}

  // True: decided. The core of one of the bodies meets the other, or does not, and is all of its body. Requires that
  // one is curved.
  bool cores_decide(std::uint32_t near_a, std::uint32_t near_b) {
    const PairAnswer of_cores = polyhedron_polyhedron(a_.body.core(), a_.pose, b_.body.core(), b_.pose);
    count(of_cores);
    if (const auto* common = std::get_if<CommonVertices>(&of_cores.evidence)) {
      meet_in_cores(*common);
      return true;
    }
    return core_decides(true, near_a) || core_decides(false, near_b);
  }

  // True: decided, of hulls always; of cylinders as of the capsules that hold them. Where these are apart the bodies are;
  // where they meet, and the shortest way between the cores is perpendicular to every axis, it ends on the cylinders
  // themselves.
  bool capsules_decide() {
    for (const PlacedRound* body : {&a_, &b_}) {
      if (body->kind() != RoundKind::hull && body->kind() != RoundKind::cylinder) return false;
    }
    const PolyhedronDistance distance =
        polyhedron_polyhedron_distance(a_.body.core(), a_.pose, b_.body.core(), b_.pose);
    count(distance);
    if (const auto* common = std::get_if<CommonVertices>(&distance.evidence)) {
      meet_in_cores(*common);
      return true;
    }
    const ClosestFeatures& features = *closest_of(distance);
    const ClosestPoints closest = closest_points(features);
    const std::array<Dyadic, 3> way = way_between(closest.of_a, closest.of_b);
    const Dyadic reach = Dyadic(a_.radius()) + Dyadic(b_.radius());
    ++tally_.exact;
    if (compare_root(features.squared(), reach) == Sign::positive) {
      apart(way);
      return true;
    }
    for (const PlacedRound* body : {&a_, &b_}) {
      const auto axis = axis_of(*body);
      if (axis && dot(axis->way, Exact{way[0], way[1], way[2]}).sign() != Sign::zero) return false;
    }
    CommonPoint point = point_between(closest.of_a, a_.radius(), closest.of_b, b_.radius());
    point.of_a = in_points(a_, std::move(point.of_a));
    point.of_b = in_points(b_, std::move(point.of_b));
    meet(std::move(point));
    return true;
  }

  // True: both hold the point; of hulls, as far as the points of their cores tell that are made so.
  bool meet_at(const ExactPoint3& x, const std::array<Combination, 2>& of_cores) {
    CommonPoint common{x, {}, {}};
    for (const PlacedRound* body : {&a_, &b_}) {
      const Combination& of_core = of_cores[body == &a_ ? 0 : 1];
      ++tally_.exact;
      if (side_of(*body, x, of_core) == Sign::negative) return false;
      (body == &a_ ? common.of_a : common.of_b) = made_by(*body, x, of_core);
    }
    meet(std::move(common));
    return true;
  }

  // True: both hold a point near those of `near`, which is in the middle of those that are thin, exactly: doubles hold
  // no point of a disc of some 2^-53 of its radius. `made`: of hulls, these points of their cores. At a rim the search
  // ends on the surface; so from there on a little towards the first point of each core too.
  bool meet_in_the_middle(const std::array<Point3, 2>& near, const std::array<RoundCombination, 2>& made) {
    for (const double thin : {0x1p-20, 0x1p-40}) {
      for (const Point3& x : near) {
        if (meet_in_the_middle(x, made, thin)) return true;
        for (const PlacedRound* body : {&a_, &b_}) {
          const Exact end = coordinates<Dyadic>(body->core[0]);
          const Point3 to{end.x.nearest(), end.y.nearest(), end.z.nearest()};
          for (const double part : {0x1p-40, 0x1p-32, 0x1p-26, 0x1p-23, 0x1p-20}) {
            const auto inwards = [&](double from, double there) { return from + part * (there - from); };
            const Point3 in{inwards(x.x, to.x), inwards(x.y, to.y), inwards(x.z, to.z)};
            if (meet_in_the_middle(in, made, thin)) return true;
          }
        }
      }
    }
    return false;
  }

  // thin: against what is wide, or the coordinates.
  bool meet_in_the_middle(const Point3& x, const std::array<RoundCombination, 2>& made, double thin) {
    if (!is_finite(x)) return false;
    Middle middle(x, thin);
    for (const PlacedRound* body : {&a_, &b_}) add_middle(*body, middle);
    if (middle.planes.empty() || middle.planes.size() > 3) return false;
    return meet_at(middle.nearest(), {round_detail::exact(made[0]), round_detail::exact(made[1])});
  }

  // True: both hold the point, of curved bodies by their own formulas, of hulls by the exact distance of the core.
  bool meet_at(const Point3& point) {
    if (!is_finite(point)) return false;
    CommonPoint common{exactly(point), {}, {}};
    const WeightedPoint x = weighted(point);
    const ConvexPolyhedron as_body(std::span<const Point3>(&point, 1));
    for (const PlacedRound* body : {&a_, &b_}) {
      Combination& made = body == &a_ ? common.of_a : common.of_b;
      if (body->body.is_curved()) {
        if (side_of(body->shape, x, &tally_) == Sign::negative) return false;
        made = made_by(*body, exact_point(x));
        continue;
      }
      const PolyhedronDistance distance =
          polyhedron_polyhedron_distance(as_body, Pose(), body->body.core(), body->pose);
      count(distance);
      const ClosestFeatures* closest = closest_of(distance);
      if (closest == nullptr || compare_distance(distance, body->radius()) == Sign::positive) return false;
      made = closest_points(*closest).of_b.of_body;
    }
    meet(std::move(common));
    return true;
  }

 private:
  // Planes, none of which the others make, and the point in all of them that is nearest to x.
  struct Middle {
    struct Plane {
      Exact normal;
      Dyadic lacks;  // what normal x is short of
    };
    Exact x;
    double size, thin;  // of the coordinates of x; what is thin, against this or what is wide
    std::vector<Plane> planes;

    Middle(const Point3& at, double is_thin)
        : x{Dyadic(at.x), Dyadic(at.y), Dyadic(at.z)},
          size(std::max({std::fabs(at.x), std::fabs(at.y), std::fabs(at.z)})),
          thin(is_thin) {}

    void add(const Exact& normal, const Exact& through) {
      planes.push_back({normal, dot(normal, through - x)});
      if (planes.size() <= 3 && determinant(planes.size()).sign() == Sign::zero) planes.pop_back();
    }
    // Along the normals, by what solves the equations of their products: Cramer's rule.
    ExactPoint3 nearest() const {
      const Dyadic all = determinant(planes.size());
      Exact at = times(all, x);
      for (std::size_t k = 0; k < planes.size(); ++k) at = sum(at, times(determinant(k), planes[k].normal));
      return exact_point(at, all);
    }

   private:
    // Of the products of the normals; those with normal `lacking` replaced by what is lacking.
    Dyadic determinant(std::size_t lacking) const {
      const std::size_t n = planes.size();
      const auto at = [&](std::size_t i, std::size_t j) {
        return j == lacking ? planes[i].lacks : dot(planes[i].normal, planes[j].normal);
      };
      if (n == 1) return at(0, 0);
      const auto minor = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
        return at(i, k) * at(j, l) - at(i, l) * at(j, k);
      };
      if (n == 2) return minor(0, 1, 0, 1);
      return at(0, 0) * minor(1, 2, 1, 2) - at(1, 0) * minor(0, 2, 1, 2) + at(2, 0) * minor(0, 1, 1, 2);
    }
  };

  // Half way between base and top, the base of a cone, across the short axes of an ellipsoid.
  static void add_middle(const PlacedRound& body, Middle& middle) {
    const Affine3& pose = body.core.pose;
    const auto is_thin = [&](double thick, double wide) { return thick <= middle.thin * std::max(wide, middle.size); };
    if (body.kind() == RoundKind::ellipsoid) {
      const auto& m = pose.linear;
      std::array<double, 3> lengths{};
      for (std::size_t k = 0; k < 3; ++k) lengths[k] = std::hypot(m[k], m[3 + k], m[6 + k]);
      const double wide = *std::max_element(lengths.begin(), lengths.end());
      const std::array<Dyadic, 9> rows = adjoint(pose);
      const Exact centre = coordinates<Dyadic>(body.core[0]);
      for (std::size_t k = 0; k < 3; ++k) {
        if (is_thin(lengths[k], wide)) middle.add({rows[3 * k], rows[3 * k + 1], rows[3 * k + 2]}, centre);
      }
    } else if (const auto axis = axis_of(body)) {
      const auto& [base, way] = *axis;
      const double length = std::hypot(way.x.nearest(), way.y.nearest(), way.z.nearest());
      if (!is_thin(length, body.radius())) return;
      const Dyadic half(body.kind() == RoundKind::cone ? 0.0 : 0.5);
      middle.add(way, sum(base, times(half, way)));
    }
  }

  bool core_decides(bool of_a, std::uint32_t near) {
    const PlacedRound &own = of_a ? a_ : b_, &other = of_a ? b_ : a_;
    const RoundBody as_body = RoundBody::rounded(own.body.core(), 0);
    const PlacedRound core(as_body, own.pose);
    // Where a body touches another by its radius, its core is mostly far from it, which is seen at once.
    if (!own.body.is_polyhedron() && !other.body.is_polyhedron()) {
      RoundAnswer of_core;
      StageTally tally;
      RoundDisposal dispose(core, other, of_core, tally);
      RoundProposer<double> proposer(core, other, dispose, of_core.cost);
      if (proposer.propose({}) && !of_core.meet()) return false;
    }
    ++tally_.exact;
    std::optional<CommonPoint> point;
    if (auto found = curved_polyhedron(other, core, near == no_vertex ? 0 : near, answer_.cost, tally_)) {
      if (!found->point && found->direction && own.body.is_polyhedron()) {
        const auto& d = *found->direction;
        apart(of_a ? std::array{-d.x, -d.y, -d.z} : std::array{d.x, d.y, d.z});
        return true;
      }
      point = std::move(found->point);
      if (point) std::swap(point->of_a, point->of_b);  // now the core's first
    } else {
      const PolyhedronDistance distance =
          polyhedron_polyhedron_distance(own.body.core(), own.pose, other.body.core(), other.pose);
      count(distance);
      const ClosestFeatures* features = closest_of(distance);
      if (features != nullptr && compare_distance(distance, other.radius()) != Sign::positive) {
        const ClosestPoints closest = closest_points(*features);
        point = point_between(closest.of_a, 0, closest.of_b, other.radius());
      }
    }
    if (!point) return false;
    point->of_a = in_points(own, std::move(point->of_a));
    if (!of_a) std::swap(point->of_a, point->of_b);
    meet(std::move(*point));
    return true;
  }
  template <class AnyAnswer>
  void count(const AnyAnswer& of) {
    answer_.cost.probes += of.cost.probes;
    answer_.cost.iterations += of.cost.iterations;
    tally_.exact += of.cost.exact;
  }
  void meet_in_cores(const CommonVertices& common) { answer_.evidence = CoresMeet{common}; }
  void meet(CommonPoint point) {
    answer_.evidence = ExactCommonPoint{std::make_shared<const CommonPoint>(std::move(point))};
  }
  void apart(const std::array<Dyadic, 3>& direction) {
    answer_.evidence = separation_along(WorldDirection(Vector3<Dyadic>{direction[0], direction[1], direction[2]}));
  }

  const PlacedRound& a_;
  const PlacedRound& b_;
  RoundAnswer& answer_;
  StageTally& tally_;
};

// Where nothing quick has held.
void search(const PlacedRound& a, const PlacedRound& b, const Point3& way, RoundAnswer& answer) {
  StageTally tally;
  RoundDisposal dispose(a, b, answer, tally);
  RoundProposer<double> first(a, b, dispose, answer.cost);
  if (first.propose(way)) {
    return conclude(answer, tally.exact);
  }
  RoundFinish finish(a, b, answer, tally);
  if (!a.body.is_curved() && !b.body.is_curved()) {
    finish.capsules_decide();
    return conclude(answer, tally.exact, true);
  }
  const Point3& d = first.search.direction;
  RoundProposer<DoubleDouble> second(a, b, dispose, answer.cost);
  const bool held = second.propose(is_finite(d) ? Vector3<DoubleDouble>{d.x, d.y, d.z} : Vector3<DoubleDouble>{});
  if (!held && !finish.cores_decide(second.near_a, second.near_b) && !finish.capsules_decide()) {
    // Bodies that touch mostly do so in numbers that people give.
    const auto is_simple = [](const PlacedRound& body) {
      return body.body.is_curved() || body.body.core().dimension() == 0;
    };
    const Combination centre{{{0, Dyadic(1.0)}}};
    for (const Point3& x : second.nearest_points) {
      for (const int bits : {40, 20, 10}) {
        if (answer.undecided()) finish.meet_at(snapped(x, bits));
      }
      if (answer.undecided() && is_simple(a) && is_simple(b) && is_finite(x))
        finish.meet_at(simple_fractions(x), {centre, centre});
    }
    if (answer.undecided()) finish.meet_in_the_middle(second.nearest_points, second.nearest_made);
    if (answer.undecided()) answer.evidence = NearlyTouching{second.best_direction};
  }
  conclude(answer, tally.exact, !held);
}

// Where neither is an ellipsoid: what is decided quickly has no need of a copy of its pose.
RoundAnswer of_poses_as_given(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b) {
  require_rigid(a, pose_a);
  require_rigid(b, pose_b);
  RoundAnswer answer;
  Point3 way{};
  if (!decide_quickly(a, pose_a, b, pose_b, answer, way)) {
    search(PlacedRound(a, pose_a), PlacedRound(b, pose_b), way, answer);
  }
  return answer;
}

}  // namespace

CommonPoint point_between(const PointOf& p, double radius_p, const PointOf& q, double radius_q) {
  const Dyadic r(radius_p), s(radius_q), zero(0.0);
  const bool points = r.sign() == Sign::zero && s.sign() == Sign::zero;
  const Dyadic &over_p = p.at.denominator, &over_q = q.at.denominator;
  const Dyadic of_p = points ? Dyadic(1.0) : s * over_q, of_q = points ? zero : r * over_p;
  return {exact_point(sum(times(of_p, p.at.numerators()), times(of_q, q.at.numerators())),
                      points ? over_p : (r + s) * over_p * over_q),
          p.of_body, q.of_body};
}

RoundAnswer round_answer(PairAnswer&& of_polyhedra) {
  const auto take = [](auto& evidence) { return RoundEvidence(std::move(evidence)); };
  return {std::visit(take, of_polyhedra.evidence), of_polyhedra.decided_by, of_polyhedra.cost};
}

// ---- The front doors of all questions about two bodies: polyhedra have methods of their own.

namespace {

bool are_polyhedra(const RoundBody& a, const RoundBody& b) { return a.is_polyhedron() && b.is_polyhedron(); }
bool are_hulls(const RoundBody& a, const RoundBody& b) { return !a.is_curved() && !b.is_curved(); }

}  // namespace

RoundAnswer round_round(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b) {
  if (are_polyhedra(a, b)) return round_answer(polyhedron_polyhedron(a.core(), pose_a, b.core(), pose_b));
  const bool ellipsoids = a.kind() == RoundKind::ellipsoid || b.kind() == RoundKind::ellipsoid;
  return ellipsoids ? round_round(PlacedRound(a, pose_a), PlacedRound(b, pose_b))
                    : of_poses_as_given(a, pose_a, b, pose_b);
}

RoundAnswer round_round(const PlacedRound& a, const PlacedRound& b) {
  if (are_polyhedra(a.body, b.body)) {
    return round_answer(polyhedron_polyhedron(a.body.core(), a.pose, b.body.core(), b.pose));
  }
  RoundAnswer answer;
  Point3 way{};
  if (!decide_quickly(a.body, a.pose, b.body, b.pose, answer, way)) {
    search(a, b, way, answer);
  }
  return answer;
}

RoundAnswer round_round_by(PolyhedronMethod method, const RoundBody& a, const Pose& pose_a, const RoundBody& b,
                           const Pose& pose_b) {
  if (!are_polyhedra(a, b)) return round_round(a, pose_a, b, pose_b);
  return round_answer(method(a.core(), pose_a, b.core(), pose_b));
}

RoundAnswer round_round_warm(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b,
                             WarmStart& last) {
  if (!are_polyhedra(a, b)) return round_round(a, pose_a, b, pose_b);
  return round_answer(polyhedron_polyhedron_warm(a.core(), pose_a, b.core(), pose_b, last));
}

std::optional<RoundEvidence> apart_by_boxes(const RoundBody& a, const WorldBox& box_a, const RoundBody& b,
                                            const WorldBox& box_b) {
  const std::optional<Separation> boxes = apart_by_boxes(box_a, box_b);
  if (!boxes) return std::nullopt;
  if (are_polyhedra(a, b)) return *boxes;
  return SeparatingDirection{boxes->direction.given};
}

RoundContact round_round_contact(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence) {
  if (verdict_of(evidence) != Verdict::meet) return {};
  if (!are_polyhedra(a.body, b.body)) return contact_searched(a, b, evidence);
  const Interiors found = interiors(a.body.core(), a.pose, b.body.core(), b.pose);
  if (found.meet) return OverlappingAt{found.point};
  return TouchingAt{common_point_of(a, b, evidence), found.direction};
}

RoundDistance round_distance(const PlacedRound& a, const PlacedRound& b) {
  if (!are_polyhedra(a.body, b.body)) return distance_searched(a, b);
  const PolyhedronDistance found = polyhedron_polyhedron_distance(a.body.core(), a.pose, b.body.core(), b.pose);
  const auto take = [](const auto& evidence) { return RoundDistanceEvidence(evidence); };
  return {std::visit(take, found.evidence), found.decided_by, found.cost};
}

RoundCloser round_closer(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b, double least) {
  SUNDER_REQUIRE(least > 0 && std::isfinite(least));
  return are_polyhedra(a, b) ? closer_of_polyhedra(a, pose_a, b, pose_b, least)
                             : closer_searched(a, pose_a, b, pose_b, least);
}

EnclosedDepth depth_of_meeting(const PlacedRound& a, const PlacedRound& b, Cost& cost) {
  return are_hulls(a.body, b.body) ? depth_of_hulls(a, b, cost) : depth_of_curved(a, b, cost);
}

SweepAnswer round_round_sweep(const RoundBody& a, const Translation& of_a,  //
                              const RoundBody& b, const Translation& of_b) {
  return are_polyhedra(a, b) ? polyhedron_polyhedron_sweep(a.core(), of_a, b.core(), of_b)
                             : sweep_searched(a, of_a, b, of_b, are_hulls(a, b));
}

RoundFirstContact round_round_first_contact(const RoundBody& a, const Translation& of_a,  //
                                            const RoundBody& b, const Translation& of_b,  //
                                            const SweepAnswer& answer) {
  const SweepContact contact = contact_of(a, of_a, b, of_b, answer);
  if (contact.time.numerator.sign() == Sign::zero) return {{0, 0}, contact};
  if (!are_polyhedra(a, b)) return first_contact_searched(a, of_a, b, of_b, are_hulls(a, b), contact);
  SweepContact first = *polyhedron_polyhedron_first_contact(a.core(), of_a, b.core(), of_b);
  const Interval time = first.time.enclosure();
  return {time, std::move(first)};
}

Point3 rounded_point_of(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence) {
  const Point3 point = nearest(common_point_of(a, b, evidence).at);
  return {point.x + 0.0, point.y + 0.0, point.z + 0.0};
}

Point3 rounded_direction(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence) {
  const Point3 d = near_direction(a, b, evidence);
  const double largest = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  const Point3 e{d.x / largest, d.y / largest, d.z / largest};
  const double length = std::sqrt(e.x * e.x + e.y * e.y + e.z * e.z);
  return {e.x / length + 0.0, e.y / length + 0.0, e.z / length + 0.0};
}

RoundedGap rounded_gap(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence) {
  RoundSearch<DoubleDouble> search(a, b);
  const std::array<Dyadic, 3> d = direction_of(a, b, evidence);
  const Vector3<Interval> near = WorldDirection(Vector3<Dyadic>{d[0], d[1], d[2]}).enclosure();
  const Vector3<DoubleDouble> about{near.x.low, near.y.low, near.z.low};
  const DoubleDouble length = round_detail::root_of(dot(about, about));
  search.direction = {about.x / length, about.y / length, about.z / length};
  Cost cost;
  const DoubleDouble gap = search.gap_at(search.probe(cost)) - search.support.reach;
  return {rounded_direction(a, b, evidence), std::max(nearest(gap) / search.simplex.scale, 0.0)};
}

RoundEvidence separation_along(const WorldDirection& direction) {
  if (direction.is_doubles()) return SeparatingDirection{direction.doubles()};
  const Vector3<Dyadic> d = direction.exact();
  const Vector3<Interval> about = direction.enclosure();
  return ExactSeparatingDirection{{about.x.low, about.y.low, about.z.low},
                                  std::make_shared<const std::array<Dyadic, 3>>(std::array{d.x, d.y, d.z})};
}

namespace {

WorldDirection separating(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence) {
  if (const auto* of_polyhedra = std::get_if<Separation>(&evidence)) {
    const auto placed = [](const PlacedRound& body) {
      return PlacedVertices{body.body.core().vertices(), body.core.pose, body.core.tame};
    };
    return world_direction(of_polyhedra->direction, placed(a), placed(b));
  }
  if (const auto* doubles = std::get_if<SeparatingDirection>(&evidence)) return WorldDirection(doubles->direction);
  const auto& [x, y, z] = *std::get<ExactSeparatingDirection>(evidence).exact;
  return WorldDirection(Vector3<Dyadic>{x, y, z});
}

// How the bodies make their common point.
class CommonPointOf {
 public:
  CommonPointOf(const PlacedRound& a, const PlacedRound& b) : a_(a), b_(b) {}

  CommonPoint operator()(const CommonVertices& common) const { return common_point(common, a_.core, b_.core); }
  CommonPoint operator()(const CoresMeet& meet) const {
    CommonPoint point = common_point(meet.of_cores, a_.core, b_.core);
    point.of_a = in_points(a_, std::move(point.of_a));
    point.of_b = in_points(b_, std::move(point.of_b));
    return point;
  }
  CommonPoint operator()(const ExactCommonPoint& exact) const { return *exact.point; }
  CommonPoint operator()(const PointBetweenCores& between) const {
    return point_between(of_core(a_, between.of_a), a_.radius(), of_core(b_, between.of_b), b_.radius());
  }
  CommonPoint operator()(const PointInDoubles& point) const {
    const ExactPoint3 x = exact_point(weighted(point.at));
    const auto made = [&](const PlacedRound& body, const RoundCombination& c) {
      return made_by(body, x, round_detail::exact(c));
    };
    return {x, made(a_, point.of_a), made(b_, point.of_b)};
  }
  CommonPoint operator()(const PointOfCore& point) const {
    const auto [x, made] = of_core(point.is_of_a ? a_ : b_, point.made);
    const Combination of_curved = made_by(point.is_of_a ? b_ : a_, x);
    return point.is_of_a ? CommonPoint{x, made, of_curved} : CommonPoint{x, of_curved, made};
  }
  template <class Other>  // of bodies that do not meet
  CommonPoint operator()(const Other&) const {
    SUNDER_REQUIRE(false);
    return {};
  }

 private:
  static PointOf of_core(const PlacedRound& body, const RoundCombination& c) {
    return {exact_point(weighted(body, c)), round_detail::exact(c)};
  }

  const PlacedRound& a_;
  const PlacedRound& b_;
};

}  // namespace

std::array<Dyadic, 3> direction_of(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence) {
  const Vector3<Dyadic> d = separating(a, b, evidence).exact();
  return {d.x, d.y, d.z};
}

Point3 near_direction(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence) {
  if (const auto* undecided = std::get_if<NearlyTouching>(&evidence)) return undecided->direction;
  if (const auto* exact = std::get_if<ExactSeparatingDirection>(&evidence)) return exact->near;
  const WorldDirection direction = separating(a, b, evidence);
  if (direction.is_doubles()) return direction.doubles();
  const Vector3<Interval> about = direction.enclosure();
  return {about.x.low, about.y.low, about.z.low};
}

CommonPoint common_point_of(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence) {
  return std::visit(CommonPointOf(a, b), evidence);
}

}  // namespace sunder::solid
