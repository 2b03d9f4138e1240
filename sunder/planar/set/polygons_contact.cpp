// Two polygons: only edges near both are looked at.
#include <sunder/planar/set/edge_contact_lists.h>
#include <sunder/planar/set/polygons_any.h>

#include <algorithm>
#include <vector>

namespace sunder::planar {

namespace {

Box common_box(const Polygon& a, const Polygon& b) {
  const auto box_of = [](const Polygon& polygon) {
    Box box = box_of_ring(polygon, 0);
    for (std::uint32_t r = 1; r < polygon.ring_count(); ++r) {
      const Box ring = box_of_ring(polygon, r);
      box = {std::min(box.left, ring.left), std::max(box.right, ring.right), std::min(box.bottom, ring.bottom),
             std::max(box.top, ring.top)};
    }
    return box;
  };
  const Box in_a = box_of(a), in_b = box_of(b);
  return {std::max(in_a.left, in_b.left), std::min(in_a.right, in_b.right), std::max(in_a.bottom, in_b.bottom),
          std::min(in_a.top, in_b.top)};
}

}  // namespace

PolygonsAnswer polygons_contact(const Polygon& a, const Polygon& b) {
  PolygonsAnswer answer;
  const Box common = common_box(a, b);
  if (common.left > common.right || common.bottom > common.top) return answer;
  PolygonEdges edges({&a, &b});
  PolygonMeetings meetings(edges, {}, [&](const PolygonsContact& found) {
    const bool more = found.contact != Contact::touching || found.kind > answer.found.kind;
    if (more) answer.found = found;
    return found.contact != Contact::overlapping;
  });
  std::vector<std::uint32_t> near;
  for (std::uint32_t e = 0; e < edges.edges().size(); ++e) {
    const Segment& s = edges.edges()[e];
    const double low = std::min(s.a.y, s.b.y), high = std::max(s.a.y, s.b.y);
    if (meet(Box{s.a.x, s.b.x, low, high}, common)) near.push_back(e);
  }
  if (take_contacts_of(near, edges, {}, meetings) && meetings.look_around_points()) meetings.look_inside();
  answer.cost = meetings.cost;
  answer.cost.probes += edges.edges().size();
  return answer;
}

}  // namespace sunder::planar
