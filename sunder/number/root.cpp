#include <sunder/base/contract.h>
#include <sunder/number/root.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace sunder {

Interval root(const ExactFraction& square) {
  const auto& [numerator, denominator] = square;
  SUNDER_REQUIRE(numerator.sign() != Sign::negative && denominator.sign() == Sign::positive);
  if (numerator.sign() == Sign::zero) return {0.0};
  std::int64_t shift = numerator.top() - denominator.top();
  shift -= shift & 1;
  constexpr double largest = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  const int power = static_cast<int>(std::clamp<std::int64_t>(shift / 2, -2000, 2000));
  double low = std::min(std::ldexp(std::sqrt(nearest_ratio(numerator.scaled(-shift), denominator)), power), largest);
  while (compare_root(square, low) == Sign::negative) low = std::nextafter(low, 0.0);
  while (low < largest && compare_root(square, std::nextafter(low, infinity)) != Sign::negative)
    low = std::nextafter(low, infinity);
  return {low, compare_root(square, low) == Sign::zero ? low : std::nextafter(low, infinity)};
}

std::optional<Interval> sure_root(const Estimate& numerator, const Estimate& denominator) {
  const double root = std::sqrt(numerator.value.high / denominator.value.high);
  if (!(root > 0 && root < 0x1p1000)) return std::nullopt;
  const auto compared = [&](double x) { return sign(Estimate(x) * Estimate(x) * denominator - numerator); };
  double low = root, high = root;
  switch (compared(root)) {
    case Guess::negative: high = std::nextafter(root, HUGE_VAL); break;
    case Guess::positive: low = std::nextafter(root, 0.0); break;
    default: return std::nullopt;
  }
  // Is it between them?
  if (compared(low) != Guess::negative || compared(high) != Guess::positive) return std::nullopt;
  return Interval{low, high};
}

}  // namespace sunder
