// 1. Edges that cross or overlap, as with segments. 2. A sweep over the rest: where rings come together, and in which
// order around the point; there they may cross in a vertex. 3. Rings cut where they touch themselves, and what lies
// within what. 4. The graph of these loops and the points where they meet.
//
// Why the graph tells whether the interior is connected: loops that do not cross, side by side within one, part the
// plane into as many faces as they are, plus one, plus one for each cycle (Euler's formula: a loop that visits k points
// has k edges). The faces besides the interior are the outside and the inside of each loop but the outermost one.
#include <sunder/base/names.h>
#include <sunder/planar/polygons/polygon_simple.h>
#include <sunder/planar/polygons/polygon_valid.h>
#include <sunder/planar/polygons/ring_loops.h>
#include <sunder/planar/polygons/ring_points.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/sweep/ends_in_order.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <tuple>
#include <utility>

namespace sunder::planar {

namespace {

using Kind = PolygonDefectKind;
constexpr std::uint32_t none = RingLoop::none;

class Check {
 public:
  Check(RingSet rings, const ValidOptions& options) : rings_(std::move(rings)), options_(options) {}

  // All but those that contacts_ has.
  PolygonDefects run() {
    if (options_.rule == PolygonRule::simple) look_for_repetitions();
    look_for_short_rings();
    edges_ = Segments(rings_.edges());
    if (!is_simple_ring()) look_at_several();
    std::vector<PolygonDefect>& defects = answer_.found;
    if (full()) {
      const auto enough = defects.begin() + static_cast<std::ptrdiff_t>(options_.most);
      std::partial_sort(defects.begin(), enough, defects.end(), is_before);
      defects.resize(options_.most);
    } else {
      std::sort(defects.begin(), defects.end(), is_before);
    }
    return std::move(answer_);
  }

  CountAnswer<> visit(const PolygonDefectVisitor& visit) {
    is_visited_ = true;
    const PolygonDefects others = run();
    auto next = others.found.begin();
    bool goes_on = true;
    const auto hand_over = [&](const PolygonDefect& d) {
      for (; goes_on && next != others.found.end() && is_before(*next, d); ++next) goes_on = visit(*next);
      return goes_on = goes_on && visit(d);
    };
    for (const Kind kind : {Kind::crossing, Kind::overlap}) {
      if (!contacts_ || !goes_on) break;
      contacts_->visit([&](const SegmentsContact& c) { return kind_of(c) != kind || hand_over(defect_of(c)); });
    }
    for (; goes_on && next != others.found.end(); ++next) goes_on = visit(*next);
    return {others.found.size() + (contacts_ ? contacts_->count() : 0), others.cost};
  }

 private:
  static bool is_before(const PolygonDefect& c, const PolygonDefect& d) {
    const auto& [p, q] = c.place;
    const auto& [r, s] = d.place;
    return std::tie(c.kind, c.a, c.b, p.x, p.y, q.x, q.y) < std::tie(d.kind, d.a, d.b, r.x, r.y, s.x, s.y);
  }

  bool full() const { return answer_.found.size() >= options_.most; }

  static RingPlace place_of(const RingSet& rings, std::uint32_t edge) {
    const RingSet::Ring& ring = rings.rings()[rings.ring_of(edge)];
    return {ring.part, ring.number, rings.given(edge)};
  }
  RingPlace place_of(std::uint32_t edge) const { return place_of(rings_, edge); }
  void add(Kind kind, const RingPlace& a, const RingPlace& b, const Segment& place) {
    answer_.found.push_back({kind, a, b, place});
  }
  void add(Kind kind, const RingWay& v, const RingWay& w, const Point2& at) {
    add(kind, place_of(v.edge), place_of(w.edge), {at, at});
  }

  // Rings are left out by leaving out the later one.
  void leave_out(std::uint32_t ring, std::uint32_t other) { keep_[std::max(ring, other)] = false; }
  void drop() {
    if (std::find(keep_.begin(), keep_.end(), false) == keep_.end()) return;
    rings_ = rings_.only(keep_);
    keep_.assign(rings_.rings().size(), true);
  }

