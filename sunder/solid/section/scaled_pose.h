// The pose of a body between two frames that are scaled along their axes by powers of two: the one in which its drums
// see it (Drums::shrink), and one of the world in which the body is about one long along each axis. For searches.
#pragma once

#include <sunder/solid/search/placed.h>
#include <sunder/solid/section/section_search.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sunder::solid {

class ScaledPose {
 public:
  ScaledPose(const Affine3& pose, const Point3& shrink) : pose_(pose) {
    for (std::size_t i = 0; i < 3; ++i) {
      shrink_[i] = std::ilogb(shrink[i]);
      int greatest = std::numeric_limits<int>::min();
      for (std::size_t j = 0; j < 3; ++j) {
        const double m = pose.linear[3 * i + j];
        if (m != 0) greatest = std::max(greatest, std::ilogb(m) - std::ilogb(shrink[j]));
      }
      world_[i] = -greatest;
    }
  }

  // Into the scaled world of another body.
  ScaledPose(const Affine3& pose, const Point3& shrink, const ScaledPose& of_world)
      : pose_(pose), world_(of_world.world_) {
    for (std::size_t i = 0; i < 3; ++i) shrink_[i] = std::ilogb(shrink[i]);
  }

  // The linear part.
  double operator()(std::size_t i, std::size_t j) const {
    return std::ldexp(pose_.linear[3 * i + j], world_[i] - shrink_[j]);
  }

  // From one point of the world to another; from one to the image of a point of the body, or of one under another pose.
  template <class Real>
  VectorOf<Real> way(const Point3& from, const Point3& to) const {
    const auto part = [&](std::size_t i) { return difference<Real>(in_world(i, to[i]), in_world(i, from[i])); };
    return {part(0), part(1), part(2)};
  }
  template <class Real>
  VectorOf<Real> way_to_image(const Point3& from, const Point3& p) const {
    const auto part = [&](std::size_t i) -> Real {
      const auto term = [&](std::size_t j) { return product<Real>((*this)(i, j), std::ldexp(p[j], shrink_[j])); };
      return (term(0) + term(1)) +
             (term(2) + difference<Real>(in_world(i, pose_.translation[i]), in_world(i, from[i])));
    };
    return {part(0), part(1), part(2)};
  }

  template <class Real>
  VectorOf<Real> way_to_image(const Point3& from, const Affine3& pose, const Point3& p) const {
    const auto part = [&](std::size_t i) -> Real {
      const auto term = [&](std::size_t j) { return product<Real>(in_world(i, pose.linear[3 * i + j]), p[j]); };
      return (term(0) + term(1)) + (term(2) + difference<Real>(in_world(i, pose.translation[i]), in_world(i, from[i])));
    };
    return {part(0), part(1), part(2)};
  }

  // Of the drums' frame, what n measures in the world from a point to which `away` is the way to the drums' base.
  template <class Real>
  LinearForm<Real> form(const VectorOf<Real>& n, const VectorOf<Real>& away) const {
    const auto column = [&](std::size_t j) -> Real {
      return n.x * Real((*this)(0, j)) + n.y * Real((*this)(1, j)) + n.z * Real((*this)(2, j));
    };
    return {{column(0), column(1), column(2)}, n.x * away.x + n.y * away.y + n.z * away.z};
  }

  // A normal of the scaled world as one of the world: of any length.
  Point3 in_world_as_normal(const Point3& n) const {
    const int greatest = std::max({world_[0], world_[1], world_[2]});
    Point3 result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = std::ldexp(n[i], world_[i] - greatest);
    return result;
  }

  // Does the pose turn left into right?
  bool reflects() const {
    const auto row = [&](std::size_t i) { return Point3{(*this)(i, 0), (*this)(i, 1), (*this)(i, 2)}; };
    return dot(row(0), cross(row(1), row(2))) < 0;
  }

 private:
  double in_world(std::size_t i, double x) const { return std::ldexp(x, world_[i]); }

  const Affine3& pose_;
  std::array<int, 3> shrink_{}, world_{};
};

}  // namespace sunder::solid
