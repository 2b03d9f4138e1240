// What a walk down the bounded hierarchy of a polyhedron asks about a direction, in floating point.
#pragma once

#include <sunder/solid/represent/bounded_hierarchy.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/search/support.h>

#include <cstdint>
#include <type_traits>

namespace sunder::solid {

// As BoundedWalk's compare.
template <class Real>
class CompareBounded {
 public:
  using Vector = VectorOf<Real>;

  explicit CompareBounded(const ConvexPolyhedron& body)
      : hierarchy_(represent::of<BoundedHierarchy>(body)), direction_(body) {}

  void turn_to(const Vector& direction) { direction_.turn_to(direction); }

  // Is rank j further along than rank i?
  Sign operator()(std::uint32_t i, std::uint32_t j) const {
    const BoundedHierarchy::Node &p = hierarchy_.nodes[i], &q = hierarchy_.nodes[j];
    Vector way = direction_.from_to(p.at, q.at);
    if constexpr (!std::is_same_v<Real, double>) {
      if (p.copy != BoundedHierarchy::none || q.copy != BoundedHierarchy::none) {
        const Vector rest = direction_.from_to(rest_of(p), rest_of(q));
        way = {way.x + rest.x, way.y + rest.y, way.z + rest.z};
      }
    }
    return sign_of_rounded(dot(direction_.direction(), way));
  }

  const BoundedHierarchy& hierarchy() const { return hierarchy_; }

 private:
  Point3 rest_of(const BoundedHierarchy::Node& node) const {
    return node.copy == BoundedHierarchy::none ? Point3{} : hierarchy_.copies[node.copy].rest;
  }

  const BoundedHierarchy& hierarchy_;
  ScaledDirection<Real> direction_;
};

}  // namespace sunder::solid
