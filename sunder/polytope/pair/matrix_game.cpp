#include <sunder/polytope/pair/matrix_game.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder::polytope {

namespace {

constexpr double small = 0x1p-40, noise = 0x1p-44, least_pivot = 0x1p-30;
constexpr int most_pivots = 8 * MatrixGame::most;

}  // namespace

// With entries moved to about 2 to 3, so that the value is positive, the best weights of columns are those of: the
// greatest sum of u_j >= 0 with P u <= 1. The simplex method; the prices of slacks are the weights of rows. A new row
// is a constraint that the last solution may break, which dual steps mend; a new column is one that may pay, and primal
// steps take it in. Of entries out of scale the table is made anew.
bool MatrixGame::set_scale() {
  double low = entry(0, 0), high = low;
  for (std::size_t i = 0; i < rows_; ++i) {
    for (std::size_t j = 0; j < columns_; ++j) {
      low = std::min(low, entry(i, j));
      high = std::max(high, entry(i, j));
    }
  }
  low_ = low;
  by_ = high > low ? 1 / (high - low) : 0;
  return std::isfinite(high) && std::isfinite(low) && std::isfinite(by_);
}

void MatrixGame::rebuild() {
  ++solved_anew_;
  is_solved_ = set_scale();
  if (!is_solved_) return;
  const std::size_t rows = rows_;
  variables_ = 0;
  total_ = 0;
  rows_ = 0;
  for (std::size_t j = 0; j < columns_; ++j) append_column(j);
  for (; rows_ < rows; ++rows_) append_row(rows_);
  primal_steps();
}

// Row i is the first that is not in the table.
void MatrixGame::append_row(std::size_t i) {
  const std::size_t slack = variables_++;
  slack_of_row_[i] = slack;
  column_of_variable_[slack] = most;
  prices_[slack] = 0;
  for (std::size_t k = 0; k < i; ++k) cell(k, slack) = 0;
  std::fill_n(&cell(i, 0), slack, 0.0);
  cell(i, slack) = right_[i] = 1;
  for (std::size_t j = 0; j < columns_; ++j) cell(i, variable_of_column_[j]) = scaled(entry(i, j));
  for (std::size_t k = 0; k < i; ++k) {
    const std::size_t column = column_of_variable_[basic_[k]];
    if (column == most) continue;
    const double factor = scaled(entry(i, column));
    for (std::size_t v = 0; v < variables_; ++v) cell(i, v) -= factor * cell(k, v);
    right_[i] -= factor * right_[k];
  }
  basic_[i] = slack;
}

void MatrixGame::append_column(std::size_t j) {
  const std::size_t v = variables_++;
  variable_of_column_[j] = v;
  column_of_variable_[v] = j;
  prices_[v] = -1;
  for (std::size_t k = 0; k < rows_; ++k) cell(k, v) = 0;
  for (std::size_t i = 0; i < rows_; ++i) {
    const double payoff = scaled(entry(i, j));
    for (std::size_t k = 0; k < rows_; ++k) cell(k, v) += payoff * cell(k, slack_of_row_[i]);
    prices_[v] += payoff * prices_[slack_of_row_[i]];
  }
}

void MatrixGame::grow_by_row() {
  bool is_usable = is_solved_;
  for (std::size_t j = 0; j < columns_ && is_usable; ++j) is_usable = is_in_scale(entry(rows_ - 1, j));
  if (!is_usable) return rebuild();
  append_row(rows_ - 1);
  dual_steps();
  if (is_solved_) primal_steps();
  if (!is_solved_) rebuild();
}

void MatrixGame::grow_by_column() {
  if (rows_ == 0) return;
  bool is_usable = is_solved_;
  for (std::size_t i = 0; i < rows_ && is_usable; ++i) is_usable = is_in_scale(entry(i, columns_ - 1));
  if (!is_usable) return rebuild();
  append_column(columns_ - 1);
  primal_steps();
  if (!is_solved_) rebuild();
}

