// Where the search between two spaces works: the frame of the polar hierarchy of one body R (represent/
// polar_hierarchy.h), with the vertices of the other, P, mapped into it. Rounded: nothing here decides anything.
#pragma once

#include <sunder/solid/represent/of.h>
#include <sunder/solid/represent/polar_hierarchy.h>
#include <sunder/solid/search/placed.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace sunder::solid {

// The half-space n.y <= h.
template <class Real>
struct HalfSpace {
  VectorOf<Real> n;
  Real h;

  // What brings the numbers to a size of about 1, at most 1; of DoubleDouble a power of two, so that no entry of a game
  // is rounded by itself, and what cancels in a mixture of rows or columns still does, to the last bit.
  double scale() const {
    const Point3 m = rounded(n);
    return to_one(std::fabs(m.x) + std::fabs(m.y) + std::fabs(m.z) + std::fabs(nearest(h)));
  }
  static double scale_of(const VectorOf<Real>& y, double w) {
    const Point3 p = rounded(y);
    return to_one(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z), w}));
  }

  // How far a point is outside, of a direction (w = 0) how fast it goes there, with the product of both scales: between
  // -1 and 1.
  Real pay(const VectorOf<Real>& y, double w, double scales) const { return scaled(dot(n, y) - h * Real(w), scales); }
  Real pay(const VectorOf<Real>& y) const { return pay(y, 1, scale() * scale_of(y, 1)); }

 private:
  static double to_one(double size) {
    if (!(size >= 0x1p-1022 && size <= std::numeric_limits<double>::max())) return 1;
    if constexpr (std::is_same_v<Real, double>) {
      return 1 / size;
    } else {
      constexpr std::uint64_t exponent = 0x7ff0000000000000;
      return 0.5 / std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) & exponent);
    }
  }
};

// Tree: PolarHierarchy or BoundedPolarHierarchy.
template <class Real, class Tree>
class PolarFrame {
 public:
  using Vector = VectorOf<Real>;

