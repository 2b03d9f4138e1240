// Points, segments, polygons, lines, rays and half-planes of the plane, each an object of its own, out of files: WKT,
// GeoJSON, CSV.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/plane/coordinate_system.h>
#include <sunder/io/text/left_out.h>
#include <sunder/predicate/point.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

struct PlanarObject {
  enum class Kind : std::uint8_t { point, segment, polygon, line, ray, half_plane } kind = Kind::polygon;
  std::string name;        // what the file gives as id or name, else the feature's number, counted from 1
  std::uint32_t line = 0;  // of the file, from 1; 0 where the format does not tell (GeoJSON that is one object)

  // Finite. Of a polygon: as the file lists them, without the repeated last one. Of a line, a ray and a half-plane: its
  // two points, which differ; the ray begins in the first one, the half-plane is to the left of the way to the second.
  std::vector<Point2> vertices;

  CoordinateSystem system{};  // as of lines.h
  std::string problem{};      // why it is no object here, and the remedy; then it has no vertices; mostly empty

  bool unbounded() const { return kind == Kind::line || kind == Kind::ray || kind == Kind::half_plane; }
};

std::string_view name_of(PlanarObject::Kind);  // "half-plane"

// Throws Error bad_file, with its place in the file, where the object has a problem.
void require_object(const PlanarObject& object, std::string_view place);

struct PlanarFile {
  std::vector<PlanarObject> objects;  // at least one that has no problem
  std::vector<std::string> remarks;   // for people, one line each
  std::vector<LeftOut> left_out;      // what is no object here: MULTIPOINT, curves
  std::string format;                 // for people: "WKT"

  std::vector<SystemOfFile> systems() const;  // of the objects, each once

  // Those objects are in this system that declare none.
  void declare(const CoordinateSystem& system);
};

// Has the file an ending of these formats: .wkt, .csv, .geojson, .json, or .geojsonl, .geojsons, .ndjson, .jsonl?
bool is_planar(const std::filesystem::path& path);

// Reads the file whole.
//   WKT, GeoJSON  as in lines.h: a POINT, a LINESTRING of two points, or a POLYGON without holes is an object. What is
//                 more has a problem beside others, and is refused where there are no others.
//                 In WKT also LINE (x y, x y), RAY (x y, x y) and HALFPLANE (x y, x y), words of ours on lines of
//                 their own; GeoJSON has no such objects.
//   CSV           two numbers a line: the vertices of one polygon in order (one line: a point; two: a segment).
//                 Four and more: a segment a line, as in lines.h.
//                 Where the first line begins with a kind, each line is an object: line,x1,y1,x2,y2 and, if it has one,
//                 its name; the same with ray, half-plane and segment; point,x,y. A line of names may stand first,
//                 if its first one is "kind".
// Semicolons part the fields where the first line has one. Small and large letters of kinds are the same.
// inputs: as of read_file. Throws Error bad_file: "FILE:LINE: what; remedy". Cost: linear.
PlanarFile read_planar_objects(const std::filesystem::path& path, bool drop_z = false, InputFiles* inputs = nullptr);

// As read_planar_objects, from memory. place: the file's name, for its ending and for messages; where the ending is
// none of these, the first letters tell the format.
PlanarFile parse_planar_objects(std::string_view text, std::string_view place, bool drop_z = false);

}  // namespace sunder::io
