// Bentley & Ottmann 1979, by bundles: all that happens at one point is dealt with at once, in every position.
//
// The line sweeps lexicographically, as in segments_any_by_sweep.cpp. The next place is the first end, or the first
// crossing of two neighbours, whichever comes first. At a place p, the segments in the list that hold p stand in a row:
// those that end there leave, the rest (which pass through) are reversed, and those that begin there enter, by their
// direction. All pairs of the bundle meet in p. Then the row's first and last, and what stands next to them, are looked
// at as neighbours.
// Two neighbours that cross further on are found by one orientation: the one that ends first does so on the wrong side
// of the other. Where it ends on the other one, the end is marked, so that an end where nothing happens can be told
// without looking for a row.
// Overlaps: of two on one line either may stand above the other as long as they overlap. They are given at their first
// common point, where one of them begins; where one ends on others of its line only, nothing happens.
// The bundle of p is complete: just before p, those in the list that hold p have nothing else between them.
#include <sunder/planar/segments/contact_bundle.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/sweep/crossing_queue.h>
#include <sunder/planar/sweep/ends_in_order.h>
#include <sunder/planar/sweep/sweep_status.h>
#include <sunder/predicate/line/crossing.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <limits>

namespace sunder::planar {

namespace {

constexpr std::uint32_t none = no_segment;

class BentleyOttmann {
 public:
  // record: where to write the events, or null; the sweep stops where it has more than `most` entries.
  BentleyOttmann(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit, SweepEvents* record,
                 std::size_t most = std::numeric_limits<std::size_t>::max())
      : segments_(segments),
        options_(options),
        visit_(visit),
        record_(record),
        most_(most),
        status_(segments.all()),
        ends_on_(segments.size()),
        crossings_(segments) {}

  Cost run() {
    const std::vector<std::uint32_t> ends = ends_in_order(segments_.all());
    std::size_t e = 0;
    for (std::size_t step = 0; !stopped_ && (e < ends.size() || !crossings_.empty()); ++step) {
      tell_progress(options_, step, e, ends.size());
      if (!crossings_.empty() && (e == ends.size() || crossings_.next_minus(point(ends[e])) == Sign::negative)) {
        at_crossing();
        continue;
      }
      const std::size_t first = e;
      const Point2& p = point(ends[first]);
      while (e < ends.size() && point(ends[e]) == p) ++e;
      at_end(p, std::span(ends).subspan(first, e - first));
    }
    return cost_;
  }

 private:
  const Point2& point(std::uint32_t end) const { return end_point(segments_.all(), end); }

  // --- At a crossing where no segment begins or ends ---

  void at_crossing() {
    const CrossingQueue::Event event = crossings_.pop();
    const Crossing p = crossings_.crossing_of(event);
    const Enclosure2 in = enclosure(p);
    gather(event.lower, [&](std::uint32_t i) {
      if (bundle_.on_one_line(i, event.lower) || bundle_.on_one_line(i, event.upper)) return true;
      ++cost_.probes;
      return orient_2d(segments_[i].a, segments_[i].b, p, in) == Sign::zero;
    });
    bundle_.set(row_, {}, {}, nullptr);
    stopped_ = !bundle_.visit();
    pass(row_);
    record(planar::at_crossing, row_);
    meet_neighbours(row_.front(), row_.back());
  }

  // --- Where segments begin or end ---

