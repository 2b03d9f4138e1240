#include <sunder/solid/mesh/mesh_claims.h>

namespace sunder::solid {

void write_mesh(ClaimsWriter& file, const MeshView& mesh, const ConvexPolyhedron& hull,
                std::optional<std::uint32_t> off_hull) {
  file.begin_statement("mesh");
  file.index("body", 0);
  file.begin_list("mesh_faces");
  for (std::uint32_t p = 0; p < mesh.polygon_count(); ++p) file.add_list(mesh.polygon(p));
  file.end_list();
  file.text("verdict", off_hull ? "not_convex" : "convex");
  if (off_hull) file.index("face", *off_hull);
  file.begin_claims();
  file.begin_claim(off_hull ? "leaves_hull" : "bounds_hull");
  if (!off_hull) file.indices("beneath", facets_beneath(mesh, hull));
  file.end_claim();
  file.end_statement();
}

}  // namespace sunder::solid
