// The oracle: one linear program with everything in it, as a full tableau. Its variables are the weights of points, the
// places of half-spaces (as differences of two that are not negative) and their slacks; its rows say that both bodies
// have one point. It shares nothing with the search and the exact method of the front door.
#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/number/integer_internal.h>
#include <sunder/polytope/pair/placed.h>
#include <sunder/polytope/pair/polytope_polytope.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace sunder::polytope {

namespace {

// min sum of artificial variables, subject to rows (equations in variables that are not negative). In integers: each
// row has its own unit, so has each column; none of that changes signs.
class Tableau {
 public:
  Tableau(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), exact_(rows, ExactVector(columns + 1)) {}

  Dyadic& at(std::size_t row, std::size_t column) { return exact_[row][column]; }
  Dyadic& right_hand_side(std::size_t row) { return exact_[row][columns_]; }

  // Can the rows be kept? Bland's rule: of the columns that pay the first, of the rows that may leave the one with the
  // first variable. Counts pivots.
  bool solve(std::uint32_t& pivots) {
    begin();
    for (;;) {
      may_be_interrupted(1000);
      std::size_t entering = 0;
      while (entering < columns_ && table_[rows_][entering] <= 0) ++entering;
      if (entering == columns_) return table_[rows_][width_ - 1].is_zero();
      std::size_t leaving = rows_;
      for (std::size_t i = 0; i < rows_; ++i) {
        if (table_[i][entering] <= 0) continue;
        if (leaving == rows_) {
          leaving = i;
          continue;
        }
        const int order = (table_[i][width_ - 1] * table_[leaving][entering])
                              .compare(table_[leaving][width_ - 1] * table_[i][entering]);
        if (order < 0 || (order == 0 && basis_[i] < basis_[leaving])) leaving = i;
      }
      pivot(leaving, entering);
      ++pivots;
    }
  }

  // After solve() said so, of variable k; over denominator().
  Dyadic value(std::size_t k) const {
    for (std::size_t i = 0; i < rows_; ++i) {
      if (basis_[i] == k) return dyadic_of(table_[i][width_ - 1], -column_unit_[k]);
    }
    return {};
  }
  Dyadic denominator() const { return dyadic_of(determinant_, 0); }

  // After solve() denied it: y, one for each row, with y . column <= 0 for all columns, and y . right-hand side > 0.
  // The price of the artificial variable of row i is y_i - 1, times the determinant.
  Dyadic multiplier(std::size_t row) const {
    const Integer y = table_[rows_][columns_ + row] + determinant_;
    return dyadic_of(signs_[row] < 0 ? -y : y, -row_unit_[row]);
  }

 private:
  void begin() {
    width_ = columns_ + rows_ + 1;
    row_unit_.assign(rows_, 0);
    column_unit_.assign(columns_, 0);
    signs_.assign(rows_, 1);
    constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
    for (std::size_t k = 0; k < columns_; ++k) {
      std::int64_t unit = none;
      for (std::size_t i = 0; i < rows_; ++i) {
        if (exact_[i][k].sign() != Sign::zero) unit = std::min(unit, exact_[i][k].exponent());
      }
      column_unit_[k] = unit == none ? 0 : unit;
    }
    table_.assign(rows_ + 1, std::vector<Integer>(width_));
    basis_.resize(rows_);
    for (std::size_t i = 0; i < rows_; ++i) {
      std::int64_t unit = none;
      for (std::size_t k = 0; k <= columns_; ++k) {
        if (exact_[i][k].sign() == Sign::zero) continue;
        unit = std::min(unit, exact_[i][k].exponent() - (k < columns_ ? column_unit_[k] : 0));
      }
      row_unit_[i] = unit == none ? 0 : unit;
      if (exact_[i][columns_].sign() == Sign::negative) signs_[i] = -1;
      for (std::size_t k = 0; k <= columns_; ++k) {
        const Dyadic& x = exact_[i][k];
        if (x.sign() == Sign::zero) continue;
        const std::int64_t shift = x.exponent() - (k < columns_ ? column_unit_[k] : 0) - row_unit_[i];
        table_[i][k < columns_ ? k : width_ - 1] = (mantissa_of(x) << static_cast<unsigned>(shift)) * signs_[i];
      }
      table_[i][columns_ + i] = 1;
      basis_[i] = columns_ + i;
      for (std::size_t k = 0; k < width_; ++k) table_[rows_][k] += table_[i][k];
    }
    for (std::size_t i = 0; i < rows_; ++i) table_[rows_][columns_ + i] = 0;
  }

  void pivot(std::size_t r, std::size_t c) {
    const Integer by = table_[r][c];
    for (std::size_t i = 0; i <= rows_; ++i) {
      if (i == r) continue;
      const Integer factor = table_[i][c];
      for (std::size_t k = 0; k < width_; ++k) {
        Integer& x = table_[i][k];
        if (factor.is_zero() || table_[r][k].is_zero()) {
          if (!x.is_zero()) x = x * by / determinant_;
        } else {
          x = (x * by - factor * table_[r][k]) / determinant_;  // exact
        }
      }
    }
    determinant_ = by;
    basis_[r] = c;
  }

  std::size_t rows_, columns_, width_ = 0;
  std::vector<ExactVector> exact_;
  std::vector<std::int64_t> row_unit_, column_unit_;
  std::vector<int> signs_;
  std::vector<std::vector<Integer>> table_;  // the last row: the prices; the last column: the right-hand sides
  std::vector<std::size_t> basis_;
  Integer determinant_ = 1;
};

// Where the variables and rows of a body are in the tableau.
struct Part {
  const Polytope& body;
  const Pose& pose;
  double sign;  // of its point in the rows of the common point
  std::size_t first_variable = 0, first_row = 0;

