#include <sunder/predicate/exact_point.h>

namespace sunder {

Point2 nearest(const ExactPoint2& p) { return {nearest_ratio(p.x, p.denominator), nearest_ratio(p.y, p.denominator)}; }

Point3 nearest(const ExactPoint3& p) {
  return {nearest_ratio(p.x, p.denominator), nearest_ratio(p.y, p.denominator), nearest_ratio(p.z, p.denominator)};
}

}  // namespace sunder
