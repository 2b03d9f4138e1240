// Runs of edges of the one and of the other whose boxes meet are taken apart together, down to edges.
//
// Let no edges of two polygons meet. Then a ring is inside of the other polygon, or outside, as a whole, and polygons
// that have a common point have a ring of one inside of the other: what they have in common has a boundary, of which
// each point is on a ring of one and inside of the other.
#include <sunder/base/interruption.h>
#include <sunder/base/lanes.h>
#include <sunder/near/box_pairs.h>
#include <sunder/planar/polygons/crossing_edges.h>
#include <sunder/planar/polygons/polygon_pairs.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace sunder::planar {

namespace {

constexpr std::uint32_t fan = EdgeBoxes::fan;

// A bit for each box that meets the box. Without branches, here and below: no one can predict these.
std::uint32_t meeting(std::span<const FourBoxes> boxes, const CoarseBox& box) {
  const FourBoxes four = FourBoxes::all(box);
  std::uint32_t bits = 0, shift = 0;
  for (const FourBoxes& some : boxes) {
    bits |= meeting(some, four) << shift;
    shift += fan;
  }
  return bits;
}

// The number of the lowest bit, which is taken away. Requires that there is one.
std::uint32_t take_bit(std::uint32_t& bits) {
  const int k = std::countr_zero(bits);
  bits &= bits - 1;
  return static_cast<std::uint32_t>(k);
}

std::span<const FourBoxes> top_level(const Polygon& polygon) {
  return polygon.edge_boxes().level(polygon.edge_boxes().top());
}

void prefetch_bytes(const void* begin, std::size_t bytes) {
  constexpr std::size_t line = 64;
  const char* const first = static_cast<const char*>(begin);
  for (std::size_t at = 0; at < bytes; at += line) __builtin_prefetch(first + at);
}

void prefetch_contents(const Polygon& polygon) {
  const std::span<const FourBoxes> runs = top_level(polygon);
  prefetch_bytes(runs.data(), runs.size_bytes());
  prefetch_bytes(polygon.vertices().data(), polygon.size() * sizeof(Point2));
}

void prefetch_boxes(const Polygon& polygon) {
  const std::span<const FourBoxes> runs = top_level(polygon);
  __builtin_prefetch(&runs.front());
  __builtin_prefetch(&runs.back());
}

// May a ring of the one be inside of the other?
bool may_be_inside(const Polygon& inner, const Polygon& outer) {
  return inner.ring_count() > 1 || holds(outer.box(), inner.box());
}

// May an edge in the box be below the point?
bool is_above(const Point2& p, const CoarseBox& coarse) {
  const LanesBox box = coarse.in_doubles();
  return box.low[0] <= p.x && p.x <= box.high[0] && box.low[1] <= p.y;
}

}  // namespace

// The boxes of the edges of a run, two in Lanes. For edges that are not there, boxes that meet none.
struct PolygonPairs::Edges {
  std::array<Lanes, fan / 2> left, right, bottom, top;

  static Edges of_run(const Polygon& polygon, std::uint32_t run) {
    const std::uint32_t first = fan * run, size = polygon.size();
    if (polygon.ring_count() == 1 && first + fan <= size) {  // most runs
      const Point2* const v = polygon.vertices().data();
      const Point2* const w = v + first;
      const Point2& end = *(first + fan < size ? w + fan : v);
      return {{w[0], w[1], w[2], w[3]}, {w[1], w[2], w[3], end}};
    }
    constexpr double none = std::numeric_limits<double>::quiet_NaN();  // compares as false
    std::array<Point2, fan> from, to;
    from.fill({none, none});
    to = from;
    for (std::uint32_t k = 0; k < std::min(fan, size - first); ++k) {
      const Segment edge = polygon.edge(first + k);
      from[k] = edge.a;
      to[k] = edge.b;
    }
    return {from, to};
  }

  bool any_meets(const CoarseBox& box) const {
    const auto twice = [](float x) { return Lanes{static_cast<double>(x), static_cast<double>(x)}; };
    const Lanes l = twice(box.left), r = twice(box.right), b = twice(box.bottom), t = twice(box.top);
    return bits_of(meeting(l, r, b, t, 0) | meeting(l, r, b, t, 1)) != 0;
  }

