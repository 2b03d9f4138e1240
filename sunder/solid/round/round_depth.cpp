#include <sunder/base/contract.h>
#include <sunder/certificate/common_point.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/polyhedron_polyhedron_depth.h>
#include <sunder/solid/round/round_depth.h>
#include <sunder/solid/round/round_depth_curved.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

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

// radii + sqrt(square / over), where `sign` is 1; radii - sqrt(square / over), which is not negative, where it is -1.
Interval radii_and_root(const Dyadic& radii, int sign, const Dyadic& square, const Dyadic& over) {
  return neighbours([&](double x) {
    const Dyadic rest = sign > 0 ? Dyadic(x) - radii : radii - Dyadic(x);  // against the root
    if (rest.sign() == Sign::negative) return sign > 0 ? Sign::negative : Sign::positive;
    const Sign of_squares = (rest * rest * over - square).sign();
    return sign > 0 ? of_squares : to_sign(static_cast<Guess>(-static_cast<std::int8_t>(of_squares)));
  });
}

// How the cores make a point that both have.
DepthPoints common_point(const Placed& a, const Placed& b, const CommonVertices& evidence) {
  const CommonPoint point = sunder::common_point(evidence, a, b);
  return {{point.at, point.of_a}, {point.at, point.of_b}};
}

void of_hulls(const PlacedRound& a, const PlacedRound& b, RoundDepth& found) {
  const Dyadic radii = Dyadic(a.radius()) + Dyadic(b.radius());
  const PolyhedronDepth cores = polyhedron_polyhedron_depth(a.body.core(), a.pose, b.body.core(), b.pose);
  found.cost = cores.answer.cost;
  if (!cores.meet()) {
    const PolyhedronDistance apart = polyhedron_polyhedron_distance(a.body.core(), a.pose, b.body.core(), b.pose);
    found.cost = apart.answer.cost;
    const auto [square, over] = apart.closest->squared();
    found.depth = radii_and_root(radii, -1, square, over);
    const ClosestPoints points = closest_points(*apart.closest);
    const std::array<Dyadic, 3> way = way_between(points.of_a, points.of_b);
    found.direction = WorldDirection(Vector3<Dyadic>{way[0], way[1], way[2]});
    found.points = std::make_shared<const DepthPoints>(DepthPoints{points.of_a, points.of_b});
    return;
  }
  found.direction = cores.direction;
  found.surface = cores.surface;
  if (cores.is_exact) {
    found.depth = radii_and_root(radii, 1, cores.squared[0], cores.squared[1]);
  } else {
    const Interval sum = Interval(cores.depth) + radii.enclosure();
    found.depth = {std::max(sum.low, 0.0), sum.high};
  }
  if (!found.surface) {
    found.points = std::make_shared<const DepthPoints>(
        common_point(a.core, b.core, std::get<CommonVertices>(cores.answer.evidence)));
    if (!cores.is_exact) found.depth.low = radii.enclosure().low;
  }
}

}  // namespace

RoundDepth round_depth(const PlacedRound& a, const PlacedRound& b) {
  RoundDepth found;
  const RoundAnswer answer = round_round(a, b);
  found.verdict = answer.verdict();
  if (found.meet()) {
    if (a.body.is_curved() || b.body.is_curved()) {
      depth_of_curved(a, b, found);
    } else {
      of_hulls(a, b, found);
    }
  }
  found.cost.probes += answer.cost.probes;
  found.cost.iterations += answer.cost.iterations;
  found.cost.exact += answer.cost.exact;
  return found;
}

RoundDepth round_depth(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b) {
  return round_depth(PlacedRound(a, pose_a), PlacedRound(b, pose_b));
}

void add_depth(ClaimsWriter& file, std::uint32_t index_a, std::uint32_t index_b, const RoundDepth& depth) {
  if (!depth.meet()) return;
  const auto [low, high] = depth.depth;
  if (std::isfinite(high)) {
    const Vector3<Dyadic> d = depth.direction->exact();
    add_depth_at_most(file, index_a, index_b, high, std::array{d.x, d.y, d.z});
  }
  if (!(low > 0)) return;
  if (depth.surface) return add_depth_at_least(file, index_a, index_b, low, *depth.surface);
  add_depth_at_least(file, index_a, index_b, low, *depth.points);
}

}  // namespace sunder::solid
