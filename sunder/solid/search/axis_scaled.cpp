#include <sunder/solid/search/axis_scaled.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sunder::solid {

namespace {

using Propose = FunctionRef<bool(const Placed&, const Placed&, const Holds&)>;

class AxisScaled {
 public:
  AxisScaled(const Placed& a, const Placed& b) {
    const Point3 p = lengths(a), q = lengths(b);
    size_ = {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)};
    least_ = std::min(size_[0], std::min(size_[1], size_[2]));
    greatest_ = std::max(size_[0], std::max(size_[1], size_[2]));
    if (least_ > 0 && greatest_ <= std::numeric_limits<double>::max()) return;
    least_ = std::numeric_limits<double>::infinity(), greatest_ = 0;
    for (double& size : size_) {
      if (size > 0 && size <= std::numeric_limits<double>::max()) {
        least_ = std::min(least_, size);
        greatest_ = std::max(greatest_, size);
      } else {
        size = 1;
      }
    }
  }

  // Would floating point not see along one axis what there is, for what there is along another?
  bool is_wanted() const { return greatest_ > least_ * 0x1p40; }

  // propose(a, b, holds): of the bodies so scaled.
  bool propose(const Placed& a, const Placed& b, const Holds& holds, const Propose& propose) const {
    std::array<double, 3> by;
    for (std::size_t i = 0; i < 3; ++i) by[i] = std::ldexp(1.0, std::clamp(-std::ilogb(size_[i]), -1020, 1020));
    const auto scaled = [&](Affine3 pose) {
      for (std::size_t i = 0; i < 9; ++i) pose.linear[i] *= by[i / 3];
      for (std::size_t i = 0; i < 3; ++i) pose.translation[i] *= by[i];
      return pose;
    };
    const Affine3 pose_a = scaled(a.pose), pose_b = scaled(b.pose);
    // A direction is a linear form: d . (S x) is (S d) . x. Beside a form n of the world it only tells a sense.
    const auto of_world = [&](Proposal p) {
      using enum Proposal::Claim;
      const bool is_form = p.claim == apart_along || p.claim == apart_along_sum;
      for (Point3* d : {&p.direction, &p.rest}) {
        *d = is_form ? Point3{d->x * by[0], d->y * by[1], d->z * by[2]}
                     : Point3{d->x / by[0], d->y / by[1], d->z / by[2]};
      }
      return holds(p);
    };
    return propose(Placed(a, pose_a), Placed(b, pose_b), of_world);
  }

 private:
  // Bounds of the image's coordinates without the translation.
  static Point3 lengths(const Placed& body) {
    const Point3 &low = body.graph.low, &high = body.graph.high;
    const auto reach = [](double from, double to) { return std::max(std::fabs(from), std::fabs(to)); };
    const double x = reach(low.x, high.x), y = reach(low.y, high.y), z = reach(low.z, high.z);
    const auto& m = body.pose.linear;
    const auto along = [&](std::size_t i) {
      return std::fabs(m[i]) * x + std::fabs(m[i + 1]) * y + std::fabs(m[i + 2]) * z;
    };
    return {along(0), along(3), along(6)};
  }

  std::array<double, 3> size_;
  double least_, greatest_;
};

}  // namespace

bool propose_axis_scaled_where_wanted(const Placed& a, const Placed& b, const Holds& holds, Propose propose) {
  const AxisScaled scaled(a, b);
  return scaled.is_wanted() ? scaled.propose(a, b, holds, propose) : propose(a, b, holds);
}

}  // namespace sunder::solid
