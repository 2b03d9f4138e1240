// The search of Gilbert, Johnson and Keerthi on two placed bodies with a radius, in double or in double-double
// precision. Of hulls it sees the cores, of curved bodies what they are; `reach` is what the radii of hulls add. What
// it leaves is for proposals; nothing here decides anything. Source: Gilbert, Johnson, Keerthi 1988.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/solid/round/round_body.h>
#include <sunder/solid/round/round_placed.h>
#include <sunder/solid/round/round_round.h>
#include <sunder/solid/search/gjk.h>
#include <sunder/solid/search/support.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
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

// Of a curved body, whose points are of no vertex.
inline constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

// One of the bodies, seen from an origin. Lengths are times the scale, a power of two.
template <class Real>
class RoundSide {
 public:
  using Vector = VectorOf<Real>;

  RoundSide(const PlacedRound& of, const Vector& shift, double scale)
      : of_(of), core_(of.core), shift_(shift), scale_(scale), radius_(of.radius() * scale) {
    const std::span<const Point3> ends = of.body.ends();
    if (ends.empty()) return;
    first_ = at(ends[0]);
    if (ends.size() == 1) return;
    second_ = at(ends[1]);
    axis_ = minus(second_, first_);
    if constexpr (std::is_same_v<Real, double>) axis_ = core_.turned<Real>(minus(ends[1], ends[0]), scale);
    length2_ = dot(axis_, axis_);
  }

  struct Far {
    Vector at;
    std::uint32_t vertex = no_vertex;  // of a hull's core
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
    if (of_.body.ends().size() == 1) return first_;
    if (!of_.body.is_curved()) return at(core_.graph.middle);
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

// The support of two placed bodies with a radius. Its vertices' `a` are slots.
template <class Real>
class RoundSupport {
 public:
  using Vector = VectorOf<Real>;
  using Vertex = DifferenceVertexOf<Real>;

  // A point of the difference A - B, and the points whose difference it is.
  struct Slot {
    Vector of_a{}, of_b{};
    std::uint32_t vertex_a = no_vertex, vertex_b = no_vertex;
  };

  RoundSupport(const PlacedRound& a, const PlacedRound& b)
      : scale(scale_to_one(std::max(size_of(a), size_of(b)))),
        a_(a, Vector{}, scale),
        b_(b, shift_of(a, b, scale), scale),
        origin_{a.core.pose.translation[0], a.core.pose.translation[1], a.core.pose.translation[2]} {
    reach = a.body.rounding() * scale + b.body.rounding() * scale;
    can_shrink = a.body.is_curved() || b.body.is_curved();
  }

  double scale;
  std::array<Slot, 5> slots;
  Real reach = 0;           // what the radii of hulls add
  bool can_shrink = false;  // one of them is curved

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

  // Into a slot that no vertex of the simplex uses.
  Vertex furthest(const Vector& direction, const DifferenceSimplexOf<Real>& simplex, Cost& cost) {
    const std::uint32_t free = free_slot(simplex);
    const auto p = a_.furthest(direction, cost);
    const auto q = b_.furthest(negated(direction), cost);
    slots[free] = {p.at, q.at, p.vertex, q.vertex};
    return {minus(p.at, q.at), free, free};
  }

  static bool are_same(const Vertex& v, const Vertex& w) {
    return v.at.x == w.at.x && v.at.y == w.at.y && v.at.z == w.at.z;
  }
  Real noise(const Vector& d, const Vertex& w) const {
    const Slot& s = slots[w.a];
    const auto size = [](const Vector& p) { return magnitude(p.x) + magnitude(p.y) + magnitude(p.z); };
    const Real largest = std::max(nearest(size(s.of_a)), nearest(size(s.of_b)));
    return Real(relative_noise) * largest * (magnitude(d.x) + magnitude(d.y) + magnitude(d.z));
  }
  static Real noise2(const Vertex&) { return 0; }
  static bool is_coarse() { return false; }
  static void refine() {}

  // A point of the search in the world, in doubles.
  Point3 in_world(const Vector& p) const {
    return {origin_.x + nearest(p.x) / scale, origin_.y + nearest(p.y) / scale, origin_.z + nearest(p.z) / scale};
  }

  // The same without rounding; nothing where that is out of the range of numbers.
  std::optional<ExactPoint3> exactly_in_world(const Vector& p) const {
    const double by = 1 / scale;  // a power of two
    if (!(by >= std::numeric_limits<double>::min() && by <= std::numeric_limits<double>::max())) return std::nullopt;
    const auto number = [&](double origin, const DoubleDouble& x) {
      return Dyadic(origin) + (Dyadic(x.high) + Dyadic(x.low)) * Dyadic(by);
    };
    if (!std::isfinite(nearest(p.x) + nearest(p.y) + nearest(p.z))) return std::nullopt;
    return ExactPoint3{number(origin_.x, p.x), number(origin_.y, p.y), number(origin_.z, p.z)};
  }

  // Does the direction part what is seen of A and of B by more than that, and than rounding may be wrong?
  static bool exceeds(const Real& gap, const Real& least, const Vector& direction) {
    return gap > Real(0) && gap * gap > least * least * dot(direction, direction) * Real(1 + 16 * relative_noise);
  }

  static constexpr double relative_noise = std::is_same_v<Real, double> ? 0x1p-50 : 0x1p-100;

 private:
  static Vector shift_of(const PlacedRound& a, const PlacedRound& b, double scale) {
    const auto &s = a.core.pose.translation, &t = b.core.pose.translation;
    const auto part = [&](std::size_t i) -> Real { return difference<Real>(t[i], s[i]) * Real(scale); };
    return {part(0), part(1), part(2)};
  }

  RoundSide<Real> a_, b_;
  Point3 origin_;
};

template <class Real>
using RoundSearch = Gjk<Real, RoundSupport<Real>>;

template <class Real>
constexpr int round_steps = std::is_same_v<Real, double> ? 100 : 400;

// What the simplex of a search makes: the point of each body that its weights mean.
template <class Real>
struct Made {
  VectorOf<Real> of_a{}, of_b{};
  RoundCombination a, b;  // of hulls; else empty
};

inline void add_weight(RoundCombination& c, std::uint32_t v, double weight) {
  if (v == no_vertex) return;
  const std::size_t count = c.count();
  for (std::size_t k = 0; k < count; ++k) {
    if (c.vertices[k] != v) continue;
    c.weights[k] += weight;
    return;
  }
  c.vertices[count] = v;
  c.weights[count] = weight;
}

template <class Real>
std::optional<Made<Real>> made_of(const RoundSearch<Real>& search) {
  const auto mean = mean_nearest(search.simplex);
  if (!mean) return std::nullopt;
  Made<Real> made;
  bool is_some = false;
  for (const auto& part : *mean) {
    const Real weight = part.weight / mean->total;
    const auto& slot = search.support.slots[part.a];
    made.of_a = round_detail::sum<Real>(made.of_a, weight, slot.of_a);
    made.of_b = round_detail::sum<Real>(made.of_b, weight, slot.of_b);
    const double w = nearest(weight);
    if (!(w > 0)) continue;
    is_some = true;
    add_weight(made.a, slot.vertex_a, w);
    add_weight(made.b, slot.vertex_b, w);
  }
  return is_some ? std::optional(made) : std::nullopt;
}

}  // namespace sunder::solid
