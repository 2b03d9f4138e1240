// A contact of two members of a set, as all that tell of it have it: reports in JSON, GeoJSON, tables.
#pragma once

#include <sunder/ask/list_stream.h>
#include <sunder/ask/verb.h>

#include <sunder/io/text/file.h>
#include <sunder/io/text/property.h>
#include <sunder/predicate/point.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::ask {

// What else is told of a contact: one value for both members, or one for each.
struct ContactProperty {
  std::string_view key;
  std::vector<std::string> values;
  bool is_text = true;  // else as in JSON: a number, null
};

// A field that --property asks for, and what it says of both members.
struct ContactField {
  std::string key;
  std::array<io::PropertyValue, 2> values;
};

struct ContactRow {
  std::uint64_t i = 0, j = 0;
  std::string_view contact;                     // its kind
  Point2 point;                                 // of both, rounded
  std::optional<std::array<Point2, 2>> part{};  // of an overlap of segments: the common part, exact
  std::vector<ContactProperty> properties{};
  std::vector<ContactField> fields{};
};

// Properties of features, by their numbers: keys are the fields asked for. Empty where there are none.
using FeatureProperties = std::vector<io::PropertyValues>;
std::vector<ContactField> fields_of(const std::vector<std::string>& keys,            //
                                    const FeatureProperties& of_i, std::uint32_t i,  //
                                    const FeatureProperties& of_j, std::uint32_t j);

// For people: ", owner city, power 12".
std::string words_of(const std::vector<std::string>& keys, const FeatureProperties& of_i, std::uint32_t i);

// As in JSON.
std::string value_json(const io::PropertyValue& value);

// The option; of_whom: "of both members".
Option property_option(std::vector<std::string>& keys, std::string_view of_whom);

// Throws Error bad_call where a field is asked for twice: --property.
void require_different(const std::vector<std::string>& keys);

// {"i": 0, "j": 1, "contact": "crossing", "point": [1.0, 1.0], "names": ["A", "B"], "properties": {"owner": ["x",
// "y"]}}
std::string report_text(const ContactRow& row);

// A feature of a FeatureCollection, on one line.
//   geometry    Point; of an overlap LineString, its common part. Numbers are the shortest that read back as the same
//               double, and those of the file: a board's y still points down.
//   properties  number (from 1), and what the contact has in a report, but for the point.
// Bytes of names that are no UTF-8 become U+FFFD.
std::string geojson_text(const ContactRow& row, std::uint64_t number);

// Contacts as CSV (RFC 4180): i, j, contact, x, y, and of what is told of each member two columns: "name_i",
// "name_j"; of fields that were asked for "owner_i", "owner_j".
// The file is whole, or not there.
class ContactTable {
 public:
  ContactTable(const Talk& talk, const std::string& name) : file_(name, talk.instead(name)) {}
  void add(const ContactRow& row);
  void close();

 private:
  void write_names(const ContactRow& row);

  io::OutputFile file_;
  bool is_empty_ = true;
};

}  // namespace sunder::ask
