// After Balaban 1995, in every position. The staircases and the halving are his; what is lent and chosen, how places
// are found, and the argument for the bound are written for this file.
//
// Places are the distinct ends, in lexicographic order; a strip is what a line that is tilted a little sweeps from one
// place to a later one. At any time between places the segments on the line have an order: by height, and of two on one
// line by number. Two on one line never change their order; two others change it where they cross, and only there. The
// time just before a place and the time just after it are told apart: what happens at a place happens between the two.
//   A staircase of a strip: segments (stairs) that span the strip and do not change their order in it. From the list of
// the segments alive just after the strip's first place, stairs are taken greedily; the rest go down into the two
// halves of the strip, one after the other, and what comes back, with the stairs, is the list just before its last
// place. A segment that spans the strip and is not taken crosses a stair in it.
//
// Where a contact is given, once:
//   - Where no segment of the pair ends in their only common point, they cross there. Either there is one strip around
//   the crossing in which one of the two is a stair (the other is not, and the stair is in no strip inside): then by a
//   walk over the staircase, from where the other one stands when it enters the strip, or begins in it. Or both come
//   down into the strips that are not halved: then by an exchange of the insertion sort between two places. Or both
//   pass through a place inside, both in the list: then there, where the row of those that hold the place is turned.
//   - Else, at a place where one of the two begins or ends: each that does is held against the others that do, against
//   those in the list that hold the place, and against the stairs that hold it, of every strip around. Of an overlap
//   that is where the later of the two begins.
//
// To find a place in the staircases of all strips around it, every fourth stair of a strip is lent to each half. One
// that is lent counts as a stair, save that nothing is given for it, and that it does not come back. So the place is
// found in the innermost staircase by a binary search, and then in each one further out in at most four steps.
//   Of the four ways to choose every fourth stair the one is taken whose stairs have been crossed least in the strip.
//
// The bound. Let X be the sum over strips of the crossings, in the strip, of its stairs and the segments in its list,
// and C the same of its stairs and the segments that begin in it. Stairs that are not lent add at most k to each of X
// and C. Of C, a segment crosses at most a quarter, and one, of a row of stairs when they are lent to the strip that it
// begins in: C = O(k + N log N). Of X, what the lent stairs of a half add has been crossed before it in the strip, and
// at most a quarter of all that has been crossed there is lent: for two halves, half of X + C. So X = O(k + N log N).
//   A segment is in the list of a strip because an end of it is in the strip around that, O(N log N) times, or because
// it crosses a stair there, at most X times. A walk costs two comparisons and what it crosses; the rest of a strip, a
// few for each in its list and for each stair; the stairs, with those lent, are at most twice those taken, and one per
// strip. A row or a run of stairs that hold a place is paid for by the contacts there, of which an overlap is looked at
// where one of the two begins or ends, no more than four times. In all, O(N log N + k).
//   Memory: each segment is in the list or in one staircase; those lent add a third, and one per strip around: O(N).
#include <sunder/base/interruption.h>
#include <sunder/planar/segments/contact_bundle.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/sweep/ends_in_order.h>
#include <sunder/predicate/line/height_order.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace sunder::planar {

namespace {

// A strip of so many places is swept from one to the next, without stairs. (By trial; 4 to 16 do nearly as well.)
constexpr std::uint32_t few_in_strip = 8;

class Balaban {
 public:
  Balaban(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit)
      : segments_(segments),
        options_(options),
        visit_(visit),
        ends_(ends_in_order(segments.all())),
        first_(segments.size()),
        last_(segments.size()) {
    for (std::uint32_t e = 0; e < ends_.size(); ++e) {
      if (e == 0 || end_point(segments.all(), ends_[e - 1]) != end_point(segments.all(), ends_[e])) {
        places_.push_back(e);
      }
      (ends_[e] % 2 == 0 ? first_ : last_)[ends_[e] / 2] = place_count() - 1;
    }
  }

  Cost run() {
    if (places_.empty()) return cost_;
    const std::uint32_t last = place_count() - 1;
    at_place(0);
    if (last == 0) return cost_;
    in_strip(0, last);
    at_place(last);
    return cost_;
  }

