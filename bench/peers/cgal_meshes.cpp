// CGAL, header only: self-intersections of a surface mesh, by boxes and exact predicates. The mesh is prepared.
#include <bench/peers/mesh_peer.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <utility>
#include <vector>

namespace bench {

Run cgal_self_crossings(const std::vector<MeshSoup>& soups) {
  using Surface = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  std::vector<Surface> surfaces;
  for (const MeshSoup& soup : soups) {
    Surface& surface = surfaces.emplace_back();
    std::vector<Surface::Vertex_index> points;
    for (const sunder::Point3& p : soup.points) points.push_back(surface.add_vertex({p.x, p.y, p.z}));
    for (std::size_t k = 0; k < soup.corners.size(); k += 3) {
      surface.add_face(points[soup.corners[k]], points[soup.corners[k + 1]], points[soup.corners[k + 2]]);
    }
  }
  return each([surfaces = std::move(surfaces)](std::size_t k) {
    std::vector<std::pair<Surface::Face_index, Surface::Face_index>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections(surfaces[k], std::back_inserter(pairs));
    return pairs.size();
  });
}

}  // namespace bench
