// Exact numbers of polytopes as Python has them.
#pragma once

#include <sunder/polytope/pair/evidence.h>

#include "common.h"

#include <span>

namespace sunder::python {

nb::tuple fractions_of(std::span<const Dyadic> numbers, const Dyadic& denominator);
nb::dict weights_of(const Weights& weights);  // by rows

// Hulls, vertices, regions and linear programs, after what bind_polytopes() has.
void bind_hulls(nb::module_& polytope);

}  // namespace sunder::python
