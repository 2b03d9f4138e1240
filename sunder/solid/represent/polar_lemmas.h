// What Barba and Langerman 2015, section 3, say of polars, shown on one body and its polar: each statement at many
// points, planes and bodies that are made of these two, in exact arithmetic.
//
// P contains the origin here, so that the polar which does not, rho_inf(P), is empty; that of a moved P is not. The
// lemmas for all bodies and origins are tests: tests/solid/polar_property_test.cpp.
#pragma once

#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/polar_about.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace sunder::solid {

struct PolarLemma {
  std::string_view name;        // "Lemma 3.1"
  std::string_view says;        // in words, what was checked
  std::uint64_t checked = 0;    // exact signs and equalities
  std::uint64_t of = 0;         // things of which it was checked (points, planes, pairs)
  std::uint64_t there_are = 0;  // such things; the rest was passed over, in equal steps
  bool holds = true;
};

// Lemmas 3.1 to 3.6 and Theorem 3.7, in this order. Requires the polar of the body. Cost: O(n), and not much more than
// `most` exact signs for each.
std::vector<PolarLemma> polar_lemmas(const ConvexPolyhedron& body, const PolarAbout& polar,
                                     std::uint64_t most = 20'000);

}  // namespace sunder::solid