  // Bit fan e + f: do the boxes of edge e of the one and edge f of the other meet?
  static std::uint32_t meeting(const Edges& one, const Edges& other) {
    const auto of_edge = [&](std::uint32_t e) {
      const auto twice = [e](const std::array<Lanes, 2>& x) { return Lanes{x[e / 2][e % 2], x[e / 2][e % 2]}; };
      const Lanes l = twice(one.left), r = twice(one.right), b = twice(one.bottom), t = twice(one.top);
      return (bits_of(other.meeting(l, r, b, t, 0)) | bits_of(other.meeting(l, r, b, t, 1)) << 2) << (fan * e);
    };
    return of_edge(0) | of_edge(1) | of_edge(2) | of_edge(3);  // written out: a loop would not keep them in registers
  }

 private:
  static_assert(fan == 4);

  Edges(const std::array<Point2, fan>& from, const std::array<Point2, fan>& to) {
    for (std::uint32_t k = 0; k < fan / 2; ++k) {
      const LanesBox a = lanes_box_of(from[2 * k], to[2 * k]), b = lanes_box_of(from[2 * k + 1], to[2 * k + 1]);
      left[k] = Lanes{a.low[0], b.low[0]};
      right[k] = Lanes{a.high[0], b.high[0]};
      bottom[k] = Lanes{a.low[1], b.low[1]};
      top[k] = Lanes{a.high[1], b.high[1]};
    }
  }

  // Which boxes of half k, of edges 2 k and 2 k + 1, meet the box with these sides?
  LanesMask meeting(Lanes l, Lanes r, Lanes b, Lanes t, std::uint32_t k) const {
    return is_at_most(l, right[k]) & is_at_most(left[k], r) & is_at_most(b, top[k]) & is_at_most(bottom[k], t);
  }
};

// Each of these returns false when it has found a contact of edges, or gives up.
bool PolygonPairs::compare(const Polygon& a, const Polygon& b) {
  const CoarseBox common = common_part(a.edge_boxes().whole(), b.edge_boxes().whole());
  const std::span<const FourBoxes> of_a = top_level(a), of_b = top_level(b);
  cost.probes += fan * of_a.size();
  std::uint32_t in_a = meeting(of_a, common);
  const bool are_edges = a.edge_boxes().top() == 0 && b.edge_boxes().top() == 0;
  near_count_ = 0;  // where it gave up, some were left
  near_bits_ = 0;
  while (in_a != 0) {
    const std::uint32_t r = take_bit(in_a);
    cost.probes += fan * of_b.size();
    std::uint32_t near = meeting(of_b, of_a[r / fan][r % fan]);
    if (near == 0) continue;
    const Run run{a, a.edge_boxes().top(), r};
    if (are_edges) {
      const Edges of_run = Edges::of_run(a, r);
      while (near != 0) {
        if (!add_near(of_run, run, {b, 0, take_bit(near)})) return false;
      }
    }
    while (near != 0) {
      if (!compare_runs(run, {b, b.edge_boxes().top(), take_bit(near)})) return false;
    }
  }
  return compare_near(a, b);
}

// Their boxes meet.
bool PolygonPairs::compare_runs(const Run& r, const Run& s) {
  if (gave_up()) return false;
  if (r.level == 0 && s.level == 0) return add_near(Edges::of_run(r.polygon, r.number), r, s);
  const bool first = r.level >= s.level;
  const Run &parted = first ? r : s, &whole = first ? s : r;
  const FourBoxes& parts = parted.polygon.edge_boxes().level(parted.level - 1)[parted.number];
  std::uint32_t near = meeting(parts, FourBoxes::all(whole.polygon.edge_boxes().box(whole.level, whole.number)));
  cost.probes += fan;
  while (near != 0) {
    const Run part{parted.polygon, parted.level - 1, fan * parted.number + take_bit(near)};
    if (!(first ? compare_runs(part, s) : compare_runs(r, part))) return false;
  }
  return true;
}

