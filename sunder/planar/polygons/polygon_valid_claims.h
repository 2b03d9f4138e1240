// Certificates that polygons are valid, or of what is wrong with them (docs/claims.md, "Valid polygons").
//
// Requires finite coordinates and fewer than 2^31 vertices. None throws, but for want of memory, or what the writer's
// sink throws.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/planar/polygons/polygon_valid.h>

#include <cstdint>
#include <memory>
#include <span>

namespace sunder::planar {

// Adds the parts to the table `polygons`, which is open. A last vertex that repeats its ring's first is left out.
void write_parts(ClaimsWriter& file, std::span<const PolygonRings> parts);

// The statements about the parts of one multipolygon; in the table these are first_part and those that follow. Keeps
// the writer by reference.
class ValidClaims {
 public:
  // O(n) for n edges.
  ValidClaims(ClaimsWriter& file, std::span<const PolygonRings> parts, std::uint32_t first_part, PolygonRule rule);
  ValidClaims(const ValidClaims&) = delete;
  ValidClaims& operator=(const ValidClaims&) = delete;
  ~ValidClaims();

  // That they are valid. Requires that it is true. O((n + k) log n) time for k crossings.
  void write_valid();

  // Of a defect, as polygon_defects names it; nothing where the same statement was made before: of passes of a ring
  // through one point, and of an interior that is not connected, one tells of all. False, and nothing is written: the
  // defect is that two rings cross in a vertex, and no point near it shows it; or that the interior is not connected,
  // and another defect hides that. Cost: O(log n) for crossings, overlaps and touches; linear in the edges for each
  // point that is looked at, mostly one, of other crossings in vertices, and of what is nested or outside; for
  // `disconnected`, once, as for write_valid.
  bool write_defect(const PolygonDefect& defect);

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace sunder::planar
