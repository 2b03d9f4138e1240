#include <sunder/ask/objects.h>

#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace sunder::ask {

std::string departure_text(const MeshBody& object) {
  if (!object.departure) return "";
  const auto& [depth, at_least, volume] = *object.departure;
  std::string text = depth == 0 ? "no edge lies below the hull"
                                : fmt::format("the deepest edge lies {} {} below the hull",
                                              at_least ? "at least about" : "about", about(depth));
  if (volume) {
    text += fmt::format("; the hull's volume is about {}, of which the mesh lacks about {}", about(volume->hull),
                        about(volume->missing));
  }
  return text;
}

void note_remarks(Talk& talk, const std::vector<const MeshBody*>& objects) {
  std::vector<std::string> told;
  const auto tell = [&](const MeshBody& object, const std::string& remark) {
    std::string text = object.file + ": " + remark;
    if (std::find(told.begin(), told.end(), text) == told.end()) talk.note(told.emplace_back(std::move(text)));
  };
  for (const MeshBody* object : objects) {
    if (object->inner_vertices > 0) tell(*object, io::inner_vertices_text(object->inner_vertices));
    if (object->mesh == nullptr) continue;
    for (const std::string& remark : object->mesh->remarks) tell(*object, remark);
  }
}

void note_hulls(Talk& talk, const std::vector<const MeshBody*>& objects) {
  note_remarks(talk, objects);
  std::vector<std::string> files;
  const MeshBody *first = nullptr, *deepest = nullptr;
  for (const MeshBody* object : objects) {
    if (object->shape != io::BodyShape::hull) continue;
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
    talk.note(fmt::format("{} is not exactly convex ({}), so its convex hull is used{}{}", files[0], first->why_hull,
                          departure.empty() ? "" : "; ", departure));
    return;
  }
  std::string list;
  for (const std::string& file : files) list += (list.empty() ? "" : ", ") + name(file);
  talk.note(fmt::format("{} meshes are not exactly convex, so their convex hulls are used: {}{}", files.size(), list,
                        departure.empty() ? "" : fmt::format("; in {}, {}", name(deepest->file), departure)));
}

SurfaceTold surface_told(const solid::Mesh& mesh) {
  std::array<std::uint64_t, 3> of_kind{};  // by each PieceKind
  std::uint64_t open_edges = 0, t_junctions = 0;
  for (const solid::Mesh::Piece& piece : mesh.pieces()) {
    ++of_kind[static_cast<std::size_t>(piece.kind)];
    open_edges += piece.open_edges;
    t_junctions += piece.t_junctions;
  }
  const auto [oriented, unoriented, open] = of_kind;
  const std::size_t pieces = mesh.pieces().size(), crossing = mesh.crossing_faces().size();
  const std::string of_pieces = pieces == 1 ? "1 piece" : fmt::format("{} pieces", pieces);
  SurfaceTold told;
  told.json = {{"closed", mesh.is_closed()},
               {"pieces", pieces},
               {"oriented", oriented},
               {"unoriented", unoriented},
               {"open", open},
               {"open_edges", open_edges},
               {"t_junctions", t_junctions},
               {"crossing_faces", crossing}};
  told.lines = {open == 0 ? "yes, " + of_pieces
                          : fmt::format("no: {}{} belong to an odd number of triangles", count_of(open_edges, "edge"),
                                        pieces > 1 ? fmt::format(", of {} of {},", open, of_pieces) : "")};
  if (unoriented > 0) {
    told.lines.push_back(fmt::format(
        "{} of {}, not turned the same way everywhere: inside is where a ray crosses the mesh an odd number of times",
        unoriented, of_pieces));
  }
  if (t_junctions > 0) {
    told.lines.push_back(
        fmt::format("{} inside edges of other triangles (T-junctions), exactly", count_of(t_junctions, "corner")));
  }
  if (crossing > 0) {
    told.lines.push_back(fmt::format("{}, the first is polygon {}",
                                     crossing == 1 ? "1 polygon crosses or touches itself"
                                                   : fmt::format("{} polygons cross or touch themselves", crossing),
                                     mesh.crossing_faces()[0]));
  }
  return told;
}

const char* dimension_name(int dimension) {
  constexpr std::array<const char*, 4> names{"point", "segment", "polygon", "body"};
  return names[static_cast<std::size_t>(dimension)];
}

Json to_json(const MeshBody& object) {
  Json json = {{"name", object.name},
               {"file", object.file},
               {"format", object.format},
               {"shape", name_of(object.shape)},
               {"dimension", object.hull.dimension()},
               {"vertices", object.hull.vertices().size()},
               {"facets", object.hull.facet_count()}};
  if (object.shape == io::BodyShape::hull) json["why_hull"] = object.why_hull;
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
