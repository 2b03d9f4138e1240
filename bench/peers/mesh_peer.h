// Meshes that are not convex, and pairs of them, for bench_meshes; and how other libraries answer about them.
#pragma once

#include <bench/contest/contest.h>

#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/object/pose.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace bench {

// A mesh as a file has it.
struct MeshSoup {
  std::vector<sunder::Point3> points;
  std::vector<std::uint32_t> begin{0}, corners;

  std::size_t triangles() const { return begin.size() - 1; }
  sunder::solid::MeshView view() const { return {points, begin, corners}; }
};

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

Run fcl_make_meshes(const std::vector<MeshSoup>& soups);  // of triangles: an OBBRSS tree of each; how many triangles
Run cgal_self_crossings(const std::vector<MeshSoup>& soups);  // of triangles, of a closed surface: how many pairs cross

}  // namespace bench
