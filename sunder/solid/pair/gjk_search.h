// The state of Gilbert, Johnson and Keerthi's method on two placed bodies, whichever vertices it is given, and what
// becomes of it. Nothing here decides anything.
#pragma once

#include <sunder/predicate/along.h>
#include <sunder/solid/pair/closest_simplex.h>
#include <sunder/solid/pair/placed.h>
#include <sunder/solid/pair/proposal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace sunder::solid {

inline constexpr int most_iterations = 100;

template <class Real>
class GjkSearch {
 public:
  using Vector = VectorOf<Real>;
  using Vertex = DifferenceVertexOf<Real>;

  GjkSearch(const Placed& a, const Placed& b) : a_(a), b_(b) {
    const auto& s = a.pose.translation;
    const auto& t = b.pose.translation;
    const double scale = simplex.scale = scale_of(std::max(a.size, b.size));
    const auto shift = [&](std::size_t i) -> Real { return difference<Real>(t[i], s[i]) * Real(scale); };
    shift_ = {shift(0), shift(1), shift(2)};
  }

  // Between the middles of the bodies.
  Vector first_direction() const {
    const Vector p = a_.turned<Real>(a_.graph.middle, simplex.scale),
                 q = b_.turned<Real>(b_.graph.middle, simplex.scale);
    const Vector d{(q.x - p.x) + shift_.x, (q.y - p.y) + shift_.y, (q.z - p.z) + shift_.z};
    return dot(d, d) > 0 ? d : Vector{1, 0, 0};
  }

  // Of a vertex of A and one of B.
  Vertex difference_of(std::uint32_t a, std::uint32_t b) const {
    const Vector p = a_.turned<Real>(a, simplex.scale), q = b_.turned<Real>(b, simplex.scale);
    return {{(p.x - q.x) - shift_.x, (p.y - q.y) - shift_.y, (p.z - q.z) - shift_.z}, a, b};
  }

  // Is w further along the direction than the face, by more than the noise of floating point?
  bool gains_by(const Vertex& w) const {
    if (simplex.count == 0) return true;
    bool is_there = false;  // without branches: how many vertices there are is hard to predict
    for (int i = 0; i < 4; ++i) {
      const Vertex& v = simplex.vertex[static_cast<std::size_t>(i)];
      is_there |= (i < simplex.count) & (v.a == w.a) & (v.b == w.b);
    }
    if (is_there) return false;
    const Vector& d = direction;
    const Real gain = dot(d, minus(w.at, simplex.vertex[0].at));
    return gain > 4 * noise * (magnitude(d.x * w.at.x) + magnitude(d.y * w.at.y) + magnitude(d.z * w.at.z));
  }

  // One step: w joins the simplex, which becomes its face nearest to the origin. False where that is no use: the origin
  // is inside, or as near as floating point can tell.
  bool step_to(const Vertex& w) {
    simplex.vertex[static_cast<std::size_t>(simplex.count++)] = w;
    Real distance2 = 0;
    if (!reduce_to_closest_face(simplex, direction, distance2)) return false;
    if (simplex.count != 1) return distance2 > 0;
    const Vector p = a_.turned<Real>(simplex.vertex[0].a, simplex.scale),
                 q = b_.turned<Real>(simplex.vertex[0].b, simplex.scale);
    return distance2 > noise * noise * (dot(p, p) + dot(q, q));
  }

  Vector direction;                   // of the world, from A towards B
  DifferenceSimplexOf<Real> simplex;  // the face nearest to the origin, or the tetrahedron around it

 protected:
  const Placed& a_;
  const Placed& b_;

 private:
  // What rounding leaves of a difference of two images, as part of their size: some roundings.
  static constexpr double noise = std::is_same_v<Real, double> ? 0x1p-46 : 0x1p-98;

  // A power of two that brings differences of images near 1 where sixth powers of them could overflow or vanish, as
  // they occur in closest_simplex.cpp; else 1.
  static double scale_of(double size) {
    if (size >= 0x1p-100 && size <= 0x1p100) return 1;
    if (!(size > 0 && size <= std::numeric_limits<double>::max())) return 1;
    return std::ldexp(1.0, std::clamp(-std::ilogb(size), -1022, 1022));
  }

  Vector shift_;
};

