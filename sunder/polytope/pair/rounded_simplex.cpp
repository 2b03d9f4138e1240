#include <sunder/polytope/pair/rounded_simplex.h>

#include <algorithm>
#include <cmath>

namespace sunder::polytope {

// The last column has the right-hand sides, the last row the prices.
std::array<bool, RoundedProgram::most_columns> RoundedProgram::basis() {
  std::array<bool, most_columns> result{};
  std::array<std::size_t, most_rows> basic{};
  basic.fill(columns);
  table[rows].fill(0);
  for (std::size_t i = 0; i < rows; ++i) {
    double greatest = 0;
    for (std::size_t k = 0; k < columns; ++k) greatest = std::max(greatest, std::fabs(table[i][k]));
    if (!std::isfinite(greatest)) return result;
    for (std::size_t k = 0; k < columns && greatest > 0; ++k) table[i][k] /= greatest;
    table[i][columns] = i + ones < rows ? 0 : 1;
    for (std::size_t k = 0; k <= columns; ++k) table[rows][k] += table[i][k];
  }
  constexpr double small = 0x1p-40;
  for (std::size_t step = 0; step < 4 * rows; ++step) {
    const auto prices = table[rows].begin();
    const auto entering =
        static_cast<std::size_t>(std::max_element(prices, prices + static_cast<std::ptrdiff_t>(columns)) - prices);
    if (!(table[rows][entering] > small)) break;
    std::size_t leaving = rows;
    for (std::size_t i = 0; i < rows; ++i) {
      if (table[i][entering] > small && (leaving == rows || table[i][columns] * table[leaving][entering] <
                                                                table[leaving][columns] * table[i][entering])) {
        leaving = i;
      }
    }
    if (leaving == rows) break;
    const double by = 1 / table[leaving][entering];
    for (std::size_t k = 0; k <= columns; ++k) table[leaving][k] *= by;
    for (std::size_t i = 0; i <= rows; ++i) {
      if (i == leaving) continue;
      const double factor = table[i][entering];
      for (std::size_t k = 0; k <= columns; ++k) table[i][k] -= factor * table[leaving][k];
    }
    basic[leaving] = entering;
  }
  for (std::size_t i = 0; i < rows; ++i) {
    if (basic[i] < columns) result[basic[i]] = true;
  }
  return result;
}

}  // namespace sunder::polytope
