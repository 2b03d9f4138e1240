// Points, segments, rays, lines and planes of space as bodies of a certificate (docs/claims.md, "Tables"), in exact
// numbers: points, and ways that go on for ever, so that what is said of one is said of the whole.
//
// None throws, but for want of memory.
#pragma once

#include <sunder/certificate/pair_claims.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/line/line_in_body.h>
#include <sunder/solid/object/line.h>
#include <sunder/solid/object/plane.h>

#include <array>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace sunder::solid {

using Exact3 = Vector3<Dyadic>;

// In the world.
using Flat = std::variant<Point3, Segment, Ray, Line, Plane>;

// For PairClaims::add_body.
struct FlatBody {
  std::vector<Point3> points;
  std::vector<Way3> ways;
};

// Of a plane with the normal (a, b, c) one point, and the six ways +-(-b, a, 0), +-(-c, 0, a), +-(0, -c, b), of which
// two are zero where two of a, b, c are. Nothing where no point of the plane was found whose coordinates are doubles: a
// plane that is given by a point always has one; of one that is given by an offset see exact_point_of.
std::optional<FlatBody> body_of(const Flat& flat);

// A point of the plane, exactly. That which the plane is given by, where the offset is zero. Else tried are points
// whose difference from that is along an axis, then along two axes, with small fractions: by the extended Euclidean
// algorithm on the normal's mantissas. Nothing where that finds none: then often there is none, as on the plane 3 x
// = 1.
std::optional<Point3> exact_point_of(const Plane& plane);

// The number that normal . x is on the plane.
Dyadic level(const Plane& plane);

// normal . (x - point) - offset, times the denominator: positive above the plane.
Dyadic height(const Plane& plane, const ExactPoint3& x);

// How the body makes a point of it. is_inside: with positive weights that span all of it. Requires a point of it, and
// where it is to be inside one of its relative interior.
Combination combination_of(const Flat& flat, const FlatBody& body, const ExactPoint3& x, bool is_inside);

}  // namespace sunder::solid
