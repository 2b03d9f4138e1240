// Pictures of a planar pair, as SVG: the two objects, and what shows how they lie. Rounded numbers, for people.
#pragma once

#include <sunder/io/planar_objects.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>
#include <sunder/planar/pair/polygon_polygon_distance.h>

#include <optional>
#include <string>
#include <vector>

namespace sunder::picture {

struct PicturedPolygon {
  const planar::ConvexPolygon& polygon;
  const planar::Pose& pose;
  std::string name;
};

// The polygons with the evidence of the front door's search, which is asked here, and the vertices that it looked at.
// closest: draws the distance too. title: empty: a question.
std::string pair_svg(const PicturedPolygon& a, const PicturedPolygon& b,
                     const std::optional<planar::ClosestFeatures>& closest, const std::string& title);

// A line, ray or half-plane in the world, as io::PlanarObject has it, and a bounded object.
struct CutPicture {
  PicturedPolygon body;
  io::PlanarObject::Kind kind;
  Point2 a, b;
  std::string name;
  bool body_is_a = true;
  std::vector<Point2> marks;  // none; or the ends of what is to be shown as common, rounded
  std::string said, title;
};

// The line across the sheet, the ray from its beginning on, the half-plane shaded.
std::string cut_svg(const CutPicture& picture);

}  // namespace sunder::picture
