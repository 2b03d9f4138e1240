// The crossings that lie ahead of a sweep: those of segments that were neighbours on its line.
// Also called: event queue of a sweep line.
#pragma once

#include <sunder/base/contract.h>
#include <sunder/planar/object/segments.h>
#include <sunder/predicate/line/crossing.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sunder::planar {

class CrossingQueue {
 public:
  // Keeps a reference.
  explicit CrossingQueue(const Segments& segments) : segments_(segments) {}

  struct Event {
    std::uint32_t lower, upper;  // just before it
    Interval x;                  // holds its x
  };

  bool empty() const { return events_.empty(); }

  void push(std::uint32_t lower, std::uint32_t upper) {
    events_.push_back({lower, upper, enclosure(crossing(lower, upper)).x});
    std::push_heap(events_.begin(), events_.end(), Later{this});
  }

  // Of the next one, lexicographically: minus p. Requires that there is one.
  Sign next_minus(const Point2& p) {
    SUNDER_REQUIRE(!empty());
    ++comparisons;
    const Event& e = events_.front();
    return compare(crossing_of(e), enclosure_of(e), p);
  }

  // Takes the next one out, and all others at its point.
  Event pop() {
    SUNDER_REQUIRE(!empty());
    const Event event = pop_one();
    while (!empty() && order(events_.front(), event) == Sign::zero) pop_one();
    return event;
  }

  // Takes the next one out alone. Requires that there is one.
  Event pop_one() {
    std::pop_heap(events_.begin(), events_.end(), Later{this});
    const Event event = events_.back();
    events_.pop_back();
    return event;
  }

  Crossing crossing_of(const Event& e) const { return crossing(e.lower, e.upper); }

  std::uint64_t comparisons = 0;

 private:
  struct Later {
    CrossingQueue* queue;
    bool operator()(const Event& e, const Event& f) const { return queue->order(e, f) == Sign::positive; }
  };

  Crossing crossing(std::uint32_t lower, std::uint32_t upper) const {
    const Segment &s = segments_[lower], &t = segments_[upper];
    return {s.a, s.b, t.a, t.b};
  }
  static Enclosure2 enclosure_of(const Event& e) { return {e.x, {}}; }  // compare() looks at x only

  Sign order(const Event& e, const Event& f) {
    if (e.lower == f.lower && e.upper == f.upper) return Sign::zero;
    ++comparisons;
    return compare(crossing_of(e), enclosure_of(e), crossing_of(f), enclosure_of(f));
  }

  const Segments& segments_;
  std::vector<Event> events_;  // a heap
};

}  // namespace sunder::planar
