// Points, segments and polygons of the plane, each an object of its own, out of files: WKT, GeoJSON, CSV.
#pragma once

#include <sunder/predicate/point.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

struct PlanarObject {
  enum class Kind : std::uint8_t { point, segment, polygon } kind = Kind::polygon;
  std::string name;              // what the file gives as id or name, else the feature's number, counted from 1
  std::uint32_t line = 0;        // of the file, from 1; 0 where the format does not tell (GeoJSON)
  std::vector<Point2> vertices;  // finite; of a polygon: as the file lists them, without the repeated last one
};

struct PlanarFile {
  std::vector<PlanarObject> objects;  // at least one
  std::vector<std::string> remarks;   // for people, one line each
  std::string format;                 // for people: "WKT"
};

// Has the file an ending of these formats: .wkt, .csv, .geojson, .json?
bool is_planar(const std::filesystem::path& path);

// Reads the file whole.
//   WKT, GeoJSON  as in lines.h: a POINT, a LINESTRING of two points, or a POLYGON without holes is an object.
//   CSV           two numbers a line: the vertices of one polygon in order (one line: a point; two: a segment).
//                 Four and more: a segment a line, as in lines.h.
// Throws Error bad_file: "FILE:LINE: what; remedy". Cost: linear.
PlanarFile read_planar_objects(const std::filesystem::path& path, bool drop_z = false);

// As read_planar_objects, from memory. place: the file's name, for its ending and for messages.
PlanarFile parse_planar_objects(std::string_view text, std::string_view place, bool drop_z = false);

}  // namespace sunder::io
