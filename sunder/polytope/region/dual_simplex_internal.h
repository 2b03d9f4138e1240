// The dual simplex method in integers, for the maximum of c . x over few dimensions and many rows a . x <= b, which are
// found by scans as they are needed.
//
// Beside the rows there are d sides of a box, one a coordinate: +-x_j <= M, of the sign of c_j, where M is greater than
// all numbers. So there is always a basis, d rows whose normals make c with weights that are not negative: to begin
// with the box. Its vertex is x = p + M q. A row that x breaks enters; the one leaves that keeps the weights
// non-negative; where none does, the row contradicts those of the basis. c is c_j +- e^(j+1), e less than all numbers,
// so all weights are positive, the value falls at each step, and the method ends. It is the simplex method for weights
// of rows (number/exact/basis_internal.h), the sides of the box its artificial variables.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/number/exact/basis_internal.h>
#include <sunder/number/exact/scaled_integers_internal.h>
#include <sunder/polytope/pair/evidence.h>
#include <sunder/polytope/pair/placed.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::polytope {

// In a basis: rows, and from here on sides of the box, by their coordinate.
inline constexpr std::uint32_t first_box_side = 0xffffffc0u;

struct RowBasis {
  std::array<std::uint32_t, most_dimension> rows{};
  std::uint64_t proposal_probes = 0;
  std::uint32_t steps = 0;
};

class DualSimplex {
 public:
  // Keeps a reference to the half-spaces.
  DualSimplex(const Polytope& half_spaces, std::span<const Dyadic> objective);

  // From this basis, if it is one, and its weights are not negative; else from the box.
  void begin_at(const RowBasis& basis);

  // To the end: is there a common point?
  bool solve(Cost& cost);

  // After that, where there is one. The vertex, or where it is not finite, a common point that is as good, or (is
  // unbounded) any; the direction q, times a positive number, which is zero where the vertex is finite; the basis with
  // its weights; whether c . q > 0.
  const ExactPointN& point() const { return point_; }
  const ExactVector& way() const { return way_; }
  bool is_unbounded() const { return !basis_.is_solved(); }
  bool is_at_box() const;
  // Of basis rows, those of weight zero, too.
  struct BasisRow {
    std::uint32_t row;
    Dyadic weight;
  };
  std::vector<BasisRow> basis() const;
  Dyadic denominator() const { return dyadic_of(basis_.denominator(), 0); }  // of the weights

  // Where there is none: multipliers of at most d + 1 rows.
  const Weights& contradiction() const { return contradiction_; }

  std::uint32_t pivots() const { return pivots_; }  // since begin_at()

 private:
  // A row of the half-spaces as a variable, or a side of the box. In the basis coordinates have the signs that make the
  // objective's not negative.
  ScaledIntegers integers_of(std::uint32_t row) const;
  IntegerBasis of_box() const { return IntegerBasis(objective_.integers); }
  std::uint32_t row_of(std::size_t i) const;
  void find_vertex();
  bool enter(std::uint32_t row);
  ExactFurthest most_broken(const ExactVector& p, const Dyadic& w, Cost& cost) const;
  bool go_on(Cost& cost, std::uint32_t& entering);

  const Polytope& body_;
  std::size_t d_;
  std::array<bool, most_dimension> is_flipped_{};  // of coordinates
  ScaledIntegers objective_;
  IntegerBasis basis_;
  ExactVector vertex_, way_;  // over the denominator
  ExactPointN point_;
  Weights contradiction_;
  std::uint32_t pivots_ = 0;
};

}  // namespace sunder::polytope
