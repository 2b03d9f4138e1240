// Of the vertices that a simplex of the difference is made of, up to eight, at most five that are enough for a common
// point (Caratheodory's theorem). In floating point: the outcome is a proposal.
#pragma once

#include <sunder/solid/search/closest_simplex.h>
#include <sunder/solid/search/placed.h>
#include <sunder/solid/search/proposal.h>

#include <array>
#include <cstdint>
#include <type_traits>

namespace sunder::solid {

// Weights below this part of the largest are taken for zero.
template <class Real>
constexpr double negligible = std::is_same_v<Real, double> ? 0x1p-40 : 0x1p-92;

// The different vertices of one body in a simplex or a mixture.
template <std::size_t Most>
struct SupportOf {
  std::array<std::uint32_t, Most> vertex{};
  std::size_t count = 0;

  // Returns where the vertex stands.
  std::size_t add(std::uint32_t v) {
    for (std::size_t i = 0; i < count; ++i) {
      if (vertex[i] == v) return i;
    }
    vertex[count] = v;
    return count++;
  }
};
using Support = SupportOf<4>;

// A point as a mean of vertices of one body, with weights that are not negative and sum to 1, as far as rounding tells.
template <class Real>
struct Mixture {
  static constexpr std::size_t most = 18;
  std::array<std::uint32_t, most> vertex{};
  std::array<Real, most> weight{};
  std::size_t count = 0;

  // Adds to the weight of a vertex. Requires at most `most` different ones.
  void add(std::uint32_t v, const Real& w) {
    std::size_t k = 0;
    while (k < count && vertex[k] != v) ++k;
    if (k == count) {
      vertex[count] = v;
      weight[count++] = 0;
    }
    weight[k] += w;
  }
};

// Of a tetrahedron that holds the origin, with the origin's weights, up to a factor, all positive. Names the vertices
// in the proposal, that they meet. False where rounding spoils it.
bool name_five_of_tetrahedron(const Placed& a, const DifferenceSimplex& tetrahedron,
                              const std::array<double, 4>& weights, Proposal& proposal);

// Of any simplex, with the weights of the point nearest to the origin. `drop_negligible`: weights that are next to
// nothing beside the largest count as zero, before and after.
template <class Real>
bool name_at_most_five(const Placed& a, const Placed& b, const DifferenceSimplexOf<Real>& simplex,
                       const std::array<Real, 4>& weights, bool drop_negligible, Proposal& proposal);

// Of a point that is a mixture of both.
template <class Real>
bool name_at_most_five(const Placed& a, const Placed& b, const Mixture<Real>& of_a, const Mixture<Real>& of_b,
                       bool drop_negligible, Proposal& proposal);

}  // namespace sunder::solid
