#include <sunder/number/double_double.h>
#include <sunder/predicate/orient.h>
#include <sunder/predicate/stages.h>

namespace sunder {

namespace {

template <class P>
Sign orient_2d_along_axis(int axis, const P& a, const P& b, const P& c, StageTally* tally) {
  if (axis == 0) return decide(tally, orient_2d_formula<0>, a, b, c);
  if (axis == 1) return decide(tally, orient_2d_formula<1>, a, b, c);
  return decide(tally, orient_2d_formula<2>, a, b, c);
}

// The sign of left - right, for the products of two tame numbers each. A product is the sum of two doubles, of which
// the first is the product rounded: rounding keeps the order, so where the first ones differ they tell, else the
// second.
Sign compare_products(double left_a, double left_b, double right_a, double right_b) {
  const DoubleDouble left = exact_product(left_a, left_b), right = exact_product(right_a, right_b);
  return left > right ? Sign::positive : left < right ? Sign::negative : Sign::zero;
}

// A difference that a double holds, and whose products neither overflow nor underflow.
bool is_exact(const DoubleDouble& difference) { return difference.low == 0 && tame(difference.high); }

}  // namespace

Sign orient_2d_further(const Point2& a, const Point2& b, const Point2& c, StageTally* tally) {
  // Coordinates that are small integers, or multiples of one number: a tie is told without exact numbers.
  const DoubleDouble ux = exact_sum(b.x, -a.x), uy = exact_sum(b.y, -a.y);
  const DoubleDouble vx = exact_sum(c.x, -a.x), vy = exact_sum(c.y, -a.y);
  if (is_exact(ux) && is_exact(uy) && is_exact(vx) && is_exact(vy)) {
    if (tally) ++tally->rounded;
    return compare_products(ux.high, vy.high, uy.high, vx.high);
  }
  const auto in_space = [](const Point2& p) { return Point3{p.x, p.y, 0}; };
  return decide(tally, orient_2d_formula<2>, in_space(a), in_space(b), in_space(c));
}

Sign orient_2d_along(int axis, const Point3& a, const Point3& b, const Point3& c, StageTally* tally) {
  return orient_2d_along_axis(axis, a, b, c, tally);
}

Sign orient_2d_along(int axis, const Posed& a, const Posed& b, const Posed& c, StageTally* tally) {
  return orient_2d_along_axis(axis, a, b, c, tally);
}

Sign orient_3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d, StageTally* tally) {
  return decide(tally, orient_3d_formula, a, b, c, d);
}

Sign orient_3d(const Posed& a, const Posed& b, const Posed& c, const Posed& d, StageTally* tally) {
  return decide(tally, orient_3d_formula, a, b, c, d);
}

Sign compare_coordinate(int axis, const Posed& a, const Posed& b, StageTally* tally) {
  if (axis == 0) return decide(tally, difference_formula<0>, a, b);
  if (axis == 1) return decide(tally, difference_formula<1>, a, b);
  return decide(tally, difference_formula<2>, a, b);
}

Sign determinant_sign(const Affine3& pose) {
  const auto& m = pose.linear;
  return orient_3d(Point3{}, {m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]});
}

}  // namespace sunder
