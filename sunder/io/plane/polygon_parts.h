// The polygons of a file, feature by feature.
#pragma once

#include <sunder/io/plane/lines.h>
#include <sunder/planar/polygons/polygon_mend.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sunder::io {

// A ring that does not end where it began.
struct OpenRing {
  std::uint32_t part = 0, ring = 0;  // positions in PolygonParts::rings
  std::uint32_t edge = 0;            // that would close it: from `last` to `first`
  Point2 last, first;
};

// The parts of a feature.
struct PolygonParts {
  std::uint32_t feature = 0, line = 0, group = 0;
  std::uint32_t first_ring = 0;  // position in the file's rings of the first that is not broken
  std::vector<planar::PolygonRings> rings;
  std::string broken;  // the first ring that is none
  std::vector<OpenRing> open;
};

// Mends the rings of each part, also broken ones; parts without an area are left out.
planar::MendedRings mend(PolygonParts& parts);

// Walks over the parts of a file, which is kept.
class PolygonPartsReader {
 public:
  explicit PolygonPartsReader(const LineFile& file) : file_(file) {}

  // False at the end.
  bool next(PolygonParts& parts);

 private:
  bool at_end() const { return ring_ == file_.rings.size() && broken_ == file_.broken.size(); }
  bool is_broken() const { return broken_ < file_.broken.size() && file_.broken[broken_].ring <= ring_; }
  std::uint32_t feature() const {
    return is_broken() ? file_.broken[broken_].feature : file_.source[file_.rings[ring_].first].feature;
  }
  std::vector<Point2> points(const LineRing& ring, PolygonParts& parts) const;

  const LineFile& file_;
  std::size_t ring_ = 0, broken_ = 0;
};

}  // namespace sunder::io
