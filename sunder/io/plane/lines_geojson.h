// Lines out of GeoJSON, and out of JSON that is a list of rings. What is read, and how, stands in lines.h.
#pragma once

#include <sunder/base/error.h>
#include <sunder/io/plane/lines_builder.h>

#include <string_view>

namespace sunder::io {

// Throws Error bad_file. Cost: linear, as far as hashing of keys is.
void parse_geojson(std::string_view text, LineBuilder& builder);

}  // namespace sunder::io
