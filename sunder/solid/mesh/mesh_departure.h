// By how much does a mesh that is not convex depart from its hull?
// Also called: concavity, convexity defect.
#pragma once

#include <sunder/solid/mesh/mesh_convexity.h>
#include <sunder/solid/object/convex_polyhedron.h>

#include <optional>

namespace sunder::solid {

// For people: rounded to about five digits.
struct MeshDeparture {
  // How far the deepest point of an edge of the mesh is below the surface of the hull: the greatest distance that such
  // a point has from the nearest plane of a facet. 0 iff each edge lies on a facet, which is decided exactly.
  double depth = 0;
  bool at_least = false;  // the search was given up: an edge may be deeper

  // The volume of the hull, and that of what is in the hull but not in the mesh. Only where the mesh is closed, turned
  // the same way everywhere, and of flat faces; where it crosses itself, what it goes around twice counts twice.
  struct Volume {
    double hull = 0, missing = 0;
  };
  std::optional<Volume> volume;
};

// `hull` must be the hull of the mesh's vertices and of dimension 3, and the mesh have a polygon.
// What one might assume and does not hold: a point within a face may be deeper than all edges.
// Along an edge the distance from the nearest plane is concave, so it is greatest where few planes are equally near:
// these are found by cutting planes. Edges that cannot be deeper than the deepest so far are seen so by a few planes.
// Cost: in practice the edges, and the facets a few hundred times; where it would be more than 2^28 planes, it is given
// up. Coordinates whose differences overflow give infinity.
MeshDeparture mesh_departure(const MeshView& mesh, const ConvexPolyhedron& hull);

}  // namespace sunder::solid
