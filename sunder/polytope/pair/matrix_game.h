// Matrix games of few rows and columns, in floating point.
// Also called: two-person zero-sum games; mixed strategies.
#pragma once

#include <cstddef>
#include <vector>

namespace sunder::polytope {

// The player of columns pays entry (i, j) to the player of rows. Weights of rows, and of columns, sum to 1: about the
// best of both.
class MatrixGame {
 public:
  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  // Adds a last row, a last column: new entries are given by their other number.
  template <class Payoff>
  void add_row(const Payoff& payoff) {
    for (std::size_t j = 0; j < columns_; ++j) at(rows_, j) = payoff(j);
    ++rows_;
  }
  template <class Payoff>
  void add_column(const Payoff& payoff) {
    for (std::size_t i = 0; i < rows_; ++i) at(i, columns_) = payoff(i);
    ++columns_;
  }

  // False where floating point finds no way; then weights stay what they were. Requires a row and a column.
  bool solve();
  // Finite, not negative, and some of them positive. Of what came after the last solution, and before the first: 0.
  double row_weight(std::size_t i) const { return i < row_weights_.size() ? row_weights_[i] : 0; }
  double column_weight(std::size_t j) const { return j < column_weights_.size() ? column_weights_[j] : 0; }

  static constexpr std::size_t most = 40;  // of rows, and of columns

 private:
  double& at(std::size_t i, std::size_t j) { return entries_[i * most + j]; }

  std::size_t rows_ = 0, columns_ = 0;
  std::vector<double> entries_ = std::vector<double>(most * most), table_{}, row_weights_{}, column_weights_{};
};

}  // namespace sunder::polytope
