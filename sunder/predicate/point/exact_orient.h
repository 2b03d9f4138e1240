// The orientation of four points with exact coordinates: estimates first, then exact numbers.
#pragma once

#include <sunder/number/estimate.h>
#include <sunder/number/sign.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/exact_point.h>
#include <sunder/predicate/posed.h>

namespace sunder {

// A point to about 100 bits, with bounds of the errors; both numerators and denominator times some power of two.
struct EstimatedPoint3 {
  Vector3<Estimate> numerators{};
  Estimate denominator{1.0};
};

// Requires a positive denominator.
EstimatedPoint3 estimated(const ExactPoint3& p);
inline EstimatedPoint3 estimated(const Point3& p) { return {{p.x, p.y, p.z}, 1.0}; }

// The sign of orient_3d (predicate/point/orient.h), where estimates tell.
Guess guess_orient_3d(const EstimatedPoint3& a, const EstimatedPoint3& b, const EstimatedPoint3& c,
                      const EstimatedPoint3& d);

// That sign. Requires positive denominators.
Sign orient_3d(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c, const ExactPoint3& d,
               StageTally* tally = nullptr);

}  // namespace sunder
