#include <sunder/io/mesh/frame_internal.h>
#include <sunder/io/mesh/mesh_builder.h>
#include <sunder/io/mesh/mesh_formats.h>
#include <sunder/io/text/bytes.h>
#include <sunder/io/text/json_internal.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

namespace sunder::io {
namespace {

using nlohmann::json;

constexpr std::size_t glb_header = 12, chunk_header = 8;
constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;  // "JSON", "BIN"

// Extensions that change neither the points nor where they are.
constexpr std::array<std::string_view, 3> harmless{"KHR_materials_", "KHR_texture_", "KHR_lights_"};

// componentType
constexpr std::uint64_t type_byte = 5121, type_short = 5123, type_int = 5125, type_float = 5126;

// mode of a primitive
enum : std::uint64_t { mode_points, mode_lines, mode_loop, mode_line_strip, mode_triangles, mode_strip, mode_fan };

class GltfParser {
 public:
  GltfParser(std::string_view bytes, std::string_view place, const FileReader& read)
      : place_(place), read_(read), builder_(place), budget_(bytes.size(), place) {
    is_binary_ = bytes.starts_with("glTF");
    document_ = parse_json(is_binary_ ? json_of_binary(bytes) : bytes, place);
    if (!document_.is_object()) fail("is JSON, but no object; this is no glTF");
  }

  Mesh parse() {
    check_version();
    refuse_extensions();
    const std::vector<std::uint64_t> tops = top_nodes();
    if (tops.empty() && list("nodes").empty()) {
      for (std::uint64_t m = 0; m < list("meshes").size(); ++m) add_mesh(m, NodeFrame{}, "");
    }
    add_nodes(tops);
    builder_.join_equal_vertices();
    return builder_.finish(is_binary_ ? "glTF (binary, metres, Y up)" : "glTF (metres, Y up)");
  }

 private:
  // Throws Error bad_file; the remedy is the same for all.
  [[noreturn]] void fail(const std::string& text) const { fail_file(place_, text + "; export the mesh again"); }

  std::string_view json_of_binary(std::string_view bytes) {
    const auto number = [&](std::size_t at) {
      return load<std::uint32_t>(bytes.data() + at, ByteOrder::little_endian);
    };
    if (bytes.size() < glb_header + chunk_header)
      fail_byte(place_, bytes.size(), "the file ends inside its header; export or copy it again");
    if (number(4) != 2)
      fail_byte(place_, 4, fmt::format("is binary glTF {}, and 2 is read; export it as glTF 2.0", number(4)));
    if (number(8) != bytes.size()) {
      fail_byte(place_, 8,
                fmt::format("the header promises {} bytes, but the file has {}; export or copy it again", number(8),
                            bytes.size()));
    }
    std::string_view found;
    for (std::size_t at = glb_header; at < bytes.size();) {
      if (bytes.size() - at < chunk_header || number(at) > bytes.size() - at - chunk_header) {
        fail_byte(place_, at, "the file ends inside a chunk; export or copy it again");
      }
      const std::string_view chunk = bytes.substr(at + chunk_header, number(at));
      const std::uint32_t type = number(at + 4);
      if (at == glb_header && type != json_chunk) fail_byte(place_, at, "the first chunk is not JSON; export it again");
      if (type == json_chunk && at == glb_header) found = chunk;
      if (type == binary_chunk && !binary_) binary_ = chunk;
      at += chunk_header + chunk.size();
    }
    return found;
  }

  // The list of this name; an empty one where there is none.
  const json& list(const char* name) const { return list_of(document_, name); }

  const json& list_of(const json& object, const char* name) const {
    static const json empty = json::array();
    const auto found = object.find(name);
    if (found == object.end()) return empty;
    if (!found->is_array()) fail(fmt::format("{} is no list", name));
    return *found;
  }

  // The object of this number in the list.
  const json& item(const char* name, std::uint64_t number) const {
    const json& all = list(name);
    if (number >= all.size()) fail(fmt::format("{}[{}] is named, but there are {}", name, number, all.size()));
    const json& found = all[number];
    if (!found.is_object()) fail(fmt::format("{}[{}] is no object", name, number));
    return found;
  }

