// Pictures of a planar pair, as SVG: the two objects, and what shows how they lie. Rounded numbers, for people.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/io/plane/planar_objects.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>
#include <sunder/planar/pair/polygon_polygon_distance.h>

#include <string>
#include <vector>

namespace sunder::picture {

struct PicturedPolygon {
  const planar::ConvexPolygon& polygon;
  const planar::Pose& pose;
  std::string name;
  std::string text;  // what it is, for the legend: "plate: polygon, 4 vertices"
};

struct PairPicture {
  PicturedPolygon a, b;
  PairAnswer answer;
  std::string method;  // by which that was found, as the program calls it: "gjk" of polygon_polygon_by_gjk
  const planar::ClosestFeatures* closest = nullptr;  // else the distance is drawn too
  std::string clause{};                              // what the answer is not about, behind it
  std::string title{};                               // empty: a question
};

// The polygons with the evidence of the answer, and the vertices that its search looked at: for that it is run again.
// Where that cannot be (the methods triangles and scan), or it is not the search that answered, no vertices are marked,
// and a note says so.
std::string pair_svg(const PairPicture& picture);

// A line, ray or half-plane in the world, as io::PlanarObject has it, and a bounded object.
struct CutPicture {
  PicturedPolygon body;
  io::PlanarObject::Kind kind;
  Point2 a, b;
  std::string name;
  bool body_is_a = true;
  std::vector<Point2> marks;  // none; or the ends of what is to be shown as common, rounded
  std::string said, title;
  std::string clause{};  // as of PairPicture
};

// The line across the sheet, the ray from its beginning on, the half-plane shaded.
std::string cut_svg(const CutPicture& picture);

}  // namespace sunder::picture
