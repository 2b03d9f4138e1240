// One placed convex polygon and points of the world, for the templates of planar/pair: as vertices of one kind.
#pragma once

#include <sunder/planar/pair/edge_runs.h>

#include <cstdint>
#include <limits>
#include <type_traits>

namespace sunder::planar {

// Calls method(p) with the polygon as a sequence.
template <class Method>
auto with_placed(const ConvexPolygon& polygon, const Pose& pose, const Method& method) {
  if (pose.is_identity()) return method(PlainPolygon(polygon));
  return method(PosedPolygon(polygon, pose));
}

// A point of the world, as a vertex of that kind.
template <class Vertex>
Vertex in_world(const Point2& p) {
  if constexpr (std::is_same_v<Vertex, Point2>) {
    return p;
  } else {
    static constexpr Affine2 world{};
    SizeRange linear, coordinates;
    linear.include(1);
    coordinates.include(p.x);
    coordinates.include(p.y);
    const bool tame = images_are_tame(linear, {}, coordinates);
    return {p, &world, tame, tame ? 0 : std::numeric_limits<double>::infinity()};  // the image is the point itself
  }
}

// A point as a sequence of one vertex.
template <class V>
class OnePoint {
 public:
  using Vertex = V;

  explicit OnePoint(const V& point) : point_(point) {}

  std::uint32_t size() const { return 1; }
  std::uint32_t number(std::uint32_t) const { return 0; }
  const V& operator[](std::uint32_t) const { return point_; }

 private:
  const V& point_;
};

// The polygon's own number of the edge that begins at position k: edge v goes from vertex v to the next one. Two
// vertices have one edge, number 0.
template <class Sequence>
std::uint32_t edge_number(const Sequence& p, std::uint32_t k) {
  const std::uint32_t n = p.size(), from = p.number(position(p, k)), to = p.number(position(p, position(p, k) + 1));
  if (n < 3) return 0;
  return to == (from + 1) % n ? from : to;
}

}  // namespace sunder::planar
