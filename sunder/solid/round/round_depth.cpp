#include <sunder/base/contract.h>
#include <sunder/certificate/common_point.h>
#include <sunder/number/root.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/polyhedron_polyhedron_depth.h>
#include <sunder/solid/round/round_depth.h>
#include <sunder/solid/round/round_methods.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>

namespace sunder::solid {

namespace {

constexpr double largest = std::numeric_limits<double>::max();

// The doubles next to a number that is not negative, both it if it is one. compared(x): the sign of x less it, where x
// is not negative. By halving, in the order of the doubles: what is left of the radii may be far below these.
template <class Compared>
Interval neighbours(const Compared& compared) {
  const auto at = [](std::uint64_t bits) { return std::bit_cast<double>(bits); };
  std::uint64_t low = 0, high = std::bit_cast<std::uint64_t>(largest) + 1;
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (compared(at(middle)) == Sign::positive ? high : low) = middle;
  }
  return {at(low), compared(at(low)) == Sign::zero ? at(low) : at(high)};
}

// radii + sqrt(square), where `sign` is 1; radii - sqrt(square), which is not negative, where it is -1.
Interval radii_and_root(const Dyadic& radii, int sign, const ExactFraction& square) {
  return neighbours([&](double x) {
    const Dyadic rest = sign > 0 ? Dyadic(x) - radii : radii - Dyadic(x);  // against the root
    if (rest.sign() == Sign::negative) return sign > 0 ? Sign::negative : Sign::positive;
    const Sign of_root = compare_root(square, rest);
    return sign > 0 ? -of_root : of_root;
  });
}

// A bound of 0 needs no proof.
EnclosedDepth proved(EnclosedDepth found) {
  if (!(found.depth.low > 0)) found.proof_of_low = {};
  return found;
}

// How the cores make a point that both have.
DepthPoints common_point(const Placed& a, const Placed& b, const CommonVertices& evidence) {
  const CommonPoint point = sunder::common_point(evidence, a, b);
  return {{point.at, point.of_a}, {point.at, point.of_b}};
}

}  // namespace

EnclosedDepth depth_of_hulls(const PlacedRound& a, const PlacedRound& b, Cost& cost) {
  const Dyadic radii = Dyadic(a.radius()) + Dyadic(b.radius());
  const PolyhedronDepth cores = polyhedron_polyhedron_depth(a.body.core(), a.pose, b.body.core(), b.pose);
  cost = cores.cost;
  const PolyhedraOverlap* overlap = overlap_of(cores);
  if (overlap == nullptr) {
    const PolyhedronDistance apart = polyhedron_polyhedron_distance(a.body.core(), a.pose, b.body.core(), b.pose);
    cost = apart.cost;
    const ClosestFeatures& closest = *closest_of(apart);
    const ClosestPoints points = closest_points(closest);
    const std::array<Dyadic, 3> way = way_between(points.of_a, points.of_b);
    return proved({radii_and_root(radii, -1, closest.squared()),
                   WorldDirection(Vector3<Dyadic>{way[0], way[1], way[2]}), DepthPoints{points.of_a, points.of_b}});
  }
  EnclosedDepth found = *overlap;
  const bool has_surface = std::holds_alternative<DepthSurface>(found.proof_of_low);
  if (overlap->exact) {
    found.depth = radii_and_root(radii, 1, overlap->exact->squared);
  } else {
    const Interval sum = overlap->depth + radii.enclosure();
    found.depth = {std::max(has_surface ? sum.low : radii.enclosure().low, 0.0), sum.high};
  }
  if (!has_surface) found.proof_of_low = common_point(a.core, b.core, overlap->common);
  return proved(std::move(found));
}

RoundDepth round_depth(const PlacedRound& a, const PlacedRound& b) {
  RoundAnswer answer = round_round(a, b);
  RoundDepth found;
  if (!answer.meet()) {
    std::visit(
        [&](auto& evidence) {
          if constexpr (std::is_constructible_v<decltype(found.evidence), decltype(evidence)>) {
            found.evidence = std::move(evidence);
          }
        },
        answer.evidence);
  } else {
    found.evidence = depth_of_meeting(a, b, found.cost);
  }
  found.cost.probes += answer.cost.probes;
  found.cost.iterations += answer.cost.iterations;
  conclude(found, found.cost.exact + answer.cost.exact, answer.decided_by == DecidedBy::finishing);
  return found;
}

RoundDepth round_depth(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b) {
  return round_depth(PlacedRound(a, pose_a), PlacedRound(b, pose_b));
}

}  // namespace sunder::solid
