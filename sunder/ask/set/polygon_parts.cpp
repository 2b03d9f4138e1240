#include <sunder/ask/set/polygon_parts.h>

#include <algorithm>

namespace sunder::ask {

MendedRings mend(Parts& parts) {
  MendedRings changes;
  for (Rings& rings : parts.rings) changes += mend(rings);
  std::erase_if(parts.rings, [](const Rings& rings) { return rings.empty(); });
  parts.broken.clear();
  return changes;
}

bool PartsReader::next(Parts& parts) {
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
      const io::BrokenRing& ring = file_.broken[broken_++];
      if (parts.broken.empty()) parts.broken = ring.what;
      parts.rings.back().push_back(ring.points);
      parts.group = ring.group;
    } else {
      parts.rings.back().push_back(points(file_.rings[ring_++], parts));
    }
  }
  return true;
}

std::vector<Point2> PartsReader::points(const io::LineRing& ring, Parts& parts) const {
  std::vector<Point2> points;
  points.reserve(ring.count + 1);
  for (std::uint32_t k = 0; k < ring.count; ++k) points.push_back(file_.segments[ring.first + k].a);
  points.push_back(points.front());
  parts.line = file_.source[ring.first].line;
  if (!file_.group.empty()) parts.group = file_.group[ring.first];
  return points;
}

}  // namespace sunder::ask
