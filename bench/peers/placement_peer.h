// Many placements of a robot, from a file to a file: what contestants are given, and the ways in which peers do it.
#pragma once

#include <bench/contest/contest.h>

#include <sunder/io/robot/urdf.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bench {

struct PlacementScenario {
  struct Shape {
    std::string name;
    std::uint32_t body = 0, link = 0;
    sunder::solid::ConvexPolyhedron hull;
    sunder::solid::Pose pose;  // within the link
  };

  std::string table;                                  // CSV: the joints' names, then a placement a line
  std::string output;                                 // a name of a file to be written
  std::size_t columns = 0;                            // of the table
  std::vector<sunder::io::Joint> joints;              // parents before children
  std::vector<std::uint32_t> column;                  // of each joint, or none
  std::vector<sunder::solid::Pose> origins;           // of each joint
  std::size_t links = 0;                              // how many
  std::vector<Shape> shapes;                          // in the order of bodies
  std::vector<std::array<std::uint32_t, 2>> allowed;  // pairs of bodies not asked about, the lower first, sorted
  static constexpr std::uint32_t none = 0xffffffff;
};

// A call reads the table, and writes a line of JSON a placement: which shapes meet, with a point of contact. The answer
// is how many pairs meet, in all placements.
struct PlacementWay {
  std::string_view library, method;
  Run (*make)(const PlacementScenario&);
};

std::vector<PlacementWay> fcl_placement_ways();

}  // namespace bench