  void at_end(const Point2& p, std::span<const std::uint32_t> ends) {
    if (ends.size() == 1 && (crossings_.empty() || crossings_.next_minus(p) != Sign::zero)) {
      if (ends[0] % 2 == 1 ? leave_alone(ends[0] / 2) : enter_alone(ends[0] / 2)) return;
    }
    std::uint32_t held = none;  // some segment in the list that holds p
    while (!crossings_.empty() && crossings_.next_minus(p) == Sign::zero) held = crossings_.pop_one().lower;
    for (const std::uint32_t end : ends) {
      if (end % 2 == 1 && status_.holds(end / 2)) held = end / 2;
    }
    below_ = above_ = none;
    row_.clear();
    if (held == none) {
      const auto around = status_.around([&](const Segment& s) { return side_of(p, s) == Sign::positive; });
      below_ = around.below;
      above_ = around.above;
      if (above_ != none && side_of(p, segments_[above_]) == Sign::zero) held = above_;
    }
    if (held != none) {
      gather(held,
             [&](std::uint32_t i) { return bundle_.on_one_line(i, held) || side_of(p, segments_[i]) == Sign::zero; });
    }

    begins_.clear();
    points_.clear();
    for (const std::uint32_t end : ends) {
      const std::uint32_t i = end / 2;
      if (end % 2 == 0) (segments_[i].a == segments_[i].b ? points_ : begins_).push_back(i);
    }
    bundle_.set(row_, begins_, points_, &p);
    stopped_ = !bundle_.visit();
    passing_.clear();
    for (const std::uint32_t i : row_) {
      if (segments_[i].b == p) {
        status_.erase(i);
      } else {
        passing_.push_back(i);
      }
    }
    pass(passing_);
    for (const std::uint32_t i : begins_) {
      status_.insert(i, [&](const Segment& other) { return is_above(segments_[i], other); });
    }
    if (passing_.empty() && begins_.empty()) {
      record(ends[0], points_);
      return meet_neighbours(none, none);
    }
    const std::uint32_t first = below_ == none ? status_.lowest() : status_.neighbours_of(below_).above;
    const std::uint32_t last = above_ == none ? status_.highest() : status_.neighbours_of(above_).below;
    if (record_ != nullptr) {
      for (std::uint32_t i = first; i != above_; i = status_.neighbours_of(i).above) points_.push_back(i);
      record(ends[0], points_);
    }
    meet_neighbours(first, last);
  }

  // The only end at its place, and of no other segment's inside: false where that is not so.
  bool leave_alone(std::uint32_t i) {
    if (ends_on_[i] != 0 || (record_ != nullptr && lies_on_a_neighbour(i))) return false;
    const auto around = status_.erase(i);
    below_ = around.below;
    record(2 * i + 1, {});
    meet(around.below, around.above);
    return true;
  }
  // Does it end on one that it overlaps? (Such a contact has been given where it began, and is not marked.)
  bool lies_on_a_neighbour(std::uint32_t i) {
    const auto around = status_.neighbours_of(i);
    const auto holds_end = [&](std::uint32_t t) {
      return t != none && side_of(segments_[i].b, segments_[t]) == Sign::zero;
    };
    return holds_end(around.below) || holds_end(around.above);
  }
  bool enter_alone(std::uint32_t i) {
    begins_on_another_ = false;
    const auto around = status_.insert(i, [&](const Segment& other) { return is_above(segments_[i], other); });
    if (begins_on_another_) {
      status_.erase(i);
      return false;
    }
    below_ = around.below;
    record(2 * i, std::span(&i, 1));
    meet(around.below, i);
    meet(i, around.above);
    return true;
  }

  // --- Rows ---

  // The row around one that holds the place, from below to above, and what stands next to it.
  template <class Holds>
  void gather(std::uint32_t held, const Holds& holds) {
    const auto around = status_.row_around(held, holds, row_);
    below_ = around.below;
    above_ = around.above;
  }

  // Reverses a row of the list, whose members pass through the place, and the row given.
  void pass(std::vector<std::uint32_t>& row) {
    if (row.size() < 2 || bundle_.on_one_line(row.front(), row.back())) return;
    for (std::size_t k = 0, l = row.size(); k + 1 < l; ++k) status_.exchange(row[k], row[--l]);
    std::reverse(row.begin(), row.end());
  }

  // An event just above `below_`, with a row that goes on from it.
  void record(std::uint32_t at, std::span<const std::uint32_t> row) {
    if (record_ == nullptr) return;
    record_->row.insert(record_->row.end(), row.begin(), row.end());
    record_->add(at, below_);
    stopped_ = stopped_ || record_->entries() > most_;
  }

