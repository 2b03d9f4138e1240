// Which polygons have common points that count: docs/claims.md, "Polygons".
#include <verifier/cpp/contacts.h>
#include <verifier/cpp/rules.h>
#include <verifier/cpp/sets.h>

#include <algorithm>
#include <string>
#include <unordered_set>
#include <utility>

namespace sunder_verifier {
namespace {

// Each polygon of the first has common points that count with each of the second.
struct MeetingPolygons {
  Set first, second;
};

// At each event of a sweep of all edges, which polygons meet there.
class Cells {
 public:
  Cells(const SweepEvents& events, const PolygonTable& polygons, const AllowedContacts& allowed)
      : polygons_(polygons), allowed_(allowed), sweep_(events, polygons.edges, polygons.owner) {}

  std::vector<MeetingPolygons> meetings;  // of the event passed last

  bool next() {
    if (!sweep_.next()) return false;
    meetings.clear();
    const Set at = look_at_point(sweep_.labels[0]);
    const std::vector<std::size_t>& going = sweep_.going;
    for (std::size_t begin = 0, end = 0; allowed_.shared_endpoint && begin < going.size(); begin = end) {
      Set border;  // the owners of edges that go on in one direction
      const PlanarSegment& first = polygons_.edges[going[begin]];
      for (; end < going.size() && turn(first, polygons_.edges[going[end]]) == 0; ++end) {
        border.push_back(polygons_.owner[going[end]]);
      }
      look_along(as_set(std::move(border)), at, sweep_.labels[begin], sweep_.labels[end]);
    }
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
      const Set within =
          only(at, [&](std::size_t i) { return polygons_.is_flat(i) && (polygons_.is_point(i) || has(passing, i)); });
      meetings.push_back({within, sum(within, without(label, at))});
    }
    return at;
  }

  // Along a direction, with the labels of what is just below and just above it.
  void look_along(const Set& border, const Set& at, const Set& lower, const Set& upper) {
    if (!allowed_.touch) return meetings.push_back({border, sum(border, lower)});
    meetings.push_back({common(upper, at), upper});
    const Set within = only(border, [&](std::size_t i) { return polygons_.is_flat(i); });
    meetings.push_back({within, sum(within, without(lower, border))});
  }

  const PolygonTable& polygons_;
  const AllowedContacts& allowed_;
  LabelledSweep sweep_;
};

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
    std::vector<std::pair<std::int64_t, std::size_t>> second;  // by group
    for (const std::size_t j : meeting.second) second.emplace_back(group_of(j), j);
    std::sort(second.begin(), second.end());
    std::size_t groups = 0;
    for (std::size_t k = 0; k < second.size(); ++k)
      groups += k == 0 || second[k].first != second[k - 1].first ? std::size_t{1} : 0;
    for (const std::size_t i : meeting.first) {
      const auto first_of = [&](std::int64_t group) {
        return std::lower_bound(second.begin(), second.end(), std::pair(group, std::size_t{0}));
      };
      const auto own = first_of(group_of(i)), own_end = first_of(group_of(i) + 1);
      take_steps(groups + second.size() - static_cast<std::size_t>(own_end - own), 1, 1);
      for (auto j = second.begin(); j != own; ++j) meet(i, j->second, visit);
      for (auto j = own_end; j != second.end(); ++j) meet(i, j->second, visit);
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
