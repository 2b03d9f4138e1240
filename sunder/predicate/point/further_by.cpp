#include <sunder/predicate/point/further_by.h>

#include <sunder/predicate/coordinates.h>

namespace sunder {

bool is_further_by(const WorldDirection& direction, const Posed3& from, const Posed3& to,
                   const ExactFraction& squared) {
  const Vector3<Dyadic> d = direction.exact();
  const Dyadic gap = dot(d, coordinates<Dyadic>(to) - coordinates<Dyadic>(from));
  return gap.sign() != Sign::negative &&
         (gap * gap * squared.denominator - dot(d, d) * squared.numerator).sign() != Sign::negative;
}

}  // namespace sunder
