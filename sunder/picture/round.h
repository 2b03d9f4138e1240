// What pictures draw for bodies with a radius.
#pragma once

#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/round/round_body.h>

namespace sunder::picture {

// A polyhedron inside of the body, of points on its surface, for the eye alone: nothing is decided by it. Where the
// radius is 0, the body itself. Within some hundredths of the radius of the body; in its own frame. Cost: of a rounded
// hull of n vertices the hull of 170 n points.
solid::ConvexPolyhedron drawn_as(const solid::RoundBody& body);

}  // namespace sunder::picture
