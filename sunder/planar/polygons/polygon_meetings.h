// What the contacts of edges tell about their polygons. For use by the methods of polygons_any and polygons_all.
//
// Around a point where two polygons P and Q have edges, each fills some sectors, between directions in which its edges
// leave the point; the polygons overlap near the point iff some sector is filled by both. Where edges cross that is so,
// unless it is a vertex of both (crossing_edges.h). Where it is so at no point, a ring of P that has a point in the
// interior of Q lies there entirely: it cannot leave it but through an edge of Q, and where it would, a sector on one
// side of it is filled by both. And where no ring of one has a point in the interior of the other, interiors with a
// common point would have a common component, whose edges bound both from one side: sectors filled by both. So P and Q
// overlap iff
//   (1) an edge of P and one of Q cross in a point that is not a vertex of both, or
//   (2) around an end of an edge, on both, some sector is filled by both, or
//   (3) for some ring of one, any one vertex is in the interior of the other.
// All points of (2) are vertices, and so are doubles: no point is computed.
#pragma once

#include <sunder/planar/polygons/polygon_edges.h>
#include <sunder/planar/polygons/polygons_any.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace sunder::planar {

class PolygonMeetings {
 public:
  // Calls `found` for pairs that meet, also more than once for a pair, until it returns false. Contacts that are said
  // to be touching may yet be found to be overlapping. Pairs of one group are left out.
  using Found = std::function<bool(const PolygonsContact&)>;
  PolygonMeetings(PolygonEdges& edges, Groups groups, Found found)
      : edges_(edges), groups_(groups), found_(std::move(found)), seen_(edges.polygon_count()) {}

  // 1. Takes each contact of two edges once, e < f, also of edges of one polygon, save that of edges that follow each
  //    other. Each of the three returns false when it is to stop.
  bool take(std::uint32_t e, std::uint32_t f, ContactKind kind);

  // 2. Looks around the common points of what was taken. Cost: O(k log k) for k contacts.
  bool look_around_points();

  // 3. Looks for rings inside of other polygons, where their boxes let it seem possible. Cost: linear for each such
  //    pair of rings.
  bool look_inside();

  Cost cost{};

  bool follow(std::uint32_t e, std::uint32_t f) const {
    return edges_.polygon_of(e) == edges_.polygon_of(f) && (edges_.next(e) == f || edges_.next(f) == e);
  }

 private:
  // Both edges hold the point, which is an end of one.
  struct Meeting {
    Point2 at;
    std::uint32_t e, f;
  };
  // A direction in which an edge leaves a point.
  struct Leaving {
    Point2 to;
    std::uint32_t edge, polygon;
    bool opens;  // is the inside of the polygon to its left? else it is to its right
  };

  bool overlap_where_crossing(std::uint32_t e, std::uint32_t f);
  bool look_around(const Point2& p, std::span<const Meeting> meetings);
  bool walk_around();
  bool enter(const Leaving& leaving);
  bool report(Relation contact, std::uint32_t e, std::uint32_t f, ContactKind kind);
  bool report_inside(std::uint32_t ring, std::uint32_t polygon);

  PolygonEdges& edges_;
  Groups groups_;
  Found found_;
  std::vector<Meeting> meetings_;
  std::vector<std::uint32_t> edges_here_;  // of one point
  std::vector<Leaving> leaving_;
  std::vector<Leaving> open_;        // by which the polygons that fill the present sector were entered
  std::vector<std::uint32_t> seen_;  // of each polygon: at which point last
  std::uint32_t points_ = 0;         // looked at
};

}  // namespace sunder::planar
