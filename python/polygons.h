// Polygons with holes, and sets of them that are fit for questions about sets.
#pragma once

#include <sunder/planar/object/polygon.h>
#include <sunder/planar/set/polygon_valid.h>

#include "common.h"

namespace sunder::python {

// Polygons that are valid, but that rings may touch themselves: what questions about sets of polygons require.
struct Polygons {
  std::vector<planar::Polygon> members;
  std::size_t size() const { return members.size(); }
};

void bind_polygons(nb::module_& planar);

planar::PolygonRule rule_of(std::string_view name);

// A list of rings, each an array of points; or a list of such. `place` says what it is in errors.
std::vector<planar::PolygonRings> parts_of(nb::handle given);
planar::PolygonRings rings_of(nb::handle given, const std::string& place);

}  // namespace sunder::python
