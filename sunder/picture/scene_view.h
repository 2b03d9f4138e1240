// From placed bodies to shaded polygons of a picture: the orthographic view behind scene_picture.
#pragma once

#include <sunder/picture/painter.h>

#include <sunder/predicate/point.h>
#include <sunder/scene/scene.h>

#include <span>
#include <vector>

namespace sunder::picture {

// Looking at the world from a direction: azimuth about z from the x axis, elevation above the plane x y (radians).
class View {
 public:
  View(double azimuth, double elevation);

  Seen operator()(const Point3& p) const;
  double towards_viewer(const Point3& direction) const;  // the cosine, for a direction of length one
  double light_on(const Point3& normal) const;           // 0 dark .. 1 full light

 private:
  Point3 right_, up_, to_viewer_, to_light_;
};

// What is turned towards the viewer, farthest first, cut where it crosses.
std::vector<Piece> seen_pieces(std::span<const scene::Body> bodies, const View& view);

// The shadow of each part on the plane z = floor, the light straight above: a convex polygon.
// Requires finite images (world_vertices).
std::vector<std::vector<Seen>> shadows(std::span<const scene::Body> bodies, const View& view, double floor);

// The corners of a part in the world, rounded.
std::vector<Point3> world_vertices(const scene::Part& part);

}  // namespace sunder::picture
