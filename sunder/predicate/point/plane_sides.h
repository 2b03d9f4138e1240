// On which side of one plane are many points of one posed body? Parallel planes one after the other, too.
// Also called: half-space test; static filter.
//
// As side_of_plane (plane_side.h), whose signs these are, with the plane seen from the body's frame, once: a point
// costs a scalar product and a comparison while floating point decides, and a scalar product of exact numbers where
// none does.
#pragma once

#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/posed.h>

#include <optional>

namespace sunder {

// positive: the images of a, b, c turn counter-clockwise seen from where the normal points to; zero: seen from there
// they are on one line. Formula: normal . ((b - a) x (c - a)).
Sign turn_seen_from(const Point3& normal, const Posed3& a, const Posed3& b, const Posed3& c,
                    StageTally* tally = nullptr);

// The plane of the points x of the world with normal . (x - point) = offset.
class PlaneSides {
 public:
  // For points none of whose coordinates is larger than `coordinates` in size. images_tame: as decided by
  // images_are_tame for the body. Requires finite numbers, and a normal that is not zero. Keeps a reference to the
  // pose.
  PlaneSides(const Point3& normal, const Point3& point, const Affine3& pose, bool images_tame, double coordinates);

  // Requires a finite number. Zero until then.
  void set_offset(double offset);

  // positive: the image of p is above the plane, where the normal points to; zero: on it; negative: below.
  Sign operator()(const Point3& p, StageTally* tally = nullptr) {
    const double value = height(p);
    if (value > error_) return counted(&StageTally::rounded, tally, Sign::positive);
    if (value < -error_) return counted(&StageTally::rounded, tally, Sign::negative);
    return further(p, tally);
  }

  // How far above, times the length of the normal, times a power of two. Rounded: for searches; may be infinite or NaN.
  double height(const Point3& p) const { return (x_ * p.x + y_ * p.y + z_ * p.z) - level_; }

 private:
  template <class Number>
  struct Seen {  // from the body's frame: p is above where normal . p > level
    Vector3<Number> normal;
    Number level;
  };
  template <class Stage, class Number>
  Number seen_height(std::optional<Seen<Number>>& kept, const Point3& p) const;
  Sign further(const Point3& p, StageTally* tally);

  Point3 normal_, point_;
  double offset_ = 0;
  const Affine3& pose_;
  double coordinates_;
  bool may_be_fast_;
  Point3 scaled_;  // the normal times 2^-exponent_, exactly; meaningless unless may_be_fast_
  int exponent_ = 0;

  // In floating point, with one bound for all points; infinite where floating point may tell nothing.
  double x_ = 0, y_ = 0, z_ = 0, level_ = 0, error_ = 0;
  std::optional<Seen<Interval>> interval_;
  std::optional<Seen<Dyadic>> exact_;
};

}  // namespace sunder
