#include <verifier/cpp/reader.h>
#include <verifier/cpp/rules.h>
#include <verifier/cpp/sweep.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <unordered_set>
#include <utility>

namespace sunder_verifier {
namespace {

using Set = std::vector<std::size_t>;  // of polygons, sorted

Set as_set(Set all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

Set sum(const Set& a, const Set& b) {
  Set result;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

Set common(const Set& a, const Set& b) {
  Set result;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

Set without(const Set& a, const Set& b) {
  Set result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

template <class Condition>
Set only(const Set& set, const Condition& condition) {
  Set result;
  std::copy_if(set.begin(), set.end(), std::back_inserter(result), condition);
  return result;
}

Set toggled(const Set& set, std::size_t polygon) {
  Set result;
  std::set_symmetric_difference(set.begin(), set.end(), &polygon, &polygon + 1, std::back_inserter(result));
  return result;
}

// Each polygon of the first has common points that count with each of the second.
struct Meeting {
  Set first, second;
};

// Goes through a sweep of all edges, with the polygons that cover what is just above each edge of the list.
class Cells {
 public:
  Cells(const Claim& claim, const PolygonTable& polygons, const AllowedContacts& allowed)
      : polygons_(polygons),
        allowed_(allowed),
        sweep_(claim.events, polygons.edges, polygons.bits),
        label_(polygons.edges.size()) {}

  std::vector<Meeting> meetings;  // of the event passed last

  bool next() {
    if (!sweep_.next()) return false;
    meetings.clear();
    const Set& label = sweep_.below == no_index ? nothing_ : label_[sweep_.below];
    const Set at = look_at_point(label);
    for (const std::size_t s : sweep_.here) label_[s] = {};
    looks_ = label.size();
    look_after_point(label, at);
    take_steps(looks_, 1, 1);
    return true;
  }

 private:
  // Gives the polygons that have an edge there.
  Set look_at_point(const Set& label) {
    Set at, passing;
    const auto look = [&](std::size_t s) {
      at.push_back(polygons_.owner[s]);
      if (!ends_at(polygons_.edges[s], sweep_.point)) passing.push_back(polygons_.owner[s]);
    };
    std::for_each(sweep_.here.begin(), sweep_.here.end(), look);
    std::for_each(sweep_.row, sweep_.row_end, look);
    at = as_set(std::move(at));
    passing = as_set(std::move(passing));
    if (!allowed_.shared_endpoint) {
      meetings.push_back({at, sum(at, label)});
    } else if (!allowed_.touch) {
      meetings.push_back({passing, sum(at, label)});
      meetings.push_back({at, without(label, at)});
    } else {
      const Set within = only(at, [&](std::size_t i) {
        return polygons_.is_flat(i) && (polygons_.is_point(i) || std::binary_search(passing.begin(), passing.end(), i));
      });
      meetings.push_back({within, sum(within, without(label, at))});
    }
    return at;
  }

  void look_after_point(const Set& label, const Set& at) {
    Set border, lower = label;
    const std::size_t* before = nullptr;
    for (const std::size_t* s = sweep_.row; s != sweep_.row_end; ++s) {
      if (is_point(polygons_.edges[*s])) continue;
      if (before != nullptr && turn(polygons_.edges[*before], polygons_.edges[*s]) != 0) {
        end_direction(*before, at, border, lower);
      }
      label_[*s] = toggled(before == nullptr ? label : label_[*before], polygons_.owner[*s]);
      looks_ += label_[*s].size();
      border.push_back(polygons_.owner[*s]);
      before = s;
    }
    if (before != nullptr) end_direction(*before, at, border, lower);
  }

  // `last` is the last edge of those in one direction, `border` their owners, `lower` what is just below.
  void end_direction(std::size_t last, const Set& at, Set& border, Set& lower) {
    const Set& upper = label_[last];
    if (allowed_.touch) {
      meetings.push_back({common(upper, at), upper});
      border = as_set(std::move(border));
      const Set within = only(border, [&](std::size_t i) { return polygons_.is_flat(i); });
      meetings.push_back({within, sum(within, without(lower, border))});
    } else if (allowed_.shared_endpoint) {
      border = as_set(std::move(border));
      meetings.push_back({border, sum(border, lower)});
    }
    border.clear();
    lower = upper;
  }

  const PolygonTable& polygons_;
  const AllowedContacts& allowed_;
  Sweep sweep_;
  std::vector<Set> label_;  // of each edge in the list
  const Set nothing_;
  std::uint64_t looks_ = 0;
};

struct Member {
  std::int64_t group;
  std::size_t polygon;
};

bool is_of_lower_group(const Member& a, const Member& b) { return a.group < b.group; }
bool is_before(const Member& a, const Member& b) { return std::tie(a.group, a.polygon) < std::tie(b.group, b.polygon); }

class PolygonPairs {
 public:
  PolygonPairs(const Claim& claim, const PolygonTable& polygons, const std::vector<std::int64_t>& groups,
               const AllowedContacts& allowed)
      : cells_(claim, polygons, allowed), groups_(groups), count_(polygons.rings.size()) {}

  void run(const VisitContact& visit) {
    while (cells_.next()) {
      for (const Meeting& meeting : cells_.meetings) look(meeting, visit);
    }
  }

 private:
  std::int64_t group_of(std::size_t i) const { return groups_.empty() ? static_cast<std::int64_t>(i) : groups_[i]; }

  void look(const Meeting& meeting, const VisitContact& visit) {
    std::vector<Member> second;
    for (const std::size_t j : meeting.second) second.push_back({group_of(j), j});
    std::sort(second.begin(), second.end(), is_before);
    std::size_t groups = second.empty() ? 0 : 1;
    for (std::size_t k = 1; k < second.size(); ++k)
      if (second[k].group != second[k - 1].group) ++groups;
    for (const std::size_t i : meeting.first) {
      const auto [own, own_end] =
          std::equal_range(second.begin(), second.end(), Member{group_of(i), i}, is_of_lower_group);
      take_steps(groups + second.size() - static_cast<std::size_t>(own_end - own), 1, 1);
      std::for_each(second.begin(), own, [&](const Member& j) { meet(i, j.polygon, visit); });
      std::for_each(own_end, second.end(), [&](const Member& j) { meet(i, j.polygon, visit); });
    }
  }

  void meet(std::size_t i, std::size_t j, const VisitContact& visit) {
    if (i > j) std::swap(i, j);
    if (found_.insert(i * count_ + j).second) visit(i, j, "");
  }

  Cells cells_;
  const std::vector<std::int64_t>& groups_;
  const std::size_t count_;
  std::unordered_set<std::uint64_t> found_;
};

// May all these rings have a common point inside? In each part its shell, and one hole; one shell without. Rings stand
// by parts, the shell of a part first.
bool fits(const PartTable& parts, const Set& label) {
  std::size_t filled = 0;
  for (std::size_t k = 0; k < label.size();) {
    const std::size_t part = parts.part[label[k]], begin = k;
    while (k < label.size() && parts.part[label[k]] == part) ++k;
    if (k - begin > 2 || label[begin] != parts.shell[part]) return false;
    if (k - begin == 1) ++filled;
  }
  return filled <= 1;
}

// Goes through a sweep of all edges, with the rings that cover what is just above each edge of the list.
class Validity {
 public:
  Validity(const Claim& claim, const PartTable& parts, bool strict)
      : parts_(parts),
        strict_(strict),
        edges_(parts.polygons.edges),
        sweep_(claim.events, edges_, parts.polygons.bits),
        label_(edges_.size()),
        leader_(parts.rings.size()),
        seen_(parts.rings.size()) {
    for (std::size_t r = 0; r < leader_.size(); ++r) leader_[r] = r;
  }

  void check() {
    while (sweep_.next()) {
      look_at_edges();
      look_at_labels();
      join_rings();
    }
    const bool all_seen = std::find(seen_.begin(), seen_.end(), false) == seen_.end();
    const bool all_filled = std::none_of(parts_.polygons.rings.begin(), parts_.polygons.rings.end(),
                                         [](const auto& p) { return p.empty(); });
    require(all_seen && all_filled, "valid", "a ring is one point, or a part has none");
  }

 private:
  // What goes on, no two along one line; and rings come to the point once.
  void look_at_edges() {
    going_.clear();
    for (const std::size_t* s = sweep_.row; s != sweep_.row_end; ++s) {
      if (!is_point(edges_[*s])) going_.push_back(*s);
      require(!strict_ || !is_point(edges_[*s]), "valid", "a vertex is repeated");
    }
    std::vector<std::size_t> ends;
    for (const std::size_t s : sweep_.here) ends.push_back(parts_.ring_of[s]);
    for (const std::size_t s : going_) ends.push_back(parts_.ring_of[s]);
    at_ = as_set(ends);
    std::sort(ends.begin(), ends.end());
    bool twice = ends.size() == 2 * at_.size();
    for (std::size_t k = 0; twice && k < at_.size(); ++k) twice = ends[2 * k] == ends[2 * k + 1];
    require(twice, "valid", "a ring comes twice to a point");
    for (std::size_t k = 1; k < going_.size(); ++k) {
      require(turn(edges_[going_[k - 1]], edges_[going_[k]]) != 0, "valid", "edges go on along one line");
    }
  }

  void look_at_labels() {
    const Set* label = sweep_.below == no_index ? &nothing_ : &label_[sweep_.below];
    take_steps(label->size(), 1, 1);
    for (const std::size_t s : sweep_.here) label_[s] = {};
    for (const std::size_t s : going_) {
      label_[s] = toggled(*label, parts_.ring_of[s]);
      label = &label_[s];
      take_steps(label->size(), 1, 1);
      require(fits(parts_, *label), "valid", "a ring is misplaced");
    }
  }

  std::size_t leader(std::size_t r) {
    while (leader_[r] != r) r = leader_[r] = leader_[leader_[r]];
    return r;
  }

  // The rings of one part that touch at the point were not joined before.
  void join_rings() {
    for (std::size_t k = 0; k < at_.size(); ++k) {
      seen_[at_[k]] = true;
      if (k == 0 || parts_.part[at_[k]] != parts_.part[at_[k - 1]]) continue;
      require(!strict_, "valid", "two rings of a part touch");
      const std::size_t r = leader(at_[k - 1]), q = leader(at_[k]);
      require(r != q, "valid", "rings close a circle");
      leader_[std::max(r, q)] = std::min(r, q);
    }
  }

  const PartTable& parts_;
  const bool strict_;
  const std::vector<PlanarSegment>& edges_;
  Sweep sweep_;
  std::vector<Set> label_;  // of each edge in the list
  const Set nothing_;
  std::vector<std::size_t> leader_;  // of each ring
  std::vector<bool> seen_;
  std::vector<std::size_t> going_;
  Set at_;  // rings
};

// Requires that the point is on no edge.
bool is_above_odd(const std::vector<PlanarSegment>& edges, std::span<const EdgeRange> rings, const SweepPoint& p) {
  bool odd = false;
  for (const EdgeRange& ring : rings) {
    for (std::size_t k = ring.begin; k < ring.end; ++k) {
      const bool is_over = !is_before(p, place_of(edges[k].first)) && is_before(p, place_of(edges[k].last));
      odd ^= is_over && side(edges[k], p) > 0;
    }
  }
  return odd;
}

// Where a point is seen from a ring.
struct AtRing {
  SweepPoint place;
  std::size_t ends = 0;  // of edges of some length: one of each that ends there, two of each other that holds it
};

// Requires, by a rule, that an edge of some length holds the point.
AtRing at_ring(const char* rule, const PartTable& parts, std::size_t ring, const Numbers& point) {
  const EdgeRange& edges = parts.rings[ring];
  take_steps(4 * (edges.end - edges.begin), length(point), parts.polygons.bits);
  AtRing at{place_in_units(point, parts.polygons.exponent)};
  for (std::size_t k = edges.begin; k < edges.end; ++k) {
    const PlanarSegment& edge = parts.polygons.edges[k];
    if (!is_point(edge) && is_on(edge, at.place)) at.ends += ends_at(edge, at.place) ? std::size_t{1} : std::size_t{2};
  }
  require(at.ends > 0, rule, "the point is not on ring " + std::to_string(ring));
  return at;
}

// Is the first point of two lexicographically before the other?
struct IsBefore {
  bool operator()(const SweepPoint& p, const SweepPoint& q) const { return is_before(p, q); }
};

}  // namespace

void check_common_point(const Tables& tables, const StatedContact& contact, const Numbers& point,
                        const std::vector<std::int64_t>& groups, const AllowedContacts& allowed) {
  const PolygonTable& polygons = tables.polygons;
  const std::size_t i = contact.i, j = contact.j;
  const SweepPoint place = place_in_units(point, polygons.exponent);
  require(i != j && (groups.empty() || groups[i] != groups[j]), "common_point",
          std::to_string(i) + " and " + std::to_string(j) + " are of one group");
  int touched = 0, inside = 0;
  bool passed = false;
  for (const std::size_t k : {i, j}) {
    bool on = false, passes = false;
    for (const EdgeRange& ring : polygons.rings[k]) {
      take_steps(4 * (ring.end - ring.begin), length(point), polygons.bits);
      for (std::size_t e = ring.begin; e < ring.end; ++e) {
        if (!is_on(polygons.edges[e], place)) continue;
        on = true;
        passes |= !ends_at(polygons.edges[e], place);
      }
    }
    require(on || is_above_odd(polygons.edges, polygons.rings[k], place), "common_point",
            "the point is not in polygon " + std::to_string(k));
    touched += on ? 1 : 0;
    passed |= passes;
    inside += !on || (polygons.is_flat(k) && (passes || polygons.is_point(k))) ? 1 : 0;
  }
  require(inside == 2 || !allowed.touch, "common_point", "the point is not inside of both");
  require(!allowed.shared_endpoint || allowed.touch || touched < 2 || passed, "common_point",
          "all edges of both end at the point");
}

void check_valid(const Claim& claim, const PartTable& parts, bool strict) { Validity(claim, parts, strict).check(); }

void check_too_few_points(const PartTable& parts, std::size_t ring) {
  const EdgeRange& edges = parts.rings[ring];
  take_steps(2 * (edges.end - edges.begin), parts.polygons.bits, 1);
  std::set<SweepPoint, IsBefore> ends;
  for (std::size_t k = edges.begin; k < edges.end; ++k) {
    ends.insert(place_of(parts.polygons.edges[k].first));
    ends.insert(place_of(parts.polygons.edges[k].last));
  }
  require(ends.size() < 3, "too_few_points", "ring " + std::to_string(ring) + " has three different vertices");
}

void check_comes_twice(const PartTable& parts, std::size_t ring, const Numbers& point) {
  require(at_ring("comes_twice", parts, ring, point).ends > 2, "comes_twice", "the ring comes there once");
}

void check_misplaced(const PartTable& parts, std::size_t ring, const Numbers& point) {
  const SweepPoint place = at_ring("misplaced", parts, ring, point).place;
  const std::vector<PlanarSegment>& edges = parts.polygons.edges;
  Set label;
  for (std::size_t r = 0; r < parts.rings.size(); ++r) {
    const EdgeRange& own = parts.rings[r];
    take_steps(4 * (own.end - own.begin), length(point), parts.polygons.bits);
    if (r == ring) continue;
    for (std::size_t k = own.begin; k < own.end; ++k) {
      require(!is_on(edges[k], place), "misplaced", "the point is on ring " + std::to_string(r) + ", too");
    }
    if (is_above_odd(edges, std::span(&own, 1), place)) label.push_back(r);
  }
  require(!fits(parts, label) || !fits(parts, toggled(label, ring)), "misplaced", "rings fit there");
}

void check_circle(const PartTable& parts, const std::vector<std::size_t>& rings, const std::vector<Numbers>& points) {
  for (const std::size_t r : rings) {
    require(parts.part[r] == parts.part[rings[0]], "circle", "the rings are of different parts");
  }
  std::set<SweepPoint, IsBefore> places;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    at_ring("circle", parts, rings[k], points[k]);
    places.insert(at_ring("circle", parts, rings[k + 1 < rings.size() ? k + 1 : 0], points[k]).place);
  }
  require(places.size() == rings.size(), "circle", "a point stands twice");
}

void check_repeated(const PartTable& parts, bool strict, std::size_t edge) {
  require(strict, "repeated", "vertices may be repeated");
  require(is_point(parts.polygons.edges[edge]), "repeated", "the edge is of some length");
}

void check_rings_touch(const PartTable& parts, bool strict, std::size_t ring, std::size_t other, const Numbers& point) {
  require(strict && ring != other && parts.part[ring] == parts.part[other], "rings_touch", "these may touch");
  at_ring("rings_touch", parts, ring, point);
  at_ring("rings_touch", parts, other, point);
}

ContactsOf contacts_of_polygons(const Claim& claim, const Tables& tables, const std::vector<std::int64_t>& groups,
                                const AllowedContacts& allowed) {
  return [&](const VisitContact& visit) { PolygonPairs(claim, tables.polygons, groups, allowed).run(visit); };
}

}  // namespace sunder_verifier
