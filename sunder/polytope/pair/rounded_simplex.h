// Phase one of the simplex method in floating point, for few columns: it proposes a basis, and may be wrong.
#pragma once

#include <sunder/polytope/object/polytope.h>

#include <array>
#include <cstddef>

namespace sunder::polytope {

// Weights l >= 0 of columns with sum l_k c_k = e: e's last `ones` numbers are 1, the others 0.
struct RoundedProgram {
  static constexpr std::size_t most_rows = most_dimension + 2, most_columns = 2 * (most_dimension + 1);

  std::size_t rows = 0, columns = 0, ones = 1;
  std::array<std::array<double, most_columns + 1>, most_rows + 1> table{};  // entry [i][k] is that of column k

  // Which columns are in the basis where the method ends. Uses up the table. Equations are scaled by their greatest
  // entries.
  std::array<bool, most_columns> basis();
};

}  // namespace sunder::polytope
