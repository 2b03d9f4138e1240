// Shamos & Hoey 1976, Theorem 6, with the details that the paper leaves to the implementor.
//
// The line sweeps lexicographically, as that of segments_any_by_sweep.cpp: at one point first the polygons that end
// there leave, then points come and go, then those that begin there enter. It cuts each polygon in a closed interval.
// Where no two polygons have a contact that counts, these intervals have no common inner points, and their order never
// changes, as polygons are convex.
//
// Order on the line. A polygon P that begins at p is above another one, Q, if p is above Q. Where p is in Q they meet,
// and they are tested at once. If that does not count, a line parts their relative interiors: P is above Q where p is
// on Q's upper chain only, and below it where p is on Q's lower chain only. On both chains p is where Q begins too, or
// inside Q, a segment: then P is above Q iff the first edge of P's lower chain does not point to the right of that of
// Q's upper chain. (P is no point then: one inside a segment counts, and points enter before all else that begins.)
// So the tests tell above, below, or a contact that counts, and what they call a contact stands in a row of the list.
//
// Why some contact that counts is found, if there is one. Let q be the lexicographically first limit of points that
// count (common points; where touching is allowed, common inner points), and A and B such a pair.
//   Both began before q: just before q those between A and B hold q in the limit, so they hold q. Where touching
//   counts, each two neighbours of the row from A to B were tested. Where it is allowed, those that end at q leave
//   first, then again each two neighbours of the row have been tested; if none of them counted, their order would hold
//   after q too, and with it that of A and B, which then would have no common inner points near q.
//   B begins at q, after A or there: take the first such B to enter. The order of those in the list is that after q, so
//   the search for the place of B comes upon what B has a contact with, as this stands in a row between what is below B
//   and what is above. Where touching counts, and A ends at q: two events are at one point, and some two that follow
//   each other are of different polygons. Where it is allowed, only equal points are left: these are such events too.
#include <sunder/planar/polygons/convex_chains.h>
#include <sunder/planar/polygons/convex_pair_test.h>
#include <sunder/planar/sweep/ends_in_order.h>
#include <sunder/planar/sweep/sweep_status.h>
#include <sunder/predicate/line/arrows.h>

namespace sunder::planar {

namespace {

struct InStatus {
  const ConvexPolygon* polygon = nullptr;
  std::uint32_t number = 0;
  double bottom = 0, top = 0;
};

constexpr std::uint32_t no_polygon = SweepStatus<InStatus>::none;

class Sweep {
 public:
  Sweep(std::span<const ConvexPolygon> polygons, const SetOptions& options)
      : polygons_(polygons), options_(options), keys_(keys_of(polygons)), status_(keys_) {}

  ConvexPolygonsAnswer run() {
    std::vector<Segment> spans;
    spans.reserve(polygons_.size());
    for (const ConvexPolygon& p : polygons_) spans.push_back({p[p.leftmost()], p[p.rightmost()]});
    const std::vector<std::uint32_t> ends = ends_in_order(spans);
    const auto at = [&](std::uint32_t end) { return end_point(spans, end); };
    const auto is_point = [&](std::uint32_t end) { return polygons_[end / 2].size() == 1; };
    for (std::size_t k = 0; k < ends.size() && !answer_.meet(); ++k) {
      tell_progress<16384>(options_, k, k, ends.size());
      const bool equal_counts =
          k + 1 < ends.size() && (options_.allowed != Allowed::touch || (is_point(ends[k]) && is_point(ends[k + 1])));
      if (equal_counts && ends[k] / 2 != ends[k + 1] / 2 && at(ends[k]) == at(ends[k + 1])) {
        report_pair(polygons_, ends[k] / 2, ends[k + 1] / 2, options_.allowed, answer_);
        if (answer_.meet()) break;
      }
      ends[k] % 2 == 0 ? enter(ends[k] / 2) : leave(ends[k] / 2);
    }
    return std::move(answer_);
  }

 private:
  static std::vector<InStatus> keys_of(std::span<const ConvexPolygon> polygons) {
    const std::vector<Box2> boxes = boxes_of(polygons);
    std::vector<InStatus> keys;
    keys.reserve(polygons.size());
    for (std::uint32_t i = 0; i < polygons.size(); ++i) {
      keys.push_back({&polygons[i], i, boxes[i].low.y, boxes[i].high.y});
    }
    return keys;
  }

  void enter(std::uint32_t i) {
    entering_ = i;
    const auto around = status_.insert(i, [&](const InStatus& other) { return is_above(i, other); });
    if (answer_.meet()) return;
    test_neighbours(around.below, i);
    test_neighbours(i, around.above);
    touched_.clear();
  }

  void leave(std::uint32_t i) {
    const auto around = status_.erase(i);
    test_neighbours(around.below, around.above);
  }

  // Is polygon i, which begins now, above the other one just after? Any answer will do where their contact counts.
  bool is_above(std::uint32_t i, const InStatus& other) {
    const ConvexPolygon& polygon = polygons_[i];
    const Point2& p = polygon[polygon.leftmost()];
    ++answer_.cost.probes;
    if (p.y > other.top || p.y < other.bottom || answer_.meet()) return p.y > other.top;
    const Height height = height_of(p, *other.polygon, answer_.cost.probes);
    if (height == Height::above || height == Height::below) return height == Height::above;
    if (report_pair(polygons_, i, other.number, options_.allowed, answer_)) return true;
    touched_.push_back(other.number);
    return height == Height::on_both_chains ? leaves_above(polygon, *other.polygon) : height != Height::on_lower_chain;
  }

  // Of two polygons, neither of them a point, of which the first begins on both chains of the other.
  bool leaves_above(const ConvexPolygon& first, const ConvexPolygon& other) {
    answer_.cost.probes += 4;
    const auto& begin = first[first.leftmost()];
    const auto& to = first[lower_chain_at(first, first.size() > 1 ? 1 : 0)];
    const auto& from = other[other.leftmost()];
    const auto& along = other[upper_chain_at(other, other.size() > 1 ? 1 : 0)];
    return cross_2d(from, along, begin, to) != Sign::negative;
  }

  void test_neighbours(std::uint32_t lower, std::uint32_t upper) {
    if (lower == no_polygon || upper == no_polygon || answer_.meet()) return;
    if (std::find(touched_.begin(), touched_.end(), lower == entering_ ? upper : lower) != touched_.end()) {
      return;
    }
    ++answer_.cost.probes;
    const InStatus &s = keys_[lower], &t = keys_[upper];
    if (s.top < t.bottom) return;  // the boxes are apart
    report_pair(polygons_, lower, upper, options_.allowed, answer_);
  }

  std::span<const ConvexPolygon> polygons_;
  const SetOptions& options_;
  const std::vector<InStatus> keys_;
  SweepStatus<InStatus> status_;
  std::uint32_t entering_ = no_polygon;
  std::vector<std::uint32_t> touched_;  // while a polygon enters: those that were found to touch it, which is allowed
  ConvexPolygonsAnswer answer_;
};

}  // namespace

ConvexPolygonsAnswer convex_polygons_any_by_sweep(std::span<const ConvexPolygon> polygons, const SetOptions& options) {
  check_groups(options.groups, polygons.size());
  if (!options.groups.empty()) return convex_polygons_any_by_grid(polygons, options);
  return Sweep(polygons, options).run();
}

}  // namespace sunder::planar
