// What sunder pair reads where A and B are planar.
#pragma once

#include <sunder/ask/pair/pair_planar.h>
#include <sunder/ask/report.h>

#include <sunder/certificate/direction.h>
#include <sunder/io/planar_objects.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>

#include <cstdint>
#include <string>
#include <vector>

namespace sunder::ask {

struct PlanarInput {
  std::string path;
  std::string file, name, format;  // for people
  io::PlanarObject object;
  planar::Pose pose;
};

// Reads A or B. What the file holds that is no object here goes into `left_out`, unless an object is named; inputs: as
// of io::read_file. Throws Error for bad input, also where something is left out, and the list has no consent.
PlanarInput read_planar_input(const PairCall& call, bool is_a, LeftOutList& left_out, InputFiles* inputs);

// A bounded one, as a convex polygon.
struct PlanarBody {
  std::string file, name, format;
  std::uint32_t given = 0;  // vertices in the file
  planar::ConvexPolygon polygon;
  planar::Pose pose;
  std::vector<Point3> vertices;  // in the plane z = 0, for certificates
  Affine3 pose_in_space;

  PlacedVertices in_space() const { return {vertices, pose_in_space, false}; }
  const char* shape() const { return polygon.size() == 1 ? "point" : polygon.size() == 2 ? "segment" : "polygon"; }
};

// Throws Error where the vertices are not those of a convex polygon. Requires a bounded object.
PlanarBody planar_body(const PlanarInput& input, const PairCall& call);

// "name: polygon, 4 vertices".
std::string text_of(const PlanarBody& body, const PairCall& call);

Json to_json(const PlanarBody& body);

std::string about(const Point2& p);  // "(x, y)", four digits

// "vertex 2 of A", "edge 2-3 of A".
std::string feature_text(const PlanarBody& body, const char* letter, std::uint32_t v, bool edge);

// {"vertex": 2}, {"edge": [2, 3]}.
Json feature_json(const PlanarBody& body, std::uint32_t v, bool edge);

}  // namespace sunder::ask
