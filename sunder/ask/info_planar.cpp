#include <sunder/ask/info_planar.h>
#include <sunder/ask/left_out.h>

#include <sunder/io/csv.h>
#include <sunder/io/file.h>
#include <sunder/io/foreign.h>
#include <sunder/io/lines.h>
#include <sunder/io/planar_objects.h>
#include <sunder/io/text.h>
#include <sunder/io/triples.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sunder::ask {

namespace {

// What the first record of a CSV file says that its rows are.
enum class Table { segments, objects, circles, half_planes, triples };

Table table_of(std::string_view text, const std::string& file) {
  io::CsvReader reader(text, file);
  if (!reader.next()) return Table::segments;
  std::vector<std::string> names;
  for (const std::string_view field : reader.fields()) {
    std::string& name = names.emplace_back(field);
    for (char& c : name) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
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
  return {fmt::format("{}: {}\n  holds   {}\n  ask     {}\n", shown, format, holds, ask),
          {{"file", shown}, {"format", format}}};
}

Info describe_rows(const std::string& file, std::string_view text, Table table) {
  const io::TripleKind& kind = table == Table::half_planes ? io::half_plane_rows : io::circle_rows;
  const std::size_t rows = io::parse_triples(text, file, kind).rows.size();
  const std::string columns = table == Table::circles       ? " of x,y,r: circles"
                              : table == Table::half_planes ? " of a,b,c: half-planes"
                                                            : " of three numbers: circles, or half-planes";
  Info info = info_of(file, "CSV", count_of(rows, "row") + columns,
                      table == Table::circles       ? "sunder circles, region --of circles"
                      : table == Table::half_planes ? "sunder region"
                                                    : "sunder circles, region");
  info.json["rows"] = rows;
  return info;
}

Info describe_objects(const std::string& file, std::string_view text) {
  const io::PlanarFile objects = io::parse_planar_objects(text, file, true);
  Info info = info_of(file, objects.format, count_of(objects.objects.size(), "object"), "sunder pair");
  info.json["objects"] = Json::array();
  for (const io::PlanarObject& object : objects.objects) {
    info.json["objects"].push_back({{"name", object.name}, {"shape", name_of(object.kind)}});
  }
  return info;
}

Info describe_lines(const std::string& file, std::string_view text) {
  io::LineOptions options;
  options.drop_z = options.points = options.leave_out = options.keep_broken = true;
  const io::LineFile lines = io::parse_lines(text, file, options);
  std::size_t polygons = 0, in_rings = 0, points = 0;
  for (std::size_t r = 0; r < lines.rings.size(); ++r) {
    polygons += r == 0 || lines.rings[r].polygon != lines.rings[r - 1].polygon;
    in_rings += lines.rings[r].count;
  }
  std::size_t ring = 0;
  for (std::size_t k = 0; k < lines.segments.size();) {
    if (ring < lines.rings.size() && lines.rings[ring].first == k) {
      k += lines.rings[ring++].count;
    } else {
      points += lines.segments[k].a == lines.segments[k].b;
      ++k;
    }
  }
  const std::size_t others = lines.segments.size() - in_rings - points;
  std::string holds = count_of(lines.features.size(), "feature");
  const auto add = [&](std::size_t count, const std::string& what) {
    if (count > 0) holds += (holds.find(':') == std::string::npos ? ": " : ", ") + what;
  };
  add(polygons, fmt::format("{} of {} and {}", count_of(polygons, "polygon"), count_of(lines.rings.size(), "ring"),
                            count_of(in_rings, "edge")));
  add(others, count_of(others, polygons > 0 ? "segment of lines" : "segment"));
  add(points, count_of(points, "point"));
  add(lines.broken.size(), count_of(lines.broken.size(), "ring") + " that are open or have no area");
  LeftOutList left_out(true);
  left_out.add(file, lines.left_out, "");
  if (!left_out.empty()) holds += "; not read: " + left_out.text();
  Info info = info_of(file, lines.format, holds,
                      polygons > 0 ? "sunder polygons, simple, kernel, region, segments"
                      : others > 0 ? "sunder segments"
                                   : "sunder pair");
  info.json["features"] = lines.features.size();
  info.json["polygons"] = polygons;
  info.json["rings"] = lines.rings.size();
  info.json["segments"] = in_rings + others;
  info.json["points"] = points;
  if (!left_out.empty()) info.json["left_out"] = to_json(left_out);
  if (!lines.remarks.empty()) info.json["remarks"] = lines.remarks;
  if (lines.segments.empty()) return info;
  std::array<double, 4> box{lines.segments[0].a.x, lines.segments[0].a.y, lines.segments[0].a.x, lines.segments[0].a.y};
  for (const planar::Segment& s : lines.segments) {
    for (const Point2& p : {s.a, s.b}) {
      box = {std::min(box[0], p.x), std::min(box[1], p.y), std::max(box[2], p.x), std::max(box[3], p.y)};
    }
  }
  info.text += fmt::format("  box     ({:.10g}, {:.10g}) to ({:.10g}, {:.10g})\n", box[0], box[1], box[2], box[3]);
  info.json["box"] = {{box[0], box[1]}, {box[2], box[3]}};
  for (const std::string& remark : lines.remarks) info.text += fmt::format("  remark  {}\n", remark);
  return info;
}

}  // namespace

bool is_of_the_plane(const std::string& file) {
  constexpr std::array<std::string_view, 14> foreign{".kicad_pcb", ".shp", ".dbf", ".kml", ".kmz",  ".gml", ".gpx",
                                                     ".dxf",       ".dwg", ".gds", ".oas", ".gpkg", ".fgb", ".gz"};
  return io::is_planar(file) || std::find(foreign.begin(), foreign.end(), io::ending_of(file)) != foreign.end();
}

Info describe_planar(const std::string& file, std::string_view text) {
  if (text.substr(0, 200).find("\"sunder_certificate\"") != std::string::npos) {
    io::fail_file(file, "this is a certificate; ask sunder verify");
  }
  io::refuse_foreign(text, file);
  if (io::lines_format(text, file) != io::LinesFormat::csv) return describe_lines(file, text);
  const Table table = table_of(text, file);
  if (table == Table::segments) return describe_lines(file, text);
  return table == Table::objects ? describe_objects(file, text) : describe_rows(file, text, table);
}

}  // namespace sunder::ask
