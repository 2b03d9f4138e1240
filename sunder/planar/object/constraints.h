// Half-planes of the plane, numbered: by linear constraints, or by arrows that have them on their left.
// Also called: linear inequalities; half-spaces of the plane; constraints of a linear program.
#pragma once

#include <sunder/base/error.h>
#include <sunder/planar/object/line.h>
#include <sunder/predicate/line/constraints.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

// The half-planes a x + b y <= c, numbered from 0. Immutable; any number of threads may use it.
// P1. All coefficients are finite, and a and b of each are not both zero.
class Constraints {
 public:
  using Half = Constraint;

  // Throws Error bad_value: "half-plane 7: ..." where a coefficient is not finite; bad_shape where a and b are zero,
  // and for 2^31 constraints or more.
  explicit Constraints(std::vector<Constraint> given);

  std::uint32_t size() const { return static_cast<std::uint32_t>(constraints_.size()); }
  const Constraint& operator[](std::uint32_t i) const { return constraints_[i]; }
  std::span<const Constraint> all() const { return constraints_; }

 private:
  std::vector<Constraint> constraints_;
};

// Half-planes to the left of arrows, numbered from 0: a view, the same as the constraints (b.y - a.y) x + (a.x - b.x) y
// <= a.x b.y - b.x a.y, whose coefficients doubles need not hold.
class HalfPlanes {
 public:
  using Half = LeftOf;

  // Requires half-planes as HalfPlane::left_of makes them, fewer than 2^31. Keeps a reference.
  explicit HalfPlanes(std::span<const HalfPlane> given) : given_(given) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(given_.size()); }
  LeftOf operator[](std::uint32_t i) const { return {given_[i].a, given_[i].b}; }

 private:
  std::span<const HalfPlane> given_;
};

}  // namespace sunder::planar
