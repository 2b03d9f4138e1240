#include "sunder_verify_segments.h"

#include "segment_set.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

// The point x / w, y / w; w > 0.
struct Place {
  Integer x, y, w;
};

enum class Allowed { nothing, shared_endpoint, touch };

bool is_allowed(const std::string& kind, Allowed allowed) {
  if (kind == "none") return true;
  if (kind == contact_kinds[0]) return allowed != Allowed::nothing;
  return kind == contact_kinds[1] && allowed == Allowed::touch;
}

bool do_cross(const Segment& s, const Segment& t) { return kind_of(s, t) == contact_kinds[2]; }

// Requires that they cross.
Place crossing_of(const Segment& s, const Segment& t) {
  const Integer ux = s.last.x - s.first.x, uy = s.last.y - s.first.y;
  const Integer vx = t.last.x - t.first.x, vy = t.last.y - t.first.y;
  Integer w = ux * vy - uy * vx;
  Integer part = (t.first.x - s.first.x) * vy - (t.first.y - s.first.y) * vx;  // of s, before it, times w
  if (w < 0) {
    w = -w;
    part = -part;
  }
  return {s.first.x * w + part * ux, s.first.y * w + part * uy, w};
}

// -1: p comes first; 1: q; 0: they are one point.
int order(const Place& p, const Place& q) {
  const auto compare = [&](const Integer& a, const Integer& b) {
    return p.w == 1 && q.w == 1 ? a.compare(b) : Integer(a * q.w).compare(Integer(b * p.w));
  };
  const int x = compare(p.x, q.x), both = x != 0 ? x : compare(p.y, q.y);
  return (both > 0) - (both < 0);
}

// Is s, just after it begins, above t, which has begun? A segment of length zero is above those that it lies on. On one
// line s is above the members of its group.
bool is_above(const Segment& s, const Segment& t, bool is_one_group) {
  const int begins = turn(t.first, t.last, s.first);
  if (begins != 0) return begins > 0;
  if (s.first == s.last) return true;
  const int ends = turn(t.first, t.last, s.last);
  return ends > 0 || (ends == 0 && is_one_group);
}

// Do two cross, the lower one being below the other before?
bool cross_further_on(const Segment& lower, const Segment& upper) {
  const bool lower_ends_first = lower.last < upper.last;
  const bool is_past =
      lower_ends_first ? turn(upper.first, upper.last, lower.last) > 0 : turn(lower.first, lower.last, upper.last) < 0;
  return is_past && do_cross(lower, upper);
}

struct Some {
  std::size_t i = 0, j = 0;
  std::string kind;
  Numbers point;
};

void check_some(const SegmentSet& set, Allowed allowed, const Some& some) {
  take_steps(16, length(some.point), set.bits);
  require(!is_allowed(some.kind, allowed), "C1", some.kind + " does not count");
  require(!set.is_one_group(some.i, some.j), "C1",
          "segments " + std::to_string(some.i) + " and " + std::to_string(some.j) + " are of one group");
  const Number &x = some.point[0], &y = some.point[1];
  const std::int64_t low = std::min(set.e, std::min(x.e, y.e));
  const Integer unit = shifted(x.d * y.d, set.e - low);  // one unit of the coordinates
  for (const std::size_t k : {some.i, some.j}) {
    const Segment& s = set.segments[k];
    const Integer px = shifted(x.n * y.d, x.e - low) - s.first.x * unit;
    const Integer py = shifted(y.n * x.d, y.e - low) - s.first.y * unit;
    const Integer dx = s.last.x - s.first.x, dy = s.last.y - s.first.y;
    const Integer along = px * dx + py * dy;
    const bool is_point = dx == 0 && dy == 0;
    const bool on_line = is_point ? px == 0 && py == 0 : px * dy == py * dx;
    require(on_line && along >= 0 && along <= (dx * dx + dy * dy) * unit, "C2",
            "the point is not on segment " + std::to_string(k));
  }
  const std::string found = kind_of(set.segments[some.i], set.segments[some.j]);
  require(found == some.kind, "C3", "the contact is " + found);
}