  PolarFrame(const Placed& p, const Placed& r) : p_(p), r_(r), polar_(represent::of<Tree>(r.body)) {
    // N, from the frame of R to the world, with a scale that makes its numbers at most 1.
    const std::array<double, 3> to_one{polar_.to_one.x, polar_.to_one.y, polar_.to_one.z};
    const auto entry = [&](std::size_t i, std::size_t j) { return r.pose.linear[3 * i + j] / to_one[j]; };
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) size = std::max(size, std::fabs(entry(i, j)));
    }
    const bool is_usual = size > 0 && size <= std::numeric_limits<double>::max();
    const double scale = is_usual ? std::ldexp(1.0, std::clamp(-std::ilogb(size), -1020, 1020)) : 1;
    const auto column = [&](std::size_t j) {
      return Vector{Real(entry(0, j) * scale), Real(entry(1, j) * scale), Real(entry(2, j) * scale)};
    };
    const Vector a = column(0), b = column(1), c = column(2);
    inverse_ = {cross(b, c), cross(c, a), cross(a, b)};
    const Real to_unit = Real(1) / dot(a, inverse_[0]);
    for (Vector& row : inverse_) row = {row.x * to_unit, row.y * to_unit, row.z * to_unit};
    if (!polar_.to_round.is_identity) {  // its rows, mapped column by column
      const auto& [i, j, k] = inverse_;
      const Vector x = polar_.to_round(Vector{i.x, j.x, k.x}), y = polar_.to_round(Vector{i.y, j.y, k.y}),
                   z = polar_.to_round(Vector{i.z, j.z, k.z});
      inverse_ = {Vector{x.x, y.x, z.x}, Vector{x.y, y.y, z.y}, Vector{x.z, y.z, z.z}};
    }
    const auto& m = p.pose.linear;
    for (std::size_t j = 0; j < 3; ++j) {
      linear_[j] = into({Real(m[j] * scale), Real(m[3 + j] * scale), Real(m[6 + j] * scale)});
    }
    const auto shift = [&](std::size_t i) {
      return difference<Real>(p.pose.translation[i], r.pose.translation[i]) * Real(scale);
    };
    const Vector t = into({shift(0), shift(1), shift(2)}), o = middle();
    translation_ = {t.x - o.x, t.y - o.y, t.z - o.z};
  }

  const Tree& polar() const { return polar_; }

  // Of a point of P's own frame; and of an edge.
  Vector image(const Point3& x) const {
    const Vector y = turned({Real(x.x), Real(x.y), Real(x.z)});
    return {y.x + translation_.x, y.y + translation_.y, y.z + translation_.z};
  }
  Vector edge(const Point3& from, const Point3& to) const {
    return turned({difference<Real>(to.x, from.x), difference<Real>(to.y, from.y), difference<Real>(to.z, from.z)});
  }

  // A linear form of this frame, as P's own sees it, and as the world does, up to a factor.
  Vector seen_from_p(const Vector& d) const { return {dot(d, linear_[0]), dot(d, linear_[1]), dot(d, linear_[2])}; }
  Vector seen_from_world(const Vector& d) const {
    const auto& [i, j, k] = inverse_;
    return {d.x * i.x + d.y * j.x + d.z * k.x, d.x * i.y + d.y * j.y + d.z * k.y, d.x * i.z + d.y * j.z + d.z * k.z};
  }

  // From o to a vertex of R.
  Vector corner(std::uint32_t v) const {
    const Vector y = scaled_difference(v, polar_.base[0]), o = base_from_first();
    return {y.x - o.x, y.y - o.y, y.z - o.z};
  }

  // The facet of this rank, as a half-space.
  HalfSpace<Real> wall(std::uint32_t rank) const {
    const auto& node = polar_.hierarchy.nodes[rank];
    if constexpr (std::is_same_v<Real, double>) {
      return {node.at, 1};
    } else {
      if constexpr (std::is_same_v<Tree, BoundedPolarHierarchy>) {
        if (node.copy != BoundedHierarchy::none) {
          const Point3& rest = polar_.hierarchy.copies[node.copy].rest;
          return {{exact_sum(node.at.x, rest.x), exact_sum(node.at.y, rest.y), exact_sum(node.at.z, rest.z)}, 1};
        }
      }
      const auto facet = r_.body.facet(node.vertex);
      const std::size_t k = facet.size();
      const std::uint32_t u = facet[0], v = facet[k / 3], w = facet[2 * k / 3];
      const Vector n = cross(scaled_difference(v, u), scaled_difference(w, u));
      return {n, dot(n, corner(u))};
    }
  }

  // Of two facets as vertices of the polar: from one to the other, up to a factor.
  Vector polar_edge(std::uint32_t from, std::uint32_t to) const {
    if constexpr (std::is_same_v<Real, double>) {
      return minus(polar_.hierarchy.nodes[to].at, polar_.hierarchy.nodes[from].at);
    } else {
      const HalfSpace<Real> p = wall(from), q = wall(to);
      return {q.n.x * p.h - p.n.x * q.h, q.n.y * p.h - p.n.y * q.h, q.n.z * p.h - p.n.z * q.h};
    }
  }

 private:
  Vector into(const Vector& x) const { return {dot(inverse_[0], x), dot(inverse_[1], x), dot(inverse_[2], x)}; }
  Vector turned(const Vector& x) const {
    const auto& [i, j, k] = linear_;
    return {i.x * x.x + j.x * x.y + k.x * x.z, i.y * x.x + j.y * x.y + k.y * x.z, i.z * x.x + j.z * x.y + k.z * x.z};
  }
  Vector scaled_difference(std::uint32_t v, std::uint32_t from) const {
    const Point3 &p = r_.graph.vertices[v], &q = r_.graph.vertices[from];
    return polar_.to_round(Vector{difference<Real>(p.x, q.x) * Real(polar_.to_one.x),
                                  difference<Real>(p.y, q.y) * Real(polar_.to_one.y),
                                  difference<Real>(p.z, q.z) * Real(polar_.to_one.z)});
  }
  // From the first vertex of the base to o, and o.
  Vector base_from_first() const {
    Vector sum{Real(0), Real(0), Real(0)};
    for (std::size_t k = 1; k < 4; ++k) {
      const Vector e = scaled_difference(polar_.base[k], polar_.base[0]);
      sum = {sum.x + e.x, sum.y + e.y, sum.z + e.z};
    }
    return {sum.x * Real(0.25), sum.y * Real(0.25), sum.z * Real(0.25)};
  }
  Vector middle() const {
    const Point3& p = r_.graph.vertices[polar_.base[0]];
    const Vector e = base_from_first(),
                 first = polar_.to_round(
                     Vector{Real(p.x * polar_.to_one.x), Real(p.y * polar_.to_one.y), Real(p.z * polar_.to_one.z)});
    return {first.x + e.x, first.y + e.y, first.z + e.z};
  }

  const Placed& p_;
  const Placed& r_;
  const Tree& polar_;
  std::array<Vector, 3> inverse_, linear_;  // rows; columns
  Vector translation_;
};

}  // namespace sunder::solid
