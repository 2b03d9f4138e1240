// The oracle: one linear program with everything in it, as a full program. Its variables are the weights of points, the
// places of half-spaces (as differences of two that are not negative) and their slacks; its rows say that both bodies
// have one point. It shares nothing with the search and the exact method of the front door.
#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/oracle/dictionary_internal.h>
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
class Program {
 public:
  Program(std::size_t rows, std::size_t columns) : columns_(columns), exact_(rows, ExactVector(columns + 1)) {}

  Dyadic& at(std::size_t row, std::size_t column) { return exact_[row][column]; }
  Dyadic& right_hand_side(std::size_t row) { return exact_[row].back(); }

  // Can the rows be kept? Counts pivots.
  bool solve(std::uint32_t& pivots) {
    fill();
    const auto is_own = [&](std::int64_t variable) { return variable < artificial(0); };
    while (const auto entering = dictionary_.entering(dictionary_.objectives[0], is_own)) {
      may_be_interrupted(1000);
      dictionary_.pivot(*dictionary_.leaving(*entering), *entering);
      ++pivots;
    }
    return dictionary_.objectives[0].back().is_zero();
  }

  // After solve() said so, of variable k; over denominator().
  Dyadic value(std::size_t k) const {
    const auto row = dictionary_.row_of(static_cast<std::int64_t>(k));
    return row ? dyadic_of(dictionary_.rows[*row].back(), -column_unit_[k]) : Dyadic();
  }
  Dyadic denominator() const { return dyadic_of(dictionary_.denominator, 0); }

  // After solve() denied it: y, one for each row, with y . column <= 0 for all columns, and y . right-hand side > 0.
  Dyadic multiplier(std::size_t row) const {
    const Integer y = dictionary_.multiplier(artificial(row));
    return dyadic_of(is_negative_[row] ? -y : y, -row_unit_[row]);
  }

 private:
  std::int64_t artificial(std::size_t row) const { return static_cast<std::int64_t>(columns_ + row); }

  void fill() {
    constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
    column_unit_.assign(columns_ + 1, 0);
    for (std::size_t k = 0; k < columns_; ++k) {
      std::int64_t unit = none;
      for (const ExactVector& row : exact_) {
        if (row[k].sign() != Sign::zero) unit = std::min(unit, row[k].exponent());
      }
      if (unit != none) column_unit_[k] = unit;
      dictionary_.others.push_back(static_cast<std::int64_t>(k));
    }
    for (const ExactVector& row : exact_) {
      std::int64_t unit = none;
      for (std::size_t k = 0; k <= columns_; ++k) {
        if (row[k].sign() != Sign::zero) unit = std::min(unit, row[k].exponent() - column_unit_[k]);
      }
      row_unit_.push_back(unit == none ? 0 : unit);
      is_negative_.push_back(row.back().sign() == Sign::negative);
      oracle::Integers integers(columns_ + 1);
      for (std::size_t k = 0; k <= columns_; ++k) {
        if (row[k].sign() == Sign::zero) continue;
        integers[k] = mantissa_of(row[k]) << static_cast<unsigned>(row[k].exponent() - column_unit_[k] - unit);
        if (is_negative_.back()) integers[k] = -integers[k];
      }
      dictionary_.basic.push_back(artificial(dictionary_.rows.size()));
      dictionary_.rows.push_back(std::move(integers));
    }
    dictionary_.begin_phase_one();
  }

  std::size_t columns_;
  std::vector<ExactVector> exact_;
  std::vector<std::int64_t> row_unit_, column_unit_;
  std::vector<bool> is_negative_;  // of rows: the right-hand side, so that all was negated
  oracle::Dictionary dictionary_;
};

// Where the variables and rows of a body are in the program.
struct Part {
  const Polytope& body;
  const Pose& pose;
  double sign;  // of its point in the rows of the common point
  std::size_t first_variable = 0, first_row = 0;

  std::size_t variables() const { return body.is_of_points() ? body.size() : 2 * body.dimension() + body.size(); }
  std::size_t rows() const { return body.is_of_points() ? 1 : body.size(); }