  void look_for_repetitions() {
    for (const RingSet::Ring& ring : rings_.rings()) {
      for (std::uint32_t k = ring.begin; k < ring.end; ++k) {
        // The vertices after that of the edge that comes before are equal, up to this one.
        const std::uint32_t first = k == ring.begin ? 0 : rings_.given(k - 1) + 1;
        const Point2& p = rings_.vertex(k);
        for (std::uint32_t v = first; v < rings_.given(k); ++v) {
          add(Kind::repeated_vertex, {ring.part, ring.number, v}, {ring.part, ring.number, v + 1}, {p, p});
        }
      }
      if (ring.begin == ring.end) continue;
      const Point2& p = rings_.vertex(ring.begin);
      for (std::uint32_t v = rings_.given(ring.end - 1) + 1; v < ring.given; ++v) {  // those before the first one
        add(Kind::repeated_vertex, {ring.part, ring.number, v}, {ring.part, ring.number, (v + 1) % ring.given}, {p, p});
      }
    }
  }

  void look_for_short_rings() {
    keep_.assign(rings_.rings().size(), true);
    for (std::uint32_t r = 0; r < rings_.rings().size(); ++r) {
      const RingSet::Ring& ring = rings_.rings()[r];
      if (ring.end - ring.begin >= 3) continue;
      const RingPlace place{ring.part, ring.number, 0};
      const Point2 at = ring.begin == ring.end ? Point2{} : rings_.vertex(ring.begin);
      add(Kind::too_few_points, place, place, {at, at});
      keep_[r] = false;
    }
    drop();
  }

  // Is there one ring, and nothing wrong with it? Mostly so, and found faster.
  bool is_simple_ring() {
    if (rings_.rings().size() != 1) return rings_.rings().empty();
    const std::span<const Point2> ring = rings_.vertices();
    const Polygon polygon(PolygonRings{{ring.begin(), ring.end()}});
    const PolygonSimpleAnswer answer = polygon_simple(polygon, edges_, ends_);
    answer_.cost.probes += answer.cost.probes;
    return !answer.meet();
  }

  void look_at_several() {
    if (full()) return;
    const bool are_all = !look_at_edges();
    if (full()) return;
    if (are_all) {
      if (ends_.empty()) ends_ = ends_in_order(edges_.all());
      points_ = ring_points(rings_, edges_.all(), ends_);
    } else {
      points_ = ring_points(rings_);
    }
    answer_.cost.probes += points_.cost.probes;
    if (look_for_crossings_in_points()) {
      if (full()) return;
      drop();
      points_ = ring_points(rings_);
      answer_.cost.probes += points_.cost.probes;
    }
    loops_ = ring_loops(rings_, points_);
    find_ways_where_cut();
    look_for_touches();
    look_within();
    look_for_cycles();
  }

  // Are there crossings or overlaps? Then some rings are left out.
  bool look_at_edges() {
    const SegmentsAnswer any = ends_.empty() ? segments_any(edges_, {Allowed::touch})
                                             : segments_any_by_sweep_over(edges_, ends_, {Allowed::touch});
    answer_.cost.probes += any.cost.probes;
    if (!any.meet()) return false;
    rings_of_edges_ = rings_;
    if (is_visited_) {
      keep_contacts();
    } else if (options_.most == 1) {
      answer_.found.push_back(defect_of(*any.found));
      return true;
    } else {
      answer_.cost.probes += segments_visit(edges_, {Allowed::touch}, [&](const SegmentsContact& c) {
                               answer_.found.push_back(defect_of(c));
                               leave_out(rings_.ring_of(c.i), rings_.ring_of(c.j));
                               return !full();
                             }).probes;
    }
    drop();
    return true;
  }

  // As many as may be held; the others are asked for again when they are visited.
  void keep_contacts() {
    contacts_ = std::make_unique<ContactsInOrder<SegmentsContact>>(
        edges_.size(), most_held(edges_.size()), [this](const Block& block, const auto& take) {
          const bool is_first = contacts_ == nullptr;
          const Cost cost =
              segments_visit_block(edges_, {Allowed::touch}, block, segments_visit, [&](const SegmentsContact& c) {
                if (is_first) leave_out(rings_of_edges_.ring_of(c.i), rings_of_edges_.ring_of(c.j));
                take(c);
                return true;
              });
          if (is_first) answer_.cost.probes += cost.probes;
        });
  }

