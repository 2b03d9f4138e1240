#include <sunder/base/contract.h>
#include <sunder/predicate/simplex_origin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sunder {

namespace {

constexpr std::size_t most = 7;
template <class Number>
using Matrix = std::array<std::array<Number, most>, most>;

double middle(const Interval& x) { return x.low + (x.high - x.low) / 2; }

double size_of(const Interval& x) { return std::max(std::fabs(x.low), std::fabs(x.high)); }

// Nearly the inverse; false where elimination finds none. Nothing about it is believed.
bool invert(Matrix<double> m, std::size_t n, Matrix<double>& inverse) {
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
  SUNDER_REQUIRE(d >= 2 && d < most && points.size() == d * (d + 1));
  const std::size_t n = d + 1;
  Matrix<Interval> m;
  Matrix<double> rounded{}, inverse{};
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
      m[i][k] = i < d ? points[k * d + i] * Interval(scale) : Interval(1.0);
      rounded[i][k] = middle(m[i][k]);
    }
  }
  if (!invert(rounded, n, inverse)) return Guess::unsure;
  std::array<Interval, most> rest{};  // e - M m, where m is the last column of the inverse
  for (std::size_t i = 0; i < n; ++i) {
    Interval sum = i == d ? Interval(1.0) : Interval(0.0);
    for (std::size_t k = 0; k < n; ++k) sum = sum - m[i][k] * Interval(inverse[k][d]);
    rest[i] = sum;
  }
  Interval norm(0.0), error(0.0);  // upper ends count: bounds of |E| and |R rest|
  for (std::size_t i = 0; i < n; ++i) {
    Interval row_sum(0.0), product(0.0);
    for (std::size_t k = 0; k < n; ++k) {
      Interval e = i == k ? Interval(1.0) : Interval(0.0);
      for (std::size_t j = 0; j < n; ++j) e = e - Interval(inverse[i][j]) * m[j][k];
      row_sum = row_sum + Interval(size_of(e));
      product = product + Interval(inverse[i][k]) * rest[k];
    }
    norm = {0.0, std::max(norm.high, row_sum.high)};
    error = {0.0, std::max(error.high, size_of(product))};
  }
  const Interval room = Interval(1.0) - Interval(norm.high);
  if (sign(room) != Guess::positive) return Guess::unsure;
  for (std::size_t k = 0; k < n; ++k) {
    if (sign(Interval(inverse[k][d]) * room - Interval(error.high)) != Guess::positive) return Guess::unsure;
  }
  return Guess::positive;
}

}  // namespace sunder