constexpr std::size_t exchange = std::numeric_limits<std::size_t>::max();  // the event

struct None {
  std::vector<std::size_t> events;
  std::vector<std::size_t> below;  // or no_index
  std::vector<std::pair<std::size_t, std::size_t>> exchanges;
};

// The order of events at one point: last ends, exchanges, points, one after the other, first ends.
using Rank = std::pair<int, std::size_t>;
Rank rank_of(const SegmentSet& set, std::size_t event) {
  if (event == exchange) return {1, 0};
  const Segment& s = set.segments[event / 2];
  if (s.first == s.last) return {2, event};
  return {event % 2 == 1 ? 0 : 3, 0};
}

// T1, and of T5 what needs no list. The place of each exchange.
std::vector<Place> check_order(const SegmentSet& set, Allowed allowed, const None& none) {
  std::vector<bool> seen(2 * set.segments.size());
  std::size_t ends = 0;
  for (const std::size_t event : none.events) {
    if (event == exchange) continue;
    require(!seen[event], "T1", "event " + std::to_string(event) + " is there twice");
    seen[event] = true;
    ++ends;
  }
  require(ends == seen.size(), "T1", "the events are not each end of each segment once");
  std::vector<Place> places;
  places.reserve(none.exchanges.size());
  Place before;
  Rank rank_before;
  std::size_t end_before = exchange;  // the last event that is an end, if any
  for (std::size_t k = 0; k < none.events.size(); ++k) {
    const std::size_t event = none.events[k];
    Place here;
    if (event == exchange) {
      const auto [i, j] = none.exchanges[places.size()];
      take_steps(1, 3 * set.bits, 3 * set.bits);
      require(set.is_one_group(i, j) && do_cross(set.segments[i], set.segments[j]), "T5",
              "segments " + std::to_string(i) + " and " + std::to_string(j) +
                  ", which are exchanged, are not of one group or do not cross");
      here = crossing_of(set.segments[i], set.segments[j]);
      places.push_back(here);
    } else {
      const Point& p = set.end_of(event);
      here = {p.x, p.y, 1};
    }
    const Rank rank = rank_of(set, event);
    if (k > 0) {
      const int step = order(before, here);
      require(step < 0 || (step == 0 && rank_before <= rank), "T1", "event " + std::to_string(k) + " is out of order");
    }
    if (event != exchange) {
      const bool shared =
          allowed == Allowed::nothing && end_before != exchange && set.end_of(end_before) == set.end_of(event);
      require(!shared || set.is_one_group(end_before / 2, event / 2), "T1",
              "event " + std::to_string(k) + " shares its point with a segment that it may not meet");
      end_before = event;
    }
    before = std::move(here);
    rank_before = rank;
  }
  return places;
}

class Transcript {
 public:
  Transcript(const SegmentSet& set, Allowed allowed)
      : set_(set), allowed_(allowed), size_(set.segments.size()), above_(size_ + 1, size_), below_(above_) {
    is_cut_.resize(size_ + 1);
    is_cut_[size_] = true;
  }

  void check(const None& none) {
    const std::vector<Place> places = check_order(set_, allowed_, none);
    const bool looks = set_.has_groups && allowed_ != Allowed::touch;
    Holders holders(set_);
    std::size_t begun = 0, exchanged = 0;
    for (const std::size_t event : none.events) {
      at_exchange_ = event == exchange ? &places[exchanged] : nullptr;
      event_ = event;
      if (event == exchange) {
        const auto [i, j] = none.exchanges[exchanged++];
        exchange_neighbours(i, j);
        continue;
      }
      const auto [lower, upper] = event % 2 == 1 ? take_out(event / 2) : put_in(event / 2, none.below[begun++]);
      if (looks) holders.look(event, lower, upper);
    }
  }