  static Kind kind_of(const SegmentsContact& c) {
    return c.kind == ContactKind::overlap ? Kind::overlap : Kind::crossing;
  }

  PolygonDefect defect_of(const SegmentsContact& c) const {
    const Segment &s = edges_[c.i], &t = edges_[c.j];
    const Point2 at = c.kind == ContactKind::overlap ? Point2{} : common_point_rounded(s, t);
    const Segment place = c.kind != ContactKind::overlap ? Segment{at, at} : common_part(s, t);
    return {kind_of(c), place_of(rings_of_edges_, c.i), place_of(rings_of_edges_, c.j), place};
  }

  // Around a point two passes cross iff their ways alternate: where one is left that was entered before others that
  // have not been left yet, it crosses these.
  bool look_for_crossings_in_points() {
    const std::size_t before = answer_.found.size();
    std::vector<RingWay> open;
    std::vector<bool> is_open(std::size_t{2} * rings_.size());  // of each pass
    for (const RingPoint& point : points_.points) {
      for (const RingWay& way : points_.ways_at(point)) {
        is_open[way.pass].flip();
        if (is_open[way.pass]) {
          open.push_back(way);
          continue;
        }
        std::size_t at = open.size() - 1;
        for (; open[at].pass != way.pass; --at) {
          const auto [a, b] = std::minmax({place_of(edge_of(way)), place_of(edge_of(open[at]))});
          add(Kind::crossing, a, b, {point.at, point.at});
          leave_out(rings_.ring_of(way.edge), rings_.ring_of(open[at].edge));
          if (full()) return true;
        }
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(at));
      }
    }
    return answer_.found.size() > before;
  }
  // The edge that begins at the vertex of a pass, or passes through it.
  std::uint32_t edge_of(const RingWay& way) const {
    return way.pass < rings_.size() ? way.pass : way.pass - rings_.size();
  }

  void look_for_touches() {
    if (options_.rule == PolygonRule::self_touch) return;
    std::vector<RingWay> passes;  // of a point, by rings
    for (const RingPoint& point : points_.points) {
      passes.clear();
      for (const RingWay& way : points_.ways_at(point)) {
        if (way.forward) passes.push_back(way);
      }
      std::sort(passes.begin(), passes.end(), [](const RingWay& v, const RingWay& w) { return v.edge < w.edge; });
      for (std::size_t k = 1; k < passes.size(); ++k) {
        const RingWay &v = passes[k - 1], &w = passes[k];
        if (rings_.ring_of(v.edge) == rings_.ring_of(w.edge)) {
          add(Kind::self_touch, v, w, point.at);
        } else if (options_.rule == PolygonRule::simple && part_of(v.edge) == part_of(w.edge)) {
          add(Kind::rings_touch, v, w, point.at);
        }
      }
    }
  }
  std::uint32_t part_of(std::uint32_t edge) const { return rings_.rings()[rings_.ring_of(edge)].part; }

  // What is known of a loop within its part.
  struct Within {
    std::uint32_t parent = none;  // the innermost loop of its part that it is inside of, but for misplaced ones
    std::uint32_t around = none;  // the same of any part that has its shell
    std::uint32_t depth = 0;      // how many such loops of its part; one more where the shell has been left out
    bool is_misplaced = false;    // a hole where none may be
  };

  // Of each loop that was cut from the rest, its first and its last way where it was.
  void find_ways_where_cut() {
    ways_where_cut_.assign(loops_.loops.size(), {none, none});
    for (std::uint32_t p = 0; p < points_.points.size(); ++p) {
      const RingPoint& point = points_.points[p];
      for (std::uint32_t w = point.first; w < point.first + point.count; ++w) {
        ++answer_.cost.probes;
        const std::uint32_t loop = loops_.of_ways[w];
        if (loops_.loops[loop].cut_at != p) continue;
        auto& [first, last] = ways_where_cut_[loop];
        if (first == none) first = w;
        last = w;
      }
    }
  }

