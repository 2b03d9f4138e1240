// How a body moves from one pose to another without a turn: straight, at constant speed, while time goes from 0 to 1.
#pragma once

#include <sunder/base/error.h>
#include <sunder/solid/object/pose.h>

namespace sunder::solid {

// Straight from pose to pose, without a turn.
class Translation {
 public:
  // Throws Error bad_pose where the linear parts differ in any number: then the body turns, or changes its size.
  Translation(const Pose& begin, const Pose& end);
  // At rest.
  explicit Translation(const Pose& at) : begin_(at), end_(at) {}

  const Pose& begin() const { return begin_; }
  const Pose& end() const { return end_; }
  bool rests() const { return begin_.affine() == end_.affine(); }

 private:
  Pose begin_, end_;
};

// Do the poses have one linear part, number by number?
bool is_translation(const Pose& begin, const Pose& end);

}  // namespace sunder::solid
