// What a search has found about two convex polygons: a claim, and the vertices and edges that should prove it. Plain
// data of fixed size, without exact numbers; a search knows nothing of certificates. A proposal may be wrong in any
// way: polygon_polygon_answer.h disposes of it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace sunder::planar {

// Positions in a sequence of n vertices, three at most; where not said otherwise, a position may also be given plus n.
using Corners = std::span<const std::uint32_t>;

struct Proposal {
  enum class Claim : std::uint8_t {
    apart_by_edge_of_a,  // edge of_a[0] of A has all of B strictly on its right; vertex of_b[0] is nearest
    apart_by_edge_of_b,  // edge of_b[0] of B, and vertex of_a[0] of A
    apart_at_vertices,   // an edge at vertex of_a[0] of A, or at of_b[0] of B, does, with the other vertex nearest
    meet,                // the hulls of these corners have a common point
    meet_plainly,        // the same of three corners of each, without plus n, so that floating point is sure of it
  };
  Claim claim = Claim::meet;
  std::uint8_t count_a = 1, count_b = 1;
  std::array<std::uint32_t, 3> of_a{}, of_b{};  // the first count_a, count_b of them mean something
};

inline Proposal apart_by_edge_of_a(std::uint32_t edge, std::uint32_t near) {
  return {Proposal::Claim::apart_by_edge_of_a, 1, 1, {edge}, {near}};
}
inline Proposal apart_by_edge_of_b(std::uint32_t near, std::uint32_t edge) {
  return {Proposal::Claim::apart_by_edge_of_b, 1, 1, {near}, {edge}};
}
inline Proposal apart_at_vertices(std::uint32_t i, std::uint32_t j) {
  return {Proposal::Claim::apart_at_vertices, 1, 1, {i}, {j}};
}
inline Proposal meet(Corners of_a, Corners of_b) {
  Proposal p{Proposal::Claim::meet, static_cast<std::uint8_t>(of_a.size()), static_cast<std::uint8_t>(of_b.size())};
  std::copy(of_a.begin(), of_a.end(), p.of_a.begin());
  std::copy(of_b.begin(), of_b.end(), p.of_b.begin());
  return p;
}
inline Proposal meet_plainly(const std::array<std::uint32_t, 3>& of_a, const std::array<std::uint32_t, 3>& of_b) {
  return {Proposal::Claim::meet_plainly, 3, 3, of_a, of_b};
}

}  // namespace sunder::planar