bool PolygonPairs::add_near(const Edges& of_r, const Run& r, const Run& s) {
  cost.probes += fan;
  if (!of_r.any_meets(s.polygon.edge_boxes().box(0, s.number))) return true;
  cost.probes += fan;
  const std::uint64_t bits = Edges::meeting(of_r, Edges::of_run(s.polygon, s.number));
  static_assert(fan * fan * most_near <= 64);
  near_bits_ |= bits << (fan * fan * near_count_);
  near_[near_count_++] = {fan * r.number, fan * s.number};
  return near_count_ < wait_for_ || compare_near(r.polygon, s.polygon);
}

bool PolygonPairs::compare_near(const Polygon& a, const Polygon& b) {
  if (gave_up()) return false;
  std::uint64_t bits = std::exchange(near_bits_, 0);
  near_count_ = 0;
  const Point2* const of_a = a.vertices().data();
  const Point2* const of_b = b.vertices().data();
  // Below these, the next one is the next number.
  const std::uint32_t last_a = a.ring_count() == 1 ? a.size() - 1 : 0, last_b = b.ring_count() == 1 ? b.size() - 1 : 0;
  while (bits != 0) {
    const std::uint32_t pair = static_cast<std::uint32_t>(std::countr_zero(bits));
    bits &= bits - 1;
    const Near& near = near_[pair / (fan * fan)];
    const std::uint32_t e = near.first_of_a + pair / fan % fan, f = near.first_of_b + pair % fan;
    const Point2 &p = of_a[e], &p_end = of_a[e < last_a ? e + 1 : a.next(e)];
    const Point2 &q = of_b[f], &q_end = of_b[f < last_b ? f + 1 : b.next(f)];
    const Guess cross = surely_cross_2d(p, p_end, q, q_end);
    if (cross == Guess::negative) continue;
    const ContactKind kind =
        cross == Guess::positive ? ContactKind::crossing : segment_segment(sorted({p, p_end}), sorted({q, q_end}));
    if (kind == ContactKind::none) continue;
    const bool overlap = kind == ContactKind::crossing && overlap_at_crossing(a, e, b, f, cost.probes);
    found_.contact = overlap ? Relation::overlapping : Relation::touching;
    found_.kind = kind;
    found_.of_i = e;
    found_.of_j = f;
    return false;
  }
  return true;
}

// Is the number of edges of the run that are below the point odd? (ring_tests.h says what is below.)
bool PolygonPairs::is_odd_below(const Run& r, const Point2& p) {
  bool odd = false;
  if (r.level > 0) {
    const FourBoxes& parts = r.polygon.edge_boxes().level(r.level - 1)[r.number];
    cost.probes += 2 * fan;  // one by one, they take twice as long as four at once
    for (std::uint32_t k = 0; k < fan; ++k) {
      if (is_above(p, parts[k])) odd ^= is_odd_below({r.polygon, r.level - 1, fan * r.number + k}, p);
    }
    return odd;
  }
  cost.probes += 2 * fan;
  for (std::uint32_t k = fan * r.number; k < std::min(fan * (r.number + 1), r.polygon.size()); ++k) {
    const Segment edge = sorted(r.polygon.edge(k));
    if (lexicographically_less(p, edge.a) || !lexicographically_less(p, edge.b)) continue;
    odd ^= orient_2d(edge.a, edge.b, p) == Sign::positive;
  }
  return odd;
}

// Requires that the point is on no edge.
bool PolygonPairs::is_inside(const Polygon& polygon, const Point2& p) {
  bool inside = false;
  const std::span<const FourBoxes> runs = top_level(polygon);
  cost.probes += fan * runs.size();
  for (std::uint32_t k = 0; k < fan * runs.size(); ++k) {
    if (is_above(p, runs[k / fan][k % fan])) inside ^= is_odd_below({polygon, polygon.edge_boxes().top(), k}, p);
  }
  return inside;
}

// The first vertex of a ring of the one that is inside of the other. Requires that no edges of them meet.
std::optional<std::uint32_t> PolygonPairs::vertex_inside(const Polygon& inner, const Polygon& outer) {
  for (std::uint32_t ring = 0; ring < inner.ring_count() && !gave_up(); ++ring) {
    const Point2& v = inner.vertices()[inner.ring_begin(ring)];
    ++cost.probes;
    if (holds(outer.box(), {v, v}) && is_inside(outer, v)) return inner.ring_begin(ring);
  }
  return std::nullopt;
}

