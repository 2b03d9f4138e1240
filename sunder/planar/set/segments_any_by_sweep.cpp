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
// Why allowed contacts do no harm. Crossings and overlaps always count. So while none has been met the order of two
// segments on the line never changes, whatever touches. Take two segments of which the first contact that counts, in
// lexicographic order, is at p. If it is a crossing, then of the segments between them on the line just before p, each
// one passes through p or ends there: two that pass through it and are neighbours once the others have left cross at p;
// they were tested when they became neighbours. If it is a touch or an overlap that begins at p, one of the two begins
// or ends at p. One that ends there has next to it, towards the other, that other, or a segment that ends at p too and
// so touches the other one: neighbours again. One that begins at p enters next to the other, or next to one that began
// at p before it and touches the other likewise. Ends that are shared are never neighbours on the line, as they leave
// first; where they count, equal events are looked for instead.
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
