#include <sunder/ask/set/contact_row.h>

#include <fmt/format.h>

#include <charconv>
#include <utility>

namespace sunder::ask {

namespace {

// As in reports: a number with a point or an exponent, the shortest that reads back the same.
std::string number_json(double x) {
  std::array<char, 32> digits{};
  std::string text(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string value_text(const ContactProperty& property, std::size_t k) {
  return property.is_text ? quoted_json(property.values[k]) : property.values[k];
}

std::string properties_text(const ContactRow& row, const std::string& point) {
  std::string text = fmt::format(R"("i": {}, "j": {}, "kind": "{}"{})", row.i, row.j, row.kind, point);
  for (const ContactProperty& p : row.properties) {
    const bool is_one = p.values.size() == 1;
    text += fmt::format(R"(, "{}": {})", p.key,
                        is_one ? value_text(p, 0) : fmt::format("[{}, {}]", value_text(p, 0), value_text(p, 1)));
  }
  return text;
}

std::string position_text(const Point2& p) { return fmt::format("[{},{}]", p.x, p.y); }

std::string geometry_text(const ContactRow& row) {
  if (!row.part) return fmt::format(R"({{"type":"Point","coordinates":{}}})", position_text(row.point));
  return fmt::format(R"({{"type":"LineString","coordinates":[{},{}]}})", position_text((*row.part)[0]),
                     position_text((*row.part)[1]));
}

// A field of RFC 4180: in quotes where it needs them.
std::string field_text(const ContactProperty& property, std::size_t k) {
  const std::string& value = property.values[k];
  if (!property.is_text) return value == "null" ? "" : value;
  if (value.find_first_of(",\"\r\n") == std::string::npos) return value;
  std::string text = "\"";
  for (const char c : value) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

// Of a list the name of one: "names" has "name".
std::string_view one_of(std::string_view key) { return key.ends_with('s') ? key.substr(0, key.size() - 1) : key; }

}  // namespace

std::string report_text(const ContactRow& row) {
  const std::string point = fmt::format(R"(, "point": [{}, {}])", number_json(row.point.x), number_json(row.point.y));
  return fmt::format("{{{}}}", properties_text(row, point));
}

std::string geojson_text(const ContactRow& row, std::uint64_t number) {
  return fmt::format(R"({{"type":"Feature","geometry":{},"properties":{{"number": {}, {}}}}})", geometry_text(row),
                     number, properties_text(row, ""));
}

void ContactTable::write_names(const ContactRow& row) {
  std::string text = "i,j,kind,x,y";
  for (const ContactProperty& p : row.properties) {
    const std::string_view key = one_of(p.key);
    text += p.values.size() == 1 ? fmt::format(",{}", key) : fmt::format(",{}_i,{}_j", key, key);
  }
  file_.write(text + "\r\n");
}

void ContactTable::add(const ContactRow& row) {
  if (std::exchange(is_empty_, false)) write_names(row);
  std::string text = fmt::format("{},{},{},{},{}", row.i, row.j, row.kind, row.point.x, row.point.y);
  for (const ContactProperty& p : row.properties) {
    for (std::size_t k = 0; k < p.values.size(); ++k) text += "," + field_text(p, k);
  }
  file_.write(text + "\r\n");
}

void ContactTable::close() {
  if (is_empty_) write_names({});
  file_.commit();
}

}  // namespace sunder::ask