  // In the first d rows: sign (linear v + translation) on the left.
  void add_to(Program& program) const {
    const std::size_t d = body.dimension();
    for (std::size_t r = 0; r < d; ++r) {
      program.right_hand_side(r) = program.right_hand_side(r) - Dyadic(sign) * Dyadic(pose.translation()[r]);
    }
    for (std::uint32_t k = 0; k < body.size(); ++k) {
      const std::span<const double> row = body.row(k);
      if (body.is_of_points()) {
        for (std::size_t r = 0; r < d; ++r) {
          Dyadic image;
          for (std::size_t c = 0; c < d; ++c) image = image + Dyadic(pose.linear(r, c)) * Dyadic(row[c]);
          program.at(r, first_variable + k) = Dyadic(sign) * image;
        }
        program.at(first_row, first_variable + k) = 1.0;
      } else {
        for (std::size_t c = 0; c < d; ++c) {
          program.at(first_row + k, first_variable + 2 * c) = row[c];
          program.at(first_row + k, first_variable + 2 * c + 1) = -row[c];
        }
        program.at(first_row + k, first_variable + 2 * d + k) = 1.0;
        program.right_hand_side(first_row + k) = row[d];
      }
    }
    if (body.is_of_points()) {
      program.right_hand_side(first_row) = 1.0;
      return;
    }
    for (std::size_t r = 0; r < d; ++r) {
      for (std::size_t c = 0; c < d; ++c) {
        program.at(r, first_variable + 2 * c) = sign * pose.linear(r, c);
        program.at(r, first_variable + 2 * c + 1) = -sign * pose.linear(r, c);
      }
    }
  }

  // Where they meet: weights, or the place; its image over the denominator.
  ExactVector place(const Program& program, Weights& weights, ExactPointN& in_body) const {
    const std::size_t d = body.dimension();
    ExactVector v(d);
    if (body.is_of_points()) {
      weights.denominator = program.denominator();
      for (std::uint32_t k = 0; k < body.size(); ++k) {
        Dyadic weight = program.value(first_variable + k);
        if (weight.sign() == Sign::zero) continue;
        for (std::size_t c = 0; c < d; ++c) v[c] = v[c] + weight * Dyadic(body.row(k)[c]);
        weights.parts.push_back({k, std::move(weight)});
      }
    } else {
      for (std::size_t c = 0; c < d; ++c) {
        v[c] = program.value(first_variable + 2 * c) - program.value(first_variable + 2 * c + 1);
      }
      in_body = {v, program.denominator()};
    }
    ExactVector image = turned(pose, v);
    for (std::size_t r = 0; r < d; ++r) {
      image[r] = image[r] + program.denominator() * Dyadic(pose.translation()[r]);
    }
    return image;
  }

  // Where they are apart: of half-spaces, whose slacks have y <= 0.
  void multipliers(const Program& program, Weights& weights) const {
    if (body.is_of_points()) return;
    for (std::uint32_t k = 0; k < body.size(); ++k) {
      const Dyadic y = program.multiplier(first_row + k);
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
  Program program(of_b.first_row + of_b.rows(), of_b.first_variable + of_b.variables());
  of_a.add_to(program);
  of_b.add_to(program);
  PolytopeAnswer answer;
  answer.decided_by = DecidedBy::scan;
  answer.cost.exact = 1;
  const bool meet = program.solve(answer.cost.iterations);
  answer.cost.probes = (std::uint64_t{a.size()} + b.size()) * (std::uint64_t{answer.cost.iterations} + 1);
  ExactEvidence evidence;
  if (meet) {
    evidence.numbers = of_a.place(program, evidence.of_a, evidence.in_a);
    evidence.denominator = program.denominator();
    of_b.place(program, evidence.of_b, evidence.in_b);
  } else {  // y . (image of A) + s <= 0, -y . (image of B) + t <= 0, and y . right-hand side > 0
    for (std::size_t r = 0; r < d; ++r) evidence.numbers.push_back(program.multiplier(r));
    of_a.multipliers(program, evidence.of_a);
    of_b.multipliers(program, evidence.of_b);
  }
  answer.evidence =
      evidence_of(meet ? Verdict::meet : Verdict::apart, std::make_shared<const ExactEvidence>(std::move(evidence)));
  return answer;
}

}  // namespace sunder::polytope
