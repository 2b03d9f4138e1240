#include <sunder/base/contract.h>
#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/line/line_in_body.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace sunder {

namespace {

using Exact = Vector3<Dyadic>;

// Intervals about the numbers times one power of two, which brings the greatest near 1.
Vector3<Interval> scaled_enclosure(const Exact& v) {
  std::int64_t top = std::numeric_limits<std::int64_t>::min();
  for (const Dyadic* x : {&v.x, &v.y, &v.z}) {
    if (x->sign() != Sign::zero) top = std::max(top, x->top());
  }
  if (top == std::numeric_limits<std::int64_t>::min()) return {0.0, 0.0, 0.0};
  return {v.x.scaled(-top).enclosure(), v.y.scaled(-top).enclosure(), v.z.scaled(-top).enclosure()};
}

Exact operator*(const Exact& v, const Dyadic& by) { return {v.x * by, v.y * by, v.z * by}; }
Exact operator+(const Exact& v, const Exact& w) { return {v.x + w.x, v.y + w.y, v.z + w.z}; }

// The sign of formula<Stage>(), by intervals and then exactly.
template <class Formula>
Sign decide_by_two(StageTally* tally, const Formula& formula) {
  const Guess guess = sign(formula(IntervalStage{}));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, formula(ExactStage{}).sign());
}

template <class Stage>
auto normal(const Point3& u, const Point3& v, const Point3& w) {
  const auto from = lift<Stage>(u);
  return cross(lift<Stage>(v) - from, lift<Stage>(w) - from);
}

template <class Stage>
const auto& choose(const Vector3<Interval>& in, const Exact& exact) {
  if constexpr (std::is_same_v<Stage, IntervalStage>) {
    return in;
  } else {
    return exact;
  }
}

}  // namespace

LineInBody::LineInBody(const Point3& a, const Point3& b, const Affine3& pose) {
  const auto& m = pose.linear;
  const auto row = [&](std::size_t i) { return Exact{m[i], m[i + 1], m[i + 2]}; };
  const Exact r0 = row(0), r1 = row(3), r2 = row(6);
  // The columns of the adjugate.
  const Exact c0 = cross(r1, r2), c1 = cross(r2, r0), c2 = cross(r0, r1);
  scale_ = dot(r0, c0);
  SUNDER_REQUIRE(scale_.sign() != Sign::zero);
  const bool turned = scale_.sign() == Sign::negative;
  const auto pulled = [&](const Exact& v) {
    const Exact sum = c0 * v.x + c1 * v.y + c2 * v.z;
    return turned ? Exact{-sum.x, -sum.y, -sum.z} : sum;
  };
  const Exact from = lift<ExactStage>(a);
  point_ = pulled(from - Exact{pose.translation[0], pose.translation[1], pose.translation[2]});
  way_ = pulled(lift<ExactStage>(b) - from);
  if (turned) scale_ = -scale_;
  way_in_ = scaled_enclosure(way_);
}

Sign LineInBody::facing(const Point3& u, const Point3& v, const Point3& w, StageTally* tally) const {
  return decide_by_two(tally,
                       [&]<class Stage>(Stage) { return dot(normal<Stage>(u, v, w), choose<Stage>(way_in_, way_)); });
}

ExactPoint3 LineInBody::at_plane(const Point3& u, const Point3& v, const Point3& w) const {
  const Exact n = normal<ExactStage>(u, v, w);
  Dyadic up = dot(n, lift<ExactStage>(u) * scale_ - point_), down = dot(n, way_);
  SUNDER_REQUIRE(down.sign() != Sign::zero);
  if (down.sign() == Sign::negative) {
    up = -up;
    down = -down;
  }
  return exact_point(point_ * down + way_ * up, scale_ * down);
}

ExactPoint3 LineInBody::at(const ExactFraction& t) const {
  return exact_point(point_ * t.denominator + way_ * t.numerator, scale_ * t.denominator);
}

ExactPoint3 LineInBody::from_afar() const { return {-way_.x, -way_.y, -way_.z, Dyadic()}; }

ExactPoint3 LineInBody::between(const ExactPoint3& p, const ExactPoint3& q) {
  return exact_point(p.numerators() * q.denominator + q.numerators() * p.denominator,
                     (p.denominator * q.denominator).scaled(1));
}

Sign side_of_plane(const Point3& u, const Point3& v, const Point3& w, const ExactPoint3& p, StageTally* tally) {
  const Exact to = p.numerators() - lift<ExactStage>(u) * p.denominator;
  const Vector3<Interval> to_in = scaled_enclosure(to);
  return decide_by_two(tally,
                       [&]<class Stage>(Stage) { return dot(normal<Stage>(u, v, w), choose<Stage>(to_in, to)); });
}

WayFromMiddle::WayFromMiddle(const std::array<Point3, 4>& of, const ExactPoint3& to) : middle_of_(of) {
  Exact sum = lift<ExactStage>(of[0]);
  for (std::size_t k = 1; k < 4; ++k) sum = sum + lift<ExactStage>(of[k]);
  way_ = Exact{to.x.scaled(2), to.y.scaled(2), to.z.scaled(2)} - sum * to.denominator;
  way_in_ = scaled_enclosure(way_);
}

Sign WayFromMiddle::turn(const Point3& p, const Point3& q, StageTally* tally) const {
  return decide_by_two(tally, [&]<class Stage>(Stage) {
    // Four times the way from o: a sum of four differences.
    const auto from_middle = [&](const Point3& to) {
      const auto v = lift<Stage>(to);
      const auto d0 = v - lift<Stage>(middle_of_[0]), d1 = v - lift<Stage>(middle_of_[1]),
                 d2 = v - lift<Stage>(middle_of_[2]), d3 = v - lift<Stage>(middle_of_[3]);
      return Vector3<decltype(d0.x + d1.x)>{(d0.x + d1.x) + (d2.x + d3.x), (d0.y + d1.y) + (d2.y + d3.y),
                                            (d0.z + d1.z) + (d2.z + d3.z)};
    };
    return dot(cross(from_middle(p), from_middle(q)), choose<Stage>(way_in_, way_));
  });
}

}  // namespace sunder
