// What a search in floating point asks of a polytope of points under its pose.
#pragma once

#include <sunder/number/interval.h>
#include <sunder/polytope/object/polytope.h>
#include <sunder/polytope/object/pose.h>
#include <sunder/predicate/along_columns.h>

#include <array>
#include <cstdint>

namespace sunder::polytope {

using Vector = ColumnNumbers;

// A point of a body, and the product of its image with a direction of the world.
struct Support {
  std::uint32_t index = 0;
  BoundedProduct product;  // no product of the body is further than this, error included
};

// The point that is furthest along the direction (side 1), or least far (side -1), as floating point has it. With
// `every`, of a sample (furthest_along); then the product bounds nothing.
Support support(const Polytope& body, const Pose& pose, const Vector& direction, double side, std::size_t every = 1);

// A search looks at samples first: at a quarter of what comes next, each time. The first such step, for a body of so
// many rows: 64 to 256 rows are looked at, or all where there are few.
std::size_t first_sample(const Polytope& body);

// The image of a point: as floating point has it, and enclosed.
Vector rounded_image(const Polytope& body, const Pose& pose, std::uint32_t k);
std::array<Interval, most_dimension> enclosed_image(const Polytope& body, const Pose& pose, std::uint32_t k);

}  // namespace sunder::polytope
