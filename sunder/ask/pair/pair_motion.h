// What questions of sunder pair about bodies that move share.
#pragma once

#include <sunder/ask/pair/pair_question.h>
#include <sunder/ask/pair/pair_space.h>

#include <sunder/number/interval.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/object/translation.h>

namespace sunder::ask {

// The motion that the call gives this body, from a pose on. Throws Error where the body would turn, or its end is given
// and it is a polygon in a frame.
solid::Translation motion_of(const solid::Pose& begin, const PlacedBody* body, const PairSide& side);

// Tells where the object goes, if it moves.
void tell_motion(const solid::Translation& motion, PairObject& object);

// When they first meet.
Fact told_first_time(const Interval& time);

}  // namespace sunder::ask
