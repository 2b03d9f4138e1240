// Closed discs of the plane: circles with their insides. So nested ones have common points. Radius zero is a point.
// Also called: disks, circles, balls of the plane.
#pragma once

#include <sunder/base/error.h>
#include <sunder/near/member_list.h>
#include <sunder/predicate/disc/disc.h>

#include <vector>

namespace sunder::planar {

// P1. All numbers are finite, and no radius is negative. (Centre plus radius may lie beyond the doubles.)
class Discs : public MemberList<Disc> {
 public:
  // Throws Error bad_value: "circle 7: ..." where a number is not finite or a radius is negative; bad_shape for 2^31
  // circles or more.
  explicit Discs(std::vector<Disc> given);
};

}  // namespace sunder::planar
