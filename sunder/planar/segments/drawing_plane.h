// Is a straight-line drawing of a graph plane: do its edges meet at common vertices only?
// Also called: plane straight-line graph (PSLG) test.
//
//   P1. meet() is false iff no two vertices have one place, no vertex lies on an edge that it is not an end of, and no
//       two edges meet but in a common vertex.
//   P2. What is named is such a contact; which one it is may differ from method to method.
// An edge that is given twice overlaps itself, so the drawing is not plane.
// Source: Shamos & Hoey 1976, section IV (a drawing with more than 3 N - 6 edges is not plane; else Algorithm 1).
#pragma once

#include <sunder/base/error.h>
#include <sunder/near/set_question.h>
#include <sunder/planar/pair/segment_segment.h>

#include <array>
#include <cstdint>
#include <span>

namespace sunder::planar {

// What a plane drawing has none of.
struct DrawingContact {
  enum class Of : std::uint8_t {
    vertices,         // the vertices i < j have one place
    vertex_and_edge,  // the vertex i, which no edge ends at, lies on the edge j
    edges,            // the edges i < j meet
  };
  Of of = Of::vertices;
  std::uint32_t i = 0, j = 0;
  ContactKind kind = ContactKind::none;  // of the two edges, or of the edge and the vertex; of vertices none
};

using DrawingAnswer = AnyAnswer<DrawingContact>;  // plane where none is found; probes: comparisons

using DrawingEdge = std::array<std::uint32_t, 2>;  // two vertices

// Throws Error bad_value, "vertex 7: ...", where a coordinate is not finite; bad_shape, "edge 7: ...", where an edge
// names a vertex that is not there or one twice, or for 2^30 edges or vertices and more.
// Cost: O(N log N) for N vertices and edges; expected linear where edges are short.
DrawingAnswer drawing_plane(std::span<const Point2> vertices, std::span<const DrawingEdge> edges);

// Every pair: the oracle. O(N^2) time.
DrawingAnswer drawing_plane_by_scan(std::span<const Point2> vertices, std::span<const DrawingEdge> edges);

}  // namespace sunder::planar