// The direction as a certificate can hold it: tame, and with one vertex of the difference clearly furthest.
//
// Near contact the direction is perpendicular to a face of the difference, whose vertices then tie. So it is turned a
// little towards one of them, at the cost of at most a quarter of the gap, and floating point can tell the extreme
// vertices. `w` is what the direction found; it becomes the vertex that is now furthest. Returns false for a direction
// that is zero or not finite.
inline bool settle(const DifferenceSimplex& simplex, Point3& d, DifferenceVertex& w) {
  if (!make_tame(d)) return false;
  const std::size_t n = static_cast<std::size_t>(simplex.count);
  if (n < 2) return true;
  Point3 centroid;
  for (std::size_t i = 0; i < n; ++i) {
    const Point3& p = simplex.vertex[i].at;
    centroid = {centroid.x + p.x, centroid.y + p.y, centroid.z + p.z};
  }
  const double part = 1.0 / simplex.count;
  centroid = {centroid.x * part, centroid.y * part, centroid.z * part};
  const auto from_centroid = [&](const Point3& p) {
    return Point3{p.x - centroid.x, p.y - centroid.y, p.z - centroid.z};
  };
  // A vertex clearly beyond the face is furthest anyway.
  const double gap = -dot(d, w.at);
  const Point3 beyond = from_centroid(w.at);
  const double height = dot(d, beyond);
  if (height * height > 0x1p-40 * dot(beyond, beyond)) return true;
  // Else the vertex of the face that is furthest from the centroid.
  Point3 e;
  double length2 = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 f = from_centroid(simplex.vertex[i].at);
    if (dot(f, f) <= length2) continue;
    length2 = dot(f, f);
    e = f;
    w = simplex.vertex[i];
  }
  const double amount = std::min(0x1p-7 / std::sqrt(length2), 0.25 * gap / std::fabs(dot(e, w.at)));
  d = {d.x + amount * e.x, d.y + amount * e.y, d.z + amount * e.z};
  return make_tame(d);
}

// The axes of the world stretched, each by a power of two, so that two bodies have about the same size along all. Needles
// are searched so; whatever is lost, the exact checks are about the bodies as they are.
class Stretched {
 public:
  Stretched(const Placed& a, const Placed& b) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double size = std::max(size_along(a, i), size_along(b, i));
      if (!(size > 0 && size <= std::numeric_limits<double>::max())) continue;
      size_[i] = size;
      least_ = std::min(least_, size);
      greatest_ = std::max(greatest_, size);
    }
  }

  // Would floating point not see along one axis what there is, for what there is along another?
  bool is_wanted() const { return greatest_ > least_ * 0x1p40; }

  // propose(a, b, holds): of the stretched bodies.
  template <class Holds, class Propose>
  bool propose(const Placed& a, const Placed& b, const Holds& holds, const Propose& propose) const {
    std::array<double, 3> by;
    for (std::size_t i = 0; i < 3; ++i) by[i] = std::ldexp(1.0, std::clamp(-std::ilogb(size_[i]), -1020, 1020));
    const auto stretched = [&](Affine3 pose) {
      for (std::size_t i = 0; i < 9; ++i) pose.linear[i] *= by[i / 3];
      for (std::size_t i = 0; i < 3; ++i) pose.translation[i] *= by[i];
      return pose;
    };
    const Affine3 pose_a = stretched(a.pose), pose_b = stretched(b.pose);
    // A direction is a linear form: d . (S x) is (S d) . x. Beside a form n of the world it only tells a sense.
    const auto of_world = [&](Proposal p) {
      Point3& d = p.direction;
      if (p.claim == Proposal::Claim::apart_along) {
        d = {d.x * by[0], d.y * by[1], d.z * by[2]};
      } else {
        d = {d.x / by[0], d.y / by[1], d.z / by[2]};
      }
      return holds(p);
    };
    return propose(Placed(a, pose_a), Placed(b, pose_b), of_world);
  }

 private:
  static double size_along(const Placed& body, std::size_t axis) {
    const Point3 &low = body.graph.low, &high = body.graph.high;
    const auto part = [&](std::size_t j, double from, double to) {
      return std::fabs(body.pose.linear[3 * axis + j]) * std::max(std::fabs(from), std::fabs(to));
    };
    return part(0, low.x, high.x) + part(1, low.y, high.y) + part(2, low.z, high.z);
  }

  std::array<double, 3> size_{1, 1, 1};
  double least_ = std::numeric_limits<double>::infinity(), greatest_ = 0;
};

}  // namespace sunder::solid
