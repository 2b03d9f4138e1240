// How two convex polygons of a set meet, where that counts. For use by the methods of convex_polygons_any and _all.
#pragma once

#include <sunder/near/box_grid.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/polygons/convex_polygons_any.h>
#include <sunder/predicate/filter/diagonals.h>

#include <algorithm>
#include <span>
#include <vector>

namespace sunder::planar {

struct ConvexPairTest {
  Relation contact = Relation::none;  // none where it does not count
  PairAnswer answer;
};

inline ConvexPairTest test_pair(const ConvexPolygon& a, const ConvexPolygon& b, Allowed allowed) {
  static const Pose in_place;
  ConvexPairTest test;
  test.answer = polygon_polygon(a, in_place, b, in_place);
  if (!test.answer.meet()) return test;
  const Relation contact = polygon_polygon_contact(a, in_place, b, in_place);
  if (counts(contact, allowed)) test.contact = contact;
  return test;
}

// Tests the pair and reports it where it counts. Returns whether it counts.
inline bool report_pair(std::span<const ConvexPolygon> polygons, std::uint32_t i, std::uint32_t j, Allowed allowed,
                        ConvexPolygonsAnswer& answer) {
  const std::uint32_t first = std::min(i, j), second = std::max(i, j);
  ConvexPairTest test = test_pair(polygons[first], polygons[second], allowed);
  answer.cost.probes += 1 + test.answer.cost.probes;
  if (test.contact == Relation::none) return false;
  answer.found = {{first, second, test.contact}, std::get<CommonVertices>(test.answer.evidence)};
  return true;
}

inline Box2 box_of(const ConvexPolygon& polygon) {
  const std::span<const Point2> vertices = polygon.vertices();
  double bottom = vertices[0].y, top = bottom, low = bottom, high = bottom;  // of the even ones, and of the odd ones
  for (std::size_t k = 1; k < vertices.size(); k += 2) {
    const double y = vertices[k].y, z = vertices[k - 1].y;
    low = std::min(low, y);
    high = std::max(high, y);
    bottom = std::min(bottom, z);
    top = std::max(top, z);
  }
  low = std::min(low, vertices.back().y);
  high = std::max(high, vertices.back().y);
  return {{polygon[polygon.leftmost()].x, std::min(bottom, low)},
          {polygon[polygon.rightmost()].x, std::max(top, high)}};
}

// Boxes, and extents along the diagonals, which part many of those whose boxes meet.
struct Extents {
  std::vector<Box2> boxes;
  std::vector<DiagonalExtents> diagonals;
};

// The vertices are asked for ahead of time: of many polygons, to read them takes longest.
template <class Visit>
void for_each_polygon(std::span<const ConvexPolygon> polygons, const Visit& visit) {
  constexpr std::size_t ahead = 8, most_lines = 8, in_a_line = 4;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (i + ahead < polygons.size()) {
      const std::span<const Point2> vertices = polygons[i + ahead].vertices();
      for (std::size_t k = 0; k < std::min(vertices.size(), most_lines * in_a_line); k += in_a_line) {
        __builtin_prefetch(vertices.data() + k);
      }
    }
    visit(polygons[i]);
  }
}

inline std::vector<Box2> boxes_of(std::span<const ConvexPolygon> polygons) {
  std::vector<Box2> boxes;
  boxes.reserve(polygons.size());
  for_each_polygon(polygons, [&](const ConvexPolygon& polygon) { boxes.push_back(box_of(polygon)); });
  return boxes;
}

inline Extents extents_of(std::span<const ConvexPolygon> polygons) {
  Extents extents;
  extents.boxes.reserve(polygons.size());
  extents.diagonals.reserve(polygons.size());
  for_each_polygon(polygons, [&](const ConvexPolygon& polygon) {
    extents.boxes.push_back(box_of(polygon));
    DiagonalExtents diagonals;
    for (const Point2& p : polygon.vertices()) diagonals.include(p);
    extents.diagonals.push_back(diagonals);
  });
  return extents;
}

}  // namespace sunder::planar
