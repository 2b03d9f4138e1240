#include <sunder/predicate/point/exact_orient.h>

#include <cmath>
#include <cstdint>

namespace sunder {

namespace {

Estimate estimate_of(const Dyadic& x) {
  const double high = x.nearest();
  if (!std::isfinite(high)) return {DoubleDouble(high), high > 0 ? high : -high};
  const double low = (x - Dyadic(high)).nearest();
  return {DoubleDouble{high, low}, std::fabs(low) * 0x1p-52 + 0x1p-1060};
}

// Times the denominators of both points, which are positive.
template <class Point>
auto difference(const Point& to, const Point& from) {
  const auto axis = [&](const auto& t, const auto& f) { return t * from.denominator - f * to.denominator; };
  const auto t = to.numerators, f = from.numerators;
  return Vector3<decltype(axis(t.x, f.x))>{axis(t.x, f.x), axis(t.y, f.y), axis(t.z, f.z)};
}

template <class Point>
auto orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  return dot(cross(difference(b, a), difference(c, a)), difference(d, a));
}

struct Exact {
  Vector3<Dyadic> numerators;
  Dyadic denominator;
  explicit Exact(const ExactPoint3& p) : numerators(p.numerators()), denominator(p.denominator) {}
};

}  // namespace

EstimatedPoint3 estimated(const ExactPoint3& p) {
  const std::int64_t scale = -p.denominator.top();
  const auto part = [&](const Dyadic& x) { return estimate_of(x.scaled(scale)); };
  return {{part(p.x), part(p.y), part(p.z)}, part(p.denominator)};
}

Guess guess_orient_3d(const EstimatedPoint3& a, const EstimatedPoint3& b, const EstimatedPoint3& c,
                      const EstimatedPoint3& d) {
  return sign(orientation(a, b, c, d));
}

Sign orient_3d(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c, const ExactPoint3& d,
               StageTally* tally) {
  const Guess guess = guess_orient_3d(estimated(a), estimated(b), estimated(c), estimated(d));
  if (is_sure(guess)) return counted(&StageTally::rounded, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, orientation(Exact(a), Exact(b), Exact(c), Exact(d)).sign());
}

}  // namespace sunder
