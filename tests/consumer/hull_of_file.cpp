// The readers are linked: a tetrahedron with one more point inside has a hull of four vertices.
#include <sunder/io/mesh/mesh.h>
#include <sunder/solid/object/convex_polyhedron.h>

int main() {
  const sunder::io::Mesh mesh = sunder::io::parse_mesh("v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nv 1 1 1\n", "points.obj",
                                                       sunder::io::MeshFormat::obj);
  return sunder::solid::ConvexPolyhedron(mesh.vertices).vertices().size() == 4 ? 0 : 1;
}
