// Pairs of meshes that are not convex for bench_meshes, and how another library answers them.
#pragma once

#include <bench/contest/contest.h>

#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/object/pose.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace bench {

struct MeshScenario {
  struct Query {
    std::size_t a, b;                    // of the pool
    sunder::solid::Pose pose_a, pose_b;  // rigid
  };
  std::vector<sunder::solid::Mesh> pool;
  std::vector<Query> queries;
};

struct MeshWay {
  std::string library, method;
  Run (*run)(const MeshScenario& scenario);
};

std::vector<MeshWay> fcl_mesh_ways();
std::vector<MeshWay> fcl_mesh_distances();  // is it 0?

}  // namespace bench
