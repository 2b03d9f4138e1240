#include <sunder/base/names.h>
#include <sunder/io/plane/lines.h>
#include <sunder/io/plane/planar_objects.h>
#include <sunder/io/text/csv.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/foreign.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace sunder::io {

namespace {

using PlanarKind = PlanarObject::Kind;

// The kinds that a word names; a polygon has no word in CSV, and those of WKT are read in lines.h.
std::optional<PlanarKind> kind_of(std::string_view word) {
  const std::string small = in_small_letters(word.substr(0, 20));
  if (small == "halfplane") return PlanarKind::half_plane;
  for (const PlanarKind kind :
       {PlanarKind::point, PlanarKind::segment, PlanarKind::line, PlanarKind::ray, PlanarKind::half_plane}) {
    if (small == name_of(kind)) return kind;
  }
  return std::nullopt;
}

double number_of(std::string_view word, std::string_view place, std::uint32_t line) {
  double value = 0;
  if (const char* problem = parse_number(word, value))
    fail_line(place, line, fmt::format("{} {}", quote(word), problem));
  return value;
}

void require_two_points(const PlanarObject& object, std::string_view place) {
  if (!object.unbounded() || object.vertices[0] != object.vertices[1]) return;
  fail_line(place, object.line,
            fmt::format("the two points of this {} are equal; give two different ones", name_of(object.kind)));
}

// CSV in which each record is an object, or a vertex.
class Csv {
 public:
  Csv(std::string_view text, std::string_view place, bool drop_z, PlanarFile& file)
      : reader_(text, place), place_(place), drop_z_(drop_z), file_(file) {}

  // False where the file is of neither form; then nothing was read.
  bool parse() {
    if (!reader_.next()) return false;
    file_.format = "CSV";
    const CsvReader::Fields& fields = reader_.fields();
    if (!geometry_column(fields).empty()) return false;
    const bool names_kinds = in_small_letters(fields[0].substr(0, 20)) == "kind";
    if (names_kinds || kind_of(fields[0])) {
      if (names_kinds) check_names();
      parse_objects(names_kinds);
      return true;
    }
    const auto is = [](std::string_view name) {
      return [name](std::string_view field) { return in_small_letters(field.substr(0, 2)) == name; };
    };
    const bool named = are_names(fields, 2) && std::any_of(fields.begin(), fields.end(), is("x")) &&
                       std::any_of(fields.begin(), fields.end(), is("y"));
    if (fields.size() != 2 && !named) return false;
    parse_vertices();
    return true;
  }

 private:
  // The line of names of a file of kinds.
  void check_names() const {
    const CsvReader::Fields& names = reader_.fields();
    const bool points = names.size() > 1 && in_small_letters(names[1]) == "x";
    const std::vector<std::string_view> order = points ? std::vector<std::string_view>{"kind", "x", "y"}
                                                       : std::vector<std::string_view>{"kind", "x1", "y1", "x2", "y2"};
    for (std::size_t k = 0; k < std::min(names.size(), order.size()); ++k) {
      if (in_small_letters(names[k]) == order[k]) continue;
      reader_.fail(fmt::format("column {} is named {}; the order is kind,x1,y1,x2,y2,name", k + 1, quote(names[k])));
    }
  }

  double number(std::size_t k) const {
    const std::string_view word = reader_.fields()[k];
    double value = 0;
    if (const char* problem = parse_number(word, value)) reader_.fail(fmt::format("{} {}", quote(word), problem));
    return value;
  }

  void parse_objects(bool skip_first) {
    do {
      if (!std::exchange(skip_first, false)) add_object();
    } while (reader_.next());
    if (file_.objects.empty()) fail_file(place_, "has a line of names only; give objects behind it");
  }

  void add_object() {
    const CsvReader::Fields& fields = reader_.fields();
    const std::optional<PlanarKind> kind = kind_of(fields[0]);
    if (!kind) {
      reader_.fail(fmt::format("{} is no kind; give point, segment, line, ray or half-plane", quote(fields[0])));
    }
    const std::size_t points = *kind == PlanarKind::point ? 1 : 2, needed = 1 + 2 * points;
    if (fields.size() < needed || fields.size() > needed + 1) {
      reader_.fail(fmt::format("has {} fields; give {},{} and, if you like, a name", fields.size(), name_of(*kind),
                               points == 1 ? "x,y" : "x1,y1,x2,y2"));
    }
    PlanarObject object{*kind, one_line(fields.size() > needed ? fields[needed] : ""), reader_.line(), {}};
    for (std::size_t k = 0; k < points; ++k) object.vertices.push_back({number(1 + 2 * k), number(2 + 2 * k)});
    require_two_points(object, place_);
    if (object.name.empty()) object.name = std::to_string(file_.objects.size() + 1);
    if (object.kind == PlanarKind::segment && object.vertices[0] == object.vertices[1]) {
      object.kind = PlanarKind::point;
      object.vertices.pop_back();
    }
    file_.objects.push_back(std::move(object));
  }

