#include <sunder/base/names.h>
#include <sunder/io/mesh/mesh_body.h>
#include <sunder/io/mesh/mesh_memory.h>
#include <sunder/io/text/text.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

namespace sunder::io {

namespace {

// What is known of a mesh before its hull is: the file, and how the file numbers its vertices and faces.
struct Numbering {
  const std::filesystem::path& file;
  std::vector<std::uint32_t> vertices;  // of each vertex of the mesh its number in the file
  std::uint32_t first_face = 0;
};

std::string vertex_text(const Mesh& mesh, const Numbering& origin, std::uint32_t v) {
  const Point3& p = mesh.vertices[v];
  return fmt::format("vertex {} ({}, {}, {})", origin.vertices[v], p.x, p.y, p.z);
}

// Numbers are those of the file.
std::string why(const Mesh& mesh, const Numbering& origin, const solid::MeshDefect& defect) {
  const auto edge = [&] {
    return fmt::format("from {} to {}", vertex_text(mesh, origin, defect.edge[0]),
                       vertex_text(mesh, origin, defect.edge[1]));
  };
  const std::uint32_t face = origin.first_face + defect.face;
  using Kind = solid::MeshDefect::Kind;
  switch (defect.kind) {
    case Kind::none: return "";
    case Kind::thin: return "all its vertices are on one line";
    case Kind::open_edge: return "it is open at the edge " + edge();
    case Kind::bent_face: return fmt::format("its face {} is not flat", face);
    case Kind::reflex_edge: return "it bends inwards at the reflex edge " + edge();
    case Kind::inner_face: return fmt::format("its face {} is inside its hull", face);
    case Kind::doubled: return "its faces are doubled";
  }
  return "";
}

// The mesh without the vertices that no polygon uses; these are the vertices `used` of the file.
Mesh without_unused(Mesh mesh, const std::vector<std::uint32_t>& used) {
  if (used.size() == mesh.vertices.size()) return mesh;
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> number(mesh.vertices.size());
  vertices.reserve(used.size());
  for (const std::uint32_t v : used) {
    number[v] = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(mesh.vertices[v]);
  }
  mesh.vertices = std::move(vertices);
  for (std::uint32_t& v : mesh.polygon_vertices) v = number[v];
  return mesh;
}

// All vertices of the mesh are in use.
MeshBody hull_of_mesh(const Mesh& mesh, const Numbering& origin, bool require_convex) {
  const std::string shown = one_line(origin.file.string());
  MeshMemory::take(shown, mesh.polygon_vertices.size() - 2 * std::uint64_t{mesh.polygon_count()});
  MeshBody body{shown,
                one_line(origin.file.stem().string()),
                mesh.format,
                static_cast<std::uint32_t>(mesh.vertices.size()),
                mesh.polygon_count(),
                BodyShape::points,
                "",
                std::nullopt,
                solid::ConvexPolyhedron(mesh.vertices)};
  if (mesh.polygon_count() == 0) return body;
  body.mesh = std::make_shared<const Mesh>(mesh);

  const solid::MeshView view{mesh.vertices, mesh.polygon_begin, mesh.polygon_vertices};
  const solid::MeshDefect defect = solid::find_mesh_defect(view, body.hull);
  if (defect.kind == solid::MeshDefect::Kind::none) {
    body.shape = BodyShape::convex;
    return body;
  }
  body.shape = BodyShape::hull;
  body.why_hull = why(mesh, origin, defect);
  if (require_convex) {
    throw Error(ErrorCode::bad_shape,
                fmt::format("the mesh is not exactly convex: {} (counted from 0); repair it, or leave out "
                            "--require-convex",
                            body.why_hull),
                shown);
  }
  if (body.hull.dimension() == 3) body.departure = solid::mesh_departure(view, body.hull);
  return body;
}

// Reads a mesh; what is not read goes into the list.
Mesh read_whole(const std::filesystem::path& file, LeftOutList& left_out, InputFiles* inputs,
                std::uint64_t& inner_vertices, PartsOf parts = PartsOf::objects) {
  Mesh mesh = read_mesh(file, inputs, parts);
  inner_vertices = drop_inner_vertices(mesh);
  left_out.add(file.string(), mesh.left_out, "mend the file");
  return mesh;
}

}  // namespace

std::string_view name_of(BodyShape shape) { return name_in<BodyShape::points>({"convex", "hull", "points"}, shape); }

std::uint64_t drop_inner_vertices(Mesh& mesh) {
  const auto item = std::find_if(mesh.left_out.begin(), mesh.left_out.end(),
                                 [](const LeftOut& left_out) { return left_out.kind == unused_vertex; });
  if (item == mesh.left_out.end()) return 0;
  const std::vector<std::uint32_t> used = used_vertices(mesh);
  std::vector<Point3> points;
  points.reserve(used.size());
  for (const std::uint32_t v : used) points.push_back(mesh.vertices[v]);
  const solid::ConvexPolyhedron hull(points);
  std::uint64_t inner = 0;
  auto next = used.begin();
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (next != used.end() && *next == v) {
      ++next;
      continue;
    }
    const solid::ConvexPolyhedron point(std::span(&mesh.vertices[v], 1));
    inner += polyhedron_polyhedron(hull, solid::Pose(), point, solid::Pose()).meet();
  }
  item->count -= inner;
  if (item->count == 0) mesh.left_out.erase(item);
  return inner;
}

