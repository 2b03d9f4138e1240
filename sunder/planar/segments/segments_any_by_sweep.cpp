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
//   So only those are looked at that are neighbours when all of a place has left, or entered. Of two that begin where
// nothing in the list is, the second one stands next to the first; of two neighbours that end in one point, the first
// one leaves no new neighbours that last.
#include <sunder/base/contract.h>
#include <sunder/base/prefetch.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/segments/segments_any.h>
#include <sunder/planar/sweep/ends_in_order.h>
#include <sunder/planar/sweep/sweep_status.h>
#include <sunder/predicate/point/orient.h>

namespace sunder::planar {

namespace {

static_assert(SweepStatus<Segment>::none == no_segment);

class Sweep {
 public:
  Sweep(const Segments& segments, const SetOptions& options)
      : segments_(segments), options_(options), status_(segments.all()) {}

  SegmentsAnswer run(std::span<const std::uint32_t> ends) {
    for (std::size_t k = 0; k < ends.size() && !answer_.meet(); ++k) {
      const std::uint32_t i = ends[k] / 2;
      tell_progress(options_, k, k, ends.size());
      if (k + ahead < ends.size()) prefetch(segments_[ends[k + ahead] / 2]);
      if (options_.allowed == Allowed::nothing && k + 1 < ends.size()) test_equal_ends(ends[k], ends[k + 1]);
      const std::uint32_t next = k + 1 < ends.size() ? ends[k + 1] : none;
      ends[k] % 2 == 0 ? enter(i, next) : leave(i, next);
    }
    return answer_;
  }

 private:
  static constexpr std::size_t ahead = 12;
  static constexpr std::uint32_t none = no_segment;

  void test_equal_ends(std::uint32_t end, std::uint32_t next) {
    if (end / 2 != next / 2 && end_point(segments_.all(), end) == end_point(segments_.all(), next)) {
      test(end / 2, next / 2);
    }
  }

  // next: the end that follows.
  void enter(std::uint32_t i, std::uint32_t next) {
    if (i == entered_) return;
    const Segment& s = segments_[i];
    begins_on_another_ = false;
    const auto around = status_.insert(i, [&](const Segment& other) { return is_above(s, other); });
    if (!begins_on_another_ && next != none && next % 2 == 0 && segments_[next / 2].a == s.a) {
      return enter_beside(i, next / 2, around.below, around.above);
    }
    test_neighbours(around.below, i, begins_on_another_);
    test_neighbours(i, around.above, begins_on_another_);
  }

  // Segment j, which begins where i does, and nothing else yet in the list holds that point: next to i.
  void enter_beside(std::uint32_t i, std::uint32_t j, std::uint32_t below, std::uint32_t above) {
    const Segment &s = segments_[i], &t = segments_[j];
    ++answer_.cost.probes;
    const Sign side = orient_2d(s.a, s.b, t.b);
    const bool is_above = side != Sign::negative;
    status_.insert_above(is_above ? i : below, j);
    test_neighbours(below, is_above ? i : j, false);
    if (side == Sign::zero) test(i, j);
    test_neighbours(is_above ? j : i, above, false);
    entered_ = j;
  }

  void leave(std::uint32_t i, std::uint32_t next) {
    const auto around = status_.erase(i);
    const std::uint32_t j = next / 2;
    const bool leaves_too = next % 2 == 1 && (j == around.below || j == around.above);
    if (leaves_too && segments_[j].b == segments_[i].b) return;  // and then those around both are looked at
    test_neighbours(around.below, around.above, false);
  }

  // Is segment i, which begins now, above the other one just after?
  bool is_above(const Segment& s, const Segment& t) {
    ++answer_.cost.probes;
    const Sign begins = orient_2d(t.a, t.b, s.a);
    if (begins != Sign::zero) return begins == Sign::positive;
    begins_on_another_ = true;
    return orient_2d(t.a, t.b, s.b) != Sign::negative;  // a tie, overlap or point, is looked at as neighbours then
  }

  // Two that are neighbours now, neither of which begins here on another, meet further on or not at all. Where they do,
  // the one that ends first does so on the other one or beyond.
  void test_neighbours(std::uint32_t lower, std::uint32_t upper, bool begins_on_another) {
    if (lower == no_segment || upper == no_segment) return;
    const Segment &s = segments_[lower], &t = segments_[upper];
    if (!begins_on_another) {
      ++answer_.cost.probes;
      const bool s_ends_first = lexicographically_less(s.b, t.b);
      const Sign side = s_ends_first ? orient_2d(t.a, t.b, s.b) : orient_2d(s.a, s.b, t.b);
      if (side == (s_ends_first ? Sign::negative : Sign::positive)) return;
    }
    test(lower, upper);
  }

  void test(std::uint32_t i, std::uint32_t j) {
    if (answer_.meet()) return;
    ++answer_.cost.probes;
    const ContactKind kind = segment_segment(segments_[i], segments_[j]);
    if (!counts(kind, options_.allowed)) return;
    answer_.found = contact_of(i, j, kind);
  }

  const Segments& segments_;
  const SetOptions options_;
  SweepStatus<Segment> status_;
  SegmentsAnswer answer_;
  bool begins_on_another_ = false;  // does the segment that enters begin on one that it was compared with?
  std::uint32_t entered_ = none;    // the last one that entered beside another, whose turn is still to come
};

}  // namespace

SegmentsAnswer segments_any_by_sweep(const Segments& segments, const SetOptions& options) {
  check_groups(options.groups, segments.size());
  if (!options.groups.empty()) {  // members of one may cross, many times: up to the first contact that counts
    return first_of<SegmentsContact>(
        [&](const SegmentsVisitor& visit) { return segments_all_by_sweep(segments, options, visit); });
  }
  return segments_any_by_sweep_over(segments, ends_in_order(segments.all()), options);
}

SegmentsAnswer segments_any_by_sweep_over(const Segments& segments, std::span<const std::uint32_t> ends,
                                          const SetOptions& options) {
  SUNDER_REQUIRE(options.groups.empty());
  SUNDER_REQUIRE(ends.size() == 2 * segments.size());
  return Sweep(segments, options).run(ends);
}

}  // namespace sunder::planar
