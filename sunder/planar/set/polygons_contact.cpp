// Two polygons: only edges near both are looked at.
#include <sunder/planar/set/edge_contact_lists.h>
#include <sunder/planar/set/polygons_any.h>

#include <algorithm>
#include <vector>

namespace sunder::planar {

PolygonsAnswer polygons_contact(const Polygon& a, const Polygon& b) {
  PolygonsAnswer answer;
  if (!meet(a.box(), b.box())) return answer;
  const Box common = common_part(a.box(), b.box());
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
