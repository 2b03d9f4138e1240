#include <sunder/planar/polygons/polygon_sweep.h>
#include <sunder/planar/sweep/ends_in_order.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace sunder::planar {

PolygonSweep::PolygonSweep(const PolygonEdges& edges, const SetOptions& options, PolygonPlace::Found found,
                           const std::uint32_t* end)
    : edges_(edges),
      options_(options),
      found_(std::move(found)),
      place_(edges, options, found_, end),
      status_(edges.edges().all()),
      crossings_(edges.edges()),
      above_of_(edges.edges().size(), PersistentSets::empty),
      fills_above_(edges.edges().size()),
      is_first_(edges.edges().size()),
      seen_(edges.polygon_count()),
      fills_(edges.polygon_count()) {
  number_by_group();
  find_firsts();
}

// Keys of one group follow each other, so that a set can be gone through without them.
void PolygonSweep::number_by_group() {
  const std::uint32_t count = edges_.polygon_count();
  const auto group_of = [&](std::uint32_t p) { return options_.groups.empty() ? p : options_.groups[p]; };
  polygon_at_.resize(count);
  std::iota(polygon_at_.begin(), polygon_at_.end(), 0u);
  std::sort(polygon_at_.begin(), polygon_at_.end(), [&](std::uint32_t p, std::uint32_t q) {
    return group_of(p) != group_of(q) ? group_of(p) < group_of(q) : p < q;
  });
  key_of_.resize(count);
  for (std::uint32_t key = 0; key < count; ++key) key_of_[polygon_at_[key]] = key;
  for (std::uint32_t first = 0, last; first < count; first = last) {
    for (last = first + 1; last < count && group_of(polygon_at_[last]) == group_of(polygon_at_[first]);) ++last;
    group_at_.resize(last, Block{first, last});
  }
}

// Of each ring, the edge that goes on from its first vertex, and has a length.
void PolygonSweep::find_firsts() {
  for (const PolygonEdges::Ring& ring : edges_.rings()) {
    const Polygon& polygon = edges_.polygon(ring.polygon);
    const std::vector<Point2>& v = polygon.vertices();
    std::uint32_t first = none;
    for (std::uint32_t k = polygon.ring_begin(ring.in_polygon); k < polygon.ring_begin(ring.in_polygon + 1); ++k) {
      ++cost.probes;
      if (v[k] == v[polygon.next(k)]) continue;
      if (first == none || lexicographically_less(v[k], v[first])) first = k;
    }
    if (first != none) is_first_[edges_.first_edge(ring.polygon) + first] = true;
  }
}

bool PolygonSweep::run() {
  if (are_one_group(options_.groups)) return true;
  const std::span<const Segment> all = edges_.edges().all();
  const std::vector<std::uint32_t> ends = ends_in_order(all);
  std::size_t e = 0;
  for (std::size_t step = 0; !stopped_ && (e < ends.size() || !crossings_.empty()); ++step) {
    tell_progress(options_, step, e, ends.size());
    Sign next = Sign::positive;
    if (!crossings_.empty()) {
      next = e == ends.size() ? Sign::negative : crossings_.next_minus(end_point(all, ends[e]));
    }
    if (next == Sign::negative) {
      at_crossing();
      continue;
    }
    const Point2& p = end_point(all, ends[e]);
    std::uint32_t held = next == Sign::zero ? crossings_.pop().lower : none;  // some edge in the list that holds p
    begins_.clear();
    for (; e < ends.size() && end_point(all, ends[e]) == p; ++e) {
      ++cost.probes;
      const std::uint32_t edge = ends[e] / 2;
      if (all[edge].a == all[edge].b) continue;
      if (ends[e] % 2 == 0) {
        begins_.push_back(edge);
      } else {
        held = edge;
      }
    }
    at_vertex(p, held);
  }
  cost.probes += place_.probes + crossings_.comparisons + sets_.steps;
  return !stopped_;
}

// --- The row at a point -------------------------------------------------------------------------------------------

void PolygonSweep::at_crossing() {
  const CrossingQueue::Event event = crossings_.pop();
  const Crossing p = crossings_.crossing_of(event);
  const Enclosure2 in = enclosure(p);
  gather(event.lower, [&](std::uint32_t e) {
    if (e == event.lower || e == event.upper) return true;
    ++cost.probes;
    return orient_2d(segment(e).a, segment(e).b, p, in) == Sign::zero;
  });
  begins_.clear();
  next_.assign(row_.rbegin(), row_.rend());
  vertex_ = nullptr;
  pass();
}

