#include <sunder/base/error.h>
#include <sunder/io/plane/lines_geojson.h>
#include <sunder/io/text/csv.h>
#include <sunder/io/text/json_internal.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace sunder::io {

namespace {

// An object of a file that is a sequence of them.
struct JsonRecord {
  std::string_view text;
  std::uint32_t line = 0;
};

// The lines of newline-delimited GeoJSON, the records of RFC 8142; none where the text is one JSON value.
std::vector<JsonRecord> records_of(std::string_view text) {
  constexpr char separator = '\x1e';
  std::vector<JsonRecord> lines;  // that are not blank
  for_each_line(text, [&](std::string_view line, std::uint32_t number) { lines.push_back({line, number}); });
  if (lines.empty()) return {};
  const std::string_view first = lines[0].text;
  if (!first.starts_with(separator)) {
    // An object ends with the line, and the next line begins with one: no JSON value goes on so.
    const bool several =
        lines.size() > 1 && first.starts_with('{') && first.ends_with('}') && lines[1].text.starts_with('{');
    return several ? lines : std::vector<JsonRecord>();
  }
  std::vector<JsonRecord> records;  // each goes on up to the next separator
  for (const auto& [line, number] : lines) {
    if (line.starts_with(separator)) {
      records.push_back({line.substr(1), number});
    } else {
      std::string_view& record = records.back().text;
      record = {record.data(), static_cast<std::size_t>(line.data() + line.size() - record.data())};
    }
  }
  return records;
}

class GeoJson {
 public:
  explicit GeoJson(LineBuilder& builder)
      : builder_(builder), group_(builder.options().group), properties_(builder.options().properties) {
    builder.group_by(by_name(group_));
  }

  void parse(std::string_view text) {
    const std::vector<JsonRecord> records = records_of(text);
    if (!records.empty()) {
      for (const auto& [record, line] : records) add_top(parse_json(record, builder_.place(), line), line);
    } else {
      const nlohmann::json top = parse_json(text, builder_.place());
      const bool is_rings = top.is_array() && !top.empty() && top[0].is_array();
      is_rings ? add_rings(top) : add_top(top, 0);
    }
    if (places_ > 0) {
      builder_.file.remarks.push_back(
          fmt::format("geometries out of \"place\" of JSON-FG: {}; axes are taken as they stand", places_));
    }
    builder_.rest_in(in_degrees_ ? assumed_crs84() : CoordinateSystem());
    if (!named_ && !builder_.options().name.empty()) fail_name();
    for (const std::string& property : properties_) {
      if (!known_.contains(property)) fail_property(property);
    }
  }

 private:
  // Plain JSON that is a list of rings.
  void add_rings(const nlohmann::json& rings) {
    builder_.group_by_feature_or_ring();
    builder_.begin_feature({}, 0);
    builder_.begin_polygon();
    for (const nlohmann::json& ring : rings) add_ring(ring, true);
    in_degrees_ = false;  // it is no GeoJSON
  }

  // Of a file, or of a line of one: 0 where the file is one object.
  void add_top(const nlohmann::json& top, std::uint32_t line) {
    line_ = line;
    builder_.at_line(line);
    const bool several = type_of(top) == "FeatureCollection";
    const auto features = top.find("features");
    if (several && (features == top.end() || !features->is_array())) {
      builder_.fail("the collection has no list \"features\"");
    }
    const auto has_place = [](const nlohmann::json& item) { return place_of(item) != nullptr; };
    const bool places = several ? std::any_of(features->begin(), features->end(), has_place) : has_place(top);
    const Systems systems = declared(top, {{}, {}, places});
    if (!several) return add_feature(top, systems);
    for (const nlohmann::json& feature : *features) add_feature(feature, systems);
  }

  // What is declared so far: by "crs", and by "coordRefSys", which speaks of "place", where features have one.
  struct Systems {
    CoordinateSystem crs, reference;
    bool places = false;

    const CoordinateSystem& of_geometry() const { return crs.declared() || places ? crs : reference; }
  };

