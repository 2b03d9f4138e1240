#include <verifier/cpp/reader.h>
#include <verifier/cpp/rules.h>
#include <verifier/cpp/sweep.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

namespace sunder_verifier {

// ---- Contacts of segments.

namespace {

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
  ContactSweep(const Claim& claim, const Tables& tables, const std::vector<std::int64_t>& groups,
               const AllowedContacts& allowed)
      : sweep_(claim.events, tables.segments, tables.segment_bits),
        segments_(tables.segments),
        groups_(groups),
        allowed_(allowed) {}

  void run(const VisitContact& visit) {
    while (sweep_.next()) {
      if (sweep_.here.size() + static_cast<std::size_t>(sweep_.row_end - sweep_.row) < 2) continue;  // it is alone
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
    at_.push_back({s, back, no_index, ends_at(segments_[s], sweep_.point), group_of(s)});
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
  void look(const std::vector<std::size_t>& some, const std::vector<std::size_t>& others,
            const VisitContact& visit) const {
    if (!more_groups(others)) return;
    take_steps(some.size() * others.size() / 16, 1, 1);
    for (const std::size_t k : some) {
      for (const std::size_t l : others) {
        if (k < l || (some.size() < others.size() && at_[l].ends)) meet(at_[k], at_[l], visit);
      }
    }
  }

  // Those that go on along one line, but for those that were looked at.
  void look_along_lines(const VisitContact& visit) const {
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

  void meet(const AtEvent& s, const AtEvent& t, const VisitContact& visit) const {
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

std::string pair_text(std::size_t i, std::size_t j) { return std::to_string(i) + " and " + std::to_string(j); }

}  // namespace

void check_contact(const std::vector<PlanarSegment>& segments, std::int64_t exponent, std::size_t bits,
                   const StatedContact& contact, const Numbers& point, const std::vector<std::int64_t>& groups,
                   const AllowedContacts& allowed) {
  const auto& [i, j, kind] = contact;
  take_steps(16, length(point), bits);
  const SweepPoint place = place_in_units(point, exponent);
  require(i != j && (groups.empty() || groups[i] != groups[j]), "contact", pair_text(i, j) + " are of one group");
  const bool counts = !(kind == "shared-endpoint" && allowed.shared_endpoint) && !(kind == "touch" && allowed.touch);
  require(counts, "contact", kind + " does not count");
  for (const std::size_t k : {i, j}) {
    require(is_on(segments[k], place), "contact", "the point is not in " + std::to_string(k));
  }
  const std::string found = kind_of(segments[i], segments[j]);
  require(found == kind, "contact", "the contact is " + found);
}

ContactsOf contacts_of_segments(const Claim& claim, const Tables& tables, const std::vector<std::int64_t>& groups,
                                const AllowedContacts& allowed) {
  return [&](const VisitContact& visit) { ContactSweep(claim, tables, groups, allowed).run(visit); };
}

// ---- Lists: of segments that meet, and of polygons.

void check_listed(const char* rule, const ContactsOf& contacts, const std::vector<StatedContact>& listed) {
  std::vector<bool> found(listed.size());
  contacts([&](std::size_t i, std::size_t j, const char* kind) {
    const auto at =
        std::lower_bound(listed.begin(), listed.end(), std::pair(i, j),
                         [](const StatedContact& c, const auto& pair) { return std::pair(c.i, c.j) < pair; });
    const bool is_listed = at != listed.end() && at->i == i && at->j == j && at->kind == kind;
    require(is_listed, rule, pair_text(i, j) + " have a contact that counts, and is not listed");
    found[static_cast<std::size_t>(at - listed.begin())] = true;
  });
  for (std::size_t k = 0; k < listed.size(); ++k) {
    require(found[k], rule, pair_text(listed[k].i, listed[k].j) + " have no contact that counts");
  }
}

void check_number(const char* rule, const ContactsOf& contacts, std::uint64_t number) {
  std::uint64_t count = 0;
  contacts([&](std::size_t, std::size_t, const char*) { ++count; });
  require(count == number, rule, std::to_string(count) + " contacts count");
}

}  // namespace sunder_verifier
