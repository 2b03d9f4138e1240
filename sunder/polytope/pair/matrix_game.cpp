#include <sunder/polytope/pair/matrix_game.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::polytope {

// With entries moved to between 1 and 2, the best weights of columns are those of: the greatest sum of u_j >= 0 with
// P u <= 1. The simplex method from u = 0; the prices of slacks at its end are the weights of rows.
bool MatrixGame::solve() {
  double low = at(0, 0), high = low;
  for (std::size_t i = 0; i < rows_; ++i) {
    for (std::size_t j = 0; j < columns_; ++j) {
      low = std::min(low, at(i, j));
      high = std::max(high, at(i, j));
    }
  }
  const double by = high > low ? 1 / (high - low) : 0;
  if (!std::isfinite(high) || !std::isfinite(low) || !std::isfinite(by)) return false;
  const std::size_t width = columns_ + rows_ + 1;
  table_.assign((rows_ + 1) * width, 0);
  const auto cell = [&](std::size_t i, std::size_t j) -> double& { return table_[i * width + j]; };
  std::vector<std::size_t> basic(rows_);
  for (std::size_t i = 0; i < rows_; ++i) {
    for (std::size_t j = 0; j < columns_; ++j) cell(i, j) = 1 + (at(i, j) - low) * by;
    cell(i, columns_ + i) = cell(i, width - 1) = 1;
    basic[i] = columns_ + i;
  }
  for (std::size_t j = 0; j < columns_; ++j) cell(rows_, j) = -1;
  constexpr double small = 0x1p-40;
  for (std::size_t step = 0; step < 8 * most; ++step) {
    std::size_t entering = 0, leaving = rows_;
    for (std::size_t j = 1; j + 1 < width; ++j) {
      if (cell(rows_, j) < cell(rows_, entering)) entering = j;
    }
    if (!(cell(rows_, entering) < -small)) break;
    for (std::size_t i = 0; i < rows_; ++i) {
      if (cell(i, entering) > small && (leaving == rows_ || cell(i, width - 1) * cell(leaving, entering) <
                                                                cell(leaving, width - 1) * cell(i, entering))) {
        leaving = i;
      }
    }
    if (leaving == rows_) return false;
    const double scale = 1 / cell(leaving, entering);
    for (std::size_t j = 0; j < width; ++j) cell(leaving, j) *= scale;
    for (std::size_t i = 0; i <= rows_; ++i) {
      const double factor = cell(i, entering);
      if (i == leaving || !(std::fabs(factor) > 0)) continue;
      for (std::size_t j = 0; j < width; ++j) cell(i, j) -= factor * cell(leaving, j);
    }
    basic[leaving] = entering;
  }
  const double sum = cell(rows_, width - 1);
  if (!(sum > 0)) return false;
  std::vector<double> of_rows(rows_), of_columns(columns_);
  double all_rows = 0, all_columns = 0;
  for (std::size_t i = 0; i < rows_; ++i) {
    all_rows += of_rows[i] = std::max(0.0, cell(rows_, columns_ + i) / sum);
    if (basic[i] < columns_) all_columns += of_columns[basic[i]] = std::max(0.0, cell(i, width - 1) / sum);
  }
  if (!(all_rows > 0 && all_columns > 0 && std::isfinite(all_rows + all_columns))) return false;
  row_weights_ = std::move(of_rows);
  column_weights_ = std::move(of_columns);
  return true;
}

}  // namespace sunder::polytope
