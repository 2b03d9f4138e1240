#include <sunder/predicate/point/along.h>

namespace sunder {

Vector3<Interval> WorldDirection::enclosure() const {
  if (is_doubles_) return lift<IntervalStage>(doubles_);
  std::int64_t top = std::numeric_limits<std::int64_t>::min();
  for (const Dyadic* x : {&exact_->x, &exact_->y, &exact_->z}) {
    if (x->sign() != Sign::zero) top = std::max(top, x->top());
  }
  const auto scaled = [&](const Dyadic& x) { return x.sign() == Sign::zero ? Interval() : x.scaled(-top).enclosure(); };
  return {scaled(exact_->x), scaled(exact_->y), scaled(exact_->z)};
}

Vector3<Dyadic> WorldDirection::exact() const { return is_doubles_ ? lift<ExactStage>(doubles_) : *exact_; }

WorldDirection cross_direction(const Posed3& a, const Posed3& b, const Posed3& c, const Posed3& d) {
  return WorldDirection(cross(lift<ExactStage>(b) - lift<ExactStage>(a), lift<ExactStage>(d) - lift<ExactStage>(c)));
}

WorldDirection difference_direction(const Posed3& a, const Posed3& b) {
  return WorldDirection(lift<ExactStage>(b) - lift<ExactStage>(a));
}

Sign Along::compare_further(const Point3& from, const Point3& to, StageTally* tally) {
  const Guess guess = sign(dot(interval(), lift<IntervalStage>(to) - lift<IntervalStage>(from)));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, dot(exact(), lift<ExactStage>(to) - lift<ExactStage>(from)).sign());
}

Sign Along::compare(const ExactPoint3& from, const ExactPoint3& to, StageTally* tally) {
  const auto axis = [&](const Dyadic& t, const Dyadic& f) { return t * from.denominator - f * to.denominator; };
  const Vector3<Dyadic> difference{axis(to.x, from.x), axis(to.y, from.y), axis(to.z, from.z)};
  return counted(&StageTally::exact, tally, dot(exact(), difference).sign());
}

Sign Along::turn_further(const Point3& m, const Point3& v, const Point3& a, const Point3& b, StageTally* tally) {
  const Guess guess = sign(turn_formula(interval(), lift<IntervalStage>(m), lift<IntervalStage>(v),
                                        lift<IntervalStage>(a), lift<IntervalStage>(b)));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(
      &StageTally::exact, tally,
      turn_formula(exact(), lift<ExactStage>(m), lift<ExactStage>(v), lift<ExactStage>(a), lift<ExactStage>(b)).sign());
}

Sign Along::turn_about_normal(const Point3& p, const Point3& q, const Point3& v, const Point3& a, const Point3& b,
                              StageTally* tally) {
  const auto formula = [](const auto& direction, const auto& i, const auto& j, const auto& at, const auto& k,
                          const auto& l) { return turn_formula(direction, cross(i - at, j - at), at, k, l); };
  const Guess guess = sign(formula(interval(), lift<IntervalStage>(p), lift<IntervalStage>(q), lift<IntervalStage>(v),
                                   lift<IntervalStage>(a), lift<IntervalStage>(b)));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally,
                 formula(exact(), lift<ExactStage>(p), lift<ExactStage>(q), lift<ExactStage>(v), lift<ExactStage>(a),
                         lift<ExactStage>(b))
                     .sign());
}

Sign compare_along_further(const WorldDirection& direction, const Posed3& a, const Posed3& b, StageTally* tally) {
  const Guess guess = sign(dot(direction.enclosure(), lift<IntervalStage>(b) - lift<IntervalStage>(a)));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, dot(direction.exact(), lift<ExactStage>(b) - lift<ExactStage>(a)).sign());
}

}  // namespace sunder
