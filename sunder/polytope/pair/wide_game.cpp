#include <sunder/base/interruption.h>
#include <sunder/polytope/pair/wide_game.h>

#include <algorithm>
#include <utility>

namespace sunder::polytope {

namespace {

using Numbers = std::vector<Dyadic>;

bool is_zero(const Dyadic& x) { return x.sign() == Sign::zero; }

}  // namespace

// Weights m >= 0 of columns and slacks s >= 0 with sum m_j c_j + s = 0, sum m_j = 1: the revised simplex method, from a
// basis of artificial variables. A variable is column j, or columns + i: the slack of row i.
struct WideGame::Table {
  static constexpr std::size_t artificial = static_cast<std::size_t>(-1);

  explicit Table(const WideGame& of)
      : game(of),
        to(of.to_),
        size(of.rows_ + 1),
        basis(size, artificial),
        inverse(size, Numbers(size)),
        solution(size) {
    for (std::size_t i = 0; i < size; ++i) inverse[i][i] = 1.0;
    solution.back() = 1.0;
    set_multipliers();
  }

  bool is_solved() const {
    for (std::size_t i = 0; i < size; ++i) {
      if (basis[i] == artificial && !is_zero(solution[i])) return false;
    }
    return true;
  }

  void set_multipliers() {
    multipliers.assign(size, {});
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t k = 0; basis[i] == artificial && k < size; ++k) {
        multipliers[k] = to.sum(multipliers[k], inverse[i][k]);
      }
    }
  }

  void add_product(Dyadic& sum, const Dyadic& a, const Dyadic& b) const {
    if (!is_zero(a) && !is_zero(b)) sum = to.sum(sum, to.product(a, b));
  }

  // The product of a row of numbers with the column of a variable.
  Dyadic product(const Numbers& row, std::size_t variable) const {
    if (variable >= game.columns()) return row[variable - game.columns()];
    Dyadic sum = row.back();
    for (std::size_t i = 0; i + 1 < size; ++i) add_product(sum, row[i], game.columns_[variable][i]);
    return sum;
  }

  // The variable enters the basis if its price is positive; false where it is not, or where no row may leave.
  bool enter_if_it_pays(std::size_t variable) {
    if (product(multipliers, variable).sign() != Sign::positive) return false;
    Numbers entering(size);
    for (std::size_t i = 0; i < size; ++i) entering[i] = product(inverse[i], variable);
    std::size_t leaving = size;
    for (std::size_t i = 0; i < size; ++i) {
      if (entering[i].sign() == Sign::positive && (leaving == size || is_less(i, leaving, entering))) leaving = i;
    }
    if (leaving == size) return false;
    const auto divide = [&](Dyadic& x) { x = to.quotient(x, entering[leaving]); };
    std::for_each(inverse[leaving].begin(), inverse[leaving].end(), divide);
    divide(solution[leaving]);
    for (std::size_t i = 0; i < size; ++i) {
      if (i == leaving) continue;
      const Dyadic by = -entering[i];
      for (std::size_t k = 0; k < size; ++k) add_product(inverse[i][k], inverse[leaving][k], by);
      add_product(solution[i], solution[leaving], by);
    }
    basis[leaving] = variable;
    ++pivots;
    set_multipliers();
    may_be_interrupted(1000);
    return true;
  }

  // Lexicographically, (solution, inverse) of row i over entering[i], and of j.
  bool is_less(std::size_t i, std::size_t j, const Numbers& entering) const {
    const auto order = [&](const Dyadic& of_i, const Dyadic& of_j) {
      return to.difference(to.product(of_i, entering[j]), to.product(of_j, entering[i])).sign();
    };
    Sign sign = order(solution[i], solution[j]);
    for (std::size_t k = 0; sign == Sign::zero && k < size; ++k) sign = order(inverse[i][k], inverse[j][k]);
    return sign == Sign::negative;
  }

  const WideGame& game;
  LongFloats to;
  std::size_t size;
  std::vector<std::size_t> basis;
  std::vector<Numbers> inverse;
  Numbers solution, multipliers;
  std::size_t pivots = 0;
};

bool WideGame::solve() {
  Table table(*this);
  std::size_t counted = 0;  // pivots
  while (!table.is_solved()) {
    products_ += table.size * (columns() + 2 * (table.pivots - counted) * table.size);
    counted = table.pivots;
    if (table.pivots > 2 * (rows_ + columns())) return false;
    bool pays = false;
    for (std::size_t i = 0; i < rows_; ++i) pays = table.enter_if_it_pays(columns() + i) || pays;
    std::size_t best = 0;
    Dyadic most;
    for (std::size_t j = 0; j < columns(); ++j) {
      Dyadic price = table.product(table.multipliers, j);
      if (j > 0 && (price - most).sign() != Sign::positive) continue;
      best = j;
      most = std::move(price);
    }
    if (!table.enter_if_it_pays(best) && !pays) break;
  }
  columns_win_ = table.is_solved();
  tight_.clear();
  weights_.assign(columns_win_ ? columns() : rows_, {});
  if (!columns_win_) {
    for (std::size_t i = 0; i < rows_; ++i) weights_[i] = -table.multipliers[i];
    return true;
  }
  std::vector<bool> has_slack(rows_);
  for (std::size_t i = 0; i < table.size; ++i) {
    const std::size_t variable = table.basis[i];
    if (variable < columns()) weights_[variable] = table.solution[i];
    if (variable >= columns() && variable != Table::artificial) has_slack[variable - columns()] = true;
  }
  for (std::size_t i = 0; i < rows_; ++i) {
    if (!has_slack[i]) tight_.push_back(i);
  }
  return true;
}

}  // namespace sunder::polytope
