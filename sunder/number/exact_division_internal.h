// Division of integers that is known to leave no rest, as fraction-free elimination has it: the quotient's lowest words
// first, so that no quotient word is guessed, and half of the products are not made. Of long numbers several times as
// fast as division.
#pragma once

#include <sunder/number/integer_internal.h>

namespace sunder {

// x / by. Requires that this is whole, and by != 0.
// Source: Jebelean 1993, "An algorithm for exact division".
void divide_exactly(Integer& x, const Integer& by);

}  // namespace sunder
