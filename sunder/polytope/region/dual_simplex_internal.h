// The dual simplex method in integers, for the maximum of c . x over few dimensions and many rows a . x <= b, which are
// found by scans as they are needed.
//
// Beside the rows there are d sides of a box, one a coordinate: +-x_j <= M, of the sign of c_j, where M is greater than
// all numbers. So there is always a basis, d rows whose normals make c with weights that are not negative: to begin
// with the box. Its vertex is x = p + M q. A row that x breaks enters; the one leaves that keeps the weights
// non-negative; where none does, the row contradicts those of the basis. c is c_j +- e^(j+1), e less than all numbers,
// so all weights are positive, the value falls at each step, and the method ends (Dantzig, Orden, Wolfe 1955).
// Arithmetic is fraction-free: the inverse of the basis times its determinant (Edmonds 1967, Bareiss 1968).
#pragma once

#include <sunder/base/cost.h>
#include <sunder/number/integer_internal.h>
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
  const ExactEvidence::Place& point() const { return point_; }
  const ExactVector& way() const { return way_; }
  bool is_unbounded() const;
  bool is_at_box() const;
  // Of basis rows, those of weight zero, too.
  struct BasisRow {
    std::uint32_t row;
    Dyadic weight;
  };
  std::vector<BasisRow> basis() const;
  Dyadic denominator() const { return dyadic_of(determinant_, 0); }  // of the weights

  // Where there is none: multipliers of at most d + 1 rows.
  const RowWeights& contradiction() const { return contradiction_; }

  std::uint32_t pivots() const { return pivots_; }  // since begin_at()

 private:
  using Column = std::vector<Integer>;
  struct RowIntegers {
    Column normal;
    std::int64_t unit = 0;  // 2^unit is one of them
  };
  void begin_at_box();
  RowIntegers integers_of(std::uint32_t row) const;
  Column in_terms_of_basis(const Column& normal) const;  // times determinant_
  bool is_side(std::size_t i) const { return basis_[i] >= first_box_side; }
  Integer weight(std::size_t i) const;
  bool is_positive(std::size_t i) const;  // of the perturbed weight
  bool leaves_before(std::size_t i, std::size_t j, const Column& t) const;
  void replace(std::size_t r, std::uint32_t row, const RowIntegers& by, const Column& t);
  bool enter(std::uint32_t row);
  void find_vertex();
  ExactFurthest most_broken(const ExactVector& p, const Dyadic& w, Cost& cost) const;
  bool go_on(Cost& cost, std::uint32_t& entering);

  const Polytope& body_;
  std::size_t d_;
  Column objective_;
  std::int64_t objective_unit_ = 0;
  std::array<int, most_dimension> signs_{};  // of the perturbation, and the sides of the box
  std::array<std::uint32_t, most_dimension> basis_{};
  std::array<std::int64_t, most_dimension> units_{};
  Integer determinant_ = 1;
  std::vector<Integer> inverse_;  // of the basis, times determinant_: row j, column i is [j * d + i]
  ExactVector vertex_, way_;      // over determinant_
  ExactEvidence::Place point_;
  RowWeights contradiction_;
  std::uint32_t pivots_ = 0;
};

}  // namespace sunder::polytope
