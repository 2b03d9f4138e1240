// Matrix games of few rows and columns, in floating point.
// Also called: two-person zero-sum games; mixed strategies.
#pragma once

#include <sunder/base/contract.h>

#include <array>
#include <cstddef>

namespace sunder::polytope {

// The player of columns pays entry (i, j) to the player of rows. Weights of rows, and of columns, sum to 1: about the
// best of both. A game that has grown goes on from its last solution: a row or a column more costs some few pivots, of
// (rows + 1) (rows + columns) multiplications each. Some 40 KiB, without memory of its own.
class MatrixGame {
 public:
  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  // Adds a last row, a last column: new entries are given by their other number. Requires fewer than `most`, and a
  // column before the first row.
  template <class Payoff>
  void add_row(const Payoff& payoff) {
    SUNDER_REQUIRE(rows_ < most && columns_ > 0);
    for (std::size_t j = 0; j < columns_; ++j) entry(rows_, j) = payoff(j);
    ++rows_;
    grow_by_row();
  }
  template <class Payoff>
  void add_column(const Payoff& payoff) {
    SUNDER_REQUIRE(columns_ < most);
    for (std::size_t i = 0; i < rows_; ++i) entry(i, columns_) = payoff(i);
    ++columns_;
    grow_by_column();
  }

  // Sets the weights. False where floating point finds none; then they stay what they were, or are not the best.
  // Requires a row and a column.
  bool solve();
  // The same from the beginning, without what many pivots have rounded away.
  bool solve_anew();
  // Finite, not negative, and some of them positive. Of what came after the last solution, and before the first: 0.
  double row_weight(std::size_t i) const { return i < weighted_rows_ ? row_weights_[i] : 0; }
  double column_weight(std::size_t j) const { return j < weighted_columns_ ? column_weights_[j] : 0; }

  // How often the game was solved from the beginning so far.
  std::size_t solved_anew() const { return solved_anew_; }

  static constexpr std::size_t most = 40;  // of rows, and of columns

 private:
  static constexpr std::size_t width = 2 * most;

  double& entry(std::size_t i, std::size_t j) { return entries_[i * most + j]; }
  double& cell(std::size_t i, std::size_t v) { return table_[i * width + v]; }
  double scaled(double payoff) const { return 2 + (payoff - low_) * by_; }
  // Of a game whose entries are all alike nothing else is.
  bool is_in_scale(double payoff) const { return by_ > 0 && scaled(payoff) >= 1 && scaled(payoff) <= 16; }

  void grow_by_row();
  void grow_by_column();
  void rebuild();
  bool set_scale();
  void append_row(std::size_t i);
  void append_column(std::size_t j);
  void pivot(std::size_t leaving, std::size_t entering);
  void dual_steps();
  void primal_steps();
  double gap() const;
  bool set_weights();

  std::size_t rows_ = 0, columns_ = 0, variables_ = 0, weighted_rows_ = 0, weighted_columns_ = 0, solved_anew_ = 0;
  bool is_solved_ = false;
  double low_ = 0, by_ = 0;  // of the scale of entries
  // Row i of the table is constraint i, with its right side; the last one, apart, prices. A variable is one of a
  // column, or the slack of a row.
  std::array<double, most * most> entries_;
  std::array<double, most * width> table_;
  std::array<double, width> prices_;
  std::array<double, most> right_, row_weights_, column_weights_;
  double total_ = 0;
  std::array<std::size_t, most> slack_of_row_, variable_of_column_, basic_;
  std::array<std::size_t, width> column_of_variable_;  // `most`: a slack
};

}  // namespace sunder::polytope
