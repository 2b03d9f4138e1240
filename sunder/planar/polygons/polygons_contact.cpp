// Two polygons: only edges near both are looked at.
#include <sunder/planar/polygons/edge_contact_lists.h>
#include <sunder/planar/polygons/polygon_sweep.h>
#include <sunder/planar/polygons/polygons_any.h>

#include <algorithm>
#include <vector>

namespace sunder::planar {

namespace {

// To compare each ring with all edges of the other polygon takes longer than a sweep over both.
bool have_many_rings(const Polygon& a, const Polygon& b) {
  const auto looks = [](const Polygon& p, const Polygon& q) { return std::uint64_t{p.ring_count()} * q.size(); };
  constexpr std::uint64_t few = 16;
  return looks(a, b) + looks(b, a) > few * (a.size() + b.size());
}

}  // namespace

PolygonsAnswer polygons_contact(const Polygon& a, const Polygon& b) {
  PolygonsAnswer answer;
  if (!meet(a.box(), b.box())) return answer;
  const Box2 common = common_part(a.box(), b.box());
  PolygonEdges edges({&a, &b});
  const auto greatest = [&](const PolygonsContact& found) {
    const bool more = found.contact != Relation::touching || !answer.meet() || found.kind > answer.found->kind;
    if (more) answer.found = found;
    return found.contact != Relation::overlapping;
  };
  const auto by_sweep = [&] {
    PolygonSweep sweep(edges, {}, greatest);
    sweep.run();
    answer.cost.probes += sweep.cost.probes;
    return answer;
  };
  answer.cost.probes = edges.edges().size();
  if (have_many_rings(a, b)) return by_sweep();
  PolygonMeetings meetings(edges, {}, greatest);
  std::vector<std::uint32_t> near;
  for (std::uint32_t e = 0; e < edges.edges().size(); ++e) {
    const Segment& s = edges.edges()[e];
    const double low = std::min(s.a.y, s.b.y), high = std::max(s.a.y, s.b.y);
    if (meet(Box2{{s.a.x, low}, {s.b.x, high}}, common)) near.push_back(e);
  }
  const std::optional<bool> taken = take_contacts_of(near, edges, {}, meetings);
  if (!taken) return by_sweep();
  if (*taken && meetings.look_around_points()) meetings.look_inside();
  answer.cost.probes += meetings.cost.probes;
  return answer;
}

}  // namespace sunder::planar
