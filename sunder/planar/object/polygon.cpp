#include <sunder/base/error.h>
#include <sunder/planar/object/polygon.h>
#include <sunder/predicate/point/orient.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace sunder::planar {

namespace {

// Does the ring turn to one side at each vertex, and go round once? Directions turn by less than half a turn at a vertex,
// so with each round they change twice between those that go on lexicographically and those that go back.
bool is_strictly_convex(std::span<const Point2> ring) {
  Sign side = Sign::zero;
  std::size_t changes = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point2 &before = ring[k > 0 ? k - 1 : ring.size() - 1], &here = ring[k];
    const Point2& after = ring[k + 1 < ring.size() ? k + 1 : 0];
    const Sign turn = orient_2d(before, here, after);
    if (k == 0) side = turn;
    if (turn == Sign::zero || turn != side) return false;
    changes += lexicographically_less(before, here) != lexicographically_less(here, after);
  }
  return changes == 2;
}

}  // namespace

Polygon::Polygon(std::span<const std::vector<Point2>> rings) {
  if (rings.empty()) throw Error(ErrorCode::bad_shape, "a polygon has at least one ring");
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const std::vector<Point2>& ring = rings[r];
    const std::string place = "ring " + std::to_string(r);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (std::isfinite(ring[k].x) && std::isfinite(ring[k].y)) continue;
      throw Error(ErrorCode::bad_value, "a coordinate is not finite; every number must be: repair the data",
                  place + ", vertex " + std::to_string(k));
    }
    const std::size_t count = ring.size() > 1 && ring.front() == ring.back() ? ring.size() - 1 : ring.size();
    if (count < 3) throw Error(ErrorCode::bad_shape, "a ring has at least three vertices; leave it out", place);
    if (vertices_.size() + count >= std::size_t{1} << 31) {
      throw Error(ErrorCode::bad_shape, "a polygon has fewer than 2^31 vertices; split it", place);
    }
    vertices_.insert(vertices_.end(), ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(count));
    if (rings.size() > 1) ring_.resize(vertices_.size(), static_cast<std::uint32_t>(r));
    begin_.push_back(static_cast<std::uint32_t>(vertices_.size()));
  }
  std::vector<LanesBox> boxes;
  boxes.reserve(size());
  for (std::uint32_t k = 0; k < size(); ++k) boxes.push_back(lanes_box_of(vertices_[k], vertices_[next(k)]));
  edge_boxes_ = EdgeBoxes(boxes);
  LanesBox all = boxes[0];
  for (const LanesBox& box : boxes) all = hull(all, box);
  box_ = {{all.low[0], all.low[1]}, {all.high[0], all.high[1]}};
  strictly_convex_ = ring_count() == 1 && is_strictly_convex(vertices_);
}

}  // namespace sunder::planar
