// The hierarchies that the walk between two spaces (polar_walk.h) goes down: of P's vertices, and of R's facets as
// vertices of its polar. Plain ones with sectors, or bounded ones.
#pragma once

#include <sunder/number/sign.h>
#include <sunder/solid/descent/polar_frame.h>
#include <sunder/solid/represent/bounded_walk.h>
#include <sunder/solid/represent/hierarchy_walk.h>
#include <sunder/solid/represent/polar_hierarchy.h>
#include <sunder/solid/search/bounded_support.h>
#include <sunder/solid/search/caratheodory.h>
#include <sunder/solid/search/support.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace sunder::solid {

// What a walk down the polar's hierarchy asks about a point, taken as a direction.
template <class Real, class Tree>
class CompareFacets {
 public:
  using Vector = VectorOf<Real>;

  explicit CompareFacets(const PolarFrame<Real, Tree>& frame) : frame_(frame) {}
  void turn_to(const Vector& point) { point_ = point; }

  Sign operator()(std::uint32_t i, std::uint32_t j) const {
    return sign_of_rounded(dot(point_, frame_.polar_edge(i, j)));
  }
  Sign turn(std::uint32_t v, std::uint32_t i, std::uint32_t j) const {
    const Point3& m = frame_.polar().hierarchy.nodes[v].middle;
    const Vector middle{Real(m.x), Real(m.y), Real(m.z)}, a = frame_.polar_edge(v, i), b = frame_.polar_edge(v, j);
    return sign_of_rounded(dot(point_, a) * dot(middle, b) - dot(point_, b) * dot(middle, a));
  }

 private:
  const PolarFrame<Real, Tree>& frame_;
  Vector point_{};
};

// A hierarchy and a walk down it. Ranks are those of the hierarchy; the rim of one are its neighbours when it comes.
template <class Compare>
class SectorWalk {
 public:
  template <class Of>
  SectorWalk(const Of& of, const Hierarchy& hierarchy, std::uint64_t& probes)
      : compare(of), turn_{compare}, walk(hierarchy, compare, turn_, probes), hierarchy_(hierarchy) {}
  SectorWalk(const SectorWalk&) = delete;
  SectorWalk& operator=(const SectorWalk&) = delete;

  Compare compare;

 private:
  TurnBy<Compare> turn_;

 public:
  HierarchyWalk<Compare, TurnBy<Compare>> walk;

  const Hierarchy::Node& node(std::uint32_t rank) const { return hierarchy_.nodes[rank]; }
  std::uint32_t corners() const { return hierarchy_.level_end.front(); }
  std::size_t rim_size(std::uint32_t rank) const { return node(rank).star().size(); }
  std::uint32_t rim(std::uint32_t rank, std::size_t k) const { return node(rank).star()[k].a; }
  Point3 rest(std::uint32_t) const { return {}; }
  template <class Real>
  void add_to(Mixture<Real>& mixture, std::uint32_t rank, const Real& part) const {
    mixture.add(node(rank).vertex, part);
  }
  std::size_t level_of(std::uint32_t rank) const {  // below the top
    const auto& ends = hierarchy_.level_end;
    return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), rank) - ends.begin());
  }

 private:
  const Hierarchy& hierarchy_;
};

template <class Compare>
class BoundedTreeWalk {
 public:
  template <class Of>
  BoundedTreeWalk(const Of& of, const BoundedHierarchy& hierarchy, std::uint64_t& probes)
      : compare(of), walk(hierarchy, compare, probes), hierarchy_(hierarchy) {}
  BoundedTreeWalk(const BoundedTreeWalk&) = delete;
  BoundedTreeWalk& operator=(const BoundedTreeWalk&) = delete;

  Compare compare;
  BoundedWalk<Compare> walk;

  const BoundedHierarchy::Node& node(std::uint32_t rank) const { return hierarchy_.nodes[rank]; }
  std::uint32_t corners() const { return hierarchy_.levels.front().end; }
  std::size_t rim_size(std::uint32_t rank) const { return hierarchy_.rim_of(rank).size(); }
  std::uint32_t rim(std::uint32_t rank, std::size_t k) const { return hierarchy_.rim_of(rank)[k]; }
  Point3 rest(std::uint32_t rank) const {
    return node(rank).copy == BoundedHierarchy::none ? Point3{} : hierarchy_.copies[node(rank).copy].rest;
  }
  // A cut point is a mean of both ends of its line. One of cut points is taken for the vertex that they were cut from.
  template <class Real>
  void add_to(Mixture<Real>& mixture, std::uint32_t rank, const Real& part) const {
    if (node(rank).copy == BoundedHierarchy::none) {
      mixture.add(node(rank).vertex, part);
      return;
    }
    const BoundedHierarchy::Copy& copy = hierarchy_.copies[node(rank).copy];
    const Real of_end = part * Real(copy.share);
    mixture.add(node(copy.parent).vertex, part - of_end);
    mixture.add(node(copy.toward).vertex, of_end);
  }
  std::size_t level_of(std::uint32_t rank) const {
    const auto& levels = hierarchy_.levels;
    const auto is_below = [](std::uint32_t r, const BoundedHierarchy::Level& level) { return r < level.end; };
    return static_cast<std::size_t>(std::upper_bound(levels.begin(), levels.end(), rank, is_below) - levels.begin());
  }

 private:
  const BoundedHierarchy& hierarchy_;
};

// What PolarWalk takes.
struct SectorTrees {
  using Polar = PolarHierarchy;
  template <class Real>
  using Vertices = SectorWalk<CompareAlong<Real>>;
  template <class Real>
  using Facets = SectorWalk<CompareFacets<Real, Polar>>;
  static const Hierarchy& of(const ConvexPolyhedron& body) { return represent::of<Hierarchy>(body); }
};
struct BoundedTrees {
  using Polar = BoundedPolarHierarchy;
  template <class Real>
  using Vertices = BoundedTreeWalk<CompareBounded<Real>>;
  template <class Real>
  using Facets = BoundedTreeWalk<CompareFacets<Real, Polar>>;
  static const BoundedHierarchy& of(const ConvexPolyhedron& body) { return represent::of<BoundedHierarchy>(body); }
};

}  // namespace sunder::solid
