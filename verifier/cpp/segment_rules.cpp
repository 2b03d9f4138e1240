// The contacts of segments, by a sweep: docs/claims.md, "Sweeps".
#include <verifier/cpp/contacts.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>

namespace sunder_verifier {

namespace {

// What holds the point of an event.
struct AtEvent {
  std::size_t segment;
  std::size_t back, on;  // its line before the point and after it, numbered; no_index: it is not there then
  bool ends;             // the point is one of its ends
  std::int64_t group;
};

// Places in a list of AtEvent, class by class: two of them may have contacts if they are of different classes and
// groups, and one of them is of the first.
struct Meeting {
  struct Member {
    std::size_t place, of_class;
    bool is_first;
  };
  std::vector<Member> members;

  void add(std::size_t place, std::size_t of_class, bool is_first) { members.push_back({place, of_class, is_first}); }
};

// Visits each two that may have contacts once, in time of their number and that of the members.
template <class Visit>
void visit_pairs(const Meeting& meeting, const std::vector<AtEvent>& at, const Visit& visit) {
  using ByGroup = std::map<std::int64_t, std::vector<std::size_t>>;  // of the classes before
  ByGroup all, first;
  const auto& members = meeting.members;
  for (std::size_t begin = 0, end = 0; begin < members.size(); begin = end) {
    while (end < members.size() && members[end].of_class == members[begin].of_class) ++end;
    for (std::size_t k = begin; k < end; ++k) {
      const AtEvent& s = at[members[k].place];
      for (const auto& [group, others] : members[k].is_first ? all : first) {
        if (group == s.group) continue;
        for (const std::size_t t : others) visit(s, at[t]);
      }
    }
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t place = members[k].place;
      all[at[place].group].push_back(place);
      if (members[k].is_first) first[at[place].group].push_back(place);
    }
  }
}

// How many pairs of different groups there are.
std::uint64_t of_two_groups(std::vector<std::int64_t> groups) {
  std::sort(groups.begin(), groups.end());
  std::uint64_t number = 0;
  for (std::size_t begin = 0, end = 0; begin < groups.size(); begin = end) {
    while (end < groups.size() && groups[end] == groups[begin]) ++end;
    number += begin * (end - begin);
  }
  return number;
}

// How many pairs visit_pairs visits, in time n log n of the members: those of all, less those of what is not first.
std::uint64_t number_of_pairs(const Meeting& meeting, const std::vector<AtEvent>& at) {
  const auto of_different_classes = [&](bool also_first) {
    std::vector<std::int64_t> all, in_class;
    std::uint64_t in_classes = 0;
    for (std::size_t k = 0; k < meeting.members.size(); ++k) {
      const auto& [place, of_class, is_first] = meeting.members[k];
      if (k > 0 && of_class != meeting.members[k - 1].of_class) {
        in_classes += of_two_groups(std::move(in_class));
        in_class.clear();
      }
      if (is_first && !also_first) continue;
      all.push_back(at[place].group);
      in_class.push_back(at[place].group);
    }
    return of_two_groups(std::move(all)) - in_classes - of_two_groups(std::move(in_class));
  };
  return of_different_classes(true) - of_different_classes(false);
}

// Goes through a sweep, event by event: what holds the point, and which of these may have contacts that count.
class ContactSweep {
 public:
  ContactSweep(const SweepEvents& events, const Segments& segments, const Groups& groups,
               const AllowedContacts& allowed)
      : sweep_(events, segments), segments_(segments), groups_(groups), allowed_(allowed) {}

  std::vector<AtEvent> at;
  std::vector<Meeting> meetings;

  bool next() {
    if (!sweep_.next()) return false;
    meetings.clear();
    if (sweep_.here.size() + static_cast<std::size_t>(sweep_.row_end - sweep_.row) < 2) return true;  // it is alone
    gather();
    const bool all_of_one_group =
        std::all_of(at.begin(), at.end(), [&](const AtEvent& one) { return one.group == at[0].group; });
    if (!all_of_one_group) meet();
    return true;
  }

