// Comparisons along a direction of the world, exact, for points of posed bodies.
// Also called: comparison of dot products; which support point is further.
#pragma once

#include <sunder/base/lanes.h>
#include <sunder/predicate/exact_point.h>
#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/posed.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace sunder {

// A direction of the world: three doubles, or three exact numbers where doubles cannot hold it. Only its ray counts.
class WorldDirection {
 public:
  // Exactly these doubles; all finite.
  explicit WorldDirection(const Point3& doubles)
      : doubles_(doubles), is_doubles_(true), is_tame_(tame(doubles.x) && tame(doubles.y) && tame(doubles.z)) {}

  explicit WorldDirection(Vector3<Dyadic> exact) : exact_(std::move(exact)) {}

  bool is_doubles() const { return is_doubles_; }
  const Point3& doubles() const { return doubles_; }  // meaningless unless is_doubles()

  // True for doubles with which floating point does not underflow: components zero or in [least_tame, 1].
  static constexpr double least_tame = 0x1p-60;
  bool is_tame() const { return is_tame_; }

  Vector3<Interval> enclosure() const;  // up to a power of two
  Vector3<Dyadic> exact() const;        // the same power of two for all

 private:
  static bool tame(double x) {
    const double size = std::fabs(x);
    return size == 0 || (size >= least_tame && size <= 1);
  }

  Point3 doubles_;
  bool is_doubles_ = false;
  bool is_tame_ = false;
  std::optional<Vector3<Dyadic>> exact_;  // set unless is_doubles_
};

// Scales the direction so that its greatest component has size 1, and drops components that are negligible then: so it
// is tame. For searches, which may choose. False for zero and for what is not finite.
inline bool make_tame(Point3& d) {
  const double largest = std::max(std::fabs(d.x), std::max(std::fabs(d.y), std::fabs(d.z)));
  if (!(largest > 0) || !std::isfinite(d.x) || !std::isfinite(d.y) || !std::isfinite(d.z)) return false;
  const auto component = [&](double x) {
    const double part = x / largest;
    return std::fabs(part) < WorldDirection::least_tame ? 0.0 : part;
  };
  d = {component(d.x), component(d.y), component(d.z)};
  return true;
}

// The exact direction (b - a) x (d - c), and b - a, from posed points.
WorldDirection cross_direction(const Posed3& a, const Posed3& b, const Posed3& c, const Posed3& d);
WorldDirection difference_direction(const Posed3& a, const Posed3& b);

// The direction seen from the frame of a posed body: compares points of that body along it.
class Along {
 private:
  // The transposed linear part times the direction.
  template <class Stage, class Vector>
  auto pulled(const Vector& d) const {
    const auto& m = pose_.linear;
    const auto column = [&](std::size_t j) {
      return Stage::read(m[j]) * d.x + Stage::read(m[3 + j]) * d.y + Stage::read(m[6 + j]) * d.z;
    };
    return Vector3<decltype(column(0))>{column(0), column(1), column(2)};
  }

  template <class D, class M, class V>
  static auto turn_formula(const D& direction, const M& m, const V& v, const V& a, const V& b) {
    const auto to_a = a - v, to_b = b - v;
    return dot(direction, to_a) * dot(m, to_b) - dot(direction, to_b) * dot(m, to_a);
  }

 public:
  // images_tame: as decided by images_are_tame for the body. Keeps references to both arguments.
  Along(const WorldDirection& direction, const Affine3& pose, bool images_tame)
      : direction_(direction), pose_(pose), fast_(images_tame && direction.is_tame()) {
    if (fast_) rounded_ = pulled<RoundedStage>(lift<RoundedStage>(direction.doubles()));
  }

  // Are all `count` points, coordinate by coordinate, surely less far than `at`? False also means: not sure. `reach` is
  // an upper bound on the sizes of all coordinates involved. Floating point with one error bound for all. Requires an
  // even count, at least two.
  bool surely_less_far(const double* x, const double* y, const double* z, std::size_t count, const Point3& at,
                       double reach) const {
    return surely_beyond<-1>(x, y, z, count, at, reach);
  }
  bool surely_further(const double* x, const double* y, const double* z, std::size_t count, const Point3& at,
                      double reach) const {
    return surely_beyond<1>(x, y, z, count, at, reach);
  }

  // The sign of direction . (image of `to` - image of `from`): positive when `to` is further along.
  Sign compare(const Point3& from, const Point3& to, StageTally* tally = nullptr) {
    if (fast_) {
      const Guess guess = sign(dot(rounded_, lift<RoundedStage>(to) - lift<RoundedStage>(from)));
      if (is_sure(guess)) return counted(&StageTally::rounded, tally, to_sign(guess));
    }
    return compare_further(from, to, tally);
  }

