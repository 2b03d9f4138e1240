// sunder pair where A and B are planar: points, segments, convex polygons, and one of the two a line, a ray or a
// half-plane, out of WKT, GeoJSON and CSV.
#pragma once

#include <sunder/ask/pair/pair_question.h>

#include <sunder/io/plane/planar_objects.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>

#include <cstdint>
#include <string>
#include <vector>

namespace sunder::ask {

// What poses may be, for help texts.
extern const char* const planar_pose_forms;

// The methods of two bounded objects, and of one with a line, for help texts.
std::string planar_method_names();
std::string planar_line_method_names();

// Answers. Throws Error for bad input.
Report run_planar_pair(const PairCall& call, Talk& talk);

// A or B as it was read.
struct PlanarInput {
  std::string path;
  std::string file, name, format;  // for people
  io::PlanarObject object;
  planar::Pose pose;
  Said said{};  // in proofs
};

// What the file holds that is no object here is left out, unless an object is named. Throws Error for bad input, also
// where something is left out without consent.
PlanarInput read_planar_input(const PairCall& call, const PairSide& side, PairFiles& files);

// A bounded one, as a convex polygon. It may be moved, and not copied: the object's vertices are those here.
struct PlanarBody {
  planar::ConvexPolygon polygon;
  planar::Pose pose;
  std::uint32_t given = 0;       // vertices in the file
  std::vector<Point3> vertices;  // in the plane z = 0
  PairObject object{};
  std::string remark{};  // to be noted: that its vertices are those of the file in reverse

  // "vertex 2 of A", {"vertex": 2}; "edge 2-3 of A", {"edge": [2, 3]}.
  Told feature(const char* letter, std::uint32_t v, bool is_edge) const;
};

// Throws Error where the vertices are not those of a convex polygon. Requires a bounded object.
PlanarBody planar_body(const PlanarInput& input, const PairCall& call);

// As run_planar_pair, where one of them, or both, are unbounded. Throws Error where both are; for --distance and
// --clearance; for a pose of the unbounded object under which one of its two points is no pair of doubles.
Report run_unbounded_pair(const PairCall& call, const PlanarInput& a, const PlanarInput& b, const PairFiles& files);

}  // namespace sunder::ask