 private:
  struct Stair {
    std::uint32_t segment;
    std::uint32_t around;  // in stairs_: past the last lent stair not above this one, in the staircase it is lent from
    bool lent;
  };
  struct Staircase {
    std::uint32_t first, last;               // in stairs_
    std::uint32_t end;                       // the place at the end of its strip
    std::array<std::uint64_t, 4> crossed{};  // how often, the stairs first + r, first + r + 4, ... were crossed
  };
  struct Time {
    std::uint32_t place;
    bool after;  // just after it, or just before
  };

  std::uint32_t place_count() const { return static_cast<std::uint32_t>(places_.size()); }
  const Point2& point(std::uint32_t place) const { return end_point(segments_.all(), ends_[places_[place]]); }
  bool spans(std::uint32_t i, std::uint32_t begin, std::uint32_t end) const {
    return first_[i] <= begin && last_[i] >= end;
  }

  // --- Strips ---

  // list_: those alive just after `begin` that are in no staircase around, in their order; afterwards, the same just
  // before `end`.
  void in_strip(std::uint32_t begin, std::uint32_t end) {
    if (end - begin <= few_in_strip) return sweep(begin, end);
    split(begin, end);
    const std::uint32_t middle = begin + (end - begin) / 2;
    if (!stopped_) in_strip(begin, middle);
    if (!stopped_) at_place(middle);
    if (!stopped_) in_strip(middle, end);
    if (!stopped_) merge(end);
    stairs_.resize(staircases_.back().first);
    staircases_.pop_back();
  }

  // A strip of few places: one after the other, without stairs.
  void sweep(std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t place = begin + 1; place < end && !stopped_; ++place) {
      advance(place);
      if (!stopped_) at_place(place);
    }
    if (!stopped_) advance(end);
  }

  // From one place to the next: the list's order changes by the crossings in between.
  void advance(std::uint32_t end) {
    for (std::size_t l = 1; l < list_.size(); ++l) {
      const std::uint32_t i = list_[l];
      std::size_t k = l;
      for (; k > 0 && !stopped_ && cross_by(list_[k - 1], i, {end, false}); --k) {
        give_crossing(list_[k - 1], i);
        list_[k] = list_[k - 1];
      }
      list_[k] = i;
    }
  }

  // Takes stairs out of the list, and walks from where the others stand at `begin`.
  void split(std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t first = static_cast<std::uint32_t>(stairs_.size());
    std::uint32_t lent = 0, around_first = 0, around_last = 0;  // the next to be lent; the staircase around
    if (!staircases_.empty()) {
      const Staircase& around = staircases_.back();
      const auto least = std::min_element(around.crossed.begin(), around.crossed.end()) - around.crossed.begin();
      around_first = around.first;
      around_last = around.last;
      lent = around_first + static_cast<std::uint32_t>(least);
    }
    std::uint32_t past = around_first;
    const auto lend = [&] {
      past = lent + 1;
      stairs_.push_back({stairs_[lent].segment, past, true});
      lent += 4;
    };
    std::size_t kept = 0;
    stands_.clear();
    for (const std::uint32_t i : list_) {
      while (lent < around_last && is_below(stairs_[lent].segment, i, {begin, true})) lend();
      if (spans(i, begin, end) && (stairs_.size() == first || !cross_by(stairs_.back().segment, i, {end, false})) &&
          (lent >= around_last || !cross_by(i, stairs_[lent].segment, {end, false}))) {
        stairs_.push_back({i, past, false});
      } else {
        list_[kept++] = i;
        stands_.push_back(static_cast<std::uint32_t>(stairs_.size()));
      }
    }
    while (lent < around_last) lend();
    list_.resize(kept);
    staircases_.push_back({first, static_cast<std::uint32_t>(stairs_.size()), end});
    for (std::size_t k = 0; k < kept; ++k) walk(list_[k], staircases_.back(), stands_[k], stands_[k]);
  }

  // Puts the stairs back, just before `end`.
  void merge(std::uint32_t end) {
    const Staircase& staircase = staircases_.back();
    std::size_t from = list_.size(), to = from;
    for (std::uint32_t k = staircase.first; k < staircase.last; ++k) to += !stairs_[k].lent;
    list_.resize(to);
    for (std::uint32_t k = staircase.last; k-- > staircase.first;) {
      if (stairs_[k].lent) continue;
      const std::uint32_t stair = stairs_[k].segment;
      while (from > 0 && is_below(stair, list_[from - 1], {end, false})) list_[--to] = list_[--from];
      list_[--to] = stair;
    }
  }

