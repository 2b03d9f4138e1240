// A convex polyhedron in its place, as the methods of solid/pair work with it.
#pragma once

#include <sunder/predicate/posed.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/object/search_graph.h>
#include <sunder/solid/search/search_vector.h>

#include <cstdint>
#include <limits>

namespace sunder::solid {

// A body and its pose, made ready for exact predicates.
struct Placed {
  const ConvexPolyhedron& body;
  const SearchGraph& graph;
  const Affine3& pose;
  bool tame;    // images_are_tame (predicate/posed.h)
  double size;  // the reach of all its points (predicate/posed.h); infinite where it overflows
  // Whether exact searches go down the bounded hierarchy, where they go down one, or that with sectors
  // (extreme_vertex.h).
  bool by_bounded = false;

  Placed(const ConvexPolyhedron& of, const Pose& at)
      : body(of),
        graph(of.search_graph()),
        pose(at.affine()),
        tame(images_are_tame(at.linear_range(), at.translation_range(), graph.sizes)),
        size(std::max(at.linear_range().greatest * graph.sizes.greatest, at.translation_range().greatest)) {}

  // The same body elsewhere, for searches: nothing is said of what floating point can tell there.
  Placed(const Placed& of, const Affine3& at)
      : body(of.body),
        graph(of.graph),
        pose(at),
        tame(false),
        size(std::numeric_limits<double>::infinity()),
        by_bounded(of.by_bounded) {}

  Posed3 operator[](std::uint32_t v) const { return {graph.vertices[v], &pose, tame, size}; }

  bool turns_tame() const { return turns_are_tame(size_range(std::span<const double>(pose.linear)), graph.sizes); }

  // The image of a point of the body without the translation, times the scale, a power of two. Rounded: for searches.
  template <class Real = double>
  VectorOf<Real> turned(const Point3& p, double scale) const {
    const auto& m = pose.linear;
    const auto row = [&](std::size_t i) -> Real {
      return (product<Real>(m[i], p.x) + product<Real>(m[i + 1], p.y) + product<Real>(m[i + 2], p.z)) * Real(scale);
    };
    return {row(0), row(3), row(6)};
  }
  template <class Real = double>
  VectorOf<Real> turned(std::uint32_t v, double scale) const {
    return turned<Real>(graph.vertices[v], scale);
  }

  // A direction of the world as the body's own frame sees it: the transposed linear part times d. Rounded.
  template <class V>
  V pulled(const V& d) const {
    const auto& m = pose.linear;
    return {m[0] * d.x + m[3] * d.y + m[6] * d.z, m[1] * d.x + m[4] * d.y + m[7] * d.z,
            m[2] * d.x + m[5] * d.y + m[8] * d.z};
  }
};

}  // namespace sunder::solid
