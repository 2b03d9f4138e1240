#include <sunder/base/lanes.h>
#include <sunder/predicate/filter/sharp_stage.h>
#include <sunder/predicate/point/orient.h>

namespace sunder {

namespace {

template <class P, class Q>
Sign orient_2d_along_axis(int axis, const P& a, const P& b, const Q& c, StageTally* tally) {
  if (axis == 0) return decide(tally, orient_2d_formula<0>, a, b, c);
  if (axis == 1) return decide(tally, orient_2d_formula<1>, a, b, c);
  return decide(tally, orient_2d_formula<2>, a, b, c);
}

template <class P>
bool are_collinear_along_axes(const Point3& a, const Point3& b, const P& c, StageTally* tally) {
  for (int axis = 0; axis < 3; ++axis) {
    if (orient_2d_along_axis(axis, a, b, c, tally) != Sign::zero) return false;
  }
  return true;
}

// Two sums of two doubles each: the rounded numbers, and what rounding left of them.
struct TwoExact {
  Lanes rounded, rest;
};

// As exact_sum and exact_product of number/double_double.h, on two at once.
TwoExact exact_differences(Lanes a, Lanes b) {
  const Lanes difference = a - b, of_b = a - difference;
  return {difference, (a - (difference + of_b)) + (of_b - b)};
}
TwoExact exact_products(Lanes a, Lanes b) {
  const auto upper_halves = [](Lanes x) {
    const Lanes c = 0x1.0000002p27 * x;  // 2^27 + 1
    return c - (c - x);
  };
  const Lanes product = a * b;
  const Lanes a1 = upper_halves(a), a2 = a - a1, b1 = upper_halves(b), b2 = b - b1;
  return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

// Differences that doubles hold, and whose products neither overflow nor underflow.
bool are_exact(const TwoExact& differences) {
  const Lanes size = absolute(differences.rounded);
  const LanesMask tame = ((size >= 0x1p-280) & (size <= 0x1p280)) | (size == 0.0);
  return bits_of(tame & (differences.rest == 0.0)) == 3;
}

// The sign of the first product minus the second one. Rounding keeps their order, so where the rounded ones differ they
// tell, else the rests.
Sign compare_products(Lanes a, Lanes b) {
  const TwoExact products = exact_products(a, b);
  const Lanes& decisive = products.rounded[0] != products.rounded[1] ? products.rounded : products.rest;
  return decisive[0] > decisive[1] ? Sign::positive : decisive[0] < decisive[1] ? Sign::negative : Sign::zero;
}

}  // namespace

Sign orient_2d_further(const Point2& a, const Point2& b, const Point2& c, StageTally* tally) {
  // Coordinates that are small integers, or multiples of one number: a tie is told without exact numbers.
  const Lanes from = lanes_at(&a.x);
  const TwoExact u = exact_differences(lanes_at(&b.x), from), v = exact_differences(lanes_at(&c.x), from);
  if (are_exact(u) && are_exact(v)) {
    return counted(&StageTally::rounded, tally, compare_products(u.rounded, swapped(v.rounded)));
  }
  const auto in_space = [](const Point2& p) { return Point3{p.x, p.y, 0}; };
  return decide_sharply(tally, orient_2d_formula<2>, in_space(a), in_space(b), in_space(c));
}

Sign orient_2d_along(int axis, const Point3& a, const Point3& b, const Point3& c, StageTally* tally) {
  return orient_2d_along_axis(axis, a, b, c, tally);
}

Sign orient_2d_along(int axis, const Posed3& a, const Posed3& b, const Posed3& c, StageTally* tally) {
  return orient_2d_along_axis(axis, a, b, c, tally);
}

Sign orient_3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d, StageTally* tally) {
  return decide(tally, orient_3d_formula, a, b, c, d);
}

Sign orient_3d(const Posed3& a, const Posed3& b, const Posed3& c, const Posed3& d, StageTally* tally) {
  return decide_sharply<SharpImageStage>(tally, orient_3d_formula, a, b, c, d);
}

Sign orient_3d(const Posed3& a, const Posed3& b, const Posed3& c, const Point3& d, StageTally* tally) {
  return decide_sharply<SharpImageStage>(tally, orient_3d_formula, a, b, c, d);
}

Sign orient_3d(const Point3& a, const Point3& b, const Posed3& c, const Posed3& d, StageTally* tally) {
  return decide_sharply<SharpImageStage>(tally, orient_3d_formula, a, b, c, d);
}

bool are_collinear(const Point3& a, const Point3& b, const Point3& c, StageTally* tally) {
  return are_collinear_along_axes(a, b, c, tally);
}

bool are_collinear(const Point3& a, const Point3& b, const Posed3& c, StageTally* tally) {
  return are_collinear_along_axes(a, b, c, tally);
}

Sign compare_coordinate(int axis, const Posed3& a, const Posed3& b, StageTally* tally) {
  if (axis == 0) return decide(tally, difference_formula<0>, a, b);
  if (axis == 1) return decide(tally, difference_formula<1>, a, b);
  return decide(tally, difference_formula<2>, a, b);
}

Sign determinant_sign(const Affine3& pose) {
  const auto& m = pose.linear;
  const auto determinant = [](const auto& a, const auto& b, const auto& c) { return dot(cross(a, b), c); };
  return decide(nullptr, determinant, Point3{m[0], m[1], m[2]}, Point3{m[3], m[4], m[5]}, Point3{m[6], m[7], m[8]});
}

}  // namespace sunder
