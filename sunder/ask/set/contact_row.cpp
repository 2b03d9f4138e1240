#include <sunder/ask/set/contact_row.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace sunder::ask {

namespace {

// What is written of each of millions of contacts is put together piece by piece.

constexpr std::size_t most_usual = 240;  // characters

void add_whole(std::string& text, std::uint64_t n) {
  const fmt::format_int digits(n);
  text.append(digits.data(), digits.size());
}

// As in reports: a number with a point or an exponent, the shortest that reads back the same.
void add_number(std::string& text, double x) {
  std::array<char, 32> digits;
  const std::size_t begin = text.size();
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr);
  if (text.find_first_of(".e", begin) == std::string::npos) text += ".0";
}

void add_value(std::string& text, const std::string& value, bool is_text) {
  if (is_text) {
    add_quoted_json(text, value);
  } else {
    text += value;
  }
}

void add_ends(std::string& text, const ContactRow& row) {
  text.append(R"("i": )");
  add_whole(text, row.i);
  text.append(R"(, "j": )");
  add_whole(text, row.j);
  text.append(R"(, "contact": ")").append(row.contact) += '"';
}

void add_properties(std::string& text, const ContactRow& row) {
  for (const ContactProperty& p : row.properties) {
    text.append(R"(, ")").append(p.key).append(R"(": )");
    if (p.values.size() == 1) {
      add_value(text, p.values[0], p.is_text);
      continue;
    }
    add_value(text += '[', p.values[0], p.is_text);
    add_value(text.append(", "), p.values[1], p.is_text);
    text += ']';
  }
  for (std::size_t k = 0; k < row.fields.size(); ++k) {
    const auto& [key, values] = row.fields[k];
    text += fmt::format(R"({}{}: [{}, {}]{})", k == 0 ? R"(, "properties": {)" : ", ", quoted_json(key),
                        value_json(values[0]), value_json(values[1]), k + 1 == row.fields.size() ? "}" : "");
  }
}

void add_position(std::string& text, const Point2& p) {
  std::array<char, 64> position;
  text.append(position.data(), fmt::format_to(position.data(), FMT_COMPILE("[{},{}]"), p.x, p.y));
}

void add_geometry(std::string& text, const ContactRow& row) {
  if (!row.part) {
    add_position(text.append(R"({"type":"Point","coordinates":)"), row.point);
  } else {
    add_position(text.append(R"({"type":"LineString","coordinates":[)"), (*row.part)[0]);
    add_position(text += ',', (*row.part)[1]);
    text += ']';
  }
  text += '}';
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
  std::string text = "{";
  text.reserve(most_usual);
  add_ends(text, row);
  add_number(text.append(R"(, "point": [)"), row.point.x);
  add_number(text.append(", "), row.point.y);
  add_properties(text += ']', row);
  return text += '}';
}

std::string geojson_text(const ContactRow& row, std::uint64_t number) {
  std::string text = R"({"type":"Feature","geometry":)";
  text.reserve(most_usual);
  add_geometry(text, row);
  add_whole(text.append(R"(,"properties":{"number": )"), number);
  add_ends(text.append(", "), row);
  add_properties(text, row);
  return text.append("}}");
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
