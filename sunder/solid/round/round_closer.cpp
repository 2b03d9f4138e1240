#include <sunder/predicate/point/along.h>
#include <sunder/predicate/point/shortest_way.h>
#include <sunder/solid/round/round_closer.h>
#include <sunder/solid/round/round_methods.h>

#include <array>
#include <span>
#include <utility>

namespace sunder::solid {

namespace {

Point3 rounded_way(const WorldDirection& direction) {
  const Vector3<Interval> enclosed = direction.enclosure();
  return {enclosed.x.low, enclosed.y.low, enclosed.z.low};
}

// Mostly intervals tell it; else it costs exact numbers.
Point3 rounded_way(const ClosestFeatures& closest) {
  const FeatureVertices& of = closest.features();
  const std::array<Posed3, 4> images = closest.images();
  const std::span<const Posed3> all(images);
  const EnclosedWay enclosed = enclosed_way(all.first(of.count_a), all.subspan(of.count_a, of.count_b));
  if (enclosed.weights == Guess::positive) return {enclosed.way.x.low, enclosed.way.y.low, enclosed.way.z.low};
  return rounded_way(WorldDirection(closest.way().way.way));
}

}  // namespace

RoundCloser closer_of_polyhedra(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b,
                                double least) {
  const PolyhedronDistance found = polyhedron_polyhedron_distance(a.core(), pose_a, b.core(), pose_b);
  RoundCloser answer{{}, found.decided_by, found.cost};
  if (const auto* common = std::get_if<CommonVertices>(&found.evidence)) {
    answer.evidence = Nearer{*common};
  } else if (const ClosestFeatures& closest = *closest_of(found); compare_distance(found, least) == Sign::negative) {
    answer.evidence = Nearer{closest};
  } else {
    answer.evidence = closest;
  }
  return answer;
}

RoundCloser closer_searched(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b,
                            double least) {
  const PlacedRound in_a(a, pose_a), in_b(b, pose_b);
  RoundClearance found = round_clearance(in_a, in_b, least);
  RoundCloser answer{{}, found.decided_by, found.cost};
  if (auto* kept = std::get_if<ClearanceKept>(&found.evidence)) {
    answer.evidence = std::move(*kept);
    return answer;
  }
  RoundDistance distance = round_distance(in_a, in_b);
  answer.cost.exact += distance.cost.exact;
  if (found.undecided()) {
    answer.evidence = PerhapsNearer{std::move(distance.evidence)};
  } else {
    answer.evidence = Nearer{std::move(distance.evidence)};
  }
  return answer;
}

Point3 rounded_way(const RoundCloser& apart) {
  if (const auto* closest = std::get_if<ClosestFeatures>(&apart.evidence)) return rounded_way(*closest);
  return rounded_way(std::get<ClearanceKept>(apart.evidence).direction);
}

}  // namespace sunder::solid
