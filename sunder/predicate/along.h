// Comparisons along a direction of the world, exact, for points of posed bodies.
// Also called: comparison of dot products; which support point is further.
#pragma once

#include <sunder/base/lanes.h>
#include <sunder/predicate/posed.h>
#include <sunder/predicate/stages.h>

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

  // True for doubles with which floating point does not underflow: components zero or in [2^-60, 1].
  bool is_tame() const { return is_tame_; }

  Vector3<Interval> enclosure() const;  // up to a power of two
  Vector3<Dyadic> exact() const;        // the same power of two for all

 private:
  static bool tame(double x) {
    const double size = std::fabs(x);
    return size == 0 || (size >= 0x1p-60 && size <= 1);
  }

  Point3 doubles_;
  bool is_doubles_ = false;
  bool is_tame_ = false;
  std::optional<Vector3<Dyadic>> exact_;  // set unless is_doubles_
};

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

 private:
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
