// The sides of a mesh's polygons, where equal points count as one vertex: for questions about the mesh as a surface.
#pragma once

#include <sunder/solid/mesh/mesh_convexity.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace sunder::solid {

// For each point the lowest number of an equal one. By a hash table; sorted where that is slow, so no input is.
// Cost: n, at most n log n.
std::vector<std::uint32_t> lowest_of_equals(std::span<const Point3> points);
std::vector<std::uint32_t> lowest_of_equals_by_sorting(std::span<const Point3> points);

struct MeshCorners {
  explicit MeshCorners(const MeshView& mesh);

  std::span<const std::uint32_t> corners_of(std::uint32_t face) const {
    return std::span(corners).subspan(corner_begin[face], corner_begin[face + 1] - corner_begin[face]);
  }

  std::vector<std::uint32_t> lowest;      // for each vertex the lowest number of an equal point
  std::vector<std::uint32_t> corners;     // of all faces, as lowest numbers, repetitions in a row dropped
  std::vector<std::size_t> corner_begin;  // one entry more than there are faces
};

struct MeshSides : MeshCorners {
  // An edge of a polygon, from a corner to the next.
  struct Side {
    std::uint32_t from, to, face;

    std::pair<std::uint32_t, std::uint32_t> ends() const { return std::minmax(from, to); }
  };

  // Cost: n log n.
  explicit MeshSides(const MeshView& mesh);

  std::vector<Side> sides;  // of different ends, sorted by their ends, then by face
};

}  // namespace sunder::solid
