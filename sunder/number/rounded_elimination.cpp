#include <sunder/base/contract.h>
#include <sunder/number/rounded_elimination_internal.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace sunder {

RoundedElimination::RoundedElimination(std::size_t rows, std::size_t columns) : height_(rows), width_(columns) {
  SUNDER_REQUIRE(rows <= most && columns <= most);
  std::iota(columns_.begin(), columns_.end(), std::size_t{0});
}

std::optional<std::size_t> RoundedElimination::step(double least) {
  std::size_t row = rank_, place = rank_;
  double greatest = least;
  for (std::size_t r = rank_; r < height_; ++r) {
    for (std::size_t k = rank_; k < width_; ++k) {
      const double size = std::fabs(rows_[r][columns_[k]]);
      if (!(size > greatest)) continue;
      greatest = size;
      row = r;
      place = k;
    }
  }
  if (!(greatest > least) || std::isinf(greatest)) return std::nullopt;
  if (row != rank_) std::swap(rows_[row], rows_[rank_]);
  const auto first = columns_.begin() + static_cast<std::ptrdiff_t>(rank_);
  std::rotate(first, columns_.begin() + static_cast<std::ptrdiff_t>(place),
              columns_.begin() + static_cast<std::ptrdiff_t>(place + 1));
  const std::array<double, most>& by = rows_[rank_];
  for (std::size_t r = rank_ + 1; r < height_; ++r) {
    const double factor = rows_[r][*first] / by[*first];
    for (std::size_t k = rank_; k < width_; ++k) rows_[r][columns_[k]] -= factor * by[columns_[k]];
  }
  ++rank_;
  return row;
}

bool rounded_inverse(std::size_t n, std::span<const double> matrix, std::span<double> inverse) {
  constexpr std::size_t most = RoundedElimination::most;
  SUNDER_REQUIRE(n >= 1 && n <= most && matrix.size() == n * n && inverse.size() == n * n);
  std::array<std::array<double, 2 * most>, most> rows{};  // beside the identity
  std::array<double, most> size{};
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

}  // namespace sunder