  // --- Neighbours ---

  void meet_neighbours(std::uint32_t first, std::uint32_t last) {
    if (first == none) return meet(below_, above_);
    meet(below_, first);
    meet(last, above_);
  }

  // Two that are neighbours now, just after the place.
  void meet(std::uint32_t lower, std::uint32_t upper) {
    if (lower == none || upper == none || bundle_.on_one_line(lower, upper)) return;
    ++cost_.probes;
    const Segment &s = segments_[lower], &t = segments_[upper];
    const bool s_ends_first = lexicographically_less(s.b, t.b);
    const Sign side = s_ends_first ? orient_2d(t.a, t.b, s.b) : -orient_2d(s.a, s.b, t.b);
    if (side == Sign::negative) return;
    if (side == Sign::zero) {
      ends_on_[s_ends_first ? lower : upper] = 1;
      return;
    }
    crossings_.push(lower, upper);
  }

  // Where p stands: positive above the segment, which is in the list.
  Sign side_of(const Point2& p, const Segment& s) {
    ++cost_.probes;
    return orient_2d(s.a, s.b, p);
  }

  // Is segment s, which begins now, above the other one just after?
  bool is_above(const Segment& s, const Segment& t) {
    const Sign begins = side_of(s.a, t);
    if (begins != Sign::zero) return begins == Sign::positive;
    begins_on_another_ = true;
    return orient_2d(t.a, t.b, s.b) != Sign::negative;
  }

  const Segments& segments_;
  const SetOptions& options_;
  const SegmentsVisitor& visit_;
  SweepEvents* record_;
  const std::size_t most_;
  SweepStatus<Segment> status_;
  std::vector<std::uint8_t> ends_on_;  // of each segment: does it end on one that it was a neighbour of?
  CrossingQueue crossings_;
  std::vector<std::uint32_t> row_, passing_, begins_, points_;
  std::uint32_t below_ = none, above_ = none;  // next to the row
  bool begins_on_another_ = false, stopped_ = false;
  Cost cost_;
  ContactBundle bundle_{segments_, options_, visit_, cost_};
};

}  // namespace

Cost segments_all_by_bentley_ottmann(const Segments& segments, const SetOptions& options,
                                     const SegmentsVisitor& visit) {
  check_groups(options.groups, segments.size());
  return BentleyOttmann(segments, options, visit, nullptr).run();
}

Cost segments_visit_with_transcript(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit,
                                    SweepEvents& transcript) {
  check_groups(options.groups, segments.size());
  return BentleyOttmann(segments, options, visit, &transcript).run();
}

std::optional<SweepEvents> sweep_events(const Segments& segments, std::size_t most) {
  SetOptions options;
  options.allowed = Allowed::touch;
  const std::vector<std::uint32_t> one_group(segments.size(), 0);  // so that no contact is looked at
  options.groups = one_group;
  SweepEvents events;
  const SegmentsVisitor visit = [](const SegmentsContact&) { return true; };
  BentleyOttmann(segments, options, visit, &events, most).run();
  if (events.entries() > most) return std::nullopt;
  return events;
}

SegmentsAnswer segments_any_by_bentley_ottmann(const Segments& segments, const SetOptions& options) {
  return first_of<SegmentsContact>(
      [&](const SegmentsVisitor& visit) { return segments_all_by_bentley_ottmann(segments, options, visit); });
}

SegmentsAnswer segments_any_with_transcript(const Segments& segments, const SetOptions& options,
                                            SweepEvents& transcript) {
  const SegmentsAnswer answer = first_of<SegmentsContact>([&](const SegmentsVisitor& visit) {
    return segments_visit_with_transcript(segments, options, visit, transcript);
  });
  if (answer.meet()) transcript = {};
  return answer;
}

}  // namespace sunder::planar
