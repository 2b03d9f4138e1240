#include <sunder/io/file.h>
#include <sunder/io/lines.h>
#include <sunder/io/text.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace sunder::io {

namespace {

using planar::Segment;

constexpr std::string_view blanks = " \t\r\f\v";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

char upper(char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

// Adds lines and rings to the file under construction.
class Builder {
 public:
  explicit Builder(std::string_view place) : place_(place) {}

  void begin_feature(std::string name, std::uint32_t line) {
    if (file.features.size() == std::numeric_limits<std::uint32_t>::max()) fail("has too many features; split it");
    line_ = line;
    file.features.push_back(name.empty() ? std::to_string(file.features.size() + 1) : std::move(name));
  }

  void at_line(std::uint32_t line) { line_ = line; }

  void add(const Point2& a, const Point2& b) {
    file.segments.push_back({a, b});
    file.source.push_back({static_cast<std::uint32_t>(file.features.size() - 1), line_});
  }

  void begin_polygon() { ++polygons_; }

  void add_line(const std::vector<Point2>& points, bool ring) {
    if (ring && (points.size() < 4 || points.front() != points.back())) {
      fail(points.size() < 4 ? "a ring has fewer than four points; give at least three corners and the first again"
                             : "a ring does not end where it began; repeat its first point at its end");
    }
    if (points.size() < 2) fail("a line has fewer than two points; leave it out");
    if (ring) {
      file.rings.push_back({static_cast<std::uint32_t>(file.segments.size()),
                            static_cast<std::uint32_t>(points.size() - 1), polygons_ - 1});
    }
    for (std::size_t i = 1; i < points.size(); ++i) add(points[i - 1], points[i]);
  }

  [[noreturn]] void fail(const std::string& what) const {
    if (line_ > 0) fail_line(place_, line_, what);
    fail_file(place_, file.features.empty() ? what : fmt::format("feature {}: {}", quote(file.features.back()), what));
  }

  double number(std::string_view word) const {
    double value = 0;
    if (const char* problem = parse_number(word, value)) fail(fmt::format("{} {}", quote(word), problem));
    return value;
  }

  LineFile file;

 private:
  std::string_view place_;
  std::uint32_t line_ = 0, polygons_ = 0;
};

// Calls with each line that is not blank, and its number. A line ends with LF, CR LF or CR.
template <class OfLine>
void for_each_line(std::string_view text, const OfLine& of_line) {
  std::uint32_t number = 0;
  while (!text.empty()) {
    ++number;
    const std::size_t end = text.find_first_of("\r\n");
    const std::string_view line = trimmed(text.substr(0, end));
    if (!line.empty()) of_line(line, number);
    const bool two = end != std::string_view::npos && text.substr(end, 2) == "\r\n";
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + (two ? 2 : 1));
  }
}

// A field without blanks and without a pair of quotes around it.
std::string_view field_of(std::string_view text, const Builder& builder) {
  text = trimmed(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = trimmed(text.substr(1, text.size() - 2));
  if (text.find('"') != std::string_view::npos) {
    builder.fail(fmt::format("{} has a quote within; write fields without separators and quotes", quote(text)));
  }
  return text;
}

bool is_number(std::string_view word) {
  double value = 0;
  return parse_number(word, value) == nullptr;
}

// Is this a line of names? None of the first four is a number, and the first begins as names do.
bool are_names(const std::vector<std::string_view>& fields) {
  const std::size_t looked_at = std::min<std::size_t>(fields.size(), 4);
  if (std::any_of(fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(looked_at), is_number)) return false;
  std::string first(fields[0].substr(0, 8));
  std::transform(first.begin(), first.end(), first.begin(), upper);
  if (first.empty() || first == "NAN" || first == "INF" || first == "INFINITY") return false;
  return ('A' <= first[0] && first[0] <= 'Z') || first[0] == '_';
}

void parse_csv(std::string_view text, Builder& builder) {
  bool first = true;
  char separator = ',';
  for_each_line(text, [&](std::string_view line, std::uint32_t number) {
    if (first && line.find(';') != std::string_view::npos) separator = ';';
    builder.at_line(number);
    std::vector<std::string_view> fields;
    for (std::string_view rest = line;;) {
      const std::size_t end = rest.find(separator);
      fields.push_back(field_of(rest.substr(0, end), builder));
      if (end == std::string_view::npos) break;
      rest.remove_prefix(end + 1);
    }
    const bool names = first && are_names(fields);
    first = false;
    if (fields.size() < 4 || fields.size() > 5) {
      builder.fail(fmt::format("has {} fields; give x1,y1,x2,y2 and, if you like, an id", fields.size()));
    }
    if (names) {
      const char initial = upper(fields[0][0]);
      if (initial != 'X' && fields.size() == 5) {
        builder.fail(fmt::format("the first column is named {}; the order is x1,y1,x2,y2,id", quote(fields[0])));
      }
      return;
    }
    builder.begin_feature(fields.size() > 4 ? one_line(fields[4]) : std::string(), number);
    const Point2 from{builder.number(fields[0]), builder.number(fields[1])};
    const Point2 to{builder.number(fields[2]), builder.number(fields[3])};
    builder.add(from, to);
  });
}

// A geometry in WKT.
class Wkt {
 public:
  Wkt(std::string_view text, Builder& builder, bool drop_z) : rest_(text), builder_(builder), drop_z_(drop_z) {}

  void geometry() {
    const std::string type = word();
    const std::string tag = word();
    if (tag == "EMPTY") builder_.fail("is empty; leave the line out");
    if (!tag.empty() && tag != "Z" && tag != "M" && tag != "ZM") {
      builder_.fail(fmt::format("{} after {} is not understood", quote(tag), type));
    }
    if (type == "LINESTRING") {
      line(false);
    } else if (type == "MULTILINESTRING") {
      list([&] { line(false); });
    } else if (type == "POLYGON") {
      polygon();
    } else if (type == "MULTIPOLYGON") {
      list([&] { polygon(); });
    } else {
      builder_.fail(
          fmt::format("{} is not read here; give LINESTRING, MULTILINESTRING, POLYGON or MULTIPOLYGON", quote(type)));
    }
    if (!(rest_ = trimmed(rest_)).empty()) builder_.fail(fmt::format("{} stands after the geometry", quote(rest_)));
  }

 private:
  std::string word() {
    rest_ = trimmed(rest_);
    std::string word;
    while (!rest_.empty() && 'A' <= upper(rest_[0]) && upper(rest_[0]) <= 'Z') {
      word += upper(rest_[0]);
      rest_.remove_prefix(1);
    }
    return word;
  }

  bool take(char c) {
    rest_ = trimmed(rest_);
    if (rest_.empty() || rest_[0] != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  void expect(char c) {
    if (take(c)) return;
    builder_.fail(rest_.empty() ? fmt::format("ends where '{}' is expected; is it cut off?", c)
                                : fmt::format("{} stands where '{}' is expected", quote(rest_), c));
  }

  template <class Item>
  void list(const Item& item) {
    expect('(');
    do item();
    while (take(','));
    expect(')');
  }

  void polygon() {
    builder_.begin_polygon();
    list([&] { line(true); });
  }

  void line(bool ring) {
    std::vector<Point2> points;
    list([&] {
      rest_ = trimmed(rest_);
      const std::size_t end = std::min(rest_.find_first_of(",()"), rest_.size());
      std::string_view numbers = trimmed(rest_.substr(0, end));
      rest_.remove_prefix(end);
      std::vector<double> x;
      while (!numbers.empty()) {
        const std::size_t blank = std::min(numbers.find_first_of(blanks), numbers.size());
        x.push_back(builder_.number(numbers.substr(0, blank)));
        numbers = trimmed(numbers.substr(blank));
      }
      if (x.size() < 2 || x.size() > 4) builder_.fail("a point has two numbers, parted by a blank");
      if (x.size() > 2 && !drop_z_) builder_.fail("has a third coordinate; to ignore it, give --drop-z");
      points.push_back({x[0], x[1]});
    });
    builder_.add_line(points, ring);
  }

  std::string_view rest_;
  Builder& builder_;
  bool drop_z_;
};

class GeoJson {
 public:
  GeoJson(Builder& builder, bool drop_z) : builder_(builder), drop_z_(drop_z) {}

  void parse(std::string_view text, std::string_view place) {
    nlohmann::json top;
    try {
      top = nlohmann::json::parse(text);
    } catch (const nlohmann::json::exception& error) {  // not JSON, or a number beyond the doubles
      const std::string what = error.what();
      std::size_t at = what.find(" at line ");
      if (at == std::string::npos) at = what.find("] ") + 1;
      fail_file(place, "is not JSON that can be read: " + one_line(what.substr(at + 1)));
    }
    if (top.is_array() && !top.empty() && top[0].is_array()) {
      builder_.begin_feature({}, 0);
      builder_.begin_polygon();
      for (const nlohmann::json& ring : top) add_line(ring, true, true);
    } else if (type_of(top) == "FeatureCollection") {
      const auto features = top.find("features");
      if (features == top.end() || !features->is_array()) builder_.fail("the collection has no list \"features\"");
      for (const nlohmann::json& feature : *features) add_feature(feature);
    } else {
      add_feature(top);
    }
  }

 private:
  std::string type_of(const nlohmann::json& item) const {
    if (!item.is_object()) builder_.fail("is no GeoJSON: an object with a \"type\" is expected");
    const auto type = item.find("type");
    if (type == item.end() || !type->is_string()) builder_.fail("is no GeoJSON: an object has no \"type\"");
    return *type;
  }

  static std::string text_of(const nlohmann::json& value) {
    return value.is_string() ? one_line(value.get<std::string>()) : value.is_number() ? value.dump() : std::string();
  }

  void add_feature(const nlohmann::json& item) {
    const bool wrapped = type_of(item) == "Feature";
    std::string name;
    if (wrapped) {
      if (const auto id = item.find("id"); id != item.end()) name = text_of(*id);
      const auto properties = item.find("properties");
      for (const char* key : {"name", "NAME", "id"}) {
        if (!name.empty() || properties == item.end() || !properties->is_object()) break;
        if (const auto value = properties->find(key); value != properties->end()) name = text_of(*value);
      }
    }
    builder_.begin_feature(name, 0);
    if (!wrapped) return add_geometry(item);
    const auto geometry = item.find("geometry");
    if (geometry == item.end() || geometry->is_null()) builder_.fail("has no geometry; leave it out");
    add_geometry(*geometry);
  }

  void add_geometry(const nlohmann::json& item, int depth = 0) {
    const std::string type = type_of(item);
    if (type == "GeometryCollection") {
      if (depth == 100) builder_.fail("has collections nested 100 deep; unpack them");
      for (const nlohmann::json& part : list(item, "geometries")) add_geometry(part, depth + 1);
      return;
    }
    const bool known = type == "LineString" || type == "MultiLineString" || type == "Polygon" || type == "MultiPolygon";
    if (!known) {
      builder_.fail(fmt::format("geometry {} has no segments; give lines and polygons only", quote(type)));
    }
    const nlohmann::json& coordinates = list(item, "coordinates");
    if (type == "LineString") return add_line(coordinates, false);
    if (type == "Polygon") builder_.begin_polygon();
    for (const nlohmann::json& part : coordinates) {
      if (type != "MultiPolygon") {
        add_line(part, type == "Polygon");
      } else {
        builder_.begin_polygon();
        if (!part.is_array()) builder_.fail("coordinates are not lists of the depth that the type needs");
        for (const nlohmann::json& ring : part) add_line(ring, true);
      }
    }
  }

  const nlohmann::json& list(const nlohmann::json& item, const char* key) const {
    const auto value = item.find(key);
    if (value == item.end() || !value->is_array() || value->empty()) {
      builder_.fail(fmt::format("has no list \"{}\", or an empty one", key));
    }
    return *value;
  }

  void add_line(const nlohmann::json& points, bool ring, bool close = false) {
    if (!points.is_array()) builder_.fail("coordinates are not lists of the depth that the type needs");
    std::vector<Point2> line;
    for (const nlohmann::json& p : points) {
      const bool numbers =
          p.is_array() && p.size() >= 2 && std::all_of(p.begin(), p.end(), [](const auto& x) { return x.is_number(); });
      if (!numbers) builder_.fail("a position is not a list of two numbers");
      if (p.size() > 2 && !drop_z_) builder_.fail("has a third coordinate; to ignore it, give --drop-z");
      line.push_back({p[0].get<double>(), p[1].get<double>()});
    }
    if (close && !line.empty() && line.front() != line.back()) line.push_back(line.front());
    builder_.add_line(line, ring);
  }

  Builder& builder_;
  bool drop_z_;
};

std::string ending_of(std::string_view place) {
  std::string ending = std::filesystem::path(place).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), upper);
  return ending;
}

}  // namespace

LineFile parse_lines(std::string_view text, std::string_view place, bool drop_z) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  Builder builder(place);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) fail_file(place, "has nothing in it; give a file with lines");
  const std::string ending = ending_of(place);
  const char first = text[begin];
  const bool is_json = first == '{' || first == '[', is_word = 'A' <= upper(first) && upper(first) <= 'Z';
  if (ending == ".GEOJSON" || ending == ".JSON" || (is_json && ending != ".CSV" && ending != ".WKT")) {
    builder.file.format = "GeoJSON";
    GeoJson(builder, drop_z).parse(text, place);
  } else if (ending == ".WKT" || (is_word && ending != ".CSV")) {
    builder.file.format = "WKT";
    for_each_line(text, [&](std::string_view line, std::uint32_t number) {
      builder.begin_feature({}, number);
      Wkt(line, builder, drop_z).geometry();
    });
  } else {
    builder.file.format = "CSV";
    parse_csv(text, builder);
  }
  if (builder.file.segments.empty()) fail_file(place, "has no segments; give a file with lines");
  return std::move(builder.file);
}

LineFile read_lines(const std::filesystem::path& path, bool drop_z) {
  return parse_lines(read_file(path), path.string(), drop_z);
}

}  // namespace sunder::io
