// The area of a section, between two doubles.
#pragma once

#include <sunder/solid/section/polyhedron_plane_section.h>

namespace sunder::solid {

// low <= area <= high. high is infinite where the area is beyond the range of doubles.
struct AreaBounds {
  double low = 0, high = 0;
  double middle() const { return low + (high - low) / 2; }
};

// Of what is no polygon zero. The bounds of k corners are within k + 16 units in the last place, unless the area is
// below 2^-1000. Requires a section by the plane with this normal, and its points. Cost: linear, exact numbers for each
// corner.
AreaBounds section_area(const PlaneSection& section, const SectionPoints& points, const Point3& normal);

}  // namespace sunder::solid
