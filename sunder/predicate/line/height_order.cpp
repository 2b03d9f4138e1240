#include <sunder/predicate/filter/sharp_stage.h>
#include <sunder/predicate/line/height_order.h>

namespace sunder {

Sign height_order_further(const Point2& a, const Point2& b, const Point2& c, const Point2& d, double x,
                          StageTally* tally) {
  const auto formula = [](const auto& p, const auto& q, const auto& r, const auto& s, const auto& at) {
    const auto u = q - p;
    const auto v = s - r;
    return ((p.y - r.y) * (u.x * v.x) + v.x * (u.y * (at.x - p.x))) - u.x * (v.y * (at.x - r.x));
  };
  const auto in_space = [](const Point2& p) { return Point3{p.x, p.y, 0}; };
  return decide_sharply(tally, formula, in_space(a), in_space(b), in_space(c), in_space(d), Point3{x, 0, 0});
}

}  // namespace sunder
