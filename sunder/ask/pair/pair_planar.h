// sunder pair where A and B are planar: points, segments, convex polygons out of WKT, GeoJSON and CSV.
#pragma once

#include <sunder/ask/list_stream.h>

#include <cstdint>
#include <string>

namespace sunder::ask {

struct PlanarPairCall {
  std::string file_a, file_b;
  std::string feature_a, feature_b;  // empty: the only one
  std::string pose_a, pose_b;
  std::string method = "automatic";
  std::string certificate, svg, title;
  std::uint64_t svg_limit = most_drawn;  // vertices
  bool classify = false;
  bool distance = false;
  std::string clearance;            // a number: is one that far from the other? Empty: it is not asked
  bool mend = false, hull = false;  // what to do with vertices that are not those of a convex polygon
  bool drop_z = false;
  bool leave_out = false;  // what is no object here; of meshes, what is not read
  bool json = false;
};

// What poses may be, for help texts.
extern const char* const planar_pose_forms;

// Prints the answer; returns the exit code. Throws Error for bad input.
int run_planar_pair(const PlanarPairCall& call);

}  // namespace sunder::ask
