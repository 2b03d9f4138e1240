// What the polygons do to each other that have edges at one point. For use by PolygonSweep.
//
// Around the point each polygon fills some sectors, between directions in which its edges leave. Two polygons overlap
// there iff some sector is filled by both; else they touch. All that are there are one bundle: what does not count is
// not enumerated pair by pair.
#pragma once

#include <sunder/planar/polygons/polygon_edges.h>
#include <sunder/planar/polygons/polygons_any.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace sunder::planar {

class PolygonPlace {
 public:
  // Called for pairs that meet, also more than once for a pair, until it returns false.
  using Found = std::function<bool(const PolygonsContact&)>;

  // A direction in which an edge leaves the point.
  struct Leaving {
    std::uint32_t edge;
    bool opens;   // is the inside of its polygon to the left of it? else it is to the right
    bool passes;  // does the edge leave in the opposite direction, too?
    bool turns;   // is the direction another one than that of the entry before?
  };

  // Members of one group are left out, and touching that is allowed. Where `end` is given, pairs i < j whose i is not
  // below it too; it may fall meanwhile.
  PolygonPlace(const PolygonEdges& edges, const SetOptions& options, Found found, const std::uint32_t* end = nullptr)
      : edges_(edges),
        end_(end),
        groups_(options.groups),
        allowed_(options.allowed),
        found_(std::move(found)),
        seen_(edges.polygon_count()),
        member_of_(edges.polygon_count()) {}

  // Looks at the point from which edges leave so, counter-clockwise from straight below. Returns false where it is to
  // stop. Cost: O(m log m) for m edges, and what is found.
  bool look(std::span<const Leaving> leaving);

  bool report(Relation contact, std::uint32_t e, std::uint32_t f, ContactKind kind);
  bool is_wanted(std::uint32_t polygon, std::uint32_t other) const {
    return end_ == nullptr || std::min(polygon, other) < *end_;
  }

  std::uint64_t probes = 0;

 private:
  // A polygon at the point, or an edge.
  struct Member {
    std::uint32_t group, polygon, edge;
    bool passes;
    bool chosen = true;  // pairs of two that are not are not looked at
  };
  struct Open {  // of a group, the members that fill the present sector
    std::uint32_t begin, count;
    std::uint32_t place;  // in open_groups_
  };

  std::uint32_t group_of(std::uint32_t polygon) const { return groups_.empty() ? polygon : groups_[polygon]; }
  void find_members(std::span<const Leaving> leaving);
  bool look_at_touches(std::span<const Leaving> leaving);
  bool touch_across_groups(std::span<const Member> members);
  bool look_at_sectors(std::span<const Leaving> leaving);
  bool enter(std::uint32_t edge);
  void leave(std::uint32_t edge);

  bool report_if_wanted(Relation contact, std::uint32_t e, std::uint32_t f);

  const PolygonEdges& edges_;
  const std::uint32_t* end_;
  Groups groups_;
  Allowed allowed_;
  Found found_;

  std::vector<std::uint32_t> seen_;  // of each polygon: at which point last
  std::uint32_t point_ = 0;
  std::vector<Member> members_;           // polygons, by their groups
  std::vector<std::uint32_t> member_of_;  // of each polygon that is here
  std::vector<Member> along_;             // edges in one direction

  static constexpr std::uint32_t closed = 0xffffffffu;
  std::vector<Open> open_;                                      // of each group that is here
  std::vector<std::uint32_t> open_groups_;                      // that fill the present sector
  std::vector<std::uint32_t> open_of_, open_edge_, open_list_;  // of each member: its group; the edge by which it was
                                                                // entered; list: group after group
  std::vector<std::uint32_t> place_in_list_;                    // of each member, or `closed`
};

}  // namespace sunder::planar
