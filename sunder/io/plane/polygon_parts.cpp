#include <sunder/io/plane/polygon_parts.h>

#include <algorithm>

namespace sunder::io {

planar::MendedRings mend(PolygonParts& parts) {
  planar::MendedRings changes;
  for (planar::PolygonRings& rings : parts.rings) changes += planar::mend(rings);
  std::erase_if(parts.rings, [](const planar::PolygonRings& rings) { return rings.empty(); });
  parts.broken.clear();
  parts.open.clear();
  return changes;
}

bool PolygonPartsReader::next(PolygonParts& parts) {
  if (at_end()) return false;
  parts = {};
  parts.feature = feature();
  parts.first_ring = static_cast<std::uint32_t>(ring_);
  std::uint32_t polygon = 0;
  for (bool first = true; !at_end() && feature() == parts.feature; first = false) {
    const bool broken = is_broken();
    const std::uint32_t number = broken ? file_.broken[broken_].polygon : file_.rings[ring_].polygon;
    if (first || number != polygon) parts.rings.emplace_back();
    polygon = number;
    if (broken) {
      const BrokenRing& ring = file_.broken[broken_++];
      if (parts.broken.empty()) parts.broken = ring.what;
      if (ring.is_open) {
        parts.open.push_back(
            {static_cast<std::uint32_t>(parts.rings.size() - 1), static_cast<std::uint32_t>(parts.rings.back().size()),
             static_cast<std::uint32_t>(ring.points.size() - 1), ring.points.back(), ring.points.front()});
      }
      if (parts.line == 0) parts.line = ring.line;
      parts.rings.back().push_back(ring.points);
      parts.group = ring.group;
    } else {
      parts.rings.back().push_back(points(file_.rings[ring_++], parts));
    }
  }
  return true;
}

std::vector<Point2> PolygonPartsReader::points(const LineRing& ring, PolygonParts& parts) const {
  std::vector<Point2> points;
  points.reserve(ring.count + 1);
  for (std::uint32_t k = 0; k < ring.count; ++k) points.push_back(file_.segments[ring.first + k].a);
  points.push_back(points.front());
  parts.line = file_.source[ring.first].line;
  if (!file_.group.empty()) parts.group = file_.group[ring.first];
  return points;
}

}  // namespace sunder::io
