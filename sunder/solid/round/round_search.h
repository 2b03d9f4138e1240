// The search of Gilbert, Johnson and Keerthi on two placed bodies with a radius, in double or in double-double
// precision. Of hulls it sees the cores, of curved bodies what they are; `reach` is what the radii of hulls add. What
// it leaves is for proposals; nothing here decides anything. Source: Gilbert, Johnson, Keerthi 1988.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/solid/pair/closest_simplex.h>
#include <sunder/solid/pair/support.h>
#include <sunder/solid/round/round_body.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace sunder::solid {

namespace round_detail {

inline double root_of(double x) { return std::sqrt(x); }
inline DoubleDouble root_of(const DoubleDouble& x) {
  if (!(x.high > 0)) return 0;
  const double first = std::sqrt(x.high);
  const DoubleDouble rest = x - exact_product(first, first);
  return exact_sum(first, rest.high / (2 * first));
}

template <class Real>
VectorOf<Real> sum(const VectorOf<Real>& p, const Real& by, const VectorOf<Real>& q) {
  return {p.x + by * q.x, p.y + by * q.y, p.z + by * q.z};
}

}  // namespace round_detail

// One of the bodies, seen from an origin. Lengths are times the scale, a power of two.
template <class Real>
class RoundSide {
 public:
  using Vector = VectorOf<Real>;

  RoundSide(const PlacedRound& of, const Vector& shift, double scale)
      : of_(of), core_(of.core), shift_(shift), scale_(scale), radius_(of.radius() * scale) {
    // Two points at most: of a hull its vertices, where there are no more.
    const std::vector<Point3>& vertices = of.core.graph.vertices;
    const bool is_hull = !of.body.is_curved();
    if (is_hull && vertices.size() > 2) return;
    const Point3& first = is_hull ? vertices[0] : of.shape.points[0];
    first_ = at(first);
    if (is_hull ? vertices.size() == 1 : of.shape.ends() == 1) return;
    const Point3& second = is_hull ? vertices[1] : of.shape.points[1];
    second_ = at(second);
    axis_ = minus(second_, first_);
    if constexpr (std::is_same_v<Real, double>) axis_ = core_.turned<Real>(minus(second, first), scale);
    length2_ = dot(axis_, axis_);
  }

  struct Far {
    Vector at;
    std::uint32_t vertex = 0;  // of a hull's core
  };

  double shrink = 0;  // of a curved body, towards its middle

  // The point that is furthest along the direction, about.
  Far furthest(const Vector& d, Cost& cost) const {
    Far far = furthest_of_all(d, cost);
    if (shrink > 0 && of_.body.is_curved())
      far.at = round_detail::sum<Real>(far.at, Real(shrink), minus(middle(), far.at));
    return far;
  }

  // Of the body: a point inside, about.
  Vector middle() const {
    if (!of_.body.is_curved()) return core_.graph.vertices.size() == 1 ? first_ : at(core_.graph.middle);
    if (of_.shape.ends() == 1) return first_;
    return round_detail::sum<Real>(first_, Real(of_.kind() == RoundKind::cone ? 0.25 : 0.5), axis_);
  }

