// The affine hull of a point set, as points that span it. Internal to solid/hull.
#pragma once

#include <sunder/predicate/point.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sunder::solid {

// One to four affinely independent points with the affine hull of all, as indices; so the dimension is their number
// minus 1. The first two are the lexicographically lowest and highest, the others far away from those before where
// floating point can tell. Of equal points only the one with the lowest index occurs. Requires a point.
// Cost: O(n).
std::vector<std::uint32_t> affine_basis(std::span<const Point3> points);

// An axis along which the projections of a, b, c are not collinear (0: x, 1: y, 2: z); none when a, b, c are collinear.
std::optional<int> projection_axis(const Point3& a, const Point3& b, const Point3& c);

}  // namespace sunder::solid
