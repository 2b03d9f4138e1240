// The vertex of a placed convex polyhedron that is furthest along a direction, exactly.
#pragma once

#include <sunder/predicate/along.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/object/search_graph.h>

#include <cstdint>

namespace sunder::solid {

// A body and its pose, made ready for exact predicates.
struct Placed {
  const SearchGraph& graph;
  const Affine3& pose;
  bool tame;
  double size;  // no coordinate of an image is larger than four times this; infinite where it overflows

  Placed(const ConvexPolyhedron& body, const Pose& at)
      : graph(body.search_graph()),
        pose(at.affine()),
        tame(images_are_tame(at.linear_range(), at.translation_range(), graph.sizes)),
        size(std::max(at.linear_range().greatest * graph.sizes.greatest, at.translation_range().greatest)) {}

  Posed operator[](std::uint32_t v) const { return {graph.vertices[v], &pose, tame, size}; }

  // The image of a vertex, or of a point, without the translation, times the scale, in floating point: for searches.
  Point3 turned(std::uint32_t v, double scale) const { return turned(graph.vertices[v], scale); }
  Point3 turned(const Point3& p, double scale) const {
    const auto& m = pose.linear;
    return {(m[0] * p.x + m[1] * p.y + m[2] * p.z) * scale, (m[3] * p.x + m[4] * p.y + m[5] * p.z) * scale,
            (m[6] * p.x + m[7] * p.y + m[8] * p.z) * scale};
  }
};

// Which end of a direction.
enum class End : std::int8_t { least = -1, greatest = 1 };

// Walks from `start` over the vertex graph, by exact comparisons, until no neighbour is further: for a convex body that
// vertex is extreme. `along` must be the direction seen from this body's frame. Where `start` is extreme already this
// is the relative check of a certificate, in floating point but for near-ties.
// Cost: the degrees of the vertices on the way.
std::uint32_t extreme_vertex_from(const Placed& body, Along& along, End end, std::uint32_t start, StageTally& tally);

}  // namespace sunder::solid