 private:
  Far furthest_of_all(const Vector& d, Cost& cost) const {
    using round_detail::root_of, round_detail::sum;
    switch (of_.kind()) {
      case RoundKind::hull: {
        const std::vector<Point3>& vertices = core_.graph.vertices;
        if (vertices.size() <= 2) {
          cost.probes += vertices.size();
          if (vertices.size() == 1) return {first_, 0};
          return dot(d, axis_) > Real(0) ? Far{second_, 1} : Far{first_, 0};
        }
        const Vector e = core_.pulled(d);
        const Point3 f = rounded(e);
        std::uint32_t v = core_.graph.is_slow
                              ? support_by_hierarchy<double>(core_.body, f, cost.probes)
                              : support_from(core_.body, core_.graph, f, search_start(core_.graph, f), cost.probes);
        if constexpr (!std::is_same_v<Real, double>) {
          v = support_in_double_doubles(core_.body, e, v, cost.probes);
        }
        return {at(core_.graph.vertices[v]), v};
      }
      case RoundKind::ellipsoid: {
        // Of the map times the scale, so that no square of a length vanishes.
        Vector e = core_.pulled(d);
        e = {e.x * Real(scale_), e.y * Real(scale_), e.z * Real(scale_)};
        const Real length = root_of(dot(e, e));
        if (!(length > Real(0))) return {first_};
        const Real by = Real(of_.radius()) / length;
        const auto& m = core_.pose.linear;
        const auto row = [&](std::size_t i) {
          return by * (Real(m[i] * scale_) * e.x + Real(m[i + 1] * scale_) * e.y + Real(m[i + 2] * scale_) * e.z);
        };
        return {{first_.x + row(0), first_.y + row(3), first_.z + row(6)}};
      }
      case RoundKind::cylinder: {
        const Real along = dot(d, axis_);
        return {rim(along > Real(0) ? second_ : first_, d, along)};
      }
      case RoundKind::cone: {
        const Vector base = rim(first_, d, dot(d, axis_));
        return {dot(d, minus(second_, base)) > Real(0) ? second_ : base};
      }
    }
    return {first_};
  }

  Vector at(const Point3& p) const {
    const Vector turned = core_.turned<Real>(p, scale_);
    return {turned.x + shift_.x, turned.y + shift_.y, turned.z + shift_.z};
  }
  Vector rim(const Vector& centre, const Vector& d, const Real& along) const {
    using round_detail::root_of, round_detail::sum;
    // Once more, because of a direction nearly along the axis the rest carries the error of large numbers.
    Vector across = sum<Real>(d, -(along / length2_), axis_);
    across = sum<Real>(across, -(dot(across, axis_) / length2_), axis_);
    const Real length2 = dot(across, across);
    constexpr double noise = std::is_same_v<Real, double> ? 0x1p-50 : 0x1p-100;
    if (!(length2 > noise * noise * dot(d, d))) return centre;
    const Real length = root_of(length2);
    return sum<Real>(centre, radius_ / length, across);
  }

  const PlacedRound& of_;
  const Placed& core_;
  Vector shift_;
  double scale_;
  Real radius_;
  Vector first_{}, second_{}, axis_{};
  Real length2_ = 1;
};

template <class Real>
class RoundSearch {
 public:
  using Vector = VectorOf<Real>;

  // A point of the difference A - B, and the points whose difference it is.
  struct Slot {
    Vector of_a{}, of_b{};
    std::uint32_t vertex_a = 0, vertex_b = 0;
  };

  RoundSearch(const PlacedRound& a, const PlacedRound& b)
      : scale_(simplex.scale = scale_to_one(std::max(size_of(a), size_of(b)))),
        a_(a, Vector{}, scale_),
        b_(b, shift_of(a, b, scale_), scale_),
        origin_{a.core.pose.translation[0], a.core.pose.translation[1], a.core.pose.translation[2]} {
    const auto of_hull = [](const PlacedRound& p) { return p.body.is_curved() ? 0.0 : p.radius(); };
    reach = of_hull(a) * scale_ + of_hull(b) * scale_;
  }

  Vector first_direction() const {
    const Vector p = a_.middle(), q = b_.middle();
    const Vector d = minus(q, p);
    return dot(d, d) > Real(0) ? d : Vector{1, 0, 0};
  }

  // A point inside of one of them, about.
  Vector middle_of(bool of_a) const { return of_a ? a_.middle() : b_.middle(); }

  // From now on curved bodies are smaller about their middles, by this part.
  void shrink(double by) {
    a_.shrink = by;
    b_.shrink = by;
  }

  // The next point of the difference, into a slot that no vertex of the simplex uses.
  DifferenceVertexOf<Real> probe(Cost& cost) {
    std::uint32_t free = 0;
    const auto is_used = [&](std::uint32_t slot) {
      for (int i = 0; i < simplex.count; ++i) {
        if (simplex.vertex[static_cast<std::size_t>(i)].a == slot) return true;
      }
      return false;
    };
    while (is_used(free)) ++free;
    const auto p = a_.furthest(direction, cost);
    const auto q = b_.furthest(negated(direction), cost);
    slots[free] = {p.at, q.at, p.vertex, q.vertex};
    return {minus(p.at, q.at), free, free};
  }

