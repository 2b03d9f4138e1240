// Elimination in floating point, of small matrices: it proposes, and nothing about it is believed. For sources, not
// installed.
// Also called: Gauss elimination with complete pivoting; Gauss-Jordan elimination.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace sunder {

// Rows and columns that are independent, as floating point has it: of all numbers that are left the greatest first; of
// equal ones that of the first row, and there of the first column.
class RoundedElimination {
 public:
  static constexpr std::size_t most = 7;

  // Zeros. Requires at most 7 rows and 7 columns.
  RoundedElimination(std::size_t rows, std::size_t columns);

  std::array<double, most>& operator[](std::size_t row) { return rows_[row]; }

  // Puts the row of the greatest number left at the place rank(), and takes out of the rows behind it what they have in
  // its column. Returns where that row was; nothing, and changes nothing, where no number left is greater than `least`,
  // which is not negative, or the greatest is infinite.
  std::optional<std::size_t> step(double least);

  std::size_t rank() const { return rank_; }  // how many steps there were
  // The row of step k, and the column of its pivot. In this row, the columns of earlier steps have no meaning. From
  // k = rank() on, column(k) lists the columns without a pivot, in ascending order.
  const std::array<double, most>& row(std::size_t k) const { return rows_[k]; }
  std::size_t column(std::size_t k) const { return columns_[k]; }
  double pivot(std::size_t k) const { return rows_[k][columns_[k]]; }

 private:
  std::size_t height_, width_, rank_ = 0;
  std::array<std::array<double, most>, most> rows_{};
  std::array<std::size_t, most> columns_{};  // those of the pivots, then the others
};

// Nearly the inverse of an n x n matrix, 1 <= n <= 7, row by row; false where it finds none. The pivot of a column is
// the greatest number, for the size of its row: rows may be of very different sizes.
bool rounded_inverse(std::size_t n, std::span<const double> matrix, std::span<double> inverse);

}  // namespace sunder
