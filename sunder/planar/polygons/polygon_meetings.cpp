#include <sunder/near/box_pairs.h>
#include <sunder/planar/polygons/crossing_edges.h>
#include <sunder/planar/polygons/polygon_meetings.h>
#include <sunder/planar/polygons/ring_tests.h>

#include <algorithm>
#include <array>
#include <utility>

namespace sunder::planar {

namespace {

bool has_end_at(const Segment& s, const Point2& p) { return s.a == p || s.b == p; }

// The one or two ends of edges in which two edges that do not cross meet, or begin and end to overlap.
struct CommonEnds {
  std::array<Point2, 2> at;
  std::size_t count;
};
CommonEnds common_ends(const Segment& s, const Segment& t, ContactKind kind) {
  if (kind == ContactKind::overlap) {
    const auto [first, last] = common_part(s, t);
    return {{first, last}, 2};
  }
  if (kind == ContactKind::shared_endpoint) return {{has_end_at(t, s.a) ? s.a : s.b, {}}, 1};
  // A touch: the end that the other one holds.
  for (const Point2& p : {s.a, s.b}) {
    if (segment_segment({p, p}, t) != ContactKind::none) return {{p, {}}, 1};
  }
  return {{segment_segment({t.a, t.a}, s) != ContactKind::none ? t.a : t.b, {}}, 1};
}

}  // namespace

bool PolygonMeetings::report(Relation contact, std::uint32_t e, std::uint32_t f, ContactKind kind) {
  if (edges_.polygon_of(e) > edges_.polygon_of(f)) std::swap(e, f);
  const std::uint32_t i = edges_.polygon_of(e), j = edges_.polygon_of(f);
  if (may_meet(groups_, i, j)) return true;
  return found_({contact, kind, false, i, j, edges_.in_polygon(e), edges_.in_polygon(f)});
}

bool PolygonMeetings::overlap_where_crossing(std::uint32_t e, std::uint32_t f) {
  const Polygon &a = edges_.polygon(edges_.polygon_of(e)), &b = edges_.polygon(edges_.polygon_of(f));
  return overlap_at_crossing(a, edges_.in_polygon(e), b, edges_.in_polygon(f), cost.probes);
}

bool PolygonMeetings::take(std::uint32_t e, std::uint32_t f, ContactKind kind) {
  const bool of_one = edges_.polygon_of(e) == edges_.polygon_of(f);
  if (!of_one) {
    const bool overlap = kind == ContactKind::crossing && overlap_where_crossing(e, f);
    if (!report(overlap ? Relation::overlapping : Relation::touching, e, f, kind)) return false;
  }
  // Of two polygons, either they overlap, or others of their edges end and meet there. Of one: it is not as required.
  if (kind == ContactKind::crossing) return true;
  const CommonEnds ends = common_ends(edges_.edges()[e], edges_.edges()[f], kind);
  for (std::size_t k = 0; k < ends.count; ++k) meetings_.push_back({ends.at[k], e, f});
  return true;
}

bool PolygonMeetings::look_around_points() {
  const auto before = [](const Meeting& a, const Meeting& b) {
    if (a.at != b.at) return lexicographically_less(a.at, b.at);
    return a.e != b.e ? a.e < b.e : a.f < b.f;
  };
  std::sort(meetings_.begin(), meetings_.end(), before);
  for (std::size_t k = 0, end; k < meetings_.size(); k = end) {
    for (end = k + 1; end < meetings_.size() && meetings_[end].at == meetings_[k].at;) ++end;
    if (!look_around(meetings_[k].at, {meetings_.data() + k, end - k})) return false;
  }
  return true;
}

// Of a polygon P that is here with one of another group, all edges that hold the point are among the meetings. Let e be
// one. P is here by a meeting of two edges, one of which ends here, so that it meets e here. Unless it follows e: then
// e ends here too, and meets all edges of the other polygon here.
bool PolygonMeetings::look_around(const Point2& p, std::span<const Meeting> meetings) {
  edges_here_.clear();
  bool several = false;
  const std::uint32_t polygon = edges_.polygon_of(meetings[0].e);
  for (const Meeting& m : meetings) {
    edges_here_.insert(edges_here_.end(), {m.e, m.f});
    several |= edges_.polygon_of(m.e) != polygon || edges_.polygon_of(m.f) != polygon;
  }
  if (!several) return true;
  std::sort(edges_here_.begin(), edges_here_.end());
  edges_here_.erase(std::unique(edges_here_.begin(), edges_here_.end()), edges_here_.end());

  leaving_.clear();
  for (const std::uint32_t e : edges_here_) {
    const Segment& s = edges_.edges()[e];
    if (s.a == s.b) continue;
    const bool above = edges_.inside_is_above(e);
    if (s.b != p) leaving_.push_back({s.b, e, edges_.polygon_of(e), above});
    if (s.a != p) leaving_.push_back({s.a, e, edges_.polygon_of(e), !above});
  }
  const auto before = [&](const Leaving& a, const Leaving& b) {
    const bool a_right = lexicographically_less(p, a.to), b_right = lexicographically_less(p, b.to);
    if (a_right != b_right) return a_right;
    return orient_2d(p, a.to, b.to) == Sign::positive;
  };
  std::sort(leaving_.begin(), leaving_.end(), [&](const Leaving& a, const Leaving& b) {
    if (before(a, b) || before(b, a)) return before(a, b);
    return a.opens != b.opens ? b.opens : a.edge < b.edge;  // in one direction, first what is left
  });
  return walk_around();
}

bool PolygonMeetings::enter(const Leaving& leaving) {
  for (const Leaving& other : open_) {
    if (other.polygon == leaving.polygon) continue;
    const ContactKind kind = segment_segment(edges_.edges()[other.edge], edges_.edges()[leaving.edge]);
    if (!report(Relation::overlapping, other.edge, leaving.edge, kind)) return false;
  }
  open_.push_back(leaving);
  return true;
}

// Counter-clockwise. In each sector open_ has the polygons that fill it; the first sector, before the first direction,
// is filled by those whose last direction opens.
bool PolygonMeetings::walk_around() {
  open_.clear();
  ++points_;
  for (std::size_t k = leaving_.size(); k-- > 0;) {
    const Leaving& last = leaving_[k];
    if (std::exchange(seen_[last.polygon], points_) != points_ && last.opens && !enter(last)) return false;
  }
  for (const Leaving& leaving : leaving_) {
    std::erase_if(open_, [&](const Leaving& other) { return other.polygon == leaving.polygon; });
    if (leaving.opens && !enter(leaving)) return false;
  }
  return true;
}

bool PolygonMeetings::report_inside(std::uint32_t ring, std::uint32_t polygon) {
  const auto& [of, number] = edges_.rings()[ring];
  const std::uint32_t vertex = edges_.polygon(of).ring_begin(number);
  const bool first = of < polygon;
  return found_({Relation::overlapping, ContactKind::none, first, std::min(of, polygon), std::max(of, polygon),
                 first ? vertex : 0, first ? 0 : vertex});
}

bool PolygonMeetings::look_inside() {
  // Rings, and polygons that have a ring whose box holds that of the ring.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> candidates;
  const std::vector<PolygonEdges::Ring>& rings = edges_.rings();
  const std::vector<Box2> boxes = edges_.ring_boxes();
  // Is the ring's first vertex in the interior of the polygon?
  const auto is_inside = [&](std::uint32_t ring, std::uint32_t p) {
    const Polygon &of_ring = edges_.polygon(rings[ring].polygon), &polygon = edges_.polygon(p);
    const Point2& v = of_ring.vertices()[of_ring.ring_begin(rings[ring].in_polygon)];
    bool inside = false;
    for (std::uint32_t s = 0; s < polygon.ring_count(); ++s) {
      if (!holds(boxes[edges_.first_ring(p) + s], {v, v})) continue;
      cost.probes += polygon.ring_begin(s + 1) - polygon.ring_begin(s);
      const Sign where = where_in_ring(polygon, s, v);
      if (where == Sign::zero) return false;
      inside ^= where == Sign::positive;
    }
    return inside;
  };
  const auto look = [&](std::uint32_t inner, std::uint32_t outer) {
    if (!holds(boxes[outer], boxes[inner])) return true;
    const std::uint32_t p = rings[outer].polygon;
    if (edges_.polygon(p).ring_count() == 1) return !is_inside(inner, p) || report_inside(inner, p);
    candidates.emplace_back(inner, p);
    return true;
  };
  const bool all = for_each_box_pair(boxes, [&](std::uint32_t r, std::uint32_t s) {
    if (rings[r].polygon == rings[s].polygon || may_meet(groups_, rings[r].polygon, rings[s].polygon)) return true;
    ++cost.probes;
    return look(r, s) && look(s, r);
  });
  if (!all) return false;
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  return std::all_of(candidates.begin(), candidates.end(), [&](const auto& candidate) {
    const auto [ring, polygon] = candidate;
    return !is_inside(ring, polygon) || report_inside(ring, polygon);
  });
}

}  // namespace sunder::planar