  // The stairs that a segment crosses which enters the strip, or begins in it, between stairs `below` - 1 and `above`:
  // they stand in a row on one side.
  void walk(std::uint32_t i, Staircase& staircase, std::uint32_t below, std::uint32_t above) {
    const Time end{staircase.end, false};
    const auto cross = [&](std::uint32_t k) {
      ++staircase.crossed[(k - staircase.first) % 4];
      if (!stairs_[k].lent) give_crossing(i, stairs_[k].segment);
    };
    std::uint32_t k = above;
    for (; k < staircase.last && !stopped_ && cross_by(i, stairs_[k].segment, end); ++k) cross(k);
    if (k > above) return;
    for (k = below; k > staircase.first && !stopped_ && cross_by(stairs_[k - 1].segment, i, end); --k) cross(k - 1);
  }

  // --- Places ---

  // list_: just before the place; afterwards just after.
  void at_place(std::uint32_t place) {
    tell_progress(options_, place, place, place_count());
    begin_.clear();
    points_.clear();
    const std::size_t past = place + 1 < place_count() ? places_[place + 1] : ends_.size();
    for (std::size_t e = places_[place]; e < past; ++e) {
      const std::uint32_t i = ends_[e] / 2;
      if (ends_[e] % 2 == 0) (last_[i] == place ? points_ : begin_).push_back(i);
    }
    at_list(place, point(place));
    at_staircases(point(place));
    if (!stopped_) stopped_ = !bundle_.visit();
  }

  // Where nothing begins, and all that hold the place are on one line, their overlaps were given before.
  void at_list(std::uint32_t place, const Point2& p) {
    const auto low = std::partition_point(list_.begin(), list_.end(),
                                          [&](std::uint32_t i) { return side_of(p, i) == Sign::positive; });
    auto high = low;
    const auto goes_on = [&] { return high != low && bundle_.on_one_line(*(high - 1), *high); };
    while (high != list_.end() && (goes_on() || side_of(p, *high) == Sign::zero)) ++high;
    leaving_.clear();
    if (begin_.empty() && points_.empty() && low != high && bundle_.on_one_line(*low, *(high - 1))) {
      const auto leaves = [&](std::uint32_t i) { return last_[i] == place; };
      std::copy_if(low, high, std::back_inserter(leaving_), leaves);
      bundle_.set(leaving_, {}, {}, &p);
      list_.erase(std::remove_if(low, high, leaves), high);
      return;
    }
    bundle_.set({low, high}, begin_, points_, &p);
    const std::vector<std::uint32_t>& after = bundle_.after();
    const auto both = std::min(high - low, static_cast<std::ptrdiff_t>(after.size()));
    const auto copied = std::copy(after.begin(), after.begin() + both, low);
    list_.erase(copied, high);
    list_.insert(copied, after.begin() + both, after.end());
  }

  // From the innermost staircase outwards.
  void at_staircases(const Point2& p) {
    std::uint32_t from = staircases_.empty() ? 0 : find(p, staircases_.back());  // at most four stairs too low
    for (std::size_t s = staircases_.size(); s-- > 0 && !stopped_;) {
      Staircase& staircase = staircases_[s];
      std::uint32_t below = from;
      Sign side = Sign::negative;
      const auto look = [&](std::uint32_t k) { return side = side_of(p, stairs_[k].segment); };
      while (below < staircase.last && look(below) == Sign::positive) ++below;
      std::uint32_t above = below;
      passing_.clear();  // all on one line: stairs do not cross
      bool holds = below < staircase.last && side == Sign::zero;
      if (holds && !leaving_.empty() && bundle_.on_one_line(stairs_[below].segment, leaving_[0])) holds = false;
      while (holds) {
        if (!stairs_[above].lent) passing_.push_back(stairs_[above].segment);
        ++above;
        holds = above < staircase.last && bundle_.on_one_line(stairs_[above - 1].segment, stairs_[above].segment);
      }
      if (!passing_.empty()) bundle_.add_aside(passing_);
      for (const std::uint32_t i : begin_) walk(i, staircase, below, above);
      if (s > 0) from = below > staircase.first ? stairs_[below - 1].around : staircases_[s - 1].first;
    }
  }