  // The same of points that are known to `error` in each coordinate, as far as floating point tells: else unsure. For
  // points of the body's hull, where the error is at least 2^-53 of the greatest coordinate.
  Guess compare_within(const Point3& from, const Point3& to, double error) const {
    if (!fast_) return Guess::unsure;
    const auto difference = dot(rounded_, lift<RoundedStage>(to) - lift<RoundedStage>(from));
    const double size = rounded_.x.magnitude + rounded_.y.magnitude + rounded_.z.magnitude;
    const double bound = Rounded<12>::bound * difference.magnitude + 2 * (1 + 0x1p-40) * error * size;
    if (difference.value > bound) return Guess::positive;
    return difference.value < -bound ? Guess::negative : Guess::unsure;
  }

  // The same of exact points, whose denominators are positive, exactly.
  Sign compare(const ExactPoint3& from, const ExactPoint3& to, StageTally* tally = nullptr);

  // The sign of the determinant of three directions: m, the normal (a - v) x (b - v), and this one. m is tame, as
  // WorldDirection says. Formula: (direction . (a - v)) (m . (b - v)) - (direction . (b - v)) (m . (a - v)).
  // turns_tame: as decided by turns_are_tame for the body; false is always allowed, and costs time only.
  Sign turn(const Point3& m, const Point3& v, const Point3& a, const Point3& b, bool turns_tame,
            StageTally* tally = nullptr) {
    if (fast_ && turns_tame) {
      const Guess guess = sign(turn_formula(rounded_, lift<RoundedStage>(m), lift<RoundedStage>(v),
                                            lift<RoundedStage>(a), lift<RoundedStage>(b)));
      if (is_sure(guess)) return counted(&StageTally::rounded, tally, to_sign(guess));
    }
    return turn_further(m, v, a, b, tally);
  }

  // The same with the normal (p - v) x (q - v) as m.
  Sign turn_about_normal(const Point3& p, const Point3& q, const Point3& v, const Point3& a, const Point3& b,
                         StageTally* tally = nullptr);

 private:
  const Vector3<Interval>& interval() {
    if (!interval_) interval_ = pulled<IntervalStage>(direction_.enclosure());
    return *interval_;
  }
  const Vector3<Dyadic>& exact() {
    if (!exact_) exact_ = pulled<ExactStage>(direction_.exact());
    return *exact_;
  }

  // The formula of compare() is a Rounded<7>: its magnitude is at most that of the pulled direction times the greatest
  // difference of coordinates, at most 2 reach; another Rounded step pays for the rounding of this product.
  template <int Side>
  bool surely_beyond(const double* x, const double* y, const double* z, std::size_t count, const Point3& at,
                     double reach) const {
    if (!fast_) return false;
    const double magnitude = rounded_.x.magnitude + rounded_.y.magnitude + rounded_.z.magnitude;
    const double error = Rounded<12>::bound * (magnitude * (2 * reach));
    const double dx = Side * rounded_.x.value, dy = Side * rounded_.y.value, dz = Side * rounded_.z.value;
    LanesMask all{-1, -1};
    for (std::size_t j = 0; j < count; j += 2) {
      all &= dx * (lanes_at(x + j) - at.x) + dy * (lanes_at(y + j) - at.y) + dz * (lanes_at(z + j) - at.z) > error;
    }
    return (all[0] & all[1]) != 0;
  }

  Sign compare_further(const Point3& from, const Point3& to, StageTally* tally);
  Sign turn_further(const Point3& m, const Point3& v, const Point3& a, const Point3& b, StageTally* tally);

  const WorldDirection& direction_;
  const Affine3& pose_;
  bool fast_;
  Vector3<Rounded<3>> rounded_{};  // meaningless unless fast_
  std::optional<Vector3<Interval>> interval_;
  std::optional<Vector3<Dyadic>> exact_;
};

// compare_along for what floating point does not decide.
Sign compare_along_further(const WorldDirection& direction, const Posed3& a, const Posed3& b, StageTally* tally);

// The sign of direction . (b - a) for posed points of any two bodies: positive when b is further along.
// First with one bound from the points' reach: the formula is a Rounded<7>, its magnitude at most the sum of the sizes
// of the direction's components times four times the sum of both reaches; another Rounded step pays for the rounding of
// that product.
inline Sign compare_along(const WorldDirection& direction, const Posed3& a, const Posed3& b,
                          StageTally* tally = nullptr) {
  if (direction.is_tame() && a.tame && b.tame) {
    const Point3& d = direction.doubles();
    const double value = dot(Vector3<double>{d.x, d.y, d.z}, rounded_image(b) - rounded_image(a));
    const double error =
        Rounded<12>::bound * ((std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z)) * (4 * (a.reach + b.reach)));
    if (value > error || value < -error)
      return counted(&StageTally::rounded, tally, value > 0 ? Sign::positive : Sign::negative);
    const Guess guess =
        sign(dot(lift<RoundedStage>(direction.doubles()), lift<RoundedStage>(b) - lift<RoundedStage>(a)));
    if (is_sure(guess)) return counted(&StageTally::rounded, tally, to_sign(guess));
  }
  return compare_along_further(direction, a, b, tally);
}

}  // namespace sunder
