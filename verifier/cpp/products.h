// Which of two products is greater, exactly: what nearly all signs of the sweep are.
#pragma once

#include <verifier/cpp/numbers.h>

namespace sunder_verifier {

// -1, 0, +1 as a b is less than, equal to, greater than c d. Without memory for factors of up to 128 bits.
int compare_products(const Integer& a, const Integer& b, const Integer& c, const Integer& d);

}  // namespace sunder_verifier