  std::uint64_t whole(const json& value, const char* name) const {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > MeshBuilder::largest_vertex) {
      fail(fmt::format("{} is no number from 0 to 2^31", name));
    }
    return value.get<std::uint64_t>();
  }

  std::optional<std::uint64_t> whole_of(const json& object, const char* name) const {
    const auto found = object.find(name);
    if (found == object.end()) return std::nullopt;
    return whole(*found, name);
  }

  std::uint64_t whole_there(const json& object, const char* name) const {
    const auto value = whole_of(object, name);
    if (!value) fail(fmt::format("{} is missing", name));
    return *value;
  }

  std::string text_of(const json& object, const char* name) const {
    const auto found = object.find(name);
    if (found == object.end()) return "";
    if (!found->is_string()) fail(fmt::format("{} is no text", name));
    return found->get<std::string>();
  }

  // As many finite numbers, where they are there.
  template <std::size_t n>
  std::optional<std::array<double, n>> numbers(const json& object, const char* name) const {
    if (!object.contains(name)) return std::nullopt;
    const json& given = list_of(object, name);
    if (given.size() != n) fail(fmt::format("{} has {} numbers, expected {}", name, given.size(), n));
    std::array<double, n> values{};
    for (std::size_t i = 0; i < n; ++i) {
      if (!given[i].is_number()) fail(fmt::format("{} holds what is no number", name));
      values[i] = given[i].get<double>();
    }
    return values;
  }

  void check_version() const {
    const auto asset = document_.find("asset");
    if (asset == document_.end() || !asset->is_object()) fail("has no \"asset\"; this is no glTF");
    const std::string version = text_of(*asset, "version");
    if (!version.starts_with("2.")) fail(fmt::format("is glTF {}, and 2.0 is read", quote(version)));
  }

  void refuse_extensions() const {
    for (const json& name : list("extensionsRequired")) {
      const std::string word = name.is_string() ? name.get<std::string>() : "";
      if (std::none_of(harmless.begin(), harmless.end(), [&](std::string_view h) { return word.starts_with(h); })) {
        fail(fmt::format("needs the extension {}, which is not read", quote(word)));
      }
    }
  }

  // The roots of the scene that is shown; where there is none, all nodes that are no children.
  std::vector<std::uint64_t> top_nodes() const {
    std::vector<std::uint64_t> tops;
    const auto scene = whole_of(document_, "scene");
    if (scene || !list("scenes").empty()) {
      for (const json& node : list_of(item("scenes", scene.value_or(0)), "nodes")) tops.push_back(whole(node, "nodes"));
      return tops;
    }
    const std::size_t count = list("nodes").size();
    std::vector<bool> is_child(count);
    for (std::size_t n = 0; n < count; ++n) {
      for (const json& child : list_of(item("nodes", n), "children")) {
        if (const std::uint64_t c = whole(child, "children"); c < count) is_child[c] = true;
      }
    }
    for (std::size_t n = 0; n < count; ++n) {
      if (!is_child[n]) tops.push_back(n);
    }
    return tops;
  }

  // Nodes form trees; each is visited once, parents first, in the order of the file.
  void add_nodes(const std::vector<std::uint64_t>& tops) {
    std::vector<bool> seen(list("nodes").size());
    std::vector<std::pair<std::uint64_t, NodeFrame>> open;
    for (auto top = tops.rbegin(); top != tops.rend(); ++top) open.push_back({*top, NodeFrame{}});
    while (!open.empty()) {
      const auto [number, outer] = open.back();
      open.pop_back();
      const json& node = item("nodes", number);
      if (seen[number]) fail(fmt::format("nodes[{}] has two parents", number));
      seen[number] = true;
      const NodeFrame frame = compose(outer, frame_of(node, number));
      if (const auto mesh = whole_of(node, "mesh")) {
        if (node.contains("skin")) {
          builder_.leave_out("skinned mesh", 1);
        } else {
          refuse_shaping(node, fmt::format("nodes[{}]", number));
          add_mesh(*mesh, frame, text_of(node, "name"));
        }
      }
      const json& children = list_of(node, "children");
      for (std::size_t c = children.size(); c-- > 0;) open.push_back({whole(children[c], "children"), frame});
    }
  }

