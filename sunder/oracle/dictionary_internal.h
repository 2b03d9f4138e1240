// A linear program as the textbooks have it, for the oracles (x_by_scan.cpp) and no others: a dictionary in integers,
// and Bland's rule. It shares nothing with the simplex methods of the library (number/exact/basis_internal.h).
// Also called: simplex tableau.
// Source: Chvatal 1983, "Linear Programming", chapters 2 and 3; Bland 1977.
#pragma once

#include <sunder/number/integer_internal.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sunder::oracle {

using Integers = std::vector<Integer>;

// Basic variables x_B >= 0 and the objective z in terms of the other variables x_N >= 0:
//   x_i = (row[i].back() - sum_j row[i][j] x_j) / denominator,  z alike, for each objective.
// Variables have numbers: the caller's.
struct Dictionary {
  std::vector<std::int64_t> basic, others;
  std::vector<Integers> rows;        // of each basic variable
  std::vector<Integers> objectives;  // to be maximized
  Integer denominator = 1;           // positive

  // The first column that pays in the objective: of those with the least variable. Nothing where none does.
  template <class MayEnter>
  std::optional<std::size_t> entering(const Integers& objective, const MayEnter& may_enter) const {
    std::optional<std::size_t> best;
    for (std::size_t j = 0; j < others.size(); ++j) {
      if (objective[j] < 0 && may_enter(others[j]) && (!best || others[j] < others[*best])) best = j;
    }
    return best;
  }

  // The row whose variable is zero first as that of the column grows; of several the one of the least variable. Nothing
  // where none is.
  std::optional<std::size_t> leaving(std::size_t column) const;

  // Basic variable r and variable c of the others change places. Requires that rows[r][c] != 0.
  void pivot(std::size_t r, std::size_t c);

  // ---- Phase one: are there x >= 0 with sum_j row[i][j] x_j = row[i].back() >= 0 for all rows, whose basic variables
  // are artificial?

  // The first objective becomes minus their sum: it is zero at its greatest iff there are.
  void begin_phase_one();
  // y_k for the row of this artificial variable, times the denominator: where no column pays and the objective is less
  // than zero, y . column <= 0 for all columns, and y . right-hand sides > 0.
  Integer multiplier(std::int64_t artificial) const;

  // ---- The same without an objective, of columns that come one by one: others are artificial variables, `first` + k of
  // equation k.

  // One column more, the last one, with the entry k in equation k.
  void add_column(std::int64_t variable, std::span<const Integer> column, std::int64_t first);
  void drop_last_column();
  // Entry k of row i of the inverse of the basis, times the denominator: what the column of `first` + k has there.
  Integer inverse(std::size_t i, std::int64_t artificial) const;

  // The row, or the column, in which the variable stands.
  std::optional<std::size_t> row_of(std::int64_t variable) const;
  std::optional<std::size_t> column_of(std::int64_t variable) const;
};

}  // namespace sunder::oracle
