// sunder info FILE...: what is in a file?
#include <sunder/ask/objects.h>
#include <sunder/ask/packages_option.h>
#include <sunder/ask/report.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh.h>
#include <sunder/io/plane/lines.h>
#include <sunder/io/plane/planar_objects.h>
#include <sunder/io/robot/packages.h>
#include <sunder/io/robot/scene_file.h>
#include <sunder/io/robot/urdf.h>
#include <sunder/io/text/csv.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/foreign.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/triples.h>

#include <sunder/solid/mesh/mesh.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>

namespace sunder::ask {

namespace {

struct InfoCall {
  std::vector<std::string> files, packages;
  bool formats = false;
  bool json = false;
};

struct Format {
  const char *name, *endings, *access, *what;
};

constexpr std::array<Format, 18> formats{
    {{"OBJ", ".obj", "read, write", "Wavefront; objects are parts of a body"},
     {"STL", ".stl", "read, write", "binary (read; single precision) and ASCII; equal points are joined"},
     {"PLY", ".ply", "read, write", "ASCII, and binary of either byte order (read)"},
     {"OFF", ".off", "read, write", "Object File Format, ASCII"},
     {"COLLADA", ".dae", "read", "meshes in nodes, each a part; double precision, in metres by its unit"},
     {"glTF", ".gltf", "read", "glTF 2.0, meshes in nodes, each a part; single precision, metres"},
     {"glTF", ".glb", "read", "the same in one binary file"},
     {"VRML", ".wrl", "read", "VRML 2, sets of faces, each a part, such as convex decompositions"},
     {"3MF", ".3mf", "read", "meshes of build items, each a part; double precision, in millimetres by its unit"},
     {"URDF", ".urdf", "read", "robots: links with meshes, boxes, cylinders and the like, joints with limits"},
     {"scene", ".json", "read", "for `sunder scene`: bodies of parts, poses, pairs that may meet"},
     {"CSV", ".csv", "read", "segments: x1,y1,x2,y2; circles: x,y,r; half-planes: a,b,c; others by name"},
     {"CSV with WKT", ".csv", "read", "a geometry of WKT in each line, in a column wkt, geometry, geom or the_geom"},
     {"WKT", ".wkt", "read", "lines and polygons, a geometry on each line; their edges are segments"},
     {"GeoJSON", ".geojson", "read", "lines and polygons; their edges are segments"},
     {"GeoJSONL", ".geojsonl", "read", "the same, an object of GeoJSON on each line; also .geojsons, .ndjson, .jsonl"},
     {"KiCad board", ".kicad_pcb", "read", "tracks by layer and net; arcs as polylines"},
     {"certificate", ".json", "write, verify", "proofs: docs/claims.md"}}};

// What is told of a file: for people and in JSON.
struct Info {
  std::string text;
  Json json;

  void add(std::string_view title, const std::string& words) { text += fmt::format("  {:<6}  {}\n", title, words); }
  void add_systems(const std::string& file, std::span<const io::SystemOfFile> of_file) {
    io::CoordinateSystems systems(true);
    systems.add(file, of_file);
    if (systems.declared().empty()) return;
    for (const Fact& fact : facts_of(systems)) json[fact.key] = fact.json;
    std::string names;
    for (const auto& [system, files, first] : systems.declared()) {
      names += (names.empty() ? "" : ", ") + system.name;
    }
    add("crs", names);
    for (const std::string& remark : systems.remarks()) add("remark", remark);
  }
};

const char* type_name(io::JointType type) {
  switch (type) {
    case io::JointType::fixed: return "fixed";
    case io::JointType::revolute: return "revolute";
    case io::JointType::continuous: return "continuous";
    case io::JointType::prismatic: return "prismatic";
  }
  return "";
}

// By the ending; of standard input, by the content.
bool is_robot(const std::string& file, std::string_view bytes) {
  if (file != "-") return io::ending_of(file) == ".urdf";
  const std::string_view head = bytes.substr(0, 4096);
  return io::trimmed(head).starts_with('<') && head.find("<robot") != std::string_view::npos;
}

// Has the file an ending of a format of the plane, read or not? Of standard input, by the content.
bool is_planar(const std::string& file, std::string_view bytes) {
  if (file == "-") return !io::mesh_format_of_content(bytes);
  constexpr std::array<std::string_view, 22> foreign{
      ".kicad_pcb", ".shp",  ".dbf", ".kml", ".kmz", ".gml", ".gpx", ".gz",  ".dxf", ".dwg", ".gds",
      ".oas",       ".gpkg", ".fgb", ".gbr", ".gtl", ".gbl", ".gko", ".drl", ".def", ".lef", ".brd"};
  return io::is_planar(file) || std::find(foreign.begin(), foreign.end(), io::ending_of(file)) != foreign.end();
}

// Finds the mesh files of a robot as sunder scene does.
class MeshFiles {
 public:
  MeshFiles(const std::string& robot, const io::Packages& packages)
      : folder_(std::filesystem::path(robot).parent_path()), packages_(packages) {}

