// Coordinate systems of files of the plane: what files declare, and which of them are one system.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// A coordinate system as a file declares it. In all files read here x is the longitude, or the easting: so EPSG:4326
// and CRS84 are one system, and axes are never swapped.
struct CoordinateSystem {
  std::string id;           // what is compared: "EPSG:28992"; without authority and code the text; empty: none declared
  std::string name;         // for people, on one line: "EPSG:28992", "CRS84"
  std::string urn;          // what GeoJSON calls it; empty where it has no code
  bool is_assumed = false;  // nothing declares it: CRS84 is GeoJSON's own rule

  bool declared() const { return !id.empty(); }
};

// What is named so: "EPSG:28992", "urn:ogc:def:crs:EPSG::28992", "http://www.opengis.net/def/crs/EPSG/0/28992",
// "CRS84", "urn:ogc:def:crs:OGC:1.3:CRS84"; a name of another form is compared by its text. Empty: none.
CoordinateSystem system_by_name(std::string_view name);

// That of "SRID=28992;". No number above zero: none.
CoordinateSystem system_by_srid(std::int64_t srid);

// That of the text of a .prj: by the code of its outermost AUTHORITY or ID, else by the whole text. Empty: none.
CoordinateSystem system_by_prj(std::string_view text);

// That of the .prj beside a file (roads.prj beside roads.wkt); none where there is no such file.
// inputs: as of read_file. Throws Error bad_file where it cannot be read, or is no text of at most 64 KB.
CoordinateSystem system_beside(const std::filesystem::path& file, InputFiles* inputs = nullptr);

// GeoJSON's own, where nothing else is declared.
CoordinateSystem assumed_crs84();

// One of the systems of a file.
struct SystemOfFile {
  CoordinateSystem system;
  std::string first;  // what has it first: "line 3", "'mast'"
};

// Those of one file: "EPSG:28992"; of several "EPSG:28992 from line 1, none from line 3". Empty where none is declared.
std::string text_of(std::span<const SystemOfFile> systems);

// The coordinate systems of all that a call reads.
class CoordinateSystems {
 public:
  struct Declared {
    CoordinateSystem system;
    std::vector<std::string> files;
    std::string first;  // in the first of them
  };

  // may_differ: the caller consents that systems differ (--mixed-crs).
  explicit CoordinateSystems(bool may_differ = false) : may_differ_(may_differ) {}

  // Throws Error bad_file where a system is declared that differs from one before, unless they may differ: one line
  // with both files, both systems and the remedy.
  void add(const std::string& file, std::span<const SystemOfFile> systems);

  std::span<const Declared> declared() const { return declared_; }  // each once

  // The only one that is declared; null where there is none, or several.
  const CoordinateSystem* only() const { return declared_.size() == 1 ? &declared_.front().system : nullptr; }

  // "EPSG:28992"; of several "EPSG:28992 of a.wkt, EPSG:4326 of b.wkt"; empty where none is declared.
  std::string text() const;

  // One line each: that something declares no system beside others that do; that systems differ.
  std::vector<std::string> remarks() const;

 private:
  bool may_differ_;
  std::vector<Declared> declared_;
  std::vector<std::string> undeclared_;  // what declares none: "a.csv", "line 7 of b.wkt"
};

}  // namespace sunder::io
