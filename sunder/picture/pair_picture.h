// The picture of a planar pair: the polygons, the evidence, and which vertices the search looked at.
#pragma once

#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>

#include <string>

namespace sunder::picture {

struct PicturedPolygon {
  const planar::ConvexPolygon& polygon;
  const planar::Pose& pose;
  std::string name;
};

// As SVG, asked by the front door's search. Rounded numbers, for people.
std::string pair_svg(const PicturedPolygon& a, const PicturedPolygon& b, const std::string& title);

}  // namespace sunder::picture