  bool gains_by(const DifferenceVertexOf<Real>& w) const {
    if (simplex.count == 0) return true;
    for (int i = 0; i < simplex.count; ++i) {
      const Vector& v = simplex.vertex[static_cast<std::size_t>(i)].at;
      if (v.x == w.at.x && v.y == w.at.y && v.z == w.at.z) return false;
    }
    const Vector& d = direction;
    const Real gain = dot(d, minus(w.at, simplex.vertex[0].at));
    const Slot& s = slots[w.a];
    const auto size = [](const Vector& p) { return magnitude(p.x) + magnitude(p.y) + magnitude(p.z); };
    const Real largest = std::max(nearest(size(s.of_a)), nearest(size(s.of_b)));
    return gain > Real(noise) * largest * (magnitude(d.x) + magnitude(d.y) + magnitude(d.z));
  }

  // As GjkSearch::step_to.
  bool step_to(const DifferenceVertexOf<Real>& w) {
    simplex.vertex[static_cast<std::size_t>(simplex.count++)] = w;
    return reduce_to_closest_face(simplex, direction, distance2) && distance2 > Real(0);
  }

  // How far the direction parts A from B, times its length: at w, the last point.
  Real gap_at(const DifferenceVertexOf<Real>& w) const { return -dot(direction, w.at); }

  // A point of the search in the world, in doubles.
  Point3 in_world(const Vector& p) const {
    return {origin_.x + nearest(p.x) / scale_, origin_.y + nearest(p.y) / scale_, origin_.z + nearest(p.z) / scale_};
  }

  // The same without rounding; nothing where that is out of the range of numbers.
  std::optional<ExactPoint3> exactly_in_world(const Vector& p) const {
    const double by = 1 / scale_;  // a power of two
    if (!(by >= std::numeric_limits<double>::min() && by <= std::numeric_limits<double>::max())) return std::nullopt;
    const auto number = [&](double origin, const DoubleDouble& x) {
      return Dyadic(origin) + (Dyadic(x.high) + Dyadic(x.low)) * Dyadic(by);
    };
    if (!std::isfinite(nearest(p.x) + nearest(p.y) + nearest(p.z))) return std::nullopt;
    return ExactPoint3{number(origin_.x, p.x), number(origin_.y, p.y), number(origin_.z, p.z)};
  }

  static constexpr double noise = std::is_same_v<Real, double> ? 0x1p-50 : 0x1p-100;
  static constexpr int most_iterations = std::is_same_v<Real, double> ? 100 : 400;
  static constexpr int most_in_vain = std::is_same_v<Real, double> ? 4 : 20;  // iterations that come no nearer
  static constexpr int runs = std::is_same_v<Real, double> ? 1 : 3;           // of those that have shrunk

  // By which parts of their size curved bodies shrink, one after the other: by less no search sees.
  static constexpr auto shrinks = [] {
    if constexpr (std::is_same_v<Real, double>) {
      return std::array{0x1p-20};
    } else {
      return std::array{0x1p-42, 0x1p-56, 0x1p-70, 0x1p-84};
    }
  }();

  Vector direction{};                 // of the world, from A towards B
  DifferenceSimplexOf<Real> simplex;  // its vertices' `a` are slots
  std::array<Slot, 5> slots;
  Real distance2 = 0;  // of the simplex from the origin, squared, after a step
  Real reach = 0;

 private:
  static double size_of(const PlacedRound& p) {
    const double round = p.radius() * (p.kind() == RoundKind::ellipsoid ? 3 * greatest_of(p.pose) : 1);
    return std::max(p.core.size, round);
  }
  static double greatest_of(const Pose& pose) { return pose.linear_range().greatest; }
  static Vector shift_of(const PlacedRound& a, const PlacedRound& b, double scale) {
    const auto &s = a.core.pose.translation, &t = b.core.pose.translation;
    const auto part = [&](std::size_t i) -> Real { return difference<Real>(t[i], s[i]) * Real(scale); };
    return {part(0), part(1), part(2)};
  }

  double scale_;
  RoundSide<Real> a_, b_;
  Point3 origin_;
};

}  // namespace sunder::solid
