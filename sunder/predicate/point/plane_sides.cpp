#include <sunder/predicate/point/plane_sides.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder {

namespace {

// The formula is that of side_of_plane with its products opened: (normal . linear) . p, less the level.
template <class Stage>
auto pulled(const Point3& normal, const Affine3& pose) {
  const auto n = lift<Stage>(normal);
  const auto& m = pose.linear;
  const auto column = [&](std::size_t j) {
    return n.x * Stage::read(m[j]) + n.y * Stage::read(m[3 + j]) + n.z * Stage::read(m[6 + j]);
  };
  return Vector3<decltype(column(0))>{column(0), column(1), column(2)};
}

template <class Stage>
auto level(const Point3& normal, const Point3& point, double offset, const Affine3& pose) {
  const auto& t = pose.translation;
  return dot(lift<Stage>(normal), lift<Stage>(point) - lift<Stage>(Point3{t[0], t[1], t[2]})) + Stage::read(offset);
}

bool is_between(double x, double least, double greatest) {
  return x == 0 || (std::fabs(x) >= least && std::fabs(x) <= greatest);
}

}  // namespace

Sign turn_seen_from(const Point3& normal, const Posed3& a, const Posed3& b, const Posed3& c, StageTally* tally) {
  const auto formula = [](const auto& n, const auto& p, const auto& q, const auto& r) {
    return dot(n, cross(q - p, r - p));
  };
  return decide(tally, formula, normal, a, b, c);
}

// Floating point neither overflows nor underflows where the images are tame, and the normal, scaled so that its largest
// component is in [1/2, 1), has none below 2^-60 but zeros. As said of images_are_tame, its products with the linear
// part are zero or at least m 2^-113, m the least entry, so those with coordinates at least 2^-366, and below 2^253.
// The point and the translation are multiples of 2^-302, so products with their differences of 2^-414.
PlaneSides::PlaneSides(const Point3& normal, const Point3& point, const Affine3& pose, bool images_tame,
                       double coordinates)
    : normal_(normal), point_(point), pose_(pose), coordinates_(coordinates), may_be_fast_(images_tame) {
  std::frexp(std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)}), &exponent_);
  for (std::size_t k = 0; k < 3; ++k) {
    scaled_[k] = std::ldexp(normal[k], -exponent_);
    may_be_fast_ = may_be_fast_ && is_between(scaled_[k], 0x1p-60, 1) && (scaled_[k] == 0) == (normal[k] == 0) &&
                   is_between(point[k], 0x1p-250, 0x1p250);
  }
  set_offset(0);
}

void PlaneSides::set_offset(double offset) {
  offset_ = offset;
  interval_.reset();
  exact_.reset();
  const double scaled = std::ldexp(offset, -exponent_);
  if (!may_be_fast_ || !is_between(scaled, 0x1p-300, 0x1p300) || (scaled == 0) != (offset == 0)) {
    error_ = std::numeric_limits<double>::infinity();
    return;
  }
  const auto normal = pulled<RoundedStage>(scaled_, pose_);
  const auto rounded_level = level<RoundedStage>(scaled_, point_, scaled, pose_);
  // The magnitude of a height is at most that of a point with these coordinates, as rounding is monotone.
  const Rounded<0> most = leaf(coordinates_);
  const auto height = dot(normal, Vector3<Rounded<0>>{most, most, most}) - rounded_level;
  x_ = normal.x.value;
  y_ = normal.y.value;
  z_ = normal.z.value;
  level_ = rounded_level.value;
  error_ = height.bound * height.magnitude;
}

template <class Stage, class Number>
Number PlaneSides::seen_height(std::optional<Seen<Number>>& kept, const Point3& p) const {
  if (!kept) kept = Seen<Number>{pulled<Stage>(normal_, pose_), level<Stage>(normal_, point_, offset_, pose_)};
  return dot(kept->normal, lift<Stage>(p)) - kept->level;
}

Sign PlaneSides::further(const Point3& p, StageTally* tally) {
  const Guess guess = sign(seen_height<IntervalStage>(interval_, p));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, seen_height<ExactStage>(exact_, p).sign());
}

}  // namespace sunder
