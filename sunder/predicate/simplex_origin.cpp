#include <sunder/base/contract.h>
#include <sunder/predicate/simplex_origin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sunder {

namespace {

constexpr std::size_t most_corners = 7;
using Matrix = std::array<std::array<double, most_corners>, most_corners>;

double middle(const Interval& x) { return x.low + (x.high - x.low) / 2; }

// At least the distance of each member of the interval to its middle.
double radius(const Interval& x) { return (x.high - x.low) * (1 + 0x1p-50) + 0x1p-1074; }

double size_of(const Interval& x) { return std::max(std::fabs(x.low), std::fabs(x.high)); }

// Nearly the inverse; false where elimination finds none. Nothing about it is believed.
bool invert(Matrix m, std::size_t n, Matrix& inverse) {
  inverse = {};
  for (std::size_t i = 0; i < n; ++i) inverse[i][i] = 1;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t p = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::fabs(m[i][k]) > std::fabs(m[p][k])) p = i;
    }
    if (!(std::fabs(m[p][k]) > 0)) return false;
    std::swap(m[p], m[k]);
    std::swap(inverse[p], inverse[k]);
    const double by = 1 / m[k][k];
    for (std::size_t j = 0; j < n; ++j) {
      m[k][j] *= by;
      inverse[k][j] *= by;
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = m[i][k];
      for (std::size_t j = 0; j < n; ++j) {
        m[i][j] -= factor * m[k][j];
        inverse[i][j] -= factor * inverse[k][j];
      }
    }
  }
  return true;
}

}  // namespace

Guess least_weight_of_origin(std::span<const Interval> points, std::size_t d) {
  SUNDER_REQUIRE(d >= 2 && d < most_corners && points.size() == d * (d + 1));
  const std::size_t n = d + 1;
  Matrix m{}, inverse{};                             // M, but for `width`
  std::array<double, most_corners> size{}, width{};  // of the rows of M: sums of sizes, and of what m may be off
  Matrix off{};
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
      m[i][k] = 1;
      if (i < d) {
        const Interval x = points[k * d + i] * Interval(scale);
        m[i][k] = middle(x);
        off[i][k] = radius(x);
      }
      size[i] += std::fabs(m[i][k]);
      width[i] += off[i][k];
    }
  }
  if (!invert(m, n, inverse)) return Guess::unsure;
  // Sums of n products and one more number have at most n + 1 roundings each; `lost` is more than what underflows. What
  // follows is sums of few numbers that are not negative: `more` pays for their roundings.
  const double unit = static_cast<double>(n + 2) * 0x1p-53;
  constexpr double lost = 0x1p-1060, more = 1 + 0x1p-40;
  std::array<double, most_corners> rest{};  // a bound of |e - M m|, where m is the last column of the inverse
  for (std::size_t i = 0; i < n; ++i) {
    double sum = i == d ? 1 : 0, magnitude = sum, slack = lost;
    for (std::size_t k = 0; k < n; ++k) {
      const double weight = inverse[k][d], product = m[i][k] * weight;
      sum -= product;
      magnitude += std::fabs(product);
      slack += off[i][k] * std::fabs(weight);
    }
    rest[i] = (std::fabs(sum) + unit * magnitude + slack) * more;
  }
  double norm = 0, error = 0;  // bounds of |E| and |R rest|
  for (std::size_t i = 0; i < n; ++i) {
    std::array<double, most_corners> e{};
    e[i] = 1;
    double slack = unit + lost, of_rest = lost;
    for (std::size_t k = 0; k < n; ++k) {
      const double r = inverse[i][k];
      for (std::size_t j = 0; j < n; ++j) e[j] -= r * m[k][j];
      slack += std::fabs(r) * (unit * size[k] + width[k]);
      of_rest += std::fabs(r) * rest[k];
    }
    for (std::size_t j = 0; j < n; ++j) slack += std::fabs(e[j]);
    if (!std::isfinite(slack) || !std::isfinite(of_rest)) return Guess::unsure;
    norm = std::max(norm, slack * more);
    error = std::max(error, of_rest * more);
  }
  const double room = (1 - norm) * (1 - 0x1p-40);
  if (!(room > 0)) return Guess::unsure;
  for (std::size_t k = 0; k < n; ++k) {
    if (!(inverse[k][d] * room > error * more + lost)) return Guess::unsure;
  }
  return Guess::positive;
}

}  // namespace sunder
