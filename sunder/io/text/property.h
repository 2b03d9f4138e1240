// What the fields of a file tell of a feature: the columns of a CSV, the properties of a GeoJSON.
#pragma once

#include <string>
#include <vector>

namespace sunder::io {

// A field that is not there, or empty, is null.
struct PropertyValue {
  std::string text = "null";  // on one line
  bool is_text = false;       // else a number, true, false or null, as in JSON

  friend bool operator==(const PropertyValue&, const PropertyValue&) = default;
};

// Of the fields that were asked for, in their order.
using PropertyValues = std::vector<PropertyValue>;

}  // namespace sunder::io