 private:
  using Around = std::pair<std::size_t, std::size_t>;

  Around put_in(std::size_t s, std::size_t named) {
    const std::size_t lower = named == no_index ? size_ : named;
    require(is_cut_[lower], "T2",
            "segment " + std::to_string(s) + " begins above " + std::to_string(lower) + ", which is not cut then");
    const std::size_t upper = above_[lower];
    require(lower == size_ || begins_above(s, lower), "T3",
            "segment " + std::to_string(s) + " does not begin above " + std::to_string(lower));
    require(upper == size_ || !begins_above(s, upper), "T3",
            "segment " + std::to_string(s) + " does not begin below " + std::to_string(upper));
    part(lower, upper);
    is_cut_[s] = true;
    link(lower, s);
    link(s, upper);
    become_neighbours(lower, s);
    become_neighbours(s, upper);
    return {lower, upper};
  }

  Around take_out(std::size_t s) {
    require(is_cut_[s], "T2", "segment " + std::to_string(s) + " ends before it begins");
    const std::size_t lower = below_[s], upper = above_[s];
    part(lower, s);
    part(s, upper);
    is_cut_[s] = false;
    link(lower, upper);
    become_neighbours(lower, upper);
    return {lower, upper};
  }

  void exchange_neighbours(std::size_t i, std::size_t j) {
    require(
        is_cut_[i] && above_[i] == j, "T5",
        "segment " + std::to_string(i) + " is not just below " + std::to_string(j) + ", with which it is exchanged");
    const std::size_t lower = below_[i], upper = above_[j];
    part(lower, i);
    part(i, j);
    part(j, upper);
    link(lower, j);
    link(j, i);
    link(i, upper);
    become_neighbours(lower, j);
    become_neighbours(i, upper);
  }

  bool begins_above(std::size_t s, std::size_t t) const {
    return is_above(set_.segments[s], set_.segments[t], set_.is_one_group(s, t));
  }

  void link(std::size_t lower, std::size_t upper) {
    above_[lower] = upper;
    below_[upper] = lower;
  }

  bool may_meet(std::size_t i, std::size_t j) const { return i == size_ || j == size_ || set_.is_one_group(i, j); }

  void become_neighbours(std::size_t lower, std::size_t upper) const {
    if (may_meet(lower, upper)) return;
    const std::string kind = kind_of(set_.segments[lower], set_.segments[upper]);
    require(
        is_allowed(kind, allowed_), "T4",
        "segments " + std::to_string(lower) + " and " + std::to_string(upper) + " become neighbours and meet: " + kind);
  }

  // Two neighbours are not neighbours any longer. Those of two groups do not cross, by T4.
  void part(std::size_t lower, std::size_t upper) const {
    if (lower == size_ || upper == size_ || !set_.is_one_group(lower, upper)) return;
    const Segment &s = set_.segments[lower], &t = set_.segments[upper];
    if (!cross_further_on(s, t)) return;
    const Place crossing = crossing_of(s, t);
    require(order(place(), crossing) <= 0, "T5",
            "segments " + std::to_string(lower) + " and " + std::to_string(upper) +
                " are neighbours still where they have crossed");
  }

  Place place() const {
    if (at_exchange_ != nullptr) return *at_exchange_;
    const Point& p = set_.end_of(event_);
    return {p.x, p.y, 1};
  }

  const SegmentSet& set_;
  const Allowed allowed_;
  const std::size_t size_;                  // stands below and above all: the list is a ring
  std::vector<std::size_t> above_, below_;  // in the list
  std::vector<bool> is_cut_;                // is the segment in the list?
  std::size_t event_ = 0;                   // the one now
  const Place* at_exchange_ = nullptr;      // its place, if it is an exchange
};

