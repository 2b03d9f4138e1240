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

#include <sunder/predicate/posed.h>
#include <sunder/predicate/stages.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace sunder {

template <class T>
struct ShortestWay {
  std::uint8_t edges = 0;
  Vector3<T> way;           // from A to B, times a number: n where there are two edges, which may point from B to A
  T reach;                  // way r: positive; with two edges, n r, of either sign; zero where the flats meet, or
                            // where the edges do not span as much as there are of them
  T denominator;            // positive, or zero where they do not
  std::array<T, 4> weight;  // of the points of A, then of B, that make its ends, over the denominator; those of each
                            // sum to it

  // The square of the distance: what is over what.
  T squared() const { return edges == 2 ? reach * reach : reach; }
};

// The way r from the first point of A to that of B; the first `count` of both edges, of which `edges_of_a` are A's.
template <class T>
ShortestWay<T> shortest_way(const Vector3<T>& r, const std::array<Vector3<T>, 2>& e, std::uint8_t edges_of_a,
                            std::uint8_t edges) {
  ShortestWay<T> found;
  found.edges = edges;
  std::array<T, 2> along{T(0.0), T(0.0)};
  if (edges == 0) {
    found.way = r;
    found.denominator = T(1.0);
  } else if (edges == 1) {
    const Vector3<T>& f = e[0];
    const T square = dot(f, f);
    along[0] = dot(r, f);
    found.way = {r.x * square - f.x * along[0], r.y * square - f.y * along[0], r.z * square - f.z * along[0]};
    found.denominator = square;
  } else {
    found.way = cross(e[0], e[1]);
    found.denominator = dot(found.way, found.way);
    along = {dot(cross(r, e[1]), found.way), dot(cross(e[0], r), found.way)};
  }
  found.reach = dot(found.way, r);
  found.weight.fill(T(0.0));
  T rest_of_a = found.denominator, rest_of_b = found.denominator;
  std::size_t at = 1;
  for (std::size_t k = 0; k < edges; ++k) {
    if (k == edges_of_a) ++at;
    T& rest = k < edges_of_a ? rest_of_a : rest_of_b;
    rest = rest - along[k];
    found.weight[at++] = along[k];
  }
  found.weight[0] = rest_of_a;
  found.weight[edges_of_a + std::size_t{1}] = rest_of_b;
  return found;
}

// Between the exact images. Requires one point of each at least, four in all at most; those of one body have one pose.
template <class Stage>
auto shortest_way_of(std::span<const Posed3> a, std::span<const Posed3> b) {
  using T = decltype(Stage::read(0.0));
  const auto turned = [](const Posed3& from, const Posed3& to) {
    const auto d = lift<Stage>(to.point) - lift<Stage>(from.point);
    const auto row = [&](std::size_t i) {
      const auto& m = from.pose->linear;
      return (Stage::read(m[i]) * d.x + Stage::read(m[i + 1]) * d.y) + Stage::read(m[i + 2]) * d.z;
    };
    return Vector3<T>{row(0), row(3), row(6)};
  };
  std::array<Vector3<T>, 2> e;
  std::uint8_t edges = 0;
  for (const Posed3& p : a.subspan(1)) e[edges++] = turned(a[0], p);
  for (const Posed3& p : b.subspan(1)) e[edges++] = turned(p, b[0]);
  return shortest_way(Vector3<T>(lift<Stage>(b[0]) - lift<Stage>(a[0])), e, static_cast<std::uint8_t>(a.size() - 1),
                      edges);
}

// The same exactly, with the way from A to B and all weights not negative: so its ends are points of the hulls. Nothing
// where a weight is negative, the flats meet, or edges span too little.
std::optional<ShortestWay<Dyadic>> exact_way(std::span<const Posed3> a, std::span<const Posed3> b);

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
