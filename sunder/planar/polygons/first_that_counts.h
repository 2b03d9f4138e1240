// The first contact of two polygons that counts. For use by the methods of polygons_any.
#pragma once

#include <sunder/planar/polygons/polygon_meetings.h>
#include <sunder/planar/polygons/polygons_any.h>

#include <span>

namespace sunder::planar {

// Stops at the first contact that counts: the callback of PolygonMeetings.
inline auto first_that_counts(PolygonsAnswer& answer, Allowed allowed) {
  return [&answer, allowed](const PolygonsContact& found) {
    if (!counts(found, allowed)) return true;
    answer.found = found;
    return false;
  };
}

// Where two polygons are only known to meet: how they do.
inline void classify(std::span<const Polygon> polygons, PolygonsAnswer& answer) {
  if (!answer.meet() || answer.found->contact != Relation::touching) return;
  const std::uint32_t i = answer.found->i, j = answer.found->j;
  const PolygonsAnswer pair = polygons_contact(polygons[i], polygons[j]);
  answer.cost.probes += pair.cost.probes;
  if (!pair.meet()) return;  // of polygons whose own rings cross
  answer.found = pair.found;
  answer.found->i = i;
  answer.found->j = j;
}

}  // namespace sunder::planar
