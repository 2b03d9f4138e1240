#include <sunder/base/contract.h>
#include <sunder/predicate/common_point.h>
#include <sunder/scene/rounded_evidence.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace sunder::scene {

namespace {

// The number is about mantissa * 2^exponent, 1/2 <= |mantissa| < 1 (or 0), with any exponent.
struct Split {
  double mantissa = 0;
  std::int64_t exponent = 0;
};

Split split(const Dyadic& x) {
  if (x.sign() == Sign::zero) return {};
  return {x.scaled(-x.top() - 1).nearest(), x.top() + 1};
}

double joined(double mantissa, std::int64_t exponent) {
  constexpr std::int64_t far = 4000;  // beyond all doubles
  return std::ldexp(mantissa, static_cast<int>(std::clamp(exponent, -far, far)));
}

}  // namespace

Point3 rounded_common_point(const PairCertificate& c, const PlacedVertices& a, const PlacedVertices& b) {
  SUNDER_REQUIRE(c.verdict == Verdict::meet);
  std::array<Posed3, 5> points{};
  const std::size_t n = std::size_t{c.count_a} + c.count_b;
  for (std::size_t i = 0; i < n; ++i) points[i] = i < c.count_a ? a[c.vertices[i]] : b[c.vertices[i]];
  const std::span<const Posed3> all(points.data(), n);
  const CommonPointWeights weights = common_point_weights(all.first(c.count_a), all.subspan(c.count_a));
  const Split denominator = split(weights.denominator);
  const auto coordinate = [&](std::size_t k) {
    const Split numerator = split(weights.point[k]);
    return joined(numerator.mantissa / denominator.mantissa, numerator.exponent - denominator.exponent);
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

RoundedGap rounded_gap(const PairCertificate& c, const PlacedVertices& a, const PlacedVertices& b) {
  SUNDER_REQUIRE(c.verdict == Verdict::apart);
  const Vector3<Dyadic> d = world_direction(c.direction, a, b).exact();
  // Scaled by a power of two so that the largest component is in [1/2, 1).
  const Split x = split(d.x), y = split(d.y), z = split(d.z);
  std::int64_t shift = std::numeric_limits<std::int64_t>::min();
  for (const Split& s : {x, y, z}) {
    if (s.mantissa != 0) shift = std::max(shift, s.exponent);
  }
  const auto scaled = [&](const Split& s) { return s.mantissa == 0 ? 0 : joined(s.mantissa, s.exponent - shift); };
  const Point3 near{scaled(x), scaled(y), scaled(z)};
  const double length = std::sqrt(near.x * near.x + near.y * near.y + near.z * near.z);

  const Vector3<Dyadic> between = lift<ExactStage>(b[c.extreme_b]) - lift<ExactStage>(a[c.extreme_a]);
  const Split width = split(dot(d, between));
  return {{near.x / length, near.y / length, near.z / length}, joined(width.mantissa / length, width.exponent - shift)};
}

}  // namespace sunder::scene