void PolygonSweep::at_vertex(const Point2& p, std::uint32_t held) {
  if (held == none) {
    if (begins_.empty()) return;
    row_.clear();
    const auto around = status_.around([&](const Segment& s) {
      ++cost.probes;
      return orient_2d(s.a, s.b, p) == Sign::positive;
    });
    below_ = around.below;
    above_ = around.above;
    if (above_ != none && side_of(p, above_) == Sign::zero) held = above_;
  }
  if (held != none) gather(held, [&](std::uint32_t e) { return side_of(p, e) == Sign::zero; });
  if (row_.size() == 1 && begins_.size() == 1 && segment(row_[0]).b == p &&
      edges_.polygon_of(row_[0]) == edges_.polygon_of(begins_[0])) {
    goes_on(row_[0], begins_[0]);
    return;
  }
  const auto lower = [&](std::uint32_t e, std::uint32_t f) { return is_lower(e, f, p); };
  passing_.clear();
  for (std::size_t k = row_.size(); k-- > 0;) {
    if (segment(row_[k]).b != p) passing_.push_back(row_[k]);
  }
  std::sort(begins_.begin(), begins_.end(), lower);
  next_.resize(passing_.size() + begins_.size());
  std::merge(passing_.begin(), passing_.end(), begins_.begin(), begins_.end(), next_.begin(), lower);
  vertex_ = &p;
  pass();
}

// The row around one that holds the point, and what stands next to it.
template <class Holds>
void PolygonSweep::gather(std::uint32_t held, const Holds& holds) {
  const auto around = status_.row_around(held, holds, row_);
  below_ = around.below;
  above_ = around.above;
}

// Of two that leave p to the right.
bool PolygonSweep::is_lower(std::uint32_t e, std::uint32_t f, const Point2& p) {
  ++cost.probes;
  return orient_2d(p, segment(e).b, segment(f).b) == Sign::positive;
}

// A polygon's edge ends where its next one begins, and nothing else is there.
void PolygonSweep::goes_on(std::uint32_t old, std::uint32_t next) {
  status_.replace(old, next);
  above_of_[next] = std::exchange(above_of_[old], PersistentSets::empty);
  fills_above_[next] = fills_above_[old];
  look_for_crossing(below_, next);
  look_for_crossing(next, above_);
}

void PolygonSweep::pass() {
  under_ = below_ == none ? PersistentSets::empty : above_of_[below_];
  find_sides();
  const bool only_cross = vertex_ == nullptr && row_.size() == 2;
  const bool is_more_wanted = only_cross ? report_crossing(row_[0], row_[1]) : !are_several() || look_around();
  stopped_ = !is_more_wanted || !look_inside();
  if (stopped_) return;
  put_row();
  look_for_crossing(below_, next_.empty() ? above_ : next_.front());
  if (!next_.empty()) look_for_crossing(next_.back(), above_);
}

// Which sides of next_ are filled: each polygon fills what is below its lowest edge, or not, and then in turn.
void PolygonSweep::find_sides() {
  ++point_;
  for (const std::uint32_t e : row_) {
    const std::uint32_t polygon = edges_.polygon_of(e);
    if (std::exchange(seen_[polygon], point_) != point_) fills_[polygon] = !fills_above_[e];
  }
  fills_next_.clear();
  for (const std::uint32_t e : next_) {
    ++cost.probes;
    const std::uint32_t polygon = edges_.polygon_of(e);
    if (std::exchange(seen_[polygon], point_) != point_) fills_[polygon] = sets_.holds(under_, key_of_[polygon]);
    fills_[polygon] = !fills_[polygon];
    fills_next_.push_back(fills_[polygon]);
  }
}

// Are there edges of several polygons, or just the list's?
bool PolygonSweep::are_several() const {
  const std::uint32_t polygon = edges_.polygon_of(row_.empty() ? next_.front() : row_.front());
  const auto is_other = [&](std::uint32_t e) { return edges_.polygon_of(e) != polygon; };
  return std::any_of(row_.begin(), row_.end(), is_other) || std::any_of(next_.begin(), next_.end(), is_other);
}