  // All loops, each after those that it is inside of; `way_in_` has for each part the innermost one at present.
  void look_within() {
    const std::vector<RingLoop>& loops = loops_.loops;
    const std::uint32_t count = static_cast<std::uint32_t>(loops.size());
    std::uint32_t parts = 0;
    for (const RingSet::Ring& ring : rings_.rings()) parts = std::max(parts, ring.part + 1);
    innermost_.assign(parts, none);
    outermost_.assign(parts, none);
    has_shell_.assign(parts, false);
    is_named_.assign(rings_.rings().size(), false);
    for (const RingSet::Ring& ring : rings_.rings()) {
      if (ring.number == 0) has_shell_[ring.part] = true;
    }
    within_.assign(count, {});
    std::vector<std::uint32_t> first_inside(count + 1, none), next(count, none);  // the last entry: of no parent
    for (std::uint32_t k = count; k-- > 0;) {
      std::uint32_t& first = first_inside[std::min(loops[k].parent, count)];
      next[k] = std::exchange(first, k);
    }
    for (std::uint32_t k = first_inside[count]; k != none;) {
      enter(k);
      if (first_inside[k] != none) {
        k = first_inside[k];
        continue;
      }
      leave(k);
      while (next[k] == none && loops[k].parent != none) leave(k = loops[k].parent);
      k = next[k];
    }
  }

  const RingSet::Ring& ring_of(std::uint32_t loop) const { return rings_.rings()[loops_.loops[loop].ring]; }

  void enter(std::uint32_t loop) {
    const RingSet::Ring& ring = ring_of(loop);
    Within& here = within_[loop];
    here.parent = innermost_[ring.part];
    here.around = loops_.loops[loop].parent;
    if (here.around != none && (within_[here.around].is_misplaced || !has_shell_[ring_of(here.around).part])) {
      here.around = within_[here.around].around;
    }
    here.depth = here.parent != none ? within_[here.parent].depth + 1 : has_shell_[ring.part] ? 0 : 1;
    if (ring.number == 0) {
      enter_of_shell(loop, here);
    } else if (here.parent != none && loops_.loops[here.parent].ring == loops_.loops[loop].ring) {
      name_disconnected(loop, here.parent);
    } else if (here.parent != none && ring_of(here.parent).number != 0) {
      here.is_misplaced = true;
      name(Kind::nested_holes, loop, here.parent);
    } else if (here.depth % 2 == 0) {
      here.is_misplaced = true;
      name(Kind::hole_outside, loop, none);
    }
    if (!here.is_misplaced) innermost_[ring.part] = loop;
  }
  void enter_of_shell(std::uint32_t loop, const Within& here) {
    std::uint32_t& outermost = outermost_[ring_of(loop).part];
    if (here.parent == none) look_outside(loop);
    if (outermost == none) {
      outermost = loop;
    } else if (here.depth % 2 == 0) {
      name_disconnected(loop, outermost);
    }
  }
  void leave(std::uint32_t loop) {
    if (!within_[loop].is_misplaced) innermost_[ring_of(loop).part] = within_[loop].parent;
  }

  // An outermost loop of a part: is it in the interior of another part?
  void look_outside(std::uint32_t loop) {
    const std::uint32_t around = within_[loop].around;
    if (around != none && within_[around].depth % 2 == 0) name(Kind::nested_parts, loop, around);
  }

  // Once for each ring.
  void name(Kind kind, std::uint32_t loop, std::uint32_t other) {
    const RingLoop& inner = loops_.loops[loop];
    if (is_named_[inner.ring]) return;
    is_named_[inner.ring] = true;
    const std::uint32_t edge = points_.ways[inner.first].edge;
    const RingPlace place = place_of(edge);
    const std::uint32_t part = ring_of(other == none ? loop : other).part;
    const Point2& at = rings_.vertex(edge);
    add(kind, place, {part, other == none ? 0 : ring_of(other).number, 0}, {at, at});
  }
  // Two loops of a ring, of which one is where it parts the interior. At least one was cut from the rest.
  void name_disconnected(std::uint32_t loop, std::uint32_t other) {
    if (loops_.loops[loop].cut_at == none) loop = other;
    const RingPoint& point = points_.points[loops_.loops[loop].cut_at];
    const auto [first, last] = ways_where_cut_[loop];
    add(Kind::disconnected, points_.ways[first], points_.ways[last], point.at);
  }

