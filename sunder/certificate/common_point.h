// Exact weights of a body's points, and the points that they make.
// Also called: convex combination; barycentric coordinates; witness point.
// Throws only std::bad_alloc.
#pragma once

#include <sunder/certificate/pair.h>
#include <sunder/predicate/exact_point.h>
#include <sunder/predicate/point/common_point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace sunder {

// Some points, each by its index with a weight: its numerator over the denominator, which is positive. Weights of points
// sum to 1, and none is negative.
struct Weights {
  struct Part {
    std::uint32_t index = 0;
    Dyadic numerator;
  };
  std::vector<Part> parts{};
  Dyadic denominator{1.0};

  // Adds it to the numerator of that index. Cost: linear in the parts.
  void add(std::uint32_t index, const Dyadic& numerator);
};

// How a body makes a point: by weights of its points, and of its ways, counted on from these. A body with a radius makes
// so a point of its core, from which the body reaches the point that is meant. An ellipsoid's one weight is 1, and
// `from` is the point before the ellipsoid is placed, over a denominator that is not zero.
struct Combination : Weights {
  std::optional<ExactPoint3> from{};  // of an ellipsoid, and of no other body

  Combination() = default;
  Combination(std::vector<Part> of, Dyadic over = Dyadic(1.0), std::optional<ExactPoint3> preimage = {})
      : Weights{std::move(of), std::move(over)}, from(std::move(preimage)) {}
};

// A point of one body, and how that makes it. The denominator is not zero.
struct PointOf {
  ExactPoint3 at;
  Combination of_body;
};

// A point of two bodies, and how each of the two makes it. The denominator is not zero.
struct CommonPoint {
  ExactPoint3 at;
  Combination of_a, of_b;
};

// From the first point to the second, times a positive number. Requires positive denominators.
std::array<Dyadic, 3> way_between(const PointOf& from, const PointOf& to);

// The sum of the numerators times the points, point_at(index) each.
template <class PointAt>
Vector3<Dyadic> numerators_of(const Weights& weights, const PointAt& point_at) {
  Vector3<Dyadic> sum{};
  for (const auto& [index, numerator] : weights.parts) {
    const Vector3<Dyadic> p = point_at(index);
    sum = {sum.x + numerator * p.x, sum.y + numerator * p.y, sum.z + numerator * p.z};
  }
  return sum;
}

// The common point that evidence of meeting names, of its vertices in its order; its weights are all positive.
CommonPoint common_point(const CommonVertices& evidence, std::span<const Posed3> vertices);

// The same: a[v] and b[v] are the placed vertices of the bodies, as Posed3.
template <class A, class B>
CommonPoint common_point(const CommonVertices& evidence, const A& a, const B& b) {
  std::array<Posed3, 5> vertices{};
  const std::size_t n = std::size_t{evidence.count_a} + evidence.count_b;
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t v = evidence.vertices[k];
    vertices[k] = k < evidence.count_a ? a[v] : b[v];
  }
  return common_point(evidence, std::span<const Posed3>(vertices.data(), n));
}

}  // namespace sunder