std::string inner_vertices_text(std::uint64_t count) {
  if (count == 0) return "";
  return count == 1 ? "1 unused vertex lies in the hull of the others, and changes nothing"
                    : fmt::format("{} unused vertices lie in the hull of the others, and change nothing", count);
}

solid::Mesh mesh_as_it_is(const MeshBody& body) {
  if (body.mesh == nullptr) return mesh_of(body.hull);
  return solid::Mesh({body.mesh->vertices, body.mesh->polygon_begin, body.mesh->polygon_vertices});
}

MeshBody body_of_mesh(Mesh mesh, const std::filesystem::path& file, bool require_convex) {
  const std::vector<std::uint32_t> used = used_vertices(mesh);
  return hull_of_mesh(without_unused(std::move(mesh), used), {file, used}, require_convex);
}

MeshBody read_body(const std::filesystem::path& file, bool require_convex, LeftOutList& left_out, InputFiles* inputs) {
  std::uint64_t inner_vertices = 0;
  MeshBody body = body_of_mesh(read_whole(file, left_out, inputs, inner_vertices), file, require_convex);
  body.inner_vertices = inner_vertices;
  return body;
}

HullOfPoints read_hull(const std::filesystem::path& file, LeftOutList& left_out, InputFiles* inputs) {
  std::uint64_t inner_vertices = 0;
  Mesh mesh = read_whole(file, left_out, inputs, inner_vertices);
  const std::vector<std::uint32_t> used = used_vertices(mesh);
  Mesh small = without_unused(std::move(mesh), used);
  MeshBody body = hull_of_mesh(small, {file, used}, false);
  body.inner_vertices = inner_vertices;
  return {std::move(body), std::move(small)};
}

std::vector<MeshBody> read_bodies(const std::filesystem::path& file, bool require_convex, LeftOutList& left_out,
                                  InputFiles* inputs, PartsOf parts) {
  std::uint64_t inner_vertices = 0;
  const Mesh whole = read_whole(file, left_out, inputs, inner_vertices, parts);
  std::vector<std::vector<std::uint32_t>> used;
  const std::vector<Mesh> meshes = split_parts(whole, &used);
  std::vector<MeshBody> bodies;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    bodies.push_back(hull_of_mesh(meshes[i], {file, std::move(used[i]), whole.parts[i].first}, require_convex));
    if (meshes.size() > 1 && !meshes[i].name.empty()) bodies.back().name = meshes[i].name;
    bodies.back().inner_vertices = inner_vertices;
  }
  return bodies;
}

}  // namespace sunder::io
