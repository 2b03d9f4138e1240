// Convex polytopes of two to six dimensions, in the form in which they were given: the hull of points, or the common
// part of half-spaces. Neither is turned into the other, and nothing is rounded.
// Also called: V-polytope and H-polytope (polyhedron).
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/filter/along_columns.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace sunder::polytope {

inline constexpr std::size_t least_dimension = 2, most_dimension = 6;

enum class Form : std::uint8_t { points, half_spaces };

// Immutable; any number of threads may use it. A row is a point x1, .., xd, or a half-space a1, .., ad, b, which is
// that of all x with a1 x1 + .. + ad xd <= b.
//   P1. The hull of points is bounded and not empty; it may be of any dimension up to d. Points may be repeated, and
//       lie anywhere in the hull.
//   P2. The common part of half-spaces may be empty, unbounded, or of any dimension. A half-space with a = 0 is
//       everything, or nothing. No half-spaces at all are everything.
class Polytope {
 public:
  // numbers: row after row. Throws Error bad_shape where d is none of 2 to 6, where there is no whole number of rows,
  // no point, or more than 2^32 - 64 rows; bad_value where a number is not finite. Cost: linear; holds each number
  // twice.
  static Polytope from_points(std::size_t dimension, std::vector<double> numbers);
  static Polytope from_half_spaces(std::size_t dimension, std::vector<double> numbers);

  std::size_t dimension() const { return dimension_; }
  Form form() const { return form_; }
  bool is_of_points() const { return form_ == Form::points; }
  std::uint32_t size() const { return size_; }  // of rows
  std::span<const double> row(std::uint32_t k) const { return std::span(rows_).subspan(k * width_, width_); }

  // For scans: the numbers of all rows, column by column; behind the last row it stands again, to make the blocks full.
  const PointColumns& columns() const { return columns_; }

 private:
  Polytope(std::size_t dimension, Form form, std::vector<double> numbers);

  std::size_t dimension_, width_;
  Form form_;
  std::uint32_t size_ = 0;
  std::vector<double> rows_;
  std::shared_ptr<const std::vector<double>> numbers_;  // of the columns
  PointColumns columns_;
};

}  // namespace sunder::polytope
