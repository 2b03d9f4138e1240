// Shamos & Hoey 1976, Algorithm 1, with the details that the paper leaves to the implementor.
//
// The line sweeps lexicographically: by x, and at equal x by y, as if it were tilted a little. So vertical segments are
// segments like all others. At one point, first the segments that end there leave, then those of length zero come and
// go, then those that begin there enter.
//
// Order on the line. A segment that begins at p is above another one if p is above it; where p lies on the other (which
// begins at p too, or passes through p), if its last end is above the line through the other. Where that ties, both
// are collinear and overlap, which always counts; or it has length zero, and then it is above those that it lies on.
//
// Why allowed contacts do no harm. Crossings and overlaps always count. So while none has been met, the order of two
// segments on the line never changes, whatever touches. At p, when the segments that end there have left, at most one
// in the list passes through p: two would cross there, two such that are neighbours were tested when they became so.
// Hence "above" is monotone along the list: by the side of p, and through p by direction. Take two segments s and t
// whose contact counts and is at p, the first of all such points. On the line next to p, those between s and t contain
// p too.
//   A crossing: both pass through p, and when those between that end at p have left, they are neighbours.
//   A touch, s ends: just before p, between s and t stand only segments that end at p or pass through it. From s to t
//     some two neighbours are one that ends and one that does not (t itself at last): they touch.
//   A touch, s begins: likewise just after p, with one that begins and the one that passes through.
//   An overlap that begins at p: both have one direction from p, so between them stand only others of that direction,
//     which overlap them: some two neighbours overlap.
//   A point on t: points come before what begins, so t is the only one through p, and the point is put next to it.
// Two segments that only share an end, last of one and first of the other, are never neighbours, as what ends leaves
// first. Where shared ends count, equal events are looked for instead.
#include <sunder/planar/set/segments_any.h>
#include <sunder/planar/set/sweep_status.h>
#include <sunder/predicate/orient.h>

#include <algorithm>

namespace sunder::planar {

namespace {

static_assert(SweepStatus::none == no_segment);

struct Event {
  enum class Kind : std::uint32_t { end, point, begin };  // in the order in which they are taken at one place
  Point2 at;
  std::uint32_t segment;
  Kind kind;
};

bool operator<(const Event& a, const Event& b) {
  if (a.at.x != b.at.x) return a.at.x < b.at.x;
  if (a.at.y != b.at.y) return a.at.y < b.at.y;
  if (a.kind != b.kind) return a.kind < b.kind;
  return a.segment < b.segment;
}

std::vector<Event> sorted_events(const Segments& segments) {
  std::vector<Event> events;
  events.reserve(2 * std::size_t{segments.size()});
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    if (s.a == s.b) {
      events.push_back({s.a, i, Event::Kind::point});
    } else {
      events.push_back({s.a, i, Event::Kind::begin});
      events.push_back({s.b, i, Event::Kind::end});
    }
  }
  std::sort(events.begin(), events.end());
  return events;
}

class Sweep {
 public:
  Sweep(const Segments& segments, const SegmentsOptions& options)
      : segments_(segments), options_(options), status_(segments.size()) {}

  SegmentsAnswer run() {
    const std::vector<Event> events = sorted_events(segments_);
    const bool record = options_.transcript;
    if (record) {
      answer_.transcript.events.reserve(2 * std::size_t{segments_.size()});
      answer_.transcript.below.reserve(segments_.size());
    }
    for (std::size_t k = 0; k < events.size() && !answer_.meet(); ++k) {
      const Event& event = events[k];
      if (options_.allowed == Allowed::nothing && k + 1 < events.size() && events[k + 1].at == event.at) {
        test(event.segment, events[k + 1].segment);
        continue;
      }
      if (event.kind != Event::Kind::end) enter(event.segment);
      if (event.kind != Event::Kind::begin) leave(event.segment);
    }
    if (answer_.meet()) answer_.transcript = {};
    return std::move(answer_);
  }

 private:
  void enter(std::uint32_t i) {
    const auto around = status_.insert(i, [&](std::uint32_t other) { return is_above(i, other); });
    if (options_.transcript) {
      answer_.transcript.events.push_back(2 * i);
      answer_.transcript.below.push_back(around.below);
    }
    test(i, around.below);
    test(i, around.above);
  }

  void leave(std::uint32_t i) {
    const auto around = status_.erase(i);
    if (options_.transcript) answer_.transcript.events.push_back(2 * i + 1);
    if (around.below != no_segment) test(around.below, around.above);
  }

  // Is segment i, which begins now, above the other one just after?
  bool is_above(std::uint32_t i, std::uint32_t other) {
    ++answer_.cost.probes;
    const Segment &s = segments_[i], &t = segments_[other];
    const Sign begins = orient_2d(t.a, t.b, s.a);
    if (begins != Sign::zero) return begins == Sign::positive;
    return orient_2d(t.a, t.b, s.b) != Sign::negative;  // a tie, overlap or point, is looked at as neighbours then
  }

  void test(std::uint32_t i, std::uint32_t j) {
    if (j == no_segment || answer_.meet()) return;
    ++answer_.cost.probes;
    const ContactKind kind = segment_segment(segments_[i], segments_[j]);
    if (!counts(kind, options_.allowed)) return;
    answer_.kind = kind;
    answer_.i = std::min(i, j);
    answer_.j = std::max(i, j);
  }

  const Segments& segments_;
  const SegmentsOptions options_;
  SweepStatus status_;
  SegmentsAnswer answer_;
};

}  // namespace

SegmentsAnswer segments_any_by_sweep(const Segments& segments, const SegmentsOptions& options) {
  return Sweep(segments, options).run();
}

}  // namespace sunder::planar
