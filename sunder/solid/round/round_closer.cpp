#include <sunder/base/contract.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>
#include <sunder/solid/round/round_closer.h>
#include <sunder/solid/round/round_propose.h>

#include <cmath>

namespace sunder::solid {

namespace {

// Is a common point strictly within the radii?
bool is_strict(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence) {
  using Source = RoundEvidence::Source;
  if (evidence.source == Source::cores) return true;  // of the cores, and A's radius is above 0
  if (evidence.source != Source::between) return false;
  return nearness(round_detail::weighted(a, evidence.a), a.radius(), round_detail::weighted(b, evidence.b),
                  b.radius()) == Sign::positive;
}

}  // namespace

RoundCloser round_closer(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b, double least) {
  SUNDER_REQUIRE(!a.is_curved() && !b.is_curved() && least > 0 && std::isfinite(least));
  require_rigid(a, pose_a);
  require_rigid(b, pose_b);
  const double grown = a.radius() + least;
  RoundCloser found;
  // The sum of the radii has to be exact.
  if (grown - a.radius() == least && grown - least == a.radius() && std::isfinite(grown)) {
    const RoundBody larger = RoundBody::rounded(a.core(), grown);
    const PlacedRound of_a(larger, pose_a), of_b(b, pose_b);
    found.answer = round_round(of_a, of_b);
    if (found.answer.verdict() == RoundVerdict::apart) return found;
    found.is_closer = found.answer.meet() && is_strict(of_a, of_b, found.answer.evidence);
    if (found.is_closer) return found;
    found.answer = {};
  }
  const PolyhedronDistance cores = polyhedron_polyhedron_distance(a.core(), pose_a, b.core(), pose_b);
  if (cores.closest) {
    const auto [square, over] = cores.closest->squared();
    const Dyadic reach = Dyadic(a.radius()) + Dyadic(b.radius()) + Dyadic(least);
    found.is_closer = (reach * reach * over - square).sign() == Sign::positive;
  } else {
    found.is_closer = true;
  }
  return found;
}

}  // namespace sunder::solid
