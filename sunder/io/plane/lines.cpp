#include <sunder/base/error.h>
#include <sunder/io/plane/kicad.h>
#include <sunder/io/plane/lines.h>
#include <sunder/io/plane/lines_builder.h>
#include <sunder/io/plane/lines_geojson.h>
#include <sunder/io/text/csv.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/foreign.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace sunder::io {

namespace {

char upper(char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

// Is this a first line that names the columns of intervals, which are segments of the x-axis?
bool name_intervals(const CsvReader::Fields& fields) {
  const auto has = [&](std::string_view wanted) {
    return std::any_of(fields.begin(), fields.end(), [&](auto name) { return in_small_letters(name) == wanted; });
  };
  return are_names(fields, 2) && has("low") && has("high") && !has("x1");
}

void add_row(const CsvReader& reader, const CsvTable& table, bool are_intervals, LineBuilder& builder) {
  const double first = table.number(reader, 0), second = table.number(reader, 1);
  if (!are_intervals) return builder.add({first, second}, {table.number(reader, 2), table.number(reader, 3)});
  if (first > second) reader.fail("low is greater than high; an interval is from low to high");
  builder.add({first, 0}, {second, 0});
}

constexpr std::array<std::string_view, 7> read_kinds{
    "LINESTRING", "MULTILINESTRING", "POLYGON", "MULTIPOLYGON", "POINT", "MULTIPOINT", "GEOMETRYCOLLECTION"};
constexpr std::array<std::string_view, 10> other_kinds{
    "CIRCULARSTRING", "COMPOUNDCURVE", "CURVEPOLYGON",      "MULTICURVE", "MULTISURFACE",
    "CURVE",          "SURFACE",       "POLYHEDRALSURFACE", "TIN",        "TRIANGLE"};

bool is_letter(char c) { return 'A' <= upper(c) && upper(c) <= 'Z'; }

// Geometries in WKT, one after the other.
class Wkt {
 public:
  // line: of the file, on which the text begins.
  Wkt(std::string_view text, LineBuilder& builder, std::uint32_t line = 1)
      : rest_(text), size_(text.size()), builder_(builder), line_(line) {}

  // A geometry that is all of the text; its feature has begun.
  void parse_one() {
    begun_ = line_;
    geometry(true, 0);
    if (skip_blanks()) builder_.fail(fmt::format("{} stands after the geometry", quote(rest_of_line())));
  }

  void parse() {
    builder_.group_by_feature_or_ring();
    const auto& progress = builder_.options().progress;
    for (std::uint64_t number = 0; skip_blanks(); ++number) {
      if (progress && number % 16384 == 0) progress(1 - static_cast<double>(rest_.size()) / static_cast<double>(size_));
      begun_ = line_;
      builder_.begin_feature({}, line_);
      geometry(true, 0);
      const std::uint32_t last = line_;
      if (skip_blanks() && line_ == last) {
        builder_.fail(fmt::format("{} stands after the geometry", quote(rest_of_line())));
      }
    }
  }

 private:
  void geometry(bool whole, int depth) {
    if (depth == 100) builder_.fail("has collections nested 100 deep; unpack them");
    std::string type = word();
    if (whole && type == "SRID") {
      builder_.system(system_by_srid(srid()));
      type = word();
    }
    std::string tag = word();
    if (tag.empty()) tag = cut_tag(type);
    if (tag == "Z" || tag == "M" || tag == "ZM") tag = word();
    if (!tag.empty() && tag != "EMPTY") builder_.fail(fmt::format("{} after {} is not understood", quote(tag), type));
    const bool known = std::find(read_kinds.begin(), read_kinds.end(), type) != read_kinds.end();
    if (!known && std::find(other_kinds.begin(), other_kinds.end(), type) == other_kinds.end()) {
      builder_.fail(fmt::format("{} is not read here; give {}LINESTRING, MULTILINESTRING, POLYGON or MULTIPOLYGON",
                                type.empty() ? quote(rest_of_line()) : quote(type),
                                builder_.options().points ? "POINT, " : ""));
    }
    if (tag == "EMPTY") return builder_.add_nothing();
    content(type, depth);
  }

  void content(const std::string& type, int depth) {
    const LineOptions& options = builder_.options();
    const bool line = type == "LINESTRING" || type == "MULTILINESTRING";
    if (type == "GEOMETRYCOLLECTION") {
      list([&] { geometry(false, depth + 1); });
    } else if (type == "POLYGON") {
      polygon(false);
    } else if (type == "MULTIPOLYGON") {
      list([&] { polygon(true); });
    } else if (type == "POINT" && options.points) {
      builder_.add_point(points());
    } else if (!line || !options.lines) {
      builder_.leave_out(type == "POINT" || type == "MULTIPOINT" ? "point" : line ? "line" : type);
      pass_list();
    } else if (type == "LINESTRING") {
      builder_.add_line(points());
    } else {
      list([&] {
        if (!empty_part()) builder_.add_line(points());
      });
    }
  }

  // Passes blanks and line breaks. Is there more?
  bool skip_blanks() {
    std::size_t at = 0;
    for (; at < rest_.size() && blanks_and_breaks.find(rest_[at]) != std::string_view::npos; ++at) {
      const bool second = rest_[at] == '\n' && last_was_return_;
      last_was_return_ = rest_[at] == '\r';
      if ((rest_[at] != '\n' && rest_[at] != '\r') || second) continue;
      builder_.at_line(++line_);
    }
    if (at > 0) rest_.remove_prefix(at);
    if (rest_.empty()) return false;
    last_was_return_ = false;
    return true;
  }

  std::string_view rest_of_line() const { return rest_.substr(0, rest_.find_first_of("\r\n")); }

  std::string word() {
    skip_blanks();
    std::string word;
    while (!rest_.empty() && is_letter(rest_[0])) {
      word += upper(rest_[0]);
      rest_.remove_prefix(1);
    }
    return word;
  }

  // Behind the "SRID" of "SRID=4326;".
  std::int64_t srid() {
    const bool equals = take('=');
    const std::size_t end = std::min(rest_.find(';'), rest_.size());
    std::int64_t number = 0;
    if (!equals || end == rest_.size() || !parse_integer(trimmed(rest_.substr(0, end)), number)) {
      builder_.fail("SRID is not followed by =, a number and a semicolon; write them, or leave SRID out");
    }
    rest_.remove_prefix(end + 1);
    return number;
  }

  // The tag that is written to the type without a blank, as in POLYGONZ, cut off it.
  static std::string cut_tag(std::string& type) {
    for (const std::string_view tag : {"ZM", "Z", "M"}) {
      for (const std::string_view known : read_kinds) {
        if (type.size() != known.size() + tag.size() || !type.starts_with(known) || !type.ends_with(tag)) continue;
        type = known;
        return std::string(tag);
      }
    }
    return {};
  }

  bool take(char c) {
    if (!skip_blanks() || rest_[0] != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  void expect(char c) {
    if (take(c)) return;
    if (rest_.empty()) {
      builder_.at_line(begun_);
      builder_.fail(fmt::format("ends where '{}' is expected; is it cut off?", c));
    }
    builder_.fail(fmt::format("{} stands where '{}' is expected{}", quote(rest_of_line()), c,
                              line_ > begun_ ? fmt::format(", in the geometry that begins on line {}", begun_) : ""));
  }

  template <class Item>
  void list(const Item& item) {
    expect('(');
    do item();
    while (take(','));
    expect(')');
  }

  // A list of whatever kind.
  void pass_list() {
    expect('(');
    for (std::uint64_t open = 1; open > 0;) {
      const std::size_t end = std::min(rest_.find_first_of("()\r\n"), rest_.size());
      rest_.remove_prefix(end);
      skip_blanks();
      if (rest_.empty()) expect(')');
      if (rest_[0] == '(') ++open;
      if (rest_[0] == ')') --open;
      if (rest_[0] == '(' || rest_[0] == ')') rest_.remove_prefix(1);
    }
  }

  // Is the part of a geometry that begins here EMPTY?
  bool empty_part() {
    if (!is_empty()) return false;
    builder_.add_nothing();
    return true;
  }

  // Takes the word EMPTY, where one stands.
  bool is_empty() {
    if (!skip_blanks() || !is_letter(rest_[0])) return false;
    const std::string found = word();
    if (found != "EMPTY") builder_.fail(fmt::format("{} stands where '(' or EMPTY is expected", quote(found)));
    return true;
  }

  void polygon(bool several) {
    if (several && empty_part()) return;
    builder_.begin_polygon(several);
    list([&] {
      if (is_empty()) return builder_.add_empty_ring();
      builder_.begin_ring();
      builder_.add_ring(points());
    });
  }

  std::vector<Point2> points() {
    std::vector<Point2> points;
    list([&] {
      std::array<double, 5> x{};
      std::size_t count = 0;
      while (skip_blanks() && std::string_view(",()").find(rest_[0]) == std::string_view::npos && count < x.size()) {
        const std::size_t end = std::min(rest_.find_first_of(",() \t\r\n\f\v"), rest_.size());
        x[count++] = builder_.number(rest_.substr(0, end));
        rest_.remove_prefix(end);
      }
      if (rest_.empty()) expect(')');
      if (count < 2 || count > 4) builder_.fail("a point has two numbers, parted by a blank");
      builder_.check_dimension(count);
      points.push_back({x[0], x[1]});
    });
    return points;
  }

  static constexpr std::string_view blanks_and_breaks = " \t\r\n\f\v";

  std::string_view rest_;
  std::size_t size_;
  LineBuilder& builder_;
  std::uint32_t line_, begun_ = 1;
  bool last_was_return_ = false;
};

// CSV with a geometry in each record, behind the names.
void parse_geometries(CsvReader& reader, const std::string& column, LineBuilder& builder) {
  builder.file.format = "CSV with WKT";
  const CsvColumns columns{{column}, {}, "geometries"};
  const LineOptions& options = builder.options();
  const auto& names = reader.fields();
  const bool by_ring = options.group == "ring" && std::find(names.begin(), names.end(), "ring") == names.end();
  const std::string group = by_ring ? "" : options.group;
  CsvTable table(columns, options.name, group, options.properties);
  table.begin(reader, builder.place(), options.drop_z, true);
  if (!options.group.empty()) {
    builder.group_by(by_ring ? GroupBy::ring : table.groups() ? GroupBy::field : GroupBy::feature);
  }
  while (reader.next()) {
    table.check_count(reader);
    builder.begin_feature(table.name(reader), reader.line());
    if (!options.properties.empty()) builder.property_values(table.properties(reader));
    if (table.groups()) builder.group_value(std::string(table.group(reader)));
    const std::string_view geometry = table.field(reader, 0);
    if (is_hexadecimal_wkb(geometry)) reader.fail("the geometry is hexadecimal WKB; write WKT: SELECT ST_AsEWKT(geom)");
    geometry.empty() ? builder.add_nothing() : Wkt(geometry, builder, reader.line()).parse_one();
  }
}

void parse_csv(std::string_view text, LineBuilder& builder) {
  const CsvColumns of_segments{{"x1", "y1", "x2", "y2"}, {}, "segments"},
      of_intervals{{"low", "high"}, {}, "intervals"};
  const LineOptions& options = builder.options();
  std::optional<CsvTable> table;
  CsvReader reader(text, builder.place(), options.progress);
  bool are_intervals = false;
  while (reader.next()) {
    if (reader.is_first()) {
      const std::string geometry = geometry_column(reader.fields());
      if (!geometry.empty()) return parse_geometries(reader, geometry, builder);
      if (!options.lines) {
        reader.fail(
            "CSV has polygons in a column of WKT, named wkt, geometry or geom; for segments, ask sunder segments");
      }
      are_intervals = name_intervals(reader.fields());
      table.emplace(are_intervals ? of_intervals : of_segments, options.name, options.group, options.properties);
      const bool names = table->begin(reader, builder.place(), options.drop_z, true);
      if (!options.group.empty()) builder.group_by(table->groups() ? GroupBy::field : GroupBy::feature);
      if (names) continue;
    }
    table->check_count(reader);
    builder.begin_feature(table->name(reader), reader.line());
    if (!options.properties.empty()) builder.property_values(table->properties(reader));
    if (table->groups()) builder.group_value(std::string(table->group(reader)));
    add_row(reader, *table, are_intervals, builder);
  }
}

}  // namespace

LinesFormat lines_format(std::string_view text, std::string_view place) {
  const std::string ending = ending_of(place);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (ending == ".kicad_pcb" || text.starts_with("(kicad_")) return LinesFormat::kicad;
  if (ending == ".csv") return LinesFormat::csv;
  if (ending == ".wkt") return LinesFormat::wkt;
  if (ending == ".geojson" || ending == ".json") return LinesFormat::geojson;
  if (text.starts_with('{') || text.starts_with('[') || text.starts_with('\x1e')) return LinesFormat::geojson;
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  const bool is_table = line.find(',') < line.find('(');  // names of columns
  return !line.empty() && is_letter(line[0]) && !is_table ? LinesFormat::wkt : LinesFormat::csv;
}

LineFile parse_lines(std::string_view text, std::string_view place, const LineOptions& options) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    fail_file(place, "has nothing in it; give a file with lines");
  const LinesFormat format = lines_format(text, place);
  if (format == LinesFormat::kicad) {
    if (!options.lines) fail_file(place, "is a board of tracks, without polygons; ask sunder segments");
    if (!options.name.empty()) {
      throw Error(ErrorCode::bad_call, "tracks are named by their nets; leave the name out", one_line(place));
    }
    if (!options.properties.empty()) {
      throw Error(ErrorCode::bad_call, "a board has no properties to tell of; leave them out", one_line(place));
    }
    return parse_kicad(text, place, options);
  }
  refuse_foreign(text, place);
  LineBuilder builder(place, options);
  if (format == LinesFormat::geojson) {
    builder.file.format = "GeoJSON";
    parse_geojson(text, builder);
  } else if (format == LinesFormat::wkt) {
    builder.file.format = "WKT";
    Wkt(text, builder).parse();
  } else {
    builder.file.format = "CSV";
    parse_csv(text, builder);
  }
  const bool has_fields = builder.file.format != "WKT";
  if (!options.name.empty() && !has_fields) {
    throw Error(ErrorCode::bad_call, "WKT has no fields to name features by; leave it out", one_line(place));
  }
  if (!options.properties.empty() && !has_fields) {
    throw Error(ErrorCode::bad_call, "WKT has no properties to tell of; leave them out", one_line(place));
  }
  builder.tell_of_nothing();
  if (format != LinesFormat::geojson) builder.rest_in({});
  if (builder.file.segments.empty() && builder.file.broken.empty()) {
    const char* const wanted = options.points ? "objects" : options.lines ? "segments" : "polygons";
    fail_file(place, fmt::format("has no {0}; give a file with {0}", wanted));
  }
  return std::move(builder.file);
}

LineFile read_lines(const std::filesystem::path& path, const LineOptions& options) {
  LineFile file = parse_lines(read_file(path, options.inputs), path.string(), options);
  const auto is_declared = [](const SystemOfFile& s) { return s.system.declared(); };
  const bool is_known = std::all_of(file.systems.begin(), file.systems.end(), is_declared);
  if (file.format != "GeoJSON" && !is_known) file.declare(system_beside(path, options.inputs));
  return file;
}

void LineFile::declare(const CoordinateSystem& known) {
  if (!known.declared()) return;
  const auto is = [](const std::string& id) { return [&](const SystemOfFile& s) { return s.system.id == id; }; };
  const auto none = std::find_if(systems.begin(), systems.end(), is(""));
  if (none == systems.end()) return;
  const auto same = std::find_if(systems.begin(), systems.end(), is(known.id));
  none->system = known;
  if (same == systems.end()) return;
  // Each stands there once: what was not declared goes to the other one.
  const auto from = static_cast<std::uint32_t>(none - systems.begin()),
             to = static_cast<std::uint32_t>(same - systems.begin());
  for (std::uint32_t& s : system) {
    if (s == from) s = to;
    if (s > from) --s;
  }
  systems.erase(none);
}

void fail_group(std::string_view file, std::string_view group, std::string_view known) {
  throw Error(ErrorCode::bad_call,
              fmt::format("there is no field {} to group by; there are {}", quote(group), one_line(known)),
              one_line(file));
}

}  // namespace sunder::io