SegmentSet read_set(const json& top) {
  Numbers flat;
  std::size_t count = 0;
  for (const json& item : list_member(top, "segments", "the file")) {
    for (Number& number : read_numbers(item, 4, read_double, "segments[" + std::to_string(count) + "]")) {
      flat.push_back(std::move(number));
    }
    ++count;
  }
  const Common scaled = common(flat);
  SegmentSet set;
  set.e = scaled.e;
  set.bits = bits(scaled.integers);
  for (std::size_t k = 0; k < flat.size(); k += 4) {
    const Integer* x = &scaled.integers[k];
    set.segments.push_back({{x[0], x[1]}, {x[2], x[3]}});
    const Segment& s = set.segments.back();
    if (s.last < s.first) {
      refuse_form("segments[" + std::to_string(k / 4) + "] does not begin with its lexicographically first end");
    }
  }
  const std::size_t size = set.segments.size();
  set.has_groups = top.contains("groups");
  if (set.has_groups) {
    set.groups = read_groups(top, size, "the file");
  } else {
    for (std::size_t i = 0; i < size; ++i) set.groups.push_back(static_cast<std::int64_t>(i));
  }
  return set;
}

None read_none(const json& item, const SegmentSet& set, const std::string& where) {
  const std::size_t size = set.segments.size();
  None none;
  std::size_t exchanges = 0;
  for (const json& event : list_member(item, "events", where)) {
    const bool is_exchange = set.has_groups && is_minus_one(event);
    none.events.push_back(is_exchange ? exchange : read_index(event, 2 * size, where + " event"));
    if (is_exchange) ++exchanges;
  }
  if (item.contains("exchanges")) {
    if (!set.has_groups) refuse_form(where + " has exchanges, but the file has no groups");
    for (const json& pair : list_member(item, "exchanges", where)) {
      if (!pair.is_array() || pair.size() != 2) refuse_form(where + ".exchanges has an entry that is no pair");
      const std::string entry = where + ".exchanges entry";
      none.exchanges.emplace_back(read_index(pair[0], size, entry), read_index(pair[1], size, entry));
    }
  }
  if (exchanges != none.exchanges.size()) {
    refuse_form(where + " has not one entry of exchanges for each event -1");
  }
  none.below = index_or_none_list(item, "below", size, size, where);
  return none;
}

Some read_some(const json& item, const SegmentSet& set, const std::string& where) {
  const std::size_t size = set.segments.size();
  Some some;
  some.i = index_member(item, "i", size, where);
  some.j = index_member(item, "j", size, where);
  if (some.i == some.j) refuse_form(where + " names one segment twice");
  some.kind = string_member(item, "kind", where);
  if (std::find(contact_kinds.begin(), contact_kinds.end(), some.kind) == contact_kinds.end()) {
    refuse_form(where + ".kind is no kind of contact");
  }
  some.point = read_numbers(list_member(item, "point", where), 2, read_number, where + ".point");
  return some;
}

Allowed allowed_of(const std::string& rule) {
  return rule == "touch" ? Allowed::touch : rule == "nothing" ? Allowed::nothing : Allowed::shared_endpoint;
}

}  // namespace

void add_segment_questions(const json& top, Questions& questions) {
  if (!top.contains("segments")) return;
  const auto set = std::make_shared<const SegmentSet>(read_set(top));
  questions["segments_any"] = [set](const json& item, const std::string& where) {
    const std::string rule = read_rule(item, where);
    const Allowed allowed = allowed_of(rule);
    const std::string verdict = string_member(item, "verdict", where);
    if (verdict != "some" && verdict != "none") refuse_form(where + ".verdict is neither none nor some");
    if (verdict == "some") {
      const Some some = read_some(item, *set, where);
      return make_statement("segments", rule + " allowed", verdict, [=] { check_some(*set, allowed, some); });
    }
    const None none = read_none(item, *set, where);
    return make_statement("segments", rule + " allowed", verdict, [=] { Transcript(*set, allowed).check(none); });
  };
}

}  // namespace sunder_verifier
