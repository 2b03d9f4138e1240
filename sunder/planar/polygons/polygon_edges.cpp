#include <sunder/base/contract.h>
#include <sunder/near/box_pairs.h>
#include <sunder/planar/polygons/polygon_edges.h>
#include <sunder/planar/polygons/ring_tests.h>

#include <algorithm>

namespace sunder::planar {

namespace {

Segments all_edges(const std::vector<const Polygon*>& polygons) {
  std::vector<Segment> edges;
  std::size_t count = 0;
  for (const Polygon* polygon : polygons) count += polygon->size();
  edges.reserve(count);
  for (const Polygon* polygon : polygons) {
    for (std::uint32_t k = 0; k < polygon->size(); ++k) edges.push_back(polygon->edge(k));
  }
  return Segments(std::move(edges));
}

}  // namespace

Box2 box_of_ring(const Polygon& polygon, std::uint32_t ring) {
  const std::span<const Point2> vertices = polygon.ring(ring);
  Box2 box{vertices[0], vertices[0]};
  for (const Point2& p : vertices) box = hull(box, {p, p});
  return box;
}

PolygonEdges::PolygonEdges(std::vector<const Polygon*> polygons)
    : polygons_(std::move(polygons)), sides_known_(polygons_.size()), edges_(all_edges(polygons_)) {
  SUNDER_REQUIRE(edges_.size() < std::size_t{1} << 31);
  polygon_of_.reserve(edges_.size());
  for (std::uint32_t p = 0; p < polygons_.size(); ++p) {
    first_edge_.push_back(static_cast<std::uint32_t>(polygon_of_.size()));
    first_ring_.push_back(static_cast<std::uint32_t>(rings_.size()));
    polygon_of_.resize(polygon_of_.size() + polygons_[p]->size(), p);
    for (std::uint32_t r = 0; r < polygons_[p]->ring_count(); ++r) rings_.push_back({p, r});
  }
  inside_is_left_.resize(rings_.size());
}

std::vector<Box2> PolygonEdges::ring_boxes() const {
  std::vector<Box2> boxes;
  boxes.reserve(rings_.size());
  for (const Ring& ring : rings_) boxes.push_back(box_of_ring(*polygons_[ring.polygon], ring.in_polygon));
  return boxes;
}

bool PolygonEdges::inside_is_above(std::uint32_t e) {
  const std::uint32_t p = polygon_of_[e], k = in_polygon(e);
  if (!sides_known_[p]) find_sides(p);
  const bool is_left = inside_is_left_[first_ring_[p] + polygons_[p]->ring_of(k)];
  const Segment in_ring = polygons_[p]->edge(k);
  return is_left != lexicographically_less(in_ring.b, in_ring.a);
}

// Of each ring: inside of itself is to the left where it runs counter-clockwise; what is inside of an odd number of
// others is a hole, with the inside of the polygon on the other side.
void PolygonEdges::find_sides(std::uint32_t p) {
  sides_known_[p] = true;
  const Polygon& polygon = *polygons_[p];
  const std::uint32_t first = first_ring_[p], count = polygon.ring_count();
  std::vector<Box2> boxes;
  for (std::uint32_t r = 0; r < count; ++r) {
    inside_is_left_[first + r] = is_counter_clockwise(polygon, r);
    if (count > 1) boxes.push_back(box_of_ring(polygon, r));
  }
  const auto turn_if_inside = [&](std::uint32_t inner, std::uint32_t outer) {
    if (!holds(boxes[outer], boxes[inner])) return;
    const std::uint32_t begin = polygon.ring_begin(inner);
    for (std::uint32_t k = begin; k < polygon.ring_begin(inner + 1); ++k) {
      const Segment edge = polygon.edge(k);
      if (edge.a == edge.b) continue;
      if (begins_inside_ring(polygon, outer, edge.a, edge.b)) {
        inside_is_left_[first + inner] = !inside_is_left_[first + inner];
      }
      return;
    }
  };
  if (count < 2) return;
  for_each_box_pair(boxes, [&](std::uint32_t r, std::uint32_t s) {
    turn_if_inside(r, s);
    turn_if_inside(s, r);
    return true;
  });
}

}  // namespace sunder::planar
