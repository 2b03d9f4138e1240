// Few vertices of A and few of B: which of them make the points of the two hulls that are nearest to each other? In
// floating point for searches, where the outcome is a proposal; in exact numbers, where it is exact.
#pragma once

#include <sunder/number/double_double.h>
#include <sunder/number/dyadic.h>
#include <sunder/predicate/point/shortest_way.h>

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <utility>

namespace sunder::solid {

// Vertices of A and of B, four in all at most, one of each at least: hulls that hold the nearest points.
struct FeatureVertices {
  std::uint8_t count_a = 0, count_b = 0;
  std::array<std::uint32_t, 4> vertices{};  // count_a of A, and then count_b of B

  std::uint32_t of_a(std::size_t k) const { return vertices[k]; }
  std::uint32_t of_b(std::size_t k) const { return vertices[count_a + k]; }
};

// Different vertices of one body, up to four, with their images.
template <class T>
struct VertexSet {
  std::array<std::uint32_t, 4> vertex{};
  std::array<Vector3<T>, 4> at{};
  std::size_t count = 0;

  bool has(std::uint32_t v) const {
    for (std::size_t k = 0; k < count; ++k) {
      if (vertex[k] == v) return true;
    }
    return false;
  }
  void add(std::uint32_t v, const Vector3<T>& image) {
    vertex[count] = v;
    at[count++] = image;
  }
};

// Vertices that hold the nearest points, and how these lie.
template <class T>
struct ClosestWay {
  FeatureVertices features{};
  ShortestWay<T> way{};        // between the flats of the features
  std::array<T, 4> weights{};  // of the features, all positive, over the way's denominator
};

namespace closest_features_detail {

// Is it more than rounding may leave of zero? `size`: of what it was made of.
inline bool is_positive(double x, double size) { return x > 0x1p-88 * size; }
inline bool is_positive(const DoubleDouble& x, const DoubleDouble& size) { return x > 0x1p-192 * size; }
inline bool is_positive(const Dyadic& x, const Dyadic&) { return x.sign() == Sign::positive; }

// Is the one shorter than the other? In floating point by the way's own length: `reach` of a short one is a sum of long
// numbers that cancel.
template <class T>
bool is_shorter(const ShortestWay<T>& x, const ShortestWay<T>& y) {
  const auto square = [](const ShortestWay<T>& w) {
    return w.edges == 2 ? w.reach * w.reach / w.denominator : dot(w.way, w.way) / (w.denominator * w.denominator);
  };
  return square(x) < square(y);
}
template <>
inline bool is_shorter(const ShortestWay<Dyadic>& x, const ShortestWay<Dyadic>& y) {
  return (x.squared() * y.denominator - y.squared() * x.denominator).sign() == Sign::negative;
}

// The vertices of the subsets, bit by bit, where the shortest way between their flats has positive weights.
template <class T>
std::optional<ClosestWay<T>> way_between(const VertexSet<T>& a, unsigned of_a, const VertexSet<T>& b, unsigned of_b) {
  ClosestWay<T> found;
  FeatureVertices& named = found.features;
  FlatArrows<T> arrows;
  std::size_t n = 0;
  const auto each = [&](const VertexSet<T>& set, unsigned subset, auto edge) {
    const Vector3<T>* first = nullptr;
    for (std::size_t k = 0; k < set.count; ++k) {
      if ((subset >> k & 1) == 0) continue;
      named.vertices[n++] = set.vertex[k];
      if (first == nullptr) {
        first = &set.at[k];
      } else {
        arrows.e[arrows.edges++] = edge(*first, set.at[k]);
      }
    }
    return first;
  };
  const Vector3<T>* first_a = each(a, of_a, [](const auto& from, const auto& to) { return to - from; });
  named.count_a = static_cast<std::uint8_t>(n);
  arrows.edges_of_a = arrows.edges;
  const Vector3<T>* first_b = each(b, of_b, [](const auto& to, const auto& from) { return to - from; });
  named.count_b = static_cast<std::uint8_t>(n - named.count_a);
  arrows.r = *first_b - *first_a;
  found.way = shortest_way(arrows);
  const auto& e = arrows.e;
  const T size = arrows.edges == 2 ? dot(e[0], e[0]) * dot(e[1], e[1]) : found.way.denominator;
  if (!is_positive(found.way.denominator, size)) return std::nullopt;
  found.weights = weights_of(arrows, found.way);
  for (std::size_t k = 0; k < n; ++k) {
    if (!is_positive(found.weights[k], T(0.0))) return std::nullopt;
  }
  return found;
}

}  // namespace closest_features_detail

// The subsets whose hulls are as near to each other as those of all, with positive weights. Of exact numbers there are
// some always; in floating point there may be none. Requires one vertex of each. Of hulls whose insides meet they need
// not hold a common point.
// Why: the nearest points of the hulls are convex combinations of vertices; those of least number are affinely
// independent, and their flats' nearest points are these. With d the way, what of A is furthest along it and what of B
// is least far lie in two parallel planes; the weights satisfy two equations there and one sum each, so four do.
// Cost: at most 132 shortest ways, which are added to `ways`; one, where the first try is all vertices and does it.
template <class T>
std::optional<ClosestWay<T>> closest_way(const VertexSet<T>& a, const VertexSet<T>& b, std::uint32_t& ways) {
  using closest_features_detail::is_shorter, closest_features_detail::way_between;
  const unsigned all_a = (1U << a.count) - 1, all_b = (1U << b.count) - 1;
  if (a.count + b.count <= 4) {
    ++ways;
    if (std::optional<ClosestWay<T>> of_all = way_between(a, all_a, b, all_b)) return of_all;
  }
  std::optional<ClosestWay<T>> least;
  for (unsigned of_a = 1; of_a <= all_a; ++of_a) {
    for (unsigned of_b = 1; of_b <= all_b; ++of_b) {
      if (std::popcount(of_a) + std::popcount(of_b) > 4) continue;
      ++ways;
      std::optional<ClosestWay<T>> found = way_between(a, of_a, b, of_b);
      if (found && (!least || is_shorter(found->way, least->way))) least = std::move(found);
    }
  }
  return least;
}

// Their vertices; the first of each, where there are none.
template <class T>
FeatureVertices closest_features(const VertexSet<T>& a, const VertexSet<T>& b) {
  std::uint32_t ways = 0;
  const std::optional<ClosestWay<T>> found = closest_way(a, b, ways);
  return found ? found->features : FeatureVertices{1, 1, {a.vertex[0], b.vertex[0]}};
}

}  // namespace sunder::solid
