// What have a plane and a line, a ray, a segment or a point in common? In constant time.
// Also called: line-plane intersection, ray-plane intersection, segment-plane intersection.
//
// As line_line.h says. Of a segment, a ray or a line in the plane that is all of it.
// Source: CD87, Figure 1.
#pragma once

#include <sunder/solid/line/line_line.h>
#include <sunder/solid/object/line.h>
#include <sunder/solid/object/plane.h>

namespace sunder::solid {

// Exact; of the world. Cost: at most 13 signs.
FlatCommon plane_line(const Plane& plane, const Line& line);
FlatCommon plane_ray(const Plane& plane, const Ray& ray);
FlatCommon plane_segment(const Plane& plane, const Segment& segment);
FlatCommon plane_point(const Plane& plane, const Point3& point);

// Of any of these.
FlatCommon plane_linear(const Plane& plane, const Linear& linear);

}  // namespace sunder::solid