  void parse_vertices() {
    const CsvColumns columns{{"x", "y"}, {"r", "radius"}, "vertices"};
    const std::string no_name;
    CsvTable table(columns, no_name, no_name);
    const bool names = table.begin(reader_, place_, drop_z_);
    PlanarObject object{PlanarKind::polygon, "1", 0, {}};
    for (bool more = !names || reader_.next(); more; more = reader_.next()) {
      if (!names && reader_.fields().size() != 2) {
        reader_.fail(fmt::format("has {} fields; give two, x and y, as in the lines before", reader_.fields().size()));
      }
      table.check_count(reader_);
      if (object.vertices.empty()) object.line = reader_.line();
      object.vertices.push_back({table.number(reader_, 0), table.number(reader_, 1)});
    }
    if (object.vertices.empty()) fail_file(place_, "has a line of names only; give vertices behind it");
    if (object.vertices.size() > 1 && object.vertices.front() == object.vertices.back()) object.vertices.pop_back();
    object.kind = object.vertices.size() == 1   ? PlanarKind::point
                  : object.vertices.size() == 2 ? PlanarKind::segment
                                                : PlanarKind::polygon;
    file_.objects.push_back(std::move(object));
  }

  CsvReader reader_;
  std::string_view place_;
  bool drop_z_;
  PlanarFile& file_;
};

// The points between parentheses that are all of the text.
std::vector<Point2> points_of(std::string_view text, std::string_view place, std::uint32_t line, bool drop_z) {
  text = trimmed(text);
  if (!text.starts_with('(') || !text.ends_with(')')) {
    fail_line(place, line,
              fmt::format("{} stands where points in parentheses are expected, as in (0 0, 1 2)", quote(text)));
  }
  text = text.substr(1, text.size() - 2);
  std::vector<Point2> points;
  for (bool more = true; more;) {
    const std::size_t comma = std::min(text.find(','), text.size());
    more = comma < text.size();
    std::string_view numbers = trimmed(text.substr(0, comma));
    text.remove_prefix(std::min(comma + 1, text.size()));
    std::vector<double> x;
    while (!numbers.empty()) {
      const std::size_t blank = std::min(numbers.find_first_of(blanks), numbers.size());
      x.push_back(number_of(numbers.substr(0, blank), place, line));
      numbers = trimmed(numbers.substr(blank));
    }
    if (x.size() < 2 || x.size() > 4) fail_line(place, line, "a point has two numbers, parted by a blank");
    if (x.size() > 2 && !drop_z) fail_line(place, line, "has a third coordinate; to ignore it, give --drop-z");
    points.push_back({x[0], x[1]});
  }
  return points;
}

// Takes the lines with words of ours out of WKT: blanks stand in their place, so that lines keep their numbers.
std::string take_unbounded(std::string_view text, std::string_view place, bool drop_z, PlanarFile& file) {
  std::string rest(text);
  for_each_line(text, [&](std::string_view words, std::uint32_t number) {
    const auto is_letter = [](char c) { return ('A' <= c && c <= 'Z') || ('a' <= c && c <= 'z') || c == '-'; };
    const auto end = static_cast<std::size_t>(std::find_if_not(words.begin(), words.end(), is_letter) - words.begin());
    const std::optional<PlanarKind> kind = kind_of(words.substr(0, end));
    if (!kind || *kind == PlanarKind::point || *kind == PlanarKind::segment) return;
    PlanarObject object{*kind, {}, number, points_of(words.substr(end), place, number, drop_z)};
    if (object.vertices.size() != 2) {
      fail_line(place, number,
                fmt::format("a {} has two points; {} are given", name_of(*kind), object.vertices.size()));
    }
    require_two_points(object, place);
    file.objects.push_back(std::move(object));
    rest.replace(static_cast<std::size_t>(words.data() - text.data()), words.size(), words.size(), ' ');
  });
  return rest;
}

// What lines.h reads. A feature that is no object here has its problem.
void parse_bounded(std::string_view text, std::string_view place, bool drop_z, PlanarFile& file) {
  LineOptions options;
  options.drop_z = drop_z;
  options.points = options.leave_out = options.keep_broken = true;
  LineFile lines = parse_lines(text, place, options);
  file.format = std::move(lines.format);
  file.remarks = std::move(lines.remarks);
  file.left_out = std::move(lines.left_out);
  std::size_t segment = 0, ring = 0, broken = 0;
  for (std::uint32_t feature = 0; feature < lines.features.size(); ++feature) {
    const std::size_t first = segment, first_ring = ring, first_broken = broken;
    const auto& segments = lines.segments;
    while (segment < segments.size() && lines.source[segment].feature == feature) ++segment;
    while (ring < lines.rings.size() && lines.rings[ring].first < segment) ++ring;
    while (broken < lines.broken.size() && lines.broken[broken].feature == feature) ++broken;
    if (segment == first && broken == first_broken) continue;  // it holds nothing
    PlanarObject object{PlanarKind::segment, lines.features[feature], 0, {}};
    object.line = segment > first ? lines.source[first].line : lines.broken[first_broken].line;
    if (!lines.system.empty()) object.system = lines.systems[lines.system[feature]].system;  // of a board there is none
    if (broken > first_broken) {
      object.kind = PlanarKind::polygon;
      object.problem = fmt::format("{}; {}", lines.broken[first_broken].what, lines.broken[first_broken].remedy);
    } else if (ring > first_ring) {
      object.kind = PlanarKind::polygon;
      if (lines.rings[first_ring].count != segment - first) {
        object.problem = "has holes, or several parts; give one polygon without holes";
      }
    } else if (segment - first > 1) {
      object.problem = "has several segments; give a point, a segment or a polygon";
    } else if (segments[first].a == segments[first].b) {
      object.kind = PlanarKind::point;
    }
    if (object.problem.empty()) {
      for (std::size_t k = first; k < segment; ++k) object.vertices.push_back(segments[k].a);
      if (object.kind == PlanarKind::segment) object.vertices.push_back(segments[first].b);
    }
    file.objects.push_back(std::move(object));
  }
}

// Is there an object at all?
PlanarFile checked(PlanarFile file, std::string_view place) {
  if (std::none_of(file.objects.begin(), file.objects.end(),
                   [](const auto& object) { return object.problem.empty(); })) {
    require_object(file.objects.front(), place);
  }
  return file;
}

}  // namespace

