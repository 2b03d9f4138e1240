// What a search in floating point asks of a polytope of points under its pose.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/number/interval.h>
#include <sunder/polytope/object/polytope.h>
#include <sunder/polytope/object/pose.h>
#include <sunder/polytope/pair/candidate_rows.h>
#include <sunder/polytope/pair/nearest_search.h>
#include <sunder/polytope/represent/hierarchical_tree.h>
#include <sunder/predicate/filter/along_columns.h>

#include <array>
#include <cstdint>

namespace sunder::polytope {

using Vector = ColumnNumbers;

// A point of a body, and the product of its image with a direction of the world.
struct Support {
  std::uint32_t index = 0;
  BoundedProduct product;  // no product of the body is further than this, error included
};

// The point that is furthest along the direction (side 1), or least far (side -1), as floating point has it.
Support support(const Polytope& body, const Pose& pose, const Vector& direction, double side);

// The same of those points that are looked at, and without a bound.
FurthestPoint likely_support(CandidateRows& candidates, const Pose& pose, const Vector& direction, double side,
                             Cost& cost);

// The same by a walk down the tree of the body. After one to a leaf: is no point further, surely, but for the error
// below?
FurthestPoint likely_support(TreeWalk& walk, const Pose& pose, const Vector& direction, double side,
                             TreeWalk::Reach reach, Cost& cost);
bool is_sure(const TreeWalk& walk, const Pose& pose, const Vector& direction, double side, Cost& cost);

// A bound on the error of the products of support points.
double support_error(const Polytope& body, const Pose& pose, const Vector& direction);

// The image of a point: as floating point has it, and enclosed.
Vector rounded_image(const Polytope& body, const Pose& pose, std::uint32_t k);
std::array<Interval, most_dimension> enclosed_image(const Polytope& body, const Pose& pose, std::uint32_t k);

// The image of point i of A less that of point j of B, as floating point has it.
DifferencePoint rounded_difference(const Polytope& a, const Pose& pose_a, std::uint32_t i, const Polytope& b,
                                   const Pose& pose_b, std::uint32_t j);

}  // namespace sunder::polytope
