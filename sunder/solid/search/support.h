// A vertex of a convex polyhedron that is furthest along a direction, as far as a search in floating point tells.
// Also called: support point, support mapping. (The exact one: extreme_vertex.h.)
#pragma once

#include <sunder/base/contract.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/search_graph_walk.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/hierarchy_walk.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/search/search_vector.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace sunder::solid {

// A direction beside a body, in floating point. Directions of any length and bodies of any size, along each axis, are
// brought near 1 where products of a walk could overflow or vanish.
template <class Real>
class ScaledDirection {
 public:
  using Vector = VectorOf<Real>;

  explicit ScaledDirection(const ConvexPolyhedron& body) {
    const Point3 &low = body.search_graph().low, &high = body.search_graph().high;
    to_one_ = {scale_to_one(high.x - low.x), scale_to_one(high.y - low.y), scale_to_one(high.z - low.z)};
  }

  void turn_to(const Vector& direction) { direction_ = form(direction); }
  const Vector& direction() const { return direction_; }

  // Beside a vector that is scaled. Always inlined: a call in each step takes a tenth more instructions.
  [[gnu::always_inline]] Vector form(const Vector& d) const {
    const Vector f{d.x * Real(1 / to_one_.x), d.y * Real(1 / to_one_.y), d.z * Real(1 / to_one_.z)};
    const Point3 size = rounded(f);
    const Real by(scale_to_one(std::max({std::fabs(size.x), std::fabs(size.y), std::fabs(size.z)})));
    return {f.x * by, f.y * by, f.z * by};
  }
  Vector from_to(const Point3& p, const Point3& q) const {
    return {difference<Real>(q.x, p.x) * Real(to_one_.x), difference<Real>(q.y, p.y) * Real(to_one_.y),
            difference<Real>(q.z, p.z) * Real(to_one_.z)};
  }

 private:
  Point3 to_one_;
  Vector direction_{};
};

// What a walk down a hierarchy asks about a direction, in floating point.
template <class Real>
class CompareAlong {
 public:
  using Vector = VectorOf<Real>;

  explicit CompareAlong(const ConvexPolyhedron& body) : hierarchy_(represent::of<Hierarchy>(body)), direction_(body) {}

  void turn_to(const Vector& direction) { direction_.turn_to(direction); }

  // Is rank j further along than rank i?
  Sign operator()(std::uint32_t i, std::uint32_t j) const {
    return sign_of_rounded(dot(direction_.direction(), from_to(i, j)));
  }

  // As HierarchyWalk's turn.
  Sign turn(std::uint32_t v, std::uint32_t i, std::uint32_t j) const {
    const Vector middle = middle_of(v), a = from_to(v, i), b = from_to(v, j), &d = direction_.direction();
    return sign_of_rounded(dot(d, a) * dot(middle, b) - dot(d, b) * dot(middle, a));
  }

  const Hierarchy& hierarchy() const { return hierarchy_; }

 private:
  Vector middle_of(std::uint32_t v) const {
    const Hierarchy::Node& node = hierarchy_.nodes[v];
    if constexpr (!std::is_same_v<Real, double>) {
      // The cone may be too narrow for doubles to point into it.
      if (!node.has_middle_in_doubles()) {
        return cross(from_to(v, node.middle_triangle[0]), from_to(v, node.middle_triangle[1]));
      }
    }
    return direction_.form({node.middle.x, node.middle.y, node.middle.z});
  }
  Vector from_to(std::uint32_t i, std::uint32_t j) const {
    return direction_.from_to(hierarchy_.nodes[i].at, hierarchy_.nodes[j].at);
  }

  const Hierarchy& hierarchy_;
  ScaledDirection<Real> direction_;
};

// The turn of what compares, as HierarchyWalk takes it.
template <class Compare>
struct TurnBy {
  const Compare& compare;

  Sign operator()(std::uint32_t v, std::uint32_t i, std::uint32_t j) const { return compare.turn(v, i, j); }
};

// Down the hierarchy, to the furthest of the first `end` ranks. Requires three vertices or more. Cost: O(log n) probes.
template <class Real>
std::uint32_t support_by_hierarchy(const ConvexPolyhedron& body, const VectorOf<Real>& direction, std::uint64_t& probes,
                                   std::uint32_t end = Hierarchy::none) {
  CompareAlong<Real> compare(body);
  compare.turn_to(direction);
  const TurnBy<CompareAlong<Real>> turn{compare};
  const Hierarchy& hierarchy = compare.hierarchy();
  return hierarchy.nodes[HierarchyWalk(hierarchy, compare, turn, probes).run(end)].vertex;
}

// `graph` is the body's, and `start` its search_start(). Cost: O(log n) probes, fewer where a walk from the table ends
// soon.
inline std::uint32_t support_from(const ConvexPolyhedron& body, const SearchGraph& graph, const Point3& direction,
                                  std::uint32_t start, std::uint64_t& probes) {
  if (graph.padded != 0) return furthest_of_few(graph, direction, probes);
  if (graph.is_slow) return support_by_hierarchy<double>(body, direction, probes);
  const Walk end = walk(graph, direction, start, probes);
  return end.has_ended ? graph.block(end.place).vertex() : support_by_hierarchy<double>(body, direction, probes);
}

inline std::uint32_t support(const ConvexPolyhedron& body, const Point3& direction, std::uint64_t& probes) {
  const SearchGraph& graph = body.search_graph();
  return support_from(body, graph, direction, search_start(graph, direction), probes);
}

// From `near` on, or from where the direction table says, whichever is further: where little has changed since `near`
// was furthest, or much. Where a walk does not end soon, or the graph is slow, a vertex on the way. Requires near <
// number of vertices.
inline std::uint32_t support_near(const SearchGraph& graph, const Point3& direction, std::uint32_t near,
                                  std::uint64_t& probes) {
  if (graph.padded != 0) return furthest_of_few(graph, direction, probes);
  if (graph.is_slow) return near;
  const std::uint32_t here = graph.place[near];
  if (walk(graph, direction, here, probes, 0).has_ended) return near;
  const std::uint32_t there = table_start(graph, direction);
  const bool is_far = dot(direction, graph.block(here).at()) < dot(direction, graph.block(there).at());
  return graph.block(walk(graph, direction, is_far ? there : here, probes).place).vertex();
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
