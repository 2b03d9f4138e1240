#include <sunder/base/contract.h>
#include <sunder/polytope/pair/orthogonal_complement.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::polytope {

namespace {

constexpr double nothing = 0x1p-40;  // of the length of a vector

}  // namespace

OrthogonalComplement::OrthogonalComplement(std::size_t n) : n_(n), dimension_(n) {
  SUNDER_REQUIRE(n <= most_columns);
  for (std::size_t k = 0; k < n; ++k) base_[k][k] = 1;
}

ColumnNumbers OrthogonalComplement::coordinates(const ColumnNumbers& vector) const {
  ColumnNumbers result{};
  for (std::size_t k = 0; k < dimension_; ++k) {
    for (std::size_t c = 0; c < n_; ++c) result[k] += base_[k][c] * vector[c];
  }
  return result;
}

ColumnNumbers OrthogonalComplement::vector(const ColumnNumbers& coordinates) const {
  ColumnNumbers result{};
  for (std::size_t k = 0; k < dimension_; ++k) {
    for (std::size_t c = 0; c < n_; ++c) result[c] += coordinates[k] * base_[k][c];
  }
  return result;
}

// With u the coordinates, j the greatest of them, and h = u + s |u| e_j, s the sign of u_j: the reflection that turns h
// round takes e_j to -s u / |u|, so it takes the other base vectors to a base of what is orthogonal to u.
bool OrthogonalComplement::take_out(const ColumnNumbers& vector) {
  ColumnNumbers h = coordinates(vector);
  double square = 0, whole = 0;
  std::size_t greatest = 0;
  for (std::size_t c = 0; c < n_; ++c) whole += vector[c] * vector[c];
  for (std::size_t k = 0; k < dimension_; ++k) {
    square += h[k] * h[k];
    if (std::fabs(h[k]) > std::fabs(h[greatest])) greatest = k;
  }
  if (!(square > whole * (nothing * nothing))) return false;
  h[greatest] += std::copysign(std::sqrt(square), h[greatest]);
  const double square_of_h = 2 * std::fabs(h[greatest]) * std::sqrt(square);  // |h|^2 = 2 |u| (|u| + |u_j|)
  if (!std::isfinite(square_of_h)) return false;
  const ColumnNumbers along = this->vector(h);
  for (std::size_t k = 0; k < dimension_; ++k) {
    for (std::size_t c = 0; c < n_; ++c) base_[k][c] -= 2 * h[k] / square_of_h * along[c];
  }
  --dimension_;
  std::swap(base_[greatest], base_[dimension_]);
  return true;
}

}  // namespace sunder::polytope
