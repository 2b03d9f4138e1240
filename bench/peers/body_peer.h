// The other libraries of bench_pair behind one interface: everything that a library can prepare - shapes, transforms,
// first guesses - is prepared outside of the timed loop, which answers 1 (they meet) or 0.
#pragma once

#include <bench/contest/contest.h>
#include <bench/inputs/body_scenarios.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace bench {

struct BodyWay {
  std::string_view library, method;
  Run (*make)(const Scenario&);
};

// FCL with libccd:
//   collide: through the public front door fcl::collide, asking for no contacts.
//   solver: called directly, without the dispatch and bookkeeping of fcl::collide.
std::vector<BodyWay> fcl_body_ways();

// Bullet in double precision:
//   Distance: btGjkEpaSolver2::Distance, which is its GJK plus the closest points where apart.
//   Penetration: btGjkEpaSolver2::Penetration without margins: the same GJK plus its EPA where they meet.
//   detector: btGjkPairDetector with btVoronoiSimplexSolver, the path of Bullet's own convex-convex collision
//   algorithm.
std::vector<BodyWay> bullet_body_ways();

// Counter-clockwise triangles of the hull of points of which all are extreme, by Qhull: peers that want faces get them
// from here, so that they do not depend on the library that they are compared with.
std::vector<std::array<std::uint32_t, 3>> triangles_by_qhull(const std::vector<Vec>& points);

// The same by Sunder: Qhull takes hours for the hull of a prism of 100,000 vertices.
std::vector<std::array<std::uint32_t, 3>> triangles_by_sunder(const std::vector<Vec>& points);

// The number of vertices of the hull, by Qhull with its default options.
std::uint64_t vertices_by_qhull(const std::vector<Vec>& points);

}  // namespace bench