  // With what this object declares itself.
  Systems declared(const nlohmann::json& item, Systems systems) const {
    if (const auto crs = item.find("crs"); crs != item.end()) systems.crs = system_of_crs(*crs);
    const auto reference = item.find("coordRefSys");
    if (reference != item.end()) systems.reference = system_by_name(reference_of(*reference));
    return systems;
  }

  // null declares none.
  CoordinateSystem system_of_crs(const nlohmann::json& crs) const {
    if (crs.is_null()) return {};
    if (crs.is_string()) return system_by_name(crs.get<std::string>());
    const auto properties = crs.find("properties");
    if (crs.is_object() && properties != crs.end() && properties->is_object()) {
      for (const char* key : {"name", "href", "code"}) {
        const auto value = properties->find(key);
        if (value == properties->end()) continue;
        if (value->is_number_unsigned() && key == std::string_view("code")) {
          return system_by_name("EPSG:" + value->dump());
        }
        if (value->is_string()) return system_by_name(value->get<std::string>());
      }
    }
    builder_.fail(
        "\"crs\" names no coordinate system; write {\"type\":\"name\",\"properties\":{\"name\":\"EPSG:...\"}}, or "
        "leave it "
        "out");
  }

  // A name, a reference, or a list of these.
  std::string reference_of(const nlohmann::json& reference) const {
    if (reference.is_null()) return {};
    if (reference.is_string()) return reference.get<std::string>();
    if (reference.is_object() && reference.contains("href") && reference["href"].is_string()) {
      return reference["href"].get<std::string>();
    }
    if (!reference.is_array() || reference.empty()) {
      builder_.fail("\"coordRefSys\" names no coordinate system; give its URI, or leave it out");
    }
    std::string all;
    for (const nlohmann::json& part : reference) {
      if (part.is_array()) builder_.fail("\"coordRefSys\" is a list of lists; give URIs");
      all += (all.empty() ? "" : " + ") + reference_of(part);
    }
    return all;
  }

  // What JSON-FG has beside "geometry"; null where it is none.
  static const nlohmann::json* place_of(const nlohmann::json& feature) {
    if (!feature.is_object()) return nullptr;
    const auto place = feature.find("place");
    return place != feature.end() && place->is_object() && place->contains("type") ? &*place : nullptr;
  }

  std::string type_of(const nlohmann::json& item) const {
    if (!item.is_object()) builder_.fail("is no GeoJSON: an object with a \"type\" is expected");
    const auto type = item.find("type");
    if (type == item.end() || !type->is_string()) builder_.fail("is no GeoJSON: an object has no \"type\"");
    if (*type == "Topology") {
      builder_.fail("is TopoJSON, which is not read; make GeoJSON of it: ogr2ogr -f GeoJSON out.geojson in.json");
    }
    return *type;
  }

  static std::string text_of(const nlohmann::json& value) {
    return value.is_string() ? one_line(value.get<std::string>()) : value.is_number() ? value.dump() : std::string();
  }

  // The value of the property that groups, as it is written.
  std::string group_of(const nlohmann::json& feature, bool wrapped) const {
    const auto properties = wrapped ? feature.find("properties") : feature.end();
    const bool some = properties != feature.end() && properties->is_object();
    const auto value = some ? properties->find(group_) : nlohmann::json::const_iterator();
    if (!some || value == properties->end()) {
      builder_.fail(fmt::format("has no property {}; give it one{}", quote(group_),
                                builder_.options().lines ? ", or group by feature or ring" : ""));
    }
    if (value->is_string()) {
      if (value->get_ref<const std::string&>().empty()) {
        builder_.fail(fmt::format("has no text in the property {}; give one", quote(group_)));
      }
      return value->get<std::string>();
    }
    if (!value->is_number() && !value->is_boolean()) {
      builder_.fail(
          fmt::format("property {} is neither text nor a number, true or false; give it one of these", quote(group_)));
    }
    return value->dump();
  }