// Counter-clockwise from straight below: those to the right from below to above, then those to the left from above.
bool PolygonSweep::look_around() {
  leaving_.clear();
  const auto passes = [&](std::uint32_t e) {
    return vertex_ == nullptr || (segment(e).a != *vertex_ && segment(e).b != *vertex_);
  };
  const auto turns = [&](std::uint32_t e, const Point2& end) {
    ++cost.probes;
    return orient_2d(segment(e).a, segment(e).b, end) != Sign::zero;
  };
  for (std::size_t k = 0; k < next_.size(); ++k) {
    const bool is_another = k == 0 || turns(next_[k - 1], segment(next_[k]).b);
    leaving_.push_back({next_[k], fills_next_[k], passes(next_[k]), is_another});
  }
  for (std::size_t k = row_.size(); k-- > 0;) {
    const bool is_another = k + 1 == row_.size() || turns(row_[k + 1], segment(row_[k]).a);
    leaving_.push_back({row_[k], !fills_above_[row_[k]], passes(row_[k]), is_another});
  }
  return place_.look(leaving_);
}

// Two edges cross, and nothing else is there.
bool PolygonSweep::report_crossing(std::uint32_t e, std::uint32_t f) {
  const std::uint32_t p = edges_.polygon_of(e), q = edges_.polygon_of(f);
  ++cost.probes;
  if (p == q || may_meet(options_.groups, p, q) || !place_.is_wanted(p, q)) return true;
  return place_.report(Relation::overlapping, e, f, ContactKind::crossing);
}

// Rings that begin here are inside of those polygons that fill what is below, save of those that have edges here.
bool PolygonSweep::look_inside() {
  bool goes_on = true;
  for (const std::uint32_t e : begins_) {
    if (!is_first_[e]) continue;
    const auto [first, last] = group_at_[key_of_[edges_.polygon_of(e)]];
    sets_.for_each_without(under_, first, last - 1, [&](std::uint32_t key) {
      ++cost.probes;
      const std::uint32_t outer = polygon_at_[key];
      const bool is_asked = seen_[outer] != point_ && place_.is_wanted(edges_.polygon_of(e), outer);
      goes_on = goes_on && (!is_asked || report_inside(e, outer));
    });
    if (!goes_on) return false;
  }
  return true;
}

bool PolygonSweep::report_inside(std::uint32_t e, std::uint32_t outer) {
  const std::uint32_t inner = edges_.polygon_of(e), vertex = edges_.in_polygon(e);  // the edge goes on from there
  const bool first = inner < outer;
  return found_({Relation::overlapping, ContactKind::none, first, std::min(inner, outer), std::max(inner, outer),
                 first ? vertex : 0, first ? 0 : vertex});
}

// What is above the last of them is as before.
void PolygonSweep::put_row() {
  const PersistentSets::Set top = sets_.again(row_.empty() ? under_ : above_of_[row_.back()]);
  for (const std::uint32_t e : row_) {
    status_.erase(e);
    sets_.release(std::exchange(above_of_[e], PersistentSets::empty));
  }
  std::uint32_t below = below_;
  PersistentSets::Set under = under_;
  for (std::size_t k = 0; k < next_.size(); ++k) {
    const std::uint32_t e = next_[k];
    status_.insert_above(below, e);
    under = above_of_[e] = k + 1 == next_.size() ? top : sets_.toggled(under, key_of_[edges_.polygon_of(e)]);
    fills_above_[e] = fills_next_[k];
    below = e;
  }
  if (next_.empty()) sets_.release(top);
}

// --- Neighbours ---------------------------------------------------------------------------------------------------

Sign PolygonSweep::side_of(const Point2& p, std::uint32_t e) {
  ++cost.probes;
  return orient_2d(segment(e).a, segment(e).b, p);
}

// Two that are neighbours now: do they cross further on? Then the one that ends first does so on the wrong side.
void PolygonSweep::look_for_crossing(std::uint32_t lower, std::uint32_t upper) {
  if (lower == none || upper == none) return;
  const bool lower_ends_first = lexicographically_less(segment(lower).b, segment(upper).b);
  const Sign side = lower_ends_first ? side_of(segment(lower).b, upper) : -side_of(segment(upper).b, lower);
  if (side == Sign::positive) crossings_.push(lower, upper);
}

}  // namespace sunder::planar