  std::size_t variables() const { return body.is_of_points() ? body.size() : 2 * body.dimension() + body.size(); }
  std::size_t rows() const { return body.is_of_points() ? 1 : body.size(); }

  // In the first d rows: sign (linear v + translation) on the left.
  void add_to(Tableau& tableau) const {
    const std::size_t d = body.dimension();
    for (std::size_t r = 0; r < d; ++r) {
      tableau.right_hand_side(r) = tableau.right_hand_side(r) - Dyadic(sign) * Dyadic(pose.translation()[r]);
    }
    for (std::uint32_t k = 0; k < body.size(); ++k) {
      const std::span<const double> row = body.row(k);
      if (body.is_of_points()) {
        for (std::size_t r = 0; r < d; ++r) {
          Dyadic image;
          for (std::size_t c = 0; c < d; ++c) image = image + Dyadic(pose.linear(r, c)) * Dyadic(row[c]);
          tableau.at(r, first_variable + k) = Dyadic(sign) * image;
        }
        tableau.at(first_row, first_variable + k) = 1.0;
      } else {
        for (std::size_t c = 0; c < d; ++c) {
          tableau.at(first_row + k, first_variable + 2 * c) = row[c];
          tableau.at(first_row + k, first_variable + 2 * c + 1) = -row[c];
        }
        tableau.at(first_row + k, first_variable + 2 * d + k) = 1.0;
        tableau.right_hand_side(first_row + k) = row[d];
      }
    }
    if (body.is_of_points()) {
      tableau.right_hand_side(first_row) = 1.0;
      return;
    }
    for (std::size_t r = 0; r < d; ++r) {
      for (std::size_t c = 0; c < d; ++c) {
        tableau.at(r, first_variable + 2 * c) = sign * pose.linear(r, c);
        tableau.at(r, first_variable + 2 * c + 1) = -sign * pose.linear(r, c);
      }
    }
  }

  // Where they meet: weights, or the place; its image over the denominator.
  ExactVector place(const Tableau& tableau, Weights& weights, ExactPointN& in_body) const {
    const std::size_t d = body.dimension();
    ExactVector v(d);
    if (body.is_of_points()) {
      weights.denominator = tableau.denominator();
      for (std::uint32_t k = 0; k < body.size(); ++k) {
        Dyadic weight = tableau.value(first_variable + k);
        if (weight.sign() == Sign::zero) continue;
        for (std::size_t c = 0; c < d; ++c) v[c] = v[c] + weight * Dyadic(body.row(k)[c]);
        weights.parts.push_back({k, std::move(weight)});
      }
    } else {
      for (std::size_t c = 0; c < d; ++c) {
        v[c] = tableau.value(first_variable + 2 * c) - tableau.value(first_variable + 2 * c + 1);
      }
      in_body = {v, tableau.denominator()};
    }
    ExactVector image = turned(pose, v);
    for (std::size_t r = 0; r < d; ++r) {
      image[r] = image[r] + tableau.denominator() * Dyadic(pose.translation()[r]);
    }
    return image;
  }

  // Where they are apart: of half-spaces, whose slacks have y <= 0.
  void multipliers(const Tableau& tableau, Weights& weights) const {
    if (body.is_of_points()) return;
    for (std::uint32_t k = 0; k < body.size(); ++k) {
      const Dyadic y = tableau.multiplier(first_row + k);
      if (y.sign() != Sign::zero) weights.parts.push_back({k, -y});
    }
  }
};

}  // namespace

PolytopeAnswer polytope_polytope_by_scan(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b) {
  SUNDER_REQUIRE(a.dimension() == b.dimension());
  const std::size_t d = a.dimension();
  Part of_a{a, pose_a, 1, 0, d}, of_b{b, pose_b, -1};
  of_b.first_variable = of_a.variables();
  of_b.first_row = d + of_a.rows();
  Tableau tableau(of_b.first_row + of_b.rows(), of_b.first_variable + of_b.variables());
  of_a.add_to(tableau);
  of_b.add_to(tableau);
  PolytopeAnswer answer;
  answer.decided_by = DecidedBy::scan;
  answer.cost.exact = 1;
  const bool meet = tableau.solve(answer.cost.iterations);
  answer.cost.probes = (std::uint64_t{a.size()} + b.size()) * (std::uint64_t{answer.cost.iterations} + 1);
  ExactEvidence evidence;
  if (meet) {
    answer.evidence.verdict = Verdict::meet;
    evidence.numbers = of_a.place(tableau, evidence.of_a, evidence.in_a);
    evidence.denominator = tableau.denominator();
    of_b.place(tableau, evidence.of_b, evidence.in_b);
  } else {  // y . (image of A) + s <= 0, -y . (image of B) + t <= 0, and y . right-hand side > 0
    answer.evidence.verdict = Verdict::apart;
    for (std::size_t r = 0; r < d; ++r) evidence.numbers.push_back(tableau.multiplier(r));
    of_a.multipliers(tableau, evidence.of_a);
    of_b.multipliers(tableau, evidence.of_b);
  }
  answer.evidence.exact = std::make_shared<const ExactEvidence>(std::move(evidence));
  return answer;
}

}  // namespace sunder::polytope