  // The first that there is, of the names that the format knows, or the one that is asked for.
  std::string name_of(const nlohmann::json& feature) {
    const std::string& asked = builder_.options().name;
    const auto properties = feature.find("properties");
    const auto property = [&](const std::string& key) -> std::string {
      if (properties == feature.end() || !properties->is_object()) return {};
      const auto value = properties->find(key);
      return value != properties->end() ? text_of(*value) : std::string();
    };
    const auto own_id = [&]() -> std::string {
      const auto id = feature.find("id");
      return id != feature.end() ? text_of(*id) : std::string();
    };
    if (!asked.empty()) {
      std::string name = property(asked);
      if (name.empty() && asked == "id") name = own_id();
      named_ = named_ || !name.empty();
      return name;
    }
    for (const std::string key : {"name", "Name", "NAME", "", "id", "ID", "Id"}) {
      if (std::string name = key.empty() ? own_id() : property(key); !name.empty()) return name;
    }
    return {};
  }

  [[noreturn]] void fail_name() const {
    throw Error(ErrorCode::bad_call,
                fmt::format("no feature has a property {} that is text or a number, to name it by; name another one",
                            quote(builder_.options().name)),
                one_line(builder_.place()));
  }

  // Of the feature, those that are asked for.
  PropertyValues properties_of(const nlohmann::json& feature, bool wrapped) {
    PropertyValues values(properties_.size());
    const auto properties = wrapped ? feature.find("properties") : feature.end();
    if (properties == feature.end() || !properties->is_object()) return values;
    for (const auto& property : properties->items()) known_.insert(property.key());
    for (std::size_t k = 0; k < values.size(); ++k) {
      const auto value = properties->find(properties_[k]);
      if (value == properties->end()) continue;
      const bool is_text = value->is_string() || value->is_structured();
      values[k] = {value->is_string() ? one_line(value->get<std::string>()) : value->dump(), is_text};
    }
    return values;
  }

  [[noreturn]] void fail_property(const std::string& property) const {
    constexpr std::size_t most = 20;
    std::vector<std::string> first;
    for (const std::string& known : known_) {
      if (first.size() < most) first.push_back(shorten(known));
    }
    throw Error(
        ErrorCode::bad_call,
        fmt::format("there is no property {} to tell of; there {} {}{}", quote(property), first.empty() ? "is" : "are",
                    first.empty() ? "none" : fmt::format("{}", fmt::join(first, ", ")),
                    known_.size() > most ? ", ..." : ""),
        one_line(builder_.place()));
  }

  void add_feature(const nlohmann::json& item, const Systems& of_all) {
    const bool wrapped = type_of(item) == "Feature";
    builder_.begin_feature(wrapped ? name_of(item) : std::string(), line_);
    if (!properties_.empty()) builder_.property_values(properties_of(item, wrapped));
    if (by_name(group_) == GroupBy::field) builder_.group_value(group_of(item, wrapped));
    const Systems systems = declared(item, of_all);
    if (!wrapped) return add_whole(item, systems.of_geometry());
    if (const nlohmann::json* place = place_of(item)) {
      ++places_;
      return add_whole(*place, systems.reference);
    }
    const auto geometry = item.find("geometry");
    if (geometry == item.end()) builder_.fail("has no \"geometry\"; give it, or null");
    if (geometry->is_null()) {
      builder_.system(systems.crs.declared() ? systems.crs : systems.reference);
      return builder_.add_nothing();
    }
    add_whole(*geometry, declared(*geometry, systems).of_geometry());
  }

  // The geometry of a feature.
  void add_whole(const nlohmann::json& geometry, const CoordinateSystem& system) {
    builder_.system(system);
    add_geometry(geometry);
  }

