// Scenes that move: what contestants are given, and the ways in which peers answer which bodies meet at each step.
#pragma once

#include <bench/contest/contest.h>

#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace bench {

struct SceneScenario {
  std::vector<sunder::solid::ConvexPolyhedron> shapes;  // of each body
  std::vector<std::array<std::uint32_t, 2>> allowed;    // pairs not asked about, the lower first, sorted
  std::vector<std::vector<sunder::solid::Pose>> steps;  // of each step the poses of all bodies
};

// An input is a step; the answer is how many pairs of bodies meet. Steps are asked in their order, again and again.
struct SceneWay {
  std::string_view library, method;
  Run (*make)(const SceneScenario&);
};

std::vector<SceneWay> fcl_scene_ways();

}  // namespace bench