std::string_view name_of(PlanarObject::Kind kind) {
  return name_in<PlanarKind::half_plane>({"point", "segment", "polygon", "line", "ray", "half-plane"}, kind);
}

bool is_planar(const std::filesystem::path& path) {
  const std::string ending = ending_of(path.string());
  constexpr std::array<std::string_view, 8> endings{".wkt",      ".csv",      ".geojson", ".json",
                                                    ".geojsonl", ".geojsons", ".ndjson",  ".jsonl"};
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

void require_object(const PlanarObject& object, std::string_view place) {
  if (object.problem.empty()) return;
  if (object.line > 0) fail_line(place, object.line, object.problem);
  fail_file(place, fmt::format("feature {}: {}", quote(object.name), object.problem));
}

PlanarFile parse_planar_objects(std::string_view text, std::string_view place, bool drop_z) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  refuse_foreign(text, place);
  PlanarFile file;
  const LinesFormat format = lines_format(text, place);
  if (format == LinesFormat::csv && Csv(text, place, drop_z, file).parse()) return file;
  if (format != LinesFormat::wkt) {
    parse_bounded(text, place, drop_z, file);
    return checked(std::move(file), place);
  }
  const std::string rest = take_unbounded(text, place, drop_z, file);
  if (file.objects.empty()) {
    parse_bounded(text, place, drop_z, file);
    return checked(std::move(file), place);
  }
  bool more = false;
  for_each_line(rest, [&](std::string_view, std::uint32_t) { more = true; });
  file.format = "WKT";
  if (more) parse_bounded(rest, place, drop_z, file);
  // In the order of the file, counted as it is read.
  std::sort(file.objects.begin(), file.objects.end(),
            [](const PlanarObject& p, const PlanarObject& q) { return p.line < q.line; });
  for (std::size_t i = 0; i < file.objects.size(); ++i) file.objects[i].name = std::to_string(i + 1);
  return file;
}

PlanarFile read_planar_objects(const std::filesystem::path& path, bool drop_z, InputFiles* inputs) {
  PlanarFile file = parse_planar_objects(read_file(path, inputs), path.string(), drop_z);
  const auto is_declared = [](const PlanarObject& object) { return object.system.declared(); };
  const bool is_known = std::all_of(file.objects.begin(), file.objects.end(), is_declared);
  if (file.format != "GeoJSON" && !is_known) file.declare(system_beside(path, inputs));
  return file;
}

std::vector<SystemOfFile> PlanarFile::systems() const {
  std::vector<SystemOfFile> all;
  for (const PlanarObject& object : objects) {
    const bool is_new =
        std::none_of(all.begin(), all.end(), [&](const SystemOfFile& s) { return s.system.id == object.system.id; });
    if (is_new) all.push_back({object.system, fmt::format("feature {}", quote(object.name))});
  }
  return all;
}

void PlanarFile::declare(const CoordinateSystem& system) {
  for (PlanarObject& object : objects) {
    if (!object.system.declared()) object.system = system;
  }
}

}  // namespace sunder::io
