// The contacts of polygons by one sweep over their edges: around points where several come together, where edges
// cross, and of rings inside of other polygons. For use by polygons_any and polygons_all.
// Also called: map overlay by plane sweep.
//
// The line sweeps lexicographically, and passes crossings (Bentley & Ottmann 1979). All that happens at one point is
// dealt with at once. What the polygons fill just above each edge of the list is known as a set: it differs from that
// below by the edge's polygon, in which they share all else (PersistentSets). So
//   - edges that cross were neighbours before; where nothing else is at the point, their polygons overlap;
//   - around a point where polygons of several groups have edges, PolygonPlace tells who touches and who overlaps;
//   - a ring without these lies inside of the polygons in the set below its first vertex, and of no others.
// Other pairs have no common point, as polygon_meetings.h shows.
// Cost: O((n + k) log n) for n edges, and k that are the crossings of edges and the edges that pass vertices of others,
// also of one group, and what is found (see PolygonPlace): not the pairs of one group that share a point, or lie inside
// of one another. Memory: O(n) and
// what crossings lie ahead.
#pragma once

#include <sunder/near/contacts_in_order.h>
#include <sunder/planar/polygons/polygon_place.h>
#include <sunder/planar/sweep/crossing_queue.h>
#include <sunder/planar/sweep/persistent_sets.h>
#include <sunder/planar/sweep/sweep_status.h>

#include <cstdint>
#include <vector>

namespace sunder::planar {

class PolygonSweep {
 public:
  // Calls `found` for pairs that meet, also more than once for a pair, until it returns false. Contacts that are said
  // to be touching may yet be found to be overlapping. Pairs of one group are left out, and touching that is allowed.
  // Where `end` is given, so are pairs i < j whose i is not below it; it may fall meanwhile.
  PolygonSweep(const PolygonEdges& edges, const SetOptions& options, PolygonPlace::Found found,
               const std::uint32_t* end = nullptr);

  // Returns whether `found` never returned false.
  bool run();

  Cost cost{};

 private:
  static constexpr std::uint32_t none = SweepStatus<Segment>::none;

  const Segment& segment(std::uint32_t e) const { return edges_.edges()[e]; }
  Sign side_of(const Point2& p, std::uint32_t e);

  void number_by_group();
  void find_firsts();
  void at_crossing();
  void at_vertex(const Point2& p, std::uint32_t held);
  template <class Holds>
  void gather(std::uint32_t held, const Holds& holds);
  void goes_on(std::uint32_t old, std::uint32_t next);
  void pass();
  bool is_lower(std::uint32_t e, std::uint32_t f, const Point2& p);
  bool are_several() const;
  void find_sides();
  bool look_around();
  bool report_crossing(std::uint32_t e, std::uint32_t f);
  bool look_inside();
  bool report_inside(std::uint32_t e, std::uint32_t outer);
  void put_row();
  void look_for_crossing(std::uint32_t lower, std::uint32_t upper);

  const PolygonEdges& edges_;
  SetOptions options_;
  PolygonPlace::Found found_;
  PolygonPlace place_;
  SweepStatus<Segment> status_;
  CrossingQueue crossings_;
  PersistentSets sets_;
  std::vector<std::uint32_t> key_of_, polygon_at_;  // of each polygon: its number in sets_; and back
  std::vector<Block> group_at_;                     // of each key: those of its group
  std::vector<PersistentSets::Set> above_of_;       // of each edge in the list: which polygons fill what is just above
  std::vector<bool> fills_above_;                   // of each edge: does its own?
  std::vector<bool> is_first_;                      // of each edge: does its ring begin with it?

  // At a point.
  const Point2* vertex_ = nullptr;               // none where edges only cross
  std::vector<std::uint32_t> begins_, passing_;  // edges that begin there; that neither begin nor end
  std::vector<std::uint32_t> row_, next_;        // those in the list that hold it, from below to above; and just after
  std::vector<bool> fills_next_;                 // as fills_above_
  std::uint32_t below_ = 0, above_ = 0;          // next to the row
  PersistentSets::Set under_ = PersistentSets::empty;  // just below the row
  std::vector<std::uint32_t> seen_;                    // of each polygon: at which point last
  std::vector<bool> fills_;  // of each polygon that was seen: what is between two edges of the row
  std::uint32_t point_ = 0;
  std::vector<PolygonPlace::Leaving> leaving_;
  bool stopped_ = false;
};

}  // namespace sunder::planar
