// Segments out of files: CSV, WKT, GeoJSON.
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

// L1. There is a segment; coordinates are finite.
// L2. source has an entry for each segment; its features increase, and are positions in features.
struct LineFile {
  std::vector<planar::Segment> segments;  // ends in the order of the file
  std::vector<LineSource> source;
  std::vector<std::string> features;  // names: what the file gives as id or name, else the number counted from 1
  std::string format;                 // for people: "WKT"
};

// Reads the file whole; its format is told by its ending (.csv, .wkt, .geojson, .json), else by its first character.
//   CSV      x1,y1,x2,y2 and, if there is one, an id; a first line of names is skipped. A line is a feature.
//   WKT      a geometry on each line: LINESTRING, MULTILINESTRING, POLYGON, MULTIPOLYGON. A line is a feature.
//   GeoJSON  the same geometries, and collections of them; "id", else the property "name" or "id", names a feature.
// Lines of two points or more, and the edges of rings, become segments. A ring must end where it began. A third
// coordinate is refused unless drop_z. Empty lines are skipped.
// Throws Error bad_file: "FILE:LINE: what; remedy". Cost: linear.
LineFile read_lines(const std::filesystem::path& path, bool drop_z = false);

// As read_lines, from memory. place: the file's name, for its ending and for messages.
LineFile parse_lines(std::string_view text, std::string_view place, bool drop_z = false);

}  // namespace sunder::io
