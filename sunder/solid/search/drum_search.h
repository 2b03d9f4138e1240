// Searches in a stack of drums (represent/drums.h), in floating point: nothing here decides anything. Directions are
// those of the frame in which the drums see the body (Drums::shrink).
//
// A facet's outward normal is one direction at all heights, so the corner of a slice that is furthest along a level
// direction is on one lateral edge all through a drum: that between the two sides whose normals have the direction
// between them. So searches compare normals and vertices of the body, and no corner of a slice has to be made.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/planar/pair/edge_runs.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/search/search_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace sunder::solid {

// Normals normal_at(0 .. n - 1) go round an axis counter-clockwise, once: the first of them that is at or past d, begun
// with number 1; n counts as 0. Cost: log2 n + 2 normals.
template <class NormalAt>
std::uint32_t first_past(std::uint32_t n, const Point3& axis, const Point3& d, const NormalAt& normal_at) {
  if (n == 1) return 0;
  const auto turn = [&](const Point3& a, const Point3& b) { return dot(axis, cross(a, b)); };
  const Point3 first = normal_at(0);
  // At most half a turn past the first, and not opposite to it?
  const auto is_near = [&](const Point3& b) {
    const double left = turn(first, b);
    if (left != 0) return left > 0;
    return dot(cross(axis, first), cross(axis, b)) > 0;
  };
  const bool d_is_near = is_near(d);
  const auto is_past = [&](std::uint32_t k) {
    const Point3 m = normal_at(k);
    return is_near(m) == d_is_near ? turn(d, m) >= 0 : d_is_near;
  };
  return planar::first_where(1, n, is_past) % n;
}

class DrumSearch {
 public:
  // Keeps references to all of them. The steps of accesses to edges of drums are counted as probes.
  DrumSearch(const Drums& drums, std::span<const Point3> vertices, Cost& cost)
      : drums_(drums), vertices_(vertices), cost_(cost) {}

  const Drums& drums() const { return drums_; }
  const Point3& vertex(std::uint32_t v) const { return vertices_[v]; }

  const LateralEdge& edge(std::uint32_t drum, std::uint32_t k) const {
    cost_.probes += drums_.steps_of_access();
    return drums_.edge(drum, k);
  }

  // How high a vertex is, counted from vertex_of(0).
  template <class Real>
  Real height(std::uint32_t v) const {
    const Point3 &up = drums_.up(), &p = vertices_[v], &base = vertices_[drums_.vertex_of(0)], &by = drums_.shrink();
    return Real(up.x) * (difference<Real>(p.x, base.x) * Real(by.x)) +
           Real(up.y) * (difference<Real>(p.y, base.y) * Real(by.y)) +
           Real(up.z) * (difference<Real>(p.z, base.z) * Real(by.z));
  }

  // How far from an edge's lower vertex to its upper one a slice is: exactly 0 and 1 at their own.
  template <class Real>
  Real share_at(const LateralEdge& e, std::uint32_t slice) const {
    if (slice <= e.begin) return 0;
    if (slice >= e.end) return 1;
    const Real low = height<Real>(e.low);
    return (height<Real>(drums_.vertex_of(slice)) - low) / (height<Real>(e.high) - low);
  }

  // A normal of the world, as the drums see it under the body's pose, its greatest component about 1. Numbers whose
  // sizes are far apart keep what counts.
  template <class Real>
  VectorOf<Real> pulled(const Affine3& pose, const Point3& normal) const {
    std::array<int, 9> exponents;
    int greatest = std::numeric_limits<int>::min();
    for (std::size_t i = 0; i < 9; ++i) {
      const double m = pose.linear[i], n = normal[i / 3];
      exponents[i] = m == 0 || n == 0 ? std::numeric_limits<int>::min() / 4
                                      : std::ilogb(m) + std::ilogb(n) - std::ilogb(drums_.shrink()[i % 3]);
      greatest = std::max(greatest, exponents[i]);
    }
    const auto column = [&](std::size_t j) {
      const auto part = [&](std::size_t i) -> Real {
        const double m = pose.linear[i], n = normal[i / 3];
        if (exponents[i] < greatest - 1000) return 0;
        return product<Real>(std::ldexp(m, -std::ilogb(m)), std::ldexp(n, exponents[i] - greatest - std::ilogb(n)));
      };
      return part(j) + part(3 + j) + part(6 + j);
    };
    return {column(0), column(1), column(2)};
  }

  // The lateral edge whose corners are furthest along d among those of their slices: its number in the drum.
  // Cost: log2 of the drum's size + 2 accesses.
  std::uint32_t furthest_edge(std::uint32_t drum, const Point3& d) const {
    const std::uint32_t n = drums_.size(drum);
    return first_past(n, drums_.up(), d, [&](std::uint32_t k) { return drums_.normal(edge(drum, k).side); });
  }

  // The vertex furthest along d, which is not level: edges that are furthest in their drums rise along d up to the
  // slice where it is, and fall from there on. is_enough(v): may the search end with vertex v?
  // Cost: log2 of the number of drums + 2 times that of furthest_edge().
  template <class Real, class IsEnough>
  std::uint32_t furthest_vertex(const VectorOf<Real>& d, const IsEnough& is_enough) const {
    const Point3 rounded_d = rounded(d);
    std::uint32_t best = drums_.vertex_of(0);
    const auto keep_better = [&](std::uint32_t v) {
      if (along<Real>(d, best, v) == Sign::positive) best = v;
      return is_enough(best);
    };
    std::uint32_t low = 0, high = drums_.drum_count();
    bool done = keep_better(drums_.vertex_of(high));
    while (low < high && !done) {
      ++cost_.iterations;
      const std::uint32_t middle = low + (high - low) / 2;
      const LateralEdge& e = edge(middle, furthest_edge(middle, rounded_d));
      const bool rises = along<Real>(d, e.low, e.high) == Sign::positive;
      done = keep_better(rises ? e.high : e.low);
      if (rises) {
        low = std::min(e.end, high);
      } else {
        high = std::max(e.begin, low);
      }
    }
    return best;
  }

 private:
  // Is w further along d than v?
  template <class Real>
  Sign along(const VectorOf<Real>& d, std::uint32_t v, std::uint32_t w) const {
    const Point3 &p = vertices_[v], &q = vertices_[w], &by = drums_.shrink();
    return sign_of_rounded(d.x * (difference<Real>(q.x, p.x) * Real(by.x)) +
                           d.y * (difference<Real>(q.y, p.y) * Real(by.y)) +
                           d.z * (difference<Real>(q.z, p.z) * Real(by.z)));
  }
  const Drums& drums_;
  std::span<const Point3> vertices_;
  Cost& cost_;
};

}  // namespace sunder::solid