std::optional<PolygonsContact> PolygonPairs::contact(std::uint32_t i, std::uint32_t j) {
  const Polygon &a = polygons_[i], &b = polygons_[j];
  found_ = {Relation::none, ContactKind::none, false, i, j, 0, 0};
  const bool are_apart = compare(a, b);
  wait_for_ = are_apart ? most_near : 1;
  if (!are_apart) {
    if (found_.contact == Relation::none) return std::nullopt;
    if (found_.contact == Relation::overlapping) return found_;
    const PolygonsAnswer pair = polygons_contact(a, b);
    constexpr std::uint64_t of_a_call = 256;  // it takes as long as so many looks, beside what it counts
    cost.probes += of_a_call + pair.cost.probes;
    if (!pair.meet()) return std::nullopt;  // of polygons whose own rings cross
    found_ = *pair.found;
    found_.i = i;
    found_.j = j;
    return found_;
  }
  if (may_be_inside(a, b)) {
    if (const auto vertex = vertex_inside(a, b)) {
      return PolygonsContact{Relation::overlapping, ContactKind::none, true, i, j, *vertex, 0};
    }
  }
  if (may_be_inside(b, a)) {
    if (const auto vertex = vertex_inside(b, a)) {
      return PolygonsContact{Relation::overlapping, ContactKind::none, false, i, j, 0, *vertex};
    }
  }
  if (gave_up()) return std::nullopt;
  return found_;
}

std::optional<bool> for_each_meeting_pair(std::span<const Polygon> polygons, const SetOptions& options, Cost& cost,
                                          const std::function<bool(const PolygonsContact&)>& found,
                                          const std::uint32_t* end) {
  // To look at an edge takes a hundredth of the time that it takes to put it in a grid, or a sweep.
  constexpr std::uint64_t looks = 64, looks_for_found = 16;
  // So many that they stay in the cache until they are looked at.
  constexpr std::uint64_t few = 1 << 13;
  std::vector<Box2> boxes;
  boxes.reserve(polygons.size());
  std::uint64_t edges = 0;
  for (const Polygon& polygon : polygons) {
    boxes.push_back(polygon.box());
    edges += polygon.size();
    if (edges <= few) prefetch_contents(polygon);
  }
  PolygonPairs pairs(polygons, looks * edges);
  bool was_stopped = false;  // else, where it ends early, it gave up
  // A pair waits until the next ones are known; meanwhile first its polygons, then their boxes come from memory.
  constexpr std::uint32_t most_waiting = 4;
  std::array<std::array<std::uint32_t, 2>, most_waiting> waiting;  // pair k is at k % most_waiting
  std::uint32_t known = 0, compared = 0;
  const auto compare_next = [&] {
    may_be_interrupted(2);
    const auto [i, j] = waiting[compared++ % most_waiting];
    const std::optional<PolygonsContact> contact = pairs.contact(i, j);
    if (!contact || contact->contact == Relation::none) return contact.has_value();
    if (counts(*contact, options.allowed)) pairs.allow(looks_for_found);
    was_stopped = !found(*contact);
    return !was_stopped;
  };
  const auto of_pair = [&](std::uint32_t i, std::uint32_t j) {
    ++pairs.cost.probes;
    if (end != nullptr && i >= *end) return !pairs.gave_up();
    prefetch_bytes(&polygons[i], sizeof(Polygon));
    prefetch_bytes(&polygons[j], sizeof(Polygon));
    if (known > 0) {
      for (const std::uint32_t polygon : waiting[(known - 1) % most_waiting]) prefetch_boxes(polygons[polygon]);
    }
    waiting[known++ % most_waiting] = {i, j};
    return known - compared < most_waiting || compare_next();
  };
  bool all = for_each_box_pair(boxes, of_pair, options.progress, &cost.probes, options.groups);
  while (all && compared != known) all = compare_next();
  cost.probes += pairs.cost.probes;
  if (!all && !was_stopped) return std::nullopt;
  return all;
}

}  // namespace sunder::planar