  // The first stair that is not below p.
  std::uint32_t find(const Point2& p, const Staircase& staircase) {
    const auto first = stairs_.begin() + staircase.first, last = stairs_.begin() + staircase.last;
    const auto is_below_p = [&](const Stair& stair) { return side_of(p, stair.segment) == Sign::positive; };
    return static_cast<std::uint32_t>(std::partition_point(first, last, is_below_p) - stairs_.begin());
  }

  // --- Order ---

  // Where p stands: positive above the segment, which is alive.
  Sign side_of(const Point2& p, std::uint32_t i) {
    ++cost_.probes;
    return orient_2d(segments_[i].a, segments_[i].b, p);
  }

  // Of two that are alive at this time.
  bool is_below(std::uint32_t i, std::uint32_t j, Time time) {
    if (first_[i] < first_[j]) return !is_below(j, i, time);
    const Segment &s = segments_[i], &t = segments_[j];
    if (s.a.x != s.b.x && t.a.x != t.b.x) {
      ++cost_.probes;
      const Sign order = height_order(t.a, t.b, s.a, s.b, point(time.place).x);
      if (order != Sign::zero) return order == Sign::positive;
    }
    Sign side = side_of(s.a, j);  // of s, when it begins
    if (side == Sign::zero) side = orient_2d(t.a, t.b, s.b);
    if (side == Sign::zero) return i < j;
    const bool begins_below = side == Sign::negative;
    return begins_below != (begins_below ? cross_by(i, j, time) : cross_by(j, i, time));
  }

  // Of two, in their order at some time before at which they are alive: have they changed it, or did the first to end
  // end in between, after they had changed it?
  bool cross_by(std::uint32_t lower, std::uint32_t upper, Time time) {
    ++cost_.probes;
    const Segment &s = segments_[lower], &t = segments_[upper];
    const bool s_ends_first = last_[lower] < last_[upper];
    const Sign side = s_ends_first ? orient_2d(t.a, t.b, s.b) : -orient_2d(s.a, s.b, t.b);
    if (side != Sign::positive) return false;
    if (std::min(last_[lower], last_[upper]) <= time.place) return true;
    const Sign order = crossing_order(s, t, point(time.place));
    return order == Sign::negative || (order == Sign::zero && time.after);
  }

  // Where two cross that are alive at p, of which s begins below the other: lexicographically, the sign of that point
  // minus p. (One that stands upright does so at p.x.)
  static Sign crossing_order(const Segment& s, const Segment& t, const Point2& p) {
    const bool s_stands = s.a.x == s.b.x, t_stands = t.a.x == t.b.x;
    if (!s_stands && !t_stands) {
      const Sign by_x = height_order(t.a, t.b, s.a, s.b, p.x);
      if (by_x != Sign::zero) return by_x;
    }
    return s_stands ? -orient_2d(t.a, t.b, p) : -orient_2d(s.a, s.b, p);
  }

  void give_crossing(std::uint32_t i, std::uint32_t j) {
    may_be_interrupted(1);
    if (may_meet(options_.groups, i, j)) return;
    stopped_ = !visit_({std::min(i, j), std::max(i, j), ContactKind::crossing});
  }

  const Segments& segments_;
  const SetOptions& options_;
  const SegmentsVisitor& visit_;
  std::vector<std::uint32_t> ends_, places_;  // each place: where its ends begin
  std::vector<std::uint32_t> first_, last_;   // of each segment: the places of its ends
  std::vector<std::uint32_t> list_;           // those alive that are in no staircase, in their order
  std::vector<Stair> stairs_;                 // of the strips around, one staircase after another, the innermost last
  std::vector<Staircase> staircases_;
  std::vector<std::uint32_t> begin_, points_, passing_;  // at a place
  std::vector<std::uint32_t> leaving_;  // at a place where segments of one line end and nothing else is in the list
  std::vector<std::uint32_t> stands_;   // of those in the list: the number in stairs_ of the first stair above
  bool stopped_ = false;
  Cost cost_;
  ContactBundle bundle_{segments_, options_, visit_, cost_};
};

}  // namespace

Cost segments_all_by_balaban(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit) {
  check_groups(options.groups, segments.size());
  return Balaban(segments, options, visit).run();
}

}  // namespace sunder::planar
