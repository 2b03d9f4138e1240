#include <sunder/base/contract.h>
#include <sunder/number/exact/elimination_internal.h>
#include <sunder/polytope/object/pose.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace sunder::polytope {

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