  // Loops that have met are joined; two that have, and meet again, close a cycle.
  void look_for_cycles() {
    std::vector<std::uint32_t> joined(loops_.loops.size());
    std::iota(joined.begin(), joined.end(), 0u);
    const auto representative = [&](std::uint32_t loop) {
      while (joined[loop] != loop) loop = joined[loop] = joined[joined[loop]];
      return loop;
    };
    std::vector<std::array<std::uint32_t, 3>> here;  // of a point: parts, loops, a way of each
    for (const RingPoint& point : points_.points) {
      here.clear();
      for (std::uint32_t w = point.first; w < point.first + point.count; ++w) {
        const std::uint32_t loop = loops_.of_ways[w];
        if (!within_[loop].is_misplaced) here.push_back({ring_of(loop).part, loop, w});
      }
      std::sort(here.begin(), here.end());
      for (std::size_t k = 1; k < here.size(); ++k) {
        const auto& [part, loop, way] = here[k - 1];
        const auto& [other_part, other, other_way] = here[k];
        if (part != other_part || loop == other) continue;
        const std::uint32_t a = representative(loop), b = representative(other);
        if (a == b) {
          add(Kind::disconnected, points_.ways[way], points_.ways[other_way], point.at);
        } else {
          joined[a] = b;
        }
      }
    }
  }

  RingSet rings_;
  const ValidOptions& options_;
  bool is_visited_ = false;
  PolygonDefects answer_;
  Segments edges_{{}};                                          // of the rings that are not too short
  std::vector<std::uint32_t> ends_;                             // of these in order; empty: not asked for yet
  RingSet rings_of_edges_;                                      // those, where edges cross or overlap
  std::unique_ptr<ContactsInOrder<SegmentsContact>> contacts_;  // that are defects; null: they are in answer_
  std::vector<bool> keep_;                                      // of each ring
  RingPoints points_;
  RingLoops loops_;
  std::vector<std::array<std::uint32_t, 2>> ways_where_cut_;  // of each loop
  std::vector<Within> within_;                                // of each loop
  std::vector<std::uint32_t> innermost_;                      // of each part: the loop that has been entered last
  std::vector<std::uint32_t> outermost_;                      // of each part: a loop of the shell
  std::vector<bool> has_shell_, is_named_;                    // of each part; of each ring
};

RingSet rings_of(std::span<const PolygonRings> parts) {
  RingSet rings;
  for (std::uint32_t p = 0; p < parts.size(); ++p) {
    for (std::uint32_t r = 0; r < parts[p].size(); ++r) rings.add(p, r, parts[p][r]);
  }
  return rings;
}

}  // namespace

std::string_view name_of(PolygonDefectKind kind) {
  return name_in<Kind::nested_parts>({"too-few-points", "crossing", "overlap", "repeated-vertex", "self-touch",
                                      "rings-touch", "hole-outside", "nested-holes", "disconnected", "nested-parts"},
                                     kind);
}

PolygonDefects polygon_defects(std::span<const PolygonRings> parts, const ValidOptions& options) {
  return Check(rings_of(parts), options).run();
}

CountAnswer<> visit_polygon_defects(std::span<const PolygonRings> parts, const ValidOptions& options,
                                    const PolygonDefectVisitor& visit) {
  const ValidOptions all{options.rule};
  return Check(rings_of(parts), all).visit(visit);
}

PolygonDefects polygon_defects(std::span<const Polygon> parts, const ValidOptions& options) {
  RingSet rings;
  for (std::uint32_t p = 0; p < parts.size(); ++p) {
    for (std::uint32_t r = 0; r < parts[p].ring_count(); ++r) rings.add(p, r, parts[p].ring(r));
  }
  return Check(std::move(rings), options).run();
}

PolygonDefects polygon_defects(const Polygon& polygon, const ValidOptions& options) {
  return polygon_defects(std::span(&polygon, 1), options);
}

}  // namespace sunder::planar
