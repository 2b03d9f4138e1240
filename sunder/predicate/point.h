// Points, affine maps and boxes as plain numbers, of the plane (D = 2) and of space (D = 3). No invariant: objects
// check their coordinates when made.
// Also called: affine transformation; axis-aligned bounding box (AABB).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sunder {

template <std::size_t D>
struct Point;

template <>
struct Point<2> {
  double x = 0, y = 0;
  friend bool operator==(const Point&, const Point&) = default;
  double operator[](std::size_t k) const { return k == 0 ? x : y; }
  double& operator[](std::size_t k) { return k == 0 ? x : y; }
};

template <>
struct Point<3> {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Point&, const Point&) = default;
  double operator[](std::size_t k) const { return k == 0 ? x : k == 1 ? y : z; }
  double& operator[](std::size_t k) { return k == 0 ? x : k == 1 ? y : z; }
};

using Point2 = Point<2>;
using Point3 = Point<3>;

// The numbers of the identity, row by row.
template <std::size_t D>
constexpr std::array<double, D * D> identity_matrix() {
  std::array<double, D * D> result{};
  for (std::size_t k = 0; k < D; ++k) result[k * D + k] = 1;
  return result;
}

// The affine map x -> linear x + translation. The linear part is row by row: row i is linear[D i .. D i + D - 1].
// The numbers *are* the map: a predicate on posed points decides about the exact images, which need not be doubles.
template <std::size_t D>
struct Affine {
  std::array<double, D * D> linear = identity_matrix<D>();
  std::array<double, D> translation{};
  friend bool operator==(const Affine&, const Affine&) = default;
};

using Affine2 = Affine<2>;
using Affine3 = Affine<3>;

// A closed box, its sides along the axes: low[k] <= high[k].
template <std::size_t D>
struct Box {
  Point<D> low, high;
  friend bool operator==(const Box&, const Box&) = default;
};

// Is each low end finite, and not above its high end, which is finite?
template <std::size_t D>
bool is_box(const Box<D>& box) {
  for (std::size_t k = 0; k < D; ++k) {
    if (!std::isfinite(box.low[k]) || !std::isfinite(box.high[k]) || box.low[k] > box.high[k]) return false;
  }
  return true;
}

using Box2 = Box<2>;
using Box3 = Box<3>;

// Of a box, or of what derives from one.
template <class BoxLike>
inline constexpr std::size_t dimension_of =
    [] { return []<std::size_t D>(const Box<D>*) { return D; }(static_cast<const BoxLike*>(nullptr)); }();

// Have they a common point?
template <std::size_t D>
bool meet(const Box<D>& a, const Box<D>& b) {
  for (std::size_t k = 0; k < D; ++k) {
    if (a.low[k] > b.high[k] || b.low[k] > a.high[k]) return false;
  }
  return true;
}

template <std::size_t D>
bool holds(const Box<D>& outer, const Box<D>& inner) {
  for (std::size_t k = 0; k < D; ++k) {
    if (outer.low[k] > inner.low[k] || inner.high[k] > outer.high[k]) return false;
  }
  return true;
}

// The smallest box that holds both.
template <std::size_t D>
Box<D> hull(const Box<D>& a, const Box<D>& b) {
  Box<D> result;
  for (std::size_t k = 0; k < D; ++k) {
    result.low[k] = std::min(a.low[k], b.low[k]);
    result.high[k] = std::max(a.high[k], b.high[k]);
  }
  return result;
}

// What two boxes have in common. Requires that they meet.
template <std::size_t D>
Box<D> common_part(const Box<D>& a, const Box<D>& b) {
  Box<D> result;
  for (std::size_t k = 0; k < D; ++k) {
    result.low[k] = std::max(a.low[k], b.low[k]);
    result.high[k] = std::min(a.high[k], b.high[k]);
  }
  return result;
}

}  // namespace sunder
