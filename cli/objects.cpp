#include <cli/objects.h>

#include <sunder/base/error.h>
#include <sunder/io/text.h>

#include <fmt/format.h>

#include <algorithm>

namespace sunder::cli {

namespace {

std::string place_of(const io::Mesh& mesh, std::uint32_t v) {
  const Point3& p = mesh.vertices[v];
  return fmt::format("({}, {}, {})", p.x, p.y, p.z);
}

std::string edge_text(const io::Mesh& mesh, const std::array<std::uint32_t, 2>& edge) {
  return fmt::format("from vertex {} {} to vertex {} {}", edge[0], place_of(mesh, edge[0]), edge[1],
                     place_of(mesh, edge[1]));
}

std::string why(const io::Mesh& mesh, const scene::MeshDefect& defect) {
  using Kind = scene::MeshDefect::Kind;
  switch (defect.kind) {
    case Kind::none: return "";
    case Kind::thin: return "all its vertices are on one line";
    case Kind::open_edge: return "it is open at the edge " + edge_text(mesh, defect.edge);
    case Kind::bent_face: return fmt::format("its face {} is not flat", defect.face);
    case Kind::reflex_edge: return "it bends inwards at the reflex edge " + edge_text(mesh, defect.edge);
    case Kind::inner_face: return fmt::format("its face {} is inside its hull", defect.face);
    case Kind::doubled: return "its faces are doubled";
  }
  return "";
}

// The mesh without the vertices that no polygon uses.
io::Mesh without_unused(const io::Mesh& mesh) {
  const std::vector<std::uint32_t> used = io::used_vertices(mesh);
  if (used.size() == mesh.vertices.size()) return mesh;
  io::Mesh small = mesh;
  small.vertices.clear();
  std::vector<std::uint32_t> number(mesh.vertices.size());
  for (const std::uint32_t v : used) {
    number[v] = static_cast<std::uint32_t>(small.vertices.size());
    small.vertices.push_back(mesh.vertices[v]);
  }
  for (std::uint32_t& v : small.polygon_vertices) v = number[v];
  return small;
}

}  // namespace

const char* name_of(Shape shape) {
  switch (shape) {
    case Shape::convex: return "convex";
    case Shape::hull: return "hull";
    case Shape::points: return "points";
  }
  return "";
}

Object make_object(const io::Mesh& whole, const std::filesystem::path& file, bool require_convex) {
  const io::Mesh mesh = without_unused(whole);
  const std::string shown = io::one_line(file.string());
  Object object{shown,
                io::one_line(file.stem().string()),
                mesh.format,
                static_cast<std::uint32_t>(mesh.vertices.size()),
                mesh.polygon_count(),
                Shape::points,
                "",
                solid::ConvexPolyhedron(mesh.vertices)};
  if (mesh.polygon_count() == 0) return object;

  scene::MeshDefect defect =
      scene::find_mesh_defect({mesh.vertices, mesh.polygon_begin, mesh.polygon_vertices}, object.hull);
  if (defect.kind == scene::MeshDefect::Kind::none) {
    object.shape = Shape::convex;
    return object;
  }
  const std::vector<std::uint32_t> used = io::used_vertices(whole);  // back to the file's numbers
  for (std::uint32_t& v : defect.edge) v = used[v];
  object.shape = Shape::hull;
  object.why_hull = why(whole, defect);
  if (require_convex) {
    throw Error(ErrorCode::bad_shape,
                fmt::format("the mesh is not exactly convex: {} (counted from 0); repair it, or leave out "
                            "--require-convex to use its hull",
                            object.why_hull),
                shown);
  }
  return object;
}

Object read_object(const std::filesystem::path& file, bool require_convex) {
  return make_object(io::read_mesh(file), file, require_convex);
}

std::vector<Object> read_parts(const std::filesystem::path& file, bool require_convex) {
  const std::vector<io::Mesh> meshes = io::split_parts(io::read_mesh(file));
  std::vector<Object> objects;
  for (const io::Mesh& mesh : meshes) {
    objects.push_back(make_object(mesh, file, require_convex));
    if (meshes.size() > 1 && !mesh.name.empty()) objects.back().name = mesh.name;
  }
  return objects;
}

void note_hulls(const std::vector<const Object*>& objects) {
  std::vector<std::string> files;
  const Object* first = nullptr;
  for (const Object* object : objects) {
    if (object->shape != Shape::hull) continue;
    if (first == nullptr) first = object;
    if (std::find(files.begin(), files.end(), object->file) == files.end()) files.push_back(object->file);
  }
  if (files.size() == 1) {
    note(fmt::format("{} is not exactly convex ({}): its hull stands for it", files[0], first->why_hull));
  } else if (!files.empty()) {
    std::string list;
    for (const std::string& file : files) {
      list += (list.empty() ? "" : ", ") + io::one_line(std::filesystem::path(file).filename().string());
    }
    note(fmt::format("{} meshes are not exactly convex, and their hulls stand for them: {}", files.size(), list));
  }
}

const char* dimension_name(int dimension) {
  constexpr std::array<const char*, 4> names{"point", "segment", "polygon", "body"};
  return names[static_cast<std::size_t>(dimension)];
}

Json to_json(const Object& object) {
  return {{"name", object.name},
          {"file", object.file},
          {"format", object.format},
          {"shape", name_of(object.shape)},
          {"dimension", object.hull.dimension()},
          {"vertices", object.hull.vertices().size()},
          {"facets", object.hull.facet_count()}};
}

}  // namespace sunder::cli
