#include <sunder/base/contract.h>
#include <sunder/predicate/point/simplex_origin.h>
#include <sunder/predicate/point/verified_inverse.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sunder {

namespace {

constexpr std::size_t most_corners = most_verified_rows;
using Matrix = std::array<double, most_corners * most_corners>;  // n by n, row by row

double middle(const Interval& x) { return x.low + (x.high - x.low) / 2; }

// At least the distance of each member of the interval to its middle.
double radius(const Interval& x) { return (x.high - x.low) * (1 + 0x1p-50) + 0x1p-1074; }

double size_of(const Interval& x) { return std::max(std::fabs(x.low), std::fabs(x.high)); }

}  // namespace

Guess least_weight_of_origin(std::span<const Interval> points, std::size_t d) {
  SUNDER_REQUIRE(d >= 2 && d < most_corners && points.size() == d * (d + 1));
  const std::size_t n = d + 1;
  Matrix m{}, off{}, inverse{};              // M, but for `off`
  std::array<double, most_corners> width{};  // of the rows of M: the sums of what they may be off
  for (std::size_t i = 0; i < n; ++i) {
    double greatest = 1;
    if (i < d) {
      greatest = 0;
      for (std::size_t k = 0; k < n; ++k) greatest = std::max(greatest, size_of(points[k * d + i]));
    }
    if (!(greatest > 0x1p-900 && greatest < 0x1p900)) return Guess::unsure;
    // A row times a power of two leaves the weights what they are.
    const double scale = std::ldexp(1.0, -std::ilogb(greatest));
    for (std::size_t k = 0; k < n; ++k) {
      m[i * n + k] = 1;
      if (i < d) {
        const Interval x = points[k * d + i] * Interval(scale);
        m[i * n + k] = middle(x);
        off[i * n + k] = radius(x);
      }
      width[i] += off[i * n + k];
    }
  }
  const std::size_t all = n * n;
  const double norm =
      verified_inverse(std::span(m).first(all), std::span(width).first(n), std::span(inverse).first(all));
  if (!(norm < 1)) return Guess::unsure;
  // Roundings, what underflows, and roundings of what is not negative, as in verified_inverse().
  const double unit = static_cast<double>(n + 2) * 0x1p-53;
  constexpr double lost = 0x1p-1060, more = 1 + 0x1p-40;
  std::array<double, most_corners> rest{};  // a bound of |e - M m|, where m is the last column of the inverse
  for (std::size_t i = 0; i < n; ++i) {
    double sum = i == d ? 1 : 0, magnitude = sum, slack = lost;
    for (std::size_t k = 0; k < n; ++k) {
      const double weight = inverse[k * n + d], product = m[i * n + k] * weight;
      sum -= product;
      magnitude += std::fabs(product);
      slack += off[i * n + k] * std::fabs(weight);
    }
    rest[i] = (std::fabs(sum) + unit * magnitude + slack) * more;
  }
  double error = 0;  // a bound of |R rest|
  for (std::size_t i = 0; i < n; ++i) {
    double of_rest = lost;
    for (std::size_t k = 0; k < n; ++k) of_rest += std::fabs(inverse[i * n + k]) * rest[k];
    if (!std::isfinite(of_rest)) return Guess::unsure;
    error = std::max(error, of_rest * more);
  }
  const double room = (1 - norm) * (1 - 0x1p-40);
  if (!(room > 0)) return Guess::unsure;
  for (std::size_t k = 0; k < n; ++k) {
    if (!(inverse[k * n + d] * room > error * more + lost)) return Guess::unsure;
  }
  return Guess::positive;
}

}  // namespace sunder
