// A matrix game, solved in floating point: what both players should mix, and what it is worth.
// Also called: zero-sum game; minimax theorem; Farkas' lemma in its symmetric form.
//
// The rows are half-spaces, the columns points; an entry tells how far the point is outside. Then von Neumann's theorem
// is: either a mixture of the points is in all half-spaces (the value is not positive), or the half-spaces have a
// mixture that none of the points is in (it is positive). So a few points and a few half-spaces are told apart, with
// evidence either way, by a simplex method on a tableau of a few cache lines. Nothing here decides anything.
// Source: Dantzig 1951; the condensed tableau of Tucker.
#pragma once

#include <sunder/number/double_double.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

namespace sunder::solid {

// At most Most rows and as many columns. Entries are of size 1 at most, as are their roundings beside `noise`.
template <class Real, std::size_t Most>
class MatrixGame {
 public:
  static constexpr double noise = std::is_same_v<Real, double> ? 0x1p-44 : 0x1p-94;

  std::size_t rows = 0, columns = 0;
  std::array<std::array<Real, Most>, Most> pay;      // to the rows, by the columns
  std::array<Real, Most> row_weight, column_weight;  // not negative, of sum 1: what to mix
  Real value;                                        // what the rows gain at least, and the columns lose at most

  // False where floating point finds no end.
  bool solve() {
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) tableau_[i][j] = pay[i][j] + Real(shift);
      tableau_[i][columns] = 1;
      of_row_[i] = columns + i;
    }
    for (std::size_t j = 0; j < columns; ++j) {
      tableau_[rows][j] = -1;
      of_column_[j] = j;
    }
    tableau_[rows][columns] = 0;
    for (std::size_t step = 0; step < most_steps; ++step) {
      const std::size_t j = entering();
      if (j == columns) return read();
      const std::size_t i = leaving(j);
      if (i == rows) return false;
      pivot(i, j);
    }
    return false;
  }

 private:
  static constexpr double shift = 2;  // makes all entries positive
  static constexpr std::size_t most_steps = 8 * Most;

  std::size_t entering() const {
    std::size_t best = columns;
    Real least = -noise;
    for (std::size_t j = 0; j < columns; ++j) {
      if (tableau_[rows][j] < least) least = tableau_[rows][j], best = j;
    }
    return best;
  }

  std::size_t leaving(std::size_t j) const {
    std::size_t best = rows;
    Real least = 0;
    for (std::size_t i = 0; i < rows; ++i) {
      if (!(tableau_[i][j] > Real(noise))) continue;
      const Real ratio = tableau_[i][columns] / tableau_[i][j];
      if (best == rows || ratio < least) least = ratio, best = i;
    }
    return best;
  }

  void pivot(std::size_t r, std::size_t c) {
    const Real scale = Real(1) / tableau_[r][c];
    for (std::size_t j = 0; j <= columns; ++j) {
      if (j != c) tableau_[r][j] *= scale;
    }
    for (std::size_t i = 0; i <= rows; ++i) {
      if (i == r) continue;
      const Real factor = tableau_[i][c];
      for (std::size_t j = 0; j <= columns; ++j) {
        if (j != c) tableau_[i][j] -= factor * tableau_[r][j];
      }
      tableau_[i][c] = -factor * scale;
    }
    tableau_[r][c] = scale;
    std::swap(of_row_[r], of_column_[c]);
  }

  bool read() {
    row_weight.fill(0);
    column_weight.fill(0);
    const Real total = tableau_[rows][columns];
    if (!(total > Real(0))) return false;
    const Real scale = Real(1) / total;
    const auto weight = [&](const Real& x) { return x > Real(0) ? x * scale : Real(0); };
    for (std::size_t i = 0; i < rows; ++i) {
      if (of_row_[i] < columns) column_weight[of_row_[i]] = weight(tableau_[i][columns]);
    }
    for (std::size_t j = 0; j < columns; ++j) {
      if (of_column_[j] >= columns) row_weight[of_column_[j] - columns] = weight(tableau_[rows][j]);
    }
    value = scale - Real(shift);
    return true;
  }

  std::array<std::array<Real, Most + 1>, Most + 1> tableau_;
  std::array<std::size_t, Most> of_row_, of_column_;  // variables: those of columns, then those of rows
};

}  // namespace sunder::solid
