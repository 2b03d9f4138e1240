#include <sunder/ask/objects.h>

#include <sunder/base/error.h>
#include <sunder/io/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace sunder::ask {

namespace {

// What is known of a mesh before its hull is: the file, and how the file numbers its vertices and faces.
struct Origin {
  const std::filesystem::path& file;
  std::vector<std::uint32_t> vertices;  // of each vertex of the mesh its number in the file
  std::uint32_t first_face = 0;
};

std::string vertex_text(const io::Mesh& mesh, const Origin& origin, std::uint32_t v) {
  const Point3& p = mesh.vertices[v];
  return fmt::format("vertex {} ({}, {}, {})", origin.vertices[v], p.x, p.y, p.z);
}

// Numbers are those of the file.
std::string why(const io::Mesh& mesh, const Origin& origin, const scene::MeshDefect& defect) {
  const auto edge = [&] {
    return fmt::format("from {} to {}", vertex_text(mesh, origin, defect.edge[0]),
                       vertex_text(mesh, origin, defect.edge[1]));
  };
  const std::uint32_t face = origin.first_face + defect.face;
  using Kind = scene::MeshDefect::Kind;
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
io::Mesh without_unused(io::Mesh mesh, const std::vector<std::uint32_t>& used) {
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
Object object_of(const io::Mesh& mesh, const Origin& origin, bool require_convex) {
  const std::string shown = io::one_line(origin.file.string());
  Object object{shown,
                io::one_line(origin.file.stem().string()),
                mesh.format,
                static_cast<std::uint32_t>(mesh.vertices.size()),
                mesh.polygon_count(),
                Shape::points,
                "",
                std::nullopt,
                solid::ConvexPolyhedron(mesh.vertices)};
  if (mesh.polygon_count() == 0) return object;

  const scene::MeshView view{mesh.vertices, mesh.polygon_begin, mesh.polygon_vertices};
  const scene::MeshDefect defect = scene::find_mesh_defect(view, object.hull);
  if (defect.kind == scene::MeshDefect::Kind::none) {
    object.shape = Shape::convex;
    return object;
  }
  object.shape = Shape::hull;
  object.why_hull = why(mesh, origin, defect);
  if (require_convex) {
    throw Error(ErrorCode::bad_shape,
                fmt::format("the mesh is not exactly convex: {} (counted from 0); repair it, or leave out "
                            "--require-convex to use its hull",
                            object.why_hull),
                shown);
  }
  if (object.hull.dimension() == 3) object.departure = scene::mesh_departure(view, object.hull);
  return object;
}

// Reads a mesh; what is not read goes into the list.
io::Mesh read_whole(const std::filesystem::path& file, LeftOutList& left_out, InputFiles* inputs) {
  io::Mesh mesh = io::read_mesh(file, inputs);
  left_out.add(file.string(), mesh.left_out, "mend the file");
  return mesh;
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

Object make_object(io::Mesh mesh, const std::filesystem::path& file, bool require_convex) {
  const std::vector<std::uint32_t> used = io::used_vertices(mesh);
  return object_of(without_unused(std::move(mesh), used), {file, used}, require_convex);
}

Object read_object(const std::filesystem::path& file, bool require_convex, LeftOutList& left_out, InputFiles* inputs) {
  return make_object(read_whole(file, left_out, inputs), file, require_convex);
}

ObjectOfPoints read_object_of_points(const std::filesystem::path& file, LeftOutList& left_out, InputFiles* inputs) {
  io::Mesh mesh = read_whole(file, left_out, inputs);
  const std::vector<std::uint32_t> used = io::used_vertices(mesh);
  io::Mesh small = without_unused(std::move(mesh), used);
  Object object = object_of(small, {file, used}, false);
  return {std::move(object), std::move(small.vertices)};
}

std::vector<Object> read_parts(const std::filesystem::path& file, bool require_convex, LeftOutList& left_out,
                               InputFiles* inputs) {
  const io::Mesh whole = read_whole(file, left_out, inputs);
  std::vector<std::vector<std::uint32_t>> used;
  const std::vector<io::Mesh> meshes = io::split_parts(whole, &used);
  std::vector<Object> objects;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    objects.push_back(object_of(meshes[i], {file, std::move(used[i]), whole.parts[i].first}, require_convex));
    if (meshes.size() > 1 && !meshes[i].name.empty()) objects.back().name = meshes[i].name;
  }
  return objects;
}

std::string departure_text(const Object& object) {
  if (!object.departure) return "";
  const auto& [depth, at_least, volume] = *object.departure;
  std::string text = depth == 0 ? "no edge is below the hull"
                                : fmt::format("the deepest edge is {} {} below the hull",
                                              at_least ? "at least about" : "about", about(depth));
  if (volume) {
    text +=
        fmt::format(", which holds about {} more than the mesh, of {}", about(volume->missing), about(volume->hull));
  }
  return text;
}

void note_hulls(const std::vector<const Object*>& objects) {
  std::vector<std::string> files;
  const Object *first = nullptr, *deepest = nullptr;
  for (const Object* object : objects) {
    if (object->shape != Shape::hull) continue;
    if (first == nullptr) first = object;
    if (object->departure && (deepest == nullptr || object->departure->depth > deepest->departure->depth)) {
      deepest = object;
    }
    if (std::find(files.begin(), files.end(), object->file) == files.end()) files.push_back(object->file);
  }
  if (files.empty()) return;
  const auto name = [](const std::string& file) {
    return io::one_line(std::filesystem::path(file).filename().string());
  };
  const std::string departure = deepest == nullptr ? "" : departure_text(*deepest);
  if (files.size() == 1) {
    note(fmt::format("{} is not exactly convex ({}): its hull stands for it{}{}", files[0], first->why_hull,
                     departure.empty() ? "" : "; ", departure));
    return;
  }
  std::string list;
  for (const std::string& file : files) list += (list.empty() ? "" : ", ") + name(file);
  note(fmt::format("{} meshes are not exactly convex, and their hulls stand for them: {}{}", files.size(), list,
                   departure.empty() ? "" : fmt::format("; of {}, {}", name(deepest->file), departure)));
}

const char* dimension_name(int dimension) {
  constexpr std::array<const char*, 4> names{"point", "segment", "polygon", "body"};
  return names[static_cast<std::size_t>(dimension)];
}

Json to_json(const Object& object) {
  Json json = {{"name", object.name},
               {"file", object.file},
               {"format", object.format},
               {"shape", name_of(object.shape)},
               {"dimension", object.hull.dimension()},
               {"vertices", object.hull.vertices().size()},
               {"facets", object.hull.facet_count()}};
  if (object.shape == Shape::hull) json["why_hull"] = object.why_hull;
  if (!object.departure) return json;
  const auto& [depth, at_least, volume] = *object.departure;
  json["departure"] = {{"depth_about", depth}, {"at_least", at_least}};
  if (volume) {
    json["departure"]["volume_missing_about"] = volume->missing;
    json["departure"]["volume_of_hull_about"] = volume->hull;
  }
  return json;
}

}  // namespace sunder::ask
