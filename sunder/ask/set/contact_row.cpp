#include <sunder/ask/set/contact_row.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
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
  return value_json({property.values[k], property.is_text});
}

std::string properties_text(const ContactRow& row, const std::string& point) {
  std::string text = fmt::format(R"("i": {}, "j": {}, "contact": "{}"{})", row.i, row.j, row.contact, point);
  for (const ContactProperty& p : row.properties) {
    const bool is_one = p.values.size() == 1;
    text += fmt::format(R"(, "{}": {})", p.key,
                        is_one ? value_text(p, 0) : fmt::format("[{}, {}]", value_text(p, 0), value_text(p, 1)));
  }
  for (std::size_t k = 0; k < row.fields.size(); ++k) {
    const auto& [key, values] = row.fields[k];
    text += fmt::format(R"({}{}: [{}, {}]{})", k == 0 ? R"(, "properties": {)" : ", ", quoted_json(key),
                        value_json(values[0]), value_json(values[1]), k + 1 == row.fields.size() ? "}" : "");
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
std::string field_text(const std::string& value, bool is_text) {
  if (!is_text) return value == "null" ? "" : value;
  if (value.find_first_of(",\"\r\n") == std::string::npos) return value;
  std::string text = "\"";
  for (const char c : value) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

// Of a list the name of one: "names" has "name".
std::string_view one_of(std::string_view key) { return key.ends_with('s') ? key.substr(0, key.size() - 1) : key; }

}  // namespace

std::string value_json(const io::PropertyValue& value) { return value.is_text ? quoted_json(value.text) : value.text; }

std::vector<ContactField> fields_of(const std::vector<std::string>& keys, const FeatureProperties& of_i,
                                    std::uint32_t i, const FeatureProperties& of_j, std::uint32_t j) {
  std::vector<ContactField> fields;
  for (std::size_t k = 0; k < keys.size(); ++k) fields.push_back({keys[k], {of_i[i][k], of_j[j][k]}});
  return fields;
}

std::string words_of(const std::vector<std::string>& keys, const FeatureProperties& of_i, std::uint32_t i) {
  std::string words;
  for (std::size_t k = 0; k < keys.size(); ++k) words += fmt::format(", {} {}", io::one_line(keys[k]), of_i[i][k].text);
  return words;
}

Option property_option(std::vector<std::string>& keys, std::string_view of_whom) {
  return {"--property", &keys, fmt::format("also print this column or property {}", of_whom), "FIELD"};
}

void require_different(const std::vector<std::string>& keys) {
  for (auto key = keys.begin(); key != keys.end(); ++key) {
    if (std::find(keys.begin(), key, *key) == key) continue;
    throw Error(ErrorCode::bad_call, fmt::format("{} is asked for twice; give it once", io::quote(*key)), "--property");
  }
}

std::string report_text(const ContactRow& row) {
  const std::string point = fmt::format(R"(, "point": [{}, {}])", number_json(row.point.x), number_json(row.point.y));
  return fmt::format("{{{}}}", properties_text(row, point));
}

std::string geojson_text(const ContactRow& row, std::uint64_t number) {
  return fmt::format(R"({{"type":"Feature","geometry":{},"properties":{{"number": {}, {}}}}})", geometry_text(row),
                     number, properties_text(row, ""));
}

void ContactTable::write_names(const ContactRow& row) {
  std::string text = "i,j,contact,x,y";
  for (const ContactProperty& p : row.properties) {
    const std::string_view key = one_of(p.key);
    text += p.values.size() == 1 ? fmt::format(",{}", key) : fmt::format(",{}_i,{}_j", key, key);
  }
  for (const auto& [key, values] : row.fields) {
    text += fmt::format(",{},{}", field_text(key + "_i", true), field_text(key + "_j", true));
  }
  file_.write(text + "\r\n");
}

void ContactTable::add(const ContactRow& row) {
  if (std::exchange(is_empty_, false)) write_names(row);
  std::string text = fmt::format("{},{},{},{},{}", row.i, row.j, row.contact, row.point.x, row.point.y);
  for (const ContactProperty& p : row.properties) {
    for (std::size_t k = 0; k < p.values.size(); ++k) text += "," + field_text(p.values[k], p.is_text);
  }
  for (const auto& [key, values] : row.fields) {
    for (const auto& [value, is_text] : values) text += "," + field_text(value, is_text);
  }
  file_.write(text + "\r\n");
}

void ContactTable::close() {
  if (is_empty_) write_names({});
  file_.commit();
}

}  // namespace sunder::ask
