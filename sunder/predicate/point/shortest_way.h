// The shortest way from the flat through a few points of A to the flat through a few points of B: one formula for
// searches and for exact decisions, and what filters tell of it.
//
// A flat is a point, a line or a plane; there are four points in all at most. From the first point of A to that of B
// leads r; along the edges e, the others of A less the first, and the first of B less the others, it may be shortened.
// The shortest way is what of r is perpendicular to all e, of which there are none to two:
//   none  r itself
//   one   r (e e) - e (r e), over e e
//   two   with n = e1 x e2: n (n r), over n n
// and each edge is gone along by its weight, over the same denominator.
#pragma once

#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/posed.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace sunder {

// The arrows between the points: r, and the first `edges` of e, of which `edges_of_a` are A's.
template <class T>
struct FlatArrows {
  Vector3<T> r;
  std::array<Vector3<T>, 2> e;
  std::uint8_t edges = 0, edges_of_a = 0;
};

template <class T>
struct ShortestWay {
  std::uint8_t edges = 0;
  Vector3<T> way;  // from A to B, times a number: n where there are two edges, which may point from B to A
  T reach;         // way r: positive; with two edges, of either sign; zero where the flats meet, or where the edges do
                   // not span as much as there are of them
  T denominator;   // positive, or zero where they do not

  // The square of the distance: what is over the denominator.
  T squared() const { return edges == 2 ? reach * reach : reach; }
};

template <class T>
ShortestWay<T> shortest_way(const FlatArrows<T>& of) {
  const auto& [r, e, edges, edges_of_a] = of;
  ShortestWay<T> found;
  found.edges = edges;
  if (edges == 0) {
    found.way = r;
    found.denominator = T(1.0);
  } else if (edges == 1) {
    const Vector3<T>& f = e[0];
    const T along = dot(r, f);
    found.denominator = dot(f, f);
    const auto part = [&](const T& x, const T& y) { return x * found.denominator - y * along; };
    found.way = {part(r.x, f.x), part(r.y, f.y), part(r.z, f.z)};
  } else {
    found.way = cross(e[0], e[1]);
    found.denominator = dot(found.way, found.way);
  }
  found.reach = dot(found.way, r);
  return found;
}

// The weights of the points of A, then of B, that make the ends of the way, over its denominator; those of each body
// sum to it.
template <class T>
std::array<T, 4> weights_of(const FlatArrows<T>& of, const ShortestWay<T>& found) {
  const auto& r = of.r;
  const auto& e = of.e;
  const std::size_t edges = of.edges, edges_of_a = of.edges_of_a;
  std::array<T, 2> along{T(0.0), T(0.0)};
  if (edges == 1) along[0] = dot(r, e[0]);
  if (edges == 2) along = {dot(cross(r, e[1]), found.way), dot(cross(e[0], r), found.way)};
  std::array<T, 4> weight{T(0.0), T(0.0), T(0.0), T(0.0)};
  const std::size_t first_of_b = edges_of_a + 1;
  weight[0] = weight[first_of_b] = found.denominator;
  for (std::size_t k = 0; k < edges; ++k) {
    const bool is_a = k < edges_of_a;
    T& rest = weight[is_a ? 0 : first_of_b];
    rest = rest - along[k];
    weight[is_a ? k + 1 : k + 2] = along[k];
  }
  return weight;
}

// Between the exact images. Requires one point of each at least, four in all at most; those of one body have one pose.
template <class T>
FlatArrows<T> flat_arrows(std::span<const Posed3> a, std::span<const Posed3> b) {
  const auto turned = [](const Posed3& from, const Posed3& to) {
    const Vector3<T> d = coordinates<T>(to.point) - coordinates<T>(from.point);
    const auto row = [&](std::size_t i) {
      const auto& m = from.pose->linear;
      return (T(m[i]) * d.x + T(m[i + 1]) * d.y) + T(m[i + 2]) * d.z;
    };
    return Vector3<T>{row(0), row(3), row(6)};
  };
  FlatArrows<T> arrows;
  arrows.r = coordinates<T>(b[0]) - coordinates<T>(a[0]);
  for (const Posed3& p : a.subspan(1)) arrows.e[arrows.edges++] = turned(a[0], p);
  arrows.edges_of_a = arrows.edges;
  for (const Posed3& p : b.subspan(1)) arrows.e[arrows.edges++] = turned(p, b[0]);
  return arrows;
}

// The same exactly, with the way from A to B and all weights not negative: so its ends are points of the hulls. Nothing
// where a weight is negative, the flats meet, or edges span too little.
struct ExactWay {
  ShortestWay<Dyadic> way;
  std::array<Dyadic, 4> weight;
};
std::optional<ExactWay> exact_way(std::span<const Posed3> a, std::span<const Posed3> b);

// What intervals tell of it. positive: all weights are, and `way` encloses the way from A to B. negative: a weight is,
// so there is no exact_way. Else unsure.
struct EnclosedWay {
  Guess weights = Guess::unsure;
  Vector3<Interval> way;  // meaningless unless `weights` is positive
};
EnclosedWay enclosed_way(std::span<const Posed3> a, std::span<const Posed3> b);

// Compares points of a posed body along a direction that is enclosed. Never wrong, but not always sure.
class EnclosedAlong {
 public:
  EnclosedAlong(const Vector3<Interval>& direction, const Affine3& pose);

  bool surely_less_far(const Point3& from, const Point3& to) const { return difference(from, to).high < 0; }
  bool surely_further(const Point3& from, const Point3& to) const { return difference(from, to).low > 0; }

 private:
  Interval difference(const Point3& from, const Point3& to) const {
    return dot(pulled_, lift<IntervalStage>(to) - lift<IntervalStage>(from));
  }

  Vector3<Interval> pulled_;
};

}  // namespace sunder
