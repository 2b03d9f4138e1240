// On which side of a plane is a posed point? Exact, for every finite double.
// Also called: half-space test; signed distance to a plane, its sign.
#pragma once

#include <sunder/number/estimate.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/posed.h>

namespace sunder {

// positive: the image of p is above the plane of the points x with normal . (x - point) = offset, where the normal
// points to; zero: on it; negative: below. Formula: normal . (p - point) - offset.
inline Sign side_of_plane(const Point3& normal, const Point3& point, double offset, const Posed3& p,
                          StageTally* tally = nullptr) {
  const auto formula = [](const auto& n, const auto& on, const auto& d, const auto& x) { return dot(n, x - on) - d.x; };
  return decide(tally, formula, normal, point, Point3{offset, 0, 0}, p);
}

// Above the plane through `point` with this normal, of which estimates are known: the sign of normal . (p - point), or
// where they do not tell, that of exact(), which returns it as an exact number.
template <class Exact>
Sign side_of_plane(const Vector3<Estimate>& normal, const Vector3<Estimate>& point, const Vector3<Estimate>& p,
                   const Exact& exact, StageTally* tally = nullptr) {
  const Guess guess = sign(dot(normal, p - point));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, exact().sign());
}

}  // namespace sunder