  void add_geometry(const nlohmann::json& item, int depth = 0) {
    const std::string type = type_of(item);
    if (type == "GeometryCollection") {
      if (depth == 100) builder_.fail("has collections nested 100 deep; unpack them");
      const nlohmann::json& parts = list(item, "geometries");
      if (parts.empty()) return builder_.add_nothing();
      for (const nlohmann::json& part : parts) add_geometry(part, depth + 1);
      return;
    }
    const bool point = type == "Point" || type == "MultiPoint";
    const bool line = type == "LineString" || type == "MultiLineString";
    if (of_json_fg(type)) return builder_.leave_out(type);
    if (!point && !line && type != "Polygon" && type != "MultiPolygon") {
      builder_.fail(fmt::format("geometry {} is not one of GeoJSON; give lines and polygons", quote(type)));
    }
    const nlohmann::json& coordinates = list(item, "coordinates");
    if (coordinates.empty()) return builder_.add_nothing();
    if ((point && !(builder_.options().points && type == "Point")) || (line && !builder_.options().lines)) {
      return builder_.leave_out(point ? "point" : "line");
    }
    if (point) return builder_.add_point(points_of(nlohmann::json::array({coordinates})));
    if (type == "LineString") return builder_.add_line(points_of(coordinates));
    if (type == "Polygon") return add_polygon(coordinates, false);
    for (const nlohmann::json& part : coordinates) {
      if (part.is_array() && part.empty()) {
        builder_.add_nothing();
      } else if (line) {
        builder_.add_line(points_of(part));
      } else {
        add_polygon(part, true);
      }
    }
  }

  // What JSON-FG has more: solids and curves.
  static bool of_json_fg(const std::string& type) {
    constexpr std::array<std::string_view, 9> types{"Polyhedron",   "MultiPolyhedron", "Prism",
                                                    "MultiPrism",   "CircularString",  "CompoundCurve",
                                                    "CurvePolygon", "MultiCurve",      "MultiSurface"};
    return std::find(types.begin(), types.end(), type) != types.end();
  }

  void add_polygon(const nlohmann::json& rings, bool several) {
    builder_.begin_polygon(several);
    if (!rings.is_array()) builder_.fail("coordinates are not lists of the depth that the type needs");
    for (const nlohmann::json& ring : rings) {
      const bool is_empty = ring.is_array() && ring.empty();
      is_empty ? builder_.add_empty_ring() : add_ring(ring, false);
    }
  }

  const nlohmann::json& list(const nlohmann::json& item, const char* key) const {
    const auto value = item.find(key);
    if (value == item.end() || !value->is_array()) builder_.fail(fmt::format("has no list \"{}\"", key));
    return *value;
  }

  // close: where the first point is not repeated, do.
  void add_ring(const nlohmann::json& list, bool close) {
    builder_.begin_ring();
    std::vector<Point2> points = points_of(list);
    if (close && !points.empty() && points.front() != points.back()) points.push_back(points.front());
    builder_.add_ring(points);
  }

  std::vector<Point2> points_of(const nlohmann::json& list) {
    if (!list.is_array()) builder_.fail("coordinates are not lists of the depth that the type needs");
    std::vector<Point2> points;
    for (const nlohmann::json& p : list) {
      const bool numbers =
          p.is_array() && p.size() >= 2 && std::all_of(p.begin(), p.end(), [](const auto& x) { return x.is_number(); });
      if (!numbers) builder_.fail("a position is not a list of two numbers");
      builder_.check_dimension(p.size());
      points.push_back({p[0].get<double>(), p[1].get<double>()});
      in_degrees_ = in_degrees_ && std::fabs(points.back().x) <= 180 && std::fabs(points.back().y) <= 90;
    }
    return points;
  }

  LineBuilder& builder_;
  const std::string& group_;
  const std::vector<std::string>& properties_;  // that are asked for
  std::set<std::string> known_;                 // properties that a feature has, where some are asked for
  bool named_ = false;                          // has a feature the field that is to name it?
  std::uint32_t line_ = 0;                      // of the file, where each line is an object
  std::uint64_t places_ = 0;                    // read of JSON-FG
  bool in_degrees_ = true;                      // are all numbers within 180 and 90?
};

}  // namespace

void parse_geojson(std::string_view text, LineBuilder& builder) { GeoJson(builder).parse(text); }

}  // namespace sunder::io