void MatrixGame::pivot(std::size_t leaving, std::size_t entering) {
  const double scale = 1 / cell(leaving, entering);
  double* row = &cell(leaving, 0);
  for (std::size_t v = 0; v < variables_; ++v) row[v] *= scale;
  right_[leaving] *= scale;
  const auto subtract = [&](double factor, double* of, double& right) {
    for (std::size_t v = 0; v < variables_; ++v) of[v] -= factor * row[v];
    right -= factor * right_[leaving];
  };
  for (std::size_t i = 0; i < rows_; ++i) {
    const double factor = cell(i, entering);
    if (i != leaving && std::fabs(factor) > 0) subtract(factor, &cell(i, 0), right_[i]);
  }
  subtract(prices_[entering], prices_.data(), total_);
  basic_[leaving] = entering;
}

void MatrixGame::dual_steps() {
  for (int step = 0; step < most_pivots; ++step) {
    std::size_t leaving = 0, entering = variables_;
    for (std::size_t i = 1; i < rows_; ++i) {
      if (right_[i] < right_[leaving]) leaving = i;
    }
    if (!(right_[leaving] < -small)) return;
    const double* row = &cell(leaving, 0);
    for (std::size_t v = 0; v < variables_; ++v) {
      if (row[v] < -least_pivot &&
          (entering == variables_ || prices_[v] * row[entering] > prices_[entering] * row[v])) {
        entering = v;
      }
    }
    if (entering == variables_) break;
    pivot(leaving, entering);
  }
  is_solved_ = false;
}

void MatrixGame::primal_steps() {
  for (int step = 0; step < most_pivots; ++step) {
    std::size_t entering = 0, leaving = rows_;
    for (std::size_t v = 1; v < variables_; ++v) {
      if (prices_[v] < prices_[entering]) entering = v;
    }
    if (!(prices_[entering] < -small)) return;
    for (std::size_t i = 0; i < rows_; ++i) {
      if (cell(i, entering) > least_pivot &&
          (leaving == rows_ || right_[i] * cell(leaving, entering) < right_[leaving] * cell(i, entering))) {
        leaving = i;
      }
    }
    if (leaving == rows_) break;
    pivot(leaving, entering);
  }
  is_solved_ = false;
}

bool MatrixGame::solve_anew() {
  rebuild();
  return set_weights();
}

bool MatrixGame::solve() {
  if (set_weights() && gap() <= small / by_) return true;
  rebuild();
  return set_weights();
}

// By how much one player might do better against the weights of the other: 0 but for roundings.
double MatrixGame::gap() const {
  double most_of_rows = -std::numeric_limits<double>::infinity(), least_of_columns = -most_of_rows;
  std::array<double, most> of_column{};
  for (std::size_t i = 0; i < rows_; ++i) {
    double of_row = 0;
    for (std::size_t j = 0; j < columns_; ++j) {
      of_row += column_weights_[j] * entries_[i * most + j];
      of_column[j] += row_weights_[i] * entries_[i * most + j];
    }
    most_of_rows = std::max(most_of_rows, of_row);
  }
  for (std::size_t j = 0; j < columns_; ++j) least_of_columns = std::min(least_of_columns, of_column[j]);
  return most_of_rows - least_of_columns;
}

bool MatrixGame::set_weights() {
  if (!is_solved_ || !(total_ > 0)) return false;
  std::array<double, most> of_rows, of_columns;
  std::fill_n(of_columns.begin(), columns_, 0.0);
  const auto weight = [&](double part) { return part > total_ * noise ? part / total_ : 0; };
  double all_rows = 0, all_columns = 0;
  for (std::size_t i = 0; i < rows_; ++i) {
    all_rows += of_rows[i] = weight(prices_[slack_of_row_[i]]);
    const std::size_t column = column_of_variable_[basic_[i]];
    if (column < most) all_columns += of_columns[column] = weight(right_[i]);
  }
  if (!(all_rows > 0 && all_columns > 0 && std::isfinite(all_rows + all_columns))) return false;
  std::copy_n(of_rows.begin(), rows_, row_weights_.begin());
  std::copy_n(of_columns.begin(), columns_, column_weights_.begin());
  weighted_rows_ = rows_;
  weighted_columns_ = columns_;
  return true;
}

}  // namespace sunder::polytope
