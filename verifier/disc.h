// Discs as integers.
#pragma once

#include "statement_reader.h"

namespace sunder_verifier {

// All numbers are in one unit.
struct Disc {
  Integer x, y, r;
};

inline Integer square(const Integer& n) { return n * n; }

}  // namespace sunder_verifier
