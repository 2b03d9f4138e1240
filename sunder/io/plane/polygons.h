// Polygons out of files, feature by feature: those that are valid, or can be made so, and what is told of the others.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/plane/lines.h>
#include <sunder/io/text/left_out.h>
#include <sunder/planar/object/polygon.h>
#include <sunder/planar/polygons/polygon_mend.h>
#include <sunder/planar/polygons/polygon_valid.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sunder::io {

// "ring 0 crosses itself at about (2, 2): edges 0 and 2". has_parts: rings are named with their parts.
std::string text_of(const planar::PolygonDefect& defect, bool has_parts);

struct PolygonsRequest {
  std::vector<std::string> files;  // one, or two
  bool drop_z = false;
  bool leave_out = false;                          // points and lines, which are of another kind
  bool skip_invalid = false;                       // features that are not valid
  bool mend = false;                               // what planar::mend can
  bool by_part = false;                            // each part of a multipolygon is a polygon; else each feature is one
  std::optional<planar::PolygonRule> rule{};       // what is not valid by it is refused, or skipped; none: all is taken
  std::string group, name;                         // as LineOptions have them
  std::vector<std::string> properties{};           // so too; of two files, both have them
  bool tell_inputs = false;                        // the SHA-256 of the files
  bool mixed_crs = false;                          // coordinate systems may differ
  std::function<void(double)> progress = nullptr;  // as LineOptions have it
};

// A polygon is the parts of a feature, or one of them. Features that hold nothing make none.
struct PolygonSource {
  std::uint32_t file = 0, feature = 0;        // positions in PolygonsInput::files and in its features
  std::uint32_t line = 0;                     // of the file; 0 where the format does not tell
  std::uint32_t part = 0;                     // by part: which
  std::vector<std::uint32_t> part_of_ring{};  // not by part, and of several parts: of each ring
};

struct SkippedFeature {
  std::uint32_t file = 0, feature = 0, line = 0;
  std::string why;  // "part 1, ring 0: ..."
};

struct MendedFeature {
  std::uint32_t file = 0, feature = 0, line = 0;
  planar::MendedRings changes;
  bool is_empty = false;  // nothing is left of it
};

struct PolygonsInput {
  std::vector<std::string> names;  // of the files, as they were given
  std::vector<LineFile> files;     // their rings are those of the files; polygons may have been mended
  std::vector<planar::Polygon> polygons;
  std::vector<PolygonSource> source;  // of each polygon
  std::vector<std::uint32_t> groups;  // of each polygon: where a group was asked for, a position in files[0].groups;
                                      // of two files, the file; else empty
  std::vector<SkippedFeature> skipped;
  std::string skipped_kind = "invalid feature";  // what they are
  std::vector<MendedFeature> mended;
  LeftOutList left_out{true};
  InputFiles inputs;  // where they are asked for
  CoordinateSystems systems{};

  const std::string& name(std::uint32_t polygon) const;  // of its feature
  std::uint32_t line(std::uint32_t polygon) const { return source[polygon].line; }
  std::uint64_t edges() const;

  // "7", or "7 (Antarctica)": the number, counted from 1, and the name, where there is one.
  std::string feature_text(std::uint32_t file, std::uint32_t feature) const;

  // What the answer does not speak of, for the sentence of the verdict: "skipped: 2 invalid features; left out: 3
  // points of 'mast'"; empty where it speaks of all.
  std::string left_out_words() const;

  // For a certificate: the files, the same one by one, and that features were mended.
  Origin origin() const;

  // Reads a file without its polygons, which PolygonPartsReader gives.
  void read_file(const std::string& name, LineOptions options, bool tell_inputs);

 private:
  std::string skipped_text() const;
  std::string emptied_text() const;  // of mended features
};

// Repeated vertices are left out of features that are one polygon: the points that they hold are the same without. By
// part they stay, so that vertices count as in the file.
// Throws Error bad_file where there are no polygons (also: none left), or, where a rule is given and nothing is to be
// skipped, where one is not valid: with its number and name, the defect, how many more there are, and the remedy; and
// where coordinate systems differ that may not.
// bad_call where the file has no such group or name, and for two files with a group.
PolygonsInput read_polygons(const PolygonsRequest& request);

}  // namespace sunder::io
