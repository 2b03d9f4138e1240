// A contact of two members of a set, as all that tell of it have it: reports in JSON, GeoJSON, tables.
#pragma once

#include <sunder/ask/list_stream.h>

#include <sunder/io/file.h>
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

struct ContactRow {
  std::uint64_t i = 0, j = 0;
  std::string_view kind;
  Point2 point;                                 // of both, rounded
  std::optional<std::array<Point2, 2>> part{};  // of an overlap of segments: the common part, exact
  std::vector<ContactProperty> properties{};
};

// {"i": 0, "j": 1, "kind": "crossing", "point": [1.0, 1.0], "names": ["A", "B"]}
std::string report_text(const ContactRow& row);

// A feature of a FeatureCollection, on one line.
//   geometry    Point; of an overlap LineString, its common part. Numbers are the shortest that read back as the same
//               double, and those of the file: a board's y still points down.
//   properties  number (from 1), and those that the contact has in a report, but for the point.
// Bytes of names that are no UTF-8 become U+FFFD.
std::string geojson_text(const ContactRow& row, std::uint64_t number);

// Contacts as CSV (RFC 4180): i, j, kind, x, y, and of what is told of each member two columns ("name_i", "name_j").
// The file is whole, or not there.
class ContactTable {
 public:
  explicit ContactTable(const std::string& name) : file_(name) {}
  void add(const ContactRow& row);
  void close();

 private:
  void write_names(const ContactRow& row);

  io::OutputFile file_;
  bool is_empty_ = true;
};

}  // namespace sunder::ask
