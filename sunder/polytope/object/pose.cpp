#include <sunder/base/contract.h>
#include <sunder/polytope/object/exact_matrix_internal.h>
#include <sunder/polytope/object/pose.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace sunder::polytope {

std::optional<ExactInverse> exact_inverse(std::size_t dimension, std::span<const double> matrix) {
  const std::size_t d = dimension, width = 2 * d;
  std::int64_t unit = std::numeric_limits<std::int64_t>::max();
  for (const double x : matrix) {
    if (x != 0) unit = std::min(unit, Dyadic(x).exponent());
  }
  if (unit == std::numeric_limits<std::int64_t>::max()) return std::nullopt;
  // The matrix in its unit, beside the identity; both times the pivots so far.
  std::vector<Integer> rows(d * width);
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t j = 0; j < d; ++j) {
      const Dyadic x(matrix[i * d + j]);
      if (x.sign() != Sign::zero) rows[i * width + j] = mantissa_of(x) << static_cast<unsigned>(x.exponent() - unit);
    }
    rows[i * width + d + i] = 1;
  }
  Integer before = 1;
  for (std::size_t k = 0; k < d; ++k) {
    std::size_t p = k;
    while (p < d && rows[p * width + k].is_zero()) ++p;
    if (p == d) return std::nullopt;
    if (p != k) {
      for (std::size_t j = 0; j < width; ++j) std::swap(rows[p * width + j], rows[k * width + j]);
    }
    const Integer pivot = rows[k * width + k];
    for (std::size_t i = 0; i < d; ++i) {
      if (i == k) continue;
      const Integer factor = rows[i * width + k];
      for (std::size_t j = 0; j < width; ++j) {
        rows[i * width + j] = (rows[i * width + j] * pivot - rows[k * width + j] * factor) / before;  // exact
      }
    }
    before = pivot;
  }
  // Now each row has the last pivot on the diagonal.
  ExactInverse result;
  const bool is_negative = before < 0;
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t j = 0; j < d; ++j) {
      const Integer& n = rows[i * width + d + j];
      result.numbers.push_back(dyadic_of(is_negative ? -n : n, 0));
    }
  }
  result.denominator = dyadic_of(is_negative ? -before : before, unit);
  return result;
}

Pose::Pose(std::size_t dimension) : dimension_(dimension) {
  SUNDER_REQUIRE(dimension >= least_dimension && dimension <= most_dimension);
  for (std::size_t k = 0; k < dimension; ++k) linear_[k * dimension + k] = 1;
  linear_range_ = size_range(this->linear());
}

Pose::Pose(std::size_t dimension, std::span<const double> linear, std::span<const double> translation)
    : dimension_(dimension), linear_range_(size_range(linear)), translation_range_(size_range(translation)) {
  std::copy(linear.begin(), linear.end(), linear_.begin());
  std::copy(translation.begin(), translation.end(), translation_.begin());
  const Pose identity(dimension);
  is_identity_ = linear_ == identity.linear_ && translation_ == identity.translation_;
}

Pose Pose::from_matrix(std::size_t dimension, std::span<const double> linear, std::span<const double> translation) {
  const auto fail = [](const std::string& what) { throw Error(ErrorCode::bad_pose, what, "pose"); };
  if (dimension < least_dimension || dimension > most_dimension) {
    fail("of dimension " + std::to_string(dimension) + "; give a dimension from 2 to 6");
  }
  if (linear.size() != dimension * dimension || translation.size() != dimension) {
    fail("of " + std::to_string(linear.size()) + " and " + std::to_string(translation.size()) + " numbers; give " +
         std::to_string(dimension * dimension) + " and " + std::to_string(dimension));
  }
  for (const std::span<const double> part : {linear, translation}) {
    if (!std::all_of(part.begin(), part.end(), [](double x) { return std::isfinite(x); })) {
      fail("has a number that is not finite; give finite doubles");
    }
  }
  const Pose pose(dimension, linear, translation);
  const Pose identity(dimension);
  if (pose.linear_ != identity.linear_ && !exact_inverse(dimension, linear)) {
    fail("the matrix is singular; give an invertible one");
  }
  return pose;
}

}  // namespace sunder::polytope
