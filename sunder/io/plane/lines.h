// Segments, and the rings of polygons, out of files: CSV, WKT, GeoJSON, KiCad boards (kicad.h).
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/plane/coordinate_system.h>
#include <sunder/io/text/left_out.h>
#include <sunder/io/text/property.h>
#include <sunder/planar/object/segments.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// The formats of text, boards aside.
enum class LinesFormat : std::uint8_t { csv, wkt, geojson, kicad };

// By the ending of the place (.csv, .wkt, .geojson, .json, .kicad_pcb) or "(kicad_" in the beginning, else by the first
// letters of the text.
LinesFormat lines_format(std::string_view text, std::string_view place);

// What is asked of a reader.
struct LineOptions {
  bool drop_z = false;  // ignore third coordinates; else they are refused
  std::string group{};  // the field that says which segments belong together; empty: none, for a board "net"
  std::function<void(double)> progress = nullptr;  // called now and then with the part that is read (CSV, WKT), 0 to 1
  bool points = false;                             // take points too (WKT, GeoJSON), as segments of length zero
  bool lines = true;                               // take lines, not only rings

  // What is of another kind (points, lines, curves) is refused, unless it is to be left out: then left_out tells of it.
  bool leave_out = false;

  // A ring that is none (open, or of fewer than three corners) is refused, unless this is set: then broken tells of it.
  bool keep_broken = false;

  std::string name{};  // the field that names features; empty: the first of those listed below

  std::vector<std::string> properties{};  // the fields that are told of each feature

  InputFiles* inputs = nullptr;  // as of read_file
};

// A ring that is none.
struct BrokenRing {
  std::uint32_t feature = 0;
  std::string what;            // "ring 1: does not end where it began"
  std::vector<Point2> points;  // as the file has them
  std::uint32_t ring = 0;      // how many rings of the file stand before it
  std::uint32_t polygon = 0;   // as of LineRing
  std::uint32_t group = 0;     // a position in groups; meaningless where there are none
  std::uint32_t line = 0;      // as of LineSource
  std::string remedy;          // "repeat its first point at its end"
  bool is_open = false;        // three corners and more, and no end; else too few corners
};

// Where a segment is from.
struct LineSource {
  std::uint32_t feature = 0;  // counted from 0
  std::uint32_t line = 0;     // of the file, from 1; 0 where the format does not tell (GeoJSON that is one object)
};

// The edges of a ring: segments[first .. first + count), in its direction.
struct LineRing {
  std::uint32_t first = 0, count = 0;
  std::uint32_t polygon = 0;  // counted from 0; its rings stand together
};

// L1. There is a segment, or a broken ring; coordinates are finite.
// L2. source has an entry for each segment; its features do not decrease, and are positions in features. Every feature
//     of the file has its position, also one that has no segments: whose geometry is null, empty, or was left out.
// L3. rings are in the order of their segments; each has at least three, and ends where it began. polygon counts
//     within the file, and does not decrease; a number that no ring has is that of a polygon whose rings are broken.
// L4. group is empty, and groups too, or group has an entry for each segment, a position in groups; each group has a
//     segment, or a broken ring. So are layer and layers. Both lists of names are in the order in which their first
//     segments or broken rings come; names need not differ.
struct LineFile {
  std::vector<planar::Segment> segments;  // ends in the order of the file
  std::vector<LineSource> source;
  std::vector<LineRing> rings;
  std::vector<std::string> features;  // names: what the file gives as id or name, else its number, counted from 1
  std::vector<std::uint32_t> group;   // empty unless a group was asked for, or the file is a board
  std::vector<std::string> groups;    // names: "GND"; where rings are grouped: "pond, ring 1"
  std::vector<std::uint32_t> layer;   // empty where the format has no layers
  std::vector<std::string> layers;    // names: "F.Cu"
  std::vector<std::string> remarks;   // for people, one line each: what was read but is not looked at, or approximated
  std::vector<LeftOut> left_out;      // one by one, in the order of the file; of: "line 7", "'mast'"
  std::vector<BrokenRing> broken;     // in the order of the file
  std::string format;                 // for people: "WKT"
  std::vector<PropertyValues> properties;  // of each feature; empty unless some were asked for
  std::vector<SystemOfFile> systems;       // each once, one that is not declared too; of a board none
  std::vector<std::uint32_t> system;       // of each feature a position in systems; of a board none

  // Those features are in this system that declare none.
  void declare(const CoordinateSystem& system);
};

// Reads the file whole; its format is told by its first letters "(kicad_", by its ending (.csv, .wkt, .geojson, .json,
// .kicad_pcb), else by its first character.
//   CSV      x1,y1,x2,y2 and, if there is one, an id; a line is a feature. Where a first line names the columns, these
//            are found by their names, in any order, and any others may stand beside them; the id is the one named
//            "name" or "id" (also Name, NAME, ...), else the first other. Names that do not hold these are refused.
//            Splitting as in csv.h. Or a geometry of WKT in each line, in a column that the first line names wkt,
//            geometry, geom or the_geom: then columns may be grouped by, and "ring".
//   WKT      geometries, each beginning on a line of its own: LINESTRING, MULTILINESTRING, POLYGON, MULTIPOLYGON,
//            GEOMETRYCOLLECTION. Each is a feature, and may go over several lines; source has the first.
//            "SRID=4326;" before it is its coordinate system.
//   GeoJSON  the same geometries; also an object on each line, and records of RFC 8142. The first that there is
//            of the properties "name", "Name", "NAME", the feature's "id", and the properties "id", "ID", "Id" names a
//            feature. A key may not stand twice in an object.
//            Also plain JSON that is a list of rings: one polygon, whose rings need not repeat their first point.
// A feature whose geometry is null or empty has no segments; a remark tells how many there are. Where an own field
// names features, one without it is named by its number; Error bad_call where none has it, or the format has no fields.
// Where fields are to be told of features, one without it has null there; Error bad_call as above, with the fields that
// there are. What a GeoJSON has as list or object is told as text.
// Lines of two points or more, and the edges of rings, become segments. A ring must end where it began. A third
// coordinate is refused unless drop_z. Empty lines are skipped. Messages and names count rings and polygons from 0.
//
// Coordinate systems: of WKT the SRID, else that of the .prj beside the file, as of CSV (read_lines only). Of GeoJSON
// "crs" of the whole, a feature or a geometry, else JSON-FG's "coordRefSys"; where nothing is declared, CRS84 if all
// numbers of the file are within 180 and 90, else none.
// JSON-FG: a feature's "place", where it is an object, is its geometry, in the system "coordRefSys", with a remark;
// the "geometry" of other features is then in another system.
//
// Groups: "feature" puts the segments of a feature together, "ring" those of a ring or of an open line (not in CSV).
// In CSV any column behind the fourth may be named instead, also one named "feature"; in GeoJSON any other property,
// whose value is a number, true, false, or text that is not empty. Values are the same where they are written the same.
// Each line and feature must have one.
// Throws Error bad_file: "FILE:LINE: what; remedy"; bad_call where the file has no such group. Cost: linear.
LineFile read_lines(const std::filesystem::path& path, const LineOptions& options = {});

// As read_lines, from memory. place: the file's name, for its ending and for messages.
LineFile parse_lines(std::string_view text, std::string_view place, const LineOptions& options = {});

// Throws Error bad_call: "FILE: there is no field 'x' to group by; there are feature, ring". For readers.
[[noreturn]] void fail_group(std::string_view file, std::string_view group, std::string_view known);

}  // namespace sunder::io
