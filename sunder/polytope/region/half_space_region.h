// What is the common part of N half-spaces of R^d, 2 <= d <= 6: is it empty, bounded, unbounded, of which dimension,
// and how far does it reach along each coordinate? In the plane, with its sides in order:
// planar/region/half_plane_intersection.h. Also called: feasibility of linear inequalities; bounding box and affine
// hull of a polyhedron (H-polytope).
//
// The answer is exactly right for the doubles given, whatever the position, and stands by itself:
//   R1. check() accepts it.
//   R2. It does not depend on the compiler.
// None throws, but for want of memory.
// Source: Shamos & Hoey 1976, Theorem 11 in more than two variables; Freund, Roundy & Todd 1985 for the affine hull.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/polytope/pair/evidence.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace sunder::polytope {

enum class RegionKind : std::uint8_t { empty, bounded, unbounded };

std::string_view name_of(RegionKind);  // "bounded"

// What there is of a region that is not empty.
struct RegionExtent {
  // The dimension of the affine hull of the common points.
  std::size_t dimension = 0;
  // dimension + 1 common points, in no hyperplane of that hull.
  std::vector<ExactPointN> points{};
  // Positive multipliers of rows (a, b) whose sum is zero in all numbers, whose normals span all that is across that
  // hull: on these rows all common points lie. Of d dimensions there are none.
  Weights flat{};
  // The least and the greatest of each coordinate, where there are such: nearest doubles, infinite beyond their range.
  struct Range {
    std::optional<double> least{}, greatest{};
  };
  std::array<Range, most_dimension> ranges{};
};

// As of a linear program that is infeasible.
struct EmptyRegion {
  static constexpr RegionKind verdict = RegionKind::empty;
  Weights contradiction{};
};

// Positive multipliers of rows whose normals have the sum zero, and span R^d.
struct BoundedRegion : RegionExtent {
  static constexpr RegionKind verdict = RegionKind::bounded;
  Weights enclosing{};
};

// A direction in which no common point ever leaves.
struct UnboundedRegion : RegionExtent {
  static constexpr RegionKind verdict = RegionKind::unbounded;
  std::vector<Dyadic> direction{};
};

using HalfSpaceRegion =
    Answer<std::variant<EmptyRegion, BoundedRegion, UnboundedRegion>>;  // cost: as of linear programs

// Null where it is empty.
const RegionExtent* extent_of(const HalfSpaceRegion& region);

// By 2 d linear programs, for the least and the greatest coordinates; where the points found span less than R^d, by two
// more across them, until they span more, or prove to be in a hyperplane: at most 2 d times. Requires half-spaces.
// Cost: some 20 d^2 scans at most. Allocates.
HalfSpaceRegion half_space_region(const Polytope& half_spaces);

// Is the region what it says it is, by its evidence alone? Extents are not proved by it. Cost: linear, exact
// arithmetic.
bool check(const Polytope& half_spaces, const HalfSpaceRegion& region);

}  // namespace sunder::polytope
