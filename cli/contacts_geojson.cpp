#include <cli/contacts_geojson.h>

#include <sunder/planar/pair/segment_segment.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace sunder::cli {

namespace {

using planar::Segment;
using planar::SegmentsContact;

std::string number_text(double x) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr};
}

std::string point_text(const Point2& p) { return "[" + number_text(p.x) + "," + number_text(p.y) + "]"; }

std::string geometry_text(const Segment& s, const Segment& t, planar::ContactKind kind) {
  if (kind == planar::ContactKind::overlap) {
    const Segment part = common_part(s, t);
    return R"({"type":"LineString","coordinates":[)" + point_text(part.a) + "," + point_text(part.b) + "]}";
  }
  return R"({"type":"Point","coordinates":)" + point_text(planar::common_point_rounded(s, t)) + "}";
}

std::string properties_text(const io::LineFile& file, const SegmentsContact& contact, std::uint64_t number) {
  const auto member = [](const char* key, const std::string& value) {
    return ",\"" + std::string(key) + "\":" + value;
  };
  const auto both = [&](const char* key, const auto& value_of) {
    return member(key, "[" + value_of(contact.i) + "," + value_of(contact.j) + "]");
  };
  const auto names = [&](const char* key, const std::vector<std::string>& list,
                         const std::vector<std::uint32_t>& entries) {
    if (list.empty()) return std::string();
    return both(key, [&](std::uint32_t i) { return quoted_json(list[entries[i]]); });
  };
  return "{\"number\":" + std::to_string(number) + member("kind", "\"" + std::string(name_of(contact.kind)) + "\"") +
         member("i", std::to_string(contact.i)) + member("j", std::to_string(contact.j)) +
         both("features", [&](std::uint32_t i) { return quoted_json(file.features[file.source[i].feature]); }) +
         both("lines",
              [&](std::uint32_t i) {
                return file.source[i].line > 0 ? std::to_string(file.source[i].line) : std::string("null");
              }) +
         names("groups", file.groups, file.group) + names("layers", file.layers, file.layer) + "}";
}

}  // namespace

Segment common_part(const Segment& s, const Segment& t) {
  // On one line, the lexicographic order is the order along it.
  return {planar::lexicographically_less(s.a, t.a) ? t.a : s.a, planar::lexicographically_less(s.b, t.b) ? s.b : t.b};
}

ContactsGeojson::ContactsGeojson(const io::LineFile& file, ListStream::Sink sink)
    : file_(file), list_(R"({"type":"FeatureCollection","features":[)", "", std::move(sink)) {}

void ContactsGeojson::add(const SegmentsContact& contact) {
  const Segment s = planar::sorted(file_.segments[contact.i]), t = planar::sorted(file_.segments[contact.j]);
  list_.add(R"({"type":"Feature","geometry":)" + geometry_text(s, t, contact.kind) + R"(,"properties":)" +
            properties_text(file_, contact, list_.count() + 1) + "}");
}

}  // namespace sunder::cli
