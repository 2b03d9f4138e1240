#include <sunder/base/contract.h>
#include <sunder/predicate/point/verified_inverse.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace sunder {

namespace {

constexpr double no_inverse = std::numeric_limits<double>::infinity();

// Gauss-Jordan elimination of the matrix beside the identity. Nothing about it is believed. The pivot of a column is
// the greatest number, for the size of its row: rows may be of very different sizes.
bool invert_nearly(std::span<const double> matrix, std::size_t n, std::span<double> inverse) {
  std::array<std::array<double, 2 * most_verified_rows>, most_verified_rows> rows{};
  std::array<double, most_verified_rows> size{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      rows[i][j] = matrix[i * n + j];
      size[i] = std::max(size[i], std::fabs(rows[i][j]));
    }
    if (!(size[i] > 0)) return false;
    rows[i][n + i] = 1;
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t p = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::fabs(rows[i][k]) / size[i] > std::fabs(rows[p][k]) / size[p]) p = i;
    }
    if (!(std::fabs(rows[p][k]) > 0)) return false;
    std::swap(rows[p], rows[k]);
    std::swap(size[p], size[k]);
    const double by = 1 / rows[k][k];
    for (std::size_t j = 0; j < 2 * n; ++j) rows[k][j] *= by;
    for (std::size_t i = 0; i < n; ++i) {
      const double factor = rows[i][k];
      if (i == k || factor == 0) continue;
      for (std::size_t j = 0; j < 2 * n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) inverse[i * n + j] = rows[i][n + j];
  }
  return true;
}

}  // namespace

// An entry of I - R M is a number less n products: at most n + 1 roundings each, so off by at most (n + 2) 2^-53 times
// the sum of their sizes. Of a row these are 1 + sum_k |r_k| (the sum of sizes of row k of M). What underflows in its
// n^2 products is less than `lost`. The rest is sums of few numbers that are not negative: `more` pays for their
// roundings.
double verified_inverse(std::span<const double> matrix, std::span<const double> width, std::span<double> inverse) {
  const std::size_t n = width.size();
  SUNDER_REQUIRE(n >= 1 && n <= most_verified_rows && matrix.size() == n * n && inverse.size() == n * n);
  if (!invert_nearly(matrix, n, inverse)) return no_inverse;
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
