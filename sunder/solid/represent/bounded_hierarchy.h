// The bounded hierarchy of Barba and Langerman over a convex polyhedron with an interior: P = P_1, P_2, ..., P_k, a
// tetrahedron. Each is the hull of the one before without an independent set of vertices of low degree, or the one
// before with its vertices of high degree cut off by planes.
// Also called: BDK-hierarchy; bounded-degree Dobkin-Kirkpatrick hierarchy.
//
//   B1. P_1 is the polyhedron, P_k a tetrahedron.
//   B2. P_{i+1} lies in P_i. Its vertices are those of P_i but some, and where these were cut off, points of the edges
//       of P_i at them.
//   B3. A vertex of P_i has a degree of at most 5 most_kept, for i > 1. Proved, unless a cut is refused for
//       most_generation, which no body that was tried has reached. P_1 has the degrees that it has.
//   B4. The vertices that P_i has and P_{i+1} has not are an independent set of P_i, whose edges are split where
//       P_{i+1} has new vertices on them. Those that are not cut off have a degree of at most most_taken.
//   B5. k is at most a constant times log2 n, and all P_i together have at most a constant times n vertices: measured
//       (docs/design/bounded-hierarchy.md has the paper's proof, with its constant).
// Surfaces are triangulated, facets of many vertices somehow, and degrees are those of the triangulated ones.
//
// It is held as a history. Vertices have ranks, in the order in which they come when the tetrahedron grows to the whole
// again; each has a list of the neighbours that come while it is there. A cut point is there until the vertex comes
// that it was cut from. So a vertex is held once, and a walk (bounded_walk.h) reads lists, and no level.
//
// Cut points are not rounded: such a point is named by the vertex w that was cut off, the plane, and the other end u of
// the edge, which is a point of that line outside of the polyhedron where the edge was cut at its other end before.
// From these it is a fraction, exactly; what is kept of it in doubles is for filters and searches.
//
// Of a flat polygon: every second vertex of a level goes, P_k is a triangle, and nothing is cut.
//
// Source: BL15 section 4, Lemma 4.1. Departures: a vertex is cut off in one step, without a level on which its edges
// are split and it is still there; c is chosen and measured, not taken from the proof; where the paper says that W are
// vertices of P_i, they are those of the hull without the independent set, as nothing else makes sense; P_1 keeps its
// own degrees, which the paper takes as three by moving facets symbolically.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/exact_point.h>
#include <sunder/predicate/point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::solid {

class ConvexPolyhedron;

struct BoundedHierarchy {
  static constexpr std::size_t slot = 6;  // see solid/represent/of.h

  struct Limits {
    std::uint32_t most_taken = 8;       // the degree of a vertex that goes, at most 8
    std::uint32_t most_kept = 32;       // a vertex of a greater degree is cut off
    std::uint32_t most_generation = 3;  // cut points of cut points of cut points are not cut off
  };

  // Requires three vertices or more. Cost: O(n), and some exact arithmetic for each cut point. Every sign is exact.
  static BoundedHierarchy make(const ConvexPolyhedron& body) { return make(body, Limits()); }
  // `surfaces`, if any, gets the triangles of P_k, P_{k-1}, ..., P_1, as ranks, counter-clockwise from outside. For
  // tests and pictures; none of a polygon.
  using Surface = std::vector<std::array<std::uint32_t, 3>>;
  static BoundedHierarchy make(const ConvexPolyhedron& body, const Limits& limits,
                               std::vector<Surface>* surfaces = nullptr);

  static constexpr std::uint32_t none = 0xffffffff;

  struct Node {
    Point3 at;  // of a cut point: rounded
    std::uint32_t
        vertex;          // its number in the polyhedron; of a cut point, that of the vertex that it was first cut from
    std::uint32_t copy;  // of a cut point: its place in `copies`; else none
    std::uint32_t begin, end;  // of its list in `comers`
    // In `rims`, counter-clockwise: its neighbours when it comes, or if it was cut off, its cut points. Of P_k: empty.
    std::uint32_t rim_begin, rim_end;
  };
  struct Copy {
    Point3 rest;           // what rounding has left, rounded
    double share;          // how far it is from the parent, as a part of the way to u, rounded
    std::uint32_t parent;  // the rank of the vertex that was cut off: greater than all ranks of its list
    std::uint32_t toward;  // the rank of u
    std::uint32_t cut;
  };
  // The plane direction . (x - w) = 2^exponent, w the vertex that was cut off, which is on its lower side.
  struct Cut {
    Vector3<Dyadic> direction;
    std::int64_t exponent;
  };

  std::vector<Node> nodes;            // by rank
  std::vector<std::uint32_t> comers;  // ranks: of each list they ascend
  std::vector<std::uint32_t> rims;    // ranks
  std::vector<Copy> copies;
  std::vector<Cut> cuts;
  double error = 0;  // how far a coordinate of `at` may be off

  // Of P_k, P_{k-1}, ..., P_1: the vertices are the ranks below `end`, but for cut points whose parent is among these.
  struct Level {
    std::uint32_t end;
    std::uint32_t size;             // how many they are
    std::uint32_t greatest_degree;  // 2 of a polygon
  };
  std::vector<Level> levels;

  std::span<const std::uint32_t> comers_of(std::uint32_t rank) const {
    return std::span(comers).subspan(nodes[rank].begin, nodes[rank].end - nodes[rank].begin);
  }
  std::span<const std::uint32_t> rim_of(std::uint32_t rank) const {
    return std::span(rims).subspan(nodes[rank].rim_begin, nodes[rank].rim_end - nodes[rank].rim_begin);
  }
  std::uint32_t parent_of(std::uint32_t rank) const {  // none: it is a vertex of the polyhedron
    return nodes[rank].copy == none ? none : copies[nodes[rank].copy].parent;
  }
  ExactPoint3 exact(std::uint32_t rank) const;

  std::size_t memory() const;  // bytes
};

}  // namespace sunder::solid
