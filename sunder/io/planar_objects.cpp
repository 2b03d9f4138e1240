#include <sunder/io/file.h>
#include <sunder/io/lines.h>
#include <sunder/io/planar_objects.h>
#include <sunder/io/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace sunder::io {

namespace {

std::string ending_of(std::string_view place) {
  std::string ending = std::filesystem::path(place).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// The lines of a CSV file whose first line with numbers has two of them; nothing for other files.
bool parse_vertices(std::string_view text, std::string_view place, PlanarFile& file) {
  PlanarObject object{PlanarObject::Kind::polygon, "1", 0, {}};
  std::uint32_t number = 0;
  while (!text.empty()) {
    ++number;
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty()) continue;
    std::array<std::string_view, 2> fields;
    std::size_t count = 0;
    for (std::size_t begin = 0; begin <= line.size(); ++count) {
      const std::size_t next = std::min(line.find_first_of(",;", begin), line.size());
      if (count < 2) fields[count] = trimmed(line.substr(begin, next - begin));
      begin = next + 1;
    }
    std::array<double, 2> xy{};
    const std::array problems{parse_number(fields[0], xy[0]), count > 1 ? parse_number(fields[1], xy[1]) : nullptr};
    if (object.vertices.empty() && object.line == 0 && problems[0] != nullptr && count == 2) {
      object.line = number;  // a line of names, perhaps; the next one must be numbers
      continue;
    }
    if (object.vertices.empty() && count != 2) return false;
    if (count != 2)
      fail_line(place, number, fmt::format("has {} fields; give two, x and y, as in the lines before", count));
    for (std::size_t k = 0; k < 2; ++k) {
      if (problems[k] != nullptr) fail_line(place, number, fmt::format("{} {}", quote(fields[k]), problems[k]));
    }
    if (object.vertices.empty()) object.line = number;
    object.vertices.push_back({xy[0], xy[1]});
  }
  if (object.vertices.empty()) return false;
  if (object.vertices.size() > 1 && object.vertices.front() == object.vertices.back()) object.vertices.pop_back();
  object.kind = object.vertices.size() == 1   ? PlanarObject::Kind::point
                : object.vertices.size() == 2 ? PlanarObject::Kind::segment
                                              : PlanarObject::Kind::polygon;
  file.objects.push_back(std::move(object));
  file.format = "CSV";
  return true;
}

}  // namespace

bool is_planar(const std::filesystem::path& path) {
  const std::string ending = ending_of(path.string());
  return ending == ".wkt" || ending == ".csv" || ending == ".geojson" || ending == ".json";
}

PlanarFile parse_planar_objects(std::string_view text, std::string_view place, bool drop_z) {
  PlanarFile file;
  if (ending_of(place) == ".csv" && parse_vertices(text, place, file)) return file;
  LineOptions options;
  options.drop_z = drop_z;
  options.points = true;
  LineFile lines = parse_lines(text, place, options);
  file.format = std::move(lines.format);
  file.remarks = std::move(lines.remarks);
  const auto fail = [&](std::uint32_t feature, std::uint32_t line, const std::string& what) {
    if (line > 0) fail_line(place, line, what);
    fail_file(place, fmt::format("feature {}: {}", quote(lines.features[feature]), what));
  };
  const bool csv = file.format == "CSV";
  std::size_t ring = 0;
  for (std::uint32_t s = 0; s < lines.segments.size();) {
    const auto [feature, line] = lines.source[s];
    std::uint32_t end = s + 1;
    while (!csv && end < lines.segments.size() && lines.source[end].feature == feature) ++end;
    PlanarObject object{PlanarObject::Kind::segment, lines.features[feature], line, {}};
    const bool is_ring = ring < lines.rings.size() && lines.rings[ring].first == s;
    if (is_ring) {
      if (lines.rings[ring].count != end - s) {
        fail(feature, line, "has holes, or several parts; give one polygon without holes");
      }
      ++ring;
      object.kind = PlanarObject::Kind::polygon;
      for (std::uint32_t k = s; k < end; ++k) object.vertices.push_back(lines.segments[k].a);
    } else {
      if (end - s != 1) fail(feature, line, "has several segments; give a point, a segment or a polygon");
      object.vertices = {lines.segments[s].a};
      if (lines.segments[s].a == lines.segments[s].b) {
        object.kind = PlanarObject::Kind::point;
      } else {
        object.vertices.push_back(lines.segments[s].b);
      }
    }
    file.objects.push_back(std::move(object));
    s = end;
  }
  return file;
}

PlanarFile read_planar_objects(const std::filesystem::path& path, bool drop_z) {
  return parse_planar_objects(read_file(path), path.string(), drop_z);
}

}  // namespace sunder::io
