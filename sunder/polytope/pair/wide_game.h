// Who wins a matrix game whose entries differ by more than a double's exponents do, and by which rows and columns: in
// floating point with long mantissas (number/long_float_internal.h). It proposes, and may be wrong.
#pragma once

#include <sunder/number/long_float_internal.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunder::polytope {

// Entries as in MatrixGame: the player of columns pays them. Either weights of columns make all rows <= 0, or weights
// of rows make all columns > 0 (Ville): phase one of the simplex method tells which. Allocates.
class WideGame {
 public:
  explicit WideGame(std::int64_t bits) : to_{bits} {}

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_.size(); }
  template <class Payoff>
  void add_row(const Payoff& payoff) {
    for (std::size_t j = 0; j < columns(); ++j) columns_[j].push_back(to_.rounded(payoff(j)));
    ++rows_;
  }
  template <class Payoff>
  void add_column(const Payoff& payoff) {
    columns_.push_back({1.0});
    for (std::size_t i = 0; i < rows_; ++i) columns_.back().push_back(to_.rounded(payoff(i)));
  }

  // False where no end comes, which roundings may cause. Cost: some 2 (rows + columns) pivots, of (rows + 1)
  // (rows + columns) products each.
  bool solve();
  std::uint64_t products() const { return products_; }  // so far, about
  bool columns_win() const { return columns_win_; }
  // The weights of the winner: one for each column if the columns win, one for each row if the rows win.
  const std::vector<Dyadic>& weights() const { return weights_; }
  // If the columns win: the rows without slack. With these weights each of them sums to zero.
  const std::vector<std::size_t>& tight() const { return tight_; }

 private:
  LongFloats to_;
  std::size_t rows_ = 0;
  std::vector<std::vector<Dyadic>> columns_;  // of each a 1, for the sum of weights, then its entries
  std::uint64_t products_ = 0;
  bool columns_win_ = false;
  std::vector<Dyadic> weights_;
  std::vector<std::size_t> tight_;
};

}  // namespace sunder::polytope
