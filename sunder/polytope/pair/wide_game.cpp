#include <sunder/base/interruption.h>
#include <sunder/number/exact/basis_internal.h>
#include <sunder/polytope/pair/wide_game.h>

#include <algorithm>
#include <utility>

namespace sunder::polytope {

// Weights m >= 0 of columns and slacks s >= 0 with sum m_j c_j + s = 0, sum m_j = 1: phase one of the simplex method.
// The first row is that of the sum.
bool WideGame::solve() {
  constexpr std::uint32_t of_column = 0, slack = 1;
  std::vector<Dyadic> right(rows_ + 1);
  right.front() = 1.0;
  LongFloatBasis basis(right, {to_});
  std::uint32_t counted = 0;  // pivots
  while (!basis.is_solved()) {
    products_ += (rows_ + 1) * (columns() + 2 * (basis.pivots() - counted) * (rows_ + 1));
    counted = basis.pivots();
    if (counted > 2 * (rows_ + columns())) return false;
    may_be_interrupted(1000);
    bool pays = false;
    for (std::uint32_t i = 0; i < rows_; ++i) {
      if (basis.multipliers()[i + 1].sign() != Sign::positive) continue;
      std::vector<Dyadic> unit(rows_ + 1);
      unit[i + 1] = 1.0;
      pays = basis.enter_if_it_pays({slack, i}, unit) || pays;
    }
    std::uint32_t best = 0;
    Dyadic most;
    for (std::uint32_t j = 0; j < columns(); ++j) {
      Dyadic price = basis.price(columns_[j]);
      if (j > 0 && (price - most).sign() != Sign::positive) continue;
      best = j;
      most = std::move(price);
    }
    if (!basis.enter_if_it_pays({of_column, best}, columns_[best]) && !pays) break;
  }
  columns_win_ = basis.is_solved();
  tight_.clear();
  weights_.assign(columns_win_ ? columns() : rows_, {});
  if (!columns_win_) {
    for (std::size_t i = 0; i < rows_; ++i) weights_[i] = -basis.multipliers()[i + 1];
    return true;
  }
  std::vector<bool> has_slack(rows_);
  for (std::size_t i = 0; i < basis.rows(); ++i) {
    const auto [kind, index, unit] = basis.variable(i);
    if (kind == of_column) weights_[index] = basis.value(i);
    if (kind == slack) has_slack[index] = true;
  }
  for (std::size_t i = 0; i < rows_; ++i) {
    if (!has_slack[i]) tight_.push_back(i);
  }
  return true;
}

}  // namespace sunder::polytope