  const char* kind(const AtEvent& s, const AtEvent& t) const {
    if (s.on != no_index && s.on == t.on) return "overlap";
    return s.ends && t.ends ? "shared-endpoint" : s.ends || t.ends ? "touch" : "crossing";
  }

 private:
  std::int64_t group_of(std::size_t s) const { return groups_.empty() ? static_cast<std::int64_t>(s) : groups_[s]; }
  bool is_line(std::size_t s) const { return !is_point(segments_[s]); }

  void add(std::size_t s, std::size_t back) {
    at.push_back({s, back, no_index, ends_at(segments_[s], sweep_.point), group_of(s)});
  }

  // What holds the point, with the lines of what was here, and of what goes on.
  void gather() {
    at.clear();
    place_.clear();
    rows_.clear();
    std::size_t line = 0;
    for (const std::size_t s : sweep_.here) {
      if (!at.empty() && turn(segments_[at.back().segment], segments_[s]) != 0) ++line;
      place_[s] = at.size();
      add(s, line);
    }
    const std::size_t* before = nullptr;
    for (const std::size_t* s = sweep_.row; s != sweep_.row_end; ++s) {
      const auto [place, is_new] = place_.try_emplace(*s, at.size());
      if (is_new) add(*s, no_index);
      if (!is_line(*s)) continue;
      if (before == nullptr || turn(segments_[*before], segments_[*s]) != 0) rows_.emplace_back();
      before = s;
      at[place->second].on = rows_.size() - 1;
      rows_.back().push_back(place->second);
    }
  }

  // Those on one line before the point have met. What goes on along one line counts even if the point is an end.
  void meet() {
    Meeting across;
    for (std::size_t k = 0; k < at.size(); ++k) {
      if (allowed_.touch && at[k].ends) continue;
      const std::size_t alone = at.size() + k;
      across.add(k, at[k].back == no_index ? alone : at[k].back, !allowed_.shared_endpoint || !at[k].ends);
    }
    meetings.push_back(std::move(across));
    if (!allowed_.shared_endpoint) return;
    for (const std::vector<std::size_t>& row : rows_) {
      Meeting along;
      for (const std::size_t k : row) {
        if (allowed_.touch || at[k].ends) along.add(k, k, at[k].ends);
      }
      meetings.push_back(std::move(along));
    }
  }

  Sweep sweep_;
  const Segments& segments_;
  const Groups& groups_;
  const AllowedContacts& allowed_;
  std::unordered_map<std::size_t, std::size_t> place_;  // of a segment in at
  std::vector<std::vector<std::size_t>> rows_;          // places of those that go on along one line
};

}  // namespace

bool holds(const PlanarSegment& segment, const SweepPoint& place) { return is_on(segment, place); }

std::string kind_of(const PlanarSegment& s, const PlanarSegment& t) {
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

Contacts contacts_of(const SweepEvents& events, const Segments& segments, const Groups& groups,
                     const AllowedContacts& allowed) {
  const auto visit_all = [&](const VisitContact& visit) {
    ContactSweep sweep(events, segments, groups, allowed);
    while (sweep.next()) {
      for (const Meeting& meeting : sweep.meetings) {
        visit_pairs(meeting, sweep.at, [&](const AtEvent& s, const AtEvent& t) {
          visit(std::min(s.segment, t.segment), std::max(s.segment, t.segment), sweep.kind(s, t));
        });
      }
    }
  };
  const auto count_all = [&] {
    ContactSweep sweep(events, segments, groups, allowed);
    std::uint64_t number = 0;
    while (sweep.next()) {
      for (const Meeting& meeting : sweep.meetings) number += number_of_pairs(meeting, sweep.at);
    }
    return number;
  };
  return {visit_all, count_all};
}

}  // namespace sunder_verifier
