// sunder info FILE...: what is in a file?
#include <sunder/ask/info_planar.h>
#include <sunder/ask/objects.h>
#include <sunder/ask/report.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/mesh.h>
#include <sunder/io/text.h>
#include <sunder/io/urdf.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace sunder::ask {

namespace {

struct Call {
  std::vector<std::string> files;
  bool formats = false;
  bool json = false;
};

struct Format {
  const char *name, *endings, *access, *what;
};

constexpr std::array<Format, 10> formats{
    {{"OBJ", ".obj", "read, write", "Wavefront; objects are parts of a body"},
     {"STL", ".stl", "read, write", "binary (read; single precision) and ASCII; equal points are joined"},
     {"PLY", ".ply", "read, write", "ASCII, and binary of either byte order (read)"},
     {"OFF", ".off", "read, write", "Object File Format, ASCII"},
     {"URDF", ".urdf", "read", "robots: links with meshes and boxes, joints with limits"},
     {"CSV", ".csv", "read", "segments: x1,y1,x2,y2; circles: x,y,r; half-planes: a,b,c; others by name"},
     {"WKT", ".wkt", "read", "lines and polygons, a geometry on each line; their edges are segments"},
     {"GeoJSON", ".geojson", "read", "lines and polygons; their edges are segments"},
     {"KiCad board", ".kicad_pcb", "read", "tracks by layer and net; arcs as polylines"},
     {"certificate", ".json", "write, verify", "proofs: docs/claims.md"}}};

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

bool is_planar(const std::string& file, std::string_view bytes) {
  return file == "-" ? !io::mesh_format_of_content(bytes) : is_of_the_plane(file);
}

// A finite limit as a number, another as null.
Json limit(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Info describe_robot(const std::string& file, std::string_view bytes) {
  const io::Robot robot = io::parse_urdf(bytes, file);
  Info info;
  const std::string shown = io::one_line(file);
  info.json = {{"file", shown}, {"format", "URDF"}, {"name", robot.name}, {"root", robot.links[robot.root].name}};
  info.json["links"] = Json::array();
  info.json["joints"] = Json::array();
  LeftOutList left_out(true);
  left_out.add(file, robot.left_out, "");
  if (!left_out.empty()) info.json["left_out"] = to_json(left_out);
  info.text = fmt::format("{}: URDF robot {} of {} and {}\n", shown, robot.name, count_of(robot.links.size(), "link"),
                          count_of(robot.joints.size(), "joint"));
  std::size_t width = 0;
  for (const io::Link& link : robot.links) width = std::max(width, link.name.size());
  for (const io::Joint& joint : robot.joints) width = std::max(width, joint.name.size());

  for (const io::Link& link : robot.links) {
    Json shapes = Json::array();
    std::string list;
    for (const io::CollisionShape& shape : link.shapes) {
      shapes.push_back(shape.mesh.empty() ? Json{{"box", shape.size}} : Json{{"mesh", shape.mesh}});
      list += (list.empty() ? "" : ", ") +
              (shape.mesh.empty() ? "box" : std::filesystem::path(shape.mesh).filename().string());
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
         {"lower", limit(joint.lower)},
         {"upper", limit(joint.upper)},
         {"mimic", joint.mimic ? Json(robot.joints[joint.mimic->joint].name) : Json(nullptr)}});
    std::string range;
    if (joint.mimic)
      range = ", follows " + robot.joints[joint.mimic->joint].name;
    else if (std::isfinite(joint.upper))
      range = fmt::format(" from {} to {}", joint.lower, joint.upper);
    info.text += fmt::format("  joint  {:<{}}  {} to {}, {}{}\n", joint.name, width, parent, child,
                             type_name(joint.type), range);
  }
  if (!left_out.empty()) info.text += fmt::format("  not read: {}\n", left_out.text());
  return info;
}

Info describe_mesh(const std::string& file, std::string_view bytes) {
  const io::Mesh mesh = io::parse_mesh(bytes, file, io::mesh_format(bytes, file));
  const MeshBody object = io::body_of_mesh(mesh, file, false);
  const auto [low, high] = object.hull.box();
  LeftOutList left_out(true);
  left_out.add(file, mesh.left_out, "");
  Info info;
  info.json = to_json(object);
  if (!left_out.empty()) info.json["left_out"] = to_json(left_out);
  info.json["mesh"] = {{"vertices", mesh.vertices.size()},
                       {"in_use", object.mesh_vertices},
                       {"polygons", mesh.polygon_count()},
                       {"parts", mesh.parts.size()}};
  info.json["box"] = Json::array({to_json(low), to_json(high)});

  info.text = fmt::format("{}: {}\n", object.file, object.format);
  info.text +=
      fmt::format("  holds   {} vertices{}, {}, {}\n", mesh.vertices.size(),
                  object.mesh_vertices < mesh.vertices.size() ? fmt::format(" ({} in use)", object.mesh_vertices) : "",
                  count_of(mesh.polygon_count(), "polygon"), count_of(mesh.parts.size(), "part"));
  const std::string why = object.shape == io::BodyShape::convex ? "exactly convex"
                          : object.shape == io::BodyShape::hull ? "not exactly convex: " + object.why_hull
                                                                : "a set of points";
  info.text += fmt::format("  shape   {}\n", why);
  if (object.departure) info.text += fmt::format("          {}\n", departure_text(object));
  if (!left_out.empty()) info.text += fmt::format("          not read: {}\n", left_out.text());
  info.text += fmt::format("  hull    {}, {} vertices, {}\n", dimension_name(object.hull.dimension()),
                           object.hull.vertices().size(), count_of(object.hull.facet_count(), "facet"));
  info.text += fmt::format("  box     {} to {}\n", about(low), about(high));
  return info;
}

Info describe(const std::string& file) {
  const std::string bytes = io::read_file(file);
  if (is_robot(file, bytes)) return describe_robot(file, bytes);
  return is_planar(file, bytes) ? describe_planar(file, bytes) : describe_mesh(file, bytes);
}

int run(const Call& call) {
  if (call.files.empty() && !call.formats) {
    throw Error(ErrorCode::bad_call, "no file is named; name files, or ask for --formats", "info");
  }
  Json json = envelope("info", "read");
  std::string text;
  if (call.formats) {
    json["formats"] = Json::array();
    for (const Format& f : formats) {
      json["formats"].push_back({{"name", f.name}, {"endings", f.endings}, {"access", f.access}, {"what", f.what}});
      text += fmt::format("{:<12} {:<10} {:<14} {}\n", f.name, f.endings, f.access, f.what);
    }
  }
  for (const std::string& file : call.files) {
    Info info = describe(file);
    json["objects"].push_back(std::move(info.json));
    text += info.text;
  }
  call.json ? print(to_text(json)) : print_for_people(text);
  return exit_code::no;
}

}  // namespace

Verb info_verb() {
  const auto call = std::make_shared<Call>();
  return {"info",
          "What is in these files? Which formats are read?",
          codes_of_reports,
          {{"FILE", &call->files, "meshes, sets of points, robots, files of the plane", ""},
           {"--formats", &call->formats, "list the formats that are in"},
           json_option(call->json)},
          [call] { return run(*call); }};
}

}  // namespace sunder::ask
