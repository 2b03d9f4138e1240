// Polygons out of files, feature by feature, for verbs.
#pragma once

#include <sunder/ask/left_out.h>
#include <sunder/ask/report.h>
#include <sunder/ask/set/polygon_mend.h>

#include <sunder/io/lines.h>
#include <sunder/planar/object/polygon.h>
#include <sunder/planar/set/polygon_valid.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sunder::ask {

// Help of the options that make a request.
inline constexpr const char* skip_invalid_help = "answer for the valid features, and list the others";
inline constexpr const char* mend_help = "close rings, cut spikes off, leave out rings without area; and say so";
inline constexpr const char* name_help = "the property that names features; unless given, name, NAME, id";

struct PolygonsRequest {
  std::vector<std::string> files;  // one, or two
  bool drop_z = false;
  bool leave_out = false;                     // points and lines, which are of another kind
  bool skip_invalid = false;                  // features that are not valid
  bool mend = false;                          // what mend (polygon_mend.h) can
  bool by_part = false;                       // each part of a multipolygon is a polygon; else each feature is one
  std::optional<planar::PolygonRule> rule{};  // what is not valid by it is refused, or skipped; none: all is taken
  std::string group, name;                    // as LineOptions have them
  bool tell_inputs = false;                   // the SHA-256 of the files
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
  std::uint32_t file = 0, feature = 0;
  MendedRings changes;
};

struct PolygonsInput {
  std::vector<std::string> names;   // of the files, as they were given
  std::vector<io::LineFile> files;  // their rings are those of the files; polygons may have been mended
  std::vector<planar::Polygon> polygons;
  std::vector<PolygonSource> source;  // of each polygon
  std::vector<std::uint32_t> groups;  // of each polygon: where a group was asked for, a position in files[0].groups;
                                      // of two files, the file; else empty
  std::vector<SkippedFeature> skipped;
  std::string skipped_kind = "invalid feature";  // what they are
  std::vector<MendedFeature> mended;
  LeftOutList left_out{true};
  InputFiles inputs;  // where they are asked for

  const std::string& name(std::uint32_t polygon) const;  // of its feature
  std::uint32_t line(std::uint32_t polygon) const { return source[polygon].line; }
  std::uint64_t features() const;
  std::uint64_t edges() const;

  // "7", or "7 (Antarctica)": the number, counted from 1, and the name, where there is one.
  std::string feature_text(std::uint32_t file, std::uint32_t feature) const;

  // What the answer does not speak of, for the sentence of the verdict: "skipped: 2 invalid features; left out: 3
  // points of 'mast'"; empty where it speaks of all.
  std::string left_out_words() const;

  // For a certificate: the files, the same one by one, and that features were mended.
  Origin origin() const;

  // "  skipped ...", "  left out ...", "  mended ...", "  remark ...": lines for people, at most 20 of a kind.
  std::string tell() const;

  // Adds "skipped", "left_out", "mended", "remarks" to a report, as far as there are any.
  void tell(Json& report) const;
};

// Repeated vertices are left out of features that are one polygon: the points that they hold are the same without. By
// part they stay, so that vertices count as in the file.
// Throws Error bad_file where there are no polygons (also: none left), or, where a rule is given and nothing is to be
// skipped, where one is not valid: with its number and name, the defect, how many more there are, and the remedy.
// bad_call where the file has no such group or name, and for two files with a group.
PolygonsInput read_polygons(const PolygonsRequest& request);

}  // namespace sunder::ask
