// Which of many points of R^d, d at most 7, is furthest along a direction, where their coordinates stand in columns: in
// floating point, with a bound on the error of the products; and exactly. Also called: support function; extreme point
// by a scan.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/sign.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder {

// Coordinates of points of up to six dimensions, or of half-spaces: a1, .., ad, b.
inline constexpr std::size_t most_columns = 7;

using ColumnNumbers = std::array<double, most_columns>;

// Coordinate c of point k is column[c * stride + k]. The stride is a multiple of `block`; up to there stands the
// last point again.
struct PointColumns {
  static constexpr std::size_t block = 32;

  const double* column = nullptr;
  std::size_t stride = 0;
  std::uint32_t count = 0;
  std::size_t dimension = 0;  // 2 to 7
  ColumnNumbers reach{};      // of each column the greatest size

  double at(std::uint32_t k, std::size_t c) const { return column[c * stride + k]; }
};

struct FurthestPoint {
  std::uint32_t index = 0;
  double product = 0;  // as floating point has it
};

// The point with the greatest product of floating point: of equals the first. Where products are no numbers, any. With
// `every`, of a sample: of each block whose number is a multiple of it.
// Cost: one look at each number, or each of the sample.
FurthestPoint furthest_along(const PointColumns& points, const ColumnNumbers& direction, std::size_t every = 1);

// Points that are far along some direction: those of a whole look that were the furthest of their piece of 16. Along a
// direction that is near to it, the furthest of all is likely among them. Pieces share places where they are many.
class Shortlist {
 public:
  static constexpr std::size_t most = 64;

  // For furthest_along. Requires a whole look before.
  PointColumns columns() const { return {numbers_.data(), stride_, count_, dimension_, {}}; }
  std::uint32_t index(std::uint32_t k) const { return indices_[k]; }  // of its point k
  std::uint32_t count() const { return count_; }

 private:
  friend FurthestPoint furthest_along(const PointColumns& points, const ColumnNumbers& direction, Shortlist& list);

  std::size_t stride_ = 0, dimension_ = 0;
  std::uint32_t count_ = 0;
  std::array<std::uint32_t, most> indices_;
  std::array<double, most * most_columns> numbers_;
};

// The same of all points, and the shortlist of this direction. Cost: some 1.8 times as much.
FurthestPoint furthest_along(const PointColumns& points, const ColumnNumbers& direction, Shortlist& list);

// A bound on the errors of such products, if the direction's components had `roundings` each (at most 16), and sizes
// (before rounding) of at most `sizes`. Let u = 2^-53: a sum of d <= 7 products of such components is a sum of
// monomials of at most roundings + 1 + 6 factors (1 + e), |e| <= u (number/rounded.h); two more pay for the magnitude,
// one for its product. What underflows loses at most 2^-1074 a component and a product. Infinite where anything may
// have overflowed.
double product_error(const PointColumns& points, const ColumnNumbers& sizes, int roundings);

// A product of floating point, and a bound of its error.
struct BoundedProduct {
  double product = 0, error = 0;
};

// The sign of the second exact product less the first.
inline Guess compare(const BoundedProduct& first, const BoundedProduct& second) {
  const double gap = second.product - first.product, slack = (first.error + second.error) * (1 + 0x1p-50);
  return gap * (1 - 0x1p-50) > slack ? Guess::positive : gap * (1 - 0x1p-50) < -slack ? Guess::negative : Guess::unsure;
}

// The greatest exact product with the direction, and the first point that has it. `exact_looks` grows by the points
// that floating point could not rule out. Cost: two looks at each number, and exact arithmetic for those near the end.
struct ExactFurthest {
  std::uint32_t index = 0;
  Dyadic product;
};
ExactFurthest exactly_furthest_along(const PointColumns& points, std::span<const Dyadic> direction,
                                     std::uint32_t& exact_looks);

// The same, and all points that have it, in their order: the face that is furthest. Cost: as above.
struct ExactFace {
  std::vector<std::uint32_t> indices;
  Dyadic product;
};
ExactFace exact_face_along(const PointColumns& points, std::span<const Dyadic> direction, std::uint32_t& exact_looks);

// Is the greatest product positive? Cost: one look at each number, and exact arithmetic for points whose product is
// about zero, where no other is further.
bool is_any_positive_along(const PointColumns& points, std::span<const Dyadic> direction, std::uint32_t& exact_looks);

// The points whose exact product with the direction is zero, in their order. Cost: as above.
std::vector<std::uint32_t> at_zero_along(const PointColumns& points, std::span<const Dyadic> direction,
                                         std::uint32_t& exact_looks);

}  // namespace sunder
