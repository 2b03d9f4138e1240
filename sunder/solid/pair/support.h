// A vertex of a convex polyhedron that is furthest along a direction, as far as a search in floating point tells.
// Also called: support point, support mapping. (The exact one: extreme_vertex.h.)
#pragma once

#include <sunder/base/contract.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/pair/search_vector.h>
#include <sunder/solid/represent/hierarchy_walk.h>
#include <sunder/solid/represent/search_graph_walk.h>

#include <cstdint>
#include <type_traits>

namespace sunder::solid {

// What a walk down a hierarchy asks about a direction, in floating point.
template <class Real>
struct CompareAlong {
  const Hierarchy& hierarchy;
  const VectorOf<Real>& direction;

  static Sign sign_of(const Real& x) {
    return x > Real(0) ? Sign::positive : Real(0) > x ? Sign::negative : Sign::zero;
  }
  VectorOf<Real> from_to(std::uint32_t i, std::uint32_t j) const {
    const Point3 &p = hierarchy.nodes[i].at, &q = hierarchy.nodes[j].at;
    return {difference<Real>(q.x, p.x), difference<Real>(q.y, p.y), difference<Real>(q.z, p.z)};
  }
  Sign operator()(std::uint32_t i, std::uint32_t j) const { return sign_of(dot(direction, from_to(i, j))); }
};
template <class Real>
struct TurnAlong {
  const CompareAlong<Real>& compare;

  Sign operator()(std::uint32_t v, std::uint32_t i, std::uint32_t j) const {
    const Point3& m = compare.hierarchy.nodes[v].middle;
    const VectorOf<Real> middle{m.x, m.y, m.z}, a = compare.from_to(v, i), b = compare.from_to(v, j);
    const VectorOf<Real>& d = compare.direction;
    return CompareAlong<Real>::sign_of(dot(d, a) * dot(middle, b) - dot(d, b) * dot(middle, a));
  }
};

// Down the hierarchy, to the furthest of the first `end` ranks. Requires three vertices or more. Cost: O(log n) probes.
template <class Real>
std::uint32_t support_by_hierarchy(const ConvexPolyhedron& body, const VectorOf<Real>& direction, std::uint64_t& probes,
                                   std::uint32_t end = Hierarchy::none) {
  const Hierarchy& hierarchy = body.hierarchy();
  const CompareAlong<Real> compare{hierarchy, direction};
  const TurnAlong<Real> turn{compare};
  return hierarchy.nodes[HierarchyWalk(hierarchy, compare, turn, probes).run(end)].vertex;
}

// `start` is search_start() of the body's graph. Cost: O(log n) probes, fewer where a walk from the table ends soon.
inline std::uint32_t support_from(const ConvexPolyhedron& body, const Point3& direction, std::uint32_t start,
                                  std::uint64_t& probes) {
  const SearchGraph& graph = body.search_graph();
  if (graph.padded != 0) return furthest_of_few(graph, direction, probes);
  if (graph.is_slow) return support_by_hierarchy<double>(body, direction, probes);
  const Walk end = walk(graph, direction, start, probes);
  return end.has_ended ? graph.block(end.place).vertex() : support_by_hierarchy<double>(body, direction, probes);
}

inline std::uint32_t support(const ConvexPolyhedron& body, const Point3& direction, std::uint64_t& probes) {
  return support_from(body, direction, search_start(body.search_graph(), direction), probes);
}

// From the one that doubles find to one that DoubleDouble finds.
inline std::uint32_t support_in_double_doubles(const ConvexPolyhedron& body, const Vector3<DoubleDouble>& direction,
                                               std::uint32_t from, std::uint64_t& probes) {
  const SearchGraph& graph = body.search_graph();
  VertexBlock block = graph.block(graph.place[from]);
  const Point3 origin = block.at();
  DoubleDouble greatest = 0;  // counted from there: a vertex has one value, and it grows strictly
  for (std::uint32_t step = 0; block.count() <= most_around && step <= most_steps; ++step) {
    std::uint32_t best = block.count();
    for (std::uint32_t j = 0; j < block.count(); ++j) {
      const DoubleDouble value = direction.x * exact_sum(block.x()[j], -origin.x) +
                                 direction.y * exact_sum(block.y()[j], -origin.y) +
                                 direction.z * exact_sum(block.z()[j], -origin.z);
      if (!(value > greatest)) continue;
      greatest = value;
      best = j;
    }
    probes += block.count();
    if (best == block.count()) return block.vertex();
    block = graph.block(block.place(best));
  }
  return support_by_hierarchy<DoubleDouble>(body, direction, probes);
}

}  // namespace sunder::solid
