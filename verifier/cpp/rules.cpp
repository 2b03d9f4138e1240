#include <verifier/cpp/rules.h>
#include <verifier/statement.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

namespace sunder_verifier {

// ---- Sweeps.

namespace {

Integer turn(const Integer& ux, const Integer& uy, const Integer& vx, const Integer& vy) { return ux * vy - uy * vx; }

// x / w, y / w; w > 0.
struct SweepPoint {
  Integer x, y, w = 1;

  bool is(const PlanarPoint& p) const { return x == p.x * w && y == p.y * w; }
};

// Is p lexicographically before q?
bool is_before(const SweepPoint& p, const SweepPoint& q) {
  const int x = Integer(p.x * q.w).compare(Integer(q.x * p.w));
  return x != 0 ? x < 0 : p.y * q.w < q.y * p.w;
}

// 1: the point is above the segment's line: left of it, seen from its first end.
int side(const PlanarSegment& s, const SweepPoint& p) {
  return turn(s.last.x - s.first.x, s.last.y - s.first.y, p.x - s.first.x * p.w, p.y - s.first.y * p.w).sign();
}

int turn(const PlanarSegment& s, const PlanarSegment& t) {
  return turn(s.last.x - s.first.x, s.last.y - s.first.y, t.last.x - t.first.x, t.last.y - t.first.y).sign();
}

bool is_point(const PlanarSegment& s) { return s.first == s.last; }

// Of their lines, which are not parallel.
SweepPoint crossing(const PlanarSegment& s, const PlanarSegment& t) {
  const Integer ux = s.last.x - s.first.x, uy = s.last.y - s.first.y;
  const Integer vx = t.last.x - t.first.x, vy = t.last.y - t.first.y;
  SweepPoint p;
  p.w = turn(ux, uy, vx, vy);
  Integer along = turn(t.first.x - s.first.x, t.first.y - s.first.y, vx, vy);
  if (p.w < 0) {
    p.w = -p.w;
    along = -along;
  }
  p.x = s.first.x * p.w + ux * along;
  p.y = s.first.y * p.w + uy * along;
  return p;
}

bool is_less(const PlanarPoint& p, const PlanarPoint& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

SweepPoint place_of(const PlanarPoint& p) { return {p.x, p.y, 1}; }

bool is_on(const PlanarSegment& s, const SweepPoint& p) {
  return side(s, p) == 0 && !is_before(p, place_of(s.first)) && !is_before(place_of(s.last), p);
}

// How two segments meet that have a common point.
const char* kind_of(const PlanarSegment& s, const PlanarSegment& t) {
  if (turn(s, t) == 0 && !is_point(s) &&
      !is_point(t)) {  // on one line, where the order of points is the order along it
    const PlanarPoint& first = is_less(s.first, t.first) ? t.first : s.first;
    const PlanarPoint& last = is_less(s.last, t.last) ? s.last : t.last;
    return is_less(first, last) ? "overlap" : "shared-endpoint";
  }
  for (const PlanarPoint* p : {&s.first, &s.last}) {
    if (*p == t.first || *p == t.last) return "shared-endpoint";
  }
  const bool touch = is_on(t, place_of(s.first)) || is_on(t, place_of(s.last)) || is_on(s, place_of(t.first)) ||
                     is_on(s, place_of(t.last));
  return touch ? "touch" : "crossing";
}

// The list of a sweep: event by event, which segments hold its point.
class Sweep {
 public:
  Sweep(const SweepEvents& events, const Tables& tables)
      : events_(events),
        tables_(tables),
        segments_(tables.segments),
        above_(segments_.size() + 1, kOut),
        has_begun_(segments_.size()),
        stays_(segments_.size()) {
    above_[segments_.size()] = segments_.size();  // the end of the ring, which stands below and above all
  }

  // Of the event passed last.
  SweepPoint point;
  std::vector<std::size_t> here;                         // what was in the list, and holds the point
  const std::size_t *row = nullptr, *row_end = nullptr;  // what goes on from it

  // Passes the next event. False: there is none, and the list is empty.
  bool next() {
    if (k_ == events_.at.size()) {
      require(above_[segments_.size()] == segments_.size() && begun_ == segments_.size(), "sweep",
              "not all segments begin and end");
      return false;
    }
    row = events_.row.data() + events_.begin[k_];
    row_end = events_.row.data() + events_.begin[k_ + 1];
    come_to_point();
    const std::size_t none = segments_.size();
    const std::size_t below = events_.below[k_] < 0 ? none : static_cast<std::size_t>(events_.below[k_]);
    const std::size_t upper = take_out_from(below);
    put_in(below, upper);
    require(stay_ == 0, "sweep", where() + " loses a segment that goes on");
    ++k_;
    return true;
  }

 private:
  static constexpr std::size_t kOut = no_index;

  std::string where() const { return "event " + std::to_string(k_); }

  void come_to_point() {
    SweepPoint p;
    if (events_.at[k_] >= 0) {
      const auto end = static_cast<std::size_t>(events_.at[k_]);
      const PlanarPoint& q = end % 2 == 1 ? segments_[end / 2].last : segments_[end / 2].first;
      p.x = q.x;
      p.y = q.y;
    } else {
      require(row_end - row > 1 && turn(segments_[*row], segments_[row_end[-1]]) != 0, "sweep",
              where() + " has no point: its first and last segment do not cross");
      const std::size_t longest = 3 * tables_.segment_bits;
      take_steps(static_cast<std::uint64_t>(row_end - row) + 4, longest, longest);
      p = crossing(segments_[*row], segments_[row_end[-1]]);
    }
    require(k_ == 0 || is_before(point, p), "sweep", where() + " is not after the one before it");
    point = std::move(p);
  }

  // Takes out what holds the point, from `below` up. The one above that.
  std::size_t take_out_from(std::size_t below) {
    const std::size_t none = segments_.size();
    require(above_[below] != kOut, "sweep", where() + " is above a segment that is not in the list");
    require(below == none || side(segments_[below], point) > 0, "sweep",
            where() + " is not above segment " + std::to_string(below));
    here.clear();
    stay_ = 0;
    std::size_t s = above_[below];
    int place = 0;
    while (s != none && (place = side(segments_[s], point)) == 0) {
      here.push_back(s);
      stays_[s] = !point.is(segments_[s].last);
      if (stays_[s]) ++stay_;
      s = std::exchange(above_[s], kOut);
    }
    require(s == none || place < 0, "sweep", where() + " is not below segment " + std::to_string(s));
    return s;
  }

  // Puts in what goes on, sorted by direction.
  void put_in(std::size_t below, std::size_t upper) {
    std::size_t lower = below;
    for (const std::size_t* s = row; s != row_end; ++s) {
      if (stays_[*s]) {
        stays_[*s] = false;
        --stay_;
      } else {
        require(!has_begun_[*s] && point.is(segments_[*s].first), "sweep",
                where() + ": segment " + std::to_string(*s) + " is not in the list there, or does not begin there");
        has_begun_[*s] = true;
        ++begun_;
      }
      require(lower == below || turn(segments_[lower], segments_[*s]) >= 0, "sweep",
              where() + ": segment " + std::to_string(*s) + " does not go on above " + std::to_string(lower));
      if (is_point(segments_[*s])) continue;
      above_[lower] = *s;
      lower = *s;
    }
    above_[lower] = upper;
  }

  const SweepEvents& events_;
  const Tables& tables_;
  const std::vector<PlanarSegment>& segments_;
  std::size_t k_ = 0, begun_ = 0, stay_ = 0;
  std::vector<std::size_t> above_;  // by segment: the next one in the list; out: it is not in
  std::vector<bool> has_begun_, stays_;
};

// What holds the point of an event.
struct AtEvent {
  std::size_t segment;
  std::size_t back, on;  // its line before the point and after it, numbered; no_index: it is not there then
  bool ends;             // the point is one of its ends
  std::int64_t group;
};

// Goes through a sweep, and tells of each two segments of different groups whose contact counts, once.
class ContactSweep {
 public:
  using Visit = std::function<void(std::size_t i, std::size_t j, const char* kind)>;  // i < j

  ContactSweep(const Claim& claim, const Tables& tables, const std::vector<std::int64_t>& groups,
               const AllowedContacts& allowed)
      : sweep_(claim.events, tables), segments_(tables.segments), groups_(groups), allowed_(allowed) {}

  void run(const Visit& visit) {
    while (sweep_.next()) {
      gather();
      const auto passes = [&](std::size_t k) { return !at_[k].ends; };
      std::vector<std::size_t> all(at_.size()), passing;
      std::iota(all.begin(), all.end(), std::size_t{0});
      std::copy_if(all.begin(), all.end(), std::back_inserter(passing), passes);
      const bool any_may_touch = allowed_.shared_endpoint || allowed_.touch;
      look(any_may_touch ? passing : all, allowed_.touch ? passing : all, visit);
      look_along_lines(visit);
    }
  }

 private:
  std::int64_t group_of(std::size_t s) const { return groups_.empty() ? static_cast<std::int64_t>(s) : groups_[s]; }
  bool is_line(std::size_t s) const { return !is_point(segments_[s]); }

  void add(std::size_t s, std::size_t back) {
    const bool ends = sweep_.point.is(segments_[s].first) || sweep_.point.is(segments_[s].last);
    at_.push_back({s, back, no_index, ends, group_of(s)});
  }

  // What holds the point, with the lines of what was here, and of what goes on.
  void gather() {
    at_.clear();
    place_.clear();
    rows_.clear();
    std::size_t line = 0;
    for (const std::size_t s : sweep_.here) {
      if (!at_.empty() && turn(segments_[at_.back().segment], segments_[s]) != 0) ++line;
      place_[s] = at_.size();
      add(s, line);
    }
    const std::size_t* before = nullptr;
    for (const std::size_t* s = sweep_.row; s != sweep_.row_end; ++s) {
      const auto [place, is_new] = place_.try_emplace(*s, at_.size());
      if (is_new) add(*s, no_index);
      if (!is_line(*s)) continue;
      if (before == nullptr || turn(segments_[*before], segments_[*s]) != 0) rows_.emplace_back();
      before = s;
      at_[place->second].on = rows_.size() - 1;
      rows_.back().push_back(place->second);
    }
  }

  bool more_groups(const std::vector<std::size_t>& some) const {
    return std::any_of(some.begin(), some.end(), [&](std::size_t k) { return at_[k].group != at_[some[0]].group; });
  }

  // Each of some with each of others; those that are in both, once.
  void look(const std::vector<std::size_t>& some, const std::vector<std::size_t>& others, const Visit& visit) const {
    if (!more_groups(others)) return;
    take_steps(some.size() * others.size() / 16, 1, 1);
    for (const std::size_t k : some) {
      for (const std::size_t l : others) {
        if (k < l || (some.size() < others.size() && at_[l].ends)) meet(at_[k], at_[l], visit);
      }
    }
  }

  // Those that go on along one line, but for those that were looked at.
  void look_along_lines(const Visit& visit) const {
    for (const std::vector<std::size_t>& row : rows_) {
      if (!more_groups(row)) continue;
      take_steps(row.size() * row.size() / 16, 1, 1);
      for (std::size_t k = 0; k < row.size(); ++k) {
        for (std::size_t l = 0; l < k; ++l) {
          const AtEvent &s = at_[row[k]], &t = at_[row[l]];
          const bool both_end = s.ends && t.ends, some_end = s.ends || t.ends;
          if (allowed_.touch ? some_end : allowed_.shared_endpoint && both_end) meet(s, t, visit);
        }
      }
    }
  }

  void meet(const AtEvent& s, const AtEvent& t, const Visit& visit) const {
    if (s.group == t.group || (s.back != no_index && s.back == t.back)) return;  // on one line before: they have met
    const bool overlap = s.on != no_index && s.on == t.on;
    if (!overlap && s.ends && t.ends && allowed_.shared_endpoint) return;
    if (!overlap && s.ends != t.ends && allowed_.touch) return;
    const char* kind = overlap            ? "overlap"
                       : s.ends && t.ends ? "shared-endpoint"
                       : s.ends || t.ends ? "touch"
                                          : "crossing";
    visit(std::min(s.segment, t.segment), std::max(s.segment, t.segment), kind);
  }

  Sweep sweep_;
  const std::vector<PlanarSegment>& segments_;
  const std::vector<std::int64_t>& groups_;
  const AllowedContacts& allowed_;
  std::vector<AtEvent> at_;
  std::unordered_map<std::size_t, std::size_t> place_;  // of a segment in at_
  std::vector<std::vector<std::size_t>> rows_;          // places of those that go on along one line
};

std::string segments_text(std::size_t i, std::size_t j) {
  return "segments " + std::to_string(i) + " and " + std::to_string(j);
}

}  // namespace

void check_contact(const Tables& tables, const StatedContact& contact, const Numbers& point,
                   const std::vector<std::int64_t>& groups, const AllowedContacts& allowed) {
  const auto& [i, j, kind] = contact;
  take_steps(16, length(point), tables.segment_bits);
  Numbers in_units = point;
  for (Number& value : in_units) value.e -= tables.segment_exponent;
  Integers given = projective(in_units);
  const SweepPoint place{std::move(given[0]), std::move(given[1]), std::move(given[2])};
  require(i != j && (groups.empty() || groups[i] != groups[j]), "contact",
          std::to_string(i) + " and " + std::to_string(j) + " are of one group");
  const bool counts = !(kind == "shared-endpoint" && allowed.shared_endpoint) && !(kind == "touch" && allowed.touch);
  require(counts, "contact", kind + " does not count");
  for (const std::size_t k : {i, j}) {
    require(is_on(tables.segments[k], place), "contact", "the point is not in " + std::to_string(k));
  }
  const std::string found = kind_of(tables.segments[i], tables.segments[j]);
  require(found == kind, "contact", "the contact is " + found);
}

void check_none_counts(const Claim& claim, const Tables& tables, const std::vector<std::int64_t>& groups,
                       const AllowedContacts& allowed) {
  ContactSweep(claim, tables, groups, allowed).run([](std::size_t i, std::size_t j, const char* kind) {
    require(false, "none_counts", segments_text(i, j) + " have a contact: " + kind);
  });
}

void check_these_count(const Claim& claim, const Tables& tables, const std::vector<std::int64_t>& groups,
                       const AllowedContacts& allowed, const std::vector<StatedContact>& contacts) {
  std::vector<bool> found(contacts.size());
  ContactSweep(claim, tables, groups, allowed).run([&](std::size_t i, std::size_t j, const char* kind) {
    const auto at =
        std::lower_bound(contacts.begin(), contacts.end(), std::pair(i, j),
                         [](const StatedContact& c, const auto& pair) { return std::pair(c.i, c.j) < pair; });
    require(at != contacts.end() && at->i == i && at->j == j && at->kind == kind, "these_count",
            segments_text(i, j) + " have a contact that is not listed: " + kind);
    found[static_cast<std::size_t>(at - contacts.begin())] = true;
  });
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    require(found[k], "these_count", segments_text(contacts[k].i, contacts[k].j) + " have no contact that counts");
  }
}

void check_number_counts(const Claim& claim, const Tables& tables, const std::vector<std::int64_t>& groups,
                         const AllowedContacts& allowed, std::uint64_t number) {
  std::uint64_t count = 0;
  ContactSweep(claim, tables, groups, allowed).run([&](std::size_t, std::size_t, const char*) { ++count; });
  require(count == number, "number_counts", std::to_string(count) + " contacts count");
}

}  // namespace sunder_verifier
