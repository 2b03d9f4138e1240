// Sections of bodies by planes as text: OBJ, and WKT with Z. Put it into a file with write_file_atomically (file.h).
//
// Corners are written as the nearest doubles, in the shortest decimal form that reads back as the same; so a polygon
// may be no longer exactly flat. Exact corners are in certificates (docs/claims.md, "Sections").
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

enum class SectionFormat : std::uint8_t { obj, wkt };

// By the name's ending: .obj, .wkt. Throws Error bad_call for another one.
SectionFormat section_format_of_name(const std::string& file);

// The corners of a section, in order: none, one, two, or those of a polygon.
struct SectionText {
  std::string name;  // one line, such as "z = 0.5"
  std::vector<Point3> corners;
};

// OBJ: an object for each section that is not nothing, with its vertices and one face, line or point. WKT: a line for
// each section: POLYGON Z, LINESTRING Z, POINT Z, or POLYGON Z EMPTY for nothing.
std::string to_text(SectionFormat format, std::span<const SectionText> sections);

}  // namespace sunder::io
