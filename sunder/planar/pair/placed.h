// A convex polygon in its place, as the methods of planar/pair see it: a sequence of vertices with random access.
//
// Positions 0 .. n - 1 run counter-clockwise in the world; `number` tells which vertex of the polygon is meant. A
// sequence that exists only implicitly, such as the section of a polyhedron, offers the same members.
#pragma once

#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>
#include <sunder/predicate/line/arrows.h>

#include <array>
#include <cstdint>

namespace sunder::planar {

// In the world as given.
class PlainPolygon {
 public:
  using Vertex = Point2;

  explicit PlainPolygon(const ConvexPolygon& polygon) : polygon_(polygon), vertices_(polygon.vertices().data()) {}

  std::uint32_t size() const { return polygon_.size(); }
  const Point2& operator[](std::uint32_t k) const { return vertices_[k]; }
  std::uint32_t number(std::uint32_t k) const { return k; }
  const Point2& rounded(std::uint32_t k) const { return vertices_[k]; }

  // Seen from outside, there is an arrow `up` such that the edges from `first` to `second` do not point to its left,
  // and none of them down it; those from `second` to `first` do not point to its right, and none of them up it.
  std::uint32_t first() const { return polygon_.leftmost(); }
  std::uint32_t second() const { return polygon_.rightmost(); }
  std::array<Point2, 2> up() const { return {Point2{0, 0}, Point2{0, 1}}; }

 private:
  const ConvexPolygon& polygon_;
  const Point2* vertices_;
};

// Under a pose, to which it refers. One that reflects turns the order of the vertices round.
class PosedPolygon {
 public:
  using Vertex = Posed2;

  PosedPolygon(const ConvexPolygon& polygon, Pose&& pose) = delete;
  PosedPolygon(const ConvexPolygon& polygon, const Pose& pose)
      : polygon_(polygon),
        pose_(pose.affine()),
        reflected_(pose.reflects()),
        tame_(images_are_tame(pose.linear_range(), pose.translation_range(), polygon.sizes())),
        axis_tame_(images_are_tame(pose.linear_range(), pose.translation_range(), {1, 1})),
        error_(error_of(pose, polygon.sizes().greatest, tame_)),
        axis_error_(error_of(pose, 1, axis_tame_)) {}

  std::uint32_t size() const { return polygon_.size(); }
  std::uint32_t number(std::uint32_t k) const { return reflected_ ? size() - 1 - k : k; }
  Posed2 operator[](std::uint32_t k) const { return {polygon_[number(k)], &pose_, tame_, error_}; }

  // The image, rounded: for searches.
  Point2 rounded(std::uint32_t k) const { return (*this)[k].rounded_image(); }

  // As above. Reflected, the polygon is passed through the other way, with a vertical edge at the end of its half
  // again.
  std::uint32_t first() const { return reflected_ ? number(other_end(polygon_.rightmost())) : polygon_.leftmost(); }
  std::uint32_t second() const { return reflected_ ? number(other_end(polygon_.leftmost())) : polygon_.rightmost(); }
  std::array<Posed2, 2> up() const {
    return {Posed2{{0, 0}, &pose_, axis_tame_, axis_error_}, Posed2{{0, 1}, &pose_, axis_tame_, axis_error_}};
  }

 private:
  static double error_of(const Pose& pose, double coordinates, bool tame) {
    return tame ? image_error(pose.linear_range(), pose.translation_range(), coordinates)
                : std::numeric_limits<double>::infinity();
  }

  // Of the vertical edge that ends at this vertex of the polygon, if there is one.
  std::uint32_t other_end(std::uint32_t v) const {
    const std::uint32_t before = (v == 0 ? size() : v) - 1;
    return polygon_[before].x == polygon_[v].x ? before : v;
  }

  const ConvexPolygon& polygon_;
  const Affine2& pose_;
  bool reflected_, tame_, axis_tame_;
  double error_, axis_error_;
};

// Calls method(a, b) with two sequences of one kind.
template <class Method>
auto with_placed(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b, const Pose& pose_b,
                 const Method& method) {
  if (pose_a.is_identity() && pose_b.is_identity()) return method(PlainPolygon(a), PlainPolygon(b));
  return method(PosedPolygon(a, pose_a), PosedPolygon(b, pose_b));
}

}  // namespace sunder::planar
