// Bodies with a radius: balls, capsules, rounded boxes and hulls, cylinders, cones, ellipsoids.
// Also called: geometric primitives; sphere-swept volumes; spherocylinders; Minkowski sum with a ball.
//
// A body is a core, which are points of doubles, and a radius. A pose maps the core exactly; the radius stays as it is.
// No polyhedron stands for any of them.
// Memory: that of the core, at most 420 bytes a vertex for 100 vertices and more, with all that the front door walks on
// (tested); a radius, a copy and a placement cost nothing by vertex.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/disc/round_kind.h>
#include <sunder/predicate/disc/round_shape.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/search/placed.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace sunder::solid {

// A box, as searches see it: about, in doubles.
struct RoundBox {
  Point3 middle;
  std::array<Point3, 3> half;            // from the middle to three facets
  std::array<double, 3> over_half2;      // 1 over the square of its length
  std::array<std::uint32_t, 8> corners;  // vertices of the core: bit k of the place is set where it is along half[k]
};

// A box along the axes of its frame, exactly: its corners have no other coordinates than these. Searches that read it
// need not go to the core.
struct AxisBox {
  std::array<Point3, 2> range{};          // the lowest corner and the highest
  std::array<double, 3> over_side{};      // 1 over its length, about
  std::array<std::uint8_t, 8> corners{};  // vertices of the core: bit k of the place is set where coordinate k is high
};

// Immutable, and cheap to copy (copies share one block of memory); any number of threads may use one at once. Radii are
// in the unit of the world. What one might assume and does not hold: a radius of zero is allowed, but for ellipsoids; a
// cylinder or a cone of radius zero is its axis, a segment, and of kind `hull`.
class RoundBody {
 public:
  // Throw Error: bad_value for a number that is not finite, a radius below zero, a semi-axis that is not above zero;
  // bad_shape for a cylinder or cone whose two points are equal.
  RoundBody(const ConvexPolyhedron& polyhedron);  // itself: of kind hull, and radius 0
  static RoundBody ball(const Point3& centre, double radius);
  static RoundBody capsule(const Point3& from, const Point3& to, double radius);
  static RoundBody rounded(const ConvexPolyhedron& core, double radius);  // of radius 0: the polyhedron itself
  static RoundBody cylinder(const Point3& base, const Point3& top, double radius);
  static RoundBody cone(const Point3& base, const Point3& apex, double radius);
  static RoundBody ellipsoid(const Point3& centre, const std::array<double, 3>& semi_axes);  // along x, y, z

  RoundKind kind() const { return kind_; }
  double radius() const { return radius_; }

  // The hull of the points: of cylinders and cones their axis, of an ellipsoid the centre.
  const ConvexPolyhedron& core() const { return core_; }

  // As certificates list them: vertices of the core; base, and top or apex; of an ellipsoid the origin, the centre of a
  // ball of radius 1. Of curved bodies they lie in the body itself.
  std::span<const Point3> points() const;

  // Of a core of one or two points these, as `points` has them; of others none. They lie in the body itself.
  std::span<const Point3> ends() const { return std::span<const Point3>(axis_box_.range).first(count_); }

  // The greatest coordinate of the core, in size.
  double greatest() const { return greatest_; }

  // Where the points are: the identity, but for an ellipsoid, which is the image of its ball under
  // x -> diagonal x + centre.
  const Affine3& frame() const { return frame_.affine(); }
  const Pose& frame_pose() const { return frame_; }

  // Where the core is a box, as far as doubles tell: for proposals. Else nullptr.
  const RoundBox* box() const { return box_.get(); }

  // Where it is one along the axes, exactly. Else nullptr.
  const AxisBox* axis_box() const { return is_along_axes_ ? &axis_box_ : nullptr; }

  // How far the body reaches beyond what searches walk on: the radius of hulls, of whose core they see; 0 of cylinders,
  // cones and ellipsoids, which they see as they are.
  double rounding() const { return is_curved() ? 0 : radius_; }

  bool is_polyhedron() const { return kind_ == RoundKind::hull && radius_ == 0; }

  // Cylinders, cones and ellipsoids. (Points within a radius of a polyhedron are decided through their cores.)
  bool is_curved() const { return kind_ != RoundKind::hull; }

 private:
  RoundBody(RoundKind kind, const ConvexPolyhedron& core, double radius);

  RoundKind kind_;
  double radius_;
  double greatest_ = 0;
  std::uint32_t count_ = 0;
  bool is_along_axes_ = false;
  AxisBox axis_box_;  // of others its range keeps the ends: what a question reads lies together
  ConvexPolyhedron core_;
  std::shared_ptr<const RoundBox> box_;
  Pose frame_;
};

// All of the body is within that of its core: cylinders and cones are within their radius of their axis. Infinite where
// that is not known, of ellipsoids.
double reach_beyond_core(const RoundBody& body);

// A little smaller, within itself: what has a point in common with it then has one inside of it.
RoundBody smaller(const RoundBody& body);

// How people are told of a body.
struct RoundWords {
  std::string_view shape;       // "ball", "capsule", "rounded hull", "cylinder", "cone", "ellipsoid"
  std::string_view form;        // a sentence's end: " of radius {sizes}, center {points}"
  std::vector<Point3> points;   // as `points` has them; of an ellipsoid the centre
  std::string_view sizes_name;  // "radius", "semi_axes"
  std::vector<double> sizes;    // one radius, or three semi-axes
};
RoundWords words_of(const RoundBody& body);

// A polyhedron inside of the body, of points on its surface, for pictures: nothing is decided by it. Within some
// hundredths of the radius of the body; in its own frame. Cost: of a rounded hull of n vertices the hull of 170 n
// points.
struct DrawnBody {
  ConvexPolyhedron polyhedron;
  bool is_all = true;  // it is the body itself
};
DrawnBody drawn_as(const RoundBody& body);

// May the body be placed so? A polyhedron, and an ellipsoid, by any pose. Others by rotations and reflections with a
// translation, because the radius stays: Pose::is_rigid. Throws Error: bad_pose.
void require_rigid(const RoundBody& body, const Pose& pose);

// The body under the pose, which stays, as predicates see it. Of hulls its point is not set.
RoundShape shape_of(const RoundBody& body, const Affine3& pose);

// A body in its place. An ellipsoid's map is compose(pose, frame), in doubles, and these are what answers are exact
// for.
class PlacedRound {
 public:
  // Keeps a reference to the body. Throws Error as require_rigid; bad_pose where an ellipsoid's map leaves the doubles.
  PlacedRound(const RoundBody& of, const Pose& at);
  PlacedRound(const PlacedRound&) = delete;
  PlacedRound& operator=(const PlacedRound&) = delete;

  const RoundBody& body;
  const Pose pose;
  const Placed core;  // the core under the pose
  const RoundShape shape;

  RoundKind kind() const { return body.kind(); }
  double radius() const { return body.radius(); }
};

}  // namespace sunder::solid
