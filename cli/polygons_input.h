// Polygons with holes out of a file, for verbs.
#pragma once

#include <sunder/io/lines.h>
#include <sunder/planar/object/polygon.h>

#include <cstdint>
#include <string>
#include <vector>

namespace sunder::cli {

struct PolygonsInput {
  io::LineFile file;
  std::vector<planar::Polygon> polygons;
  std::vector<std::uint32_t> first_ring;  // of each polygon, among the rings of the file
  std::vector<std::uint32_t> groups;      // of each polygon, a position in file.groups; empty unless asked for

  std::string name(std::uint32_t polygon) const;    // of its feature
  std::uint32_t line(std::uint32_t polygon) const;  // 0 where the format does not tell
};

// Throws Error bad_file where there are no polygons, or one is not well formed. simple: also where one is not simple,
// with two edges that meet. group: the property, or "feature", that says which belong together, or empty; Error
// bad_call where the file has none such.
PolygonsInput read_polygons(const std::string& name, bool drop_z, bool simple, const std::string& group = "");

}  // namespace sunder::cli