  // Nothing where it is not found.
  std::optional<std::string> file_of(const std::string& mesh) {
    try {
      std::string file = io::resolve_mesh(mesh, folder_, packages_).string();
      found_ += 1;
      return file;
    } catch (const Error& error) {
      if (missing_++ == 0) problem_ = error.what();
      return std::nullopt;
    }
  }

  // "3 of 4 meshes are there; the first that is not: ..". Empty where there are none.
  std::string text() const {
    const std::uint64_t all = found_ + missing_;
    if (all == 0) return "";
    if (missing_ == 0) return all == 1 ? "the mesh is there" : fmt::format("all {} meshes are there", all);
    return fmt::format("{} of {} are there; {}{}", found_, all == 1 ? "1 mesh" : fmt::format("{} meshes", all),
                       missing_ == 1 ? "the one that is not: " : "the first that is not: ", problem_);
  }

 private:
  std::filesystem::path folder_;
  const io::Packages& packages_;
  std::uint64_t found_ = 0, missing_ = 0;
  std::string problem_;
};

Json shape_json(const io::CollisionShape& shape, MeshFiles& meshes) {
  switch (shape.kind) {
    case io::ShapeKind::mesh: {
      const std::optional<std::string> file = meshes.file_of(shape.mesh);
      return {{"mesh", shape.mesh}, {"file", file ? Json(io::one_line(*file)) : Json(nullptr)}};
    }
    case io::ShapeKind::box: return {{"box", shape.size}};
    case io::ShapeKind::sphere: return {{"sphere", {{"radius", shape.radius}}}};
    case io::ShapeKind::cylinder:
    case io::ShapeKind::capsule: break;
  }
  return {{std::string(name_of(shape.kind)), {{"radius", shape.radius}, {"length", shape.length}}}};
}

Info describe_robot(const std::string& file, std::string_view bytes, const io::Packages& packages) {
  const io::Robot robot = io::parse_urdf(bytes, file);
  Info info;
  const std::string shown = io::one_line(file);
  info.json = {{"file", shown}, {"format", "URDF"}, {"name", robot.name}, {"root", robot.links[robot.root].name}};
  info.json["links"] = Json::array();
  info.json["joints"] = Json::array();
  const LeftOutList left_out(file, robot.left_out);
  if (!left_out.empty()) info.json["left_out"] = to_json(left_out);
  info.text = fmt::format("{}: URDF robot {} of {} and {}\n", shown, robot.name, count_of(robot.links.size(), "link"),
                          count_of(robot.joints.size(), "joint"));
  MeshFiles meshes(file, packages);
  std::size_t width = 0;
  for (const io::Link& link : robot.links) width = std::max(width, link.name.size());
  for (const io::Joint& joint : robot.joints) width = std::max(width, joint.name.size());

  for (const io::Link& link : robot.links) {
    Json shapes = Json::array();
    std::string list;
    for (const io::CollisionShape& shape : link.shapes) {
      shapes.push_back(shape_json(shape, meshes));
      list += (list.empty() ? "" : ", ") + (shape.kind == io::ShapeKind::mesh
                                                ? std::filesystem::path(shape.mesh).filename().string()
                                                : std::string(name_of(shape.kind)));
    }
    info.json["links"].push_back({{"name", link.name}, {"shapes", shapes}});
    info.text += fmt::format("  link   {:<{}}  {}\n", link.name, width, list.empty() ? "no shape" : list);
  }
  for (const io::Joint& joint : robot.joints) {
    const std::string& parent = robot.links[joint.parent].name;
    const std::string& child = robot.links[joint.child].name;
    info.json["joints"].push_back(
        {{"name", joint.name},
         {"type", type_name(joint.type)},
         {"parent", parent},
         {"child", child},
         {"lower", joint.lower},  // what is not finite is null
         {"upper", joint.upper},
         {"mimic", joint.mimic ? Json(robot.joints[joint.mimic->joint].name) : Json(nullptr)}});
    std::string range;
    if (joint.mimic)
      range = ", follows " + robot.joints[joint.mimic->joint].name;
    else if (std::isfinite(joint.upper))
      range = fmt::format(" from {} to {}", joint.lower, joint.upper);
    info.text += fmt::format("  joint  {:<{}}  {} to {}, {}{}\n", joint.name, width, parent, child,
                             type_name(joint.type), range);
  }
  if (const std::string found = meshes.text(); !found.empty()) info.add("meshes", found);
  if (!left_out.empty()) info.text += fmt::format("  not read: {}\n", left_out.text());
  return info;
}

// A file of JSON with the key of scenes; GeoJSON has a type, and certificates say what they are.
bool is_scene(const std::string& file, std::string_view bytes) {
  if (file != "-" && !io::is_scene_file(file)) return false;
  if (bytes.find("\"bodies\"") == std::string_view::npos || bytes.find("\"type\"") != std::string_view::npos)
    return false;
  return bytes.substr(0, 200).find("\"sunder_certificate\"") == std::string_view::npos;
}

Info describe_scene(const std::string& file, std::string_view bytes) {
  const std::string shown = io::one_line(file);
  const io::SceneFile scene = io::parse_scene_file(bytes, shown);
  Info info;
  info.json = {{"file", shown}, {"format", "scene"}, {"unit", scene.unit.empty() ? Json(nullptr) : Json(scene.unit)}};
  info.json["bodies"] = Json::array();
  info.json["allowed_pairs"] = Json::array();
  std::size_t width = 0, parts = 0;
  for (const io::SceneFile::Body& body : scene.bodies) {
    width = std::max(width, body.name.size());
    parts += body.parts.size();
  }
  info.text = fmt::format("{}: scene of {} and {}, {}\n", shown,
                          scene.bodies.size() == 1 ? "1 body" : fmt::format("{} bodies", scene.bodies.size()),
                          count_of(parts, "part"),
                          scene.unit.empty() ? "which names no unit of lengths" : "lengths in " + scene.unit);
  for (const io::SceneFile::Body& body : scene.bodies) {
    Json list = Json::array();
    std::string text;
    for (const io::SceneFile::Part& part : body.parts) {
      Json of_part{{"name", part.name}, {"shape", part.format}};
      text += (text.empty() ? "" : ", ") + (part.name.empty() ? "" : part.name + " (") +
              (part.mesh ? io::one_line(part.mesh->file) : part.format) + (part.name.empty() ? "" : ")");
      if (part.mesh) of_part["mesh"] = part.mesh->file;
      list.push_back(std::move(of_part));
    }
    info.json["bodies"].push_back({{"name", body.name}, {"parts", list}});
    info.text += fmt::format("  body   {:<{}}  {}\n", body.name, width, text);
  }
  for (const auto& [a, b] : scene.allowed) {
    const std::string &name_a = scene.bodies[a].name, &name_b = scene.bodies[b].name;
    info.json["allowed_pairs"].push_back({name_a, name_b});
    info.text += fmt::format("  may meet: {} and {}\n", name_a, name_b);
  }
  info.add("ask", "sunder scene");
  return info;
}

void add_surface(Info& info, const io::Mesh& mesh) {
  const SurfaceTold told = surface_told(solid::Mesh({mesh.vertices, mesh.polygon_begin, mesh.polygon_vertices}));
  info.json["surface"] = told.json;
  const char* key = "closed";
  for (const std::string& line : told.lines) info.add(std::exchange(key, ""), line);
}

Info describe_mesh(const std::string& file, std::string_view bytes) {
  io::Mesh mesh = io::parse_mesh(bytes, file, io::mesh_format(bytes, file));
  const std::uint64_t inner = io::drop_inner_vertices(mesh);
  const std::vector<std::string> remarks = mesh.remarks;
  const MeshBody object = io::body_of_mesh(mesh, file, false);
  const auto [low, high] = object.hull.box();
  const LeftOutList left_out(file, mesh.left_out);
  Info info{fmt::format("{}: {}\n", object.file, object.format), to_json(object)};
  if (!left_out.empty()) info.json["left_out"] = to_json(left_out);
  info.json["mesh"] = {{"vertices", mesh.vertices.size()},
                       {"in_use", object.mesh_vertices},
                       {"polygons", mesh.polygon_count()},
                       {"parts", mesh.parts.size()}};
  info.json["box"] = Json::array({to_json(low), to_json(high)});

  const std::string in_use =
      object.mesh_vertices < mesh.vertices.size() ? fmt::format(" ({} in use)", object.mesh_vertices) : "";
  info.add("holds", fmt::format("{} vertices{}, {}, {}", mesh.vertices.size(), in_use,
                                count_of(mesh.polygon_count(), "polygon"), count_of(mesh.parts.size(), "part")));
  if (inner > 0) info.add("", io::inner_vertices_text(inner));
  for (const std::string& remark : remarks) info.add("remark", remark);
  if (!remarks.empty()) info.json["remarks"] = remarks;
  info.add("shape", object.shape == io::BodyShape::convex ? "exactly convex"
                    : object.shape == io::BodyShape::hull ? "not exactly convex: " + object.why_hull
                                                          : "a set of points");
  if (object.departure) info.add("", departure_text(object));
  if (mesh.polygon_count() > 0) add_surface(info, mesh);
  if (!left_out.empty()) info.add("", "not read: " + left_out.text());
  info.add("hull", fmt::format("{}, {} vertices, {}", dimension_name(object.hull.dimension()),
                               object.hull.vertices().size(), count_of(object.hull.facet_count(), "facet")));
  info.add("box", about(low) + " to " + about(high));
  return info;
}

// What the first record of a CSV file says that its rows are.
enum class Table { segments, objects, circles, half_planes, triples };

Table table_of(std::string_view text, const std::string& file) {
  io::CsvReader reader(text, file);
  if (!reader.next()) return Table::segments;
  if (!io::geometry_column(reader.fields()).empty()) return Table::segments;
  std::vector<std::string> names;
  for (const std::string_view field : reader.fields()) names.push_back(io::in_small_letters(field));
  const auto has = [&](std::initializer_list<const char*> needed) {
    return std::all_of(needed.begin(), needed.end(),
                       [&](const char* n) { return std::find(names.begin(), names.end(), n) != names.end(); });
  };
  if (has({"x", "y", "r"})) return Table::circles;
  if (has({"a", "b", "c"})) return Table::half_planes;
  if (has({"x1", "y1", "x2", "y2"}) && names[0] != "kind") return Table::segments;
  double value = 0;
  const bool numbers = io::parse_number(names[0], value) == nullptr;
  if (numbers && names.size() == 3) return Table::triples;
  return numbers && names.size() > 3 ? Table::segments : Table::objects;
}

Info info_of(const std::string& file, std::string_view format, const std::string& holds, const std::string& ask) {
  const std::string shown = io::one_line(file);
  Info info{fmt::format("{}: {}\n", shown, format), {{"file", shown}, {"format", format}}};
  info.add("holds", holds);
  info.add("ask", ask);
  return info;
}

Info describe_rows(const std::string& file, std::string_view text, const io::TripleKind& kind, const char* what,
                   const char* ask) {
  const std::size_t rows = io::parse_triples(text, file, kind).rows.size();
  Info info = info_of(file, "CSV", count_of(rows, "row") + " of " + what, ask);
  info.json["rows"] = rows;
  info.add_systems(file, std::array{io::SystemOfFile{io::system_beside(file), {}}});
  return info;
}

Info describe_objects(const std::string& file, std::string_view text) {
  io::PlanarFile objects = io::parse_planar_objects(text, file, true);
  objects.declare(io::system_beside(file));
  Info info = info_of(file, objects.format, count_of(objects.objects.size(), "object"), "sunder pair");
  info.add_systems(file, objects.systems());
  info.json["objects"] = Json::array();
  for (const io::PlanarObject& object : objects.objects) {
    info.json["objects"].push_back({{"name", object.name}, {"shape", name_of(object.kind)}});
  }
  return info;
}

Info describe_lines(const std::string& file, std::string_view text) {
  io::LineFile lines =
      io::parse_lines(text, file, {.drop_z = true, .points = true, .leave_out = true, .keep_broken = true});
  if (lines.format != "GeoJSON") lines.declare(io::system_beside(file));
  const auto count_points = [](std::span<const planar::Segment> segments) {
    const auto is_point = [](const planar::Segment& s) { return s.a == s.b; };
    return static_cast<std::size_t>(std::count_if(segments.begin(), segments.end(), is_point));
  };
  const std::span all(lines.segments);
  std::size_t polygons = 0, in_rings = 0, points = count_points(all);
  for (std::size_t r = 0; r < lines.rings.size(); ++r) {
    polygons += r == 0 || lines.rings[r].polygon != lines.rings[r - 1].polygon;
    in_rings += lines.rings[r].count;
    points -= count_points(all.subspan(lines.rings[r].first, lines.rings[r].count));
  }
  const std::size_t others = lines.segments.size() - in_rings - points;
  std::string holds = count_of(lines.features.size(), "feature");
  const auto add = [&](std::size_t count, const std::string& what) {
    if (count > 0) holds += (holds.find(':') == std::string::npos ? ": " : ", ") + what;
  };
  add(polygons, fmt::format("{} of {} and {}", count_of(polygons, "polygon"), count_of(lines.rings.size(), "ring"),
                            count_of(in_rings, "edge")));
  add(others, count_of(others, "segment") + (polygons > 0 ? " of lines" : ""));
  add(points, count_of(points, "point"));
  add(lines.broken.size(), count_of(lines.broken.size(), "ring") + " that are open or have no area");
  const LeftOutList left_out(file, lines.left_out);
  if (!left_out.empty()) holds += "; not read: " + left_out.text();
  Info info = info_of(file, lines.format, holds,
                      polygons > 0 ? "sunder polygons, simple, kernel, region, segments"
                      : others > 0 ? "sunder segments"
                                   : "sunder pair");
  info.add_systems(file, lines.systems);
  info.json["features"] = lines.features.size();
  info.json["polygons"] = polygons;
  info.json["rings"] = lines.rings.size();
  info.json["segments"] = in_rings + others;
  info.json["points"] = points;
  if (!left_out.empty()) info.json["left_out"] = to_json(left_out);
  if (!lines.remarks.empty()) info.json["remarks"] = lines.remarks;
  if (lines.segments.empty()) return info;
  Box2 box = box_of(planar::sorted(lines.segments[0]));
  for (const planar::Segment& s : lines.segments) box = hull(box, box_of(planar::sorted(s)));
  info.add("box", place_text(box.low) + " to " + place_text(box.high));
  info.json["box"] = {{box.low.x, box.low.y}, {box.high.x, box.high.y}};
  for (const std::string& remark : lines.remarks) info.add("remark", remark);
  return info;
}

Info describe_planar(const std::string& file, std::string_view text) {
  if (text.substr(0, 200).find("\"sunder_certificate\"") != std::string::npos) {
    io::fail_file(file, "this is a certificate; ask sunder verify");
  }
  io::refuse_foreign(text, file);
  const bool is_table = io::lines_format(text, file) == io::LinesFormat::csv;
  switch (is_table ? table_of(text, file) : Table::segments) {
    case Table::circles:
      return describe_rows(file, text, io::circle_rows, "x,y,r: circles", "sunder circles, region --of circles");
    case Table::half_planes:
      return describe_rows(file, text, io::half_plane_rows, "a,b,c: half-planes", "sunder region");
    case Table::triples:
      return describe_rows(file, text, io::circle_rows, "three numbers: circles, or half-planes",
                           "sunder circles, region");
    case Table::objects: return describe_objects(file, text);
    case Table::segments: break;
  }
  return describe_lines(file, text);
}

Info describe(const std::string& file, const io::Packages& packages) {
  const std::string bytes = io::read_file(file);
  if (is_robot(file, bytes)) return describe_robot(file, bytes, packages);
  if (is_scene(file, bytes)) return describe_scene(file, bytes);
  return is_planar(file, bytes) ? describe_planar(file, bytes) : describe_mesh(file, bytes);
}

Report run(const InfoCall& call, Talk& talk) {
  if (call.files.empty() && !call.formats) {
    throw Error(ErrorCode::bad_call, "no file is named; name files, or ask for --formats", "info");
  }
  Report report{.verb = "info", .answer = "read"};
  if (call.formats) {
    Json list = Json::array();
    std::string text;
    for (const Format& f : formats) {
      list.push_back({{"name", f.name}, {"endings", f.endings}, {"access", f.access}, {"what", f.what}});
      text += fmt::format("{:<12} {:<10} {:<14} {}\n", f.name, f.endings, f.access, f.what);
    }
    report.add("formats", std::move(list), std::move(text));
  }
  const io::Packages packages = packages_of(talk, call.packages);
  for (const std::string& file : call.files) {
    Info info = describe(file, packages);
    report.objects.push_back(std::move(info.json));
    report.tell(std::move(info.text));
  }
  report.notes = talk.notes();
  return report;
}

}  // namespace

Verb info_verb() {
  const auto call = std::make_shared<InfoCall>();
  return {"info",
          "What do these files contain? Which formats does the program read?",
          codes_of_reports,
          {{"FILE", &call->files, "meshes, sets of points, robots, scenes, or planar files (WKT, GeoJSON, CSV)", ""},
           package_option(call->packages),
           {"--formats", &call->formats, "list all formats that the program reads or writes"},
           json_option(call->json)},
          [call](Talk& talk) { return run(*call, talk); }};
}

}  // namespace sunder::ask
