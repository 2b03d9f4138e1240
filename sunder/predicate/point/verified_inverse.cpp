#include <sunder/base/contract.h>
#include <sunder/number/rounded_elimination_internal.h>
#include <sunder/predicate/point/verified_inverse.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sunder {

namespace {

constexpr double no_inverse = std::numeric_limits<double>::infinity();

}  // namespace

// An entry of I - R M is a number less n products: at most n + 1 roundings each, so off by at most (n + 2) 2^-53 times
// the sum of their sizes. Of a row these are 1 + sum_k |r_k| (the sum of sizes of row k of M). What underflows in its
// n^2 products is less than `lost`. The rest is sums of few numbers that are not negative: `more` pays for their
// roundings.
double verified_inverse(std::span<const double> matrix, std::span<const double> width, std::span<double> inverse) {
  const std::size_t n = width.size();
  SUNDER_REQUIRE(n >= 1 && n <= most_verified_rows && matrix.size() == n * n && inverse.size() == n * n);
  if (!rounded_inverse(n, matrix, inverse)) return no_inverse;
  const double unit = static_cast<double>(n + 2) * 0x1p-53;
  constexpr double lost = 0x1p-1060, more = 1 + 0x1p-40;
  std::array<double, most_verified_rows> off{};  // of row k, times |r_k|: its roundings, and its width
  for (std::size_t k = 0; k < n; ++k) {
    double size = 0;
    for (std::size_t j = 0; j < n; ++j) size += std::fabs(matrix[k * n + j]);
    off[k] = unit * size + width[k];
  }
  double most = 0;
  for (std::size_t i = 0; i < n; ++i) {
    std::array<double, most_verified_rows> e{};
    e[i] = 1;
    double sum = unit + lost;
    for (std::size_t k = 0; k < n; ++k) {
      const double r = inverse[i * n + k];
      for (std::size_t j = 0; j < n; ++j) e[j] -= r * matrix[k * n + j];
      sum += std::fabs(r) * off[k];
    }
    for (std::size_t j = 0; j < n; ++j) sum += std::fabs(e[j]);
    if (!std::isfinite(sum)) return no_inverse;
    most = std::max(most, sum * more);
  }
  return most;
}

}  // namespace sunder
