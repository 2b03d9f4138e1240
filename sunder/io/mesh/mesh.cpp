#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh.h>
#include <sunder/io/mesh/mesh_formats.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/foreign.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/text_reader.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

namespace sunder::io {
namespace {

constexpr std::string_view remedy = "export the mesh as OBJ, STL, PLY, OFF, COLLADA, glTF, VRML or 3MF";

std::optional<MeshFormat> format_of_ending(const std::filesystem::path& path) {
  const std::string ending = ending_of(path.string());
  if (ending == ".obj") return MeshFormat::obj;
  if (ending == ".stl") return MeshFormat::stl;
  if (ending == ".ply") return MeshFormat::ply;
  if (ending == ".off") return MeshFormat::off;
  if (ending == ".dae") return MeshFormat::collada;
  if (ending == ".gltf" || ending == ".glb") return MeshFormat::gltf;
  if (ending == ".wrl" || ending == ".vrml") return MeshFormat::vrml;
  if (ending == ".3mf") return MeshFormat::three_mf;
  return std::nullopt;
}

// Does the file lie in the folder of the mesh, or below, when symbolic links are followed? That may be the folder of
// the mesh's name, or of the file that this is a link to.
bool is_within_folder_of(const std::filesystem::path& file, const std::filesystem::path& mesh) {
  namespace fs = std::filesystem;
  std::error_code problem;
  const fs::path real = fs::canonical(file, problem);
  if (problem) return true;  // it is not there: reading tells
  const auto holds = [&](const fs::path& folder) {
    const fs::path real_folder = fs::canonical(folder.empty() ? fs::path(".") : folder, problem);
    return std::mismatch(real_folder.begin(), real_folder.end(), real.begin(), real.end()).first == real_folder.end();
  };
  if (holds(mesh.parent_path())) return true;
  const fs::path real_mesh = fs::canonical(mesh, problem);
  return !problem && holds(real_mesh.parent_path());
}

bool is_any_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool has_in_head(std::string_view bytes, std::string_view text) {
  return bytes.substr(0, 4096).find(text) != std::string_view::npos;
}

}  // namespace

std::optional<MeshFormat> mesh_format_of_content(std::string_view bytes) {
  if (is_binary_stl(bytes)) return MeshFormat::stl;
  if (bytes.starts_with("glTF")) return MeshFormat::gltf;
  if (bytes.starts_with("#VRML V2.0 utf8")) return MeshFormat::vrml;
  if (is_3mf(bytes)) return MeshFormat::three_mf;
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  if (trimmed(bytes.substr(0, 4096)).starts_with('<') && has_in_head(bytes, "<COLLADA")) return MeshFormat::collada;
  if (trimmed(bytes.substr(0, 4096)).starts_with('{') && has_in_head(bytes, "\"asset\"")) return MeshFormat::gltf;
  TextReader reader(bytes, "", {.comments = true, .continued = false});
  const std::string_view word = reader.word_of_any_line();
  if (word == "ply") return MeshFormat::ply;
  if (is_off_header(word)) return MeshFormat::off;
  if (is_any_of(word, {"solid", "SOLID", "Solid"})) return MeshFormat::stl;
  if (is_any_of(word, {"v", "vn", "vt", "o", "g", "s", "mtllib", "usemtl"})) return MeshFormat::obj;
  return std::nullopt;
}

MeshFormat mesh_format(std::string_view bytes, std::string_view place) {
  const std::optional<MeshFormat> by_content = mesh_format_of_content(bytes), by_name = format_of_ending(place);
  if (by_content && !(by_name && by_content == MeshFormat::obj)) return *by_content;
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  if (const ForeignBody known = foreign_body(bytes); !known.what.empty()) {
    fail_file(place, foreign_text(known, place));
  }
  if (by_name == MeshFormat::three_mf && is_zip(bytes)) return *by_name;
  std::string_view other = foreign_format(bytes);
  if (bytes.starts_with("#VRML")) other = "VRML of another version than 2.0 in utf8";
  if (bytes.starts_with('{') && by_name != MeshFormat::gltf) other = "JSON";
  if (bytes.starts_with('<') && by_name != MeshFormat::collada) other = "XML of an unknown kind";
  if (!other.empty()) fail_file(place, fmt::format("this is {}, which is not read; {}", other, remedy));
  if (by_name) return *by_name;
  fail_file(place, fmt::format("no mesh by its first bytes or its ending; {}", remedy));
}

MeshFormat mesh_format_of_name(const std::filesystem::path& path) {
  const auto format = format_of_ending(path);
  if (format && *format <= MeshFormat::off) return *format;
  throw Error(ErrorCode::bad_call, "the ending names no mesh format; use .obj, .stl, .ply or .off",
              one_line(path.string()));
}

Mesh parse_mesh(std::string_view bytes, std::string_view place, MeshFormat format, PartsOf parts) {
  switch (format) {
    case MeshFormat::obj: return parse_obj(bytes, place, parts);
    case MeshFormat::stl: return parse_stl(bytes, place);
    case MeshFormat::ply: return parse_ply(bytes, place);
    case MeshFormat::off: return parse_off(bytes, place);
    case MeshFormat::collada: return parse_collada(bytes, place);
    case MeshFormat::gltf: return parse_gltf(bytes, place);
    case MeshFormat::vrml: return parse_vrml(bytes, place);
    case MeshFormat::three_mf: return parse_3mf(bytes, place);
  }
  throw Error(ErrorCode::bad_call, "unknown mesh format");
}

Mesh read_mesh(const std::filesystem::path& path, InputFiles* inputs, PartsOf parts) {
  const std::string bytes = read_file(path, inputs);
  const std::string place = path.string();
  const MeshFormat format = mesh_format(bytes, place);
  const FileReader read_beside = [&](const std::filesystem::path& name) {
    const std::filesystem::path beside = path.parent_path() / name;
    if (!is_within_folder_of(beside, path)) {
      fail_file(place, fmt::format("the buffer {} is a symbolic link to a file outside the folder of the mesh; copy "
                                   "the file there",
                                   quote(name.string())));
    }
    require_regular(beside);
    return read_file(beside, inputs);
  };
  Mesh mesh =
      format == MeshFormat::gltf ? parse_gltf(bytes, place, read_beside) : parse_mesh(bytes, place, format, parts);
  if (mesh.name.empty()) mesh.name = one_line(path.stem().string());
  return mesh;
}

std::vector<std::uint32_t> used_vertices(const Mesh& mesh) {
  std::vector<std::uint32_t> used(mesh.vertices.size());
  std::iota(used.begin(), used.end(), 0u);
  if (mesh.polygon_count() == 0) return used;
  std::vector<bool> in_polygon(mesh.vertices.size());
  for (const std::uint32_t v : mesh.polygon_vertices) in_polygon[v] = true;
  std::erase_if(used, [&](std::uint32_t v) { return !in_polygon[v]; });
  return used;
}

std::vector<Mesh> split_parts(const Mesh& mesh, std::vector<std::vector<std::uint32_t>>* used_by_part) {
  const bool polygons = mesh.polygon_count() > 0;
  const std::uint32_t total = polygons ? mesh.polygon_count() : static_cast<std::uint32_t>(mesh.vertices.size());
  std::vector<Mesh> parts;
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    const std::uint32_t begin = mesh.parts[i].first;
    const std::uint32_t end = i + 1 < mesh.parts.size() ? mesh.parts[i + 1].first : total;
    Mesh& part = parts.emplace_back();
    part.name = mesh.parts[i].name;
    part.format = mesh.format;
    part.remarks = mesh.remarks;
    part.parts.push_back({part.name, 0});
    if (!polygons) {
      part.vertices.assign(mesh.vertices.begin() + begin, mesh.vertices.begin() + end);
      if (used_by_part != nullptr) {
        std::vector<std::uint32_t>& used = used_by_part->emplace_back(end - begin);
        std::iota(used.begin(), used.end(), begin);
      }
      continue;
    }
    const auto corner = mesh.polygon_vertices.begin();
    part.polygon_vertices.assign(corner + mesh.polygon_begin[begin], corner + mesh.polygon_begin[end]);
    for (std::uint32_t p = begin; p < end; ++p) {
      part.polygon_begin.push_back(mesh.polygon_begin[p + 1] - mesh.polygon_begin[begin]);
    }
    std::vector<std::uint32_t> used = part.polygon_vertices;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const std::uint32_t v : used) part.vertices.push_back(mesh.vertices[v]);
    for (std::uint32_t& v : part.polygon_vertices) {
      v = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    }
    if (used_by_part != nullptr) used_by_part->push_back(std::move(used));
  }
  return parts;
}

}  // namespace sunder::io
