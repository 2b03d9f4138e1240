// Which polygons have common points that count: docs/claims.md, "Polygons".
#include <verifier/cpp/contacts.h>
#include <verifier/cpp/rules.h>
#include <verifier/cpp/sets.h>

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

// Each polygon of the first has common points that count with each of the second.
struct MeetingPolygons {
  Set first, second;
};

// Goes through a sweep of all edges, with the polygons that cover what is just above each edge of the list.
class Cells {
 public:
  Cells(const SweepEvents& events, const PolygonTable& polygons, const AllowedContacts& allowed)
      : polygons_(polygons), allowed_(allowed), sweep_(events, polygons.edges), label_(polygons.edges.size()) {}

  std::vector<MeetingPolygons> meetings;  // of the event passed last

  bool next() {
    if (!sweep_.next()) return false;
    meetings.clear();
    const Set& label = sweep_.below == no_index ? nothing_ : label_[sweep_.below];
    take_steps(2 * label.size(), 1, 1);
    const Set at = look_at_point(label);
    for (const std::size_t s : sweep_.here) label_[s] = {};
    look_after_point(label, at);
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
      take_steps(2 * label_[*s].size(), 1, 1);
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
};

struct OfGroup {
  std::int64_t group;
  std::size_t polygon;
};

bool is_of_lower_group(const OfGroup& a, const OfGroup& b) { return a.group < b.group; }
bool is_before(const OfGroup& a, const OfGroup& b) {
  return std::tie(a.group, a.polygon) < std::tie(b.group, b.polygon);
}

class PolygonPairs {
 public:
  PolygonPairs(const SweepEvents& events, const PolygonTable& polygons, const Groups& groups,
               const AllowedContacts& allowed)
      : cells_(events, polygons, allowed), groups_(groups), count_(polygons.rings.size()) {}

  void run(const VisitContact& visit) {
    while (cells_.next()) {
      for (const MeetingPolygons& meeting : cells_.meetings) look(meeting, visit);
    }
  }

 private:
  std::int64_t group_of(std::size_t i) const { return groups_.empty() ? static_cast<std::int64_t>(i) : groups_[i]; }

  void look(const MeetingPolygons& meeting, const VisitContact& visit) {
    if (meeting.first.empty()) return;
    std::vector<OfGroup> second;
    for (const std::size_t j : meeting.second) second.push_back({group_of(j), j});
    std::sort(second.begin(), second.end(), is_before);
    std::size_t groups = second.empty() ? 0 : 1;
    for (std::size_t k = 1; k < second.size(); ++k)
      if (second[k].group != second[k - 1].group) ++groups;
    for (const std::size_t i : meeting.first) {
      const auto [own, own_end] =
          std::equal_range(second.begin(), second.end(), OfGroup{group_of(i), i}, is_of_lower_group);
      take_steps(groups + second.size() - static_cast<std::size_t>(own_end - own), 1, 1);
      std::for_each(second.begin(), own, [&](const OfGroup& j) { meet(i, j.polygon, visit); });
      std::for_each(own_end, second.end(), [&](const OfGroup& j) { meet(i, j.polygon, visit); });
    }
  }

  void meet(std::size_t i, std::size_t j, const VisitContact& visit) {
    if (i > j) std::swap(i, j);
    if (!found_.insert(i * count_ + j).second) return;
    take_steps(8, 1, 1);
    visit(i, j, "");
  }

  Cells cells_;
  const Groups& groups_;
  const std::size_t count_;
  std::unordered_set<std::uint64_t> found_;
};

void check_common_point(const PolygonTable& polygons, std::size_t i, std::size_t j, const Numbers& point,
                        const Groups& groups, const AllowedContacts& allowed) {
  const SweepPoint place = place_in_units(point, polygons.edges.exponent);
  require(i != j && (groups.empty() || groups[i] != groups[j]), "common_point",
          std::to_string(i) + " and " + std::to_string(j) + " are of one group");
  int touched = 0, inside = 0;
  bool passed = false;
  for (const std::size_t k : {i, j}) {
    bool on = false, passes = false, odd = false;
    for (const EdgeRange& ring : polygons.rings[k]) {
      const std::vector<std::size_t> near = edges_near(polygons, ring, point, place);
      for (const std::size_t e : near) {
        if (!is_on(polygons.edges[e], place)) continue;
        on = true;
        passes |= !ends_at(polygons.edges[e], place);
      }
      odd ^= is_above_odd(polygons, near, place);
    }
    require(on || odd, "common_point", "the point is not in polygon " + std::to_string(k));
    touched += on ? 1 : 0;
    passed |= passes;
    inside += !on || (polygons.is_flat(k) && (passes || polygons.is_point(k))) ? 1 : 0;
  }
  require(inside == 2 || !allowed.touch, "common_point", "the point is not inside of both");
  require(!allowed.shared_endpoint || allowed.touch || touched < 2 || passed, "common_point",
          "all edges of both end at the point");
}

}  // namespace

std::vector<std::size_t> edges_near(const PolygonTable& polygons, const EdgeRange& ring, const Numbers& point,
                                    const SweepPoint& place) {
  const std::size_t count = (ring.end - ring.begin + edges_of_block - 1) / edges_of_block, size = length(point);
  take_steps(count + 4, size, polygons.edges.bits);
  std::vector<std::size_t> near;
  for (std::size_t b = 0; b < count; ++b) {
    const EdgeBlock& block = polygons.blocks[ring.first_block + b];
    if (place.x < block.left * place.w || place.x > block.right * place.w || place.y < block.low * place.w) continue;
    const std::size_t begin = ring.begin + b * edges_of_block;
    for (std::size_t k = begin; k < std::min(begin + edges_of_block, ring.end); ++k) near.push_back(k);
  }
  take_steps(4 * near.size(), size, polygons.edges.bits);
  return near;
}

bool is_above_odd(const PolygonTable& polygons, const std::vector<std::size_t>& edges, const SweepPoint& p) {
  bool odd = false;
  for (const std::size_t k : edges) {
    const PlanarSegment& edge = polygons.edges[k];
    const bool is_over = !is_before(p, place_of(edge.first)) && is_before(p, place_of(edge.last));
    odd ^= is_over && side(edge, p) > 0;
  }
  return odd;
}

Contacts contacts_of(const SweepEvents& events, const PolygonTable& polygons, const Groups& groups,
                     const AllowedContacts& allowed) {
  return counted_one_by_one(
      [&](const VisitContact& visit) { PolygonPairs(events, polygons, groups, allowed).run(visit); });
}

const ClaimRows claims_of_polygons{
    {"common_point", "", rule<check_common_point>},
};

}  // namespace sunder_verifier
