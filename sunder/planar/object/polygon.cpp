#include <sunder/base/error.h>
#include <sunder/planar/object/polygon.h>
#include <sunder/predicate/orient.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace sunder::planar {

namespace {

// Directions turn by less than half a turn at a vertex, all to one side, so with each round they change twice between
// those that go on lexicographically and those that go back.
bool surely_turns_once(std::span<const Point2> ring) {
  bool is_left = false, goes_on = lexicographically_less(ring.back(), ring[0]);
  std::size_t changes = 0;
  const Point2* before = &ring.back();
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point2 &here = ring[k], &after = ring[k + 1 < ring.size() ? k + 1 : 0];
    const RoundedOrientation turn(*before, here, after);
    if (k == 0) is_left = turn.value > 0;
    if (!turn.is_sure() || (turn.value > 0) != is_left) return false;
    const bool went_on = std::exchange(goes_on, lexicographically_less(here, after));
    changes += went_on != goes_on;
    before = &here;
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
  surely_convex_ = ring_count() == 1 && surely_turns_once(vertices_);
}

}  // namespace sunder::planar
