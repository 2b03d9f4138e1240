#include <sunder/base/error.h>
#include <sunder/planar/object/polygon_sides.h>

#include <algorithm>
#include <string>

namespace sunder::planar {

// No line through the lexicographically first vertex leaves vertices on both sides on the line: where it is collinear
// with its neighbours, the edges overlap.
PolygonSides::PolygonSides(const Polygon& polygon) : vertices_(polygon.vertices()) {
  if (polygon.ring_count() > 1) {
    throw Error(ErrorCode::bad_shape, "there are several rings; a polygon with holes has no kernel, give one ring");
  }
  const std::uint32_t n = size();
  const auto next = [n](std::uint32_t k) { return k + 1 == n ? 0 : k + 1; };
  for (std::uint32_t k = 0; k < n; ++k) {
    if (vertices_[k] != vertices_[next(k)]) continue;
    throw Error(ErrorCode::bad_shape, "it equals the next one; leave it out", "vertex " + std::to_string(k));
  }
  const auto first = static_cast<std::uint32_t>(
      std::min_element(vertices_.begin(), vertices_.end(), lexicographically_less) - vertices_.begin());
  const Point2& before = vertices_[first == 0 ? n - 1 : first - 1];
  const Sign turn = orient_2d(before, vertices_[first], vertices_[next(first)]);
  if (turn == Sign::zero) {
    throw Error(ErrorCode::bad_shape, "the ring turns back here, so it is not simple; repair it",
                "vertex " + std::to_string(first));
  }
  clockwise_ = turn == Sign::negative;
}

}  // namespace sunder::planar
