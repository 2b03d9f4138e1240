// A mesh of lists of corners, and what is asked of it and its hull.
#pragma once

#include <sunder/solid/mesh/mesh_convexity.h>
#include <sunder/solid/object/convex_polyhedron.h>

#include <cstdint>
#include <vector>

namespace sunder::solid {

struct FaceMesh {
  std::vector<Point3> vertices;
  std::vector<std::vector<std::uint32_t>> faces;
};

template <class Answer>
Answer asked_of(const FaceMesh& mesh, Answer (*question)(const MeshView&, const ConvexPolyhedron&)) {
  std::vector<std::uint32_t> begin{0}, corners;
  for (const auto& face : mesh.faces) {
    corners.insert(corners.end(), face.begin(), face.end());
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return question({mesh.vertices, begin, corners}, ConvexPolyhedron(mesh.vertices));
}

}  // namespace sunder::solid