  // Morphs, and many instances by an extension.
  void refuse_shaping(const json& object, const std::string& name) const {
    for (const json& weight : list_of(object, "weights")) {
      if (!weight.is_number() || weight.get<double>() != 0) fail(name + " is morphed, which is not read");
    }
    const auto extensions = object.find("extensions");
    if (extensions != object.end() && extensions->is_object() && extensions->contains("EXT_mesh_gpu_instancing")) {
      fail(name + " has the extension EXT_mesh_gpu_instancing, which is not read");
    }
  }

  NodeFrame frame_of(const json& node, std::uint64_t number) const {
    if (const auto m = numbers<16>(node, "matrix")) {  // column by column
      if ((*m)[3] != 0 || (*m)[7] != 0 || (*m)[11] != 0 || (*m)[15] != 1) {
        fail(fmt::format("the matrix of nodes[{}] is no affine map", number));
      }
      NodeFrame frame;
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) frame.turn[3 * row + column] = (*m)[4 * column + row];
        frame.move[row] = (*m)[12 + row];
      }
      return frame;
    }
    NodeFrame frame;
    if (const auto translation = numbers<3>(node, "translation")) frame = moved_by(*translation);
    if (const auto q = numbers<4>(node, "rotation")) {
      if (std::all_of(q->begin(), q->end(), [](double entry) { return entry == 0; })) {
        fail(fmt::format("the rotation of nodes[{}] is 0 0 0 0", number));
      }
      frame = compose(frame, turned_by_quaternion(*q));
    }
    if (const auto scale = numbers<3>(node, "scale")) {
      if ((*scale)[0] == 0 || (*scale)[1] == 0 || (*scale)[2] == 0) {
        fail(fmt::format("a scale of 0 in nodes[{}] makes the mesh flat", number));
      }
      frame = compose(frame, scaled_by(*scale));
    }
    return frame;
  }

  void add_mesh(std::uint64_t number, const NodeFrame& frame, const std::string& name) {
    budget_.spend(1);
    const json& mesh = item("meshes", number);
    refuse_shaping(mesh, fmt::format("meshes[{}]", number));
    builder_.begin_part(name.empty() ? text_of(mesh, "name") : name);
    std::map<std::uint64_t, Points> added;  // of accessors, which primitives may share
    for (const json& primitive : list_of(mesh, "primitives")) {
      budget_.spend(1);
      if (!primitive.is_object()) fail("a primitive is no object");
      const auto attributes = primitive.find("attributes");
      if (attributes == primitive.end() || !attributes->is_object()) fail("a primitive has no attributes");
      const std::uint64_t position = whole_there(*attributes, "POSITION");
      auto points = added.find(position);
      if (points == added.end()) points = added.emplace(position, add_points(position, frame)).first;
      add_primitive(primitive, points->second);
    }
  }

  struct Points {
    std::uint32_t first = 0, count = 0;
  };

  // An accessor's bytes: element i begins at data + i * stride, and all are there.
  struct View {
    const char* data = nullptr;
    std::size_t stride = 0, count = 0;
    std::uint64_t type = 0;
  };

  View view_of(std::uint64_t number, std::string_view shape) {
    const json& accessor = item("accessors", number);
    const auto failed = [&](const std::string& text) { fail(fmt::format("accessors[{}] {}", number, text)); };
    if (accessor.contains("sparse")) failed("is sparse, which is not read");
    if (text_of(accessor, "type") != shape)
      failed(fmt::format("is {}, expected {}", quote(text_of(accessor, "type")), shape));
    View view;
    view.type = whole_there(accessor, "componentType");
    view.count = whole_there(accessor, "count");
    std::size_t size = shape == "VEC3" ? 3 : 1;
    switch (view.type) {
      case type_byte: break;
      case type_short: size *= 2; break;
      case type_int:
      case type_float: size *= 4; break;
      default: failed("holds numbers of a type that is not read");
    }
    if (!accessor.contains("bufferView")) failed("has no bufferView");
    const std::uint64_t which = whole_there(accessor, "bufferView");
    const json& part = item("bufferViews", which);
    const std::string_view buffer = buffer_of(whole_there(part, "buffer"));
    const std::uint64_t begin = whole_of(part, "byteOffset").value_or(0), length = whole_there(part, "byteLength");
    if (begin > buffer.size() || length > buffer.size() - begin) {
      fail(fmt::format("bufferViews[{}] ends beyond its buffer of {} bytes", which, buffer.size()));
    }
    const std::uint64_t offset = whole_of(accessor, "byteOffset").value_or(0);
    view.stride = whole_of(part, "byteStride").value_or(size);
    if (view.stride < size)
      fail(fmt::format("bufferViews[{}] has a stride of {} bytes, less than {}", which, view.stride, size));
    if (view.count > 0 &&
        (offset > length || size > length - offset || view.count - 1 > (length - offset - size) / view.stride)) {
      failed(fmt::format("promises {} entries, more than its view of {} bytes holds", view.count, length));
    }
    if (view.count > 0) view.data = buffer.data() + begin + offset;
    return view;
  }

  Points add_points(std::uint64_t number, const NodeFrame& frame) {
    const View view = view_of(number, "VEC3");
    if (view.type != type_float) fail(fmt::format("accessors[{}]: positions are not of single precision", number));
    budget_.spend(view.count);
    const Points points{builder_.vertex_count(), static_cast<std::uint32_t>(view.count)};
    for (std::size_t i = 0; i < view.count; ++i) {
      const char* from = view.data + i * view.stride;
      std::array<double, 3> c{};
      for (std::size_t k = 0; k < 3; ++k) {
        c[k] = static_cast<double>(load<float>(from + 4 * k, ByteOrder::little_endian));
        if (!std::isfinite(c[k])) fail(fmt::format("accessors[{}]: point {} is not finite", number, i));
      }
      const Point3 placed = frame({c[0], c[1], c[2]});
      if (!std::isfinite(placed.x) || !std::isfinite(placed.y) || !std::isfinite(placed.z)) {
        fail(fmt::format("accessors[{}]: a node moves point {} beyond the doubles", number, i));
      }
      builder_.add_vertex(placed);
    }
    return points;
  }

  std::vector<std::uint32_t> indices_of(const json& primitive, const Points& points) {
    std::vector<std::uint32_t> indices;
    const auto number = whole_of(primitive, "indices");
    if (!number) {
      budget_.spend(points.count);
      for (std::uint32_t i = 0; i < points.count; ++i) indices.push_back(i);
      return indices;
    }
    const View view = view_of(*number, "SCALAR");
    if (view.type == type_float) fail(fmt::format("accessors[{}]: indices are no whole numbers", *number));
    budget_.spend(view.count);
    indices.reserve(view.count);
    for (std::size_t i = 0; i < view.count; ++i) {
      const char* from = view.data + i * view.stride;
      const std::uint32_t index = view.type == type_byte    ? load<std::uint8_t>(from, ByteOrder::little_endian)
                                  : view.type == type_short ? load<std::uint16_t>(from, ByteOrder::little_endian)
                                                            : load<std::uint32_t>(from, ByteOrder::little_endian);
      if (index >= points.count) {
        fail(fmt::format("accessors[{}] names vertex {}, but there are {} (counted from 0)", *number, index,
                         points.count));
      }
      indices.push_back(index);
    }
    return indices;
  }

  void add_primitive(const json& primitive, const Points& points) {
    const std::uint64_t mode = whole_of(primitive, "mode").value_or(mode_triangles);
    const std::vector<std::uint32_t> indices = indices_of(primitive, points);
    const std::size_t count = indices.size();
    switch (mode) {
      case mode_points: return builder_.leave_out("point", count);
      case mode_lines: return builder_.leave_out("line", count / 2);
      case mode_loop: return builder_.leave_out("line", count);
      case mode_line_strip: return builder_.leave_out("line", count > 0 ? count - 1 : 0);
      case mode_triangles:
        if (count % 3 != 0) fail(fmt::format("triangles have {} corners, which is no multiple of 3", count));
        break;
      case mode_strip:
      case mode_fan: break;
      default: fail(fmt::format("the mode {} of a primitive is not known", mode));
    }
    for (std::size_t i = 2; i < count; i += mode == mode_triangles ? 3u : 1u) {
      std::array<std::uint32_t, 3> triangle{indices[i - 2], indices[i - 1], indices[i]};
      if (mode == mode_fan) triangle[0] = indices[0];
      if (mode == mode_strip && i % 2 == 1) std::swap(triangle[0], triangle[1]);
      for (const std::uint32_t corner : triangle) builder_.add_corner(points.first + corner);
      builder_.end_polygon();
    }
  }

  std::string_view buffer_of(std::uint64_t number) {
    const auto known = buffers_.find(number);
    if (known != buffers_.end()) return known->second;
    const json& buffer = item("buffers", number);
    const std::uint64_t length = whole_there(buffer, "byteLength");
    std::string_view bytes;
    if (!buffer.contains("uri")) {
      if (number != 0 || !binary_) fail(fmt::format("buffers[{}] has no uri", number));
      bytes = *binary_;
    } else {
      bytes = owned_.emplace(number, bytes_of(text_of(buffer, "uri"))).first->second;
    }
    if (length > bytes.size()) {
      fail(fmt::format("buffers[{}] promises {} bytes, but has {}", number, length, bytes.size()));
    }
    return buffers_.emplace(number, bytes.substr(0, length)).first->second;
  }

  std::string bytes_of(const std::string& uri) {
    if (uri.starts_with("data:")) {
      const std::size_t comma = uri.find(',');
      if (comma == std::string::npos || !std::string_view(uri).substr(0, comma).ends_with(";base64")) {
        fail("a data: URI of a buffer is not in base64");
      }
      return from_base64(std::string_view(uri).substr(comma + 1));
    }
    const std::string name = without_percent(uri);
    const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
    if (name.find(':') != std::string::npos || name.find('\0') != std::string::npos || path.empty() ||
        path.is_absolute() || *path.begin() == "..") {
      fail(fmt::format("a buffer is the file {}, which is not within the folder of the mesh", quote(uri)));
    }
    if (!read_) fail(fmt::format("a buffer is the file {}, and only this file is given", quote(uri)));
    std::string bytes = read_(path);
    budget_.add_bytes(bytes.size());
    return bytes;
  }

  std::string from_base64(std::string_view text) const {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    while (text.ends_with('=')) text.remove_suffix(1);
    std::string bytes;
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
      const std::size_t digit = digits.find(c);
      if (digit == std::string_view::npos) fail("a data: URI of a buffer is no base64");
      bits = (bits << 6 | static_cast<std::uint32_t>(digit)) & 0xFFFF;
      held += 6;
      if (held < 8) continue;
      held -= 8;
      bytes.push_back(static_cast<char>(bits >> held & 0xFF));
    }
    return bytes;
  }

  // "a%20b" is "a b".
  std::string without_percent(std::string_view uri) const {
    const auto digit = [&](char c) {
      const std::size_t value = std::string_view("0123456789abcdef").find(in_small_letters({&c, 1}));
      if (value == std::string_view::npos) fail(fmt::format("the name {} of a buffer is no URI", quote(uri)));
      return static_cast<unsigned>(value);
    };
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
      if (uri[i] != '%' || i + 2 >= uri.size()) {
        name.push_back(uri[i]);
        continue;
      }
      name.push_back(static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2])));
      i += 2;
    }
    return name;
  }

  std::string_view place_;
  const FileReader& read_;
  MeshBuilder builder_;
  InstanceBudget budget_;
  bool is_binary_ = false;
  std::optional<std::string_view> binary_;  // the chunk that is buffers[0]
  json document_;
  std::unordered_map<std::uint64_t, std::string> owned_;
  std::unordered_map<std::uint64_t, std::string_view> buffers_;
};

}  // namespace

Mesh parse_gltf(std::string_view bytes, std::string_view place, const FileReader& read) {
  return GltfParser(bytes, place, read).parse();
}

}  // namespace sunder::io
