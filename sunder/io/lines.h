// Segments, and the rings of polygons, out of files: CSV, WKT, GeoJSON.
#pragma once

#include <sunder/planar/object/segments.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// Where a segment is from.
struct LineSource {
  std::uint32_t feature = 0;  // counted from 0
  std::uint32_t line = 0;     // of the file, from 1; 0 where the format does not tell (GeoJSON)
};

// The edges of a ring: segments[first .. first + count), in its direction.
struct LineRing {
  std::uint32_t first = 0, count = 0;
  std::uint32_t polygon = 0;  // counted from 0; its rings stand together
};

// L1. There is a segment; coordinates are finite.
// L2. source has an entry for each segment; its features do not decrease, and are positions in features.
// L3. rings are in the order of their segments; each has at least three, and ends where it began.
struct LineFile {
  std::vector<planar::Segment> segments;  // ends in the order of the file
  std::vector<LineSource> source;
  std::vector<LineRing> rings;
  std::vector<std::string> features;  // names: what the file gives as id or name, else the number counted from 1
  std::string format;                 // for people: "WKT"
};

// Reads the file whole; its format is told by its ending (.csv, .wkt, .geojson, .json), else by its first character.
//   CSV      x1,y1,x2,y2 and, if there is one, an id; a first line of names is skipped. A line is a feature. Where the
//            first line has a semicolon, semicolons part the fields. A field may stand in quotes, but hold none.
//   WKT      a geometry on each line: LINESTRING, MULTILINESTRING, POLYGON, MULTIPOLYGON. A line is a feature.
//   GeoJSON  the same geometries, and collections of them; "id", else the property "name" or "id", names a feature.
//            Also plain JSON that is a list of rings: one polygon, whose rings need not repeat their first point.
// Lines of two points or more, and the edges of rings, become segments. A ring must end where it began. A third
// coordinate is refused unless drop_z. Empty lines are skipped.
// Throws Error bad_file: "FILE:LINE: what; remedy". Cost: linear.
LineFile read_lines(const std::filesystem::path& path, bool drop_z = false);

// As read_lines, from memory. place: the file's name, for its ending and for messages.
LineFile parse_lines(std::string_view text, std::string_view place, bool drop_z = false);

}  // namespace sunder::io
