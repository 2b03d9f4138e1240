// Elimination in integers without fractions: ranks, kernels and inverses of small matrices. For sources, not installed.
// Also called: Gauss-Jordan elimination; reduced row echelon form; fraction-free elimination.
// Source: Bareiss 1968, "Sylvester's identity and multistep integer-preserving Gaussian elimination"; Edmonds 1967.
#pragma once

#include <sunder/number/integer_internal.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace sunder {

// Rows, added one after the other, as rows that span the same: each has the number pivot() in a column of its own,
// where the others have 0. All numbers are minors of the rows added, so none is longer than it has to be.
class Elimination {
 public:
  struct Row {
    std::size_t column;  // of its pivot
    std::vector<Integer> numbers;
  };

  explicit Elimination(std::size_t width) : Elimination(width, width) {}
  // Columns from `pivot_columns` on are carried along, but have no pivots.
  Elimination(std::size_t width, std::size_t pivot_columns) : width_(width), pivot_columns_(pivot_columns) {}

  // Does the row raise the rank? Then it is added. Of exact numbers a positive multiple is.
  bool add(std::vector<Integer> row);
  bool add(std::span<const Dyadic> row);

  std::size_t rank() const { return rows_.size(); }
  const std::vector<Row>& rows() const { return rows_; }
  const Integer& pivot() const { return pivot_; }  // positive; 1 to begin with

  // Some vector that is orthogonal to all rows, and not zero, in lowest terms; nothing where the rank is the width.
  std::optional<std::vector<Integer>> across() const;

 private:
  std::size_t width_, pivot_columns_;
  std::vector<Row> rows_;
  Integer pivot_ = 1;
};

// The inverse of a matrix is `numbers` over `denominator`, which is positive; row by row.
struct ExactInverse {
  std::vector<Dyadic> numbers;
  Dyadic denominator{1.0};
};

// Inverts a d x d matrix of finite doubles, given row by row; returns nothing where it is singular. Allocates.
std::optional<ExactInverse> exact_inverse(std::size_t d, std::span<const double> matrix);

}  // namespace sunder
