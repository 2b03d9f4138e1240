#include <sunder/polytope/object/polytope.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace sunder::polytope {

Polytope::Polytope(std::size_t dimension, Form form, std::vector<double> numbers)
    : dimension_(dimension), width_(dimension + (form == Form::half_spaces)), form_(form), rows_(std::move(numbers)) {
  const bool of_points = form == Form::points;
  const std::string noun = of_points ? "point" : "half-space";
  if (dimension < least_dimension || dimension > most_dimension) {
    throw Error(ErrorCode::bad_shape,
                noun + "s of dimension " + std::to_string(dimension) + "; give a dimension from 2 to 6");
  }
  if (rows_.size() % width_ != 0) {
    throw Error(ErrorCode::bad_shape, std::to_string(rows_.size()) + " numbers are no whole number of " + noun +
                                          "s; give " + std::to_string(width_) + " each");
  }
  const std::size_t count = rows_.size() / width_;
  if (of_points && count == 0) throw Error(ErrorCode::bad_shape, "no points; give one at least");
  if (count > 0xffffffffu - 2 * PointColumns::block)
    throw Error(ErrorCode::bad_shape, "too many " + noun + "s; give fewer");
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    if (!std::isfinite(rows_[k])) {
      throw Error(ErrorCode::bad_value, "a number that is not finite; give finite doubles",
                  noun + " " + std::to_string(k / width_));
    }
    double& reach = columns_.reach[k % width_];
    reach = std::max(reach, std::fabs(rows_[k]));
  }
  size_ = static_cast<std::uint32_t>(count);
  columns_.count = size_;
  columns_.dimension = width_;
  columns_.stride = (count + PointColumns::block - 1) / PointColumns::block * PointColumns::block;
  std::vector<double> by_columns(columns_.stride * width_);
  for (std::size_t c = 0; c < width_; ++c) {
    for (std::size_t k = 0; k < columns_.stride; ++k) {
      by_columns[c * columns_.stride + k] = rows_[std::min(k, count - 1) * width_ + c];
    }
  }
  numbers_ = std::make_shared<const std::vector<double>>(std::move(by_columns));
  columns_.column = numbers_->data();
}

Polytope Polytope::from_points(std::size_t dimension, std::vector<double> numbers) {
  return {dimension, Form::points, std::move(numbers)};
}

Polytope Polytope::from_half_spaces(std::size_t dimension, std::vector<double> numbers) {
  return {dimension, Form::half_spaces, std::move(numbers)};
}

}  // namespace sunder::polytope
